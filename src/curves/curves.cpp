// SPDX-License-Identifier: MIT
#include "curves/curves.h"

#include "curves/tuning.h"
#include "implicit/evaluate_all.h"

#include <array>
#include <numeric>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// The largest distance between a cubic and its chord, in lengths of the chord. The cubic turns by less than a right
// angle.
constexpr double piece_bulge = 0.25;
// The number of points in a task. It is several SIMD vectors long. It is so small that a few hundred points give enough
// tasks for two threads.
constexpr std::int64_t points_a_task = 32;

// Evaluates points[order[i]] for all i < count as one batch.
void evaluate_some(const Level& level, CurvePoint* points, const std::int32_t* order, std::int64_t count) {
    using Column = std::array<double, static_cast<std::size_t>(points_a_task)>;
    HRBFNPR_ASSERT(count <= points_a_task);
    std::array<Column, 3> place;
    std::array<Column, 8> out;
    for (std::int64_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c)
            place[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] = points[order[i]].position[c];
    level.evaluate({place[0].data(), place[1].data(), place[2].data(), count},
                   {out[0].data(),
                    {out[1].data(), out[2].data(), out[3].data()},
                    out[4].data(),
                    {out[5].data(), out[6].data(), out[7].data()}});
    for (std::int64_t i = 0; i < count; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        CurvePoint& p = points[order[i]];
        p.value = out[0][lane];
        p.gradient = {out[1][lane], out[2][lane], out[3][lane]};
        p.level = out[4][lane];
        p.level_gradient = {out[5][lane], out[6][lane], out[7][lane]};
    }
}

// Returns whether the next step is negligible. If the last two steps have the lengths s and t = c s^2, the next step
// has the length t^3 / s^2.
bool is_last(double step, double step_before, double tolerance) noexcept {
    return step <= tolerance ||
           (step <= curve_tuning.may_be_last * tolerance &&
            step * step * step <= curve_tuning.negligible_step * tolerance * step_before * step_before);
}

constexpr std::int64_t vertices_a_task = 16384;
// The number of points whose Hessians are stored at a time. It limits the stack that a caller's function uses.
constexpr std::int64_t hessian_block = 32;
// The value of g at a place without samples near it, where the support s is not finite. It is so large that no Newton
// step leads there.
constexpr double unsupported = 1e6;

// Evaluates f and its Hessian in blocks. level(place, grad f, times, slope) returns g at a point and sets slope to its
// gradient. times(v) returns H v at the point.
template <class LevelAt>
void evaluate_blocks(const implicit::Implicit& surface, const implicit::PointBatch& points, const LevelBatch& out,
                     LevelAt&& level) {
    HRBFNPR_ASSERT(points.count >= 0 && points.count <= implicit::batch_size);
    // The second derivatives xx xy xz yy yz zz of each point.
    std::array<std::array<double, static_cast<std::size_t>(hessian_block)>, 6> h;
    for (std::int64_t begin = 0; begin < points.count; begin += hessian_block) {
        const std::int64_t end = std::min(points.count, begin + hessian_block);
        implicit::FieldBatch fields{
            out.value + begin, {out.gradient[0] + begin, out.gradient[1] + begin, out.gradient[2] + begin}, {}};
        for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = h[c].data();
        surface.evaluate(implicit::slice(points, begin, end), fields);
        for (std::int64_t i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i - begin);
            const auto times = [&](const glm::dvec3& v) {
                return glm::dvec3(h[0][k] * v.x + h[1][k] * v.y + h[2][k] * v.z,
                                  h[1][k] * v.x + h[3][k] * v.y + h[4][k] * v.z,
                                  h[2][k] * v.x + h[4][k] * v.y + h[5][k] * v.z);
            };
            glm::dvec3 slope(0.0);
            out.level[i] = level({points.x[i], points.y[i], points.z[i]},
                                 {out.gradient[0][i], out.gradient[1][i], out.gradient[2][i]}, times, slope);
            for (int c = 0; c < 3; ++c) out.level_gradient[static_cast<std::size_t>(c)][i] = slope[c];
        }
    }
}

// Sets the gradients so that CurvePoint::direction(), the cross product of gradient and level_gradient, is the tangent.
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

