// SPDX-License-Identifier: MIT
// Discs and strokes of ink into the planes of a tile, and planes to bytes, for each instruction set; the same bits from
// all of them.
#pragma once

#include "base/instruction_set.h"
#include "output/raster/stroke_union.h"

#include <cstdint>

namespace hrbfnpr::output {

// Rows of `stride` floats, one for each pixel.
struct DiscTile {
    std::int32_t width, height, stride; // stride >= width + 8
    float* transmittance;               // the part of the paper that still shows, from 0 to 1
    float* color[3];                    // the colour that inks add to it, premultiplied; NULL: all inks have one colour
    const float* host;                  // depth of the host's picture, falling towards the eye; or NULL
};

// Inks by their numbers; (left, top) is the tile's first pixel.
struct InkList {
    const drawing::Dot* inks;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    const float* colors; // four numbers for each layer: RGB, and an alpha that multiplies the ink's
    float one_alpha;     // the alpha that takes its place where all inks have one colour
    float toward;        // -1: the host's depth rises towards the eye; 1
};

// Planes of the tile's stride that are zero, and are zero again afterwards.
struct StrokePlanes {
    float* cover;          // the part of a pixel that is covered
    float* ink;            // the cover times the opacity
    StrokeUnion* overlaps; // working memory, for strokes that may overlap themselves
};

// Four channels of a row, each alpha * transmittance + beta * (1 - transmittance), as bytes.
struct RowColors {
    float paper[4]; // premultiplied, in the order of the bytes
    float ink[4];
    bool straight; // divide by the last one
};

struct RasterLoops {
    // Lays discs, in their order; those of paper need the planes of colours, and bring the paper back.
    void (*discs)(const DiscTile& tile, const InkList& list);
    // Lays the union of the segments over the tile: where they overlap, the stroke is no darker. A pixel takes the
    // exact area that is covered of it. Throws Error{out_of_memory}.
    void (*stroke)(const DiscTile& tile, const SegmentList& list, const StrokePlanes& planes);
    void (*store)(const RowColors& colors, const float* transmittance, std::int64_t count, std::uint32_t* pixels);
};

[[nodiscard]] RasterLoops raster_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
