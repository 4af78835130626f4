// SPDX-License-Identifier: MIT
#include "output/vector/pen.h"

#include "output/vector/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::output {

using glm::dvec2;

void add_spiral(const PageDot& dot, double pen_width, double tolerance, base::Array<dvec2>& points) {
    constexpr double turn = 2.0 * std::numbers::pi;
    HRBFNPR_ASSERT(tolerance > 0.0);
    points.push_back({dot.x, dot.y});
    const double outer = dot.radius - 0.5 * pen_width;
    if (!(outer > 0.0)) return;
    const double chord = std::clamp(std::sqrt(8.0 * tolerance / outer), 0.1, 0.8); // its angle
    // The growth of the radius for each radian is bounded, as a pen may be as thin as a double can tell.
    const double pitch = std::max(plot_tuning.spiral_pitch * pen_width, outer / plot_tuning.most_turns) / turn;
    const auto add = [&](double angle, double radius) {
        points.push_back({dot.x + radius * std::cos(angle), dot.y + radius * std::sin(angle)});
    };
    double angle = 0.0;
    for (; pitch * angle < outer; angle += chord) add(angle, pitch * angle);
    for (double rest = 0.0; rest < turn + chord; rest += chord) add(angle + rest, outer); // and once round
}

std::span<const dvec2> PenLines::line(const PagePath& path, double tolerance) {
    places_.clear();
    for (const PagePoint& p : path.points) places_.push_back(place_of(p));
    geometry::thin(std::span<const dvec2>(places_.span()), tolerance, keeps_);
    line_.clear();
    for (std::int64_t i = 0; i < places_.size(); ++i)
        if (keeps_[i] != 0) line_.push_back(places_[i]);
    return line_.span();
}

std::span<const dvec2> PenLines::line(const PageDot& dot, double pen, const ShapeSettings& settings,
                                      const dvec2& from) {
    line_.clear();
    const dvec2 centre(dot.x, dot.y);
    const double radius = dot.radius - 0.5 * pen;
    const DotShapes shape = settings.dots_of(pen);
    if (shape == DotShapes::spirals) {
        add_spiral(dot, pen, settings.tolerance, line_);
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
    HRBFNPR_ASSERT(!line.empty());
    travel(line[0]);
    for (const dvec2& place : line) draw(place);
}

} // namespace hrbfnpr::output
