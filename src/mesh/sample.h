// SPDX-License-Identifier: MIT
// Places on a mesh, even over its area, with normals.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

struct MeshSamples {
    explicit MeshSamples(base::Memory& memory) noexcept : position(memory), normal(memory), face(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal; // unit
    base::Array<std::int32_t> face;
};

// The unit normal at a place of a face, between those of the corners.
[[nodiscard]] glm::dvec3 normal_at(const Mesh& mesh, std::int64_t face, const glm::dvec3& shares) noexcept;

// Random places; stream: further ones for the same seed.
[[nodiscard]] MeshSamples random_samples(const base::Runtime& runtime, const Mesh& mesh, std::int64_t count,
                                         std::uint64_t seed, std::uint32_t stream, const base::Progress& progress);

// `count` of so many random candidates, in farthest-point order; as many candidates as that, or fewer: all of them, in
// random order.
[[nodiscard]] MeshSamples even_samples(const base::Runtime& runtime, const Mesh& mesh, std::int64_t count,
                                       std::int64_t candidates, std::uint64_t seed, const base::Progress& progress);

} // namespace hrbfnpr::mesh
