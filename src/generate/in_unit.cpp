// SPDX-License-Identifier: MIT
#include "generate/in_unit.h"

#include "base/status.h"
#include "generate/generate.h"
#include "marks/marks.h"
#include "marks/site.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hrbfnpr::generate {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

void scale(base::Array<float>& array, double by) noexcept {
    for (float& number : array) number = static_cast<float>(by * double{number});
}

// k1 and k2, beside the confidence.
void scale_curvatures(base::Array<float>& curvature, double by) noexcept {
    for (std::int64_t i = 0; i < curvature.size(); ++i)
        if (i % 3 != 2)
            curvature[i] = static_cast<float>(std::clamp(by * double{curvature[i]}, -largest_float, largest_float));
}

// Lengths of the descriptor, in diagonals: others are mistakes.
constexpr double shortest_length = 1e-12;
constexpr double longest_length = 1e9;

bool fits(double length, double diagonal) noexcept {
    const double part = length / diagonal;
    return length == 0.0 || (part >= shortest_length && part <= longest_length);
}

[[noreturn]] void refuse_length(const char* field, double length, double diagonal) {
    fail(Status::invalid_argument,
         "generate_desc.%s is %g, %.2g of the model's diagonal; it must be 0, or from %g to %g of that", field, length,
         length / diagonal, shortest_length, longest_length);
}

void check_length(std::int64_t layer, const char* field, double length, double diagonal) {
    if (fits(length, diagonal)) return;
    char name[64];
    std::snprintf(name, sizeof name, "layers[%lld].%s", static_cast<long long>(layer), field);
    refuse_length(name, length, diagonal);
}

} // namespace

void check_request(const implicit::Implicit& implicit, const Settings& settings) {
    const double diagonal = implicit.diagonal();
    marks::require_size("the model's bounds are", diagonal, "samples (or a custom model's function)");
    if (settings.distribution == marks::Distribution::published) {
        if (!fits(settings.seeds.initial_step, diagonal))
            refuse_length("initial_step", settings.seeds.initial_step, diagonal);
        return;
    }
    std::int64_t number = 0;
    for (const LayerSettings& layer : settings.layers) {
        if (layer.has_strokes()) {
            check_length(number, "separation", layer.hatching.separation, diagonal);
            check_length(number, "step", layer.hatching.step, diagonal);
        }
        ++number;
    }
}

InUnit::InUnit(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
               const Settings& settings)
    : runtime_(runtime), implicit_(implicit), unit_(geometry::unit_for(implicit.diagonal())),
      sample_position_(runtime.memory), seed_position_(runtime.memory), samples_(samples), settings_(settings) {
    if (unit_ == 1.0) return;
    scaled_.emplace(implicit, unit_);
    for (const double coordinate : samples.position) sample_position_.push_back(coordinate / unit_);
    samples_ = {sample_position_.span(), samples.spacing / unit_};
    const base::InView& seeds = settings.seeds.points;
    for (std::int64_t i = 0; i < seeds.count; ++i)
        for (std::uint32_t axis = 0; axis < 3; ++axis) seed_position_.push_back(seeds.get(i, axis) / unit_);
    if (!seeds.empty())
        settings_.seeds.points = {reinterpret_cast<const std::byte*>(seed_position_.data()), seeds.count,
                                  3 * std::int64_t{sizeof(double)}, base::Scalar::float64, 3};
    settings_.seeds.initial_step /= unit_;
    for (LayerSettings& layer : settings_.layers)
        for (double* length : {&layer.hatching.separation, &layer.hatching.step}) *length /= unit_;
}

void to_callers_unit(marks::PointSet& set, double unit) {
    if (unit == 1.0) return;
    set.origin *= unit;
    set.bounds = {unit * set.bounds.min, unit * set.bounds.max};
    set.spacing *= unit;
    if (const double side = set.bounds.longest_side(); side > 0.0)
        marks::require_size("the marks are", side, "samples (or a custom model's function)");
    for (marks::Layer& layer : set.layers) {
        scale(layer.position, unit);
        scale_curvatures(layer.curvature, 1.0 / unit);
        layer.report.step *= unit;
    }
}

} // namespace hrbfnpr::generate
