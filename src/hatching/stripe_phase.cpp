// SPDX-License-Identifier: MIT
#include "hatching/stripe_phase.h"

#include "base/random.h"
#include "hatching/graph_solver.h"

#include <cmath>
#include <numbers>

namespace hrbfnpr::hatching {
namespace {

// Of inverse iteration.  Then the eigenvector lives in a few places only: where it is small its phase is right
// already, and waves of one height average from there.
constexpr int inverse_steps = 12;
constexpr double shift = 0.02;
constexpr int first_averages = 12;
// Rounds of plain means, in which a wave is low where it is squeezed or drawn out, so that waves of the right length
// grow into it from around there and forks appear; with waves of one height none would, and lines would stay too dense
// or too sparse.  Then averages of one height.
constexpr int means = 100;
constexpr int phase_averages = 20;

Complex unit(const Complex& z) noexcept {
    const double size = quick_size(z);
    return size > 0.0 ? z / size : Complex(1.0);
}

void average(const base::Runtime& runtime, const WaveLinks& links, int rounds, Phases& z,
             const base::Progress& progress) {
    Phases next(runtime.memory, z.size());
    for (int round = 0; round < rounds; ++round) {
        progress.check();
        for_samples(runtime, z.size(), [&](std::int64_t i) { next[i] = unit(links.around(i, z) + z[i]); });
        std::swap(next, z);
    }
}

void spread(const base::Runtime& runtime, const WaveLinks& links, int rounds, Phases& z,
            const base::Progress& progress) {
    Phases next(runtime.memory, z.size());
    for (int round = 0; round < rounds; ++round) {
        progress.check();
        for_samples(runtime, z.size(), [&](std::int64_t i) { next[i] = links.mean(i, z); });
        std::swap(next, z);
    }
    for_samples(runtime, z.size(), [&](std::int64_t i) { z[i] = unit(z[i]); });
}

} // namespace

// By how much the phase grows along each link, and whether the lines point to opposite ways.
WaveLinks link_waves(const base::Runtime& runtime, const LineSamples& samples, double period,
                     const base::Progress& progress) {
    const SampleGraph& graph = samples.graph;
    const double frequency = 2.0 * std::numbers::pi / period;
    return {runtime, graph.first, progress, [&](std::int64_t i) {
                const glm::dvec3 across = glm::cross(graph.normal[i], samples.along[i]);
                const double angle = graph.angle(i, samples.along[i]);
                return [&samples, &graph, frequency, i, across, angle](std::int64_t k) -> WaveLink {
                    const std::int32_t j = graph.link[k].to;
                    const double carried = angle + static_cast<double>(graph.link[k].turn);
                    const bool turned = glm::dot(graph.tangent(j, carried), samples.along[j]) < 0.0;
                    const glm::dvec3 there = glm::cross(graph.normal[j], samples.along[j]);
                    const glm::dvec3 mean = 0.5 * (across + (turned ? -there : there));
                    const double growth = frequency * glm::dot(graph.position[j] - graph.position[i], mean);
                    return {std::polar(1.0, -growth), j, turned ? -1.0F : 1.0F};
                };
            }};
}

Phases first_phases(const base::Runtime& runtime, const WaveLinks& links, std::uint64_t seed,
                    const base::Progress& progress) {
    Phases x(runtime.memory, links.places());
    for (std::int64_t i = 0; i < x.size(); ++i)
        x[i] = std::polar(1.0, 2.0 * std::numbers::pi *
                                   base::uniform4(seed, static_cast<std::uint64_t>(i), base::Purpose::stripes)[0]);
    Phases next(runtime.memory, x.size());
    TaskSums sums(runtime, x.size());
    for (int step = 0; step < inverse_steps; ++step) {
        const double squared = sums.of([&](std::int64_t i) { return inner(x[i], x[i]); });
        const double size = std::sqrt(squared / static_cast<double>(x.size()));
        for_samples(runtime, x.size(), [&](std::int64_t i) {
            x[i] /= size;
            next[i] = x[i] / shift;
        });
        solve(runtime, {1e-3, 200}, x, next, progress, [&](std::int64_t i, const base::Array<Complex>& from) {
            return (links.count(i) + shift) * from[i] - links.around(i, from);
        });
        std::swap(x, next);
    }
    for_samples(runtime, x.size(), [&](std::int64_t i) { x[i] = unit(x[i]); });
    average(runtime, links, first_averages, x, progress);
    return x;
}

Phases doubled(const base::Runtime& runtime, const WaveLinks& links, const Phases& phases,
               const base::Progress& progress) {
    Phases z(runtime.memory, phases.size());
    for_samples(runtime, z.size(), [&](std::int64_t i) { z[i] = product(phases[i], phases[i]); });
    spread(runtime, links, means, z, progress);
    average(runtime, links, phase_averages, z, progress);
    return z;
}

} // namespace hrbfnpr::hatching
