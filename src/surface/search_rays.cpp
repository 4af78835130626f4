// SPDX-License-Identifier: MIT
// Finds where many rays meet the surface of a prepared fit.
//
// Searching: the ray goes from cell to cell of RayCells. Cells without a root need no evaluation. In other cells the
// bound M on the second derivative says that f stays beyond its tangent by at most M s^2 / 2 at the distance s from the
// last evaluation. So there is a first distance at which a root is possible, and there may be a first distance at which
// a root is certain. If a root is certain within the cell, it is refined; else the next step ends at the first possible
// root. Steps have at least the smallest length, so that the search ends.
//
// Refining: Newton's method along the ray. A step is replaced by bisection if it leaves the bracket or is more than
// half as long as the previous step. If the prepared values are too inexact for the tolerance, the root is finished
// with sums over all centres.
//
// Bounds are estimates. A ray that contradicts a bound or a sign is cast by marching instead, as few rays are.
#include "implicit/evaluate_all.h"
#include "surface/cast_rays.h"
#include "surface/ray_cells.h"
#include "surface/ray_range.h"
#include "surface/region.h"
#include "surface/tuning.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace hrbfnpr::surface {
namespace {

constexpr auto batch_lanes = static_cast<std::size_t>(RayTuning::batch);
using SearchColumn = std::array<double, batch_lanes>;

constexpr double search_slack = 1.0 + 1e-9; // allows for rounding

struct SearchRay {
    enum class Phase : std::uint8_t { search, refine, finish, done };

    RayRange range;
    RayCells::Line line{};
    double clear_to = 0.0; // up to this s, the search is complete
    double at = 0.0;       // s of the last evaluation, with f and its derivative along the ray
    double value = 0.0;
    double slope = 0.0;
    double bend = 0.0;  // a bound on the second derivative from `at` to the end of the current cell
    double trial = 0.0; // the value of s for the next evaluation
    double low = 0.0;   // the bracket [low, high] of a root, and the last change of s within it
    double high = 0.0;
    double change = 0.0;
    std::int32_t evaluations = 0;
    std::int32_t hits = 0;
    bool evaluated = false;  // whether the search has evaluated f at `at`
    bool sign_known = false; // whether `inside` is set
    bool inside = false;     // whether f < 0 at s = clear_to
    bool proved = false;     // whether f has been seen to have the other sign in the bracket
    Phase phase = Phase::search;
};

// Distances from the last evaluation: no root is nearer than `possible`, and a root is not farther than `certain`.
struct RootBounds {
    double possible;
    double certain;
};

// f is `height` >= 0 away from 0, and changes by `away` a unit of length, plus at most bend / 2 times the square.
[[nodiscard]] RootBounds root_bounds(double height, double away, double bend) noexcept {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double up = std::sqrt(away * away + 2.0 * bend * height);
    double possible = 0.0;
    if (away > 0.0)
        possible = bend > 0.0 ? (away + up) / bend : never;
    else if (up - away > 0.0)
        possible = 2.0 * height / (up - away);
    const double square = away * away - 2.0 * bend * height;
    const double certain = away < 0.0 && square > 0.0 ? 2.0 * height / (std::sqrt(square) - away) : never;
    return {possible, certain};
}

class RaySearch {
public:
    RaySearch(const RayCells& cells, const implicit::Implicit& implicit, const RaySettings& settings,
              RayHits& hits) noexcept
        : cells_(cells), implicit_(implicit), settings_(settings), hits_(hits), region_(search_region(implicit)),
          smallest_step_(settings.smallest_step * implicit.diagonal()),
          tolerance_(settings.tolerance * implicit.diagonal()),
          measured_error_(cells.prepared().error().value * implicit.diagonal()),
          value_error_(ray_tuning.error * measured_error_),
          slope_error_(ray_tuning.error * cells.prepared().error().gradient) {}

    void run(const base::Work& work, const Rays& rays, std::int64_t begin, std::int64_t end);

private:
    void begin_ray(std::size_t i, const Rays& rays);
    void search_on(std::size_t i) noexcept;
    void choose_step(SearchRay& ray, const RootBounds& bounds, double end) noexcept;
    void take_step(std::size_t i, double f, double slope) noexcept;
    [[nodiscard]] bool contradicts(const SearchRay& ray, double f, double slope) const noexcept;
    [[nodiscard]] bool may_refine(std::size_t i) noexcept;
    void continue_from(std::size_t i, double s, double f, double slope) noexcept;
    void take_root(std::size_t i, double f, const glm::dvec3& g);
    void take_exact(std::size_t i, double f, const glm::dvec3& g);
    void root(std::size_t i, double s, const glm::dvec3& g);
    void hit(std::size_t i, double s, const glm::dvec3& g);
    void end_with(std::size_t i, RayStatus status) noexcept;
    void doubt(std::size_t i) noexcept;
    [[nodiscard]] bool count_evaluation(std::size_t i, bool finite) noexcept;
    [[nodiscard]] std::size_t pack(bool finishing) noexcept;
    void advance(bool finishing, const base::Progress& progress);

