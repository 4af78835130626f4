// SPDX-License-Identifier: MIT
#include "fit/adaptive.h"

#include "base/assert.h"
#include "base/clock.h"
#include "fit/tuning.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::fit {
namespace {

geometry::VecArray positions_of_centres(const Samples& samples, const base::Array<std::int64_t>& centres) {
    geometry::VecArray positions(centres.memory());
    positions.reserve(centres.size());
    for (const std::int64_t i : centres) positions.push_back(samples.position[i]);
    return positions;
}

// The errors of a fit at each sample.
struct Misfits {
    explicit Misfits(base::Memory& memory, std::int64_t count)
        : error(memory, count), score(memory, count), to_centre(memory, count), spacing(memory, count) {}

    base::Array<double> error;     // distance from the surface
    base::Array<double> score;     // higher is worse
    base::Array<double> to_centre; // distance to the nearest centre
    base::Array<double> spacing;   // distance from that centre to the nearest other centre
};

Misfits misfits_of(const base::Work& work, const Samples& samples, const base::Array<std::int64_t>& centres,
                   const Distances& distances, const CandidateOptions& options) {
    const geometry::PointTree tree(positions_of_centres(samples, centres), work);
    // For each centre: its spacing, by the centre's index in `tree`.
    base::Array<double> spacing(work.memory, centres.size());
    for (std::int64_t at = 0; at < centres.size(); ++at)
        spacing[at] = std::min(tree.nearest_other(at), samples.bounds.diagonal());
    // Returns the distance between the unit gradient and the normal: 0 if they are equal, and 2 if they are opposite or
    // the gradient is 0.
    const auto deviation = [&](std::int64_t i) {
        const glm::dvec3 gradient = distances.gradient[i];
        const double slope = glm::length(gradient);
        return slope > 0.0 ? glm::distance(gradient / slope, samples.normal[i]) : 2.0;
    };
    Misfits found(work.memory, samples.position.size());
    const auto measure = [&](std::int64_t i) {
        // A single sample's noise hides its distance from the surface; the mean over its neighbours has less noise.
        double distance = distances.distance[i];
        double off = deviation(i);
        if (options.neighbours != nullptr) {
            const auto near = options.neighbours->of(i);
            for (const std::int64_t j : near) {
                distance += distances.distance[j];
                off += deviation(j);
            }
            distance /= static_cast<double>(near.size() + 1);
            off /= static_cast<double>(near.size() + 1);
        }
        std::int64_t nearest = 0;
        tree.nearest(
            samples.position[i], 1, [](std::int64_t) { return true; }, [](std::int64_t) { return true; }, &nearest);
        found.to_centre[i] = glm::distance(samples.position[i], tree.points()[nearest]);
        found.spacing[i] = spacing[nearest];
        // A sample where f grows inward lies on another sheet, or on no sheet at all, so its distance means little.
        const bool wrong_side = off > 1.4142135623730951;
        found.error[i] = wrong_side ? std::max(std::abs(distance), adaptive_tuning.wrong_side * options.tolerance)
                                    : std::abs(distance);
        found.score[i] = found.error[i] + adaptive_tuning.lever * off * found.to_centre[i];
    };
    work.for_chunks(samples.position.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) measure(i);
    });
    return found;
}

bool is_unsolvable(const Error& error) noexcept {
    return error.status() == Status::not_converged || error.status() == Status::singular_system;
}

void resize_off_surface(Samples& off_surface, std::int64_t count) {
    off_surface.position.resize(count);
    off_surface.normal.resize(count);
    off_surface.value.resize(count);
}

void add_off_surface(const Samples& added, Samples& off_surface) {
    for (std::int64_t i = 0; i < added.position.size(); ++i) {
        off_surface.position.push_back(added.position[i]);
        off_surface.normal.push_back(added.normal[i]);
        off_surface.value.push_back(added.value[i]);
    }
}

// Returns the centres of both lists, each once, in ascending order.
base::Array<std::int64_t> joined(const base::Array<std::int64_t>& some, const base::Array<std::int64_t>& others) {
    base::Array<std::int64_t> all(some.memory());
    all.reserve(some.size() + others.size());
    for (const base::Array<std::int64_t>* const part : {&some, &others})
        for (const std::int64_t i : *part) all.push_back(i);
    std::sort(all.begin(), all.end());
    all.resize(std::unique(all.begin(), all.end()) - all.begin());
    return all;
}

