// SPDX-License-Identifier: MIT
#include "curves/surface_lines.h"

#include "curves/chains.h"
#include "curves/curves.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr int turn_steps = 60;
constexpr double known_turn = 1e-10;   // in pieces: a turn is found once its bracket is this short
constexpr double at_line_point = 1e-6; // in pieces: a part that would end this near to a point ends at the point

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

// n . v, negative where the outside of the surface is seen.
double facing(const glm::dvec3& gradient, const glm::dvec3& place, const View& view) noexcept {
    return glm::dot(gradient, view.sight(place)) / glm::length(gradient);
}

} // namespace

void LineBuilder::add(const glm::dvec3& position, const glm::dvec3& normal, double strength,
                      const glm::dvec3& tangent) {
    Curves& curves = lines_.curves;
    if (curves.point.size() > curves.first.back() && curves.point.back().position == position) return;
    CurvePoint p;
    p.position = position;
    p.gradient = normal;
    if (tangent != glm::dvec3(0.0)) set_tangent(p, tangent, as_given_);
    curves.point.push_back(p);
    lines_.strength.push_back(static_cast<float>(strength));
}

void LineBuilder::add(const SurfaceLines& from, std::int64_t point) {
    HRBFNPR_ASSERT(point >= 0 && point < from.strength.size());
    const CurvePoint& p = from.curves.point[point];
    add(p.position, p.gradient, static_cast<double>(from.strength[point]), p.direction());
}

void LineBuilder::end(bool closed) {
    Curves& curves = lines_.curves;
    HRBFNPR_ASSERT(lines_.strength.size() == curves.point.size());
    const std::int64_t first = curves.first.back();
    const std::int64_t count = curves.point.size() - first;
    if (count < (closed ? 3 : 2)) {
        curves.point.resize(first);
        lines_.strength.resize(first);
        return;
    }
    for (std::int64_t i = 0; i < count; ++i) {
        CurvePoint& p = curves.point[first + i];
        if (p.level_gradient != glm::dvec3(0.0)) continue;
        const std::int64_t before = closed ? (i + count - 1) % count : std::max<std::int64_t>(0, i - 1);
        const std::int64_t after = closed ? (i + 1) % count : std::min(count - 1, i + 1);
        set_tangent(p,
                    tangent_between(p.position - curves.point[first + before].position,
                                    curves.point[first + after].position - p.position),
                    as_given_);
    }
    curves.end(closed);
}

SurfaceLines parts_where(const SurfaceLines& lines, const base::Array<double>& value, bool below, bool as_given) {
    const Curves& curves = lines.curves;
    HRBFNPR_ASSERT(value.size() == curves.point.size());
    SurfaceLines parts(value.memory());
    LineBuilder builder(parts, as_given);
    const auto wanted = [&](std::int64_t i) { return (value[i] < 0.0) == below; };
    // Where the value vanishes between a point that is wanted and one that is not.
    const auto put_between = [&](std::int64_t a, std::int64_t b) {
        const CurvePoint& p = curves.point[a];
        const CurvePoint& q = curves.point[b];
        const double u = std::clamp(value[a] / (value[a] - value[b]), 0.0, 1.0);
        // A point that stands there already is the end.
        if ((u < at_line_point && wanted(a)) || (u > 1.0 - at_line_point && wanted(b))) return;
        const auto strength =
            static_cast<double>(lines.strength[a]) * (1.0 - u) + static_cast<double>(lines.strength[b]) * u;
        const CubicPiece piece(p, q);
        builder.add(piece.at(u), (1.0 - u) * p.gradient + u * q.gradient, strength, piece.derivative(u));
    };
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t count = curves.size_of(c);
        const bool closed = curves.closed[c] != 0;
        const auto at = [&](std::int64_t i) { return curves.first[c] + (i + count) % count; };
        for_parts(
            count, closed, [&](std::int64_t i) { return wanted(at(i)); },
            [&](std::int64_t begin, std::int64_t end, bool whole) {
                if (!whole && (closed || begin > 0)) put_between(at(begin - 1), at(begin));
                for (std::int64_t i = begin; i < end; ++i) builder.add(lines, at(i));
                if (!whole && (closed || end < count)) put_between(at(end - 1), at(end));
                builder.end(whole);
            });
    }
    return parts;
}

SurfaceLines facing_parts(base::Memory& memory, const SurfaceLines& lines, const View& view, bool outside) {
    base::Array<double> value(memory);
    for (const CurvePoint& p : lines.curves.point) value.push_back(glm::dot(p.gradient, view.sight(p.position)));
    return parts_where(lines, value, outside, false);
}

SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines, const implicit::Implicit& surface,
                        const View& view) {
    const Curves& curves = lines.curves;
    struct Turn {
        std::int64_t a, b; // the points of a piece at whose ends n . v has different signs
        Illinois root;
        double share;
        glm::dvec3 gradient;
    };
    base::Array<Turn> turns(runtime.memory);
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t a = curves.first[c] + k;
            const std::int64_t b = curves.next(c, a);
            const double from = facing(curves.point[a].gradient, curves.point[a].position, view);
            const double to = facing(curves.point[b].gradient, curves.point[b].position, view);
            if ((from < 0.0) != (to < 0.0)) turns.push_back({a, b, Illinois(from, to), 0.5, glm::dvec3(0.0)});
        }
    geometry::VecArray place(runtime.memory, turns.size());
    geometry::VecArray gradient(runtime.memory, turns.size());
    bool left = !turns.empty();
    for (int step = 0; step < turn_steps && left; ++step) {
        for (std::int64_t i = 0; i < turns.size(); ++i) {
            turns[i].share = turns[i].root.trial;
            place.set(i, CubicPiece(curves.point[turns[i].a], curves.point[turns[i].b]).at(turns[i].share));
        }
        implicit::evaluate_all(runtime, surface, place,
                               {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}},
                               base::Progress());
        left = false;
        for (std::int64_t i = 0; i < turns.size(); ++i) {
            turns[i].gradient = gradient[i];
            if (!turns[i].root.done(known_turn)) turns[i].root.take(facing(gradient[i], place[i], view));
            left = left || !turns[i].root.done(known_turn);
        }
    }
    SurfaceLines finer(runtime.memory);
    LineBuilder builder(finer);
    std::int64_t next = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            builder.add(lines, i);
            if (next >= turns.size() || turns[next].a != i) continue;
            const Turn& turn = turns[next++];
            const CubicPiece piece(curves.point[i], curves.point[turn.b]);
            builder.add(piece.at(turn.share), turn.gradient, static_cast<double>(lines.strength[i]),
                        piece.derivative(turn.share));
        }
        builder.end(curves.closed[c] != 0);
    }
    HRBFNPR_ASSERT(next == turns.size());
    return finer;
}

} // namespace hrbfnpr::curves
