// SPDX-License-Identifier: MIT
#include "hatching/stripe_vertices.h"

#include "hatching/vertex_links.h"

#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"
#include "surface/creased.h"

#include <cmath>
#include <numbers>

namespace hrbfnpr::hatching {
namespace {

// In spacings: so far samples have a say.
constexpr double influence = 2.0;
// Samples on other sheets: their normals differ by more, or they lie farther beside the tangent plane, in distances.
constexpr double least_vertex_cosine = 0.3;
constexpr double steepest_vertex = 0.6;
constexpr std::int64_t vertices_a_task = 2048;
// Rounds: of plain means, as for samples, and all.
constexpr int vertex_means = 20;
constexpr int vertex_averages = 40;

struct Heard {
    std::int64_t sample;
    double weight;
    bool turned = false;
    Complex factor{1.0}; // from the sample's wave to what that means here
};

class Interpolator {
public:
    Interpolator(const LineSamples& samples, const SampleWaves& waves, const base::Array<std::int32_t>& sheets,
                 const geometry::PointGrid& grid, const geometry::VecArray& places, base::Memory& memory) noexcept
        : samples_(samples), waves_(waves), sheets_(sheets), grid_(grid), places_(places), heard_(memory) {}

    void at(const curves::SurfaceMesh& mesh, std::int64_t vertex, StripeVertices& out) {
        const glm::dvec3 p = mesh.position[vertex];
        const glm::dvec3 n = glm::normalize(mesh.gradient[vertex]);
        listen(p, n, sheets_.empty() ? 0 : sheets_[vertex]);
        const glm::dvec3 along = line(n);
        if (glm::dot(along, along) == 0.0) return;
        const glm::dvec3 across = glm::cross(n, along);
        out.along.set(vertex, along);
        out.across.set(vertex, across);
        hear_coarsest(p, along, across);
        for (std::int64_t level = 0; level < waves_.levels(); ++level) {
            if (level > 0) halve();
            out.wave[level][vertex] = wave(level);
        }
    }

private:
    void listen(const glm::dvec3& p, const glm::dvec3& n, std::int32_t sheet) {
        const SampleGraph& graph = samples_.graph;
        const double radius = influence * graph.spacing;
        heard_.clear();
        sum_ = 0.0;
        grid_.around(p, [&](std::int64_t at) {
            const glm::dvec3 way = p - places_[at];
            const double squared = glm::dot(way, way);
            if (!(squared < radius * radius)) return;
            const std::int64_t i = grid_.index(at);
            if (!(glm::dot(graph.normal[i], n) > least_vertex_cosine)) return;
            if (!sheets_.empty() && surface::is_creased(sheet, graph.sheet[i], n, graph.normal[i])) return;
            const double height = glm::dot(way, n);
            if (height * height > steepest_vertex * steepest_vertex * squared) return;
            const double rest = 1.0 - squared / (radius * radius);
            heard_.push_back({.sample = i, .weight = rest * rest});
            sum_ += rest * rest;
        });
    }
    // A line has no sign: angles are doubled before they are added.
    [[nodiscard]] glm::dvec3 line(const glm::dvec3& n) const noexcept {
        const glm::dvec3 u = geometry::any_perpendicular(n);
        const glm::dvec3 v = glm::cross(n, u);
        Complex sum(0.0);
        for (const Heard& h : heard_) {
            const glm::dvec3 t = samples_.along[h.sample];
            const Complex z(glm::dot(t, u), glm::dot(t, v));
            sum += h.weight * product(z, z);
        }
        if (!(quick_size(sum) > 1e-3 * sum_) || !(sum_ > 0.0)) return glm::dvec3(0.0);
        const double angle = 0.5 * std::arg(sum);
        return std::cos(angle) * u + std::sin(angle) * v;
    }
    void hear_coarsest(const glm::dvec3& p, const glm::dvec3& along, const glm::dvec3& across) noexcept {
        const SampleGraph& graph = samples_.graph;
        const double frequency = 2.0 * std::numbers::pi / waves_.period;
        for (Heard& h : heard_) {
            const glm::dvec3 there = glm::cross(graph.normal[h.sample], samples_.along[h.sample]);
            h.turned = glm::dot(along, samples_.along[h.sample]) < 0.0;
            const glm::dvec3 mean = 0.5 * (across + (h.turned ? -there : there));
            h.factor = std::polar(1.0, frequency * glm::dot(p - graph.position[h.sample], mean));
        }
    }
    // The next level's period is half of this one's.
    void halve() noexcept {
        for (Heard& h : heard_) h.factor = product(h.factor, h.factor);
    }
    [[nodiscard]] Complex wave(std::int64_t level) const noexcept {
        Complex sum(0.0);
        for (const Heard& h : heard_)
            sum += h.weight * product(h.factor, seen(waves_.phases[level][h.sample], h.turned));
        return sum / sum_;
    }

