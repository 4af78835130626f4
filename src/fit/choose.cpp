// SPDX-License-Identifier: MIT
#include "fit/choose.h"

#include "base/assert.h"
#include "fit/adaptive.h"
#include "fit/clean.h"
#include "fit/tuning.h"
#include "fit/typical.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace hrbfnpr::fit {
namespace {

base::Array<std::int64_t> all_indices(base::Memory& memory, std::int64_t count) {
    base::Array<std::int64_t> all(memory, count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// Returns the regularization: the variance of the noise divided by the variance of f (see CentreFit::variance).
Smoothing smoothing_of(const Noise& noise, double diagonal, double variance) noexcept {
    const double position = noise.position / diagonal;
    return {position * position / variance, noise.normal * noise.normal / variance};
}

bool is_settled(double before, double now) noexcept {
    return now < choice_tuning.settled * before && before < choice_tuning.settled * now;
}

std::int64_t first_count(const FitInput& input, std::int64_t most) noexcept {
    if (input.tolerance > 0.0) return std::min(choice_tuning.first_centres, most);
    const std::int64_t share = most / choice_tuning.last_of_first;
    return std::min(std::max(share, adaptive_tuning.smallest_batch), most);
}

} // namespace

ChosenFit choose_and_fit(const base::Work& work, const FitInput& input, const Samples& samples, const Noise& noise) {
    const std::int64_t count = samples.position.size();
    HRBFNPR_ASSERT(count > 0 && samples.normal.size() == count);
    const std::int64_t most = input.maximum_centres > 0 ? input.maximum_centres : count;
    const bool keeps_all = input.tolerance == 0.0 && count <= most;
    const bool automatic = input.regularization_mode == RegularizationMode::automatic && noise.position > 0.0;
    const bool noisy = automatic || input.regularization > 0.0;

    std::optional<geometry::Neighbours> neighbours; // Set only if the samples are noisy.
    base::Array<std::int64_t> typical(work.memory);
    if (noisy && count >= fewest_to_clean) {
        neighbours.emplace(work.runtime().parallel, samples.position, choice_tuning.averaged, work);
        typical = typical_samples(work, samples, *neighbours);
    }
    std::int64_t first = keeps_all ? (automatic ? choice_tuning.pilot_centres : count) : first_count(input, most);
    base::Array<std::int64_t> centres =
        first < count ? even_choice(samples, first, work) : all_indices(work.memory, count);
    if (first < count && neighbours) {
        for (std::int64_t& i : centres) i = typical[i];
        // Several samples may have the same typical sample, so the list may hold duplicates.
        std::sort(centres.begin(), centres.end());
        centres.resize(std::unique(centres.begin(), centres.end()) - centres.begin());
    }

    std::optional<geometry::PointTree> tree; // a search tree of the samples
    Distances distances(work.memory);        // the distances of all samples from the surface of the last measured fit
    Smoothing smoothing{input.regularization, input.regularization};
    int settling = automatic ? 1 : choice_tuning.settling_fits;
    const auto smooth = [&](const AdaptiveFit& now) {
        if (automatic && now.fit.variance > 0.0)
            smoothing = smoothing_of(noise, samples.bounds.diagonal(), now.fit.variance);
    };
    const auto measure = [&](const AdaptiveFit& now) {
        const bool known = now.centres.size() == count && !now.fit.misfit.empty();
        distances = known ? distances_of_misfit(now.fit.misfit, now.fit.result.data, samples)
                          : measure_distances(work, now.fit.result.data, samples);
    };
    const auto measure_and_choose = [&](const AdaptiveFit& now) {
        NextCentres next(work.memory, smoothing);
        if (settling < choice_tuning.settling_fits) {
            const double before = smoothing.value;
            smooth(now);
            next.smoothing = smoothing;
            next.continues = !is_settled(before, smoothing.value);
            settling = next.continues ? settling + 1 : choice_tuning.settling_fits;
            if (next.continues) return next;
        }
        if (keeps_all && now.centres.size() < count) {
            next.centres = all_indices(work.memory, count);
            next.continues = true;
            return next;
        }
        measure(now);
        if (keeps_all || now.centres.size() >= most) return next;
        if (!tree) tree.emplace(samples.position, work);
        // The mean of neighbouring samples has less noise than one sample, so its tolerance is smaller.
        const double tolerance = std::max(input.tolerance - choice_tuning.noise_allowed * noise.position,
                                          choice_tuning.least_tolerance * input.tolerance);
        CandidateOptions options{tolerance, choice_tuning.noise_apart * noise.position,
                                 std::min(batch_of(now.centres.size(), 1.0), most - now.centres.size())};
        if (neighbours) options.neighbours = &*neighbours;
        if (neighbours) options.typical = &typical;
        Candidates worst = worst_candidates(work, samples, *tree, now.centres, distances, options);
        work.runtime().log(base::LogLevel::debug, "fit: round %d: %lld centres, %lld samples outside the tolerance",
                           static_cast<int>(now.rounds), static_cast<long long>(now.centres.size()),
                           static_cast<long long>(worst.outside));
        const double outside = static_cast<double>(worst.outside) / static_cast<double>(count);
        worst.chosen.resize(std::min(worst.chosen.size(), batch_of(now.centres.size(), outside)));
        const std::int64_t fewest =
            neighbours ? std::max<std::int64_t>(now.centres.size() / choice_tuning.worthwhile, 1) : 1;
        next.continues = worst.chosen.size() >= fewest;
        next.centres = std::move(worst.chosen);
        smooth(now);
        next.smoothing = smoothing;
        return next;
    };
    AdaptiveFit made = fit_adaptively(work, input, samples, std::move(centres), smoothing,
                                      {choice_tuning.most_rounds, 0.0, false}, std::ref(measure_and_choose));
    return {std::move(made.fit), std::move(made.centres), std::move(distances), keeps_all ? 0 : made.rounds,
            made.seconds_before};
}

} // namespace hrbfnpr::fit
