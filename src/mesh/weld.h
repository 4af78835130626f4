// SPDX-License-Identifier: MIT
// The first half of make_mesh(): the caller's arrays as vertices in different places and faces that have an area.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

struct Welded {
    explicit Welded(base::Memory& memory) noexcept : vertex(memory), triangle(memory), given_face(memory) {}

    base::Array<glm::dvec3> vertex; // those of faces, in the order in which they were given
    base::Array<Triangle> triangle;
    base::Array<std::int32_t> given_face;
};

// Counts in the report what it joins and leaves out.
[[nodiscard]] Welded weld(const base::Work& work, const MeshInput& input, MeshReport& report);

} // namespace hrbfnpr::mesh
