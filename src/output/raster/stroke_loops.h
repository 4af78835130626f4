// SPDX-License-Identifier: MIT
// Strokes into the planes of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "output/raster/disc_loops.h"
#include "output/raster/stroke_outline.h"

#include <cstdint>

namespace hrbfnpr::output {

// Planes of the tile's stride that are zero, and are zero again afterwards.
struct StrokePlanes {
    float* cover;           // the part of a pixel that is covered
    float* ink;             // that, times the opacity
    std::uint64_t* samples; // which of 63 places of a pixel are covered, where a stroke may overlap itself
};

struct StrokeLoops {
    // Lays the union of the segments over the tile: where they overlap, the stroke is no darker.  A pixel takes the
    // exact area that is covered of it; where parts of the stroke overlap, that is counted at 63 places.
    void (*lay)(const DiscTile& tile, const SegmentList& list, const StrokePlanes& planes);
};

[[nodiscard]] StrokeLoops stroke_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
