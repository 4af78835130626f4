// SPDX-License-Identifier: MIT
// Makes surfaces from a mesh. It repairs the mesh, and divides coarse faces that approximate a round shape. It groups
// parts that cannot belong to one surface, fits a model to each group, and ends the model where the mesh ends.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Fits one surface to each group of parts, usually to a single group. The group with the largest area comes first.
// `shape` is a mesh that leave_out_unusable() has cleaned. `up` receives the up direction: the direction in the
// options, or else the direction that choose_up() finds.
[[nodiscard]] Vector<Surface> fit_mesh(const Call& call, Shape&& shape, glm::dvec3& up);

} // namespace hrbfnpr::picture
