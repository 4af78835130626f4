// SPDX-License-Identifier: MIT
// Multi-level refinement: grows stipples and strokes from seeds. [NPAR 5]
//
// Level 0 consists of the seeds that fit into the budget. In each further level every mark gets children a step away in
// its tangent plane, or along its stroke, which are projected onto the surface. The step is a third of the last one.
#pragma once

#include "marks/site.h"

namespace hrbfnpr::published {

// The settings of a layer's refinement.
struct Settings {
    std::int32_t levels = -1;   // -1: the default of its kind
    bool from_stipples = false; // strokes start from the stipples up to `start_level`, not from the seeds
    std::int32_t start_level = 0;
};

// The marks from which a layer starts. A stroke of each of the two sets of directions starts from each mark.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // the number of starts if none had been dropped
};

// The directions that the strokes of both sets follow.
enum class Directions : std::uint8_t { principal, combing, function };

struct GrowthSettings {
    std::int64_t layer = 0; // the layer's number for messages; -1: stipples that serve only as starts of strokes
    std::int32_t levels = 0;
    double step = 0.0;                             // rho_0
    std::int64_t budget = 0;                       // 0 = none
    Directions directions = Directions::principal; // the directions that strokes follow
    marks::DirectionFunction function;             // the function, with Directions::function
};

// Grows stipples by the x5 recursion.
void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report);

// Grows strokes along both directions by the x3 recursion. A combing stroke that enters another region of the field
// takes the new direction, as published, and breaks there.
void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report);

} // namespace hrbfnpr::published
