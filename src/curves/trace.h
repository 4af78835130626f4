// SPDX-License-Identifier: MIT
// All curves of f = g = 0 on a meshed surface: where the mesh sees g change its sign, points are brought onto curves,
// all at once; what lies between those that cannot be linked is followed step by step.  Then every change of sign is
// asked for its curve, and every vertex where |g| is least for a loop between vertices.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "curves/curves.h"

namespace hrbfnpr::curves {

struct TraceSettings {
    double longest = 1.0;                  // step, in the mesh's sides
    double shortest = 1e-4;                // in the mesh's sides: a curve that needs shorter ones is given up
    double turn = 0.33;                    // radians between points, at most
    double tolerance = 2e-4;               // a Newton's step that is shorter is the last one; in the mesh's sides
    std::int32_t evaluation_limit = 20000; // for each start
};

// In the mesh's sides: where points are nearer to each other, a curve may have a kink between them, of so many radians,
// since the Hessian of a Hermite sum jumps at each sample.
inline constexpr double kink_length = 2e-3;
inline constexpr double sharpest_kink = 1.2;

struct TraceReport {
    std::int64_t starts = 0;
    std::int64_t evaluations = 0;
    std::int64_t broken = 0; // curves that end inside the surface: steps became too short
    std::int64_t added = 0;  // starts on curves that the first ones had not led to
    std::int64_t loops = 0;  // of these, on loops that pass between the mesh's vertices
    std::int64_t missed = 0; // changes of sign that no curve was found for
};

// The same bits for any thread count.  near: places near the curves, in their order, that are tried before what the
// mesh sees; those of the view before, as moved_with() has them.  What they miss is found as without them.
[[nodiscard]] Curves trace(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                           const TraceSettings& settings, TraceReport& report, const base::Progress& progress,
                           const Curves* near = nullptr);

} // namespace hrbfnpr::curves
