// SPDX-License-Identifier: MIT
// The tuning constants of the rasteriser. tests/raster holds its strokes against exact areas of pixels; scripts/bench
// frame measures its time.
#pragma once

namespace hrbfnpr::output {

struct RasterTuning {
    // ---- Outlines of strokes

    // Points that are nearer to each other than this stand in one place, pixels.
    double nowhere = 1e-6;
    // An edge may lie off by this much, pixels. Larger: fewer edges, less exact.
    double edge_tolerance = 0.0007;
    // An arc's chords may lie off by this much, times their length where that is less than a pixel. Larger: fewer
    // chords.
    double arc_tolerance = 0.006;
    // The same for an arc of one chord, whose error is all on one side.
    double chord_tolerance = 0.0008;
    // Both are multiplied by this where arcs may lie upon each other, since their errors add up.
    double finer = 0.2;
    // A quarter of a circle has at most two to this power chords.
    int most_halvings = 6;
    // Segments whose opacities differ by no more than this make one outline. Larger: fewer outlines, visible steps.
    float same_opacity = 1.0F / 1024.0F;

    // ---- Unions of outlines

    // A row with more heights than this where edges begin, end or cross is cut into as many even slabs. Larger: more
    // exact rows of very tangled strokes, more time.
    int most_breaks = 256;
    // Slabs that are less high than this are left out, pixels.
    double flat = 1e-12;
};
inline constexpr RasterTuning raster_tuning;

} // namespace hrbfnpr::output
