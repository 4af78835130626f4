// SPDX-License-Identifier: MIT
// Converts lines and dots to the shapes of file formats. For SVG and PDF a line becomes a filled outline, or one or
// more lines of constant width, made of Bezier curves and arcs (curves.h). For a plotter it becomes straight lines
// within the tolerance, and the time of the pen is counted.
#pragma once

#include "output/vector/curves.h"
#include "output/vector/page.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::output {

// Receives shapes; curves are added between begin and end. Filled shapes are closed; they may overlap, and the nonzero
// rule fills them. Joins of lines are round.
class ShapeSink {
public:
    ShapeSink() = default;
    ShapeSink(const ShapeSink&) = delete;
    ShapeSink& operator=(const ShapeSink&) = delete;
    virtual ~ShapeSink() = default;
    virtual void begin_fill(double opacity) = 0;
    // `cap` is for both ends, round or flat.
    virtual void begin_line(double width, drawing::Cap cap, double opacity) = 0;
    virtual void move_to(const glm::dvec2& p) = 0;
    virtual void line_to(const glm::dvec2& p) = 0;
    virtual void curve_to(const geometry::Cubic& cubic) = 0;
    virtual void arc_to(const CurvePiece& arc) = 0;
    virtual void close() = 0;
    virtual void end_shape() = 0;
};

inline bool is_even(const PagePath& path) noexcept {
    if (!path.closed &&
        (path.begin == drawing::Cap::pointed || path.end == drawing::Cap::pointed || path.begin != path.end))
        return false;
    const auto [least, most] =
        std::minmax_element(path.points.begin(), path.points.end(),
                            [](const PagePoint& a, const PagePoint& b) { return a.radius < b.radius; });
    return most->radius - least->radius <= shape_tuning.even_width * most->radius;
}

inline constexpr double unit_radius = 0.1; // the radius of class 0, mm

inline double radius_of_class(double number, double step) noexcept { return unit_radius * std::pow(step, number); }

inline int class_of(double radius, double step) noexcept {
    const double number = std::log(std::max(radius, shape_tuning.least_radius) / unit_radius) / std::log(step);
    return static_cast<int>(std::floor(number + 0.5));
}

// The length of the Bezier handles for a quarter of the unit circle.
inline constexpr double quarter = 0.5522847498307936;

inline glm::dvec2 along(const PagePoint& a, const PagePoint& b) noexcept {
    return glm::normalize(place_of(b) - place_of(a));
}
inline glm::dvec2 left_of(const glm::dvec2& direction) noexcept { return {direction.y, -direction.x}; }

inline bool turns_sharply(const PagePoint& a, const PagePoint& b, const PagePoint& c) noexcept {
    const glm::dvec2 before = along(a, b), after = along(b, c);
    const double cosine = glm::dot(before, after);
    if (cosine < shape_tuning.sharp_cosine) return true;
    const double sine = std::abs(before.x * after.y - before.y * after.x);
    const double reach = b.radius * sine / (1.0 + cosine); // the turn shortens the inner side by this length
    const double shorter = std::min(glm::distance(place_of(a), place_of(b)), glm::distance(place_of(b), place_of(c)));
    return 2.0 * reach > (1.0 - shape_tuning.least_inner_share) * shorter;
}

// Adds the cap at an end of a line, from the corner on the left of the direction `out` to the corner on its right.
inline void add_cap(const PagePoint& p, const glm::dvec2& out, drawing::Cap cap, ShapeSink& sink) {
    const glm::dvec2 centre = place_of(p), from = left_of(out);
    const double r = p.radius;
    if (cap == drawing::Cap::pointed) sink.line_to(centre + 2.0 * static_cast<double>(drawing::point_length) * r * out);
    if (cap != drawing::Cap::round) return;
    sink.curve_to({centre + r * (from + quarter * out), centre + r * (out + quarter * from), centre + r * out});
    sink.curve_to({centre + r * (out - quarter * from), centre + r * (quarter * out - from), centre - r * from});
}

