// SPDX-License-Identifier: MIT
#include "output/vector/pen_lines.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

double square_from(const PagePoint& p, const PagePoint& a, const PagePoint& b) noexcept {
    return geometry::square_from_segment(dvec2(p.x, p.y), dvec2(a.x, a.y), dvec2(b.x, b.y));
}

// Points of a line that is split by itself: the work is as the square of their number where all are kept.
constexpr std::int64_t split_at = 1024;

} // namespace

// [Douglas and Peucker 1973, "Algorithms for the reduction of the number of points required to represent a digitized
// line or its caricature"]
std::span<const dvec2> PenLines::line(const PagePath& path, double tolerance) {
    const auto count = static_cast<std::int64_t>(path.points.size());
    const PagePoint* const points = path.points.data();
    keeps_.clear();
    keeps_.resize(count);
    waits_.clear();
    for (std::int64_t first = 0; first < count - 1; first += split_at)
        waits_.push_back({first, std::min(first + split_at, count - 1)});
    keeps_[0] = 1;
    for (const Range& range : waits_) keeps_[range.last] = 1;
    while (!waits_.empty()) {
        const Range range = waits_.back();
        waits_.resize(waits_.size() - 1);
        double most = tolerance * tolerance;
        std::int64_t farthest = -1;
        for (std::int64_t i = range.first + 1; i < range.last; ++i)
            if (const double square = square_from(points[i], points[range.first], points[range.last]); square > most) {
                most = square;
                farthest = i;
            }
        if (farthest < 0) continue;
        keeps_[farthest] = 1;
        waits_.push_back({range.first, farthest});
        waits_.push_back({farthest, range.last});
    }
    line_.clear();
    for (std::int64_t i = 0; i < count; ++i)
        if (keeps_[i] != 0) line_.push_back({points[i].x, points[i].y});
    return line_.span();
}

std::span<const dvec2> PenLines::line(const PageDot& dot, double pen, const ShapeSettings& settings,
                                      const dvec2& from) {
    line_.clear();
    const dvec2 centre(dot.x, dot.y);
    const double radius = dot.radius - 0.5 * pen;
    const DotShapes shape = settings.dots_of(pen);
    if (shape == DotShapes::spirals) {
        spiral(dot, pen, settings.tolerance, line_);
    } else if (shape == DotShapes::lines || !(radius > 0.0)) {
        line_.push_back(centre);
    } else {
        // A chord stays within the tolerance of its arc.
        const double half = std::acos(std::clamp(1.0 - settings.tolerance / radius, 0.0, 1.0));
        const double sides = std::max(8.0, std::ceil(std::numbers::pi / half));
        const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
        for (double side = 0.0; side <= sides; side += 1.0) {
            const double angle = begin + 2.0 * std::numbers::pi * side / sides;
            line_.push_back(centre + radius * dvec2(std::cos(angle), std::sin(angle)));
        }
    }
    return line_.span();
}

void PenTrack::travel(const dvec2& to) noexcept {
    const double way = glm::distance(place_, to);
    if (way == 0.0) return;
    counts_.travelled += way;
    counts_.seconds += way / speeds_.travel;
    place_ = to;
    is_down_ = false;
}

void PenTrack::draw(const dvec2& to) noexcept {
    const double way = glm::distance(place_, to);
    if (!is_down_) counts_.seconds += 2.0 * speeds_.seconds;
    is_down_ = true;
    counts_.drawn += way;
    counts_.seconds += way / speeds_.draw;
    place_ = to;
}

void PenTrack::draw(std::span<const dvec2> line) noexcept {
    travel(line[0]);
    for (const dvec2& place : line) draw(place);
}

} // namespace hrbfnpr::output
