// SPDX-License-Identifier: MIT
// Patches that meet themselves in a crease, as one that fades does, or one along a tube, cut where they are smooth.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Cuts each such patch into the parts nearest to each side of its creases, numbers the patches anew, and says which
// faces beyond a smooth cut its sheets are to be fitted to as well, so that they agree there.
void split_fading(const base::Runtime& runtime, const Mesh& mesh, const base::Array<Side>& sides, Creases& creases,
                  const base::Progress& progress);

} // namespace hrbfnpr::mesh
