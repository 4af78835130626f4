// SPDX-License-Identifier: MIT
// Parts of a mesh that a fit may join, as it knows distances and no topology.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/sample.h"

namespace hrbfnpr::mesh {

[[nodiscard]] bool has_parts(const Mesh& mesh) noexcept;

struct Touching {
    std::int32_t one = -1, other = -1; // components, numbered from 0; -1: none
    glm::dvec3 place{0.0};
    bool may_cross = false; // they go through each other, or are near; else they are near
};

// The first edge that goes through a face of another component.
[[nodiscard]] Touching find_crossing(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                     const base::Progress& progress);

// The same; else the first of some places on the mesh from which
// another component is no farther than `near` along the normal or against it.
[[nodiscard]] Touching find_touching(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                     const MeshSamples& places, double near, const base::Progress& progress);

// The second alone, where the parts look to or from each other there: parts that cross are no reason.
[[nodiscard]] Touching find_near(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                 const MeshSamples& places, double near, const base::Progress& progress);

// Finds parts that a fit may join, and says so in the log.  Solids that are fitted apart may cross, because they meet
// in creases.
[[nodiscard]] Touching warn_of_touching(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                        const MeshSamples& places, double near, bool solids_apart,
                                        const base::Progress& progress);

} // namespace hrbfnpr::mesh
