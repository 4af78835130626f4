// SPDX-License-Identifier: MIT
// The border of a surface as a line, where it ends at its region or for want of samples. The surface lies to the left,
// as seen from outside.
#pragma once

#include "curves/clip_mesh.h"
#include "curves/surface_lines.h"

namespace hrbfnpr::curves {

// Along the mesh's border edges.
[[nodiscard]] SurfaceLines border_lines(base::Memory& memory, const SurfaceMesh& mesh);

// The same of a mesh that was cut along g = 0: there the points are on f = g = 0, as many as the curve's turns want,
// with exact tangents.
[[nodiscard]] SurfaceLines exact_border(const base::Runtime& runtime, const Level& level, const ClippedMesh& clipped,
                                        const base::Progress& progress);

// Whether all of the border was cut, so that none of it is the end of the region.
[[nodiscard]] bool is_all_cut(const ClippedMesh& clipped) noexcept;

} // namespace hrbfnpr::curves
