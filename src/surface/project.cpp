// SPDX-License-Identifier: MIT
#include "surface/project.h"

#include "implicit/evaluate_all.h"
#include "surface/project_creases.h"
#include "surface/project_search.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace hrbfnpr::surface {
namespace {

constexpr std::int64_t projected_at_once = implicit::batch_size;
using Column = std::array<double, static_cast<std::size_t>(projected_at_once)>;

// The smallest trial step, as a share of the Newton step. A shorter step would change a point only by rounding.
constexpr double smallest_share = 1e-14;

// Steepest descent on phi = f^2, whose gradient is 2 f g with g = grad f:
//
//   x_new = x - t grad phi = x - t 2 f g.
//
// Newton's step on f along g ends at x - f g / |g|^2, so its t is t0 = 1 / (2 |g|^2). Trials are t = s t0 with s = 1,
// b, b^2 and so on, where b = armijo_factor.
//
// Armijo's rule accepts the first trial with
//
//   phi(x_new) <= phi(x) - sigma t |grad phi|^2 = f^2 - sigma (s / (2 |g|^2)) 4 f^2 |g|^2 = f^2 (1 - 2 sigma s).
class ProjectedBatch {
public:
    // `order` is the order in which points are processed. Null: the given order.
    ProjectedBatch(const implicit::Implicit& implicit, const ProjectionSettings& settings,
                   const std::int32_t* order) noexcept
        : implicit_(implicit), settings_(settings), order_(order), diagonal_(implicit.diagonal()),
          centre_(implicit.bounds().centre()) {}

    void run(Projection& points, std::int64_t begin, std::int64_t end, const base::Progress& progress);

private:
    void choose_trial(std::size_t i) noexcept;
    void evaluate(const base::Progress& progress);
    [[nodiscard]] bool take_trial(Projection& points, std::size_t lane) noexcept;
    [[nodiscard]] bool finished(Projection& points, std::size_t i) noexcept;
    void end_with(Projection& points, std::size_t i, ProjectionStatus status) noexcept;

    [[nodiscard]] std::int64_t index(std::size_t i) const noexcept {
        const std::int64_t at = begin_ + static_cast<std::int64_t>(i);
        return order_ != nullptr ? order_[at] : at;
    }
    // Returns whether f and its gradient can be used. A gradient that is too long counts as infinite.
    [[nodiscard]] static bool finite(double f, const glm::dvec3& g) noexcept {
        const double slope = glm::length(g);
        return std::isfinite(f) && (is_usable_slope(slope) || slope < 1.0);
    }
    // Returns whether Armijo's rule f^2 <= v^2 part holds. It compares ratios where a square would overflow or
    // underflow.
    [[nodiscard]] static bool satisfies_armijo(double f, double v, double part) noexcept {
        const double square = v * v;
        if (square >= 1e-280 && square <= 1e280) return f * f <= square * part;
        return (f / v) * (f / v) <= part;
    }

    const implicit::Implicit& implicit_;
    const ProjectionSettings& settings_;
    const std::int32_t* order_;
    double diagonal_;
    glm::dvec3 centre_;
    std::int64_t begin_ = 0;

    // The current iterate of each point of the batch.
    std::array<glm::dvec3, static_cast<std::size_t>(projected_at_once)> position_;
    std::array<glm::dvec3, static_cast<std::size_t>(projected_at_once)> gradient_;
    std::array<glm::dvec3, static_cast<std::size_t>(projected_at_once)> trial_;
    Column value_;
    Column share_; // s of the next trial; 0 before the first evaluation
    std::array<std::int32_t, static_cast<std::size_t>(projected_at_once)> evaluations_;

