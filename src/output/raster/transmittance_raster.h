// SPDX-License-Identifier: MIT
// The rasteriser of drawings whose ink has been dimmed already: what is left of the paper, tile by tile.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "drawing/drawing.h"
#include "output/raster/disc_loops.h"
#include "output/raster/settings.h"
#include "output/raster/stroke_loops.h"

namespace hrbfnpr::output {

class TransmittanceRaster {
public:
    explicit TransmittanceRaster(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(disc_loops(runtime.instruction_set)),
          stroke_loops_(stroke_loops(runtime.instruction_set)), planes_(runtime.memory), colors_(runtime.memory),
          numbers_(runtime.memory), unions_(runtime.memory) {}

    void draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings);

private:
    // A worker's, on lines of the cache of its own.
    struct alignas(base::Memory::alignment) Numbers {
        explicit Numbers(base::Memory& memory) noexcept : of_tile(memory) {}
        base::Array<std::uint32_t> of_tile; // its dots, then its segments
    };

    const base::Runtime& runtime_;
    DiscLoops loops_;
    StrokeLoops stroke_loops_;
    base::Array<float> planes_;      // of each worker
    base::Array<float> colors_;      // as in InkList
    base::List<Numbers> numbers_;    // of each worker
    base::List<StrokeUnion> unions_; // of each worker, if there are strokes
};

} // namespace hrbfnpr::output
