// SPDX-License-Identifier: MIT
#include "hatching/waves.h"

#include "base/random.h"
#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"
#include "hatching/tuning.h"
#include "surface/creased.h"

#include <numbers>
#include <numeric>

namespace hrbfnpr::hatching {
namespace {

constexpr double tau = 2.0 * std::numbers::pi;

Links wave_links(const base::Runtime& runtime, const Graph& graph, const Waves& waves, double period,
                 const base::Progress& progress) {
    return {runtime, graph, progress, [&](std::int64_t i, std::int32_t j) -> Link {
                return {std::polar(1.0, -waves.growth(i, j, period)), j, waves.turned(i, j) ? -1.0F : 1.0F};
            }};
}

// The wave that neighbours agree on most: the eigenvector of the least eigenvalue, by inverse iteration. It lives in a
// few places only; where it is small its phase is right already. It grows by 1 / eigen_shift at most in each step,
// which no number overflows by.
Numbers first_wave(const base::Runtime& runtime, const Links& links, std::uint64_t seed,
                   const base::Progress& progress) {
    const std::int64_t n = links.nodes();
    base::Array<double> diagonal(runtime.memory, n);
    Numbers x(runtime.memory, n);
    for (std::int64_t i = 0; i < n; ++i) {
        diagonal[i] = links.count(i) + hatching_tuning.eigen_shift;
        x[i] = std::polar(1.0, tau * base::uniform4(seed, static_cast<std::uint64_t>(i), base::Purpose::stripes)[0]);
    }
    Numbers next(runtime.memory, n);
    for (int step = 0; step < hatching_tuning.eigen_steps; ++step) {
        for_nodes(runtime, n, progress, [&](std::int64_t i) { next[i] = x[i] / hatching_tuning.eigen_shift; });
        solve(runtime, {1e-3, 200}, links, diagonal, 1.0, x, next, progress);
        std::swap(x, next);
    }
    for_nodes(runtime, n, progress, [&](std::int64_t i) { x[i] = to_unit(x[i]); });
    return x;
}

// The wave of half the period of the links has twice the phase. In plain means it is low where it is squeezed or drawn
// out, so that waves of the right length grow into it from around there, and a fork of two lines becomes two forks;
// among waves of one height none would, and lines would stay too dense or too sparse.
Numbers halved(const base::Runtime& runtime, const Links& links, const Numbers& wave, int means,
               const base::Progress& progress) {
    HRBFNPR_ASSERT(links.nodes() == wave.size());
    Numbers z(runtime.memory, wave.size());
    for_nodes(runtime, z.size(), progress, [&](std::int64_t i) { z[i] = to_unit(product(wave[i], wave[i])); });
    iterate(runtime, means, z, progress, [&](std::int64_t i, const Numbers& now) { return links.mean(i, now); });
    iterate(runtime, hatching_tuning.unit_averages, z, progress,
            [&](std::int64_t i, const Numbers& now) { return to_unit(links.around(i, now) + now[i]); });
    return z;
}

// A sample near a vertex of the mesh.
struct Heard {
    std::int64_t sample;
    double weight;
    bool turned = false;
    Complex factor{1.0}; // the sample's wave, times this, is that wave as seen from the vertex
};

// The line of a vertex from those of the samples around it, unit; 0: it has none. A line has no sign, so that angles
// are doubled before they are added.
glm::dvec3 mean_line(const Waves& samples, const base::Array<Heard>& heard, const glm::dvec3& normal) noexcept {
    const glm::dvec3 u = geometry::any_perpendicular(normal);
    const glm::dvec3 v = glm::cross(normal, u);
    Complex sum(0.0);
    double weights = 0.0;
    for (const Heard& h : heard) {
        const glm::dvec3 t = samples.along[h.sample];
        const Complex z(glm::dot(t, u), glm::dot(t, v));
        sum += h.weight * product(z, z);
        weights += h.weight;
    }
    if (!(magnitude(sum) > 1e-3 * weights)) return glm::dvec3(0.0);
    const double angle = 0.5 * std::arg(sum);
    return std::cos(angle) * u + std::sin(angle) * v;
}

// The line and the waves of a vertex that is there already.
void interpolate(const Waves& samples, base::Array<Heard>& heard, const glm::dvec3& normal, std::int64_t vertex,
                 Waves& result) noexcept {
    const glm::dvec3 line = mean_line(samples, heard, normal);
    if (glm::dot(line, line) == 0.0) return;
    result.set_line(vertex, normal, line);
    double weights = 0.0;
    for (Heard& h : heard) {
        const glm::dvec3 there = samples.across[h.sample];
        h.turned = glm::dot(line, samples.along[h.sample]) < 0.0;
        const glm::dvec3 mean = 0.5 * (result.across[vertex] + (h.turned ? -there : there));
        const glm::dvec3 way = result.position[vertex] - samples.position[h.sample];
        h.factor = std::polar(1.0, tau / samples.period * glm::dot(way, mean));
        weights += h.weight;
    }
    for (std::int64_t level = 0; level < samples.level.size(); ++level) {
        Complex sum(0.0);
        for (Heard& h : heard) {
            if (level > 0) h.factor = product(h.factor, h.factor); // half the period
            sum += h.weight * product(h.factor, seen(samples.level[level][h.sample], h.turned));
        }
        result.level[level][vertex] = sum / weights;
    }
}

Waves interpolated(const base::Runtime& runtime, const SampleGraph& graph, const Waves& samples,
                   const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets,
                   const base::Progress& progress) {
    Waves result(runtime.memory, mesh.position, samples.period);
    for (std::int64_t level = 0; level < samples.level.size(); ++level)
        result.level.add(runtime.memory, mesh.vertices());
    const double radius = hatching_tuning.influence * graph.spacing;
    const geometry::PointGrid grid(graph.position, radius, progress);
    const geometry::VecArray places = grid.in_order(graph.position, progress);
    runtime.parallel.for_chunks(mesh.vertices(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<Heard> heard(runtime.memory);
        for (std::int64_t v = begin; v < end; ++v) {
            if (v % 128 == 0) progress.check();
            const glm::dvec3 p = mesh.position[v];
            const glm::dvec3 n = glm::normalize(mesh.gradient[v]);
            heard.clear();
            grid.around(p, [&](std::int64_t at) {
                const glm::dvec3 way = p - places[at];
                const double squared = glm::dot(way, way);
                if (!(squared < radius * radius)) return;
                const std::int64_t i = grid.index(at);
                const glm::dvec3 there = graph.normal[i];
                if (!(glm::dot(there, n) > hatching_tuning.same_sheet_cosine)) return;
                if (!sheets.empty() && surface::is_creased(sheets[v], graph.sheet[i], n, there)) return;
                const double height = glm::dot(way, n);
                if (height * height > hatching_tuning.steepest * hatching_tuning.steepest * squared) return;
                const double rest = 1.0 - squared / (radius * radius);
                heard.push_back({i, rest * rest});
            });
            interpolate(samples, heard, n, v, result);
        }
    });
    return result;
}

// Both ends of each edge are neighbours; at a border one of them has the other only.
Graph graph_of(base::Memory& memory, const curves::SurfaceMesh& mesh) {
    Graph graph(memory);
    graph.first.resize(mesh.vertices() + 1);
    graph.neighbour.resize(mesh.corner.size());
    for (const std::int32_t v : mesh.corner) ++graph.first[v];
    std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
    for (std::int64_t edge = mesh.corner.size() - 1; edge >= 0; --edge)
        graph.neighbour[--graph.first[mesh.corner[edge]]] = mesh.corner[edge - edge % 3 + (edge % 3 + 1) % 3];
    return graph;
}

} // namespace

double Waves::growth(std::int64_t a, std::int64_t b, double wave_period) const noexcept {
    const glm::dvec3 there = across[b];
    const glm::dvec3 mean = 0.5 * (across[a] + (turned(a, b) ? -there : there));
    return tau / wave_period * glm::dot(position[b] - position[a], mean);
}

void add_sample_waves(const base::Runtime& runtime, const SampleGraph& graph, std::uint64_t seed, int levels,
                      Waves& samples, const base::Progress& progress) {
    HRBFNPR_ASSERT(samples.along.size() == graph.nodes() && samples.level.empty() && samples.period > 0.0);
    Links links = wave_links(runtime, graph, samples, samples.period, progress);
    samples.level.add(first_wave(runtime, links, seed, progress));
    const double finest = hatching_tuning.finest_period * graph.spacing;
    while (samples.finest() < levels && samples.period_of(samples.finest() + 1) >= finest) {
        links.halve_period(runtime, progress);
        samples.level.add(halved(runtime, links, samples.level.back(), hatching_tuning.sample_means, progress));
    }
}

Waves waves_at_vertices(const base::Runtime& runtime, const SampleGraph& graph, const Waves& samples,
                        const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets, int levels,
                        const base::Progress& progress) {
    HRBFNPR_ASSERT(!samples.level.empty());
    HRBFNPR_ASSERT(sheets.empty() || (sheets.size() == mesh.vertices() && graph.sheet.size() == graph.nodes()));
    Waves waves = interpolated(runtime, graph, samples, mesh, sheets, progress.part(0.0, 0.5));
    const auto is_next_known = [&] { return waves.period_of(waves.finest() + 1) >= mesh.side; };
    if (waves.finest() >= levels || !is_next_known()) return waves;
    const Graph edges = graph_of(runtime.memory, mesh);
    Links links = wave_links(runtime, edges, waves, waves.period_of(waves.finest()), progress);
    while (waves.finest() < levels && is_next_known()) {
        links.halve_period(runtime, progress);
        waves.level.add(halved(runtime, links, waves.level.back(), hatching_tuning.vertex_means, progress));
    }
    return waves;
}

} // namespace hrbfnpr::hatching
