// SPDX-License-Identifier: MIT
// Answers questions of a fit about a mesh: which side of the mesh a place is on, which faces are outside all other
// parts, and which parts touch.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/sample.h"

#include <optional>

namespace hrbfnpr::mesh {

// Returns whether a place is inside a closed mesh. Three rays count the winding number, and the majority decides.
[[nodiscard]] bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept;

// Returns the winding number of a closed mesh around a place, the middle one of three rays' counts.
[[nodiscard]] int winding_number(const FaceTree& tree, const glm::dvec3& place) noexcept;

enum class MeshSide : std::uint8_t { outside, inside, unsure };

// Finds the side of a mesh with holes that a place is on. It uses more rays. The answer is `unsure` if too many rays
// disagree, as they do near a hole or beside a sheet.
[[nodiscard]] MeshSide side_of_mesh(const FaceTree& tree, const glm::dvec3& place) noexcept;

// If closed components overlap, drops the samples of each component that lie inside another.
void keep_outer(const base::Work& work, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal);

// The faces to which distances are measured. Usually these are all faces. If closed components overlap, faces inside
// another component are left out.
class OuterFaces {
public:
    OuterFaces(const base::Work& work, const Mesh& mesh, const FaceTree& all);

    // A face may have another index in this tree than in the mesh. If so, no face of the tree is at a border.
    [[nodiscard]] const FaceTree& tree() const noexcept { return outer_ ? *outer_ : all_; }
    [[nodiscard]] const FaceTree& all() const noexcept { return all_; }

private:
    const FaceTree& all_;
    std::optional<FaceTree> outer_;
};

[[nodiscard]] bool has_parts(const Mesh& mesh) noexcept;

// Two parts that a fit may join by mistake, because distances do not show topology.
struct PartContact {
    std::int32_t one = -1, other = -1; // the indices of the components; -1 without a component
    glm::dvec3 place{0.0};
    bool may_cross = false; // True if the parts may cross, false if they are only near each other.
};

// Finds the first edge that crosses a face of another component.
[[nodiscard]] PartContact find_crossing(const base::Work& work, const Mesh& mesh, const FaceTree& tree);

// Finds the first of `places` from which another component is at most `near` away, along the normal or against it. Set
// `solids_apart` if each solid is fitted separately. Solids may then cross, and they touch only if their normals at the
// place are nearly parallel or opposite. If it is not set, find_crossing() is tried first.
[[nodiscard]] PartContact find_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                            const MeshSamples& places, double near, bool solids_apart);

// Like find_part_contact(), but also logs a warning about the parts found.
[[nodiscard]] PartContact warn_of_part_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                               const MeshSamples& places, double near, bool solids_apart);

// Throws Error{invalid_argument} if all faces lie in one plane and face both ways. Such a solid has no inside.
void refuse_flat_solid(const Mesh& mesh);

} // namespace hrbfnpr::mesh
