// SPDX-License-Identifier: MIT
// The loop that chooses the centres of every adaptive fit among candidates: samples of a scan, places on a mesh, or
// places on one of its patches. The greedy choice is that of Carr et al., "Reconstruction and representation of 3D
// objects with radial basis functions", 2001, in batches.
//
//   even_choice       returns the first centres, spread evenly over the candidates
//   fit_centres       makes a fit with all given centres (fit_centres.h)
//   chooser           is the caller's: it measures the errors of the fit, and chooses the centres of the next round
//   worst_candidates  helps the chooser: finds the candidates with the largest errors that are apart from centres
//                     and from each other
#pragma once

#include "base/work.h"
#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "geometry/neighbours.h"
#include "geometry/point_tree.h"

#include <functional>

namespace hrbfnpr::fit {

struct AdaptiveFit {
    CentreFit fit;
    base::Array<std::int64_t> centres; // indices of candidates, ascending
    Samples off_surface;               // centres off the surface, at which f has given values
    std::int32_t rounds = 0;           // the number of fits made
    double seconds_fit = 0.0;          // the time that the fits took
    double seconds_before = 0.0;       // the time from the start of the loop to the start of the last fit
};

// The centres that the next round adds to those of the last fit.
struct NextCentres {
    NextCentres(base::Memory& memory, const Smoothing& smooth) noexcept
        : centres(memory), off_surface(memory), smoothing(smooth) {}

    // If false, the loop ends. If the last system is then solved exactly, it also gets the centres off the surface.
    // Other members are ignored.
    bool continues = false;
    base::Array<std::int64_t> centres;
    Samples off_surface;
    Smoothing smoothing;
};
using CentreChooser = std::function<NextCentres(const AdaptiveFit&)>;

struct AdaptiveSettings {
    std::int32_t most_rounds = 0;
    // The rounds solve their systems only to this relative residual, which is enough to choose centres. At the end the
    // last system is solved as exactly as the input says. 0: all rounds solve exactly.
    double residual_of_rounds = 0.0;
    // If a fit with more centres cannot be solved, the last fit is the result instead of an error. The first fit must
    // always be solvable.
    bool keeps_last = false;
};

// Makes fits in rounds, until `chooser` ends the loop or `most_rounds` rounds are done.
[[nodiscard]] AdaptiveFit fit_adaptively(const base::Work& work, const FitInput& input, const Samples& candidates,
                                         base::Array<std::int64_t> first, const Smoothing& smoothing,
                                         const AdaptiveSettings& settings, const CentreChooser& chooser);

// Returns the indices of at most `count` candidates, in ascending order. They are chosen by farthest-point sampling.
[[nodiscard]] base::Array<std::int64_t> even_choice(const Samples& candidates, std::int64_t count,
                                                    const base::Progress& progress);

// Returns the samples that become centres: the chosen candidates, then those off the surface.
[[nodiscard]] Samples centres_of(const base::Work& work, const Samples& candidates,
                                 const base::Array<std::int64_t>& centres, const Samples& off_surface);

// Returns the largest number of centres that a round may add. It is half the number of existing centres. While more
// than a quarter of the candidates is outside the tolerance, it is the whole number of existing centres, because nearly
// all added centres are then needed.
[[nodiscard]] std::int64_t batch_of(std::int64_t centres, double outside) noexcept;

// ---- Candidates to add as centres

struct CandidateOptions {
    double tolerance = 0.0;      // 0: all samples are candidates
    double least_distance = 0.0; // No new centre is nearer to another centre than this.
    std::int64_t most = 0;       // the largest number of centres to add
    // Set for noisy samples. The mean error over a sample and these neighbours is then used, and the typical sample of
    // the neighbourhood (typical.h) is added instead of the sample.
    const geometry::Neighbours* neighbours = nullptr;
    const base::Array<std::int64_t>* typical = nullptr;
};

struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept : chosen(memory) {}

    base::Array<std::int64_t> chosen; // indices of the chosen candidates, the worst first
    std::int64_t outside = 0;         // the number of samples beyond the tolerance
};

// `tree` holds the samples. `centres` holds indices of samples, and is not empty.
[[nodiscard]] Candidates worst_candidates(const base::Work& work, const Samples& samples,
                                          const geometry::PointTree& tree, const base::Array<std::int64_t>& centres,
                                          const Distances& distances, const CandidateOptions& options);

} // namespace hrbfnpr::fit
