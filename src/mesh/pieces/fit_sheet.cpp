// SPDX-License-Identifier: MIT
#include "mesh/pieces/fit_sheet.h"

#include "base/assert.h"
#include "fit/adaptive.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

// Fills in the residuals at the centres.
void describe(const base::Runtime& runtime, const implicit::HrbfData& data, fit::FitReport& to,
              const base::Progress& progress) {
    fit::Samples centres(runtime.memory);
    const double* const p = data.sample_position.data();
    for (std::int64_t i = 0; i < 3 * data.count(); i += 3) centres.position.push_back({p[i], p[i + 1], p[i + 2]});
    const fit::Distances at = fit::measure_distances(runtime, data, centres, progress);
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
}

} // namespace

SheetFit fit_sheet(const base::Runtime& runtime, const PatchSamples& patch, const fit::FitInput& given,
                   std::int64_t most, const base::Progress& progress) {
    const fit::Samples& samples = patch.samples;
    HRBFNPR_ASSERT(most > 0 && !patch.tolerance.empty() && patch.tolerance.size() == samples.position.size());
    const double unit = *std::min_element(patch.tolerance.begin(), patch.tolerance.end());
    fit::FitInput options = given;
    options.tolerance = unit; // residuals that a distance does not show are accepted
    const fit::Smoothing smoothing{options.regularization, options.regularization};

    std::optional<geometry::PointTree> tree;
    SheetFit sheet{implicit::HrbfData(runtime.memory), {}};
    double input_distance_max = 0.0;
    const auto look = [&](const fit::AdaptiveFit& now) {
        fit::Growth growth(runtime.memory, smoothing);
        fit::Distances distances = fit::measure_distances(runtime, now.fit.result.data, samples, progress);
        sheet.worst = sheet.squares = input_distance_max = 0.0;
        sheet.outside = 0;
        for (std::int64_t i = 0; i < distances.distance.size(); ++i) {
            const double distance = std::abs(distances.distance[i]);
            input_distance_max = std::max(input_distance_max, distance);
            sheet.squares += distance * distance;
            distances.distance[i] *= unit / patch.tolerance[i];
            const double off = std::abs(distances.distance[i]) / unit;
            sheet.worst = std::max(sheet.worst, off);
            sheet.outside += off > 1.0 ? 1 : 0;
        }
        const std::int64_t room = most - now.centres.size();
        if (sheet.outside == 0 || room <= 0) return growth;
        const auto share = static_cast<std::int64_t>(sheet_tuning.batch * static_cast<double>(now.centres.size()));
        const fit::CandidateOptions wanted{unit, sheet_tuning.apart * unit,
                                           std::min(room, std::max(sheet_tuning.smallest_batch, share))};
        if (!tree) tree.emplace(samples.position, progress);
        growth.centres =
            fit::worst_candidates(runtime, samples, *tree, now.centres, distances, wanted, progress).chosen;
        growth.goes_on = !growth.centres.empty();
        return growth;
    };
    fit::AdaptiveFit made = fit::fit_adaptively(
        runtime, options, samples, fit::even_choice(samples, std::min(sheet_tuning.first_centres, most), progress),
        smoothing, {sheet_tuning.most_rounds, true}, std::ref(look), progress.standing());
    sheet.data = std::move(made.fit.result.data);
    sheet.report = made.fit.result.report;
    sheet.report.input_distance_max = input_distance_max;
    sheet.report.choice_rounds = sheet.rounds = made.rounds;
    sheet.samples = samples.position.size();
    describe(runtime, sheet.data, sheet.report, progress);
    return sheet;
}

} // namespace hrbfnpr::mesh
