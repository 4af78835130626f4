// The rasteriser of frames by sheets: ink into the caller's pixels, in tiles.
#pragma once

#include "frame/depth_layers/sheet_frame.h"
#include "output/raster/draw.h"
#include "output/raster/splat_loops.h"

namespace hrbfnpr::output {

class SheetRaster {
public:
    explicit SheetRaster(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(splat_loops(runtime.instruction_set)), planes_(runtime.memory),
          colors_(runtime.memory) {}

    void draw(const frame::Frame& frame, const Image& image, const DrawSettings& settings);
    [[nodiscard]] std::int64_t scratch_bytes() const noexcept { return planes_.bytes() + colors_.bytes(); }

private:
    const base::Runtime& runtime_;
    SplatLoops loops_;
    base::Array<float> planes_; // of each lane of work
    base::Array<float> colors_; // as in InkList
};

} // namespace hrbfnpr::output
