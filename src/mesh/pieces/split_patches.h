// SPDX-License-Identifier: MIT
// Cuts patches that one sheet cannot represent, where they are smooth.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Cuts two kinds of patches. A patch that meets itself in a crease, for example in a crease that fades or runs along a
// tube, is divided into the parts nearest to each side of the crease. A patch that winds around beside itself, as the
// flank of a screw thread does, is cut across. Renumbers the patches, and lists the faces beyond a smooth cut that a
// sheet is also fitted to, so that the sheets on both sides agree there.
void split_patches(const base::Work& work, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases);

} // namespace hrbfnpr::mesh
