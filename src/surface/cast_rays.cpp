// SPDX-License-Identifier: MIT
#include "surface/cast_rays.h"

#include "surface/ray_range.h"
#include "surface/region.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace hrbfnpr::surface {
namespace {

constexpr std::int64_t batch_size = implicit::batch_size;
constexpr auto lanes = static_cast<std::size_t>(batch_size);
using Column = std::array<double, lanes>;

// A step changes f by at most L times its length. This factor allows for rounding.
constexpr double slack = 1.0 + 1e-9;

// A ray inside the search region. s is the distance from the start of the search.
//
// Marching: there is no root within |f| / L of a point, so the step has this length [Hart 1996]. It has at least the
// smallest length, so that the march ends. If a longer step changes f by more than L times its length, L is too small
// there: the step is undone, and L is raised for this ray. So if L is correct, f changes its sign only in smallest
// steps, whose ends bracket a root.
//
// Refining: Newton's method along the ray, from the secant's root. A step is replaced by bisection if it leaves the
// bracket or is more than half as long as the previous step.
struct Ray {
    enum class Phase : std::uint8_t { march, refine, done };

    RayRange range;
    double lipschitz = 0.0;
    double at = 0.0;    // the value of s up to which the search is complete
    double value = 0.0; // f at s = `at`
    double trial = 0.0; // the value of s for the next evaluation
    double low = 0.0;   // the bracket [low, high] of a root, and the last change of s within it
    double high = 0.0;
    double change = 0.0;
    double far_end = 0.0; // s and f at the far end of the original bracket, where the march continues
    double far_end_value = 0.0;
    std::int32_t evaluations = 0;
    std::int32_t hits = 0;
    bool inside = false; // whether f < 0 at s = `at`
    Phase phase = Phase::march;
};

// Clips the range [from, to] of a ray to the region. `direction` is a unit vector. Returns whether a part of the range
// remains.
bool clip(const geometry::Bounds& region, const glm::dvec3& origin, const glm::dvec3& direction, double& from,
          double& to) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const double low = region.min[axis] - origin[axis];
        const double high = region.max[axis] - origin[axis];
        if (direction[axis] == 0.0) {
            if (!(low <= 0.0 && high >= 0.0)) return false;
            continue;
        }
        const double a = low / direction[axis];
        const double b = high / direction[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to && std::isfinite(from);
}

} // namespace

RayRange range_in(const geometry::Bounds& region, const RaySettings& settings, const glm::dvec3& origin,
                  const glm::dvec3& direction) noexcept {
    RayRange range;
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const glm::dvec3 scaled = direction / largest; // scaled so that its square neither overflows nor underflows
    range.length = largest * glm::length(scaled);
    range.direction = scaled / glm::length(scaled);
    const double last = settings.t_max * range.length;
    double from = 0.0;
    double to = last;
    range.offset = settings.t_min * range.length;
    bool meets = clip(region, origin, range.direction, range.offset, to);
    // If the origin is far away, rounding could put the start outside the region, where f need not be defined. So the
    // start is clamped.
    range.start = glm::clamp(origin + range.offset * range.direction, region.min, region.max);
    range.end = last - range.offset;
    meets = meets && clip(region, range.start, range.direction, from, range.end);
    range.empty = !meets;
    return range;
}

void resize(RayHits& hits, std::int64_t count, const RaySettings& settings) {
    hits.t.resize(count * settings.maximum_hits);
    hits.position.resize(count * settings.maximum_hits);
    hits.normal.resize(count * settings.maximum_hits);
    hits.entering.resize(count * settings.maximum_hits);
    hits.count.resize(count);
    hits.status.resize(count);
}

void clear(RayHits& hits, const RaySettings& settings, std::int64_t begin, std::int64_t end) noexcept {
    const std::int64_t most = settings.maximum_hits;
    for (std::int64_t at = begin * most; at < end * most; ++at) {
        hits.t[at] = std::numeric_limits<double>::infinity();
        hits.position.set(at, glm::dvec3(0.0));
        hits.normal.set(at, glm::dvec3(0.0));
        hits.entering[at] = 0;
    }
}

void copy_ray(const RayHits& from, std::int64_t ray, std::int64_t to_ray, const RaySettings& settings, RayHits& to) {
    for (std::int64_t h = 0; h < settings.maximum_hits; ++h) {
        const std::int64_t at = ray * settings.maximum_hits + h;
        const std::int64_t to_at = to_ray * settings.maximum_hits + h;
        to.t[to_at] = from.t[at];
        to.position.set(to_at, from.position[at]);
        to.normal.set(to_at, from.normal[at]);
        to.entering[to_at] = from.entering[at];
    }
    to.count[to_ray] = from.count[ray];
    to.status[to_ray] = from.status[ray];
}

