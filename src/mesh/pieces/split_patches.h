// SPDX-License-Identifier: MIT
// Patches that one sheet cannot be, cut where they are smooth.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Cuts patches that meet themselves in a crease, as one that fades does, or one along a tube, into the parts nearest to
// each side of their creases, and patches that wind around beside themselves, as the flanks of a screw thread do.
// Numbers the patches anew, and says which faces beyond a smooth cut the sheets are to be fitted to as well, so that
// they agree there.
void split_patches(const base::Work& work, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases);

} // namespace hrbfnpr::mesh
