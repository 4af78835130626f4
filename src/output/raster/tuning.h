// SPDX-License-Identifier: MIT
// The tuning constants of the rasteriser. tests/raster compares its strokes with exact pixel areas; scripts/bench frame
// measures its time.
#pragma once

namespace hrbfnpr::output {

struct RasterTuning {
    // ---- Outlines of strokes

    // Points closer than this count as one, in pixels.
    double same_point = 1e-6;
    // The greatest error of an edge, in pixels. Larger: fewer edges, less exact.
    double edge_tolerance = 0.0007;
    // The greatest distance of an arc's chords from the arc, in pixels. For a chord shorter than 1 pixel, this distance
    // is multiplied by the chord's length in pixels. Larger: fewer chords.
    double arc_tolerance = 0.006;
    // The greatest error of an arc that is a single chord, in pixels. It is smaller than arc_tolerance, because the
    // whole arc lies on one side of its chord.
    double chord_tolerance = 0.0008;
    // The tolerances of arcs and chords are multiplied by this if arcs may overlap, because their errors add up.
    double overlap_factor = 0.2;
    // A quarter circle is divided into chords by halving it at most this many times.
    int most_halvings = 6;
    // Consecutive segments whose opacities differ by no more than this share an outline. Larger: fewer outlines,
    // visible steps.
    float same_opacity = 1.0F / 1024.0F;

    // ---- Unions of outlines

    // The largest number of breaks in a row. Breaks are the heights where edges begin, end or cross. A row with more
    // breaks is cut into this many slabs of equal height. Larger: tangled strokes are more exact, but take more time.
    int most_breaks = 256;
    // Slabs lower than this, in pixels, are skipped.
    double least_slab_height = 1e-12;
};
inline constexpr RasterTuning raster_tuning;

} // namespace hrbfnpr::output
