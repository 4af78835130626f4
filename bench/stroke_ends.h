// SPDX-License-Identifier: MIT
// How often the strokes of a picture end, and how many of them are short.
#pragma once

#include "drawn_stroke.h"

#include <algorithm>

namespace bench {

struct StrokeEnds {
    double length = 0.0; // pixels, of all strokes
    double ends = 0.0;   // ends not at the picture's border; a closed stroke has none
    double shorts = 0.0; // strokes shorter than eight times their own greatest width

    [[nodiscard]] double ends_per_1000() const { return 1000.0 * ends / length; }
    [[nodiscard]] double shorts_per_1000() const { return 1000.0 * shorts / length; }
};

inline constexpr double short_widths = 8.0;

[[nodiscard]] inline bool is_inside(const StrokePoint& p, double width, double height) {
    constexpr float margin = 2.0F;
    return p.x > margin && p.y > margin && p.x < static_cast<float>(width) - margin &&
           p.y < static_cast<float>(height) - margin;
}

inline void add_ends(StrokeEnds& all, const DrawnStroke& stroke, double width, double height) {
    if (stroke.empty() ||
        std::none_of(stroke.begin(), stroke.end(), [&](const StrokePoint& p) { return is_inside(p, width, height); }))
        return;
    const StrokePoint& first = stroke.front();
    const StrokePoint& last = stroke.back();
    const bool closed = stroke.size() > 2 && first.x == last.x && first.y == last.y;
    double widest = 0.0;
    for (const StrokePoint& p : stroke) widest = std::max(widest, 2.0 * static_cast<double>(p.radius));
    const double length = length_of(stroke);
    all.length += length;
    if (closed) return;
    all.ends += (is_inside(first, width, height) ? 1.0 : 0.0) + (is_inside(last, width, height) ? 1.0 : 0.0);
    if (length < short_widths * widest) all.shorts += 1.0;
}

} // namespace bench
