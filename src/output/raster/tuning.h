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
    // The greatest error of an arc's chords, in pixels; it is multiplied by the chord's length if that is below a
    // pixel. Larger: fewer chords.
    double arc_tolerance = 0.006;
    // The greatest error of an arc of one chord, in pixels; its error is all on one side.
    double chord_tolerance = 0.0008;
    // Both are multiplied by this where arcs may overlap, since their errors add up.
    double overlap_factor = 0.2;
    // A quarter circle has at most two to the power of this many chords.
    int most_halvings = 6;
    // Consecutive segments whose opacities differ by no more than this share an outline. Larger: fewer outlines,
    // visible steps.
    float same_opacity = 1.0F / 1024.0F;

    // ---- Unions of outlines

    // The largest number of breaks of a row, which are the heights where edges begin, end or cross. A row with more is
    // cut into this many slabs of equal height. Larger: very tangled strokes are more exact, more time.
    int most_breaks = 256;
    // Slabs lower than this are skipped, in pixels.
    double least_slab_height = 1e-12;
};
inline constexpr RasterTuning raster_tuning;

} // namespace hrbfnpr::output