// Returns n . v. It is negative where the eye sees the outside of the surface.
double facing(const glm::dvec3& gradient, const glm::dvec3& place, const View& view) noexcept {
    return glm::dot(gradient, view.sight(place)) / glm::length(gradient);
}

} // namespace

// ---- Levels

// The vector v from the eye depends on the point if the camera is at a finite distance. Then grad g = H v + grad f. For
// a parallel projection grad g = H v.
void ContourLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    const double own = view_.eye.w == 0.0 ? 0.0 : 1.0;
    evaluate_blocks(surface_, points, out,
                    [&](const glm::dvec3& p, const glm::dvec3& gradient, const auto& times, glm::dvec3& slope) {
                        const glm::dvec3 v = view_.sight(p);
                        slope = times(v) + own * gradient;
                        return glm::dot(gradient, v);
                    });
}

void ContourLevel::at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const {
    HRBFNPR_ASSERT(mesh.gradient.size() == mesh.vertices());
    level.resize_for_overwrite(mesh.vertices());
    work.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) level[i] = glm::dot(mesh.gradient[i], view_.sight(mesh.position[i]));
    });
}

// The derivative of the unit normal with respect to the place is computed as H / |grad f|.
void SupportLevel::evaluate(const implicit::PointBatch& points, const LevelBatch& out) const {
    evaluate_blocks(surface_, points, out,
                    [&](const glm::dvec3& p, const glm::dvec3& gradient, const auto& times, glm::dvec3& slope) {
                        const surface::Support::ValueAndDerivatives s = support_.evaluate(p, gradient);
                        slope = s.place_gradient + times(s.normal_gradient) / glm::length(gradient);
                        return std::isfinite(s.value) ? s.value - limit_ : unsupported;
                    });
}

void SupportLevel::at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const {
    support_.evaluate_all(work, mesh.position, mesh.gradient, level);
    HRBFNPR_ASSERT(level.size() == mesh.vertices());
    for (double& value : level) value = std::isfinite(value) ? value - limit_ : unsupported;
}

// Support is a sum over the nearest samples, so it is not computed where the surface is known to continue.
void SupportLevel::signs_at_vertices(const base::Work& work, const SurfaceMesh& mesh,
                                     base::Array<double>& level) const {
    SurfaceMesh some(work.memory); // the vertices at which the surface may end
    base::Array<std::int64_t> which(work.memory);
    level.resize_for_overwrite(mesh.vertices());
    for (const std::int64_t i : work.over(mesh.vertices())) {
        level[i] = -limit_;
        if (support_.continues_at(mesh.position[i], limit_)) continue;
        some.position.push_back(mesh.position[i]);
        some.gradient.push_back(mesh.gradient[i]);
        which.push_back(i);
    }
    base::Array<double> value(work.memory);
    at_vertices(work, some, value);
    for (std::int64_t k = 0; k < which.size(); ++k) level[which[k]] = value[k];
}

// ---- Points and curves

// The step for g uses the part of grad g that is perpendicular to grad f. A formula with the matrix product J J^T would
// lose half of the digits where the two gradients are nearly parallel. J is the matrix with the rows grad f and grad g.
glm::dvec3 CurvePoint::newton_step() const noexcept {
    const double slope = glm::length(gradient);
    const glm::dvec3 normal = gradient / slope;
    const double height = value / slope;
    const double along = glm::dot(level_gradient, normal);
    const glm::dvec3 across = level_gradient - along * normal;
    return -height * normal - (level - along * height) / glm::dot(across, across) * across;
}

// Evaluates the points. If it saves time, they are first sorted by the surface's cells.
void evaluate(const base::Work& work, const Level& level, base::Array<CurvePoint>& points) {
    base::Array<std::int32_t> order(work.memory);
    if (points.size() > points_a_task) order = implicit::order_by_cell(work, level.surface(), positions_of(points));
    if (order.empty()) {
        order.resize(points.size());
        std::iota(order.begin(), order.end(), 0);
    }
    HRBFNPR_ASSERT(order.size() == points.size());
    level.surface().threads(work).for_chunks(points.size(), points_a_task, [&](std::int64_t begin, std::int64_t end) {
        evaluate_some(level, points.data(), order.data() + begin, end - begin);
    });
}

