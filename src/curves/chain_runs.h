// SPDX-License-Identifier: MIT
// Runs of points on curves, from the chains that a mesh sees: crossings of a chain are brought onto the curve, all of
// all chains at once, and those that follow each other are linked where a cubic says enough of the curve between them.
#pragma once

#include "curves/beads.h"
#include "curves/trace.h"

namespace hrbfnpr::curves {

// Each run is a part of a curve, or all of it if it is closed.  No place of a curve is in two of them, but beside their
// ends.
[[nodiscard]] Curves runs_of_chains(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                                    const MeshChains& chains, const base::Array<Bead>& beads,
                                    const TraceSettings& settings, TraceReport& report, const base::Progress& progress);

} // namespace hrbfnpr::curves
