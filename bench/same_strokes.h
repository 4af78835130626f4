// SPDX-License-Identifier: MIT
// The share of one picture's strokes that another picture has at the same places.
#pragma once

#include "stroke_gaps.h"

#include <functional>

namespace bench {

struct SharedLength {
    double length = 0.0; // pixels of the first picture
    double shared = 0.0; // those that are also drawn in the second picture

    [[nodiscard]] double share() const { return length > 0.0 ? shared / length : 1.0; }
};

[[nodiscard]] inline double distance_to(const StrokePoint& a, const StrokePoint& b, double x, double y) {
    const double ex = static_cast<double>(b.x - a.x);
    const double ey = static_cast<double>(b.y - a.y);
    const double px = x - static_cast<double>(a.x);
    const double py = y - static_cast<double>(a.y);
    const double squared = ex * ex + ey * ey;
    const double at = squared > 0.0 ? std::clamp((px * ex + py * ey) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(px - at * ex, py - at * ey);
}

// Measures how much of the strokes of `one` is within `reach` of the same line in `other`, whose coordinates are
// multiplied by `scale`. Parts with a radius below `seen` pixels are left out.  line(id): the line of a mark.
[[nodiscard]] inline SharedLength shared_length(const std::vector<DrawnStroke>& one,
                                                const std::vector<DrawnStroke>& other, double scale, double reach,
                                                const std::function<std::uint32_t(std::uint32_t)>& line,
                                                float seen = 0.0F) {
    constexpr double step = 1.0; // pixels
    std::vector<DrawnStroke> scaled = other;
    for (DrawnStroke& stroke : scaled)
        for (StrokePoint& p : stroke) p.x *= static_cast<float>(scale), p.y *= static_cast<float>(scale);
    const StrokeSegments segments(scaled);
    SharedLength result;
    for (const DrawnStroke& stroke : one)
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
            const StrokePoint& a = stroke[i];
            const StrokePoint& b = stroke[i + 1];
            const double length = distance_of(a, b);
            const int parts = std::max(1, static_cast<int>(length / step));
            for (int k = 0; k < parts; ++k) {
                const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(parts);
                const auto x = static_cast<double>(a.x + t * (b.x - a.x));
                const auto y = static_cast<double>(a.y + t * (b.y - a.y));
                if (a.radius + t * (b.radius - a.radius) < seen) continue;
                bool found = false;
                segments.in_box(x - reach, y - reach, x + reach, y + reach, [&](const auto& s) {
                    found = found || (line(segments.begin(s).id) == line(a.id) &&
                                      distance_to(segments.begin(s), segments.end(s), x, y) <= reach);
                });
                result.length += length / parts;
                if (found) result.shared += length / parts;
            }
        }
    return result;
}

} // namespace bench
