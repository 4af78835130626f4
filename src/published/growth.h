// SPDX-License-Identifier: MIT
// Multi-level refinement: grows stipples and strokes from seeds. [NPAR 5]
//
// Level 0 consists of the seeds that fit into the budget. In each further level every mark gets children, which start a
// step away and are projected onto the surface. Children of stipples start in the tangent plane, children of stroke
// marks along the stroke. The step of a level is a third of the previous step.
#pragma once

#include "marks/site.h"

namespace hrbfnpr::published {

// The settings of a layer's refinement.
struct Settings {
    std::int32_t levels = -1;   // -1: the default of the layer's kind
    bool from_stipples = false; // whether strokes start from the stipples up to `start_level` instead of the seeds
    std::int32_t start_level = 0;
};

// The marks from which a layer starts. At each mark start two strokes, one for each direction set.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // the number of starting marks if none had been dropped
};

// How the directions of strokes are chosen.
enum class Directions : std::uint8_t { principal, combing, function };

struct GrowthSettings {
    std::int64_t layer = 0; // the layer's index, for messages; -1: stipples that are made only as starts of strokes
    std::int32_t levels = 0;
    double step = 0.0;                             // the step rho_0 of level 0
    std::int64_t budget = 0;                       // 0: no limit
    Directions directions = Directions::principal; // how the directions of strokes are chosen
    marks::DirectionFunction function;             // the caller's function, used with Directions::function
};

// Grows stipples by the article's recursion, which multiplies their number by five.
void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report);

// Grows strokes in both directions by the article's recursion, which multiplies their marks by three. As published, a
// combing stroke that enters another region of the field takes the new direction, and so has a sharp bend there.
void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report);

} // namespace hrbfnpr::published
