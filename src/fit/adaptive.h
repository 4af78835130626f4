// SPDX-License-Identifier: MIT
// The one loop that chooses the centres of a fit among candidates: samples of a scan, places on a mesh, or places on
// one of its patches. The greedy choice is that of Carr et al., "Reconstruction and representation of 3D objects with
// radial basis functions", 2001, in batches.
//
//   even_choice       the first centres, spread evenly over the candidates
//   fit_centres       a fit with all centres (fit_centres.h)
//   oracle            the caller measures how far the fit is off, and tells what the next round gets
//   worst_candidates  finds for the oracle the candidates that the fit is worst at, apart from centres and each other
#pragma once

#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "geometry/neighbours.h"
#include "geometry/point_tree.h"

#include <functional>

namespace hrbfnpr::fit {

// A fit and the centres that it has.
struct AdaptiveFit {
    CentreFit fit;
    base::Array<std::int64_t> centres; // numbers of candidates, ascending
    Samples held;                      // centres off the surface, where f is held to values
    std::int32_t rounds = 0;           // the number of fits that were made
    double seconds_fit = 0.0;          // the time that these took
    double seconds_before = 0.0;       // from the beginning of the loop to that of the last fit
};

// What the next round gets besides the centres that there are.
struct Growth {
    Growth(base::Memory& memory, const Smoothing& smooth) noexcept : centres(memory), held(memory), smoothing(smooth) {}

    bool goes_on = false; // false: the fit is as good as it gets, and the rest does not count
    base::Array<std::int64_t> centres;
    Samples held;
    Smoothing smoothing;
};
using Oracle = std::function<Growth(const AdaptiveFit&)>;

struct AdaptiveSettings {
    std::int32_t most_rounds = 0;
    // Where a fit with more centres cannot be solved, the last one is the result; else that is an error. The first fit
    // has to be solved.
    bool keeps_last = false;
};

// Fits in rounds until the oracle is content.
[[nodiscard]] AdaptiveFit fit_adaptively(const base::Work& work, const FitInput& input, const Samples& candidates,
                                         base::Array<std::int64_t> first, const Smoothing& smoothing,
                                         const AdaptiveSettings& settings, const Oracle& oracle);

// Numbers of at most `count` candidates in ascending order, chosen by farthest points.
[[nodiscard]] base::Array<std::int64_t> even_choice(const Samples& candidates, std::int64_t count,
                                                    const base::Progress& progress);

// The samples that a fit has for centres: candidates, then those that are held.
[[nodiscard]] Samples centres_of(const base::Work& work, const Samples& candidates,
                                 const base::Array<std::int64_t>& centres, const Samples& held);

// The most centres that a round adds to this many: half as many, or as many while nearly all that are added are needed,
// as more than a quarter of the candidates is outside the tolerance. `outside` is their share.
[[nodiscard]] std::int64_t batch_of(std::int64_t centres, double outside) noexcept;

// ---- What to add

struct CandidateOptions {
    double tolerance = 0.0;      // 0: all samples are candidates
    double least_distance = 0.0; // No new centre is nearer to another than this.
    std::int64_t most = 0;       // to be added
    // Not null for noisy samples: the mean over a sample and these counts for it, and its typical one is added in its
    // stead.
    const geometry::Neighbours* neighbours = nullptr;
    const base::Array<std::int64_t>* typical = nullptr;
};

struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept : chosen(memory) {}

    base::Array<std::int64_t> chosen; // worst first
    std::int64_t outside = 0;         // the number of samples beyond the tolerance
};

// tree: the samples. centres: numbers of samples, not empty.
[[nodiscard]] Candidates worst_candidates(const base::Work& work, const Samples& samples,
                                          const geometry::PointTree& tree, const base::Array<std::int64_t>& centres,
                                          const Distances& distances, const CandidateOptions& options);

} // namespace hrbfnpr::fit
