// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Unit normals of all corners, by the angles that faces have at their vertex; of faces within the crease angle
// (degrees) only.
void set_corner_normals(const base::Runtime& runtime, double crease_angle, Mesh& mesh, const base::Progress& progress);

} // namespace hrbfnpr::mesh
