// SPDX-License-Identifier: MIT
// Patches that wind around beside themselves, as the flanks of a screw thread do.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Cuts such patches across, smoothly, into parts that are no more than half a turn long. A sheet through turns that lie
// above each other and face the same way would have to fall to 0 between them once more, and one of many turns that lie
// beside each other is asked everywhere, with all its centres.
void split_winding(const base::Runtime& runtime, const Mesh& mesh, Creases& creases, const base::Progress& progress);

} // namespace hrbfnpr::mesh
