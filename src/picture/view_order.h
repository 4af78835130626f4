// SPDX-License-Identifier: MIT
// Draws coinciding lines of a view once. Visible lines have priority over hidden ones, and these over smooth ones [ISO
// 128-2]. In views along planes of symmetry and along flat faces, nearly every line coincides with one farther away.
#pragma once

#include "picture/memory.h"
#include "picture/tuning_views.h"
#include "picture/view_polylines.h"

namespace hrbfnpr::picture {

// A line on the paper, with at least two points.
struct ViewCurve {
    explicit ViewCurve(Pool& pool) : points(&pool), hidden(&pool) {}

    PaperLine points; // The curve is closed if the last point is the first.
    Flags hidden;     // whether surface hides the piece from point i to point i + 1
    int rank = 1;     // curves of lower rank are drawn first
    // Other lines of the same kind are left out if they are nearly parallel and nearer than this, in mm.
    double reach = view_order_tuning.reach;
    // The line is not a sharp edge. Its visible parts are drawn thin, and its hidden parts are not drawn.
    bool is_smooth = false;
};

// The lines that are drawn.
struct ShownLines {
    explicit ShownLines(Pool& pool) : outlines(&pool), hidden(&pool), smooth(&pool) {}

    Vector<PaperLine> outlines;
    Vector<PaperLine> hidden;
    Vector<PaperLine> smooth;
};

// Uses each place of the paper once: by kind, then by rank, with long parts first. Hidden lines are drawn only if
// `with_hidden` is true.
[[nodiscard]] ShownLines draw_in_order(const Vector<ViewCurve>& curves, bool with_hidden, Pool& pool);

// Returns the flags of the curve's hidden pieces without parts too short to be seen.
[[nodiscard]] Flags steady(const ViewCurve& curve, Pool& pool);

} // namespace hrbfnpr::picture
