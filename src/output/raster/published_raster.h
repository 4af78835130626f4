// SPDX-License-Identifier: MIT
// The rasteriser of drawings as published: discs of paper and of ink, far to near.     [NPAR 6.1]
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "output/raster/settings.h"

namespace hrbfnpr::output {

class PublishedRaster {
public:
    explicit PublishedRaster(const base::Runtime& runtime) noexcept;
    void draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings);

private:
    const base::Runtime& runtime_;
    drawing::Tiles tiles_;
};

} // namespace hrbfnpr::output
