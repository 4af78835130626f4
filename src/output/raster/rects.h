// SPDX-License-Identifier: MIT
// Which pixels are drawn.
#pragma once

#include "geometry/vec.h"
#include "output/raster/settings.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {

// Half-open, pixels.
struct Rect {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool empty() const noexcept { return left >= right || top >= bottom; }
};

// The pixels of the image whose centres lie in the viewport.
[[nodiscard]] inline Rect drawn_rect(const glm::dvec4& viewport, const Image& image) noexcept {
    const auto edge = [](double at, std::int32_t limit) {
        return static_cast<std::int32_t>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(limit)));
    };
    return {edge(viewport.x, image.width), edge(viewport.y, image.height), edge(viewport.x + viewport.z, image.width),
            edge(viewport.y + viewport.w, image.height)};
}

[[nodiscard]] inline glm::vec4 premultiplied(const glm::vec4& straight) noexcept {
    return {glm::vec3(straight) * straight.w, straight.w};
}

} // namespace hrbfnpr::output
