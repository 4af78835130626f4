// SPDX-License-Identifier: MIT
#include "fit/choose.h"

#include "base/clock.h"
#include "fit/candidates.h"
#include "fit/clean.h"
#include "fit/typical.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t first_centres = 256;
// Without a tolerance the first centres are this share of the last.
constexpr std::int64_t last_of_first = 4;
// A batch is at most this share of the centres: of many at once some turn out not to have been needed.
constexpr double batch = 0.5;
// ... but while more than this share of the samples is outside, nearly all are.
constexpr double mostly_outside = 0.25;
constexpr double large_batch = 1.0;
constexpr std::int64_t smallest_batch = 32;
// No end is in sight if it is not reached by then: each round but the last few grows by `batch`.
constexpr std::int32_t most_rounds = 50;

// The smoothing that the noise calls for depends on the fit's own variance, and that on the smoothing.
constexpr int settling_fits = 4;
constexpr double settled = 1.2;
constexpr std::int64_t pilot_centres = 512;

constexpr std::int64_t averaged = 16; // neighbours, of noisy samples
// Centres nearer to each other than this would follow the noise, in standard deviations of it.
constexpr double noise_apart = 4.0;
// A round that adds less than one in so many to them is not worth its time: what is left is noise.
constexpr std::int64_t worthwhile = 200;
// The surface may be off the mean of some samples by what the noise leaves of the tolerance: then nearly all of
// them are within it.  But not by less than half of it, which no centres may be able to reach.
constexpr double noise_allowed = 2.0;
constexpr double least_tolerance = 0.5;

class Chooser {
public:
    Chooser(const base::Runtime& runtime, const FitInput& input, const Samples& samples, const Noise& noise,
            const base::Progress& progress)
        : runtime_(runtime), input_(input), samples_(samples), noise_(noise), progress_(progress),
          centres_(runtime.memory), typical_(runtime.memory), smoothing_{input.regularization, input.regularization} {}

    [[nodiscard]] Choice run() {
        const bool all = keeps_all();
        if (noisy() && samples_.position.size() >= fewest_to_clean) {
            neighbours_.emplace(runtime_.parallel, samples_.position, averaged, progress_);
            typical_ = typical_samples(runtime_, samples_, *neighbours_, progress_);
        }
        set_first_centres(all ? (automatic() ? pilot_centres : samples_.position.size()) : first_count());
        fit_first();
        if (all && centres_.size() < samples_.position.size()) {
            set_first_centres(samples_.position.size());
            fit_round();
        }
        Distances distances = measure();
        if (!all) add_rounds(distances);
        return {std::move(*fit_), std::move(centres_), std::move(distances), all ? 0 : rounds_, seconds_before_};
    }

private:
    [[nodiscard]] bool keeps_all() const noexcept {
        const bool few = input_.maximum_centres == 0 || samples_.position.size() <= input_.maximum_centres;
        return input_.tolerance == 0.0 && few;
    }
    [[nodiscard]] bool automatic() const noexcept {
        return input_.regularization_mode == RegularizationMode::automatic && noise_.position > 0.0;
    }
    [[nodiscard]] bool noisy() const noexcept { return automatic() || input_.regularization > 0.0; }
    [[nodiscard]] std::int64_t fewest_added(std::int64_t centres) const noexcept {
        return neighbours_ ? std::max<std::int64_t>(centres / worthwhile, 1) : 1;
    }
    [[nodiscard]] double mean_tolerance() const noexcept {
        return std::max(input_.tolerance - noise_allowed * noise_.position, least_tolerance * input_.tolerance);
    }
    [[nodiscard]] std::int64_t most_centres() const noexcept {
        return input_.maximum_centres > 0 ? input_.maximum_centres : samples_.position.size();
    }
    [[nodiscard]] std::int64_t first_count() const noexcept {
        if (input_.tolerance > 0.0) return std::min(first_centres, most_centres());
        return std::min(std::max(most_centres() / last_of_first, smallest_batch), most_centres());
    }

    void set_first_centres(std::int64_t count) {
        centres_.clear();
        if (count >= samples_.position.size()) {
            centres_.reserve(samples_.position.size());
            for (std::int64_t i = 0; i < samples_.position.size(); ++i) centres_.push_back(i);
            return;
        }
        const geometry::FarthestOrder first =
            geometry::farthest_order(samples_.position, count, progress_.part(0.0, 0.0));
        for (const std::int64_t i : first.order) centres_.push_back(neighbours_ ? typical_[i] : i);
        sort_centres();
    }

