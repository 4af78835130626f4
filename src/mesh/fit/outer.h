// SPDX-License-Identifier: MIT
// Which side of a closed mesh a place lies on.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Whether a place lies inside a closed mesh, by the windings that most of some rays count.
[[nodiscard]] bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept;

// Drops samples of closed components that lie inside others, where components overlap.
void keep_outer(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal, const base::Progress& progress);

} // namespace hrbfnpr::mesh
