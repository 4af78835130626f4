// SPDX-License-Identifier: MIT
// Draws coinciding lines of a view once. Visible edges have priority over tangent edges, these over hidden edges, and
// hidden edges over smooth lines [ISO 128-2]. In views along planes of symmetry and along flat faces, nearly every line
// coincides with a line farther away.
#pragma once

#include "picture/shape.h"
#include "picture/tuning_views.h"
#include "picture/view_polylines.h"

namespace hrbfnpr::picture {

// The class of a line. Sharp edges and contours are drawn thick. The visible parts of tangent edges and smooth lines
// are drawn thin, and their hidden parts are not drawn.
enum class ViewClass : std::uint8_t { edge, tangent, smooth };

// A line on the paper, with at least two points.
struct ViewCurve {
    explicit ViewCurve(Pool& pool) : points(&pool), hidden(&pool), places(&pool), sure(&pool) {}

    PaperLine points; // The curve is closed if the last point is the first.
    Flags hidden;     // true if surface hides the piece from point i to point i + 1
    int rank = 1;     // Curves of lower rank are drawn first.
    // Other lines of this kind are left out if they are nearly parallel to the curve and nearer to it than this, in mm.
    double reach = view_order_tuning.reach;
    ViewClass of_class = ViewClass::edge;
    Points places;     // the places in the model of the points; empty if they are not known
    double lift = 0.0; // how far a place may be inside the model, in units of the model
    // 1 if rays show that the piece from point i to point i + 1 is hidden or visible as `hidden` says; may be empty
    Flags sure;
};

// The lines to draw.
struct ShownLines {
    explicit ShownLines(Pool& pool) : outlines(&pool), hidden(&pool), tangent(&pool), smooth(&pool) {}

    Vector<PaperLine> outlines;
    Vector<PaperLine> hidden;
    Vector<PaperLine> tangent;
    Vector<PaperLine> smooth;
};

// Draws at most one line at each place of the paper. Lines are taken by kind, then by rank, the long parts first.
// Hidden lines are drawn only if `with_hidden` is true.
[[nodiscard]] ShownLines draw_in_order(const Vector<ViewCurve>& curves, bool with_hidden, Pool& pool);

// Returns the lines without the length `gap` at each end. A line gives up at most half of its length. Closed lines stay
// as they are.
[[nodiscard]] Vector<PaperLine> shortened(const Vector<PaperLine>& lines, double gap, Pool& pool);

// Returns the flags of the hidden pieces after removing parts that are too short to be seen, unless they are sure.
[[nodiscard]] Flags steady(const ViewCurve& curve, Pool& pool);

} // namespace hrbfnpr::picture
