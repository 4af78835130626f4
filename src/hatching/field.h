// SPDX-License-Identifier: MIT
// Complex numbers at the nodes of a graph. They are lines of a field (directions without a sign, as exp(2 i angle)) at
// even samples of the surface, or waves (as exp(i phase)) at samples or at the vertices of a mesh. Crests of waves run
// along the lines of the field. Each wave has half the period of the previous wave, so that every crest of a wave is
// also a crest of the next wave.                                       [Knoeppel et al. 2013; Knoeppel et al. 2015]
//   link_samples: samples -> a graph of neighbours on the same sheet, each with a tangent frame
//   line_angles: curvature, a named guide or the caller's directions -> the smoothest field that follows them where
//                their confidence is high
//   add_sample_waves: lines of samples -> waves of the long periods
//   waves_at_vertices: waves of samples -> the same waves at the vertices of a mesh, and waves of the short periods
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
using Numbers = base::Array<Complex>;          // one number per node
using Wave = base::Array<std::complex<float>>; // one number per node
inline constexpr double tau = 2.0 * std::numbers::pi;

// Returns the product of finite numbers. The operator of std::complex also checks for NaN, which takes longer than the
// product.
template <class Real>
[[nodiscard]] std::complex<Real> product(const std::complex<Real>& a, const std::complex<Real>& b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// ---- The field

// The links between nodes. Node i has the neighbours neighbour[first[i]] to neighbour[first[i + 1] - 1].
struct Graph {
    explicit Graph(base::Memory& memory) noexcept : first(memory), neighbour(memory) {}

    [[nodiscard]] std::int64_t nodes() const noexcept { return first.size() - 1; }

    base::Array<std::int64_t> first; // where the links of each node begin; at the end, the number of links
    base::Array<std::int32_t> neighbour;
};

// The quantity that lines follow. The values equal those of hrbfnpr_layer_desc.guide.
enum class Guide : std::uint32_t { curvature = 0, combing = 1, sections = 2, light = 3, silhouette = 4 };

struct FieldSettings {
    double smoothing = 0.04;        // the length over which the field is smoothed, in diagonals
    glm::dvec3 axis{0.0, 1.0, 0.0}; // Where the confidence of curvature is low, lines run around this axis.
    double axis_weight = 0.06;      // the weight of lines around the axis; the largest weight of curvature is 1
    Guide guide = Guide::curvature;
    glm::dvec3 guide_direction{0.0, 0.0, 1.0}; // a unit vector to the light or to the eye
    double guide_weight = 1.0;                 // The weight of `guide`, from 0 to 1. Curvature has the rest.
    double diagonal = 1.0;

    [[nodiscard]] bool operator==(const FieldSettings& other) const noexcept = default;
};

// Evenly spread samples of the surface. The first samples alone are evenly spread, too, however many they are. No link
// of the graph crosses a crease or leads to another sheet.
struct SampleGraph : Graph {
    explicit SampleGraph(base::Memory& memory) noexcept
        : Graph(memory), position(memory), normal(memory), sheet(memory), u(memory) {}

    // tangent() returns the unit tangent at an angle in the frame of sample i, and angle() the angle of a tangent.
    [[nodiscard]] glm::dvec3 tangent(std::int64_t i, double angle) const noexcept {
        return std::cos(angle) * u[i] + std::sin(angle) * glm::cross(normal[i], u[i]);
    }
    [[nodiscard]] double angle(std::int64_t i, const glm::dvec3& tangent) const noexcept {
        return std::atan2(glm::dot(tangent, glm::cross(normal[i], u[i])), glm::dot(tangent, u[i]));
    }

    geometry::VecArray position, normal;
    base::Array<std::int32_t> sheet; // for each sample: its sheet of the implicit; empty if the surface is smooth
    geometry::VecArray u;            // for each sample: the first axis of its frame; the second axis is normal x u
    double spacing = 0.0;            // the square root of the area per sample
};

// Finds the links between samples. Positions, normals, sheets and spacing must already be set.
void link_samples(const base::Work& work, SampleGraph& graph);

// Returns the line along the principal direction of the larger absolute curvature: exp(2 i angle) times its confidence
// from 0 to 1. `mean` is the mean of the principal curvatures, and `difference` is half of their difference, as a line.
[[nodiscard]] Complex curvature_line(double mean, const Complex& difference, double diagonal) noexcept;

// Returns for each sample the angle of its line in its frame. If the caller gives a function of directions, it replaces
// the curvature.
[[nodiscard]] base::Array<double> line_angles(const marks::Site& site, const SampleGraph& graph,
                                              const FieldSettings& settings, const marks::DirectionFunction& function);

// ---- Waves

// Waves at the nodes of a graph, as exp(i phase). The phase grows across the line of each node, to its left as seen
// from outside. The magnitude, up to 1, tells how well the waves around a node agree.
struct Waves {
    Waves(base::Memory& memory, const geometry::VecArray& nodes, double coarsest)
        : position(nodes), along(memory, nodes.size()), across(memory, nodes.size()), period(coarsest), level(memory) {}

    void set_line(std::int64_t i, const glm::dvec3& normal, const glm::dvec3& tangent) noexcept {
        along.set(i, tangent);
        across.set(i, glm::cross(normal, tangent));
    }
    [[nodiscard]] bool has_line(std::int64_t i) const noexcept { return glm::dot(along[i], along[i]) > 0.0; }
    // Returns whether the lines of two neighbours point in opposite directions. The sign of a line itself means
    // nothing.
    [[nodiscard]] bool turned(std::int64_t a, std::int64_t b) const noexcept {
        return glm::dot(along[a], along[b]) < 0.0;
    }
    // Returns how much the phase of a wave of this period grows from node a to node b. The phase grows to the left of
    // the line of node a.
    [[nodiscard]] double growth(std::int64_t a, std::int64_t b, double wave_period) const noexcept {
        const glm::dvec3 there = across[b];
        const glm::dvec3 mean = 0.5 * (across[a] + (turned(a, b) ? -there : there));
        return tau / wave_period * glm::dot(position[b] - position[a], mean);
    }
    [[nodiscard]] std::int64_t finest() const noexcept { return level.size() - 1; }
    [[nodiscard]] double period_of(std::int64_t number) const noexcept {
        return std::ldexp(period, -static_cast<int>(number));
    }

    const geometry::VecArray& position; // the position of each node
    geometry::VecArray along, across;   // unit tangent vectors; 0 if a node has no line
    double period;                      // the period of the first wave, in units of the object
    base::List<Wave> level;             // the waves, from coarse to fine
};

// Converts the number of a wave from one line to another line. `turned`: the two lines point in opposite directions.
template <class Real>
[[nodiscard]] std::complex<Real> conjugated_if(const std::complex<Real>& z, bool turned) noexcept {
    return {z.real(), turned ? -z.imag() : z.imag()};
}

// Adds waves to `samples`, which must already have lines: `levels` waves, or fewer if the samples can represent only
// fewer.
void add_sample_waves(const base::Work& work, const SampleGraph& graph, std::uint64_t seed, int levels, Waves& samples);

// Interpolates the waves to the vertices of a mesh and adds finer waves, until there are `levels` waves, or fewer if
// the mesh can represent only fewer. `sheets` has the implicit's sheet at each vertex. It is empty if the samples have
// no sheets. If `needed` is not empty, it has a number for each sample, and vertices without a sample near them whose
// number is not 0 get neither a line nor waves.
[[nodiscard]] Waves waves_at_vertices(const base::Work& work, const SampleGraph& graph, const Waves& samples,
                                      const base::Array<std::uint8_t>& needed, const curves::SurfaceMesh& mesh,
                                      const base::Array<std::int32_t>& sheets, int levels);

} // namespace hrbfnpr::hatching
