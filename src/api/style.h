// SPDX-License-Identifier: MIT
// Converts the public style to the frame's style.
#pragma once

#include "api/descriptor.h"
#include "base/memory.h"
#include "frame/scene/style.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// The lists of styles, one after the other.
struct StyleLists {
    explicit StyleLists(base::Memory& memory) noexcept
        : layers(memory), lines(memory), lights(memory), palette(memory) {}

    void clear() noexcept {
        layers.clear();
        lines.clear();
        lights.clear();
        palette.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return layers.bytes() + lines.bytes() + lights.bytes() + palette.bytes();
    }

    base::Array<frame::LayerStyle> layers;
    base::Array<frame::LineStyle> lines;
    base::Array<frame::LightStyle> lights;
    base::Array<glm::vec4> palette;
};

// Checks every field; `owner` names the struct in messages, such as "items[2].style".  Appends the style's lists. The
// returned style has empty spans, because the lists may still move.
[[nodiscard]] frame::Style checked_style(const hrbfnpr_style& style, const char* owner, StyleLists& lists);

} // namespace hrbfnpr::api