    const LineSamples& samples_;
    const SampleWaves& waves_;
    const base::Array<std::int32_t>& sheets_;
    const geometry::PointGrid& grid_;
    const geometry::VecArray& places_; // of the samples, in the grid's order
    base::Array<Heard> heard_;
    double sum_ = 0.0;
};

} // namespace

StripeVertices::StripeVertices(const base::Runtime& runtime, const LineSamples& samples, const SampleWaves& waves,
                               const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets,
                               const base::Progress& progress)
    : position(mesh.position), across(runtime.memory, mesh.vertices()), along(runtime.memory, mesh.vertices()),
      wave(runtime.memory) {
    for (std::int64_t level = 0; level < waves.levels(); ++level) wave.add(runtime.memory, mesh.vertices());
    const geometry::PointGrid grid(samples.graph.position, influence * samples.graph.spacing, progress);
    const geometry::VecArray places = grid.in_order(samples.graph.position, progress);
    runtime.parallel.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        Interpolator interpolator(samples, waves, sheets, grid, places, runtime.memory);
        for (std::int64_t v = begin; v < end; ++v) {
            if (v % 128 == 0) progress.check();
            interpolator.at(mesh, v, *this);
        }
    });
}

namespace {

// For waves of this period.
WaveLinks link_vertices(const base::Runtime& runtime, const StripeVertices& vertices, const VertexLinks& links,
                        double period, const base::Progress& progress) {
    return {runtime, links.first, progress, [&](std::int64_t v) {
                const auto from = static_cast<std::int32_t>(v);
                return [&vertices, &links, period, from](std::int64_t k) -> WaveLink {
                    const bool turned = vertices.turned(from, links.to[k]);
                    const double growth = vertices.growth(from, links.to[k], turned, period);
                    return {std::polar(1.0, -growth), links.to[k], turned ? -1.0F : 1.0F};
                };
            }};
}

Complex unit_phase(const Complex& z) noexcept {
    const double size = quick_size(z);
    return size > 0.0 ? z / size : z;
}

} // namespace

void StripeVertices::refine(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, double period, int halvings,
                            const base::Progress& progress) {
    if (halvings <= 0) return;
    const VertexLinks links(runtime.memory, mesh);
    WaveLinks waves = link_vertices(runtime, *this, links, period, progress);
    base::Array<Complex> next(runtime.memory, mesh.vertices());
    for (int halving = 1; halving <= halvings; ++halving) {
        waves.halve(runtime, progress);
        base::Array<Complex> z(runtime.memory, mesh.vertices());
        const base::Array<Complex>& before = wave[wave.size() - 1];
        progress.check();
        runtime.parallel.for_chunks(z.size(), vertices_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t v = begin; v < end; ++v) z[v] = unit_phase(product(before[v], before[v]));
        });
        for (int round = 0; round <= vertex_averages; ++round) {
            progress.check();
            runtime.parallel.for_chunks(z.size(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
                progress.check();
                for (std::int64_t v = begin; v < end; ++v) {
                    const bool plain = round < vertex_means || round == vertex_averages;
                    next[v] = plain ? waves.mean(v, z) : unit_phase(waves.around(v, z) + z[v]);
                }
            });
            std::swap(next, z);
        }
        wave.add(std::move(z));
    }
}

double StripeVertices::growth(std::int32_t a, std::int32_t b, bool is_turned, double period) const noexcept {
    const glm::dvec3 there = across[b];
    const glm::dvec3 mean = 0.5 * (across[a] + (is_turned ? -there : there));
    return 2.0 * std::numbers::pi / period * glm::dot(position[b] - position[a], mean);
}

} // namespace hrbfnpr::hatching
