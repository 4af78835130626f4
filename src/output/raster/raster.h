// SPDX-License-Identifier: MIT
// The rasteriser: a drawing into the caller's pixels, tile by tile.
// 1. prepare (raster.cpp): a tile's planes hold the part of the paper that still shows, first all of it, and the ink's
//    colours.
// 2. lay (raster.cpp; loops.cpp for many pixels at a time): dots and strokes far to near. stroke_outline.cpp makes a
//    polygon of each segment of a stroke; stroke_union.cpp finds the area that polygons cover together where they
//    overlap.
// 3. store (raster.cpp; loops.cpp): planes to the caller's pixels, over what was there or not.
// 4. store_outputs (raster.cpp): the depth, id and class of the nearest layer or ink at each pixel's centre.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "drawing/drawing.h"
#include "output/raster/image.h"
#include "output/raster/loops.h"

namespace hrbfnpr::output {

// The scratch of one call at a time: it allocates nothing once warm.
class Raster {
public:
    explicit Raster(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(raster_loops(runtime.instruction_set)),
          published_tiles_(runtime.memory, drawing::tile_size), planes_(runtime.memory), colors_(runtime.memory),
          numbers_(runtime.memory), unions_(runtime.memory) {}

    void draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings);

private:
    // Each worker has its own, on lines of the cache of their own.
    struct alignas(base::Memory::alignment) Numbers {
        explicit Numbers(base::Memory& memory) noexcept : of_tile(memory) {}
        base::Array<std::uint32_t> of_tile; // its dots, then its segments
    };

    const base::Runtime& runtime_;
    RasterLoops loops_;
    drawing::Tiles published_tiles_; // for drawings as published, which bring no tiles of dots
    base::Array<float> planes_;      // the planes of a tile, for each worker
    base::Array<float> colors_;      // as in InkList
    base::List<Numbers> numbers_;    // one for each worker
    base::List<StrokeUnion> unions_; // one for each worker, if there are strokes
};

} // namespace hrbfnpr::output
