// The rasteriser of frames by layers: ink into the caller's pixels, in tiles.
#pragma once

#include "frame/depth_layers/layer_frame.h"
#include "output/raster/disc_loops.h"
#include "output/raster/draw.h"

namespace hrbfnpr::output {

class LayerRaster {
public:
    explicit LayerRaster(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(disc_loops(runtime.instruction_set)), planes_(runtime.memory),
          colors_(runtime.memory) {}

    void draw(const frame::Frame& frame, const Image& image, const DrawSettings& settings);
    [[nodiscard]] std::int64_t scratch_bytes() const noexcept { return planes_.bytes() + colors_.bytes(); }

private:
    const base::Runtime& runtime_;
    DiscLoops loops_;
    base::Array<float> planes_; // of each lane of work
    base::Array<float> colors_; // as in InkList
};

} // namespace hrbfnpr::output
