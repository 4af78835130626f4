// SPDX-License-Identifier: MIT
// A smooth field of lines (directions without a sign) on samples: it follows given ones where these are sure, and is
// the smoothest between them.  [Knoeppel et al. 2013]
#pragma once

#include "hatching/sample_graph.h"
#include "surface/curvature.h"

namespace hrbfnpr::hatching {

// Same numbers as HRBFNPR_HATCH_GUIDE_...
enum class Guide : std::uint32_t { curvature = 0, combing = 1, sections = 2, light = 3, silhouette = 4 };

struct FieldSettings {
    double smoothing = 0.04;        // over so long a way lines are smoothed; diagonals
    glm::dvec3 axis{0.0, 1.0, 0.0}; // where curvature says little lines run across this, around it
    double axis_weight = 0.06;      // against curvature
    Guide guide = Guide::curvature;
    glm::dvec3 guide_direction{0.0, 0.0, 1.0}; // unit: to the light, or to the eye
    double guide_weight = 1.0;                 // what is left of 1 is curvature's
    double diagonal = 1.0;
};

// A curvature counts in full where its radius is below this part of the diagonal.
inline constexpr double full_radius = 0.05;

// The mean of both principal curvatures, and half their difference as a line.
struct Bend {
    double mean = 0.0;
    Complex difference{0.0};
};

// Averaged over some four spacings.
[[nodiscard]] base::Array<Bend> average_bends(const base::Runtime& runtime, const SampleGraph& graph,
                                              const base::Array<surface::Curvature>& curvature,
                                              const base::Progress& progress);

// Lines that are wanted, and how sure each is, in [0, 1]: exp(2 i angle) times that.
// Along the larger of both principal curvatures by amount.
[[nodiscard]] base::Array<Complex> guide_by_curvature(const base::Runtime& runtime, const SampleGraph& graph,
                                                      const base::Array<Bend>& bend, const FieldSettings& settings);
// Adds lines around the axis to what is wanted.
void add_axis(const SampleGraph& graph, const FieldSettings& settings, base::Array<Complex>& guide);

// The angle of the line of each sample in its frame.
[[nodiscard]] base::Array<double> smooth_lines(const base::Runtime& runtime, const SampleGraph& graph,
                                               const base::Array<Complex>& guide, const FieldSettings& settings,
                                               const base::Progress& progress);

} // namespace hrbfnpr::hatching
