// SPDX-License-Identifier: MIT
#include "fit/product.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t targets_a_task = 128; // The sums of this many targets stay in the first-level cache.

// The number of consecutive samples in a box. Either all of them are within reach of a target, or they are skipped. It
// is small, because consecutive samples of the caller need not be close together.
constexpr std::int64_t box_samples = 32;

// Returns the distance beyond which the kernel and its derivatives are 0, or below a double's rounding.
[[nodiscard]] double reach(const HermiteSystem::Options& options) noexcept {
    switch (options.kernel) {
    case kernel::Kind::wendland_c2: return options.radius;
    case kernel::Kind::gaussian: return 9.5 * options.radius;
    case kernel::Kind::triharmonic: break;
    }
    return HUGE_VAL;
}

[[nodiscard]] double squared_distance(const geometry::Bounds& a, const geometry::Bounds& b) noexcept {
    const glm::dvec3 gap = glm::max(glm::max(a.min - b.max, b.min - a.max), glm::dvec3(0.0));
    return glm::dot(gap, gap);
}

// From this number of samples on, the fast sum is faster than the sum over all pairs (scripts/bench fit).
constexpr std::int64_t far_field_from = 40000;

// The largest number of times that the accuracy can be refined. At a higher accuracy, summing all pairs is faster.
constexpr int finest = 4;

} // namespace

HermiteProduct::HermiteProduct(const base::Work& work, const geometry::VecArray& position,
                               const HermiteSystem::Options& options, double tolerance)
    : runtime_(work), position_(position), options_(options), alpha_(work.memory, position.size()),
      beta_(work.memory, position.size()), value_(work.memory, position.size()),
      gradient_(work.memory, position.size()), boxes_(work.memory) {
    make_boxes();
    far_options_.tolerance = tolerance;
    if (options.kernel == kernel::Kind::triharmonic && position.size() >= far_field_from) make_far_field(work);
}

void HermiteProduct::make_boxes() {
    boxes_.reserve((position_.size() + box_samples - 1) / box_samples);
    for (std::int64_t begin = 0; begin < position_.size(); begin += box_samples) {
        geometry::Bounds box;
        for (std::int64_t i = begin; i < std::min(position_.size(), begin + box_samples); ++i) box.extend(position_[i]);
        boxes_.push_back(box);
    }
}

// Calls sum(begin, end) for each run of consecutive samples that is within reach of a box.
template <class Sum>
void HermiteProduct::for_runs_in_reach(const geometry::Bounds& box, const Sum& sum) const {
    const double limit = reach(options_) * reach(options_);
    const auto in_reach = [&](std::int64_t k) { return squared_distance(box, boxes_[k]) <= limit; };
    for (std::int64_t k = 0; k < boxes_.size(); ++k) {
        if (!in_reach(k)) continue;
        const std::int64_t first = k;
        while (k + 1 < boxes_.size() && in_reach(k + 1)) ++k;
        sum(first * box_samples, std::min(position_.size(), (k + 1) * box_samples));
    }
}

void HermiteProduct::make_far_field(const base::Progress& progress) {
    far_.reset();
    far_ = std::make_unique<implicit::FarField>(base::Work(runtime_, progress), position_, far_options_);
}

bool HermiteProduct::refine(const base::Progress& progress) {
    if (far_ == nullptr || far_options_.finer >= finest) return false;
    ++far_options_.finer;
    make_far_field(progress);
    return true;
}

void HermiteProduct::load(const double* x) noexcept {
    for (std::int64_t i = 0; i < position_.size(); ++i) {
        alpha_[i] = x[4 * i];
        beta_.set(i, {x[4 * i + 1], x[4 * i + 2], x[4 * i + 3]});
    }
}

void HermiteProduct::multiply(const double* x, double* y, const base::Progress& progress) {
    load(x);
    if (far_ != nullptr)
        far_->sum(alpha_.data(), beta_, value_.data(), gradient_, progress);
    else
        sum_directly(position_, value_, gradient_, progress);
    for (std::int64_t i = 0; i < position_.size(); ++i) {
        y[4 * i] = value_[i];
        for (glm::length_t c = 0; c < 3; ++c) y[4 * i + 1 + c] = gradient_[i][c];
    }
    add_diagonal(x, y);
}

void HermiteProduct::add_diagonal(const double* x, double* y) const noexcept {
    if (options_.value_diagonal == 0.0 && options_.gradient_diagonal == 0.0) return;
    for (std::int64_t i = 0; i < position_.size(); ++i) {
        y[4 * i] += options_.value_diagonal * x[4 * i];
        for (std::int64_t c = 4 * i + 1; c < 4 * i + 4; ++c) y[c] += options_.gradient_diagonal * x[c];
    }
}

base::Array<double> HermiteProduct::multiply_some(const double* x, std::int64_t stride,
                                                  const base::Progress& progress) {
    load(x);
    geometry::VecArray at(runtime_.memory);
    for (std::int64_t i = 0; i < position_.size(); i += stride) at.push_back(position_[i]);
    base::Array<double> value(runtime_.memory, at.size());
    geometry::VecArray gradient(runtime_.memory, at.size());
    sum_directly(at, value, gradient, progress);
    base::Array<double> result(runtime_.memory, 4 * at.size());
    for (std::int64_t k = 0; k < at.size(); ++k) {
        const std::int64_t i = 4 * k * stride;
        result[4 * k] = value[k] + options_.value_diagonal * x[i];
        for (glm::length_t c = 0; c < 3; ++c)
            result[4 * k + 1 + c] = gradient[k][c] + options_.gradient_diagonal * x[i + 1 + c];
    }
    return result;
}

void HermiteProduct::sum_directly(const geometry::VecArray& at, base::Array<double>& value,
                                  geometry::VecArray& gradient, const base::Progress& progress) const {
    const implicit::AddHermiteSums add = implicit::hermite_sums(runtime_.instruction_set, options_.kernel);
    runtime_.parallel.for_chunks(at.size(), targets_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        double* const sums[4] = {value.data() + begin, gradient.x.data() + begin, gradient.y.data() + begin,
                                 gradient.z.data() + begin};
        for (double* const sum : sums) std::fill_n(sum, end - begin, 0.0);
        geometry::Bounds box;
        for (std::int64_t i = begin; i < end; ++i) box.extend(at[i]);
        for_runs_in_reach(box, [&](std::int64_t s, std::int64_t s_end) {
            add(options_.radius,
                {position_.x.data() + s, position_.y.data() + s, position_.z.data() + s, alpha_.data() + s,
                 beta_.x.data() + s, beta_.y.data() + s, beta_.z.data() + s, s_end - s},
                {at.x.data() + begin, at.y.data() + begin, at.z.data() + begin, sums[0], sums[1], sums[2], sums[3],
                 end - begin});
        });
    });
}

std::int64_t HermiteProduct::bytes() const noexcept {
    const std::int64_t own = alpha_.bytes() + beta_.bytes() + value_.bytes() + gradient_.bytes();
    return own + (far_ != nullptr ? far_->bytes() : 0);
}

} // namespace hrbfnpr::fit
