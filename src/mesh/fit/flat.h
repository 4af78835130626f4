// SPDX-License-Identifier: MIT
// Solids without an inside.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Throws Error{invalid_argument} where all faces lie in one plane and look both ways: a surface through both cannot be
// told from none.
void refuse_flat_solid(const Mesh& mesh);

} // namespace hrbfnpr::mesh
