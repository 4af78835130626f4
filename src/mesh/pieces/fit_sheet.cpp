// SPDX-License-Identifier: MIT
#include "mesh/pieces/fit_sheet.h"

#include "fit/candidates.h"
#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t first_centres = 8;
constexpr std::int32_t most_rounds = 12;
constexpr double batch = 0.7; // of the centres, that a round adds at most
constexpr std::int64_t smallest_batch = 12;
constexpr double apart = 4.0; // tolerances between centres

[[nodiscard]] fit::Samples chosen_of(const base::Runtime& runtime, const fit::Samples& samples,
                                     const base::Array<std::int64_t>& centres, const base::Progress& progress) {
    fit::Samples chosen(runtime.memory);
    for (const std::int64_t i : centres) {
        chosen.position.push_back(samples.position[i]);
        chosen.normal.push_back(samples.normal[i]);
    }
    fit::measure_extent(runtime, chosen, progress);
    chosen.bounds = samples.bounds;
    return chosen;
}

class SheetFitter {
public:
    SheetFitter(const base::Runtime& runtime, const PatchSamples& patch, const fit::FitInput& options,
                std::int64_t most, const base::Progress& progress)
        : runtime_(runtime), patch_(patch), options_(options), most_(most), progress_(progress),
          centres_(runtime.memory) {
        unit_ = *std::min_element(patch.tolerance.begin(), patch.tolerance.end());
        options_.tolerance = unit_; // residuals that a distance does not show are accepted
    }

    [[nodiscard]] SheetFit run() {
        const geometry::FarthestOrder first = geometry::farthest_order(
            patch_.samples.position, std::min({first_centres, most_, patch_.samples.position.size()}), progress_);
        for (const std::int64_t i : first.order) centres_.push_back(i);
        std::sort(centres_.begin(), centres_.end());
        while (fit_round() && add_centres()) {
        }
        describe();
        return {std::move(fit_->result.data),  fit_->result.report, squares_, worst_, outside_, rounds_,
                patch_.samples.position.size()};
    }

private:
    // False where more centres make no fit: then it is the one before.
    [[nodiscard]] bool fit_round() {
        progress_.check();
        const fit::Samples chosen = chosen_of(runtime_, patch_.samples, centres_, progress_);
        try {
            fit::CentreFit made =
                fit::fit_centres(runtime_, options_, chosen, {options_.regularization, options_.regularization},
                                 progress_.part(0.0, 0.0));
            fit_.emplace(std::move(made));
        } catch (const Error& error) {
            const bool too_near = error.status() == Status::not_converged || error.status() == Status::singular_system;
            if (!too_near || rounds_ == 0) throw;
            return false;
        }
        ++rounds_;
        return true;
    }

    // False if all is well, or nothing can be added.
    [[nodiscard]] bool add_centres() {
        fit::Distances distances = fit::measure_distances(runtime_, fit_->result.data, patch_.samples, progress_);
        worst_ = squares_ = 0.0;
        outside_ = 0;
        fit_->result.report.input_distance_max = 0.0;
        for (std::int64_t i = 0; i < distances.distance.size(); ++i) {
            const double distance = std::abs(distances.distance[i]);
            fit_->result.report.input_distance_max = std::max(fit_->result.report.input_distance_max, distance);
            squares_ += distance * distance;
            distances.distance[i] *= unit_ / patch_.tolerance[i];
            const double off = std::abs(distances.distance[i]) / unit_;
            worst_ = std::max(worst_, off);
            outside_ += off > 1.0 ? 1 : 0;
        }
        const std::int64_t room = most_ - centres_.size();
        if (outside_ == 0 || room <= 0 || rounds_ >= most_rounds) return false;
        const auto share = static_cast<std::int64_t>(batch * static_cast<double>(centres_.size()));
        const fit::CandidateOptions options{unit_, apart * unit_, std::min(room, std::max(smallest_batch, share)),
                                            nullptr, nullptr};
        if (!tree_) tree_.emplace(patch_.samples.position, progress_);
        const fit::Candidates added =
            fit::find_candidates(runtime_, patch_.samples, *tree_, centres_, distances, options, progress_);
        for (const std::int64_t i : added.chosen) centres_.push_back(i);
        std::sort(centres_.begin(), centres_.end());
        return !added.chosen.empty();
    }

    void describe() {
        const implicit::HrbfData& data = fit_->result.data;
        fit::FitReport& to = fit_->result.report;
        fit::Samples centres(runtime_.memory);
        const double* const p = data.sample_position.data();
        for (std::int64_t i = 0; i < 3 * data.count(); i += 3) centres.position.push_back({p[i], p[i + 1], p[i + 2]});
        const fit::Distances at = fit::measure_distances(runtime_, data, centres, progress_);
        const double* const n = data.sample_normal.data();
        double values = 0.0;
        double gradients = 0.0;
        for (std::int64_t i = 0; i < data.count(); ++i) {
            const double off = std::abs(at.value[i]);
            const double turned = glm::distance(at.gradient[i], {n[3 * i], n[3 * i + 1], n[3 * i + 2]});
            to.value_residual_max = std::max(to.value_residual_max, off);
            to.gradient_residual_max = std::max(to.gradient_residual_max, turned);
            values += (off / data.scale) * (off / data.scale);
            gradients += turned * turned;
        }
        to.value_residual_rms = data.scale * std::sqrt(values / static_cast<double>(data.count()));
        to.gradient_residual_rms = std::sqrt(gradients / static_cast<double>(data.count()));
        to.choice_rounds = rounds_;
    }

    const base::Runtime& runtime_;
    const PatchSamples& patch_;
    fit::FitInput options_;
    const std::int64_t most_;
    const base::Progress& progress_;
    double unit_ = 0.0;                       // the least tolerance
    std::optional<geometry::PointTree> tree_; // of the samples
    base::Array<std::int64_t> centres_;
    std::optional<fit::CentreFit> fit_;
    double squares_ = 0.0;
    double worst_ = 0.0;
    std::int64_t outside_ = 0;
    std::int32_t rounds_ = 0;
};

} // namespace

SheetFit fit_sheet(const base::Runtime& runtime, const PatchSamples& patch, const fit::FitInput& options,
                   std::int64_t most, const base::Progress& progress) {
    return SheetFitter(runtime, patch, options, most, progress).run();
}

} // namespace hrbfnpr::mesh