void store_hit(RayHits& hits, const RaySettings& settings, std::int64_t ray, std::int32_t h, const RayRange& range,
               double s, const glm::dvec3& g, bool entering) noexcept {
    const std::int64_t at = ray * settings.maximum_hits + h;
    const double slope = glm::length(g);
    hits.t[at] = std::clamp((range.offset + s) / range.length, settings.t_min, settings.t_max);
    hits.position.set(at, range.at(s));
    hits.normal.set(at, std::isfinite(slope) && slope > 0.0 ? g / slope : glm::dvec3(0.0));
    hits.entering[at] = entering ? 1 : 0;
}

namespace {

class RayBatch {
public:
    RayBatch(const implicit::Implicit& implicit, const RaySettings& settings, double lipschitz, RayHits& hits) noexcept
        : implicit_(implicit), settings_(settings), hits_(hits), region_(search_region(implicit)),
          lipschitz_(lipschitz), smallest_step_(settings.smallest_step * implicit.diagonal()),
          tolerance_(settings.tolerance * implicit.diagonal()) {}

    // Casts `count` rays, at most a batch. `number` returns the number of a ray of the batch among all rays.
    template <class Number>
    void run(const Rays& rays, std::int64_t count, Number&& number, const base::Progress& progress);

private:
    void pack(Ray::Phase phase) noexcept;
    void advance(Ray::Phase phase, const base::Progress& progress);
    void take_step(std::size_t i, double f) noexcept;
    void march_on(std::size_t i, double at, double f) noexcept;
    void bracket(std::size_t i, double f) noexcept;
    void take_root(std::size_t i, double f, const glm::dvec3& g);
    void hit(std::size_t i, double s, const glm::dvec3& g);
    void end_with(std::size_t i, RayStatus status) noexcept;
    [[nodiscard]] bool count_evaluation(std::size_t i, bool finite) noexcept;

    const implicit::Implicit& implicit_;
    const RaySettings& settings_;
    RayHits& hits_;
    geometry::Bounds region_;
    double lipschitz_;
    double smallest_step_;
    double tolerance_;

