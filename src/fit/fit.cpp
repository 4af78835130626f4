// SPDX-License-Identifier: MIT
#include "fit/fit.h"

#include "base/clock.h"
#include "fit/choose.h"
#include "fit/clean.h"
#include "fit/local_factors.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

void check(const FitInput& input) {
    if (!(input.kernel_radius >= 0.0) || std::isinf(input.kernel_radius))
        fail(Status::invalid_argument, "kernel_radius is %g; it must be 0 (automatic) or above 0, and finite",
             input.kernel_radius);
    if (!(input.regularization >= 0.0) || std::isinf(input.regularization))
        fail(Status::invalid_argument, "regularization is %g; it must be finite and at least 0", input.regularization);
    if (input.polynomial_degree < -1 || input.polynomial_degree > 3)
        fail(Status::invalid_argument, "polynomial_degree is %d; it must be -1 (none) to 3",
             static_cast<int>(input.polynomial_degree));
    if (!(input.tolerance >= 0.0) || std::isinf(input.tolerance))
        fail(Status::invalid_argument, "tolerance is %g; it must be 0 (none) or above 0, and finite", input.tolerance);
    if (input.refinement_steps < 0)
        fail(Status::invalid_argument, "refinement_steps is %d; it must be at least 0",
             static_cast<int>(input.refinement_steps));
    if (input.preconditioner_neighbours >= static_cast<std::uint32_t>(LocalSystems::largest_set))
        fail(Status::invalid_argument, "preconditioner_neighbours is %u; it must be 0 (automatic) to %d",
             static_cast<unsigned>(input.preconditioner_neighbours), static_cast<int>(LocalSystems::largest_set - 1));
    if (input.points.count < 1 || input.points.count != input.normals.count)
        fail(Status::invalid_argument,
             "points has %lld elements and normals has %lld; give one normal for each point, and at least one point",
             static_cast<long long>(input.points.count), static_cast<long long>(input.normals.count));
}

// Reports how far f(x_i) is from 0 and grad f(x_i) from n_i at the centres.
void report_residuals(const ChosenFit& choice, const Samples& samples, FitReport& report) {
    const double unit = choice.fit.result.data.scale; // Dividing by the scale avoids underflow in small units.
    double value_sum = 0.0;
    double gradient_sum = 0.0;
    for (const std::int64_t i : choice.centres) {
        const double value = choice.distances.value[i];
        const double off = glm::distance(choice.distances.gradient[i], samples.normal[i]);
        report.value_residual_max = std::max(report.value_residual_max, std::abs(value));
        report.gradient_residual_max = std::max(report.gradient_residual_max, off);
        value_sum += (value / unit) * (value / unit);
        gradient_sum += off * off;
    }
    const auto count = static_cast<double>(choice.centres.size());
    report.value_residual_rms = unit * std::sqrt(value_sum / count);
    report.gradient_residual_rms = std::sqrt(gradient_sum / count);
}

// Reports how far all samples are from the surface. `given` is the number of samples before samples were dropped.
void report_distances(const ChosenFit& choice, double tolerance, std::int64_t given, FitReport& report) {
    const double unit = choice.fit.result.data.scale;
    double sum = 0.0;
    std::int64_t within = 0;
    for (const double signed_distance : choice.distances.distance) {
        const double distance = std::abs(signed_distance);
        report.input_distance_max = std::max(report.input_distance_max, distance);
        sum += (distance / unit) * (distance / unit);
        within += distance <= tolerance ? 1 : 0;
    }
    const auto count = static_cast<double>(choice.distances.distance.size());
    report.input_distance_rms = unit * std::sqrt(sum / count);
    if (tolerance > 0.0) report.input_share_within = static_cast<double>(within) / static_cast<double>(given);
}

void report_cleaning(const Cleaning& cleaning, FitReport& report) noexcept {
    report.near_duplicates = cleaning.near_duplicates;
    report.outliers_found = cleaning.outliers_found;
    report.outliers_dropped = cleaning.outliers_dropped;
    report.flipped_found = cleaning.flipped_found;
    report.flipped_repaired = cleaning.flipped_repaired;
}

[[nodiscard]] Noise noise_of(const base::Work& work, const FitInput& input, const Samples& samples) {
    if (input.regularization_mode == RegularizationMode::given) return {};
    return measure_noise(work, samples);
}

} // namespace

FitResult fit(const base::Work& work, const FitInput& input) {
    const base::Stopwatch watch;
    check(input);
    Samples samples = read_samples(work.part(0.0, 0.02), input.points, input.normals);
    const double seconds_read = watch.seconds();
    const std::int64_t before_cleaning = samples.position.size();
    const Cleaning cleaning = clean(work.part(0.02, 0.03), samples, input.outliers, input.flipped_normals);
    const Noise noise = noise_of(work, input, samples);
    const double seconds_clean = watch.seconds() - seconds_read;
    ChosenFit choice = choose_and_fit(work.part(0.03, 1.0), input, samples, noise);

    FitReport& report = choice.fit.result.report;
    report_cleaning(cleaning, report);
    work.check();
    report_residuals(choice, samples, report);
    work.check();
    report_distances(choice, input.tolerance, before_cleaning - cleaning.near_duplicates, report);
    report.samples = input.points.count;
    report.merged_samples = samples.merged;
    report.rescaled_normals = samples.rescaled_normals;
    if (input.regularization_mode != RegularizationMode::given) report.noise_estimate = noise.position;
    report.choice_rounds = choice.rounds;
    report.seconds_assemble += seconds_read;
    report.seconds_clean = seconds_clean;
    report.seconds_choose = choice.seconds_before;
    report.peak_bytes = work.memory.bytes_peak();
    report.seconds_total = watch.seconds();
    work.update(1.0);
    choice.fit.result.samples = std::move(samples);
    return std::move(choice.fit.result);
}

} // namespace hrbfnpr::fit
