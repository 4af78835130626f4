// SPDX-License-Identifier: MIT
// Complex numbers at the nodes of a graph: lines of a field (directions without a sign, as exp(2 i angle)) at even
// samples of the surface, and waves (as exp(i phase)) at samples or at the vertices of a mesh. Crests of waves run
// along the field's lines. The waves have several periods, each half of the one before, so that every crest is one of
// the next wave, too.                                                  [Knoeppel et al. 2013; Knoeppel et al. 2015]
//   link_samples: samples -> a graph of neighbours on the same sheet, each with a tangent frame
//   line_angles: curvature, a law with a name or the caller's directions -> the smoothest field that follows them where
//                they are sure
//   add_sample_waves: lines of samples -> waves of the long periods
//   waves_at_vertices: these -> the same waves at the vertices of a mesh, and waves of the short periods
#pragma once

#include "base/assert.h"
#include "base/list.h"
#include "curves/surface_mesh.h"
#include "marks/site.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace hrbfnpr::hatching {

using Complex = std::complex<double>;
using Numbers = base::Array<Complex>; // one at each node
inline constexpr double tau = 2.0 * std::numbers::pi;

// The product of finite numbers. The operator of std::complex looks for NaN, which costs more than the product itself.
[[nodiscard]] inline Complex product(const Complex& a, const Complex& b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// ---- The field

// Which nodes are linked: those from first[i] up to first[i + 1] are the neighbours of node i.
struct Graph {
    explicit Graph(base::Memory& memory) noexcept : first(memory), neighbour(memory) {}

    [[nodiscard]] std::int64_t nodes() const noexcept { return first.size() - 1; }

    base::Array<std::int64_t> first; // one more than there are nodes
    base::Array<std::int32_t> neighbour;
};

// What lines follow. The numbers are those that hrbfnpr_layer_desc.guide takes.
enum class Guide : std::uint32_t { curvature = 0, combing = 1, sections = 2, light = 3, silhouette = 4 };

struct FieldSettings {
    double smoothing = 0.04;        // the length over which lines are smoothed, in diagonals
    glm::dvec3 axis{0.0, 1.0, 0.0}; // where curvature says little lines run across this, around it
    double axis_weight = 0.06;      // how much the axis counts against curvature
    Guide guide = Guide::curvature;
    glm::dvec3 guide_direction{0.0, 0.0, 1.0}; // unit: to the light, or to the eye
    double guide_weight = 1.0;                 // the share of `guide`; curvature has the rest
    double diagonal = 1.0;

    [[nodiscard]] bool operator==(const FieldSettings& other) const noexcept = default;
};

// Even samples of the surface; the graph's links lead over no crease and to no other sheet.
struct SampleGraph : Graph {
    explicit SampleGraph(base::Memory& memory) noexcept
        : Graph(memory), position(memory), normal(memory), sheet(memory), u(memory) {}

    // The unit tangent at this angle in the frame of sample i, and the angle of a tangent there.
    [[nodiscard]] glm::dvec3 tangent(std::int64_t i, double angle) const noexcept {
        return std::cos(angle) * u[i] + std::sin(angle) * glm::cross(normal[i], u[i]);
    }
    [[nodiscard]] double angle(std::int64_t i, const glm::dvec3& tangent) const noexcept {
        return std::atan2(glm::dot(tangent, glm::cross(normal[i], u[i])), glm::dot(tangent, u[i]));
    }

    geometry::VecArray position, normal;
    base::Array<std::int32_t> sheet; // the implicit's sheet at each sample; empty: the surface is smooth
    geometry::VecArray u;            // the first axis of each sample's frame; the second is normal x u
    double spacing = 0.0;            // the root of the area for each sample
};

// Links the samples, whose positions, normals, sheets and spacing are there.
void link_samples(const base::Work& work, SampleGraph& graph);

// The line along the larger of both principal curvatures by amount, of which this is the mean and half the difference,
// as exp(2 i angle) times how sure it is, from 0 to 1.
[[nodiscard]] Complex curvature_line(double mean, const Complex& difference, double diagonal) noexcept;

// The angle of the line of each sample in its frame. The function, if there is one, takes the place of curvature.
[[nodiscard]] base::Array<double> line_angles(const marks::Site& site, const SampleGraph& graph,
                                              const FieldSettings& settings, const marks::DirectionFunction& function);

// ---- Waves

// Waves at the nodes of a graph: exp(i phase), where the phase grows across the line of each node, to its left as seen
// from outside. The magnitude, up to 1, says how far the waves around a node agree.
struct Waves {
    Waves(base::Memory& memory, const geometry::VecArray& nodes, double coarsest)
        : position(nodes), along(memory, nodes.size()), across(memory, nodes.size()), period(coarsest), level(memory) {}

    void set_line(std::int64_t i, const glm::dvec3& normal, const glm::dvec3& tangent) noexcept {
        along.set(i, tangent);
        across.set(i, glm::cross(normal, tangent));
    }
    [[nodiscard]] bool has_line(std::int64_t i) const noexcept { return glm::dot(along[i], along[i]) > 0.0; }
    // Whether the lines of two neighbours point to opposite ways: their signs mean nothing.
    [[nodiscard]] bool turned(std::int64_t a, std::int64_t b) const noexcept {
        return glm::dot(along[a], along[b]) < 0.0;
    }
    // By how much the phase of a wave of this period grows from node a to b, in the sense of a's line.
    [[nodiscard]] double growth(std::int64_t a, std::int64_t b, double wave_period) const noexcept {
        const glm::dvec3 there = across[b];
        const glm::dvec3 mean = 0.5 * (across[a] + (turned(a, b) ? -there : there));
        return tau / wave_period * glm::dot(position[b] - position[a], mean);
    }
    [[nodiscard]] std::int64_t finest() const noexcept { return level.size() - 1; }
    [[nodiscard]] double period_of(std::int64_t number) const noexcept {
        return std::ldexp(period, -static_cast<int>(number));
    }

    const geometry::VecArray& position; // the place of each node
    geometry::VecArray along, across;   // unit, tangent; 0 where a node has no line
    double period;                      // the period of the first wave, object units
    base::List<Numbers> level;          // the waves, coarsest first
};

// The wave as a line sees it that points to the opposite way, or to the same.
[[nodiscard]] inline Complex seen(const Complex& z, bool turned) noexcept { return turned ? std::conj(z) : z; }

// Adds waves to the samples' lines: as many levels as wanted, but none too fine for the samples.
void add_sample_waves(const base::Work& work, const SampleGraph& graph, std::uint64_t seed, int levels, Waves& samples);

// sheets: the implicit's sheet at each vertex; empty where the samples have none. As many levels as wanted, but none
// too fine for the mesh.
[[nodiscard]] Waves waves_at_vertices(const base::Work& work, const SampleGraph& graph, const Waves& samples,
                                      const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets,
                                      int levels);

} // namespace hrbfnpr::hatching
