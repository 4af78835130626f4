// SPDX-License-Identifier: MIT
// The border of a surface that ends where its samples do, as a line.
#pragma once

#include "curves/clip_mesh.h"
#include "curves/surface_lines.h"

namespace hrbfnpr::curves {

// Where the mesh was cut along g = 0: curves with points on f = g = 0 and exact tangents, as many as turning asks for.
// Where it ends at its region: as border_lines().  The surface lies to the left, as seen from outside.
[[nodiscard]] SurfaceLines exact_border(const base::Runtime& runtime, const Level& level, const ClippedMesh& clipped,
                                        const base::Progress& progress);

// Whether it ends nowhere at its region.
[[nodiscard]] bool is_all_cut(const ClippedMesh& clipped) noexcept;

// Where the mesh of an open surface ends; the surface lies to the left, as seen from outside.
[[nodiscard]] SurfaceLines border_lines(base::Memory& memory, const SurfaceMesh& mesh);

} // namespace hrbfnpr::curves
