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

// Re sum conj(a) b, the parts of tasks added in their order.
[[nodiscard]] double inner(const base::Runtime& runtime, const base::Array<Complex>& a, const base::Array<Complex>& b);

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
    const auto apply = [&](const base::Array<Complex>& from, base::Array<Complex>& to) {
        runtime.parallel.for_chunks(n, samples_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) to[i] = multiply(i, from);
        });
    };
    apply(x, image);
    for (std::int64_t i = 0; i < n; ++i) way[i] = residual[i] = right[i] - image[i];
    double squared = inner(runtime, residual, residual);
    const double limit = settings.tolerance * settings.tolerance * inner(runtime, right, right);
    for (int step = 0; step < settings.most_steps && squared > limit; ++step) {
        progress.check();
        apply(way, image);
        const double share = squared / inner(runtime, way, image);
        for (std::int64_t i = 0; i < n; ++i) {
            x[i] += share * way[i];
            residual[i] -= share * image[i];
        }
        const double next = inner(runtime, residual, residual);
        const double kept = next / squared;
        for (std::int64_t i = 0; i < n; ++i) way[i] = residual[i] + kept * way[i];
        squared = next;
    }
}

} // namespace hrbfnpr::hatching
