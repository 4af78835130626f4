// SPDX-License-Identifier: MIT
// The bounding volume hierarchy of a mesh's faces. It finds the nearest face, and the faces that a ray meets.
#pragma once

#include "geometry/bvh.h"
#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

using FaceTree = geometry::Bvh;

// Directions of rays that are unlikely to pass exactly through edges of a mesh.
inline constexpr std::array<glm::dvec3, 3> ray_directions{
    glm::dvec3{0.5773, 0.2161, 0.7874}, glm::dvec3{-0.6431, 0.7321, 0.2247}, glm::dvec3{0.1713, -0.5119, -0.8418}};

} // namespace hrbfnpr::mesh
