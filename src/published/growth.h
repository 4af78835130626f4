// Multi-level refinement: from seeds to stipples and strokes.         [NPAR 5]
#pragma once

#include "marks/marks.h"

namespace hrbfnpr::published {

// How far a group is refined.
struct Settings {
    std::int32_t levels = 3;
    bool from_stipples = false; // strokes start from the stipples up to `seed_level`, not from the seeds
    std::int32_t seed_level = 0;
};

// What a group starts from.  Strokes: both sets from every start.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // of starts, had none been dropped
};

struct GrowthSettings {
    marks::Group group = marks::Group::stipple;
    std::int32_t levels = 0;
    double step = 0.0;       // rho_0
    std::int64_t budget = 0; // 0 = none
};

// The x5 recursion.
void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::GroupReport& report, const base::Progress& progress);

// The x3 recursion of both sets of a CURVATURE or COMBING group.  A COMBING stroke that enters another region of
// the field takes up the new direction, as published, and breaks there.
void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::GroupReport& report, const base::Progress& progress);

} // namespace hrbfnpr::published
