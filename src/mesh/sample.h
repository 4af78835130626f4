// SPDX-License-Identifier: MIT
// Places on a mesh with their normals, spread evenly over its area.
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
    geometry::VecArray normal; // unit normals
    base::Array<std::int32_t> face;
};

// Random places on faces, uniformly distributed over the area.
class RandomPlaces {
public:
    struct Place {
        std::int64_t face;
        glm::dvec3 shares; // the barycentric coordinates of the place in its face
    };

    // corners(face) must return the positions of the corners of a face.
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
    // Returns random place `number`. Different streams give different places for the same seed.
    [[nodiscard]] Place at(std::uint64_t seed, std::int64_t number, std::uint32_t stream) const noexcept;

private:
    base::Array<double> area_; // for each face: the sum of the areas up to and including it
};

// Returns the unit normal at a place of a face, interpolated between the normals of its corners.
[[nodiscard]] glm::dvec3 normal_at(const Mesh& mesh, std::int64_t face, const glm::dvec3& shares) noexcept;

// Returns samples at random places of a mesh (RandomPlaces).
[[nodiscard]] MeshSamples random_samples(const base::Work& work, const Mesh& mesh, std::int64_t count,
                                         std::uint64_t seed, std::uint32_t stream);

// Returns `count` of the random candidates, in farthest-point order. If there are not more candidates, returns all of
// them in random order.
[[nodiscard]] MeshSamples even_samples(const base::Work& work, const Mesh& mesh, std::int64_t count,
                                       std::int64_t candidates, std::uint64_t seed);

// Returns samples that show where an open mesh ends: a support of them ends where the mesh ends (surface/support.h).
// They are `count` even samples. Near the border, rows of samples replace the even ones, because random samples would
// end the surface like torn paper. The distance of the first row from the border is such that s is 1.5 on the border,
// if no spacing of the support is less than `closest`. The borders of holes that stay closed have no row.
[[nodiscard]] MeshSamples end_samples(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                      std::int64_t count, double closest, std::uint64_t seed);

// Returns the total length of all borders.
[[nodiscard]] double border_length(const Mesh& mesh) noexcept;

} // namespace hrbfnpr::mesh
