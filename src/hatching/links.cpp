// SPDX-License-Identifier: MIT
#include "hatching/links.h"

namespace hrbfnpr::hatching {
namespace {

// Adds value(i) up over all nodes: first within each task, then over the tasks in their order.
template <class Value>
double sum_over(const base::Runtime& runtime, std::int64_t nodes, const base::Progress& progress, const Value& value) {
    base::Array<double> part(runtime.memory, (nodes + nodes_a_task - 1) / nodes_a_task);
    runtime.parallel.for_chunks(nodes, nodes_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t i = begin; i < end; ++i) sum += value(i);
        part[begin / nodes_a_task] = sum;
    });
    double all = 0.0;
    for (const double sum : part) all += sum;
    return all;
}

// The real part of conj(a) b.
double inner(const Complex& a, const Complex& b) noexcept { return a.real() * b.real() + a.imag() * b.imag(); }

} // namespace

void solve(const base::Runtime& runtime, const SolverSettings& settings, const Links& links,
           const base::Array<double>& diagonal, double coupling, const Numbers& right, Numbers& x,
           const base::Progress& progress) {
    const std::int64_t n = right.size();
    HRBFNPR_ASSERT(links.nodes() == n && diagonal.size() == n && x.size() == n);
    HRBFNPR_ASSERT(coupling >= 0.0 && settings.tolerance > 0.0);
    const auto row = [&](std::int64_t i, const Numbers& z) {
        return diagonal[i] * z[i] - coupling * links.around(i, z);
    };
    const auto sum = [&](const auto& value) { return sum_over(runtime, n, progress, value); };
    Numbers residual(runtime.memory, n);
    Numbers way(runtime.memory, n);
    Numbers image(runtime.memory, n);
    double squared = sum([&](std::int64_t i) {
        way[i] = residual[i] = right[i] - row(i, x);
        return inner(residual[i], residual[i]);
    });
    const double limit =
        settings.tolerance * settings.tolerance * sum([&](std::int64_t i) { return inner(right[i], right[i]); });
    for (int step = 0; step < settings.most_steps && squared > limit; ++step) {
        const double bend = sum([&](std::int64_t i) {
            image[i] = row(i, way);
            return inner(way[i], image[i]);
        });
        const double share = squared / bend;
        const double next = sum([&](std::int64_t i) {
            x[i] += share * way[i];
            residual[i] -= share * image[i];
            return inner(residual[i], residual[i]);
        });
        const double kept = next / squared;
        for_nodes(runtime, n, progress, [&](std::int64_t i) { way[i] = residual[i] + kept * way[i]; });
        squared = next;
    }
}

} // namespace hrbfnpr::hatching