    // Two samples may have the same typical one.
    void sort_centres() {
        std::sort(centres_.begin(), centres_.end());
        centres_.resize(std::unique(centres_.begin(), centres_.end()) - centres_.begin());
    }

    void fit_first() {
        fit_round();
        if (!automatic()) return;
        for (int step = 1; step < settling_fits; ++step) {
            const double before = smoothing_.value;
            smooth();
            if (smoothing_.value < settled * before && before < settled * smoothing_.value) break;
            fit_round();
        }
    }

    // Noise over the variance of what is fitted: see CentreFit.
    void smooth() noexcept {
        if (!automatic() || !(fit_->variance > 0.0)) return;
        const double position = noise_.position / samples_.bounds.diagonal();
        smoothing_ = {position * position / fit_->variance, noise_.normal * noise_.normal / fit_->variance};
    }

    void fit_round() {
        seconds_before_ = watch_.seconds();
        fit_.reset(); // gives its memory back first
        // How many rounds there will be nobody knows; each is longer than the one before.
        const double from = 1.0 - std::pow(0.7, rounds_);
        const double to = 1.0 - std::pow(0.7, rounds_ + 1);
        fit_.emplace(fit_centres(runtime_, input_, chosen_samples(), smoothing_, progress_.part(from, to)));
        ++rounds_;
    }

    [[nodiscard]] Samples chosen_samples() const {
        Samples chosen(runtime_.memory);
        chosen.position.reserve(centres_.size());
        chosen.normal.reserve(centres_.size());
        for (const std::int64_t i : centres_) {
            chosen.position.push_back(samples_.position[i]);
            chosen.normal.push_back(samples_.normal[i]);
        }
        if (centres_.size() == samples_.position.size())
            chosen.spacing = samples_.spacing;
        else
            measure_extent(runtime_, chosen, progress_);
        chosen.bounds = samples_.bounds;
        return chosen;
    }

    [[nodiscard]] Distances measure() const {
        if (centres_.size() == samples_.position.size() && !fit_->misfit.empty())
            return distances_of_misfit(fit_->misfit, fit_->result.data, samples_);
        return measure_distances(runtime_, fit_->result.data, samples_, progress_);
    }

    void add_rounds(Distances& distances) {
        double share = large_batch;
        const geometry::PointTree tree(samples_.position, progress_);
        std::int64_t outside = 0;
        while (centres_.size() < most_centres() && rounds_ < most_rounds) {
            const auto count = static_cast<double>(centres_.size());
            const auto most = std::max(smallest_batch, static_cast<std::int64_t>(share * count));
            const CandidateOptions options{mean_tolerance(), noise_apart * noise_.position,
                                           std::min(most, most_centres() - centres_.size()),
                                           neighbours_ ? &*neighbours_ : nullptr, neighbours_ ? &typical_ : nullptr};
            const Candidates added = find_candidates(runtime_, samples_, tree, centres_, distances, options, progress_);
            outside = added.outside;
            runtime_.log(base::LogLevel::debug, "fit: round %d: %lld centres, %lld samples outside, %lld to be added",
                         static_cast<int>(rounds_), static_cast<long long>(centres_.size()),
                         static_cast<long long>(outside), static_cast<long long>(added.chosen.size()));
            if (added.chosen.size() < fewest_added(centres_.size())) break;
            const double part = static_cast<double>(outside) / static_cast<double>(samples_.position.size());
            share = part > mostly_outside ? large_batch : batch;
            for (const std::int64_t i : added.chosen) centres_.push_back(i);
            sort_centres();
            smooth();
            fit_round();
            distances = measure();
        }
    }

    const base::Runtime& runtime_;
    const FitInput& input_;
    const Samples& samples_;
    const Noise& noise_;
    const base::Progress& progress_;
    const base::Stopwatch watch_;
    base::Array<std::int64_t> centres_;
    std::optional<geometry::Neighbours> neighbours_; // of noisy samples
    base::Array<std::int64_t> typical_;              // ...
    Smoothing smoothing_;
    std::optional<CentreFit> fit_;
    std::int32_t rounds_ = 0;
    double seconds_before_ = 0.0;
};

} // namespace

Choice choose_and_fit(const base::Runtime& runtime, const FitInput& input, const Samples& samples, const Noise& noise,
                      const base::Progress& progress) {
    return Chooser(runtime, input, samples, noise, progress).run();
}

} // namespace hrbfnpr::fit
