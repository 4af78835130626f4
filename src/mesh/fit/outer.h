// SPDX-License-Identifier: MIT
// Which side of a closed mesh a place lies on.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/mesh.h"

#include <optional>

namespace hrbfnpr::mesh {

// Whether a place lies inside a closed mesh, by the windings that most of some rays count.
[[nodiscard]] bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept;

enum class Where : std::uint8_t { outside, inside, unsure };

// The same of a mesh that may have holes, by more rays: unsure where too many disagree, as near a hole, or beside a
// sheet.
[[nodiscard]] Where where(const FaceTree& tree, const glm::dvec3& place) noexcept;

// Drops samples of closed components that lie inside others, where components overlap.
void keep_outer(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal, const base::Progress& progress);

// What distances are measured to: all faces, or, where closed components overlap, those that are not inside another.
class OuterFaces {
public:
    OuterFaces(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& all, const base::Progress& progress);

    // Of its faces nobody knows the numbers in the mesh, but that none is at a border.
    [[nodiscard]] const FaceTree& tree() const noexcept { return outer_ ? *outer_ : all_; }
    [[nodiscard]] const FaceTree& all() const noexcept { return all_; }

private:
    const FaceTree& all_;
    std::optional<FaceTree> outer_;
};

} // namespace hrbfnpr::mesh
