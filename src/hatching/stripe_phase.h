// SPDX-License-Identifier: MIT
// Stripes along a field of lines: at each sample the phase of waves whose crests run along the lines, of several
// periods, each half of the one before, so that every crest is one of the next, too.  [Knoeppel et al. 2015]
#pragma once

#include "hatching/line_field.h"

namespace hrbfnpr::hatching {

// Samples with the line that each has.
struct LineSamples {
    const SampleGraph& graph;
    geometry::VecArray along; // unit, tangent; its sign means nothing
};

// exp(i phase) of each sample, across `along`: towards normal x along the phase grows.
using Phases = base::Array<Complex>;

// The first of a period, by the smallest eigenvector of what neighbours disagree in.
[[nodiscard]] Phases first_phases(const base::Runtime& runtime, const LineSamples& samples, double period,
                                  std::uint64_t seed, const base::Progress& progress);
// Of half the period.
[[nodiscard]] Phases doubled(const base::Runtime& runtime, const LineSamples& samples, const Phases& phases,
                             double period, const base::Progress& progress);

// A wave as another line sees it: turned round if that points the other way.
[[nodiscard]] inline Complex seen(const Complex& z, bool turned) noexcept { return turned ? std::conj(z) : z; }

} // namespace hrbfnpr::hatching
