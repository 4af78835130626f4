// SPDX-License-Identifier: MIT
// The first half of make_mesh(): turns the caller's arrays into vertices in different places and faces that have an
// area.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

struct Welded {
    explicit Welded(base::Memory& memory) noexcept : vertex(memory), triangle(memory), given_face(memory) {}

    base::Array<glm::dvec3> vertex; // The vertices that faces use, in the order in which they were given.
    base::Array<Triangle> triangle;
    base::Array<std::int32_t> given_face;
};

// Welds the caller's arrays. The report receives the count of joined vertices and the count of faces that are left out.
[[nodiscard]] Welded weld(const base::Work& work, const MeshInput& input, MeshReport& report);

} // namespace hrbfnpr::mesh