    std::array<Ray, lanes> rays_;
    std::array<std::int64_t, lanes> number_; // the number of each ray of the batch among all rays
    // The indices of the unfinished rays, and of the rays that are being evaluated.
    std::array<std::size_t, lanes> active_, packed_;
    std::size_t active_count_ = 0, packed_count_ = 0;
    Column x_, y_, z_, f_, gx_, gy_, gz_;
};

void RayBatch::end_with(std::size_t i, RayStatus status) noexcept {
    rays_[i].phase = Ray::Phase::done;
    hits_.count[number_[i]] = rays_[i].hits;
    hits_.status[number_[i]] = status;
}

// Counts an evaluation. Returns whether its result can be used.
bool RayBatch::count_evaluation(std::size_t i, bool finite) noexcept {
    ++rays_[i].evaluations;
    if (!finite) end_with(i, RayStatus::not_finite);
    return finite;
}

void RayBatch::take_step(std::size_t i, double f) noexcept {
    Ray& ray = rays_[i];
    if (!count_evaluation(i, std::isfinite(f))) return;
    if (ray.evaluations == 1) {
        ray.inside = f < 0.0;
        return march_on(i, 0.0, f);
    }
    const double step = ray.trial - ray.at;
    const double slope = std::abs(f - ray.value) / step;
    if (step > smallest_step_ * slack && slope > ray.lipschitz * slack) {
        ray.lipschitz = std::max(2.0 * ray.lipschitz, 1.5 * slope);
        return march_on(i, ray.at, ray.value);
    }
    if ((f < 0.0) != ray.inside) return bracket(i, f);
    march_on(i, ray.trial, f);
}

// Ends the ray or chooses the next step. The search is complete up to s = `at`, where f has the given value.
void RayBatch::march_on(std::size_t i, double at, double f) noexcept {
    Ray& ray = rays_[i];
    ray.at = at;
    ray.value = f;
    if (at >= ray.range.end) return end_with(i, ray.hits > 0 ? RayStatus::hit : RayStatus::miss);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    const double step = std::max(smallest_step_, std::abs(f) / ray.lipschitz);
    ray.trial = std::min(ray.range.end, at + step);
    ray.phase = Ray::Phase::march;
}

// Starts to refine a root, because f changes its sign between `at` and `trial`.
void RayBatch::bracket(std::size_t i, double f) noexcept {
    Ray& ray = rays_[i];
    if (ray.hits == settings_.maximum_hits) return end_with(i, RayStatus::truncated);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    ray.low = ray.at;
    ray.high = ray.far_end = ray.trial;
    ray.far_end_value = f;
    ray.change = ray.high - ray.low;
    ray.trial = ray.low + ray.change * (ray.value / (ray.value - f));
    ray.phase = Ray::Phase::refine;
}

void RayBatch::take_root(std::size_t i, double f, const glm::dvec3& g) {
    Ray& ray = rays_[i];
    const double slope = glm::dot(g, ray.range.direction);
    if (!count_evaluation(i, std::isfinite(f) && std::isfinite(glm::length(g)))) return;
    ((f < 0.0) == ray.inside ? ray.low : ray.high) = ray.trial;
    const double newton = ray.trial - f / slope; // NaN or infinite if the slope is 0
    const bool within = newton >= ray.low && newton <= ray.high;
    const double change = std::abs(newton - ray.trial);
    if (within && change <= tolerance_) return hit(i, newton, g);
    const double middle = 0.5 * (ray.low + ray.high);
    const double next = within && change <= 0.5 * ray.change ? newton : middle;
    if (ray.high - ray.low <= tolerance_ || next == ray.trial) return hit(i, ray.trial, g);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    ray.change = std::abs(next - ray.trial);
    ray.trial = next;
}

void RayBatch::hit(std::size_t i, double s, const glm::dvec3& g) {
    Ray& ray = rays_[i];
    if (!implicit_.contains(ray.range.at(s), g)) { // f changes its sign, but the surface was trimmed here
        ray.inside = !ray.inside;
        return march_on(i, ray.far_end, ray.far_end_value);
    }
    store_hit(hits_, settings_, number_[i], ray.hits++, ray.range, s, g, !ray.inside);
    ray.inside = !ray.inside;
    if (settings_.maximum_hits == 1) return end_with(i, RayStatus::hit);
    march_on(i, ray.far_end, ray.far_end_value);
}

// Collects the active rays of a phase and the points to evaluate for them.
void RayBatch::pack(Ray::Phase phase) noexcept {
    packed_count_ = 0;
    for (std::size_t k = 0; k < active_count_; ++k) {
        const std::size_t i = active_[k];
        const Ray& ray = rays_[i];
        if (ray.phase != phase) continue;
        const glm::dvec3 p = ray.range.at(ray.trial);
        x_[packed_count_] = p.x;
        y_[packed_count_] = p.y;
        z_[packed_count_] = p.z;
        packed_[packed_count_++] = i;
    }
}

// Evaluates f, or f and its gradient, for all rays of a phase.
void RayBatch::advance(Ray::Phase phase, const base::Progress& progress) {
    pack(phase);
    if (packed_count_ == 0) return;
    progress.check();
    const bool march = phase == Ray::Phase::march;
    implicit::FieldBatch fields;
    fields.value = f_.data();
    if (!march) fields.gradient = {gx_.data(), gy_.data(), gz_.data()};
    implicit_.evaluate({x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(packed_count_)}, fields);
    for (std::size_t k = 0; k < packed_count_; ++k) {
        if (march)
            take_step(packed_[k], f_[k]);
        else
            take_root(packed_[k], f_[k], {gx_[k], gy_[k], gz_[k]});
    }
}

template <class Number>
void RayBatch::run(const Rays& rays, std::int64_t count, Number&& number, const base::Progress& progress) {
    active_count_ = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const std::int64_t at = number_[i] = number(static_cast<std::int64_t>(i));
        clear(hits_, settings_, at, at + 1);
        rays_[i] = Ray();
        rays_[i].range = range_in(region_, settings_, rays.origin[at], rays.direction[at]);
        rays_[i].lipschitz = lipschitz_;
        if (rays_[i].range.empty)
            end_with(i, RayStatus::miss); // the ray is outside the region
        else
            active_[active_count_++] = i;
    }
    while (active_count_ > 0) {
        advance(Ray::Phase::march, progress);
        advance(Ray::Phase::refine, progress);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < active_count_; ++k)
            if (rays_[active_[k]].phase != Ray::Phase::done) active_[kept++] = active_[k];
        active_count_ = kept;
    }
}

} // namespace

void march_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
                double lipschitz, const Rays& rays, const std::int32_t* which, std::int64_t count, RayHits& hits) {
    base::OwnedObject<RayBatch> batch(work.memory, implicit, settings, lipschitz, hits);
    for (std::int64_t begin = 0; begin < count; begin += batch_size)
        batch->run(
            rays, std::min(batch_size, count - begin), [&](std::int64_t i) { return which[begin + i]; }, work);
}

void cast_rays(const base::Work& work, const implicit::Implicit& implicit, const RaySettings& settings,
               const Rays& rays, RayHits& hits) {
    const std::int64_t count = rays.origin.size();
    resize(hits, count, settings);
    if (count == 0) return;
    const bool estimate = !(settings.lipschitz > 0.0);
    const double lipschitz = estimate ? lipschitz_estimate(work.part(0.0, 0.1), implicit) : settings.lipschitz;
    const base::Work casting = work.part(estimate ? 0.1 : 0.0, 1.0);
    std::atomic<std::int64_t> done{0};
    implicit.threads(work).for_chunks(count, batch_size, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<RayBatch> batch(work.memory, implicit, settings, lipschitz, hits);
        batch->run(
            rays, end - begin, [begin](std::int64_t i) { return begin + i; }, casting);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        casting.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::surface
