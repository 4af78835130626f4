// SPDX-License-Identifier: MIT
#include "fit/candidates.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// Samples that are within the tolerance, but just so, are taken along where others are not: they would be next.
constexpr double nearly_outside = 0.75;
// A normal that is off by an angle moves the surface by about this share of the angle times the distance to the
// next centre.
constexpr double lever = 0.25;
// No new centre is nearer to another than this share of the spacing there, so that a batch covers what is bad
// instead of heaping where it is worst.  If that lets none through, the share is halved, down to the least.
constexpr double apart = 0.5;
constexpr double least_apart = 1e-3;

class Finder {
public:
    Finder(const base::Runtime& runtime, const Samples& samples, const geometry::PointTree& tree,
           const base::Array<std::int64_t>& centres, const Distances& distances, const CandidateOptions& options,
           const base::Progress& progress)
        : runtime_(runtime), samples_(samples), tree_(tree), distances_(distances), options_(options),
          progress_(progress), centre_tree_(positions(centres), progress),
          centre_spacing_(runtime.memory, centres.size()), is_centre_(runtime.memory, samples.position.size()),
          error_(runtime.memory, samples.position.size()), score_(runtime.memory, samples.position.size()),
          to_centre_(runtime.memory, samples.position.size()), spacing_(runtime.memory, samples.position.size()) {
        for (const std::int64_t i : centres) is_centre_[i] = 1;
        for (std::int64_t at = 0; at < centres.size(); ++at)
            centre_spacing_[at] = std::min(centre_tree_.nearest_other(at), samples.bounds.diagonal());
        runtime.parallel.for_chunks(samples.position.size(), 512, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            for (std::int64_t i = begin; i < end; ++i) measure(i);
        });
    }

    [[nodiscard]] Candidates run() {
        Candidates result(runtime_.memory);
        for (const double error : error_) result.outside += error > options_.tolerance ? 1 : 0;
        if (result.outside == 0) return result;
        const base::Array<std::int64_t> order = worst_first();
        for (double share = apart; share >= least_apart && result.chosen.empty(); share *= 0.5) {
            take(order, share, result.chosen);
            if (options_.neighbours != nullptr) break; // noise is not chased
        }
        return result;
    }

private:
    [[nodiscard]] geometry::VecArray positions(const base::Array<std::int64_t>& which) const {
        geometry::VecArray result(runtime_.memory);
        result.reserve(which.size());
        for (const std::int64_t i : which) result.push_back(samples_.position[i]);
        return result;
    }

    // 0 where the gradient is along the normal, 2 where it is against it.
    [[nodiscard]] double deviation(std::int64_t i) const {
        const glm::dvec3 gradient = distances_.gradient[i];
        const double slope = glm::length(gradient);
        return slope > 0.0 ? glm::distance(gradient / slope, samples_.normal[i]) : 2.0;
    }

    // The noise of one sample says nothing about the surface; the mean of some does.
    void measure(std::int64_t i) {
        double distance = distances_.distance[i];
        double off = deviation(i);
        if (options_.neighbours != nullptr) {
            const auto near = options_.neighbours->of(i);
            for (const std::int64_t j : near) {
                distance += distances_.distance[j];
                off += deviation(j);
            }
            distance /= static_cast<double>(near.size() + 1);
            off /= static_cast<double>(near.size() + 1);
        }
        std::int64_t nearest = 0;
        centre_tree_.nearest(
            samples_.position[i], 1, [](std::int64_t) { return true; }, [](std::int64_t) { return true; }, &nearest);
        to_centre_[i] = glm::distance(samples_.position[i], centre_tree_.points()[nearest]);
        spacing_[i] = centre_spacing_[nearest];
        // Where f grows inward the distance is that from another sheet, or from none.
        const bool wrong_side = off > 1.4142135623730951;
        error_[i] = wrong_side ? std::max(std::abs(distance), 2.0 * options_.tolerance) : std::abs(distance);
        score_[i] = error_[i] + lever * off * to_centre_[i];
    }

    [[nodiscard]] base::Array<std::int64_t> worst_first() const {
        base::Array<std::int64_t> order(runtime_.memory);
        for (std::int64_t i = 0; i < score_.size(); ++i)
            if (is_centre_[i] == 0 && error_[i] >= nearly_outside * options_.tolerance) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
            return score_[a] > score_[b] || (score_[a] == score_[b] && a < b);
        });
        return order;
    }

    void take(const base::Array<std::int64_t>& order, double share, base::Array<std::int64_t>& chosen) const {
        base::Array<std::uint8_t> covered(runtime_.memory, samples_.position.size()); // by place in the tree
        base::Array<std::int64_t> place(runtime_.memory, samples_.position.size());
        for (std::int64_t at = 0; at < tree_.size(); ++at) place[tree_.index(at)] = at;
        for (const std::int64_t i : order) {
            if (chosen.size() >= options_.most) return;
            const double radius = std::max(share * spacing_[i], options_.least_distance);
            if (covered[place[i]] != 0 || to_centre_[i] < radius) continue;
            const std::int64_t added = options_.typical != nullptr ? (*options_.typical)[i] : i;
            // What is near enough to share its typical sample with another is not tried again.
            if (is_centre_[added] == 0) chosen.push_back(added);
            tree_.within(samples_.position[i], radius, [&](std::int64_t at, double) { covered[at] = 1; });
            if (chosen.size() % 256 == 0) progress_.check();
        }
    }

    const base::Runtime& runtime_;
    const Samples& samples_;
    const geometry::PointTree& tree_;
    const Distances& distances_;
    const CandidateOptions& options_;
    const base::Progress& progress_;
    geometry::PointTree centre_tree_;
    base::Array<double> centre_spacing_; // of each place in centre_tree_, from the nearest other centre
    base::Array<std::uint8_t> is_centre_;
    base::Array<double> error_;     // distance from the surface
    base::Array<double> score_;     // the higher, the worse
    base::Array<double> to_centre_; // distance to the nearest centre
    base::Array<double> spacing_;   // of that centre
};

} // namespace

Candidates find_candidates(const base::Runtime& runtime, const Samples& samples, const geometry::PointTree& tree,
                           const base::Array<std::int64_t>& centres, const Distances& distances,
                           const CandidateOptions& options, const base::Progress& progress) {
    return Finder(runtime, samples, tree, centres, distances, options, progress).run();
}

} // namespace hrbfnpr::fit
