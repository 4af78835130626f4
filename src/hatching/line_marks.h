// SPDX-License-Identifier: MIT
// From lines on a mesh to marks on the surface.
#pragma once

#include "hatching/stripe_lines.h"
#include "marks/marks.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::hatching {

struct LineMarkSettings {
    double separation = 0.0; // of the finest level
    double step = 0.0;       // from mark to mark
    int finest = 0;          // level
    geometry::Bounds region;
};

// Evenly along each line, brought onto the surface.  Around a fork of a coarse wave a line changes its level, and only
// for long.  Lines that are of a coarse level somewhere come first.
void add_line_marks(const marks::Site& site, const StripeLines& lines, const LineMarkSettings& settings,
                    marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress);

} // namespace hrbfnpr::hatching
