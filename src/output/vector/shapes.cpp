// SPDX-License-Identifier: MIT
#include "output/vector/shapes.h"

#include "output/vector/pen.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using geometry::Cubic;
using glm::dvec2;

bool is_even(const PagePath& path) noexcept {
    if (!path.closed && (path.begin == Cap::pointed || path.end == Cap::pointed || path.begin != path.end))
        return false;
    const auto [least, most] =
        std::minmax_element(path.points.begin(), path.points.end(),
                            [](const PagePoint& a, const PagePoint& b) { return a.radius < b.radius; });
    return most->radius - least->radius <= shape_tuning.even * most->radius;
}

// ---- Classes of widths

constexpr double unit_radius = 0.1; // the radius of class 0, mm

double radius_of_class(double number, double step) noexcept { return unit_radius * std::pow(step, number); }

int class_of(double radius, double step) noexcept {
    const double number = std::log(std::max(radius, shape_tuning.least_radius) / unit_radius) / std::log(step);
    return static_cast<int>(std::floor(number + 0.5));
}

// ---- Outlines

constexpr double quarter = 0.5522847498307936; // handle of a Bezier curve for a quarter of a unit circle

dvec2 along(const PagePoint& a, const PagePoint& b) noexcept { return glm::normalize(place_of(b) - place_of(a)); }
dvec2 left_of(const dvec2& direction) noexcept { return {direction.y, -direction.x}; }

bool turns_sharply(const PagePoint& a, const PagePoint& b, const PagePoint& c) noexcept {
    const dvec2 before = along(a, b), after = along(b, c);
    const double cosine = glm::dot(before, after);
    if (cosine < shape_tuning.sharp_cosine) return true;
    const double sine = std::abs(before.x * after.y - before.y * after.x);
    const double reach = b.radius * sine / (1.0 + cosine); // the inner side is this much shorter
    const double shorter = std::min(glm::distance(place_of(a), place_of(b)), glm::distance(place_of(b), place_of(c)));
    return 2.0 * reach > (1.0 - shape_tuning.left_inside) * shorter;
}

// From the corner on the left of the direction `out` to the one on its right.
void add_cap(const PagePoint& p, const dvec2& out, Cap cap, ShapeSink& sink) {
    const dvec2 centre = place_of(p), from = left_of(out);
    const double r = p.radius;
    if (cap == Cap::pointed) sink.line_to(centre + 2.0 * static_cast<double>(drawing::point_length) * r * out);
    if (cap != Cap::round) return;
    sink.curve_to({centre + r * (from + quarter * out), centre + r * (out + quarter * from), centre + r * out});
    sink.curve_to({centre + r * (out - quarter * from), centre + r * (quarter * out - from), centre - r * from});
}

} // namespace

void Shapes::shape(const PagePath& path, const PageGroup& group, ShapeSink& sink) {
    HRBFNPR_ASSERT(!path.points.empty());
    if (group.pen_width > 0.0) {
        const bool flat = path.begin == Cap::flat && path.end == Cap::flat;
        add_line(path.points, group.pen_width, flat ? Cap::flat : Cap::round, path, sink);
    } else if (is_even(path)) {
        add_line(path.points, mean_width(path.points), path.closed ? Cap::round : path.begin, path, sink);
    } else if (settings_.widths == Widths::classes) {
        add_classes(path, sink);
    } else {
        sink.begin_fill(path.opacity);
        outline(path, sink);
        sink.end_shape();
    }
}

void Shapes::shape(const PageDot& dot, const PageGroup& group, ShapeSink& sink) {
    const double pen = group.pen_width > 0.0 ? group.pen_width : 2.0 * dot.radius;
    line_.clear();
    if (settings_.dots_of(group.pen_width) == DotShapes::spirals) add_spiral(dot, pen, settings_.tolerance, line_);
    sink.begin_line(pen, Cap::round, dot.opacity);
    if (line_.size() < 2) {
        sink.move_to({dot.x, dot.y});
        sink.line_to({dot.x, dot.y});
    } else {
        sink.move_to(line_[0]);
        for (const Cubic& cubic : fit_.fit(line_.span(), settings_.tolerance, false)) sink.curve_to(cubic);
    }
    sink.end_shape();
}

void Shapes::add_line(std::span<const PagePoint> points, double width, Cap cap, const PagePath& path, ShapeSink& sink) {
    line_.clear();
    for (const PagePoint& p : points) line_.push_back(place_of(p));
    const std::span<const Cubic> cubics = fit_.fit(line_.span(), settings_.tolerance, path.closed);
    if (cubics.empty() && cap == Cap::flat) return; // nothing is seen of it
    sink.begin_line(width, cap, path.opacity);
    sink.move_to(path.closed && !cubics.empty() ? cubics.back().end : line_[0]);
    for (const Cubic& cubic : cubics) sink.curve_to(cubic);
    if (cubics.empty()) sink.line_to(line_[0]);
    if (path.closed && !cubics.empty()) sink.close();
    sink.end_shape();
}

