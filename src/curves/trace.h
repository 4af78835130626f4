// SPDX-License-Identifier: MIT
// All curves of f = g = 0 on a meshed surface: where the mesh sees g change its sign, curves are started and followed,
// all at once, until each has come to where another started.  Then every change of sign is asked for its curve, and
// every vertex where |g| is least for a loop between vertices.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "curves/curves.h"

namespace hrbfnpr::curves {

struct TraceSettings {
    double longest = 1.0;                  // step, in the mesh's sides
    double shortest = 1e-4;                // in the mesh's sides: a curve that needs shorter ones is given up
    double turn = 0.25;                    // radians between points, at most
    double tolerance = 1e-7;               // of starts, in the mesh's sides
    std::int64_t apart = 12;               // crossings of a chain between two starts
    std::int32_t evaluation_limit = 20000; // for each start
};

struct TraceReport {
    std::int64_t starts = 0;
    std::int64_t evaluations = 0;
    std::int64_t broken = 0; // curves that end inside the surface: steps became too short
    std::int64_t added = 0;  // starts on curves that the first ones had not led to
    std::int64_t loops = 0;  // of these, on loops that pass between the mesh's vertices
    std::int64_t missed = 0; // changes of sign that no curve was found for
};

// The same bits for any thread count.
[[nodiscard]] Curves trace(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                           const TraceSettings& settings, TraceReport& report, const base::Progress& progress);

} // namespace hrbfnpr::curves
