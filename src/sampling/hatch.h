// The strokes of BLUE_NOISE: evenly spaced, along a smooth field of directions.
#pragma once

#include "sampling/generate.h"
#include "sampling/marks.h"
#include "sampling/surface_cells.h"

namespace hrbfnpr::sampling {

struct HatchSettings {
    Group group = Group::curvature;
    double separation = 0.0; // 0 = such that all strokes have about `budget` marks
    double step = 0.0;       // 0 = a part of the separation
    double longest = 0.0;    // 0 = no limit
    std::int64_t budget = 0; // the most marks; 0 = no limit
    StrokeField field = StrokeField::cross;
};

// How many samples a field is made of where strokes have about this many marks.
[[nodiscard]] std::int64_t field_samples_for(std::int64_t marks) noexcept;

// Appends both sets' strokes in the order of their ranks.  Returns the area of the surface.
double hatch(const Site& site, const SurfaceCells& cells, const HatchSettings& settings, Marks& marks,
             GroupReport& report, const base::Progress& progress);

} // namespace hrbfnpr::sampling
