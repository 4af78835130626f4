// SPDX-License-Identifier: MIT
// Strokes into the planes of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "output/raster/disc_loops.h"

#include <cstdint>

namespace hrbfnpr::output {

// One stroke's segments that reach the tile, by the numbers of their first points.
struct SegmentList {
    const drawing::StrokePoint* points;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;    // the tile's first pixel
    const float* color; // RGB of the ink, and its alpha; the RGB is not read where the tile has no colour
    float toward;       // as in InkList
};

struct StrokeLoops {
    // Lays the union of the segments over the tile: where they overlap, the stroke is no darker.  `cover` is a plane
    // of the tile's stride that is zero, and is zero again afterwards.
    void (*lay)(const DiscTile& tile, const SegmentList& list, float* cover);
};

[[nodiscard]] StrokeLoops stroke_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