    // The indices of the points that still move, and the values evaluated for them.
    std::array<std::size_t, static_cast<std::size_t>(projected_at_once)> active_;
    std::size_t active_count_ = 0;
    Column x_, y_, z_, f_, gx_, gy_, gz_;
};

void ProjectedBatch::end_with(Projection& points, std::size_t i, ProjectionStatus status) noexcept {
    const std::int64_t at = index(i);
    points.position.set(at, position_[i]);
    points.gradient.set(at, gradient_[i]);
    points.status[at] = status;
}

// Ends the search at a new iterate, or chooses the first trial from it. Returns whether the search ended.
bool ProjectedBatch::finished(Projection& points, std::size_t i) noexcept {
    const double slope = glm::length(gradient_[i]);
    if (!is_usable_slope(slope)) {
        end_with(points, i, ProjectionStatus::zero_gradient);
        return true;
    }
    if (std::abs(value_[i]) <= settings_.tolerance * diagonal_ * slope) {
        end_with(points, i, ProjectionStatus::converged);
        return true;
    }
    // Near a critical point of f the Newton step may be arbitrarily long. But the surface is at most this far away, and
    // f need not be defined beyond.
    const double longest = diagonal_ + glm::length(position_[i] - centre_);
    const double newton = std::abs(value_[i]) / slope;
    share_[i] = newton > longest ? longest / newton : 1.0;
    return false;
}

void ProjectedBatch::choose_trial(std::size_t i) noexcept {
    const glm::dvec3 g = gradient_[i];
    trial_[i] = position_[i] - (share_[i] * value_[i] / glm::dot(g, g)) * g;
}

void ProjectedBatch::evaluate(const base::Progress& progress) {
    progress.check();
    for (std::size_t lane = 0; lane < active_count_; ++lane) {
        const glm::dvec3& p = trial_[active_[lane]];
        x_[lane] = p.x;
        y_[lane] = p.y;
        z_[lane] = p.z;
    }
    implicit::FieldBatch fields;
    fields.value = f_.data();
    fields.gradient = {gx_.data(), gy_.data(), gz_.data()};
    implicit_.evaluate({x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(active_count_)}, fields);
}

// Accepts or rejects the evaluated trial of a lane. Returns whether the search continues for the point.
bool ProjectedBatch::take_trial(Projection& points, std::size_t lane) noexcept {
    const std::size_t i = active_[lane];
    const double f = f_[lane];
    const glm::dvec3 g(gx_[lane], gy_[lane], gz_[lane]);
    const bool first = evaluations_[i]++ == 0;
    const bool ok = finite(f, g);
    const bool accepted =
        first || (ok && satisfies_armijo(f, value_[i], 1.0 - 2.0 * settings_.armijo_slope * share_[i]));
    if (accepted) {
        position_[i] = trial_[i];
        gradient_[i] = g;
        value_[i] = f;
        if (!ok) {
            end_with(points, i, ProjectionStatus::not_finite);
            return false;
        }
        if (finished(points, i)) return false;
    } else {
        share_[i] *= settings_.armijo_factor;
    }
    if (evaluations_[i] >= settings_.evaluation_limit || share_[i] < smallest_share) {
        end_with(points, i, ProjectionStatus::not_converged);
        return false;
    }
    choose_trial(i);
    return true;
}

void ProjectedBatch::run(Projection& points, std::int64_t begin, std::int64_t end, const base::Progress& progress) {
    begin_ = begin;
    active_count_ = static_cast<std::size_t>(end - begin);
    for (std::size_t i = 0; i < active_count_; ++i) {
        trial_[i] = points.position[index(i)];
        evaluations_[i] = 0;
        share_[i] = 1.0;
        active_[i] = i;
    }
    while (active_count_ > 0) {
        evaluate(progress);
        std::size_t kept = 0;
        for (std::size_t lane = 0; lane < active_count_; ++lane)
            if (take_trial(points, lane)) active_[kept++] = active_[lane];
        active_count_ = kept;
    }
}

} // namespace

void project(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
             Projection& points) {
    const std::int64_t count = points.position.size();
    points.gradient.resize(count);
    points.status.resize(count);
    const base::Array<std::int32_t> order = implicit::order_by_cell(work, implicit, points.position);
    std::atomic<std::int64_t> done{0};
    implicit.threads(work).for_chunks(count, projected_at_once, [&](std::int64_t begin, std::int64_t end) {
        base::OwnedObject<ProjectedBatch> batch(work.memory, implicit, settings, order.data());
        batch->run(points, begin, end, work);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        work.update(static_cast<double>(now) / static_cast<double>(count));
    });
    if (implicit.sheets() != nullptr) project_onto_creases(work, implicit, settings, points);
    if (implicit.sheets() != nullptr || implicit.lipschitz() > 0.0) project_by_search(work, implicit, settings, points);
}

} // namespace hrbfnpr::surface
