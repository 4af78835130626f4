// SPDX-License-Identifier: MIT
#include "output/vector/shapes.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;

// Of the greatest width: less cannot be seen.
constexpr double even = 0.02;
// mm; of the class number 0
constexpr double unit_radius = 0.1;
constexpr double least_radius = 0.005;
constexpr double most_turns = 1000.0; // of a spiral

bool is_even(const PagePath& path) noexcept {
    if (!path.closed && (path.begin == Cap::pointed || path.end == Cap::pointed || path.begin != path.end))
        return false;
    double least = path.points[0].radius, most = least;
    for (const PagePoint& p : path.points) {
        least = std::min(least, p.radius);
        most = std::max(most, p.radius);
    }
    return most - least <= even * most;
}

double mean_width(const PagePath& path) noexcept {
    double sum = 0.0;
    for (const PagePoint& p : path.points) sum += p.radius;
    return 2.0 * sum / static_cast<double>(path.points.size());
}

} // namespace

void spiral(const PageDot& dot, double pen_width, double tolerance, base::Array<glm::dvec2>& points) {
    constexpr double turn = 6.283185307179586;
    points.clear();
    points.push_back({dot.x, dot.y});
    const double outer = dot.radius - 0.5 * pen_width;
    if (!(outer > 0.0)) return;
    const double chord = std::clamp(std::sqrt(8.0 * tolerance / outer), 0.1, 0.8); // its angle
    // Of the radius, per radian; bounded, as a pen may be as thin as a double tells.
    const double pitch = std::max(0.9 * pen_width, outer / most_turns) / turn;
    const auto add = [&](double angle, double radius) {
        points.push_back({dot.x + radius * std::cos(angle), dot.y + radius * std::sin(angle)});
    };
    double angle = 0.0;
    for (; pitch * angle < outer; angle += chord) add(angle, pitch * angle);
    for (double rest = 0.0; rest < turn + chord; rest += chord) add(angle + rest, outer); // and once round
}

Shapes::Shapes(base::Memory& memory, const ShapeSettings& settings) noexcept
    : settings_(settings), fit_(memory), ribbon_(memory), line_(memory), part_(memory) {}

void Shapes::shape(const PagePath& path, const PageGroup& group, ShapeSink& sink) {
    if (group.pen_width > 0.0) {
        const bool flat = path.begin == Cap::flat && path.end == Cap::flat;
        add_line(path.points, group.pen_width, flat ? Cap::flat : Cap::round, path, sink);
    } else if (is_even(path)) {
        add_line(path.points, mean_width(path), path.closed ? Cap::round : path.begin, path, sink);
    } else if (settings_.widths == Widths::classes) {
        add_classes(path, sink);
    } else {
        sink.begin_fill(path.opacity);
        ribbon_.outline(path, settings_.tolerance, sink);
        sink.end_shape();
    }
}

void Shapes::shape(const PageDot& dot, const PageGroup& group, ShapeSink& sink) {
    const double pen = group.pen_width > 0.0 ? group.pen_width : 2.0 * dot.radius;
    line_.clear();
    if (settings_.dots_of(group.pen_width) == DotShapes::spirals) spiral(dot, pen, settings_.tolerance, line_);
    if (line_.size() < 2) {
        sink.begin_line(pen, Cap::round, dot.opacity);
        sink.move_to({dot.x, dot.y});
        sink.line_to({dot.x, dot.y});
    } else {
        sink.begin_line(pen, Cap::round, dot.opacity);
        sink.move_to(line_[0]);
        for (const Cubic& cubic : fit_.fit(line_.span(), settings_.tolerance, false)) sink.curve_to(cubic);
    }
    sink.end_shape();
}

void Shapes::add_line(std::span<const PagePoint> points, double width, Cap cap, const PagePath& path, ShapeSink& sink) {
    line_.clear();
    for (const PagePoint& p : points) line_.push_back({p.x, p.y});
    const std::span<const Cubic> cubics = fit_.fit(line_.span(), settings_.tolerance, path.closed);
    if (cubics.empty() && cap == Cap::flat) return; // nothing of it is there
    sink.begin_line(width, cap, path.opacity);
    sink.move_to(path.closed && !cubics.empty() ? cubics.back().end : line_[0]);
    for (const Cubic& cubic : cubics) sink.curve_to(cubic);
    if (cubics.empty()) sink.line_to(line_[0]);
    if (path.closed && !cubics.empty()) sink.close();
    sink.end_shape();
}

int Shapes::class_of(double radius) const noexcept {
    const double number = std::log(std::max(radius, least_radius) / unit_radius) / std::log(settings_.width_step);
    return static_cast<int>(std::floor(number + 0.5));
}

double Shapes::radius_of(double number) const noexcept { return unit_radius * std::pow(settings_.width_step, number); }

// Parts, each of the width of its class; where one ends, the width lies midway between two classes.
void Shapes::add_classes(const PagePath& path, ShapeSink& sink) {
    const auto emit = [&](int number) {
        PagePath part = path;
        part.closed = false;
        if (part_.size() > 1) add_line(part_.span(), 2.0 * radius_of(number), Cap::round, part, sink);
    };
    part_.clear();
    part_.push_back(path.points[0]);
    int current = class_of(path.points[0].radius);
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PagePoint& a = path.points[i - 1];
        const PagePoint& b = path.points[i];
        for (const int wanted = class_of(b.radius); current != wanted;) {
            const int step = wanted > current ? 1 : -1;
            const double border = radius_of(current + 0.5 * step);
            const double t = std::clamp((border - a.radius) / (b.radius - a.radius), 0.0, 1.0);
            const PagePoint cut{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), border};
            part_.push_back(cut);
            emit(current);
            current += step;
            part_.clear();
            part_.push_back(cut);
        }
        part_.push_back(b);
    }
    emit(current);
}

} // namespace hrbfnpr::output
