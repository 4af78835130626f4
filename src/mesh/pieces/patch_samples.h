// SPDX-License-Identifier: MIT
// What the sheet of a patch is held to: places of the patch, also along its creases, with the patch's own normals.
#pragma once

#include "fit/samples.h"
#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

// Of corners (3 face + k).
struct PatchNormals {
    explicit PatchNormals(base::Memory& memory) noexcept : normal(memory), tip(memory) {}

    base::Array<glm::dvec3> normal; // of length 1
    base::Array<std::uint8_t> tip;  // 1: of a cone, where no normal is everybody's, and each face has its own
};

// As their patch has them: those of another do not count.  By area and angle, so that a large flat face beside a
// rounding stays flat.
[[nodiscard]] PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases);

// Of a face: how far the middles of its edges are from the surface that is curved as the normals are.
[[nodiscard]] double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept;
// Of each vertex: the largest of its faces.
[[nodiscard]] base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal);

struct PatchSamples {
    explicit PatchSamples(base::Memory& memory) noexcept : samples(memory), tolerance(memory) {}

    fit::Samples samples;          // with bounds and spacing
    base::Array<double> tolerance; // how far each may be from the sheet
};

struct PatchTolerance {
    double crease; // at a crease ...
    double far;    // ... and from `ramp` off on
    double ramp;
};

// faces: those of the patch.  Vertices, and places between them on the surface that is curved as the normals are
// (Vlachos et al., "Curved PN triangles", 2001).
[[nodiscard]] PatchSamples sample_patch(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                        const PatchNormals& normals, std::span<const std::int32_t> faces,
                                        const PatchTolerance& tolerance, const base::Progress& progress);

} // namespace hrbfnpr::mesh
