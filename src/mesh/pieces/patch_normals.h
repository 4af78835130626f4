// SPDX-License-Identifier: MIT
// Normals of a mesh as its patches have them, and what is curved as these are.
#pragma once

#include "mesh/pieces/creases.h"

#include <limits>

namespace hrbfnpr::mesh {

// Of corners (3 face + k).
struct PatchNormals {
    explicit PatchNormals(base::Memory& memory) noexcept : normal(memory), tip(memory) {}

    base::Array<glm::dvec3> normal; // of length 1
    base::Array<std::uint8_t> tip;  // 1: of a cone, where no normal is everybody's, and each face has its own
};

// As their patch has them: those of another do not count.  By area and angle; a flat that would still bulge by more
// than the tolerance keeps its own beside what is much smaller, where that bulges less for it than the flat did.
[[nodiscard]] PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                         double tolerance = std::numeric_limits<double>::infinity());

// Of a face: how far the middles of its edges are from the surface that is curved as the normals are.
[[nodiscard]] double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept;
// Of each vertex: the largest of its faces.
[[nodiscard]] base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal);

} // namespace hrbfnpr::mesh
