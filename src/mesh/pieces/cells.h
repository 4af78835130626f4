// SPDX-License-Identifier: MIT
// Space cut into cells, in each of which a few sheets make the mesh's surface.
#pragma once

#include "mesh/pieces/sides.h"
#include "mesh/pieces/tests_in_cell.h"

namespace hrbfnpr::mesh {

struct CellsReport {
    std::int64_t cells = 0;
    std::int64_t surface_cells = 0;
    std::int64_t poor_cells = 0; // in which no tree does all that is asked for
};

// Fills in the cells of `data`, whose sheets are those of the patches, in their order.
[[nodiscard]] CellsReport make_cells(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                     const Sides& sides, const base::Array<double>& chord, std::uint64_t seed,
                                     implicit::PiecesData& data, const base::Progress& progress);

} // namespace hrbfnpr::mesh
