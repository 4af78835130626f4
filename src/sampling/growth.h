// Multi-level refinement: from seeds to stipples and strokes.         [NPAR 5]
#pragma once

#include "sampling/generate.h"
#include "sampling/marks.h"

namespace hrbfnpr::sampling {

// What a group starts from.  Strokes: both sets from every start.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // of starts, had none been dropped
};

struct GrowthSettings {
    Group group = Group::stipple;
    std::int32_t levels = 0;
    double step = 0.0;       // rho_0
    std::int64_t budget = 0; // 0 = none
};

// The x5 recursion.
void grow_stipples(const Site& site, const Start& start, const GrowthSettings& settings, Marks& marks,
                   GroupReport& report, const base::Progress& progress);

// The x3 recursion of both sets of a CURVATURE or COMBING group.  A COMBING stroke that enters another region of
// the field takes up the new direction, as published, and breaks there.
void grow_strokes(const Site& site, const Start& start, const GrowthSettings& settings, Marks& marks,
                  GroupReport& report, const base::Progress& progress);

} // namespace hrbfnpr::sampling
