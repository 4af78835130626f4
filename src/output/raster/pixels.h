// SPDX-License-Identifier: MIT
// The caller's pixels, to and from premultiplied floats.
#pragma once

#include "geometry/vec.h"
#include "output/raster/settings.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace hrbfnpr::output {

[[nodiscard]] constexpr bool is_premultiplied(Format format) noexcept {
    return format == Format::rgba8_premultiplied || format == Format::bgra8_premultiplied ||
           format == Format::rgba32f_premultiplied;
}
[[nodiscard]] constexpr bool is_bgra(Format format) noexcept {
    return format == Format::bgra8 || format == Format::bgra8_premultiplied;
}
[[nodiscard]] constexpr bool has_bytes(Format format) noexcept { return bytes_of_pixel(format) == 4; }

[[nodiscard]] inline std::byte to_byte(float value) noexcept {
    return static_cast<std::byte>(static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F));
}
[[nodiscard]] inline float from_byte(std::byte value) noexcept {
    constexpr float scale = 1.0F / 255.0F;
    return static_cast<float>(std::to_integer<std::uint8_t>(value)) * scale;
}

// Of coverage8 the colour is black, and its alpha the coverage.
[[nodiscard]] inline glm::vec4 load_pixel(const std::byte* at, Format format) noexcept {
    if (format == Format::coverage8) return {0.0F, 0.0F, 0.0F, from_byte(*at)};
    glm::vec4 color;
    if (has_bytes(format)) {
        for (int i = 0; i < 4; ++i) color[i] = from_byte(at[i]);
    } else {
        std::memcpy(&color[0], at, sizeof(float) * 4);
    }
    if (is_bgra(format)) std::swap(color.x, color.z);
    if (is_premultiplied(format)) return color;
    return {glm::vec3(color) * color.w, color.w};
}

inline void store_pixel(std::byte* at, const glm::vec4& premultiplied, Format format) noexcept {
    if (format == Format::coverage8) {
        *at = to_byte(premultiplied.w);
        return;
    }
    glm::vec4 color = premultiplied;
    // Nothing has no colour: straight pixels of alpha 0 are all zero.
    if (!is_premultiplied(format))
        color = color.w > 0.0F ? glm::vec4(glm::vec3(color) / color.w, color.w) : glm::vec4(0.0F);
    if (is_bgra(format)) std::swap(color.x, color.z);
    if (has_bytes(format)) {
        for (int i = 0; i < 4; ++i) at[i] = to_byte(color[i]);
        return;
    }
    color = glm::clamp(color, 0.0F, 1.0F);
    std::memcpy(at, &color[0], sizeof(float) * 4);
}

} // namespace hrbfnpr::output
