// SPDX-License-Identifier: MIT
#include "output/vector/clip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::output {

// [Liang and Barsky 1984, "A new concept and method for line clipping"]
bool Clip::within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from, double& to) noexcept {
    if (!std::isfinite(a.x + a.y + b.x + b.y)) return false;
    const double dx = b.x - a.x, dy = b.y - a.y;
    // Per side: how fast the segment leaves through it, and how far from it it begins.
    const std::array<double, 4> speed{-dx, dx, -dy, dy};
    const std::array<double, 4> room{a.x - frame.left, frame.right - a.x, a.y - frame.top, frame.bottom - a.y};
    for (std::size_t side = 0; side < 4; ++side) {
        if (speed[side] == 0.0 && room[side] < 0.0) return false;
        if (speed[side] < 0.0) from = std::max(from, room[side] / speed[side]);
        if (speed[side] > 0.0) to = std::min(to, room[side] / speed[side]);
    }
    return from < to;
}

std::span<const PagePoint> Clip::turned(const PagePath& path, const Frame& frame) {
    const std::size_t count = path.points.size() - 1; // without the repeated one
    std::size_t first = 0;
    while (first < count && frame.contains(path.points[first].x, path.points[first].y)) ++first;
    ring_.clear();
    for (std::size_t i = 0; i <= count; ++i) ring_.push_back(path.points[(first + i) % count]);
    return ring_.span();
}

} // namespace hrbfnpr::output
