// SPDX-License-Identifier: MIT
// Multi-level refinement: from seeds to stipples and strokes.         [NPAR 5]
#pragma once

#include "geometry/long_vec_array.h"
#include "marks/marks.h"
#include "marks/site.h"

namespace hrbfnpr::published {

// How far a layer is refined.
struct Settings {
    std::int32_t levels = -1;   // -1: the default of its kind
    bool from_stipples = false; // strokes start from the stipples up to `start_level`, not from the seeds
    std::int32_t start_level = 0;
};

// What a layer starts from.  Strokes: both sets from every start.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // of starts, had none been dropped
};

// What the strokes of both sets follow.
enum class Directions : std::uint8_t { principal, combing, function };

struct GrowthSettings {
    std::int64_t layer = 0; // for messages; -1: stipples that only strokes start from
    std::int32_t levels = 0;
    double step = 0.0;                             // rho_0
    std::int64_t budget = 0;                       // 0 = none
    Directions directions = Directions::principal; // of strokes
    marks::DirectionFunction function;             // with Directions::function
};

// Makes room for `marks` marks in each column, and looks for a cancel between them. Without it all columns would grow
// at the same mark, with no such look for a long time.
template <class... Column>
void make_room(std::int64_t marks, const base::Progress& progress, Column&... column) {
    (make_room_long(column, marks, progress), ...);
}

// The x5 recursion.
void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report, const base::Progress& progress);

// The x3 recursion of strokes along both directions. A combing stroke that enters another region of the field takes up
// the new direction, as published, and breaks there.
void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report, const base::Progress& progress);

} // namespace hrbfnpr::published