FitInput input_of_rounds(const FitInput& input, double residual) noexcept {
    FitInput rough = input;
    rough.automatic_tolerance = std::max(residual, input.automatic_tolerance);
    return rough;
}

// Returns whether a fit of a round is as exact as the input asks for.
bool solves_exactly(const FitInput& input, const FitInput& rough, const FitReport& report) noexcept {
    return rough.automatic_tolerance == input.automatic_tolerance || input.solver_tolerance > 0.0 ||
           report.solver == SolverKind::direct || report.solver_residual <= input.automatic_tolerance;
}

// Returns the index in the earlier fit of each centre of the next fit, or -1 for new centres. Both fits have the
// centres that are candidates first, in ascending order, and then those off the surface.
base::Array<std::int64_t> earlier_indices(const base::Array<std::int64_t>& before, std::int64_t off_before,
                                          const base::Array<std::int64_t>& now, std::int64_t off_now) {
    base::Array<std::int64_t> index(now.memory());
    index.reserve(now.size() + off_now);
    std::int64_t at = 0;
    for (const std::int64_t centre : now) {
        const bool known = at < before.size() && before[at] == centre;
        index.push_back(known ? at++ : -1);
    }
    for (std::int64_t i = 0; i < off_now; ++i) index.push_back(i < off_before ? before.size() + i : -1);
    HRBFNPR_ASSERT(at == before.size());
    return index;
}

} // namespace

// ---- The loop

AdaptiveFit fit_adaptively(const base::Work& work, const FitInput& input, const Samples& candidates,
                           base::Array<std::int64_t> first, const Smoothing& smoothing,
                           const AdaptiveSettings& settings, const CentreChooser& chooser) {
    HRBFNPR_ASSERT(!first.empty() && std::is_sorted(first.begin(), first.end()) && settings.most_rounds > 0);
    const base::Stopwatch watch;
    const FitInput rough = input_of_rounds(input, settings.residual_of_rounds);
    const auto fit_round = [&](std::int32_t round, const base::Array<std::int64_t>& centres, const Samples& off_surface,
                               const Smoothing& smooth, const EarlierFit& earlier) {
        // The number of rounds is unknown, so each round fills a quarter of the progress that remains.
        const base::Work part = work.part(1.0 - std::pow(0.75, round), 1.0 - std::pow(0.75, round + 1));
        return fit_centres(part, rough, centres_of(work, candidates, centres, off_surface), smooth, earlier);
    };
    Samples none(work.memory);
    Smoothing last = smoothing;
    CentreFit first_fit = fit_round(0, first, none, last, {});
    AdaptiveFit now{std::move(first_fit), std::move(first), std::move(none), 1, watch.seconds(), 0.0};
    Samples unused(work.memory); // the centres off the surface that the chooser found when it ended the loop
    for (;;) {
        NextCentres next = chooser(now);
        if (!next.continues || now.rounds >= settings.most_rounds) {
            unused = std::move(next.off_surface);
            break;
        }
        const double before = watch.seconds();
        base::Array<std::int64_t> centres = joined(now.centres, next.centres);
        const std::int64_t off_surface = now.off_surface.position.size();
        add_off_surface(next.off_surface, now.off_surface);
        try {
            const base::Array<std::int64_t> earlier =
                earlier_indices(now.centres, off_surface, centres, now.off_surface.position.size());
            now.fit = fit_round(now.rounds, centres, now.off_surface, next.smoothing, {&now.fit.result.data, &earlier});
        } catch (const Error& error) {
            if (!settings.keeps_last || !is_unsolvable(error)) throw;
            work.runtime().log(base::LogLevel::debug, "fit: with %lld centres: %s; going back to %lld centres",
                               static_cast<long long>(centres.size() + now.off_surface.position.size()), error.what(),
                               static_cast<long long>(now.centres.size() + off_surface));
            resize_off_surface(now.off_surface, off_surface);
            break;
        }
        now.centres = std::move(centres);
        last = next.smoothing;
        ++now.rounds;
        now.seconds_before = before;
        now.seconds_fit += watch.seconds() - before;
    }
    if (solves_exactly(input, rough, now.fit.result.report)) return now;
    const double before = watch.seconds();
    const std::int64_t off_surface = now.off_surface.position.size();
    add_off_surface(unused, now.off_surface);
    const base::Array<std::int64_t> earlier =
        earlier_indices(now.centres, off_surface, now.centres, now.off_surface.position.size());
    now.fit = fit_centres(work.without_progress(), input, centres_of(work, candidates, now.centres, now.off_surface),
                          last, {&now.fit.result.data, &earlier});
    now.seconds_fit += watch.seconds() - before;
    return now;
}

