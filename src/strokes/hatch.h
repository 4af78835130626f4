// SPDX-License-Identifier: MIT
// The strokes of BLUE_NOISE: evenly spaced, along a smooth field of directions.
#pragma once

#include "marks/marks.h"
#include "stipples/surface_cells.h"
#include "strokes/settings.h"

namespace hrbfnpr::strokes {

struct HatchSettings : Settings {
    marks::Kind kind = marks::Kind::principal;
    std::int64_t layer = 0;  // for messages
    std::int64_t budget = 0; // the most marks; 0 = no limit
};

// How many samples a field is made of where strokes have about this many marks.
[[nodiscard]] std::int64_t field_samples_for(std::int64_t marks) noexcept;

// Appends the strokes of both directions in the order of their ranks.  Returns the area of the surface.
double hatch(const marks::Site& site, const stipples::SurfaceCells& cells, const HatchSettings& settings,
             marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress);

} // namespace hrbfnpr::strokes
