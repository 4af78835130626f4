// SPDX-License-Identifier: MIT
// Multi-level refinement: from seeds to stipples and strokes.         [NPAR 5]
//
// Level 0 is as many of the seeds as the budget has room for. In each further level every mark gets children a step
// away in its tangent plane, or along its stroke, which are projected onto the surface; the step is a third of the last
// one.
#pragma once

#include "marks/site.h"

namespace hrbfnpr::published {

// How far a layer is refined.
struct Settings {
    std::int32_t levels = -1;   // -1: the default of its kind
    bool from_stipples = false; // strokes start from the stipples up to `start_level`, not from the seeds
    std::int32_t start_level = 0;
};

// The marks that a layer starts from. Strokes of both sets start from each of them.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // the number of starts, had none been dropped
};

// The directions that the strokes of both sets follow.
enum class Directions : std::uint8_t { principal, combing, function };

struct GrowthSettings {
    std::int64_t layer = 0; // for messages; -1: stipples that only strokes start from
    std::int32_t levels = 0;
    double step = 0.0;                             // rho_0
    std::int64_t budget = 0;                       // 0 = none
    Directions directions = Directions::principal; // what strokes follow
    marks::DirectionFunction function;             // with Directions::function
};

// The x5 recursion.
void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report);

// The x3 recursion of strokes along both directions. A combing stroke that enters another region of the field takes up
// the new direction, as published, and breaks there.
void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report);

} // namespace hrbfnpr::published
