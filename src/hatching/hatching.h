// SPDX-License-Identifier: MIT
// Hatching laid out on a surface: lines all over it along one smooth field, evenly spaced, in nested levels of which
// each has the lines between those of the ones before. In this order:
//   field.h       even samples -> a graph of neighbours -> a smooth field of lines -> waves on the samples, of the
//                 longest period and of halves of it -> waves on a mesh
//   lines.h       the crests of the finest wave -> lines -> joined ends -> even distances -> marks on the surface
#pragma once

#include "curves/surface_mesh.h"
#include "hatching/field.h"
#include "hatching/tuning.h"
#include "marks/site.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::hatching {

// Lengths are in object units.
struct Settings {
    std::int64_t layer = 0;  // for messages
    std::int64_t budget = 0; // the number of marks, about, where there is no separation
    double separation = 0.0; // the distance of neighbouring lines of all levels together; 0: it follows from the budget
    double step = 0.0;       // between the marks of a line; 0: a part of the separation
    double angle = 0.0;      // by which lines are turned in the tangent plane, counter-clockwise from outside; radians
    FieldSettings field;
    marks::DirectionFunction direction; // what lines follow in place of curvature

    // Whether lines of both can be laid on one ground.
    [[nodiscard]] bool is_on_ground_of(const Settings& other) const noexcept;
};

// What lines of any angle are laid on: the field, and the mesh that they are found on.
class Ground {
public:
    Ground(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings);

    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
    [[nodiscard]] double area() const noexcept { return area_; } // the area of the surface that the lines are laid on
    // Appends marks, line after line, coarse levels first.
    void lay_lines(const marks::Site& site, const Settings& settings, marks::Marks& marks,
                   marks::LayerReport& report) const;

private:
    Settings settings_;
    geometry::Bounds region_;
    double area_ = 0.0;
    SampleGraph graph_;
    base::Array<double> angle_; // the angle of the field's line at each sample, in the sample's frame, radians
    curves::SurfaceMesh mesh_;
    base::Array<std::int32_t> sheet_; // the sheet of each vertex of the mesh, if the mesh ends at creases; else empty
};

} // namespace hrbfnpr::hatching
