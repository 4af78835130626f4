// SPDX-License-Identifier: MIT
#include "mesh/fit/fit_data.h"

#include "implicit/prepared.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {

namespace {

// Measured on two cores, AVX2: what all pairs of places and centres take, and fields of the precision and with as many
// near centres as below.
constexpr double seconds_a_pair = 1.1e-9;
constexpr double seconds_a_field = 0.05;
constexpr double seconds_a_centre = 8.5e-5;
constexpr double worth = 1.2;
constexpr std::int64_t most_near = 1000;
constexpr double gradient_precision = 1e-2;

[[nodiscard]] bool pays(std::int64_t centres, std::int64_t places) noexcept {
    const auto count = static_cast<double>(centres);
    return seconds_a_pair * static_cast<double>(places) * count > worth * (seconds_a_field + seconds_a_centre * count);
}

} // namespace

void FitField::expect(const base::Runtime& runtime, std::int64_t places, const base::Progress& progress) {
    if (prepared_ != nullptr || !pays(data_.count(), places)) return;
    implicit::LocalFieldOptions options;
    options.tolerance = precision_;
    options.most_near = most_near;
    std::unique_ptr<implicit::Prepared> prepared = implicit::Prepared::make(runtime, data_, progress, options);
    if (prepared == nullptr) return;
    const implicit::Prepared::Error error = prepared->error();
    if (error.value <= precision_ && error.gradient <= gradient_precision) prepared_ = std::move(prepared);
}

double root_mean_square(const base::Array<double>& distance, double unit) noexcept {
    double sum = 0.0;
    for (const double d : distance) sum += (d / unit) * (d / unit);
    return unit * std::sqrt(sum / static_cast<double>(distance.size()));
}

void describe(const base::Runtime& runtime, const fit::Samples& chosen, const FitMeshReport& report,
              fit::CentreFit& fit, const base::Progress& progress) {
    fit::FitReport& to = fit.result.report;
    const fit::Distances at = fit::measure_distances(runtime, fit.result.data, chosen, progress);
    const double unit = fit.result.data.scale; // no underflow in small units
    double values = 0.0;
    double gradients = 0.0;
    const std::int64_t count = chosen.position.size();
    for (std::int64_t i = 0; i < count; ++i) {
        const double value = std::abs(at.value[i] - (chosen.value.empty() ? 0.0 : chosen.value[i]));
        const double gradient = glm::distance(at.gradient[i], chosen.normal[i]);
        to.value_residual_max = std::max(to.value_residual_max, value);
        to.gradient_residual_max = std::max(to.gradient_residual_max, gradient);
        values += (value / unit) * (value / unit);
        gradients += gradient * gradient;
    }
    to.value_residual_rms = unit * std::sqrt(values / static_cast<double>(count));
    to.gradient_residual_rms = std::sqrt(gradients / static_cast<double>(count));
    to.samples = report.candidates;
    to.choice_rounds = report.rounds;
    to.input_distance_max = report.mesh.most;
    to.input_share_within = report.mesh.share;
    to.seconds_choose = report.seconds_sample + report.seconds_measure;
    to.peak_bytes = runtime.memory.bytes_peak();
}

} // namespace hrbfnpr::mesh
