// SPDX-License-Identifier: MIT
// Conjugate gradients for sparse symmetric positive definite systems over a graph's samples, one complex number each.
// The same bits for any thread count.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "hatching/sample_graph.h"

#include <cmath>

namespace hrbfnpr::hatching {

inline constexpr std::int64_t samples_a_task = 2048;

// Re conj(a) b
[[nodiscard]] inline double inner(const Complex& a, const Complex& b) noexcept {
    return a.real() * b.real() + a.imag() * b.imag();
}

// Sums over samples, the parts of tasks added in their order.
class TaskSums {
public:
    TaskSums(const base::Runtime& runtime, std::int64_t samples)
        : runtime_(runtime), samples_(samples), part_(runtime.memory, (samples + samples_a_task - 1) / samples_a_task) {
    }

    // value(i): sample i's, on whatever thread.
    template <class Value>
    [[nodiscard]] double of(Value&& value) {
        runtime_.parallel.for_chunks(samples_, samples_a_task, [&](std::int64_t begin, std::int64_t end) {
            double sum = 0.0;
            for (std::int64_t i = begin; i < end; ++i) sum += value(i);
            part_[begin / samples_a_task] = sum;
        });
        double all = 0.0;
        for (const double sum : part_) all += sum;
        return all;
    }

private:
    const base::Runtime& runtime_;
    std::int64_t samples_;
    base::Array<double> part_; // of each task
};

// Calls visit(i) once for each sample, concurrently.
template <class Visit>
void for_samples(const base::Runtime& runtime, std::int64_t samples, Visit&& visit) {
    runtime.parallel.for_chunks(samples, samples_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) visit(i);
    });
}

struct SolverSettings {
    double tolerance = 1e-4; // of the residual, against that of 0
    int most_steps = 400;
};

// x: what is begun with, and the solution.  multiply(i, from): row i of the matrix times a vector; it may conjugate:
// what counts is that it is linear over the reals, and symmetric by inner().
template <class Multiply>
void solve(const base::Runtime& runtime, const SolverSettings& settings, const base::Array<Complex>& right,
           base::Array<Complex>& x, const base::Progress& progress, Multiply&& multiply) {
    const std::int64_t n = right.size();
    base::Array<Complex> residual(runtime.memory, n);
    base::Array<Complex> way(runtime.memory, n);
    base::Array<Complex> image(runtime.memory, n);
    TaskSums sums(runtime, n);
    double squared = sums.of([&](std::int64_t i) {
        way[i] = residual[i] = right[i] - multiply(i, x);
        return inner(residual[i], residual[i]);
    });
    const double limit =
        settings.tolerance * settings.tolerance * sums.of([&](std::int64_t i) { return inner(right[i], right[i]); });
    for (int step = 0; step < settings.most_steps && squared > limit; ++step) {
        progress.check();
        const double bend = sums.of([&](std::int64_t i) {
            image[i] = multiply(i, way);
            return inner(way[i], image[i]);
        });
        const double share = squared / bend;
        const double next = sums.of([&](std::int64_t i) {
            x[i] += share * way[i];
            residual[i] -= share * image[i];
            return inner(residual[i], residual[i]);
        });
        const double kept = next / squared;
        for_samples(runtime, n, [&](std::int64_t i) { way[i] = residual[i] + kept * way[i]; });
        squared = next;
    }
}

} // namespace hrbfnpr::hatching
