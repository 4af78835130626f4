// SPDX-License-Identifier: MIT
// A mesh with creases as an implicit of pieces that has them, too.
#pragma once

#include "implicit/pieces.h"
#include "mesh/fit/fit_mesh.h"
#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

struct PiecesReport {
    std::int32_t sheets = 0;
    double crease_length = 0.0; // of sharp creases
    double smooth_length = 0.0; // of creases that fade, which stay smooth
    std::int64_t cells = 0;
    std::int64_t poor_cells = 0;
};

struct PiecesFit {
    implicit::PiecesData data;
    fit::FitReport fit;
    FitMeshReport mesh;
    PiecesReport pieces;
};

// settings and options are those of fit_mesh(). Where the surface is far off, patches that no function goes through are
// parted along edges that bend less, unless the settings say what is sharp.
[[nodiscard]] PiecesFit fit_pieces(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                   const Creases& creases, const FitMeshSettings& settings,
                                   const fit::FitInput& options);

} // namespace hrbfnpr::mesh