// Adds the points of a spiral from the centre outward. A pen of width `pen_width` that follows the spiral fills the
// disc.
inline void add_spiral(const PageDot& dot, double pen_width, double tolerance, base::Array<glm::dvec2>& points) {
    constexpr double turn = 2.0 * std::numbers::pi;
    HRBFNPR_ASSERT(tolerance > 0.0);
    points.push_back({dot.x, dot.y});
    const double outer = dot.radius - 0.5 * pen_width;
    if (!(outer > 0.0)) return;
    const double chord = std::clamp(std::sqrt(8.0 * tolerance / outer), 0.1, 0.8); // the angle of a chord, in radians
    // The radius grows by at least this length per radian. The lower bound is needed because the pen's width may be
    // arbitrarily small.
    const double pitch = std::max(plot_tuning.spiral_pitch * pen_width, outer / plot_tuning.most_turns) / turn;
    const auto add = [&](double angle, double radius) {
        points.push_back({dot.x + radius * std::cos(angle), dot.y + radius * std::sin(angle)});
    };
    double angle = 0.0;
    for (; pitch * angle < outer; angle += chord) add(angle, pitch * angle);
    // The spiral ends with one full turn along the rim.
    for (double rest = 0.0; rest < turn + chord; rest += chord) add(angle + rest, outer);
}

// ---- Lines of SVG and PDF

// Turns lines and dots into shapes. The object holds working memory.
class Shapes {
public:
    Shapes(base::Memory& memory, const ShapeSettings& settings) noexcept
        : settings_(settings), fit_(memory), curves_(memory), line_(memory), part_(memory), sides_(memory) {}

    void shape(const PagePath& path, const PageGroup& group, ShapeSink& sink) {
        HRBFNPR_ASSERT(!path.points.empty());
        if (group.pen_width > 0.0) {
            const bool flat = path.begin == drawing::Cap::flat && path.end == drawing::Cap::flat;
            add_line(path.points, group.pen_width, flat ? drawing::Cap::flat : drawing::Cap::round, path, sink);
        } else if (is_even(path)) {
            add_line(path.points, mean_width(path.points), path.closed ? drawing::Cap::round : path.begin, path, sink);
        } else if (settings_.widths == Widths::classes) {
            add_classes(path, sink);
        } else {
            sink.begin_fill(path.opacity);
            outline(path, sink);
            sink.end_shape();
        }
    }
    // Draws the dot as a line of zero length with round ends, or as a spiral. For circles, writers do not call this.
    void shape(const PageDot& dot, const PageGroup& group, ShapeSink& sink) {
        const double pen = group.pen_width > 0.0 ? group.pen_width : 2.0 * dot.radius;
        line_.clear();
        if (settings_.dots_of(group.pen_width) == DotShapes::spirals) add_spiral(dot, pen, settings_.tolerance, line_);
        sink.begin_line(pen, drawing::Cap::round, dot.opacity);
        if (line_.size() < 2) {
            sink.move_to({dot.x, dot.y});
            sink.line_to({dot.x, dot.y});
        } else {
            add_curve(curves_.fit(line_.span(), settings_.tolerance, false, settings_.curves), sink);
        }
        sink.end_shape();
    }
    // Draws the line as a filled outline whose sides are curves within the tolerance. Where the line turns by more than
    // 30 degrees, or more sharply than its width allows, it is cut in two parts with round ends that overlap.
    void outline(const PagePath& path, ShapeSink& sink) {
        part_.clear(); // points that coincide are merged, and the widest is kept
        for (const PagePoint& p : path.points) {
            if (!part_.empty() && std::hypot(p.x - part_.back().x, p.y - part_.back().y) <= plot_tuning.same_point)
                part_.back().radius = std::max(part_.back().radius, p.radius);
            else
                part_.push_back(p);
        }
        const std::int64_t last = part_.size() - 1;
        if (last < 1) {
            if (last == 0 && (path.closed || path.begin == drawing::Cap::round || path.end == drawing::Cap::round)) {
                const glm::dvec2 out(1.0, 0.0);
                sink.move_to(place_of(part_[0]) - part_[0].radius * left_of(out));
                add_cap(part_[0], -out, drawing::Cap::round, sink);
                add_cap(part_[0], out, drawing::Cap::round, sink);
                sink.close();
            }
            return;
        }
        const bool closed = path.closed && last > 2;
        const auto is_cut = [&](std::int64_t i) {
            return turns_sharply(part_[i > 0 ? i - 1 : last - 1], part_[i], part_[i + 1]);
        };
        if (closed) { // start the line at its first cut
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
                      first == 0 && !closed ? path.begin : drawing::Cap::round,
                      i == last && !closed ? path.end : drawing::Cap::round, sink);
            first = i;
        }
    }

