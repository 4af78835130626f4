// SPDX-License-Identifier: MIT
// Fits an implicit of sheets to a mesh with creases. The fitted surface has the same creases as the mesh.
#pragma once

#include "implicit/sheet_tree.h"
#include "mesh/fit/fit_mesh.h"
#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

struct SheetTreeReport {
    std::int32_t sheets = 0;
    double crease_length = 0.0; // the total length of sharp creases
    double smooth_length = 0.0; // the total length of creases that fade out; the surface stays smooth there
    std::int64_t cells = 0;
    std::int64_t poor_cells = 0;
};

struct SheetTreeFit {
    implicit::SheetTreeData data;
    fit::FitReport fit;
    FitMeshReport mesh;
    SheetTreeReport pieces;
};

// `settings` and `options` are those of fit_mesh(). If the surface is far off, patches whose samples no function fits
// are divided along edges that bend less, unless the settings say which edges are sharp.
[[nodiscard]] SheetTreeFit fit_sheet_tree(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                          const Creases& creases, const FitMeshSettings& settings,
                                          const fit::FitInput& options);

} // namespace hrbfnpr::mesh
