// SPDX-License-Identifier: MIT
// Answers questions of a fit about a mesh: on which side of it a place lies, which of its faces are outside, and which
// of its parts touch.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/sample.h"

#include <optional>

namespace hrbfnpr::mesh {

// Tells whether a place lies inside a closed mesh, by the winding numbers that most of three rays count.
[[nodiscard]] bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept;

enum class MeshSide : std::uint8_t { outside, inside, unsure };

// Tells on which side of a mesh with holes a place lies, by more rays. The answer is `unsure` if too many rays
// disagree, as near a hole or beside a sheet.
[[nodiscard]] MeshSide side_of_mesh(const FaceTree& tree, const glm::dvec3& place) noexcept;

// Drops the samples of closed components that lie inside other components, if components overlap.
void keep_outer(const base::Work& work, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal);

// The faces to which distances are measured: all faces, or, if closed components overlap, the faces that are not inside
// another component.
class OuterFaces {
public:
    OuterFaces(const base::Work& work, const Mesh& mesh, const FaceTree& all);

    // The faces of this tree may have other numbers than in the mesh. If their numbers differ, no face of the tree is
    // at a border.
    [[nodiscard]] const FaceTree& tree() const noexcept { return outer_ ? *outer_ : all_; }
    [[nodiscard]] const FaceTree& all() const noexcept { return all_; }

private:
    const FaceTree& all_;
    std::optional<FaceTree> outer_;
};

[[nodiscard]] bool has_parts(const Mesh& mesh) noexcept;

// Two parts that a fit may join, because it knows distances and no topology.
struct PartContact {
    std::int32_t one = -1, other = -1; // components, numbered from 0; -1: none
    glm::dvec3 place{0.0};
    bool may_cross = false; // The parts may cross. If false, they are only near each other.
};

// Finds the first edge that goes through a face of another component.
[[nodiscard]] PartContact find_crossing(const base::Work& work, const Mesh& mesh, const FaceTree& tree);

// Finds the first place of `places` from which another component is no farther than `near` along the normal or against
// it. Solids that are fitted separately may cross, and touch only if their normals there are nearly parallel or
// opposite. Otherwise find_crossing() is tried first.
[[nodiscard]] PartContact find_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                            const MeshSamples& places, double near, bool solids_apart);

// Does the same as find_part_contact(), and logs a warning about the parts that it found.
[[nodiscard]] PartContact warn_of_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                               const MeshSamples& places, double near, bool solids_apart);

// Throws Error{invalid_argument} if all faces lie in one plane and face both ways, because the two sides of such a
// solid cannot be distinguished from no surface.
void refuse_flat_solid(const Mesh& mesh);

} // namespace hrbfnpr::mesh