void bring_closer(const base::Work& work, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations) {
    HRBFNPR_ASSERT(enough.size() == points.size());
    evaluate(work, level, points);
    base::Array<CurvePoint> far(work.memory);
    base::Array<std::int64_t> which(work.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 way = points[i].newton_step();
        points[i].position += way;
        if (glm::length(way) <= enough[i]) continue;
        far.push_back(points[i]);
        which.push_back(i);
    }
    evaluate(work, level, far);
    evaluations += points.size() + far.size();
    for (std::int64_t k = 0; k < which.size(); ++k) {
        points[which[k]] = far[k];
        points[which[k]].position += far[k].newton_step();
    }
}

std::int64_t bring_to_curve(const base::Work& work, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found) {
    HRBFNPR_ASSERT(settings.tolerance >= 0.0 && settings.farthest > 0.0);
    found.clear();
    found.resize(points.size());
    const geometry::VecArray begin = positions_of(points);
    base::Array<double> last_step(work.memory, points.size());
    base::Array<std::int64_t> walking(work.memory, points.size());
    std::iota(walking.begin(), walking.end(), std::int64_t{0});
    base::Array<CurvePoint> trial(work.memory);
    std::int64_t evaluations = 0;
    for (int step = 0; step < curve_tuning.newton_steps && !walking.empty(); ++step) {
        trial.resize(walking.size());
        for (std::int64_t i = 0; i < walking.size(); ++i) trial[i].position = points[walking[i]].position;
        evaluate(work, level, trial);
        evaluations += trial.size();
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < walking.size(); ++i) {
            const std::int64_t which = walking[i];
            CurvePoint& p = points[which];
            p = trial[i];
            const glm::dvec3 way = p.newton_step();
            const double length = glm::length(way);
            if (!(glm::distance(p.position + way, begin[which]) <= settings.farthest)) continue;
            p.position += way;
            if (is_last(length, std::exchange(last_step[which], length), settings.tolerance))
                found[which] = 1;
            else
                walking[left++] = which;
        }
        walking.resize(left);
    }
    return evaluations;
}

std::int64_t bisect(const base::Work& work, const Level& level, const base::Array<Bracket>& places, int halvings,
                    base::Array<CurvePoint>& points) {
    base::Array<Bracket> between(work.memory, places.size());
    std::copy(places.begin(), places.end(), between.begin());
    points.resize(places.size());
    for (int step = 0; step < halvings; ++step) {
        for (std::int64_t i = 0; i < places.size(); ++i)
            points[i].position = 0.5 * (between[i].negative + between[i].positive);
        // The distance of a chord's middle from the surface is proportional to the square of the chord's length. After
        // one Newton step it is proportional to the fourth power. A step longer than half of the chord leads to another
        // place, because |grad f| is nearly 0 there or f has a crease. Such a step is not made.
        evaluate(work, level, points);
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 middle = points[i].position;
            step_to_surface(points[i]);
            const double most = 0.5 * glm::distance(between[i].negative, between[i].positive);
            if (!(glm::distance(points[i].position, middle) <= most)) points[i].position = middle;
        }
        evaluate(work, level, points);
        for (std::int64_t i = 0; i < places.size(); ++i)
            (points[i].level < 0.0 ? between[i].negative : between[i].positive) = points[i].position;
    }
    return std::int64_t{2} * halvings * places.size();
}

geometry::VecArray positions_of(const base::Array<CurvePoint>& points) {
    geometry::VecArray places(points.memory(), points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) places.set(i, points[i].position);
    return places;
}

base::Array<std::int32_t> curve_of_points(const Curves& curves) {
    base::Array<std::int32_t> numbers(curves.point.memory(), curves.point.size());
    for (std::int64_t c = 0; c < curves.count(); ++c)
        std::fill(numbers.data() + curves.first[c], numbers.data() + curves.first[c + 1], static_cast<std::int32_t>(c));
    return numbers;
}

