// SPDX-License-Identifier: MIT
// The rasteriser: a drawing into the caller's pixels, in tiles.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "drawing/drawing.h"
#include "output/raster/published_raster.h"
#include "output/raster/settings.h"
#include "output/raster/transmittance_raster.h"

namespace hrbfnpr::output {

// The scratch of one call at a time: allocates nothing once warm.
class Raster {
public:
    explicit Raster(const base::Runtime& runtime) noexcept : published_(runtime), transmittance_(runtime) {}

    void draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings) {
        if (drawing.painting == drawing::Painting::published)
            published_.draw(drawing, image, settings);
        else
            transmittance_.draw(drawing, image, settings);
    }

private:
    PublishedRaster published_;
    TransmittanceRaster transmittance_;
};

} // namespace hrbfnpr::output
