// SPDX-License-Identifier: MIT
// Strokes of a drawing as points, in pixels.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

struct StrokePoint {
    float x, y, depth; // pixels
    float radius;      // half the stroke's width at the point, pixels
    std::uint32_t id;  // 1 + the number of the nearest mark, counted over all layers in order
};
using DrawnStroke = std::vector<StrokePoint>;

[[nodiscard]] inline double distance_of(const StrokePoint& a, const StrokePoint& b) {
    return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}
[[nodiscard]] inline double length_of(const DrawnStroke& stroke) {
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.size(); ++i) length += distance_of(stroke[i - 1], stroke[i]);
    return length;
}

} // namespace bench
