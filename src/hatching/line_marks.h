// SPDX-License-Identifier: MIT
// From lines on a mesh to marks on the surface.
#pragma once

#include "hatching/lines.h"
#include "marks/marks.h"

namespace hrbfnpr::hatching {

struct LineMarkSettings {
    double separation = 0.0; // of the finest level
    double step = 0.0;       // from mark to mark
    geometry::Bounds region; // beyond it there is no surface
};

// Appends marks at even steps along each line, brought onto the surface, line after line; those that are of a coarse
// level somewhere come first.
void add_line_marks(const marks::Site& site, const Lines& lines, const LineMarkSettings& settings, marks::Marks& marks,
                    marks::LayerReport& report, const base::Progress& progress);

} // namespace hrbfnpr::hatching
