// SPDX-License-Identifier: MIT
#include "output/vector/line_types.h"

#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

// Dashes and gaps by turns, in line widths; the first 0 ends the pattern.
using Pattern = std::array<double, 10>;
constexpr double dot = 0.5, gap = 3.0, space = 18.0, short_dash = 6.0, dash = 12.0, long_dash = 24.0;
constexpr std::array<Pattern, 16> patterns{{
    {},
    {},
    {dash, gap},
    {dash, space},
    {long_dash, gap, dot, gap},
    {long_dash, gap, dot, gap, dot, gap},
    {long_dash, gap, dot, gap, dot, gap, dot, gap},
    {dot, gap},
    {long_dash, gap, short_dash, gap},
    {long_dash, gap, short_dash, gap, short_dash, gap},
    {dash, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap},
    {dash, gap, dot, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap, dot, gap},
    {dash, gap, dot, gap, dot, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap, dot, gap, dot, gap},
}};
static_assert(patterns.size() == static_cast<std::size_t>(LineType::last) + 1);
// A line with more periods is drawn whole: they are too small to be told apart, and writing them would never end.
constexpr double most_periods = 1e5;

} // namespace

void LineTypes::path(const PagePath& path) {
    HRBFNPR_ASSERT(path.points.size() > 1);
    const Pattern& pattern = patterns[std::min(static_cast<std::size_t>(group_.line_type), patterns.size() - 1)];
    double width = group_.pen_width;
    if (!(width > 0.0)) {
        width = 0.0;
        for (const PagePoint& p : path.points) width = std::max(width, 2.0 * p.radius);
    }
    const double length = length_of(path.points);
    double period = 0.0;
    for (const double part : pattern) period += width * part;
    const double first = width * pattern[0];
    if (!(first > 0.0) || length <= first || !(length <= most_periods * period)) {
        next_.path(path);
        return;
    }
    // The pattern is scaled so that a whole number of periods fit, and a dash after the last one of an open line.
    const double open = path.closed ? 0.0 : first;
    const double times = std::max(std::floor((length - open) / period + 0.5), 1.0);
    const double scale = length / (times * period + open);
    PagePath piece = path;
    piece.closed = false;
    piece.begin = piece.end = drawing::Cap::flat;
    std::size_t at = 0; // in the pattern
    double left = scale * first;
    part_.clear();
    part_.push_back(path.points[0]);
    const auto emit = [&] {
        piece.points = part_.span();
        if (at % 2 == 0 && part_.size() > 1) next_.path(piece);
    };
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        PagePoint a = path.points[i - 1];
        const PagePoint& b = path.points[i];
        double rest = glm::distance(place_of(a), place_of(b));
        while (rest > left) {
            a = between(a, b, left / rest);
            rest -= left;
            part_.push_back(a);
            emit();
            part_.clear();
            part_.push_back(a);
            at = at + 1 < pattern.size() && pattern[at + 1] > 0.0 ? at + 1 : 0;
            left = scale * width * pattern[at];
        }
        left -= rest;
        part_.push_back(b);
    }
    if (left < scale * width * pattern[at] * (1.0 - 1e-9)) emit();
}

// [Liang and Barsky 1984, "A new concept and method for line clipping"]
bool Clip::within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from, double& to) noexcept {
    if (!std::isfinite(a.x + a.y + b.x + b.y)) return false;
    const double dx = b.x - a.x, dy = b.y - a.y;
    // For each side: how fast the segment leaves through it, and how far from it the segment begins.
    const std::array<double, 4> speed{-dx, dx, -dy, dy};
    const std::array<double, 4> room{a.x - frame.left, frame.right - a.x, a.y - frame.top, frame.bottom - a.y};
    for (std::size_t side = 0; side < 4; ++side) {
        if (speed[side] == 0.0 && room[side] < 0.0) return false;
        if (speed[side] < 0.0) from = std::max(from, room[side] / speed[side]);
        if (speed[side] > 0.0) to = std::min(to, room[side] / speed[side]);
    }
    return from < to;
}

} // namespace hrbfnpr::output