base::Array<std::int64_t> even_choice(const Samples& candidates, std::int64_t count, const base::Progress& progress) {
    HRBFNPR_ASSERT(count > 0 && !candidates.position.empty());
    geometry::FarthestOrder found = geometry::farthest_order(
        candidates.position, std::min(count, candidates.position.size()), progress.without_progress());
    std::sort(found.order.begin(), found.order.end());
    return std::move(found.order);
}

Samples centres_of(const base::Work& work, const Samples& candidates, const base::Array<std::int64_t>& centres,
                   const Samples& off_surface) {
    HRBFNPR_ASSERT(off_surface.value.size() == off_surface.position.size());
    Samples chosen(work.memory);
    chosen.position.reserve(centres.size() + off_surface.position.size());
    chosen.normal.reserve(centres.size() + off_surface.position.size());
    for (const std::int64_t i : centres) {
        chosen.position.push_back(candidates.position[i]);
        chosen.normal.push_back(candidates.normal[i]);
    }
    if (centres.size() == candidates.position.size() && candidates.spacing > 0.0)
        chosen.spacing = candidates.spacing;
    else
        measure_extent(work, chosen);
    chosen.bounds = candidates.bounds;
    if (off_surface.position.empty()) return chosen;
    chosen.value.resize(centres.size());
    for (std::int64_t i = 0; i < off_surface.position.size(); ++i) {
        chosen.position.push_back(off_surface.position[i]);
        chosen.normal.push_back(off_surface.normal[i]);
        chosen.value.push_back(off_surface.value[i]);
    }
    return chosen;
}

std::int64_t batch_of(std::int64_t centres, double outside) noexcept {
    const double share = outside > adaptive_tuning.mostly_outside ? adaptive_tuning.large_batch : adaptive_tuning.batch;
    return std::max(adaptive_tuning.smallest_batch, static_cast<std::int64_t>(share * static_cast<double>(centres)));
}

// ---- Samples to add as centres

Candidates worst_candidates(const base::Work& work, const Samples& samples, const geometry::PointTree& tree,
                            const base::Array<std::int64_t>& centres, const Distances& distances,
                            const CandidateOptions& options) {
    const std::int64_t count = samples.position.size();
    HRBFNPR_ASSERT(!centres.empty() && tree.size() == count && distances.distance.size() == count);
    const Misfits misfit = misfits_of(work, samples, centres, distances, options);
    Candidates result(work.memory);
    for (const double error : misfit.error) result.outside += error > options.tolerance ? 1 : 0;
    if (result.outside == 0) return result;

    base::Array<std::uint8_t> is_centre(work.memory, count);
    for (const std::int64_t i : centres) is_centre[i] = 1;
    base::Array<std::int64_t> order(work.memory);
    for (std::int64_t i = 0; i < count; ++i)
        if (is_centre[i] == 0 && misfit.error[i] >= adaptive_tuning.nearly_outside * options.tolerance)
            order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        return misfit.score[a] > misfit.score[b] || (misfit.score[a] == misfit.score[b] && a < b);
    });
    base::Array<std::int64_t> place(work.memory, count); // for each sample: its index in the tree
    for (std::int64_t at = 0; at < tree.size(); ++at) place[tree.index(at)] = at;

    const auto take = [&](double share) {
        base::Array<std::uint8_t> covered(work.memory, count); // 1 for samples near a new centre, by index in the tree
        for (const std::int64_t i : order) {
            if (result.chosen.size() >= options.most) return;
            const double radius = std::max(share * misfit.spacing[i], options.least_distance);
            if (covered[place[i]] != 0 || misfit.to_centre[i] < radius) continue;
            const std::int64_t added = options.typical != nullptr ? (*options.typical)[i] : i;
            // The typical sample may already be a centre. The samples around sample i are then marked as covered, too,
            // so that they are not tried again.
            if (is_centre[added] == 0) result.chosen.push_back(added);
            tree.within(samples.position[i], radius, [&](std::int64_t at, double) { covered[at] = 1; });
            work.check();
        }
    };
    for (double share = adaptive_tuning.apart; share >= adaptive_tuning.least_apart && result.chosen.empty();
         share *= 0.5) {
        take(share);
        // With noisy samples, centres at smaller distances would fit the noise.
        if (options.neighbours != nullptr) break;
    }
    return result;
}

} // namespace hrbfnpr::fit
