// SPDX-License-Identifier: MIT
// Strokes over a whole surface, evenly spaced, coarse ones before those between them.
// [Jobard & Lefer 1997; farthest-point seeding after Mebarki, Alliez & Devillers 2005]
#pragma once

#include "base/operation.h"
#include "strokes/stroke_tracer.h"

namespace hrbfnpr::strokes {

// Distances in object units.
struct LayerSettings {
    double separation = 0.0; // of neighbouring strokes, about, once all are laid
    double step = 0.0;       // of points along a stroke
    double longest = 0.0;    // 0 = no limit
    std::int64_t most_points = 0;
    int passes = 1; // the first one keeps 2^(passes - 1) separations, each further one half as many
    bool turned = false;
    geometry::Bounds region;
};

// Strokes in the order in which they were accepted.
struct Layer {
    explicit Layer(base::Memory& memory) noexcept : point(memory), stroke(memory) {}

    struct Stroke {
        std::int64_t begin = 0; // of its points
        std::int64_t count = 0;
        std::uint8_t pass = 0;
        bool closed = false;
    };

    base::Array<StrokePoint> point; // stroke by stroke, from end to end
    base::Array<Stroke> stroke;
};

[[nodiscard]] Layer lay_strokes(base::Memory& memory, const surface::DirectionField& field,
                                const LayerSettings& settings, const base::Progress& progress);

} // namespace hrbfnpr::strokes
