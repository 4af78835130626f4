// SPDX-License-Identifier: MIT
// What a round of choosing adds.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "fit/distance.h"
#include "geometry/neighbours.h"
#include "geometry/point_tree.h"

namespace hrbfnpr::fit {

struct CandidateOptions {
    double tolerance;      // 0: all samples are candidates
    double least_distance; // no new centre is nearer to another than this
    std::int64_t most;     // to be added
    // Not null for noisy samples: what counts of a sample is the mean over itself and these, and what is added in its
    // stead is its typical one.
    const geometry::Neighbours* neighbours;
    const base::Array<std::int64_t>* typical;
};

struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept : chosen(memory) {}

    base::Array<std::int64_t> chosen; // samples to be added, worst first
    std::int64_t outside = 0;         // samples beyond the tolerance
};

// tree: of the samples.  centres: samples that are centres, not empty.
[[nodiscard]] Candidates find_candidates(const base::Runtime& runtime, const Samples& samples,
                                         const geometry::PointTree& tree, const base::Array<std::int64_t>& centres,
                                         const Distances& distances, const CandidateOptions& options,
                                         const base::Progress& progress);

} // namespace hrbfnpr::fit