private:
    struct Side {
        glm::dvec2 left, right;
    };

    void add_line(std::span<const PagePoint> points, double width, drawing::Cap cap, const PagePath& path,
                  ShapeSink& sink) {
        line_.clear();
        for (const PagePoint& p : points) line_.push_back(place_of(p));
        const CurveLine line = curves_.fit(line_.span(), settings_.tolerance, path.closed, settings_.curves);
        if (line.pieces.empty() && cap == drawing::Cap::flat) return; // a point with flat ends is invisible
        sink.begin_line(width, cap, path.opacity);
        add_curve(line, sink);
        if (line.pieces.empty()) sink.line_to(line.start);
        if (path.closed && !line.pieces.empty()) sink.close();
        sink.end_shape();
    }
    static void add_curve(const CurveLine& line, ShapeSink& sink) {
        sink.move_to(line.start);
        for (const CurvePiece& piece : line.pieces) switch (piece.kind) {
            case CurvePiece::Kind::line: sink.line_to(piece.end); break;
            case CurvePiece::Kind::arc: sink.arc_to(piece); break;
            case CurvePiece::Kind::cubic: sink.curve_to({piece.control_1, piece.control_2, piece.end}); break;
            }
    }
    // Cuts the line into parts, and draws each part in the width of its class. Parts meet where the width is midway
    // between two classes.
    void add_classes(const PagePath& path, ShapeSink& sink) {
        const double width_step = settings_.width_step;
        PagePath part = path;
        part.closed = false;
        const auto emit = [&](int number) {
            if (part_.size() > 1)
                add_line(part_.span(), 2.0 * radius_of_class(number, width_step), drawing::Cap::round, part, sink);
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
    // Computes the corners of both sides. Consecutive segments meet on the bisector of their angle.
    void find_sides(std::span<const PagePoint> points, bool ring) {
        HRBFNPR_ASSERT(points.size() > 1);
        sides_.clear();
        const std::size_t last = points.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const PagePoint& p = points[i];
            const glm::dvec2 after = i < last ? along(p, points[i + 1])
                                     : ring   ? along(points[0], points[1])
                                              : along(points[i - 1], p);
            const glm::dvec2 before = i > 0  ? along(points[i - 1], p)
                                      : ring ? along(points[last - 1], points[last])
                                             : after;
            const glm::dvec2 across = (p.radius / (1.0 + glm::dot(before, after))) * (left_of(before) + left_of(after));
            sides_.push_back({place_of(p) + across, place_of(p) - across});
        }
    }
    // Adds the left side in forward order, or the right side in reverse. The current point of the sink must be the
    // start of the side.
    void add_side(bool left, bool closed, ShapeSink& sink) {
        line_.clear();
        const std::int64_t count = sides_.size();
        for (std::int64_t i = 0; i < count; ++i) line_.push_back(left ? sides_[i].left : sides_[count - 1 - i].right);
        const std::span<const geometry::Cubic> cubics = fit_.fit(line_.span(), settings_.tolerance, closed);
        if (closed && !cubics.empty()) sink.move_to(cubics.back().end);
        for (const geometry::Cubic& cubic : cubics) sink.curve_to(cubic);
    }
    void add_piece(std::span<const PagePoint> points, drawing::Cap begin, drawing::Cap end, ShapeSink& sink) {
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

    ShapeSettings settings_;
    geometry::CurveFit fit_; // fits the sides of outlines
    CurvePieces curves_;     // fits lines
    base::Array<glm::dvec2> line_;
    base::Array<PagePoint> part_;
    base::Array<Side> sides_;
};

// ---- The path of a pen

// Computes the lines that a pen draws. The object holds working memory, and a result is valid until the next call.
class PenLines {
public:
    explicit PenLines(base::Memory& memory) noexcept : places_(memory), line_(memory), keeps_(memory) {}

    // Returns the points of the path.
    std::span<const glm::dvec2> places(const PagePath& path) {
        places_.clear();
        for (const PagePoint& p : path.points) places_.push_back(place_of(p));
        return places_.span();
    }
    // Returns as few points of the path as suffice for a polyline within the tolerance of the path.
    std::span<const glm::dvec2> line(const PagePath& path, double tolerance) {
        places(path);
        geometry::simplify_polyline(std::span<const glm::dvec2>(places_.span()), tolerance, keeps_);
        line_.clear();
        for (std::int64_t i = 0; i < places_.size(); ++i)
            if (keeps_[i] != 0) line_.push_back(places_[i]);
        return line_.span();
    }
    // Returns a circle just inside the dot's rim that starts near `from`, a spiral, or one point if the dot is no wider
    // than the pen.
    std::span<const glm::dvec2> line(const PageDot& dot, double pen, const ShapeSettings& settings,
                                     const glm::dvec2& from) {
        line_.clear();
        const glm::dvec2 centre(dot.x, dot.y);
        const double radius = dot.radius - 0.5 * pen;
        const DotShapes shape = settings.dots_of(pen);
        if (shape == DotShapes::spirals) {
            add_spiral(dot, pen, settings.tolerance, line_);
        } else if (shape == DotShapes::lines || !(radius > 0.0)) {
            line_.push_back(centre);
        } else {
            // The length of a chord is limited so that it stays within the tolerance of its arc.
            const double half = std::acos(std::clamp(1.0 - settings.tolerance / radius, 0.0, 1.0));
            const double sides = std::max(8.0, std::ceil(std::numbers::pi / half));
            const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
            for (double side = 0.0; side < sides; side += 1.0) {
                const double angle = begin + 2.0 * std::numbers::pi * side / sides;
                line_.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
            }
            line_.push_back(line_[0]);
        }
        return line_.span();
    }

private:
    base::Array<glm::dvec2> places_, line_;
    base::Array<std::uint8_t> keeps_;
};

// Adds up the distances and the time of a pen. The pen starts raised at `from`. It is raised after it drew `longest` mm
// at most; 0 means no limit.
class PenTrack {
public:
    PenTrack(PageCounts& counts, const PenSpeeds& speeds, const glm::dvec2& from, double longest = 0.0) noexcept
        : counts_(counts), speeds_(speeds), place_(from), longest_(longest) {}

    [[nodiscard]] const glm::dvec2& place() const noexcept { return place_; }
    // Moves the raised pen. Does nothing if the pen is there already.
    void travel(const glm::dvec2& to) noexcept {
        const double way = glm::distance(place_, to);
        if (way == 0.0) return;
        counts_.travelled += way;
        counts_.seconds += way / speeds_.travel;
        place_ = to;
        is_down_ = false;
    }
    void raise() noexcept { is_down_ = false; }
    // Returns whether the pen must be raised before it draws a line of this length, even if it is at its start.
    [[nodiscard]] bool is_too_long(double line) const noexcept {
        return longest_ > 0.0 && is_down_ && since_lowered_ + line > longest_;
    }
    // Lowers the pen if it is raised, and moves it along a line, or a curve of the length `way`. If the distance is 0,
    // the pen is lowered all the same.
    void draw(const glm::dvec2& to) noexcept { draw(to, glm::distance(place_, to)); }
    void draw(const glm::dvec2& to, double way) noexcept {
        if (!is_down_) {
            counts_.seconds += 2.0 * speeds_.seconds;
            since_lowered_ = 0.0;
        }
        is_down_ = true;
        since_lowered_ += way;
        counts_.drawn += way;
        counts_.seconds += way / speeds_.draw;
        place_ = to;
    }
    void draw(std::span<const glm::dvec2> line) noexcept {
        HRBFNPR_ASSERT(!line.empty());
        if (is_too_long(geometry::length_along(line, [](const glm::dvec2& p) { return p; }))) raise();
        travel(line[0]);
        for (const glm::dvec2& place : line) draw(place);
    }

private:
    PageCounts& counts_;
    PenSpeeds speeds_;
    glm::dvec2 place_;
    double longest_, since_lowered_ = 0.0;
    bool is_down_ = false;
};

} // namespace hrbfnpr::output
