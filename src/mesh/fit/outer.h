// SPDX-License-Identifier: MIT
// What a fit asks of a mesh: which side of it a place lies on, which of its faces are outside, which of its parts
// touch.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/sample.h"

#include <optional>

namespace hrbfnpr::mesh {

// Tells whether a place lies inside a closed mesh, by the windings that most of three rays count.
[[nodiscard]] bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept;

enum class Where : std::uint8_t { outside, inside, unsure };

// Tells the same of a mesh that may have holes, by more rays. It is unsure where too many disagree, as near a hole, or
// beside a sheet.
[[nodiscard]] Where where(const FaceTree& tree, const glm::dvec3& place) noexcept;

// Drops samples of closed components that lie inside others, where components overlap.
void keep_outer(const base::Work& work, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal);

// The faces that distances are measured to: all, or, where closed components overlap, those that are not inside
// another.
class OuterFaces {
public:
    OuterFaces(const base::Work& work, const Mesh& mesh, const FaceTree& all);

    // Its faces may have other numbers than in the mesh; none of them is at a border then.
    [[nodiscard]] const FaceTree& tree() const noexcept { return outer_ ? *outer_ : all_; }
    [[nodiscard]] const FaceTree& all() const noexcept { return all_; }

private:
    const FaceTree& all_;
    std::optional<FaceTree> outer_;
};

[[nodiscard]] bool has_parts(const Mesh& mesh) noexcept;

// Two parts that a fit may join, as it knows distances and no topology.
struct Touching {
    std::int32_t one = -1, other = -1; // components, numbered from 0; -1: none
    glm::dvec3 place{0.0};
    bool may_cross = false; // They go through each other, or are near; else they are near.
};

// Finds the first edge that goes through a face of another component.
[[nodiscard]] Touching find_crossing(const base::Work& work, const Mesh& mesh, const FaceTree& tree);

// Finds the first of some places on the mesh from which another component is no farther than `near` along the normal or
// against it. Where solids are fitted apart the parts must look to or from each other there, as solids may cross.
// Otherwise find_crossing() comes first.
[[nodiscard]] Touching find_touching(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                     const MeshSamples& places, double near, bool solids_apart);

// Does the same, and says in the log what it found.
[[nodiscard]] Touching warn_of_touching(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                        const MeshSamples& places, double near, bool solids_apart);

// Throws Error{invalid_argument} where all faces lie in one plane and look both ways: a surface through both cannot be
// told from none.
void refuse_flat_solid(const Mesh& mesh);

} // namespace hrbfnpr::mesh
