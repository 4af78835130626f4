// SPDX-License-Identifier: MIT
// Finds the smooth surface that a patch of the mesh approximates: its normals, and samples for the fit of a sheet.
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

    base::Array<glm::dvec3> normal; // unit normals
    base::Array<std::uint8_t> tip;  // 1 if the corner is at the tip of a cone, where each face has a separate normal
};

// Returns for each corner the mean normal of the faces of its patch, weighted by area and angle. A flat keeps its face
// normal if it would bulge by more than the tolerance and all other flats there are much smaller.
[[nodiscard]] PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                         double tolerance = std::numeric_limits<double>::infinity());

// Returns the largest distance between the middle of a side of the face and the curved surface with these normals.
[[nodiscard]] double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept;
// Returns the largest chord_error() of the faces at each vertex.
[[nodiscard]] base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal);

struct PatchSamples {
    explicit PatchSamples(base::Memory& memory) noexcept : samples(memory), tolerance(memory) {}

    fit::Samples samples;          // the places, with bounds but without spacing
    base::Array<double> tolerance; // for each sample: its largest allowed distance from the sheet
    bool in_plane = false;         // true if the patch lies in a plane
};

struct PatchTolerance {
    double crease; // the tolerance at creases
    double far;    // the tolerance at a distance of more than `ramp` from creases
    double ramp;
};

// Returns samples of a patch: the vertices, and places between them on the curved surface with the normals of the
// vertices (Vlachos et al., "Curved PN triangles", 2001).
[[nodiscard]] PatchSamples sample_patch(const base::Work& work, const Mesh& mesh, const Creases& creases,
                                        const PatchNormals& normals, std::span<const std::int32_t> faces,
                                        const PatchTolerance& tolerance);

// Returns 1 for each patch that lies against another solid, as on boxes that stand on each other. `places` are tested:
// a face of another component must be within `near` and face the other way. The patch of that face gets 1, too.
[[nodiscard]] base::Array<std::uint8_t> patches_in_contact(const base::Work& work, const Mesh& mesh,
                                                           const FaceTree& tree, const Creases& creases,
                                                           const MeshSamples& places, double near);

} // namespace hrbfnpr::mesh
