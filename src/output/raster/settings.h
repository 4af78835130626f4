// SPDX-License-Identifier: MIT
// What is drawn into, and how.
#pragma once

#include "base/view.h"

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_FORMAT_...
enum class Format : std::uint32_t {
    rgba8 = 1,
    bgra8 = 2,
    rgba8_premultiplied = 3,
    bgra8_premultiplied = 4,
    rgba32f = 5,
    rgba32f_premultiplied = 6,
    coverage8 = 7
};

[[nodiscard]] constexpr std::int64_t bytes_of_pixel(Format format) noexcept {
    if (format == Format::coverage8) return 1;
    return format == Format::rgba32f || format == Format::rgba32f_premultiplied ? 16 : 4;
}

struct Image {
    Format format = Format::rgba8;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::byte* pixels = nullptr; // top-left
    std::int64_t row_stride = 0; // bytes, never 0

    [[nodiscard]] std::byte* pixel(std::int32_t x, std::int32_t y) const noexcept {
        return pixels + y * row_stride + bytes_of_pixel(format) * x;
    }
};

// Views of width * height elements, or empty.
struct DrawSettings {
    bool over = false;
    bool linear_light = false;
    base::InView host_depth;
    base::OutView depth;
    base::OutView id;
    base::OutView mark_class;
};

} // namespace hrbfnpr::output
