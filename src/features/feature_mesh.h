// SPDX-License-Identifier: MIT
// The mesh that feature lines are looked for on: finer where curvatures change otherwise between two vertices than
// their derivatives at both tell, as around the samples of a rough fit.
#pragma once

#include "curves/surface_mesh.h"
#include "features/shape.h"

namespace hrbfnpr::curves {

struct ShapedMesh {
    explicit ShapedMesh(base::Memory& memory) noexcept : mesh(memory), shape(memory) {}

    SurfaceMesh mesh;              // `side` is that of the cells it was made from
    base::Array<ShapePoint> shape; // at its vertices
    [[nodiscard]] std::int64_t bytes() const noexcept { return mesh.bytes() + shape.bytes(); }
};

// Edges are halved, up to three times, and their middles brought onto the surface; each triangle is cut into two, three
// or four at its halved edges, so that triangles still meet nowhere but in edges and corners.  The first vertices are
// those of `mesh`.  The same bits for any thread count.  Throws Error{out_of_memory, cancelled, callback}.
[[nodiscard]] ShapedMesh measured_mesh(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                       const implicit::ShapeSource& source, const SurfaceMesh& mesh,
                                       const base::Progress& progress);

} // namespace hrbfnpr::curves