// Each part has the width of its class; where it ends the line's width is midway between two classes.
void Shapes::add_classes(const PagePath& path, ShapeSink& sink) {
    const double width_step = settings_.width_step;
    PagePath part = path;
    part.closed = false;
    const auto emit = [&](int number) {
        if (part_.size() > 1) add_line(part_.span(), 2.0 * radius_of_class(number, width_step), Cap::round, part, sink);
    };
    part_.clear();
    part_.push_back(path.points[0]);
    int current = class_of(path.points[0].radius, width_step);
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PagePoint& a = path.points[i - 1];
        const PagePoint& b = path.points[i];
        for (const int wanted = class_of(b.radius, width_step); current != wanted;) {
            const int step = wanted > current ? 1 : -1;
            const double border = radius_of_class(current + 0.5 * step, width_step);
            PagePoint cut = between(a, b, std::clamp((border - a.radius) / (b.radius - a.radius), 0.0, 1.0));
            cut.radius = border;
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

void Shapes::outline(const PagePath& path, ShapeSink& sink) {
    part_.clear(); // the points that are apart; of those that are not it has the widest
    for (const PagePoint& p : path.points) {
        if (!part_.empty() && std::hypot(p.x - part_.back().x, p.y - part_.back().y) <= plot_tuning.nowhere)
            part_.back().radius = std::max(part_.back().radius, p.radius);
        else
            part_.push_back(p);
    }
    const std::int64_t last = part_.size() - 1;
    if (last < 1) {
        if (last == 0 && (path.closed || path.begin == Cap::round || path.end == Cap::round)) {
            const dvec2 out(1.0, 0.0);
            sink.move_to(place_of(part_[0]) - part_[0].radius * left_of(out));
            add_cap(part_[0], -out, Cap::round, sink);
            add_cap(part_[0], out, Cap::round, sink);
            sink.close();
        }
        return;
    }
    const bool closed = path.closed && last > 2;
    const auto is_cut = [&](std::int64_t i) {
        return turns_sharply(part_[i > 0 ? i - 1 : last - 1], part_[i], part_[i + 1]);
    };
    if (closed) { // it begins at its first cut
        std::int64_t cut = 0;
        while (cut < last && !is_cut(cut)) ++cut;
        if (cut == last) {
            find_sides(part_.span(), true);
            for (const bool left : {true, false}) {
                add_side(left, true, sink);
                sink.close();
            }
            return;
        }
        part_.resize(last);
        std::rotate(part_.begin(), part_.begin() + cut, part_.end());
        part_.push_back(part_[0]);
    }
    std::int64_t first = 0;
    for (std::int64_t i = 1; i <= last; ++i) {
        if (i < last && !is_cut(i)) continue;
        add_piece(part_.span().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(i - first + 1)),
                  first == 0 && !closed ? path.begin : Cap::round, i == last && !closed ? path.end : Cap::round, sink);
        first = i;
    }
}

// Consecutive segments meet on the line that halves their angle.
void Shapes::find_sides(std::span<const PagePoint> points, bool ring) {
    HRBFNPR_ASSERT(points.size() > 1);
    sides_.clear();
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const PagePoint& p = points[i];
        const dvec2 after = i < last ? along(p, points[i + 1])
                            : ring   ? along(points[0], points[1])
                                     : along(points[i - 1], p);
        const dvec2 before = i > 0 ? along(points[i - 1], p) : ring ? along(points[last - 1], points[last]) : after;
        const dvec2 across = (p.radius / (1.0 + glm::dot(before, after))) * (left_of(before) + left_of(after));
        sides_.push_back({place_of(p) + across, place_of(p) - across});
    }
}

// Adds the left side from its beginning, or the right one from its end. The pen stands where it begins.
void Shapes::add_side(bool left, bool closed, ShapeSink& sink) {
    line_.clear();
    const std::int64_t count = sides_.size();
    for (std::int64_t i = 0; i < count; ++i) line_.push_back(left ? sides_[i].left : sides_[count - 1 - i].right);
    const std::span<const Cubic> cubics = fit_.fit(line_.span(), settings_.tolerance, closed);
    if (closed && !cubics.empty()) sink.move_to(cubics.back().end);
    for (const Cubic& cubic : cubics) sink.curve_to(cubic);
}

void Shapes::add_piece(std::span<const PagePoint> points, Cap begin, Cap end, ShapeSink& sink) {
    find_sides(points, false);
    const PagePoint &first = points.front(), &last = points.back();
    sink.move_to(sides_[0].left);
    add_side(true, false, sink);
    add_cap(last, along(points[points.size() - 2], last), end, sink);
    sink.line_to(sides_.back().right);
    add_side(false, false, sink);
    add_cap(first, -along(first, points[1]), begin, sink);
    sink.close();
}

} // namespace hrbfnpr::output
