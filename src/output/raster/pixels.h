// The caller's pixels: four bytes to and from premultiplied floats.
#pragma once

#include "geometry/vec.h"
#include "output/raster/draw.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hrbfnpr::output {

[[nodiscard]] constexpr bool is_premultiplied(Format format) noexcept {
    return format == Format::rgba8_premultiplied || format == Format::bgra8_premultiplied;
}
[[nodiscard]] constexpr bool is_bgra(Format format) noexcept {
    return format == Format::bgra8 || format == Format::bgra8_premultiplied;
}

[[nodiscard]] inline std::byte to_byte(float value) noexcept {
    return static_cast<std::byte>(static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F));
}

[[nodiscard]] inline glm::vec4 load_pixel(const std::byte* at, Format format) noexcept {
    constexpr float scale = 1.0F / 255.0F;
    glm::vec4 color;
    for (int i = 0; i < 4; ++i) color[i] = static_cast<float>(std::to_integer<std::uint8_t>(at[i])) * scale;
    if (is_bgra(format)) std::swap(color.x, color.z);
    if (is_premultiplied(format)) return color;
    return {glm::vec3(color) * color.w, color.w};
}

inline void store_pixel(std::byte* at, const glm::vec4& premultiplied, Format format) noexcept {
    glm::vec4 color = premultiplied;
    // Nothing has no colour: straight pixels of alpha 0 are all zero.
    if (!is_premultiplied(format))
        color = color.w > 0.0F ? glm::vec4(glm::vec3(color) / color.w, color.w) : glm::vec4(0.0F);
    if (is_bgra(format)) std::swap(color.x, color.z);
    for (int i = 0; i < 4; ++i) at[i] = to_byte(color[i]);
}

} // namespace hrbfnpr::output
