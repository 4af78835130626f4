// SPDX-License-Identifier: MIT
#include "orient/descend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr int memory_pairs = 6;
constexpr double armijo = 1e-4;
constexpr int most_halvings = 12;
constexpr double longest_turn = 0.5; // of a step, about radians
constexpr std::int64_t rows_a_task = 4096;

class Descent {
public:
    Descent(const base::Runtime& runtime, const Energy& energy, const base::Array<double>& stiffness,
            geometry::VecArray& normal)
        : runtime_(runtime), energy_(energy), stiffness_(stiffness), normal_(normal), size_(normal.size()),
          gradient_(runtime.memory, size_), next_(runtime.memory, size_), next_gradient_(runtime.memory, size_),
          direction_(runtime.memory, size_), part_(runtime.memory, (size_ + rows_a_task - 1) / rows_a_task) {
        for (int k = 0; k < memory_pairs; ++k) {
            step_.emplace_back(runtime.memory, size_);
            change_.emplace_back(runtime.memory, size_);
        }
        value_ = evaluate(normal_, gradient_);
    }

    [[nodiscard]] double value() const noexcept { return value_; }

    // False if no step lowers the energy.
    bool step() {
        find_direction();
        double slope = dot(direction_, gradient_);
        if (!(slope < 0.0)) {
            pairs_ = 0;
            find_direction();
            slope = dot(direction_, gradient_);
            if (!(slope < 0.0)) return false;
        }
        double length = std::min(1.0, longest_turn / largest(direction_));
        for (int halving = 0; halving < most_halvings; ++halving, length *= 0.5) {
            move(length);
            const double value = evaluate(next_, next_gradient_);
            if (!(value <= value_ + armijo * length * slope)) continue;
            remember();
            value_ = value;
            return true;
        }
        if (pairs_ == 0) return false;
        pairs_ = 0; // the curvature that was remembered misleads
        return true;
    }

private:
    template <class F>
    void for_all(F&& f) const {
        runtime_.parallel.for_chunks(size_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) f(i);
        });
    }

    [[nodiscard]] double dot(const VecArray& a, const VecArray& b) {
        runtime_.parallel.for_chunks(size_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
            double sum = 0.0;
            for (std::int64_t i = begin; i < end; ++i) sum += a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
            part_[begin / rows_a_task] = sum;
        });
        double sum = 0.0;
        for (const double p : part_) sum += p;
        return sum;
    }

    [[nodiscard]] double largest(const VecArray& a) {
        runtime_.parallel.for_chunks(size_, rows_a_task, [&](std::int64_t begin, std::int64_t end) {
            double most = 0.0;
            for (std::int64_t i = begin; i < end; ++i) most = std::max(most, glm::dot(a[i], a[i]));
            part_[begin / rows_a_task] = most;
        });
        return std::max(1e-300, std::sqrt(*std::max_element(part_.begin(), part_.end())));
    }

    // The derivative along the spheres.
    double evaluate(const VecArray& normal, VecArray& gradient) const {
        const double value = energy_(normal, gradient);
        for_all([&](std::int64_t i) {
            const glm::dvec3 n = normal[i];
            const glm::dvec3 g = 2.0 * gradient[i];
            gradient.set(i, g - glm::dot(g, n) * n);
        });
        return value;
    }

    void find_direction() {
        for_all([&](std::int64_t i) { direction_.set(i, -gradient_[i]); });
        std::array<double, memory_pairs> along{};
        const int kept = std::min(pairs_, memory_pairs);
        for (int k = 0; k < kept; ++k) {
            const std::size_t at = pair(k);
            along[at] = dot(step_[at], direction_) * inverse_[at];
            for_all([&](std::int64_t i) { direction_.set(i, direction_[i] - along[at] * change_[at][i]); });
        }
        for_all([&](std::int64_t i) { direction_.set(i, direction_[i] * (scale_ / stiffness_[i])); });
        for (int k = kept - 1; k >= 0; --k) {
            const std::size_t at = pair(k);
            const double back = dot(change_[at], direction_) * inverse_[at];
            for_all([&](std::int64_t i) { direction_.set(i, direction_[i] + (along[at] - back) * step_[at][i]); });
        }
        for_all([&](std::int64_t i) {
            const glm::dvec3 n = normal_[i];
            const glm::dvec3 d = direction_[i];
            direction_.set(i, d - glm::dot(d, n) * n);
        });
    }

    // The k-th newest.
    [[nodiscard]] std::size_t pair(int k) const noexcept {
        return static_cast<std::size_t>((pairs_ - 1 - k) % memory_pairs);
    }

    void move(double length) {
        for_all([&](std::int64_t i) { next_.set(i, glm::normalize(normal_[i] + length * direction_[i])); });
    }

    void remember() {
        const auto at = static_cast<std::size_t>(pairs_ % memory_pairs);
        for_all([&](std::int64_t i) {
            const glm::dvec3 n = next_[i];
            const glm::dvec3 s = n - normal_[i];
            const glm::dvec3 y = next_gradient_[i] - gradient_[i];
            step_[at].set(i, s - glm::dot(s, n) * n);
            change_[at].set(i, y - glm::dot(y, n) * n);
            normal_.set(i, n);
        });
        std::swap(gradient_, next_gradient_);
        const double curvature = dot(step_[at], change_[at]);
        if (!(curvature > 0.0)) return;
        inverse_[at] = 1.0 / curvature;
        double scaled = 0.0; // y . H0 y
        for_all([&](std::int64_t i) { next_.set(i, change_[at][i] / stiffness_[i]); });
        scaled = dot(change_[at], next_);
        scale_ = curvature / std::max(scaled, 1e-300);
        ++pairs_;
    }

    const base::Runtime& runtime_;
    const Energy& energy_;
    const base::Array<double>& stiffness_;
    VecArray& normal_;
    std::int64_t size_;
    VecArray gradient_;
    VecArray next_;
    VecArray next_gradient_;
    VecArray direction_;
    base::Array<double> part_;
    std::vector<VecArray> step_;
    std::vector<VecArray> change_;
    std::array<double, memory_pairs> inverse_{};
    int pairs_ = 0;
    double scale_ = 0.5;
    double value_ = 0.0;
};

} // namespace

double descend(const base::Runtime& runtime, const Energy& energy, const base::Array<double>& stiffness,
               const DescentOptions& options, VecArray& normal, const base::Progress& progress) {
    constexpr int looked_back = 5;
    Descent descent(runtime, energy, stiffness, normal);
    double before = descent.value();
    for (int step = 0; step < options.steps; ++step) {
        progress.update(static_cast<double>(step) / options.steps);
        if (!descent.step()) break;
        if (step % looked_back != looked_back - 1) continue;
        if (before - descent.value() < options.enough * before) break;
        before = descent.value();
    }
    return descent.value();
}

} // namespace hrbfnpr::orient
