// SPDX-License-Identifier: MIT
// All curves of f = g = 0 on a meshed surface: where the mesh sees g change its sign, points are brought onto curves,
// all at once; gaps between those that cannot be linked are followed step by step. Then every change of sign is asked
// for its curve, and every vertex where |g| is least for a loop between vertices.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "curves/mesh_edges.h"

namespace hrbfnpr::curves {

struct TraceSettings {
    double longest = 1.0;                  // step, in sides of the mesh
    double shortest = 1e-4;                // in sides: a curve that needs shorter steps is given up
    double turn = 0.33;                    // radians between points, at most
    double tolerance = 2e-4;               // in sides: a shorter step of Newton's is the last one
    std::int32_t evaluation_limit = 20000; // for each start
};

struct TraceReport {
    std::int64_t starts = 0;
    std::int64_t evaluations = 0;
    std::int64_t broken = 0; // curves that end inside the surface: steps became too short
    std::int64_t added = 0;  // starts on curves that the first ones had not led to
    std::int64_t loops = 0;  // those of the added ones that are on loops between the mesh's vertices
    std::int64_t missed = 0; // changes of sign that no curve was found for
};

// The same bits for any thread count.  near: places near the curves, in their order, that are tried before the changes
// of sign on the mesh, as the curves of the view before, moved_contours(). Curves that they miss are found as without
// them.
[[nodiscard]] Curves trace(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                           const TraceSettings& settings, TraceReport& report, const Curves* near = nullptr);

// Where points of contours of another view come to in this one, by a step of Newton's with f as it is known there:
// grad g changes as little as the view. Points that move by more than `farthest` are left out.
[[nodiscard]] Curves moved_contours(base::Memory& memory, const View& view, const Curves& contours, double farthest);

} // namespace hrbfnpr::curves
