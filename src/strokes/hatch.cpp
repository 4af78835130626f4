// SPDX-License-Identifier: MIT
#include "strokes/hatch.h"

#include "strokes/stroke_field.h"
#include "strokes/stroke_marks.h"
#include "strokes/stroke_sets.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes {
namespace {

constexpr std::int64_t sets = 2;
// Marks along a stroke, in separations.
constexpr double automatic_step = 0.2;
// Strokes are traced in steps of this at most, in separations; longer ones between marks are divided.
constexpr double longest_trace_step = 0.25;
constexpr double most_divisions = 4e6;
// Separations of the first pass in the diagonal of the surface.
constexpr double first_pass = 3.0;
constexpr int most_passes = 12;
// Of the marks that fill the area, those that are laid, and a few more for what the budget cuts.
constexpr double filled = 1.03;

constexpr std::int64_t fewest_samples = 4096;
constexpr std::int64_t most_samples = 65536;
constexpr std::int64_t marks_of_sample = 16;

class Hatching {
public:
    Hatching(const marks::Site& site, const stipples::SurfaceCells& cells, const HatchSettings& settings,
             marks::LayerReport& report)
        : site_(site), cells_(cells), settings_(settings),
          report_(report), layers_{Layer(site.memory()), Layer(site.memory())}, strokes_(site.memory()) {}

    double run(marks::Marks& marks, const base::Progress& progress);

private:
    void measure(double area);
    void lay(const surface::DirectionField& field, const base::Progress& progress);
    [[nodiscard]] LayerSettings layer_settings(const surface::DirectionField& field) const;
    void order();
    void keep_to_budget();

    const marks::Site& site_;
    const stipples::SurfaceCells& cells_;
    const HatchSettings& settings_;
    marks::LayerReport& report_;
    double separation_ = 0.0;
    double step_ = 0.0;              // from mark to mark
    std::int64_t divisions_ = 1;     // of a step, to trace it
    std::array<Layer, sets> layers_; // of a cross field the first one holds all
    base::Array<OrderedStroke> strokes_;
};

// Strokes of one set, a separation apart, have area / separation of length together.
void Hatching::measure(double area) {
    separation_ = settings_.separation;
    if (!(separation_ > 0.0)) {
        const double marks = static_cast<double>(settings_.budget) / filled;
        separation_ = settings_.step > 0.0 ? static_cast<double>(sets) * area / (settings_.step * marks)
                                           : std::sqrt(static_cast<double>(sets) * area / (automatic_step * marks));
    }
    step_ = settings_.step > 0.0 ? settings_.step : automatic_step * separation_;
    divisions_ = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(
               std::ceil(std::min(step_ / (longest_trace_step * separation_), 2.0 * most_divisions) - 1e-9)));
    const double marks = static_cast<double>(sets) * area / (separation_ * step_);
    if (settings_.budget == 0 && marks > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: a separation of %g and a step of %g make about %g marks, and %lld are the most: raise them "
             "or "
             "set the layer's budget",
             static_cast<long long>(settings_.layer), site_.unit * separation_, site_.unit * step_, marks,
             static_cast<long long>(marks::most_even_marks));
    if (static_cast<double>(divisions_) > most_divisions)
        fail(Status::invalid_argument,
             "layers[%lld].step = %g is more than %g times the separation of strokes, which is %g: lower it",
             static_cast<long long>(settings_.layer), site_.unit * step_, 0.25 * most_divisions,
             site_.unit * separation_);
}

LayerSettings Hatching::layer_settings(const surface::DirectionField& field) const {
    geometry::Bounds box;
    for (std::int64_t i = 0; i < field.size(); ++i) box.extend(field.position(i));
    LayerSettings settings;
    settings.separation = separation_;
    settings.step = step_ / static_cast<double>(divisions_);
    settings.longest = settings_.longest;
    const std::int64_t most = settings_.budget > 0 ? settings_.budget : marks::most_even_marks;
    settings.most_points = divisions_ * most;
    const double halvings = std::log2(std::max(1.0, box.diagonal() / (first_pass * separation_)));
    settings.passes = std::min(most_passes, 1 + static_cast<int>(std::floor(halvings)));
    settings.region = cells_.region;
    return settings;
}

