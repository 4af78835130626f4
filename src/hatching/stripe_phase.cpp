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

// By how much the phase grows along each link, and whether the lines point to opposite ways.
struct Waves {
    Waves(const base::Runtime& runtime, const LineSamples& samples, double period, const base::Progress& progress)
        : graph(samples.graph), factor(runtime.memory, graph.link.size()), turned(runtime.memory, graph.link.size()) {
        const double frequency = 2.0 * std::numbers::pi / period;
        runtime.parallel.for_chunks(graph.size(), samples_a_task, [&](std::int64_t begin, std::int64_t end) {
            progress.check();
            for (std::int64_t i = begin; i < end; ++i) {
                const glm::dvec3 across = glm::cross(graph.normal[i], samples.along[i]);
                for (std::int64_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
                    const std::int64_t j = graph.link[k].to;
                    const double carried = graph.angle(i, samples.along[i]) + static_cast<double>(graph.link[k].turn);
                    const bool other = glm::dot(graph.tangent(j, carried), samples.along[j]) < 0.0;
                    const glm::dvec3 there = glm::cross(graph.normal[j], samples.along[j]);
                    const glm::dvec3 mean = 0.5 * (across + (other ? -there : there));
                    factor[k] = std::polar(1.0, -frequency * glm::dot(graph.position[j] - graph.position[i], mean));
                    turned[k] = other ? 1 : 0;
                }
            }
        });
    }
    // What the neighbours say of sample i, all together.
    [[nodiscard]] Complex around(std::int64_t i, const base::Array<Complex>& z) const noexcept {
        Complex sum(0.0);
        for (std::int64_t k = graph.first[i]; k < graph.first[i + 1]; ++k)
            sum += product(factor[k], seen(z[graph.link[k].to], turned[k] != 0));
        return sum;
    }

    const SampleGraph& graph;
    base::Array<Complex> factor; // of each link: from what stands at its end to what that means at its begin
    base::Array<std::uint8_t> turned;
};

Complex unit(const Complex& z) noexcept {
    const double size = quick_size(z);
    return size > 0.0 ? z / size : Complex(1.0);
}

void average(const base::Runtime& runtime, const Waves& waves, int rounds, Phases& z, const base::Progress& progress) {
    Phases next(runtime.memory, z.size());
    for (int round = 0; round < rounds; ++round) {
        progress.check();
        runtime.parallel.for_chunks(z.size(), samples_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) next[i] = unit(waves.around(i, z) + z[i]);
        });
        std::swap(next, z);
    }
}

void spread(const base::Runtime& runtime, const Waves& waves, int rounds, Phases& z, const base::Progress& progress) {
    Phases next(runtime.memory, z.size());
    const SampleGraph& graph = waves.graph;
    for (int round = 0; round < rounds; ++round) {
        progress.check();
        runtime.parallel.for_chunks(z.size(), samples_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i)
                next[i] = (waves.around(i, z) + z[i]) / static_cast<double>(1 + graph.first[i + 1] - graph.first[i]);
        });
        std::swap(next, z);
    }
    for (Complex& x : z) x = unit(x);
}

} // namespace

Phases first_phases(const base::Runtime& runtime, const LineSamples& samples, double period, std::uint64_t seed,
                    const base::Progress& progress) {
    const Waves waves(runtime, samples, period, progress);
    const SampleGraph& graph = samples.graph;
    Phases x(runtime.memory, graph.size());
    for (std::int64_t i = 0; i < graph.size(); ++i)
        x[i] = std::polar(1.0, 2.0 * std::numbers::pi *
                                   base::uniform4(seed, static_cast<std::uint64_t>(i), base::Purpose::stripes)[0]);
    Phases next(runtime.memory, graph.size());
    for (int step = 0; step < inverse_steps; ++step) {
        const double size = std::sqrt(inner(runtime, x, x) / static_cast<double>(graph.size()));
        for (Complex& z : x) z /= size;
        for (std::int64_t i = 0; i < graph.size(); ++i) next[i] = x[i] / shift;
        solve(runtime, {1e-3, 200}, x, next, progress, [&](std::int64_t i, const base::Array<Complex>& from) {
            const auto links = static_cast<double>(graph.first[i + 1] - graph.first[i]);
            return (links + shift) * from[i] - waves.around(i, from);
        });
        std::swap(x, next);
    }
    for (Complex& z : x) z = unit(z);
    average(runtime, waves, first_averages, x, progress);
    return x;
}

Phases doubled(const base::Runtime& runtime, const LineSamples& samples, const Phases& phases, double period,
               const base::Progress& progress) {
    const Waves waves(runtime, samples, 0.5 * period, progress);
    Phases z(runtime.memory, phases.size());
    for (std::int64_t i = 0; i < z.size(); ++i) z[i] = product(phases[i], phases[i]);
    spread(runtime, waves, means, z, progress);
    average(runtime, waves, phase_averages, z, progress);
    return z;
}

} // namespace hrbfnpr::hatching
