// SPDX-License-Identifier: MIT
// Hatching on a surface: evenly spaced lines along one smooth field cover the surface, in nested levels. The lines of
// each level lie between the lines of the coarser levels. The steps are:
//   field.h       even samples -> a graph of neighbours -> a smooth field of lines -> waves on the samples, of the
//                 longest period, of half of it, and so on -> waves on a mesh
//   lines.h       the crests of the finest wave -> lines -> joined ends -> even distances -> marks on the surface
//   forks.h       strays at cracks of the mesh are left out, and ends are continued into forks
#pragma once

#include "curves/surface_mesh.h"
#include "hatching/field.h"
#include "hatching/tuning.h"
#include "marks/site.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::hatching {

// Lengths are in object units.
struct Settings {
    std::int64_t layer = 0;  // the index of the layer, for messages
    std::int64_t budget = 0; // The approximate number of marks. It is used if `separation` is 0.
    // The distance between neighbouring lines where the lines of all levels are drawn. 0: the budget decides.
    double separation = 0.0;
    double step = 0.0; // The distance between marks along a line. 0: a share of the separation.
    // The angle by which lines are rotated in the tangent plane, counter-clockwise as seen from outside, in radians.
    double angle = 0.0;
    FieldSettings field;
    marks::DirectionFunction direction; // A function whose directions replace the curvature.

    // Returns whether both settings can share a HatchingField.
    [[nodiscard]] bool shares_field_with(const Settings& other) const noexcept;
};

// The data that does not depend on the angle of lines: the field, and the mesh on which lines are found.
class HatchingField {
public:
    HatchingField(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings);

    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
    // Returns whether lines can be placed on all of the surface, not only where the site's `need` may show them.
    [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
    [[nodiscard]] double area() const noexcept { return area_; } // the area of the surface that the lines are laid on
    // Appends marks, line after line. Coarse levels come first. If the site has a `need`, lines are placed only where
    // it may show them, and end a few separations beyond.
    void place_lines(const marks::Site& site, const Settings& settings, marks::Marks& marks,
                     marks::LayerReport& report) const;

private:
    Settings settings_;
    geometry::Bounds region_;
    bool is_whole_;
    double area_ = 0.0;
    SampleGraph graph_;
    base::Array<double> angle_; // for each sample: the angle of the field's line in its frame, in radians
    curves::SurfaceMesh mesh_;
    base::Array<std::int32_t> sheet_; // for each vertex: its sheet, if the mesh is split at creases; else empty
};

} // namespace hrbfnpr::hatching
