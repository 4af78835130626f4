// SPDX-License-Identifier: MIT
// Cuts patches that one sheet cannot represent. The cuts are smooth: they are no creases.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Cuts two kinds of patches. First, a patch may be on both sides of a crease, for example of a crease that fades or
// runs along a tube. Its faces are then divided by the side of the crease that is nearest. Second, a patch may wind
// beside itself, as the flank of a screw thread does. It is cut across. Then the patches are renumbered. Near a smooth
// cut, each sheet is also fitted to faces beyond the cut, so that both sheets agree there; these faces are listed.
void split_patches(const base::Work& work, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases);

} // namespace hrbfnpr::mesh
