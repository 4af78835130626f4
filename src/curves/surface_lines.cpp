// SPDX-License-Identifier: MIT
#include "curves/surface_lines.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// As CurvePoint::direction() wants it: gradient x level_gradient is the tangent.
void set_tangent(CurvePoint& p, const glm::dvec3& tangent, bool as_given) noexcept {
    glm::dvec3 n = glm::normalize(p.gradient);
    const double square = glm::dot(tangent, tangent);
    if (const glm::dvec3 across = n - glm::dot(n, tangent) / square * tangent; as_given && glm::length(across) > 1e-3)
        n = glm::normalize(across);
    const glm::dvec3 along = tangent - glm::dot(tangent, n) * n;
    const double length = glm::length(along);
    p.gradient = n;
    p.level_gradient = length > 0.0 ? glm::cross(along / length, n) : glm::cross(tangent, n);
}

// Whether the outside of the surface is seen.
bool shows_outside(const CurvePoint& p, const View& view) noexcept {
    return glm::dot(p.gradient, view.sight(p.position)) < 0.0;
}

class FacingParts {
    static constexpr double at_point = 1e-6; // of a piece

public:
    FacingParts(const SurfaceLines& lines, const View& view, bool outside, SurfaceLines& parts)
        : lines_(lines), view_(view), outside_(outside), builder_(parts) {}

    void add_curve(std::int64_t curve) {
        const Curves& curves = lines_.curves;
        const std::int64_t first = curves.first[curve];
        const std::int64_t count = curves.size_of(curve);
        std::int64_t begin = 0; // of a closed curve a point that is not wanted, if there is one
        const bool closed = curves.closed[curve] != 0;
        while (closed && begin < count && wanted(first + begin)) ++begin;
        if (begin == count) {
            for (std::int64_t i = 0; i < count; ++i) put(first + i);
            return builder_.end(true);
        }
        for (std::int64_t i = 0; i < count + (closed ? 1 : 0); ++i) {
            const std::int64_t at = first + (begin + i) % count;
            const std::int64_t before = first + (begin + i - 1 + count) % count;
            const bool has_before = i > 0;
            if (wanted(at)) {
                if (has_before && !wanted(before)) put_between(before, at);
                put(at);
            } else if (has_before && wanted(before)) {
                put_between(before, at);
                builder_.end(false);
            }
        }
        builder_.end(false);
    }

private:
    [[nodiscard]] bool wanted(std::int64_t point) const noexcept {
        return shows_outside(lines_.curves.point[point], view_) == outside_;
    }
    void put(std::int64_t at) {
        const CurvePoint& p = lines_.curves.point[at];
        builder_.add(p.position, p.gradient, static_cast<double>(lines_.strength[at]), p.direction());
    }
    // Where n . v vanishes, by its values at both points.
    void put_between(std::int64_t a, std::int64_t b) {
        const CurvePoint& p = lines_.curves.point[a];
        const CurvePoint& q = lines_.curves.point[b];
        const double from = glm::dot(p.gradient, view_.sight(p.position));
        const double to = glm::dot(q.gradient, view_.sight(q.position));
        const double u = std::clamp(from / (from - to), 0.0, 1.0);
        // A point that stands there already is the end.
        if ((u < at_point && wanted(a)) || (u > 1.0 - at_point && wanted(b))) return;
        const auto strength =
            static_cast<double>(lines_.strength[a]) * (1.0 - u) + static_cast<double>(lines_.strength[b]) * u;
        const CubicPiece piece(p, q);
        builder_.add(piece.at(u), (1.0 - u) * p.gradient + u * q.gradient, strength, piece.derivative(u));
    }

    const SurfaceLines& lines_;
    const View& view_;
    bool outside_;
    LineBuilder builder_;
};

} // namespace

LineBuilder::LineBuilder(SurfaceLines& lines, bool as_given) : lines_(lines), as_given_(as_given) {
    if (lines_.curves.first.empty()) lines_.curves.first.push_back(0);
}

void LineBuilder::add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
                      const glm::dvec3& tangent) {
    Curves& curves = lines_.curves;
    const std::int64_t first = curves.first[curves.first.size() - 1];
    if (curves.point.size() > first && curves.point[curves.point.size() - 1].position == position) return;
    CurvePoint p;
    p.position = position;
    p.gradient = normal;
    if (tangent != glm::dvec3(0.0)) set_tangent(p, tangent, as_given_);
    curves.point.push_back(p);
    lines_.strength.push_back(static_cast<float>(strength));
}

void LineBuilder::end(bool closed) {
    Curves& curves = lines_.curves;
    const std::int64_t first = curves.first[curves.first.size() - 1];
    const std::int64_t count = curves.point.size() - first;
    if (count < (closed ? 3 : 2)) {
        curves.point.resize(first);
        lines_.strength.resize(first);
        return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
        if (curves.point[first + i].level_gradient != glm::dvec3(0.0)) continue;
        const std::int64_t before = closed ? (i + count - 1) % count : std::max<std::int64_t>(0, i - 1);
        const std::int64_t after = closed ? (i + 1) % count : std::min(count - 1, i + 1);
        const glm::dvec3 in = curves.point[first + i].position - curves.point[first + before].position;
        const glm::dvec3 out = curves.point[first + after].position - curves.point[first + i].position;
        // By the circle through three points: the nearer one counts more.
        const double a = glm::dot(in, in);
        const double b = glm::dot(out, out);
        set_tangent(curves.point[first + i], a > 0.0 && b > 0.0 ? in / a + out / b : in + out, as_given_);
    }
    curves.first.push_back(curves.point.size());
    curves.closed.push_back(closed ? 1 : 0);
}

SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view, bool outside) {
    SurfaceLines parts(memory);
    FacingParts facing(lines, view, outside, parts);
    for (std::int64_t c = 0; c < lines.curves.count(); ++c) facing.add_curve(c);
    return parts;
}

} // namespace hrbfnpr::curves
