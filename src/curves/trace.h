// SPDX-License-Identifier: MIT
// Traces all curves f = g = 0 on a meshed surface. Where g changes its sign on the mesh, points are brought onto
// curves, all in parallel; gaps between points that cannot be linked are followed step by step. Afterwards every change
// of sign is checked for its curve, and every vertex where |g| is least for a loop between vertices.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "curves/mesh_edges.h"

namespace hrbfnpr::curves {

struct TraceSettings {
    double longest = 1.0;                  // the longest step, in sides of the mesh
    double shortest = 1e-4;                // in sides: curves that need shorter steps are abandoned
    double turn = 0.33;                    // the greatest turn between points, in radians
    double tolerance = 2e-4;               // in sides: a shorter Newton step is the last one
    std::int32_t evaluation_limit = 20000; // the limit for each start
};

struct TraceReport {
    std::int64_t starts = 0;
    std::int64_t evaluations = 0;
    std::int64_t broken = 0; // curves that end inside the surface: steps became too short
    std::int64_t added = 0;  // starts on curves that the first starts missed
    std::int64_t loops = 0;  // the number of added starts that are on loops between the mesh's vertices
    std::int64_t missed = 0; // changes of sign without a curve
};

// Gives the same bits for any thread count. near: places near the curves, in order along them, such as moved_contours()
// of the previous view. They are tried before the changes of sign on the mesh; curves that they miss are still found
// from these.
[[nodiscard]] Curves trace(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                           const TraceSettings& settings, TraceReport& report, const Curves* near = nullptr);

// Predicts where points of another view's contours lie in this view, by one Newton step with the stored derivatives of
// f. This works because grad g changes little if the view changes little. Points that move by more than `farthest` are
// dropped.
[[nodiscard]] Curves moved_contours(base::Memory& memory, const View& view, const Curves& contours, double farthest);

} // namespace hrbfnpr::curves
