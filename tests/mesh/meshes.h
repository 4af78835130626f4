// SPDX-License-Identifier: MIT
// Meshes in the form that make_mesh() takes.
#pragma once

#include "mesh/mesh.h"
#include "support/meshes.h"

namespace mesh_test {

using hrbfnpr::test::Triangles;

inline hrbfnpr::mesh::MeshInput input(const Triangles& from) {
    hrbfnpr::mesh::MeshInput result;
    result.vertices = {reinterpret_cast<const std::byte*>(from.vertices.data()),
                       static_cast<std::int64_t>(from.vertices.size() / 3), 24, hrbfnpr::base::Scalar::float64, 3};
    result.triangles = {reinterpret_cast<const std::byte*>(from.triangles.data()),
                        static_cast<std::int64_t>(from.faces()), 12, hrbfnpr::base::Scalar::int32, 3};
    return result;
}

inline hrbfnpr::mesh::Mesh made(const hrbfnpr::base::Runtime& runtime, const Triangles& from,
                                hrbfnpr::mesh::Parts parts = hrbfnpr::mesh::Parts::outer) {
    hrbfnpr::mesh::MeshInput desc = input(from);
    desc.parts = parts;
    return hrbfnpr::mesh::make_mesh(runtime, desc);
}

} // namespace mesh_test
