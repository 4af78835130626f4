// SPDX-License-Identifier: MIT
// Finds the smooth surface that a patch approximates: its normals, and samples that its sheet is fitted to.
#pragma once

#include "fit/samples.h"
#include "mesh/face_tree.h"
#include "mesh/pieces/creases.h"
#include "mesh/sample.h"

#include <limits>
#include <span>

namespace hrbfnpr::mesh {

// The normals of corners, numbered 3 face + k.
struct PatchNormals {
    explicit PatchNormals(base::Memory& memory) noexcept : normal(memory), tip(memory) {}

    base::Array<glm::dvec3> normal; // unit
    base::Array<std::uint8_t> tip;  // 1: the corner is at the tip of a cone, where each face has its own normal
};

// Returns for each corner the mean normal over the faces of its patch, weighted by area and angle. A flat that would
// then bulge by more than the tolerance keeps its own normal where all other flats are much smaller.
[[nodiscard]] PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                         double tolerance = std::numeric_limits<double>::infinity());

// Returns the largest distance of the middles of a face's sides from the curved surface that has these normals.
[[nodiscard]] double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept;
// Returns the largest chord_error() of the faces at each vertex.
[[nodiscard]] base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal);

struct PatchSamples {
    explicit PatchSamples(base::Memory& memory) noexcept : samples(memory), tolerance(memory) {}

    fit::Samples samples;          // with bounds and spacing
    base::Array<double> tolerance; // the largest distance of each sample from the sheet
};

struct PatchTolerance {
    double crease; // the tolerance at a crease
    double far;    // the tolerance farther than `ramp` from creases
    double ramp;
};

// Returns the vertices of a patch's faces, and places between them on the curved surface that has the vertices' normals
// (Vlachos et al., "Curved PN triangles", 2001).
[[nodiscard]] PatchSamples sample_patch(const base::Work& work, const Mesh& mesh, const Creases& creases,
                                        const PatchNormals& normals, std::span<const std::int32_t> faces,
                                        const PatchTolerance& tolerance);

// Returns 1 for each patch that lies against another solid, as boxes that stand on each other do. At one of `places` on
// such a patch, a face of another component faces the other way and is no farther than `near`. The patch of that face
// gets 1, too.
[[nodiscard]] base::Array<std::uint8_t> patches_in_contact(const base::Work& work, const Mesh& mesh,
                                                           const FaceTree& tree, const Creases& creases,
                                                           const MeshSamples& places, double near);

} // namespace hrbfnpr::mesh
