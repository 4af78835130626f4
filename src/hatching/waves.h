// SPDX-License-Identifier: MIT
// Waves whose crests run along a field of lines, of several periods, each half of the one before, so that every crest
// is one of the next wave, too.                                                             [Knoeppel et al. 2015]
//   sample_waves: lines of samples -> waves of the long periods
//   waves_at_vertices: these -> the same waves at the vertices of a mesh, and waves of the short periods
#pragma once

#include "base/list.h"
#include "curves/surface_mesh.h"
#include "hatching/field.h"

namespace hrbfnpr::hatching {

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
    [[nodiscard]] double growth(std::int64_t a, std::int64_t b, double wave_period) const noexcept;
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
void add_sample_waves(const base::Runtime& runtime, const SampleGraph& graph, std::uint64_t seed, int levels,
                      Waves& samples, const base::Progress& progress);

// sheets: the implicit's sheet at each vertex; empty where the samples have none. As many levels as wanted, but none
// too fine for the mesh.
[[nodiscard]] Waves waves_at_vertices(const base::Runtime& runtime, const SampleGraph& graph, const Waves& samples,
                                      const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets,
                                      int levels, const base::Progress& progress);

} // namespace hrbfnpr::hatching
