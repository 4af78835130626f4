// SPDX-License-Identifier: MIT
// Traces all curves f = g = 0 on a meshed surface. Points where g changes its sign on the mesh are moved onto curves,
// all in parallel. If two points cannot be linked, the curve between them is followed step by step. In the end, two
// checks find missing curves: every change of sign must have a curve near it, and around every vertex where |g| is
// least, a loop between the vertices is searched for.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "curves/mesh_edges.h"

namespace hrbfnpr::curves {

struct TraceSettings {
    double longest = 1.0;    // the longest step, in mesh sides
    double shortest = 1e-4;  // the shortest step, in mesh sides; a curve that needs shorter steps is abandoned
    double turn = 0.33;      // the largest turn between points, in radians
    double tolerance = 2e-4; // A Newton step shorter than this is the last one, in mesh sides.
    std::int32_t evaluation_limit = 20000; // the largest number of evaluations for each start
};

struct TraceReport {
    std::int64_t starts = 0;
    std::int64_t evaluations = 0;
    std::int64_t broken = 0; // the number of curves that end inside the surface, because steps became too short
    std::int64_t added = 0;  // the number of starts on curves that the first starts missed
    std::int64_t loops = 0;  // how many of the added starts are on loops between the vertices of the mesh
    std::int64_t missed = 0; // the number of changes of sign without a curve near them
};

// Traces the curves. `near` has places near the curves, in order along each curve, for example the result of
// moved_contours() for the previous view. These places are the first starts. Curves without a start are found from the
// changes of sign on the mesh. The result has the same bits for any number of threads.
[[nodiscard]] Curves trace(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                           const TraceSettings& settings, TraceReport& report, const Curves* near = nullptr);

// Predicts the positions in this view of the contours of another view: each point makes one Newton step with the stored
// derivatives of f, because grad g changes little between similar views. Points that move by more than `farthest` are
// dropped.
[[nodiscard]] Curves moved_contours(base::Memory& memory, const View& view, const Curves& contours, double farthest);

} // namespace hrbfnpr::curves
