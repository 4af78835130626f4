// SPDX-License-Identifier: MIT
// On which side of a mesh places lie, and how far from it.
#pragma once

#include "mesh/edges.h"
#include "mesh/face_tree.h"

namespace hrbfnpr::mesh {

// What is known of the mesh at the place nearest to another.
struct Beside {
    double distance = 0.0; // signed: below 0 is inside
    std::int64_t face = -1;
    glm::dvec3 place{0.0};
    bool inner = false; // the place is inside its face, not on an edge
};

class Sides {
public:
    Sides(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const base::Progress& progress);

    // By rays where the mesh is closed and is more than one part, or not a manifold, or where faces are folded upon
    // each other, whose normals do not tell; else by the normal there (Baerentzen and Aanaes, "Signed distance
    // computation using the angle weighted pseudonormal", 2005).
    [[nodiscard]] Beside beside(const glm::dvec3& place) const noexcept;
    // How far one may go from an inner place of a face along its normal, or against it, so that the mesh is no nearer
    // on the other side: at most `most`.
    [[nodiscard]] double room(const glm::dvec3& place, const glm::dvec3& along, double most) const noexcept;
    // Whether that is the mesh's surface: not a face inside another part.
    [[nodiscard]] bool is_outer(const Beside& beside) const noexcept;
    // Whether all of space is inside or outside.
    [[nodiscard]] bool solid() const noexcept { return solid_; }
    [[nodiscard]] const glm::dvec3& normal(std::int64_t face) const noexcept { return normal_[face]; }

private:
    [[nodiscard]] bool looks_solid(const base::Runtime& runtime, const base::Progress& progress) const;
    // Whether rays agree, at nearly all of these faces, with the side that they look to.
    [[nodiscard]] bool look_solid(const base::Runtime& runtime, const base::Array<std::int64_t>& face,
                                  const base::Progress& progress) const;
    [[nodiscard]] bool is_folded(std::int64_t face) const noexcept;
    [[nodiscard]] glm::dvec3 pseudo_normal(std::int64_t face, const glm::dvec3& place, bool& inner) const noexcept;

    const Mesh& mesh_;
    const FaceTree& tree_;
    base::Array<glm::dvec3> normal_;   // of faces, unit
    base::Array<glm::dvec3> edge_;     // of sides (3 face + k): the sum of the faces'
    base::Array<glm::dvec3> vertex_;   // by angles
    base::Array<std::uint8_t> folded_; // vertices of faces that are folded upon another
    double off_ = 0.0;
    bool solid_ = false;
    bool by_rays_ = false;
};

} // namespace hrbfnpr::mesh
