// SPDX-License-Identifier: MIT
// From a mesh to surfaces: what can be repaired is, coarse faces that stand for something round are divided, parts that
// are no surface together are grouped, a model is fitted to each group, and it ends where the mesh does.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Fits a surface to each group of parts, the one with the largest faces in all first; mostly there is one group.
// shape: a mesh that leave_out_unusable() has seen.  up: the options' direction, or the one that is found.
[[nodiscard]] Vector<Surface> fit_mesh(const Call& call, Shape&& shape, glm::dvec3& up);

} // namespace hrbfnpr::picture
