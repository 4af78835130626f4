// SPDX-License-Identifier: MIT
// The segments of strokes, which go from one point of a stroke to the next: where one is and how it ends.
#pragma once

#include "base/assert.h"
#include "drawing/drawing.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::drawing {

// The stroke of a segment, whose number is that of its first point. No stroke before `from` has it.
[[nodiscard]] inline const Stroke* stroke_of(const Drawing& drawing, std::int64_t segment,
                                             const Stroke* from) noexcept {
    const Stroke* const next = std::upper_bound(from, drawing.strokes.end(), segment,
                                                [](std::int64_t at, const Stroke& s) { return at < s.first; });
    HRBFNPR_ASSERT(next > drawing.strokes.begin());
    return next - 1;
}

// The ends of a segment are round where another one follows.
struct SegmentEnds {
    Cap begin = Cap::round, end = Cap::round;
};
[[nodiscard]] inline SegmentEnds ends_of(const Stroke& stroke, std::int64_t segment) noexcept {
    if (stroke.closed) return {};
    return {segment == stroke.first ? stroke.cap_begin : Cap::round,
            segment + 2 == stroke.first + stroke.count ? stroke.cap_end : Cap::round};
}

// A segment may reach this far around the line between its points.
[[nodiscard]] inline float reach(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b) noexcept {
    const bool pointed = ends.begin == Cap::pointed || ends.end == Cap::pointed;
    const float widest = std::max({a.radius, b.radius, smallest_radius});
    return widest * (pointed ? std::max(1.0F, 2.0F * point_length) : 1.0F) + soft_rim;
}

// A disc around all that a segment covers.
struct Footprint {
    float x, y, radius;
};
[[nodiscard]] inline Footprint footprint(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b) noexcept {
    return {0.5F * (a.x + b.x), 0.5F * (a.y + b.y),
            0.5F * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) + reach(ends, a, b)};
}

// Whether a segment covers a place, and then its share of the way along it. Thin ones count as a pixel wide.
[[nodiscard]] inline bool covers(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b, float x, float y,
                                 float& at) noexcept {
    const float ux = b.x - a.x;
    const float uy = b.y - a.y;
    const float length = std::hypot(ux, uy);
    const float along = length > 0.0F ? ((x - a.x) * ux + (y - a.y) * uy) / length : 0.0F;
    at = length > 0.0F ? std::clamp(along / length, 0.0F, 1.0F) : 0.0F;
    const float radius = std::max(a.radius + (b.radius - a.radius) * at, smallest_radius);
    const float beyond = std::max(-along, along - length);
    const float dx = x - a.x - at * ux;
    const float dy = y - a.y - at * uy;
    const float square = dx * dx + dy * dy;
    const Cap cap = along < 0.0F ? ends.begin : ends.end;
    if (!(beyond > 0.0F) || cap == Cap::round) return square <= radius * radius;
    const float left = cap == Cap::pointed ? radius - beyond / (2.0F * point_length) : -1.0F; // half the tip's width
    return left > 0.0F && square - beyond * beyond <= left * left;
}

// Puts the segments of a drawing's strokes into tiles like the tiles of its dots, and some that only lie near.
void bin_segments(const base::Parallel& parallel, Drawing& drawing);

} // namespace hrbfnpr::drawing
