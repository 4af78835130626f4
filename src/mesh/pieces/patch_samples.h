// SPDX-License-Identifier: MIT
// What the sheet of a patch is held to: places of the patch, also along its creases, with the patch's own normals.
#pragma once

#include "fit/samples.h"
#include "mesh/pieces/patch_normals.h"

namespace hrbfnpr::mesh {

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
