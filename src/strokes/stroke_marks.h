// SPDX-License-Identifier: MIT
// From laid strokes to marks on the surface.
#pragma once

#include "marks/direction_function.h"
#include "marks/marks.h"
#include "strokes/stroke_layer.h"

namespace hrbfnpr::strokes {

// A stroke in the order of all.
struct OrderedStroke {
    const StrokePoint* point = nullptr;
    std::int64_t count = 0; // of its marks
    std::int64_t every = 1; // points to a mark
    std::uint32_t set = 0;
    std::uint8_t pass = 0;
    bool closed = false;
    // Where one stroke was split into two of different sets they go on from each other: no taper there.
    bool goes_on_before = false, goes_on_after = false;
};

struct StrokeMarkSettings {
    marks::Kind kind = marks::Kind::principal;
    marks::DirectionFunction direction; // of FIELD
    double separation = 0.0;
    double step = 0.0; // from mark to mark
    geometry::Bounds region;
};

// Projects the points, and appends the marks of what lands in one piece, stroke after stroke.
void settle_strokes(const marks::Site& site, const base::Array<OrderedStroke>& strokes,
                    const StrokeMarkSettings& settings, marks::Marks& marks, marks::LayerReport& report,
                    const base::Progress& progress);

} // namespace hrbfnpr::strokes
