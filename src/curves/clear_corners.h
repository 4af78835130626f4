// SPDX-License-Identifier: MIT
// A surface that passes a lattice's corner very near cuts all edges there in the same point, and the triangles
// degenerate.
#pragma once

#include "curves/crossed_cells.h"

namespace hrbfnpr::curves {

// Moves corners that are very near the surface away from it, by some percent of a side.  Signs stay, and so does the
// way in which triangles are connected.
void clear_corners(const base::Runtime& runtime, const implicit::Implicit& implicit, CrossedCells& cells,
                   const base::Progress& progress);

} // namespace hrbfnpr::curves
