// SPDX-License-Identifier: MIT
// Patches that wind around beside themselves, as the flanks of a screw thread do.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// A sheet through layers that lie above each other and face the same way would have to fall to 0 between them once
// more.  Such patches are cut across, smoothly, into parts that are no more than half a turn long.  across: of each
// side of the faces, the face beyond it, or -1.
void split_winding(const base::Runtime& runtime, const Mesh& mesh, const base::Array<std::int32_t>& across,
                   Creases& creases, const base::Progress& progress);

} // namespace hrbfnpr::mesh
