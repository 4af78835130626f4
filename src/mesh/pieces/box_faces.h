// SPDX-License-Identifier: MIT
// Which faces meet a cube.
#pragma once

#include "mesh/pieces/tests_in_cell.h"

namespace hrbfnpr::mesh {

// By the axes that may part a triangle and a box (Akenine-Moeller, "Fast 3D triangle-box overlap testing", 2001).
[[nodiscard]] bool meets(const CellBox& box, const std::array<glm::dvec3, 3>& corners) noexcept;

// Of those in `from`.
void faces_in_box(const CellBox& box, const Mesh& mesh, const base::Array<std::int32_t>& from,
                  base::Array<std::int32_t>& to);

// From a place to a triangle.
[[nodiscard]] double distance_to(const glm::dvec3& place, const std::array<glm::dvec3, 3>& corners) noexcept;

} // namespace hrbfnpr::mesh
