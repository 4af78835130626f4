// SPDX-License-Identifier: MIT
// The scenes that tests, benchmarks and documentation share: samples, marks, camera and style.
#pragma once

#include "support/handles.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scenes {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; // straight alpha, packed rows from the top
};

// A scene that is ready to draw.
struct Scene {
    Model model;
    PointSet marks;
    LineSet lines; // NULL if the style draws no lines
    hrbfnpr_style style{};
    hrbfnpr_camera camera{};
};

[[nodiscard]] std::span<const std::string_view> names();
// Throws std::runtime_error for a name that is not in names(), or with the library's message.
[[nodiscard]] Scene make(hrbfnpr_context* context, std::string_view name, int width, int height);
[[nodiscard]] Picture draw(hrbfnpr_context* context, const Scene& scene);

} // namespace scenes
