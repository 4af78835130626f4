// SPDX-License-Identifier: MIT
// The field of directions that strokes follow: principal, combing or the caller's directions at evenly spread samples.
#pragma once

#include "stipples/surface_cells.h"
#include "strokes/settings.h"
#include "surface/curvature.h"
#include "surface/direction_field.h"

#include <optional>

namespace hrbfnpr::strokes {

struct StrokeFieldResult {
    surface::DirectionField field;
    // Of a cross field: the lines of set 0, by which strokes are told apart.
    std::optional<surface::DirectionField> first_set;
    double area = 0.0; // of the surface
};

[[nodiscard]] StrokeFieldResult make_stroke_field(const marks::Site& site, const stipples::SurfaceCells& cells,
                                                  marks::Kind kind, const Settings& settings, std::int64_t samples,
                                                  const base::Progress& progress);

// Stark's two directions where they are far from the border of their region; at the borders, where they jump,
// trust is 0.
struct Combing {
    glm::dvec3 r, u;
    double trust;
};
[[nodiscard]] Combing combing_at(const glm::dvec3& n) noexcept;

} // namespace hrbfnpr::strokes
