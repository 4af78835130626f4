// SPDX-License-Identifier: MIT
// Stripes along a field of lines: at each sample the phase of waves whose crests run along the lines, of several
// periods, each half of the one before, so that every crest is one of the next, too.  [Knoeppel et al. 2015]
#pragma once

#include "hatching/line_field.h"
#include "hatching/wave_links.h"

namespace hrbfnpr::hatching {

// Samples with the line that each has.
struct LineSamples {
    const SampleGraph& graph;
    geometry::VecArray along; // unit, tangent; its sign means nothing
};

// exp(i phase) of each sample, across `along`: towards normal x along the phase grows.
using Phases = base::Array<Complex>;

// Along the samples' links, for waves of this period.
[[nodiscard]] WaveLinks link_waves(const base::Runtime& runtime, const LineSamples& samples, double period,
                                   const base::Progress& progress);
// The first of the period of these links, by the smallest eigenvector of what neighbours disagree in.
[[nodiscard]] Phases first_phases(const base::Runtime& runtime, const WaveLinks& links, std::uint64_t seed,
                                  const base::Progress& progress);
// From those of twice the period of these links.
[[nodiscard]] Phases doubled(const base::Runtime& runtime, const WaveLinks& links, const Phases& phases,
                             const base::Progress& progress);

} // namespace hrbfnpr::hatching
