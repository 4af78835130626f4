// SPDX-License-Identifier: MIT
// Hatching: lines all over a surface along one smooth field, evenly spaced, coarse ones before those between them.
#pragma once

#include "hatching/line_field.h"
#include "marks/direction_function.h"
#include "marks/marks.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::hatching {

// Lengths in object units.
struct Settings {
    std::int64_t layer = 0;  // for messages
    std::int64_t budget = 0; // marks, about, where there is no separation
    double separation = 0.0; // of all lines together; 0: by the budget
    double step = 0.0;       // between the marks of a line; 0: a part of the separation
    double angle = 0.0;      // by which lines are turned in the tangent plane, counter-clockwise from outside; radians
    FieldSettings field;
    marks::DirectionFunction direction; // what lines follow in place of curvature
};

// So many samples the field and the waves are made of.
[[nodiscard]] std::int64_t samples_for(const Settings& settings, double area) noexcept;

// Appends marks, line after line, coarse levels first.  Returns the area of the surface.
double lay_lines(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
                 marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress);

} // namespace hrbfnpr::hatching
