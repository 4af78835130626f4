#include "generate/in_unit.h"

#include "base/status.h"
#include "generate/generate.h"
#include "marks/marks.h"
#include "marks/size.h"

#include <algorithm>
#include <cmath>
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

void check_length(const char* field, double length, double diagonal) {
    const double part = length / diagonal;
    if (length == 0.0 || (part >= shortest_length && part <= longest_length)) return;
    fail(Status::invalid_argument,
         "generate_desc.%s is %g, %.2g of the model's diagonal; it must be 0, or from %g to %g of that", field, length,
         part, shortest_length, longest_length);
}

} // namespace

void check_request(const implicit::Implicit& implicit, const Settings& settings) {
    const double diagonal = implicit.diagonal();
    marks::require_size("the model's bounds are", diagonal, "samples (or a custom model's function)");
    if (settings.distribution == marks::Distribution::published)
        return check_length("initial_step", settings.seeds.initial_step, diagonal);
    check_length("stroke_separation", settings.strokes.separation, diagonal);
    check_length("stroke_step", settings.strokes.step, diagonal);
    for (std::size_t group = 0; group < settings.group.size(); ++group)
        if (settings.group[group].wanted && settings.group[group].budget > marks::most_even_marks)
            fail(Status::invalid_argument,
                 "generate_desc asks for %lld marks in group[%d]; BLUE_NOISE makes %lld at most: lower the budget",
                 static_cast<long long>(settings.group[group].budget), static_cast<int>(group),
                 static_cast<long long>(marks::most_even_marks));
}

InUnit::InUnit(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
               const Settings& settings)
    : runtime_(runtime), implicit_(implicit), unit_(geometry::unit_for(implicit.diagonal())),
      sample_position_(runtime.memory), seed_position_(runtime.memory), samples_(samples), settings_(settings) {
    // A longer limit is none.
    settings_.strokes.longest = std::min(settings_.strokes.longest, longest_length * implicit.diagonal());
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
    for (double* length : {&settings_.seeds.initial_step, &settings_.strokes.separation, &settings_.strokes.step,
                           &settings_.strokes.longest})
        *length /= unit_;
}

void to_callers_unit(marks::PointSet& set, double unit) {
    if (unit == 1.0) return;
    set.origin *= unit;
    set.bounds = {unit * set.bounds.min, unit * set.bounds.max};
    set.spacing *= unit;
    if (const double side = set.bounds.longest_side(); side > 0.0)
        marks::require_size("the marks are", side, "samples (or a custom model's function)");
    for (marks::MarkGroup& group : set.group) {
        scale(group.position, unit);
        scale_curvatures(group.curvature, 1.0 / unit);
        group.report.step *= unit;
    }
}

} // namespace hrbfnpr::generate
