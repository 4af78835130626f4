// SPDX-License-Identifier: MIT
// Runs of points on curves, from places near them: the crossings of chains that a mesh sees, or points of the curves of
// another view.  They are brought onto the curves, all at once, and those that follow each other are linked where a
// cubic says enough of the curve between them.
#pragma once

#include "curves/trace.h"

namespace hrbfnpr::curves {

// Places of each chain that are part of a step from each other. Only positions count.
[[nodiscard]] Curves starts_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const MeshChains& chains,
                               const base::Array<Bead>& beads, const TraceSettings& settings);

// Starts with known directions, as far apart as starts from chains, and closer where the curve turns.
[[nodiscard]] Curves thinned(const base::Runtime& runtime, const SurfaceMesh& mesh, const Curves& starts,
                             const TraceSettings& settings);

// Each run is a part of a curve, or all of it if it is closed. No place of a curve is in two runs, but beside their
// ends. Starts follow each other as the points of a curve do.
[[nodiscard]] Curves runs_from(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                               const Curves& starts, const TraceSettings& settings, TraceReport& report,
                               const base::Progress& progress);

} // namespace hrbfnpr::curves
