// SPDX-License-Identifier: MIT
// Lines of one view, and which parts of them are hidden.
//
// Contours come from a drawing of the model, which counts the surfaces before each part.  Creases are the mesh's own
// edges: rays tell whether they are hidden.  Rays also tell it of all lines behind a cutting plane, where what stands
// before the plane counts for nothing.
#pragma once

#include "picture/call.h"
#include "picture/view_layout.h"
#include "picture/view_order.h"

namespace hrbfnpr::picture {

// What is drawn: a model, its lines and edges, and where its middle is.
struct Solid {
    explicit Solid(Pool& pool) : creases(&pool), smooth(&pool), middle(0.0) {}

    Model model;
    LineSet lines;
    PointSet marks; // a frame has to have some; none is drawn
    Renderer renderer;
    Vector<Points> creases;       // edges of a mesh
    Vector<std::uint32_t> smooth; // HRBFNPR_LINE_KIND_... of lines that are not sharp
    glm::dvec3 middle;
    double diagonal = 0.0;  // > 0
    bool is_open = false;   // a sheet that ends: either of its sides may be seen
    double lipschitz = 0.0; // of rays, where it is open
};

// Edges of a mesh without short ones that end somewhere in a face, which are the facets of a rounded shape.
[[nodiscard]] Vector<Points> without_loose_edges(Vector<Points> creases, double diagonal, Pool& pool);

struct ViewLines {
    explicit ViewLines(Pool& pool) : curves(&pool), outlines(&pool) {}

    Vector<ViewCurve> curves;   // mm from the view's centre
    Vector<PaperLine> outlines; // of what a section cuts
};

// scale: mm of a unit of the model.  operation: watched for a cancel.
[[nodiscard]] ViewLines lines_of_view(const SheetView& view, const Vector<CutPlane>& planes, const Solid& solid,
                                      double scale, hrbfnpr_operation* operation, Pool& pool);

} // namespace hrbfnpr::picture