// The sets of a line field do not know each other.
void Hatching::lay(const surface::DirectionField& field, const base::Progress& progress) {
    const LayerSettings settings = layer_settings(field);
    const std::int64_t count = field.symmetry() == surface::Symmetry::line ? sets : 1;
    site_.runtime.parallel.for_each(count, [&](std::int64_t set) {
        LayerSettings own = settings;
        own.turned = set == 1;
        layers_[static_cast<std::size_t>(set)] = lay_strokes(site_.memory(), field, own, progress);
    });
}

// Pass by pass; within one the sets take turns, so that both are equally far at every place of the order.
void Hatching::order() {
    struct Entry {
        double key; // pass, and the share of the set's ink in it that was laid before
        std::uint32_t set;
        std::int64_t stroke;
    };
    base::Array<Entry> entries(site_.memory());
    for (std::uint32_t set = 0; set < sets; ++set) {
        const Layer& layer = layers_[set];
        std::array<double, most_passes + 1> all{};
        std::array<double, most_passes + 1> before{};
        for (const Layer::Stroke& stroke : layer.stroke) all[stroke.pass] += static_cast<double>(stroke.count);
        for (std::int64_t s = 0; s < layer.stroke.size(); ++s) {
            const Layer::Stroke& stroke = layer.stroke[s];
            entries.push_back({stroke.pass + before[stroke.pass] / (all[stroke.pass] + 1.0), set, s});
            before[stroke.pass] += static_cast<double>(stroke.count);
        }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        if (a.key != b.key) return a.key < b.key;
        return a.set != b.set ? a.set < b.set : a.stroke < b.stroke;
    });
    for (const Entry& entry : entries) {
        const Layer& layer = layers_[entry.set];
        const Layer::Stroke& stroke = layer.stroke[entry.stroke];
        const StrokePoint* points = layer.point.data() + stroke.begin;
        strokes_.push_back(
            {points, (stroke.count - 1) / divisions_ + 1, divisions_, entry.set, stroke.pass, stroke.closed});
    }
}

// Whole strokes, the last ones first; but of the first one what fits.
void Hatching::keep_to_budget() {
    for (const OrderedStroke& stroke : strokes_) report_.full_count += stroke.count;
    if (settings_.budget == 0) return;
    std::int64_t sum = 0;
    std::int64_t kept = 0;
    for (; kept < strokes_.size() && sum + strokes_[kept].count <= settings_.budget; ++kept)
        sum += strokes_[kept].count;
    if (kept == 0 && !strokes_.empty()) {
        OrderedStroke& first = strokes_[kept++];
        const std::int64_t cut = first.count - settings_.budget;
        first.count = settings_.budget;
        first.closed = false;
        report_.of(first.pass).attempted += cut;
        report_.of(first.pass).dropped_budget += cut;
    }
    for (std::int64_t s = kept; s < strokes_.size(); ++s) {
        report_.of(strokes_[s].pass).attempted += strokes_[s].count;
        report_.of(strokes_[s].pass).dropped_budget += strokes_[s].count;
    }
    strokes_.resize(kept);
}

double Hatching::run(marks::Marks& marks, const base::Progress& progress) {
    const double rough = cells_.rough_area();
    measure(rough);
    const double spaces = rough / (separation_ * separation_);
    const std::int64_t samples = field_samples_for(
        static_cast<std::int64_t>(std::min(1e12, static_cast<double>(sets) * spaces / automatic_step)));
    const StrokeFieldResult field =
        make_stroke_field(site_, cells_, settings_.kind, settings_, samples, progress.part(0.0, 0.4));
    measure(field.area);
    lay(field.field, progress.part(0.4, 0.7));
    order();
    keep_to_budget();
    if (field.first_set)
        strokes_ = split_by_set(site_.runtime, strokes_, *field.first_set, separation_ / step_, progress);
    settle_strokes(site_, strokes_, {settings_.kind, settings_.direction, separation_, step_, cells_.region}, marks,
                   report_, progress.part(0.7, 1.0));
    report_.step = separation_;
    for (const OrderedStroke& stroke : strokes_) report_.levels = std::max<std::int32_t>(report_.levels, stroke.pass);
    return field.area;
}

} // namespace

std::int64_t field_samples_for(std::int64_t marks) noexcept {
    const std::int64_t fewest = std::clamp<std::int64_t>(2 * marks, 256, fewest_samples); // few marks need few
    return std::clamp(marks / marks_of_sample, fewest, most_samples);
}

double hatch(const marks::Site& site, const stipples::SurfaceCells& cells, const HatchSettings& settings,
             marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress) {
    Hatching hatching(site, cells, settings, report);
    return hatching.run(marks, progress);
}

} // namespace hrbfnpr::strokes
