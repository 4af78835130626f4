// SPDX-License-Identifier: MIT
#include "curves/curves.h"

#include "curves/tuning.h"
#include "implicit/evaluate_all.h"

#include <array>
#include <numeric>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// A cubic between points that turns by less than a right angle is no farther from its chord than this, in chords.
constexpr double piece_bulge = 0.25;
// This is small enough for two threads to share a few hundred points, and several vectors long.
constexpr std::int64_t points_a_task = 32;

// Evaluates points[order[i]] for each i < count, side by side.
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

// Whether the next step is negligible: after steps s and t = c s^2 it is t^3 / s^2.
bool is_last(double step, double step_before, double tolerance) noexcept {
    return step <= tolerance ||
           (step <= curve_tuning.may_be_last * tolerance &&
            step * step * step <= curve_tuning.negligible_step * tolerance * step_before * step_before);
}

} // namespace

// The step goes by the part of grad g across grad f, because the product J J^T would lose half of the digits where the
// gradients are nearly parallel.
glm::dvec3 CurvePoint::newton_step() const noexcept {
    const double slope = glm::length(gradient);
    const glm::dvec3 normal = gradient / slope;
    const double height = value / slope;
    const double along = glm::dot(level_gradient, normal);
    const glm::dvec3 across = level_gradient - along * normal;
    return -height * normal - (level - along * height) / glm::dot(across, across) * across;
}

// The points are worked on cell by cell where the surface has cells and that pays.
void evaluate(const base::Runtime& runtime, const Level& level, base::Array<CurvePoint>& points,
              const base::Progress& progress) {
    base::Array<std::int32_t> order(runtime.memory);
    if (points.size() > points_a_task)
        order = implicit::order_by_cell(runtime, level.surface(), positions_of(points), progress);
    if (order.empty()) {
        order.resize(points.size());
        std::iota(order.begin(), order.end(), 0);
    }
    HRBFNPR_ASSERT(order.size() == points.size());
    level.surface()
        .threads(runtime.parallel)
        .for_chunks(points.size(), points_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            evaluate_some(level, points.data(), order.data() + begin, end - begin);
        });
}

void bring_closer(const base::Runtime& runtime, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations, const base::Progress& progress) {
    HRBFNPR_ASSERT(enough.size() == points.size());
    evaluate(runtime, level, points, progress);
    base::Array<CurvePoint> far(runtime.memory);
    base::Array<std::int64_t> which(runtime.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 way = points[i].newton_step();
        points[i].position += way;
        if (glm::length(way) <= enough[i]) continue;
        far.push_back(points[i]);
        which.push_back(i);
    }
    evaluate(runtime, level, far, progress);
    evaluations += points.size() + far.size();
    for (std::int64_t k = 0; k < which.size(); ++k) {
        points[which[k]] = far[k];
        points[which[k]].position += far[k].newton_step();
    }
}

std::int64_t bring_to_curve(const base::Runtime& runtime, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found,
                            const base::Progress& progress) {
    HRBFNPR_ASSERT(settings.tolerance >= 0.0 && settings.farthest > 0.0);
    found.clear();
    found.resize(points.size());
    const geometry::VecArray begin = positions_of(points);
    base::Array<double> last_step(runtime.memory, points.size());
    base::Array<std::int64_t> walking(runtime.memory, points.size());
    std::iota(walking.begin(), walking.end(), std::int64_t{0});
    base::Array<CurvePoint> trial(runtime.memory);
    std::int64_t evaluations = 0;
    for (int step = 0; step < curve_tuning.newton_steps && !walking.empty(); ++step) {
        trial.resize(walking.size());
        for (std::int64_t i = 0; i < walking.size(); ++i) trial[i].position = points[walking[i]].position;
        evaluate(runtime, level, trial, progress);
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

std::int64_t halve(const base::Runtime& runtime, const Level& level, const base::Array<Straddle>& places, int halvings,
                   base::Array<CurvePoint>& points, const base::Progress& progress) {
    base::Array<Straddle> between(runtime.memory, places.size());
    std::copy(places.begin(), places.end(), between.begin());
    points.resize(places.size());
    for (int step = 0; step < halvings; ++step) {
        for (std::int64_t i = 0; i < places.size(); ++i)
            points[i].position = 0.5 * (between[i].negative + between[i].positive);
        // The middle of a chord is off the surface by the square of its length; one step leaves the fourth power. A
        // step longer than half of the chord leads elsewhere, as where f hardly rises or has a crease.
        evaluate(runtime, level, points, progress);
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 middle = points[i].position;
            step_to_surface(points[i]);
            const double most = 0.5 * glm::distance(between[i].negative, between[i].positive);
            if (!(glm::distance(points[i].position, middle) <= most)) points[i].position = middle;
        }
        evaluate(runtime, level, points, progress);
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

// Looks at each point around the place and at the pieces on both sides of it.
NearCurves::Foot NearCurves::nearest(const glm::dvec3& place, const glm::dvec3& along, std::int64_t but) const {
    Foot best;
    const auto look_at = [&](const glm::dvec3& foot, std::int64_t curve) {
        if (const double distance = glm::distance(foot, place); distance < best.distance)
            best = {foot, distance, curve};
    };
    grid_.around(place, [&](std::int64_t at) {
        const std::int64_t point = grid_.index(at);
        const std::int64_t curve = curve_[point];
        const CurvePoint& p = curves_.point[point];
        if (curve == but || !(glm::dot(p.direction(), along) >= 0.0)) return;
        look_at(p.position, curve);
        for (const std::int64_t way : {-1, 1}) {
            const std::int64_t first = curves_.first[curve];
            const std::int64_t size = curves_.size_of(curve);
            const std::int64_t k = point - first + way;
            if (curves_.closed[curve] == 0 && (k < 0 || k >= size)) continue;
            const CurvePoint& q = curves_.point[first + (k + size) % size];
            const glm::dvec3 chord = q.position - p.position;
            const double share = glm::dot(place - p.position, chord) / glm::dot(chord, chord);
            const double reach = best.distance + piece_bulge * glm::length(chord);
            if (!(share > 0.0 && share < 1.0) || glm::distance(p.position + share * chord, place) > reach) continue;
            look_at(way > 0 ? CubicPiece(p, q).at(share) : CubicPiece(q, p).at(1.0 - share), curve);
        }
    });
    return best;
}

} // namespace hrbfnpr::curves
