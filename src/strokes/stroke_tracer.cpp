// SPDX-License-Identifier: MIT
#include "strokes/stroke_tracer.h"

#include <cmath>

namespace hrbfnpr::strokes {
namespace {

// Where the samples around disagree more than this there is no direction to follow.
constexpr double least_agreement = 0.75;
// In sample spacings: the surface ends where the nearest sample is farther away.
constexpr double end_of_samples = 0.95;
// Of the distance kept: a stroke that comes back to its own start within this sideways is a closed curve.
constexpr double closing = 0.3;
// Along a stroke, in distances kept: nearer points of it are not asked.
constexpr double own_reach = 3.0;

} // namespace

bool Tracer::settle(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec3& along, bool turned,
                    StrokePoint& point) const noexcept {
    const surface::DirectionField::Local local = field_.at(p, normal, along, turned);
    if (local.sample < 0 || local.agreement < least_agreement || local.distance > end_of_samples * field_.spacing())
        return false;
    point = {p - local.height * local.normal, local.normal, local.direction};
    return true;
}

// The midpoint rule: of second order, where Euler's would drift off a circle by half its step's bend.
bool Tracer::advance(const StrokePoint& from, const TraceSettings& settings, StrokePoint& to) const noexcept {
    const surface::DirectionField::Local middle =
        field_.at(from.position + 0.5 * settings.step * from.direction, from.normal, from.direction, settings.turned);
    if (middle.sample < 0) return false;
    if (!settle(from.position + settings.step * middle.direction, middle.normal, middle.direction, settings.turned, to))
        return false;
    return glm::dot(from.direction, to.direction) > settings.least_cosine && settings.region.contains(to.position);
}

Tracer::Verdict Tracer::look(const StrokePoint& point, std::int32_t stroke, std::int32_t place,
                             const TraceSettings& settings) const noexcept {
    Verdict verdict = Verdict::free;
    const auto reach = static_cast<std::int32_t>(std::min(std::ceil(own_reach * settings.test / settings.step), 1e9));
    grid_.around(point.position, settings.test, [&](const StrokeGrid::Node& node) {
        const glm::dvec3 offset = node.point.position - point.position;
        if (squared_clearance(point, offset) >= settings.test * settings.test || !run_alike(node.point, point))
            return true;
        if (node.stroke != stroke) {
            verdict = Verdict::blocked;
            return false;
        }
        if (std::abs(node.place - place) <= reach) return true;
        const double beside = glm::length(offset - glm::dot(offset, point.direction) * point.direction);
        const bool is_start = node.place >= 0 && node.place <= 2 * settings.thin;
        const bool same_way = glm::dot(node.point.direction, point.direction) > 0.0;
        verdict = is_start && same_way && beside < closing * settings.test ? Verdict::closes : Verdict::blocked;
        return verdict != Verdict::blocked;
    });
    return verdict;
}

void Tracer::run(const StrokePoint& from, int side, std::int32_t stroke, std::int64_t most,
                 const TraceSettings& settings) {
    base::Array<StrokePoint>& points = side > 0 ? ahead_ : behind_;
    StrokePoint here = from;
    if (side < 0) here.direction = -here.direction;
    StrokePoint next;
    while (count() < most && advance(here, settings, next)) {
        if (points.size() % 256 == 0) settings.progress.check();
        const auto place = static_cast<std::int32_t>(side > 0 ? points.size() : -points.size() - 1);
        here = next;
        if (side < 0) next.direction = -next.direction;
        const Verdict verdict = look(next, stroke, place, settings);
        if (verdict == Verdict::blocked) return;
        if (verdict == Verdict::closes) return close_up(next, stroke, place, settings);
        points.push_back(next);
        if (place % settings.thin == 0) grid_.insert(next, stroke, place);
    }
}

// From where a stroke comes near its own start, the rest of the way in even steps.  Only forward: the way back
// starts where the way forward does.
void Tracer::close_up(const StrokePoint& end, std::int32_t stroke, std::int32_t place, const TraceSettings& settings) {
    if (place < 0) return;
    closed_ = true;
    const StrokePoint first = ahead_[0];
    const StrokePoint last = ahead_.back();
    const glm::dvec3 rest = first.position - last.position;
    const double length = glm::length(rest);
    const auto steps = static_cast<std::int32_t>(std::lround(std::min(length / settings.step, 1e9)));
    for (std::int32_t i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(steps);
        StrokePoint point;
        if (!settle(last.position + t * rest, end.normal, end.direction, settings.turned, point)) return;
        ahead_.push_back(point);
        if ((place + i - 1) % settings.thin == 0) grid_.insert(point, stroke, place + i - 1);
    }
}

void Tracer::trace(const StrokePoint& seed, std::int32_t stroke, const TraceSettings& settings) {
    ahead_.clear();
    behind_.clear();
    closed_ = false;
    ahead_.push_back(seed);
    grid_.insert(seed, stroke, 0);
    const double points = settings.longest > 0.0 ? settings.longest / settings.step : 1e6;
    const auto most = static_cast<std::int64_t>(std::clamp(points, 2.0, 1e6)) + 1;
    // With a limit, half of it to each side; what one side does not need the other may have.
    run(seed, 1, stroke, settings.longest > 0.0 ? (most + 1) / 2 : most, settings);
    if (!closed_) run(seed, -1, stroke, most, settings);
    if (!closed_ && count() < most && settings.longest > 0.0 && ahead_.size() == (most + 1) / 2)
        run(ahead_.back(), 1, stroke, most, settings);
}

} // namespace hrbfnpr::strokes
