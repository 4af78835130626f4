// SPDX-License-Identifier: MIT
// A mesh of an implicit that has sheets, cut where they meet: each triangle stands for one of them, and there are
// vertices on the creases and at their corners. Its smooth parts, which end at creases, are what contours are traced
// on.
#pragma once

#include "base/list.h"
#include "curves/chains.h"
#include "curves/surface_end.h"
#include "implicit/one_sheet.h"

#include <memory>

namespace hrbfnpr::curves {

// A place of a crease where an edge of the mesh crosses it, or a corner.
struct CreaseNode {
    glm::dvec3 position{0.0};
    bool exact = false; // both sheets are 0 there; else they could not be told apart, or more than two meet
};

// Creases as chains of nodes, from corner to corner, from border to border, or closed.
struct CreaseChains : Chains<CreaseNode> {
    explicit CreaseChains(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // the sheets on both sides of each chain, as seen from outside
};

struct SharpMesh {
    explicit SharpMesh(base::Memory& memory) : mesh(memory), sheet(memory), creases(memory) {}

    // A vertex on a crease stands there once for each sheet, with that sheet's gradient; edges on creases have no
    // neighbour.
    SurfaceMesh mesh;
    base::Array<std::int32_t> sheet; // the sheet of each triangle
    CreaseChains creases;
};

// The vertices of `mesh` stay the first ones. Some edges are halved whose sheets meet beside them, but off the surface,
// since another sheet lies between. The same bits for any thread count.
[[nodiscard]] SharpMesh split_at_creases(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                         SurfaceMesh mesh, const base::Progress& progress);

struct SheetPart {
    SheetPart(base::Memory& memory, const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t of)
        : sheet(of), surface(whole, sheets, of), mesh(memory) {}

    std::int32_t sheet;
    implicit::OneSheet surface;
    SurfaceMesh mesh; // the mesh of this sheet alone; it ends at the sheet's creases
    std::unique_ptr<const SheetEnd> end;
};

// A part of each sheet that has triangles, in the order of sheets.
[[nodiscard]] base::List<std::unique_ptr<SheetPart>>
sheet_parts(const base::Runtime& runtime, const implicit::Implicit& whole, const SharpMesh& mesh);

} // namespace hrbfnpr::curves
