// SPDX-License-Identifier: MIT
#include "curves/curve_points.h"

#include "implicit/evaluate_all.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// Small enough for two threads to share a few hundred points, and several vectors long.
constexpr std::int64_t points_a_task = 32;

using Column = std::array<double, static_cast<std::size_t>(points_a_task)>;

// Points from all over, side by side.
void evaluate_some(const Level& level, CurvePoint* points, const std::int32_t* order, std::int64_t count) {
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

// Cell by cell where the surface has cells and that pays; else as they come.
base::Array<std::int32_t> order_of(const base::Runtime& runtime, const Level& level,
                                   const base::Array<CurvePoint>& points, const base::Progress& progress) {
    base::Array<std::int32_t> order(runtime.memory);
    if (points.size() > points_a_task) {
        geometry::VecArray places(runtime.memory, points.size());
        for (std::int64_t i = 0; i < points.size(); ++i) places.set(i, points[i].position);
        order = implicit::order_by_cell(runtime, level.surface(), places, progress);
    }
    if (!order.empty()) return order;
    order.resize(points.size());
    std::iota(order.begin(), order.end(), 0);
    return order;
}

// A point on its way.
struct Walker {
    std::int64_t point;
    glm::dvec3 begin;
    double last_step = 0.0;
};

// Steps that are so many times longer than the tolerance may be the last ones, too ...
constexpr double may_be_last = 5.0;
// ... where the next one would be below this share of it: of steps s, t that go on as Newton's do, t = c s^2, the next
// one is t^3 / s^2.
constexpr double nothing = 1e-3;

bool is_last(double step, double step_before, double tolerance) noexcept {
    return step <= tolerance ||
           (step <= may_be_last * tolerance && step * step * step <= nothing * tolerance * step_before * step_before);
}

} // namespace

// By what is left of grad g across grad f: the product J J^T would lose half of the digits where they are near
// parallel.
glm::dvec3 CurvePoint::newton_step() const noexcept {
    const double slope = glm::length(gradient);
    const glm::dvec3 normal = gradient / slope;
    const double height = value / slope;
    const double along = glm::dot(level_gradient, normal);
    const glm::dvec3 across = level_gradient - along * normal;
    return -height * normal - (level - along * height) / glm::dot(across, across) * across;
}

void evaluate(const base::Runtime& runtime, const Level& level, base::Array<CurvePoint>& points,
              const base::Progress& progress) {
    const base::Parallel threads = level.surface().threads(runtime.parallel);
    const base::Array<std::int32_t> order = order_of(runtime, level, points, progress);
    threads.for_chunks(points.size(), points_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        evaluate_some(level, points.data(), order.data() + begin, end - begin);
    });
}

void bring_close(const base::Runtime& runtime, const Level& level, int steps, base::Array<CurvePoint>& points,
                 std::int64_t& evaluations, const base::Progress& progress) {
    for (int step = 0; step < steps; ++step) {
        evaluate(runtime, level, points, progress);
        for (CurvePoint& p : points) p.position += p.newton_step();
    }
    evaluations += steps * points.size();
}

void bring_closer(const base::Runtime& runtime, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations, const base::Progress& progress) {
    evaluate(runtime, level, points, progress);
    base::Array<CurvePoint> far(runtime.memory);
    base::Array<std::int64_t> of(runtime.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 way = points[i].newton_step();
        points[i].position += way;
        if (glm::length(way) <= enough[i]) continue;
        far.push_back(points[i]);
        of.push_back(i);
    }
    evaluations += points.size();
    bring_close(runtime, level, 1, far, evaluations, progress);
    for (std::int64_t k = 0; k < of.size(); ++k) points[of[k]] = far[k];
}

std::int64_t bring_to_curve(const base::Runtime& runtime, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found,
                            const base::Progress& progress) {
    found.resize(points.size());
    std::fill(found.begin(), found.end(), std::uint8_t{0});
    base::Array<Walker> walking(runtime.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) walking.push_back({i, points[i].position, 0.0});
    base::Array<CurvePoint> trial(runtime.memory);
    std::int64_t evaluations = 0;
    for (int step = 0; step < settings.steps && !walking.empty(); ++step) {
        trial.resize(walking.size());
        for (std::int64_t i = 0; i < walking.size(); ++i) trial[i].position = points[walking[i].point].position;
        evaluate(runtime, level, trial, progress);
        evaluations += trial.size();
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < walking.size(); ++i) {
            Walker walker = walking[i];
            CurvePoint& p = points[walker.point];
            p = trial[i];
            const glm::dvec3 way = p.newton_step();
            const double length = glm::length(way);
            if (!(glm::distance(p.position + way, walker.begin) <= settings.farthest)) continue;
            p.position += way;
            if (is_last(length, std::exchange(walker.last_step, length), settings.tolerance))
                found[walker.point] = 1;
            else
                walking[left++] = walker;
        }
        walking.resize(left);
    }
    return evaluations;
}

} // namespace hrbfnpr::curves
