// SPDX-License-Identifier: MIT
// Places on a mesh with normals, evenly spread over its area.
#pragma once

#include "mesh/face_tree.h"

namespace hrbfnpr::mesh {

struct MeshSamples {
    explicit MeshSamples(base::Memory& memory) noexcept : position(memory), normal(memory), face(memory) {}

    void add(const glm::dvec3& place, const glm::dvec3& unit_normal, std::int64_t of_face) {
        position.push_back(place);
        normal.push_back(unit_normal);
        face.push_back(static_cast<std::int32_t>(of_face));
    }

    geometry::VecArray position;
    geometry::VecArray normal; // unit
    base::Array<std::int32_t> face;
};

// Random places on faces, evenly spread over their area.
class RandomPlaces {
public:
    struct Place {
        std::int64_t face;
        glm::dvec3 shares; // barycentric coordinates
    };

    // corners(face) returns the places of a face's corners.
    template <class Corners>
    RandomPlaces(base::Memory& memory, std::int64_t faces, Corners&& corners, const base::Progress& progress)
        : area_(memory) {
        HRBFNPR_ASSERT(faces > 0);
        area_.reserve(faces);
        double sum = 0.0;
        for (const std::int64_t face : progress.over(faces)) {
            sum += glm::length(doubled_area(corners(face)));
            area_.push_back(sum);
        }
    }
    // Each stream gives other places for the same seed.
    [[nodiscard]] Place at(std::uint64_t seed, std::int64_t number, std::uint32_t stream) const noexcept;

private:
    base::Array<double> area_; // the sum up to and including each face
};

// Returns the unit normal at a place of a face, interpolated between those of the corners.
[[nodiscard]] glm::dvec3 normal_at(const Mesh& mesh, std::int64_t face, const glm::dvec3& shares) noexcept;

// Returns samples at RandomPlaces of a mesh.
[[nodiscard]] MeshSamples random_samples(const base::Work& work, const Mesh& mesh, std::int64_t count,
                                         std::uint64_t seed, std::uint32_t stream);

// Returns `count` of the random candidates in farthest-point order. If there are no more candidates than that, it
// returns all in random order.
[[nodiscard]] MeshSamples even_samples(const base::Work& work, const Mesh& mesh, std::int64_t count,
                                       std::int64_t candidates, std::uint64_t seed);

// Returns samples that tell where an open mesh ends: a support of them ends where the mesh does (surface/support.h).
// They are `count` even samples, except that a row along the border replaces those next to it, because random samples
// would end the surface like torn paper. The row lies at the distance inside at which s is 1.5 on the border, if no
// spacing of the support is less than `closest`. Borders of holes that stay closed have no row.
[[nodiscard]] MeshSamples end_samples(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                      std::int64_t count, double closest, std::uint64_t seed);

// Returns the length of all borders.
[[nodiscard]] double border_length(const Mesh& mesh) noexcept;

} // namespace hrbfnpr::mesh
