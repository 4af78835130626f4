// SPDX-License-Identifier: MIT
// Lines of a view that coincide: one of them is drawn, visible ones before hidden ones before smooth ones [ISO 128-2].
// Views along planes of symmetry and along flat faces have a line behind nearly every line.
#pragma once

#include "picture/memory.h"
#include "picture/tuning_views.h"
#include "picture/view_polylines.h"

namespace hrbfnpr::picture {

// A line on the paper.  Two points and more.
struct ViewCurve {
    explicit ViewCurve(Pool& pool) : points(&pool), hidden(&pool) {}

    PaperLine points; // closed if the last one is the first
    Flags hidden;     // whether surface hides the piece from point i to point i + 1
    int rank = 1;     // curves of lower rank are drawn first
    // mm: others of the same kind that are nearer and as good as parallel are left out.
    double reach = view_order_tuning.reach;
    bool is_smooth = false; // it is no sharp edge: it is drawn thin where it is visible, and else not
};

// What is drawn.
struct ShownLines {
    explicit ShownLines(Pool& pool) : outlines(&pool), hidden(&pool), smooth(&pool) {}

    Vector<PaperLine> outlines;
    Vector<PaperLine> hidden;
    Vector<PaperLine> smooth;
};

// Takes each place of the paper once: by kind, by rank, long parts first.  with_hidden: else nothing hidden is drawn.
[[nodiscard]] ShownLines draw_in_order(const Vector<ViewCurve>& curves, bool with_hidden, Pool& pool);

// The curve's `hidden` without parts that are too short to be seen.
[[nodiscard]] Flags steady(const ViewCurve& curve, Pool& pool);

} // namespace hrbfnpr::picture
