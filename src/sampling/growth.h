// Multi-level refinement: from seeds to stipples and strokes.         [NPAR 5]
#pragma once

#include "sampling/generate.h"
#include "sampling/marks.h"

namespace hrbfnpr::sampling {

// What a group starts from.  Strokes: both sets from every start; or, where the sets have starts of their
// own, set 0 from the first half and set 1 from the second.
struct Start {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;
    std::int64_t full_count; // of starts, had none been dropped
    bool own_starts = false;
};

struct GrowthSettings {
    Group group = Group::stipple;
    std::int32_t levels = 0;
    double step = 0.0;       // rho_0
    std::int64_t budget = 0; // 0 = none
    // COMBING: a stroke that enters another region of the field, where the directions jump, goes on
    // straight.  As published it takes up the new direction, and breaks there.
    bool steady = false;
};

// The x5 recursion.
void grow_stipples(const Site& site, const Start& start, const GrowthSettings& settings, Marks& marks,
                   GroupReport& report, const base::Progress& progress);

// The x3 recursion of both sets of a CURVATURE or COMBING group.
void grow_strokes(const Site& site, const Start& start, const GrowthSettings& settings, Marks& marks,
                  GroupReport& report, const base::Progress& progress);

// Drops the marks outside `region` as strayed, once all have grown: their descendants may be inside.
void clip_to(const geometry::Bounds& region, Marks& marks, GroupReport& report) noexcept;

} // namespace hrbfnpr::sampling
