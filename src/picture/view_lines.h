// SPDX-License-Identifier: MIT
// Traces the lines of one view, and finds their hidden parts.
//
// Contours come from a drawing of the model, which counts the surfaces in front of each part. Creases are the mesh's
// own edges, and rays find whether they are hidden. Rays also find this for all lines beyond a cutting plane, because
// the part of the model in front of the plane hides nothing.
#pragma once

#include "picture/call.h"
#include "picture/lines.h"
#include "picture/view_layout.h"
#include "picture/view_order.h"

namespace hrbfnpr::picture {

// The object that is drawn: a model, its lines and edges, and its middle. An object of several surfaces has one of its
// models here, and each of the others in a Solid of its own.
struct Solid {
    explicit Solid(Pool& pool) : creases(&pool), others(&pool), smooth(&pool), middle(0.0) {}

    Model model;
    LineSet lines;
    PointSet marks;         // marks that a frame needs; they are not drawn
    Vector<Points> creases; // the sharp edges of a mesh
    bool is_open = false;   // True if the surface is a sheet that ends, so that both of its sides may be visible.
    double lipschitz = 0.0; // for an open surface: the Lipschitz constant that rays use
    Vector<Solid> others;   // the other surfaces of the object; only the members above are used
    Renderer renderer;
    bool has_tangents = false;    // whether `lines` has tangent edges
    Vector<std::uint32_t> smooth; // the kinds (HRBFNPR_LINE_KIND_*) of lines that are not sharp edges
    glm::dvec3 middle;
    double diagonal = 0.0;    // above 0
    bool is_verified = false; // True if drawn lines are compared with rays.
    bool is_shell = false;    // True if the object is so open that it has no inside; cuts of it are lines.

    // Calls f for each surface of the object.
    template <class F>
    void for_surfaces(F&& f) const {
        f(*this);
        for (const Solid& other : others) f(other);
    }
};

// Returns the edges of a mesh, except short ones with a free end, which are the facets of a rounded shape.
[[nodiscard]] Vector<Points> without_loose_edges(Vector<Points> creases, double diagonal, Pool& pool);

struct ViewLines {
    explicit ViewLines(Pool& pool) : curves(&pool), outlines(&pool) {}

    Vector<ViewCurve> curves;   // in mm from the centre of the view
    LineProof proof;            // empty if the lines are not verified
    Vector<PaperLine> outlines; // the outlines of the section
};

// Returns the lines of a view. `scale` is in mm per unit of the model. The call ends early if `operation` is cancelled.
[[nodiscard]] ViewLines lines_of_view(const SheetView& view, const Vector<CutPlane>& planes, const Solid& solid,
                                      double scale, hrbfnpr_operation* operation, Pool& pool);

} // namespace hrbfnpr::picture
