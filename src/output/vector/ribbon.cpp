// SPDX-License-Identifier: MIT
#include "output/vector/ribbon.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

constexpr double sharp_cosine = 0.866; // of 30 degrees
// Of a segment's length, that is left of it at the inner side of a turn.
constexpr double left_inside = 0.1;
constexpr double quarter = 0.5522847498307936; // handle of a Bezier curve for a quarter of a unit circle

dvec2 place(const PagePoint& p) noexcept { return {p.x, p.y}; }
dvec2 along(const PagePoint& a, const PagePoint& b) noexcept { return glm::normalize(place(b) - place(a)); }
dvec2 left_of(const dvec2& direction) noexcept { return {direction.y, -direction.x}; }

} // namespace

Ribbon::Ribbon(base::Memory& memory) noexcept
    : fit_(memory), points_(memory), cuts_(memory), sides_(memory), line_(memory) {}

// Those that are apart: the widest of those that are not.
void Ribbon::find_points(const PagePath& path) {
    constexpr double nowhere = 1e-6;
    points_.clear();
    for (const PagePoint& p : path.points) {
        if (!points_.empty()) {
            PagePoint& last = points_[points_.size() - 1];
            if (std::hypot(p.x - last.x, p.y - last.y) <= nowhere) {
                last.radius = std::max(last.radius, p.radius);
                continue;
            }
        }
        points_.push_back(p);
    }
}

bool Ribbon::turns_sharply(const PagePoint& a, const PagePoint& b, const PagePoint& c) const noexcept {
    const dvec2 before = along(a, b), after = along(b, c);
    const double cosine = glm::dot(before, after);
    if (cosine < sharp_cosine) return true;
    const double sine = std::abs(before.x * after.y - before.y * after.x);
    const double reach = b.radius * sine / (1.0 + cosine); // how much shorter the inner side is
    const double shorter = std::min(glm::distance(place(a), place(b)), glm::distance(place(b), place(c)));
    return 2.0 * reach > (1.0 - left_inside) * shorter;
}

void Ribbon::find_cuts(bool closed) {
    const std::int64_t last = points_.size() - 1;
    cuts_.clear();
    for (std::int64_t i = closed ? 0 : 1; i < last; ++i)
        if (turns_sharply(points_[i > 0 ? i - 1 : last - 1], points_[i], points_[i + 1])) cuts_.push_back(i);
}

void Ribbon::outline(const PagePath& path, double tolerance, OutlineSink& sink) {
    find_points(path);
    const std::int64_t count = points_.size();
    if (count < 2) {
        if (count == 1 && (path.closed || path.begin == Cap::round || path.end == Cap::round)) {
            const dvec2 out(1.0, 0.0);
            sink.move_to(place(points_[0]) - points_[0].radius * left_of(out));
            add_cap(points_[0], -out, Cap::round, sink);
            add_cap(points_[0], out, Cap::round, sink);
            sink.close();
        }
        return;
    }
    const bool closed = path.closed && count > 3;
    find_cuts(closed);
    if (closed && cuts_.empty()) {
        add_ring(tolerance, sink);
        return;
    }
    std::int64_t first = 0;
    if (closed) { // begin at the first cut
        const std::int64_t cut = cuts_[0];
        points_.resize(count - 1);
        std::rotate(points_.begin(), points_.begin() + cut, points_.end());
        points_.push_back(points_[0]);
        for (std::int64_t& one : cuts_) one -= cut;
    }
    for (std::int64_t k = closed ? 1 : 0; k <= cuts_.size(); ++k) {
        const bool is_last = k == cuts_.size();
        const std::int64_t last = is_last ? count - 1 : cuts_[k];
        const Cap begin = first == 0 && !closed ? path.begin : Cap::round;
        add_piece(first, last, begin, is_last && !closed ? path.end : Cap::round, tolerance, sink);
        first = last;
    }
}

// Where consecutive segments meet, on the line that halves their angle.
void Ribbon::find_sides(std::int64_t first, std::int64_t last, bool ring) {
    sides_.clear();
    for (std::int64_t i = first; i <= last; ++i) {
        const PagePoint& p = points_[i];
        const bool at_begin = i == first, at_end = i == last;
        const dvec2 after = at_end ? (ring ? along(points_[first], points_[first + 1]) : along(points_[i - 1], p))
                                   : along(p, points_[i + 1]);
        const dvec2 before =
            at_begin ? (ring ? along(points_[last - 1], points_[last]) : after) : along(points_[i - 1], p);
        const dvec2 across = (p.radius / (1.0 + glm::dot(before, after))) * (left_of(before) + left_of(after));
        sides_.push_back({place(p) + across, place(p) - across});
    }
}

// One side, from its beginning, or the right one from its end.  The pen stands where it begins.
void Ribbon::add_side(bool left, bool closed, double tolerance, OutlineSink& sink) {
    line_.clear();
    const std::int64_t count = sides_.size();
    for (std::int64_t i = 0; i < count; ++i) line_.push_back(left ? sides_[i].left : sides_[count - 1 - i].right);
    const std::span<const Cubic> cubics = fit_.fit(line_.span(), tolerance, closed);
    if (closed && !cubics.empty()) sink.move_to(cubics.back().end);
    for (const Cubic& cubic : cubics) sink.curve_to(cubic);
}

void Ribbon::add_ring(double tolerance, OutlineSink& sink) {
    find_sides(0, points_.size() - 1, true);
    for (const bool left : {true, false}) {
        add_side(left, true, tolerance, sink);
        sink.close();
    }
}

void Ribbon::add_piece(std::int64_t first, std::int64_t last, Cap begin, Cap end, double tolerance, OutlineSink& sink) {
    find_sides(first, last, false);
    sink.move_to(sides_[0].left);
    add_side(true, false, tolerance, sink);
    add_cap(points_[last], along(points_[last - 1], points_[last]), end, sink);
    sink.line_to(sides_[sides_.size() - 1].right);
    add_side(false, false, tolerance, sink);
    add_cap(points_[first], -along(points_[first], points_[first + 1]), begin, sink);
    sink.close();
}

// From the corner on the left of the direction `out` to that on its right.
void Ribbon::add_cap(const PagePoint& p, const dvec2& out, Cap cap, OutlineSink& sink) const {
    const dvec2 centre = place(p), from = left_of(out);
    const double r = p.radius;
    if (cap == Cap::pointed) sink.line_to(centre + 2.0 * static_cast<double>(drawing::point_length) * r * out);
    if (cap != Cap::round) return;
    sink.curve_to({centre + r * (from + quarter * out), centre + r * (out + quarter * from), centre + r * out});
    sink.curve_to({centre + r * (out - quarter * from), centre + r * (-from + quarter * out), centre - r * from});
}

} // namespace hrbfnpr::output
