// SPDX-License-Identifier: MIT
// Steps between two sheets that are hardly apart: a mesh has a vertex in them by chance only.
#pragma once

#include "base/operation.h"
#include "curves/surface_mesh.h"
#include "implicit/sheets.h"

namespace hrbfnpr::curves {

// A vertex of whose sheet no vertex beside it is, where the sheets of all these are no farther away than `alike` sides
// and as parallel, is one more of the first of them, and moves onto it.  sheet: of each vertex.
void settle_alone(const base::Runtime& runtime, const implicit::Sheets& sheets, double alike, SurfaceMesh& mesh,
                  base::Array<std::int32_t>& sheet, const base::Progress& progress);

} // namespace hrbfnpr::curves
