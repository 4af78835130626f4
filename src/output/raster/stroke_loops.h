// SPDX-License-Identifier: MIT
// Strokes into the planes of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "output/raster/disc_loops.h"
#include "output/raster/stroke_union.h"

#include <cstdint>

namespace hrbfnpr::output {

// Planes of the tile's stride that are zero, and are zero again afterwards.
struct StrokePlanes {
    float* cover;          // the part of a pixel that is covered
    float* ink;            // that, times the opacity
    StrokeUnion* overlaps; // working memory, for strokes that may overlap themselves
};

struct StrokeLoops {
    // Lays the union of the segments over the tile: where they overlap, the stroke is no darker.  A pixel takes the
    // exact area that is covered of it.  Throws Error{out_of_memory}.
    void (*lay)(const DiscTile& tile, const SegmentList& list, const StrokePlanes& planes);
};

[[nodiscard]] StrokeLoops stroke_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
