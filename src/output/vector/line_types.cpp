// SPDX-License-Identifier: MIT
#include "output/vector/line_types.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

// Strokes and gaps by turns, in line widths; 0: no more.
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
// A line with more of them is drawn whole: they are too small to be told apart, and writing them would never end.
constexpr double most_periods = 1e5;
static_assert(patterns.size() == static_cast<std::size_t>(LineType::last) + 1);

double length_of(const PagePath& path) noexcept {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        sum += std::hypot(path.points[i].x - path.points[i - 1].x, path.points[i].y - path.points[i - 1].y);
    return sum;
}

double width_of(const PagePath& path, const PageGroup& group) noexcept {
    if (group.pen_width > 0.0) return group.pen_width;
    double most = 0.0;
    for (const PagePoint& p : path.points) most = std::max(most, p.radius);
    return 2.0 * most;
}

} // namespace

void LineTypes::begin_group(const PageGroup& group) {
    group_ = group;
    next_.begin_group(group);
}

void LineTypes::path(const PagePath& path) {
    const Pattern& pattern = patterns[std::min(static_cast<std::size_t>(group_.line_type), patterns.size() - 1)];
    const double width = width_of(path, group_);
    const double length = length_of(path);
    double period = 0.0;
    for (const double part : pattern) period += width * part;
    const double first = width * pattern[0];
    if (!(first > 0.0) || length <= first || !(length <= most_periods * period)) {
        next_.path(path);
        return;
    }
    // So that a whole number of periods, and a dash behind an open line's last one, fit.
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
        double rest = std::hypot(b.x - a.x, b.y - a.y);
        while (rest > left) {
            const double t = left / rest;
            a = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.radius + t * (b.radius - a.radius)};
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

} // namespace hrbfnpr::output
