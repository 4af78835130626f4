// SPDX-License-Identifier: MIT
// Hatching: lines all over a surface along one smooth field, evenly spaced, coarse ones before those between them.
#pragma once

#include "curves/surface_mesh.h"
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

    // Whether lines of both can be laid on one ground.
    [[nodiscard]] bool is_on_ground_of(const Settings& other) const noexcept;
};

// What lines of any angle are laid on: the field, and the mesh that they are found on.
class Ground {
public:
    Ground(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
           const base::Progress& progress);
    Ground(const Ground&) = delete; // the graph is referred to
    Ground& operator=(const Ground&) = delete;

    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
    [[nodiscard]] double area() const noexcept { return area_; } // of the surface
    // Appends marks, line after line, coarse levels first.
    void lay_lines(const marks::Site& site, const Settings& settings, marks::Marks& marks, marks::LayerReport& report,
                   const base::Progress& progress) const;

private:
    struct Spread;
    void end_at_creases(const marks::Site& site, const base::Progress& progress);
    Ground(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings, Spread spread,
           const base::Progress& progress);

    Settings settings_;
    geometry::Bounds region_;
    double area_;
    SampleGraph graph_;
    base::Array<double> angle_; // of the field at each sample
    curves::SurfaceMesh mesh_;
    base::Array<std::int32_t> sheet_; // of its vertices, where it ends at creases; else empty
};

// So many samples a ground is made of.
inline constexpr std::int64_t most_samples = 32768;
[[nodiscard]] std::int64_t samples_for(const Settings& settings, double area) noexcept;

} // namespace hrbfnpr::hatching
