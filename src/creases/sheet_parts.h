// SPDX-License-Identifier: MIT
// The surface of an implicit with creases as smooth parts, each of which ends at creases: what contours are traced on.
#pragma once

#include "base/list.h"
#include "creases/crease_mesh.h"
#include "implicit/one_sheet.h"

#include <memory>

namespace hrbfnpr::curves {

struct SheetPart {
    SheetPart(base::Memory& memory, const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t of)
        : sheet(of), surface(whole, sheets, of), mesh(memory) {}

    std::int32_t sheet;
    implicit::OneSheet surface;
    SurfaceMesh mesh;                               // the mesh of this sheet alone; it ends at the sheet's creases
    std::unique_ptr<const implicit::Domain> domain; // the mesh's
};

// A part of each sheet that has triangles, in the order of sheets.
[[nodiscard]] base::List<std::unique_ptr<SheetPart>>
sheet_parts(const base::Runtime& runtime, const implicit::Implicit& whole, const SharpMesh& mesh);

} // namespace hrbfnpr::curves