    const RayCells& cells_;
    const implicit::Implicit& implicit_;
    const RaySettings& settings_;
    RayHits& hits_;
    geometry::Bounds region_;
    double smallest_step_;
    double tolerance_;
    double measured_error_; // the largest measured error of prepared values
    double value_error_;    // bounds on the errors of prepared values and gradients
    double slope_error_;
    std::int64_t begin_ = 0;

    std::array<SearchRay, batch_lanes> rays_;
    std::array<std::size_t, batch_lanes> active_; // the indices of the unfinished rays
    std::array<std::int64_t, batch_lanes> keys_;  // the cells and indices of the rays that are being evaluated
    std::array<std::int32_t, batch_lanes> doubted_;
    std::size_t active_count_ = 0;
    std::int64_t doubted_count_ = 0;
    SearchColumn x_, y_, z_, f_, gx_, gy_, gz_;
};

void RaySearch::end_with(std::size_t i, RayStatus status) noexcept {
    rays_[i].phase = SearchRay::Phase::done;
    hits_.count[begin_ + static_cast<std::int64_t>(i)] = rays_[i].hits;
    hits_.status[begin_ + static_cast<std::int64_t>(i)] = status;
}

// Leaves a ray to the march.
void RaySearch::doubt(std::size_t i) noexcept {
    rays_[i].phase = SearchRay::Phase::done;
    doubted_[static_cast<std::size_t>(doubted_count_++)] =
        static_cast<std::int32_t>(begin_ + static_cast<std::int64_t>(i));
}

// Counts an evaluation. Returns whether its result can be used.
bool RaySearch::count_evaluation(std::size_t i, bool finite) noexcept {
    ++rays_[i].evaluations;
    if (!finite) end_with(i, RayStatus::not_finite);
    return finite;
}

void RaySearch::begin_ray(std::size_t i, const Rays& rays) {
    SearchRay& ray = rays_[i];
    const std::int64_t at = begin_ + static_cast<std::int64_t>(i);
    ray = SearchRay();
    ray.range = range_in(region_, settings_, rays.origin[at], rays.direction[at]);
    ray.line = cells_.line(ray.range.start, ray.range.direction);
    if (ray.range.empty) return end_with(i, RayStatus::miss);
    search_on(i);
}

// Goes on to the next place to evaluate, or ends the ray.
void RaySearch::search_on(std::size_t i) noexcept {
    SearchRay& ray = rays_[i];
    ray.phase = SearchRay::Phase::search;
    while (ray.clear_to < ray.range.end) {
        const RayCells::Part part = cells_.part(ray.line, ray.clear_to);
        const double end = std::min(part.end, ray.range.end);
        if (part.cell->kind != RayCells::Kind::crossed) {
            const bool inside = part.cell->kind == RayCells::Kind::inside;
            if (ray.sign_known && inside != ray.inside) return doubt(i);
            ray.sign_known = true;
            ray.inside = inside;
            ray.evaluated = false;
            ray.clear_to = end;
            continue;
        }
        if (!ray.evaluated) {
            if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
            ray.trial = ray.clear_to;
            return;
        }
        ray.bend = std::max(ray.bend, part.cell->bend);
        const double sign = ray.inside ? -1.0 : 1.0;
        const RootBounds bounds = root_bounds(std::abs(ray.value), sign * ray.slope, ray.bend);
        if (ray.at + bounds.possible >= end) {
            ray.clear_to = end;
            continue;
        }
        if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
        if (ray.at + bounds.certain <= end && !may_refine(i)) return;
        return choose_step(ray, bounds, end);
    }
    end_with(i, ray.hits > 0 ? RayStatus::hit : RayStatus::miss);
}

// Returns whether there is room for another hit; if not, ends the ray.
bool RaySearch::may_refine(std::size_t i) noexcept {
    if (rays_[i].hits < settings_.maximum_hits) return true;
    end_with(i, RayStatus::truncated);
    return false;
}

// Steps to the first possible root, or begins to refine if a root is certain before `end`.
void RaySearch::choose_step(SearchRay& ray, const RootBounds& bounds, double end) noexcept {
    const double possible = std::max(ray.clear_to, ray.at + bounds.possible);
    const double certain = ray.at + bounds.certain;
    if (certain > end) {
        ray.clear_to = possible;
        ray.trial = std::min(ray.range.end, std::max(possible, ray.at + smallest_step_));
        return;
    }
    const double margin = tolerance_ + 2.0 * value_error_ / std::abs(ray.slope);
    ray.low = possible - margin;
    ray.high = certain + margin;
    ray.change = std::numeric_limits<double>::infinity();
    ray.trial = std::clamp(ray.at - ray.value / ray.slope, ray.low, ray.high);
    ray.proved = false;
    ray.phase = SearchRay::Phase::refine;
}

// Returns whether the bound on the second derivative is too small between the last evaluation and the trial.
bool RaySearch::contradicts(const SearchRay& ray, double f, double slope) const noexcept {
    const double step = ray.trial - ray.at;
    if (step <= smallest_step_ * search_slack) return false;
    const double bent = ray.bend * step * search_slack;
    return std::abs(f - ray.value - step * ray.slope) > 0.5 * bent * step + 2.0 * value_error_ + step * slope_error_ ||
           std::abs(slope - ray.slope) > bent + 2.0 * slope_error_;
}

void RaySearch::take_step(std::size_t i, double f, double slope) noexcept {
    SearchRay& ray = rays_[i];
    if (!count_evaluation(i, std::isfinite(f) && std::isfinite(slope))) return;
    const bool inside = f < 0.0;
    if (!ray.sign_known) {
        ray.sign_known = true;
        ray.inside = inside;
    }
    if (ray.evaluated && contradicts(ray, f, slope)) return doubt(i);
    if (inside == ray.inside) return continue_from(i, ray.trial, f, slope);
    if (!ray.evaluated || ray.trial <= ray.clear_to) return doubt(i); // a root was missed
    if (!may_refine(i)) return;
    ray.low = ray.clear_to;
    ray.high = ray.trial;
    ray.change = ray.high - ray.low;
    const double newton = ray.trial - f / slope;
    ray.trial = newton > ray.low && newton < ray.high ? newton : 0.5 * (ray.low + ray.high);
    ray.proved = true;
    ray.phase = SearchRay::Phase::refine;
}

// Continues the search after an evaluation or a root.
void RaySearch::continue_from(std::size_t i, double s, double f, double slope) noexcept {
    SearchRay& ray = rays_[i];
    ray.at = ray.clear_to = s;
    ray.value = f;
    ray.slope = slope;
    ray.bend = 0.0;
    ray.evaluated = true;
    search_on(i);
}

void RaySearch::take_root(std::size_t i, double f, const glm::dvec3& g) {
    SearchRay& ray = rays_[i];
    if (!count_evaluation(i, std::isfinite(f) && std::isfinite(glm::length(g)))) return;
    const bool other = (f < 0.0) != ray.inside;
    ray.proved = ray.proved || other;
    (other ? ray.high : ray.low) = ray.trial;
    const double newton = ray.trial - f / glm::dot(g, ray.range.direction); // NaN or infinite if the slope is 0
    const bool within = newton >= ray.low && newton <= ray.high;
    const double change = std::abs(newton - ray.trial);
    if (within && change <= tolerance_) return root(i, newton, g);
    const double middle = 0.5 * (ray.low + ray.high);
    const double next = within && change <= 0.5 * ray.change ? newton : middle;
    if (ray.high - ray.low <= tolerance_ || next == ray.trial) return ray.proved ? root(i, ray.trial, g) : doubt(i);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    ray.change = std::abs(next - ray.trial);
    ray.trial = next;
}

// Takes a root of the prepared values, which are exact enough unless the ray is nearly tangent to the surface.
void RaySearch::root(std::size_t i, double s, const glm::dvec3& g) {
    SearchRay& ray = rays_[i];
    if (measured_error_ <= tolerance_ * std::abs(glm::dot(g, ray.range.direction))) return hit(i, s, g);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    ray.trial = s;
    ray.change = std::numeric_limits<double>::infinity();
    ray.phase = SearchRay::Phase::finish;
}

// Improves a root with the sum over all centres, as long as the steps become shorter.
void RaySearch::take_exact(std::size_t i, double f, const glm::dvec3& g) {
    SearchRay& ray = rays_[i];
    if (!count_evaluation(i, std::isfinite(f) && std::isfinite(glm::length(g)))) return;
    const double newton = ray.trial - f / glm::dot(g, ray.range.direction);
    const double change = std::abs(newton - ray.trial);
    if (change <= tolerance_) return hit(i, newton, g);
    if (!(change <= 0.5 * ray.change) || change > smallest_step_) return doubt(i);
    if (ray.evaluations >= settings_.evaluation_limit) return end_with(i, RayStatus::evaluation_limit);
    ray.change = change;
    ray.trial = newton;
}

void RaySearch::hit(std::size_t i, double s, const glm::dvec3& g) {
    SearchRay& ray = rays_[i];
    const bool contained = implicit_.contains(ray.range.at(s), g); // false where the surface was trimmed
    if (contained)
        store_hit(hits_, settings_, begin_ + static_cast<std::int64_t>(i), ray.hits++, ray.range, s, g, !ray.inside);
    ray.inside = !ray.inside;
    if (contained && settings_.maximum_hits == 1) return end_with(i, RayStatus::hit);
    continue_from(i, s, 0.0, glm::dot(g, ray.range.direction));
}

// Collects the places to evaluate, cell by cell. Returns their number.
std::size_t RaySearch::pack(bool finishing) noexcept {
    std::size_t count = 0;
    for (std::size_t k = 0; k < active_count_; ++k) {
        const SearchRay& ray = rays_[active_[k]];
        if (ray.phase == SearchRay::Phase::done || (ray.phase == SearchRay::Phase::finish) != finishing) continue;
        const std::int64_t cell = finishing ? 0 : cells_.prepared().cell_of(ray.range.at(ray.trial));
        keys_[count++] = cell * RayTuning::batch + static_cast<std::int64_t>(active_[k]);
    }
    std::sort(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k) {
        const SearchRay& ray = rays_[static_cast<std::size_t>(keys_[k] % RayTuning::batch)];
        const glm::dvec3 p = ray.range.at(ray.trial);
        x_[k] = p.x;
        y_[k] = p.y;
        z_[k] = p.z;
    }
    return count;
}

// Evaluates f and its gradient for all rays that are searching or refining, or for those that are finishing.
void RaySearch::advance(bool finishing, const base::Progress& progress) {
    const std::size_t count = pack(finishing);
    if (count == 0) return;
    implicit::FieldBatch fields;
    fields.value = f_.data();
    fields.gradient = {gx_.data(), gy_.data(), gz_.data()};
    const implicit::PointBatch points{x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(count)};
    for (std::int64_t from = 0; from < points.count; from += implicit::batch_size) {
        progress.check();
        const std::int64_t to = std::min(points.count, from + implicit::batch_size);
        if (finishing)
            implicit_.evaluate(implicit::slice(points, from, to), fields.from(from));
        else
            cells_.prepared().evaluate(implicit::slice(points, from, to), fields.from(from));
    }
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(keys_[k] % RayTuning::batch);
        const glm::dvec3 g(gx_[k], gy_[k], gz_[k]);
        if (finishing)
            take_exact(i, f_[k], g);
        else if (rays_[i].phase == SearchRay::Phase::refine)
            take_root(i, f_[k], g);
        else
            take_step(i, f_[k], glm::dot(g, rays_[i].range.direction));
    }
}

void RaySearch::run(const base::Work& work, const Rays& rays, std::int64_t begin, std::int64_t end) {
    begin_ = begin;
    doubted_count_ = 0;
    clear(hits_, settings_, begin, end);
    active_count_ = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(end - begin); ++i) {
        begin_ray(i, rays);
        if (rays_[i].phase != SearchRay::Phase::done) active_[active_count_++] = i;
    }
    while (active_count_ > 0) {
        advance(false, work);
        advance(true, work);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < active_count_; ++k)
            if (rays_[active_[k]].phase != SearchRay::Phase::done) active_[kept++] = active_[k];
        active_count_ = kept;
    }
    march_rays(work, implicit_, settings_, cells_.lipschitz(), rays, doubted_.data(), doubted_count_, hits_);
}

} // namespace

void cast_rays(const base::Work& work, const RayCells& cells, const implicit::Implicit& implicit,
               const RaySettings& settings, const Rays& rays, RayHits& hits) {
    const std::int64_t count = rays.origin.size();
    resize(hits, count, settings);
    std::atomic<std::int64_t> done{0};
    work.for_chunks(count, RayTuning::batch, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<RaySearch> search(work.memory, cells, implicit, settings, hits);
        search->run(work.without_progress(), rays, begin, end);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::surface