void NearCurves::examine_adjacent_pieces(std::int64_t point, const glm::dvec3& place, const glm::dvec3& along,
                                         Foot& best) const noexcept {
    const CurvePoint& p = curves_.point[point];
    if (glm::distance(p.position, place) >= best.distance + (1.0 + piece_bulge) * longest_ ||
        !(glm::dot(p.direction(), along) >= 0.0))
        return;
    const std::int64_t curve = curve_[point];
    const auto look_at = [&](const glm::dvec3& foot) {
        if (const double distance = glm::distance(foot, place); distance < best.distance)
            best = {foot, distance, curve};
    };
    look_at(p.position);
    const std::int64_t first = curves_.first[curve];
    const std::int64_t last = curves_.first[curve + 1] - 1;
    for (const std::int64_t way : {-1, 1}) {
        const std::int64_t end = way > 0 ? last : first;
        if (point == end && curves_.closed[curve] == 0) continue;
        const CurvePoint& q = curves_.point[point != end ? point + way : first + last - end];
        const glm::dvec3 chord = q.position - p.position;
        const double share = glm::dot(place - p.position, chord) / glm::dot(chord, chord);
        const double reach = best.distance + piece_bulge * glm::length(chord);
        if (!(share > 0.0 && share < 1.0) || glm::distance(p.position + share * chord, place) > reach) continue;
        look_at(way > 0 ? CubicPiece(p, q).at(share) : CubicPiece(q, p).at(1.0 - share));
    }
}

NearCurves::Foot NearCurves::nearest(const glm::dvec3& place, const glm::dvec3& along, std::int64_t but,
                                     double most) const {
    Foot best;
    best.distance = most;
    grid_.around(place, [&](std::int64_t at) {
        if (const std::int64_t point = grid_.index(at); curve_[point] != but)
            examine_adjacent_pieces(point, place, along, best);
    });
    return best;
}

bool NearCurves::passes(const glm::dvec3& place, const glm::dvec3& along, double distance, std::int64_t& guess) const {
    constexpr std::int64_t beside = 2; // how many points are examined on each side of `guess`
    Foot best;
    best.distance = std::nextafter(distance, HUGE_VAL);
    const auto look = [&](std::int64_t point) {
        if (best.curve >= 0) return;
        examine_adjacent_pieces(point, place, along, best);
        if (best.curve >= 0) guess = point;
    };
    const std::int64_t from = std::max<std::int64_t>(guess - beside, 0);
    const std::int64_t to = std::min(guess + beside, curves_.point.size() - 1);
    for (std::int64_t point = from; point <= to; ++point) look(point);
    if (best.curve < 0) grid_.around(place, [&](std::int64_t at) { look(grid_.index(at)); });
    return best.curve >= 0;
}

// ---- Lines on a surface

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
    // Adds the point between a wanted and an unwanted point at which the value is 0.
    const auto put_between = [&](std::int64_t a, std::int64_t b) {
        const CurvePoint& p = curves.point[a];
        const CurvePoint& q = curves.point[b];
        const double u = std::clamp(value[a] / (value[a] - value[b]), 0.0, 1.0);
        // If the wanted point coincides with the zero, the wanted point is the end.
        if ((u < curve_tuning.at_point && wanted(a)) || (u > 1.0 - curve_tuning.at_point && wanted(b))) return;
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
        std::int64_t a, b; // the two points of a piece on which n . v changes its sign
        Illinois root;
        double share;
        glm::dvec3 gradient;
    };
    base::Array<Turn> turns(runtime.memory);
    for_pieces(curves, [&](std::int64_t a, std::int64_t b) {
        const double from = facing(curves.point[a].gradient, curves.point[a].position, view);
        const double to = facing(curves.point[b].gradient, curves.point[b].position, view);
        if ((from < 0.0) != (to < 0.0)) turns.push_back({a, b, Illinois(from, to), 0.5, glm::dvec3(0.0)});
    });
    geometry::VecArray place(runtime.memory, turns.size());
    geometry::VecArray gradient(runtime.memory, turns.size());
    bool left = !turns.empty();
    for (int step = 0; step < curve_tuning.most_steps && left; ++step) {
        for (std::int64_t i = 0; i < turns.size(); ++i) {
            turns[i].share = turns[i].root.trial;
            place.set(i, CubicPiece(curves.point[turns[i].a], curves.point[turns[i].b]).at(turns[i].share));
        }
        implicit::evaluate_all(runtime, surface, place,
                               {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
        left = false;
        for (std::int64_t i = 0; i < turns.size(); ++i) {
            turns[i].gradient = gradient[i];
            if (!turns[i].root.done(curve_tuning.exact)) turns[i].root.take(facing(gradient[i], place[i], view));
            left = left || !turns[i].root.done(curve_tuning.exact);
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
