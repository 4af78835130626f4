// SPDX-License-Identifier: MIT
#include "generate/generate.h"

#include "base/clock.h"
#include "generate/in_unit.h"
#include "generate/make_seeds.h"
#include "hatching/hatching.h"
#include "marks/assemble.h"
#include "marks/clusters.h"
#include "published/growth.h"
#include "stipples/blue_noise.h"
#include "stipples/density_thinning.h"

#include <algorithm>
#include <optional>

namespace hrbfnpr::generate {
namespace {

// A layer while it grows.
struct Growing {
    Growing(const marks::Site& all, const LayerSettings& its, std::int64_t number, std::int64_t number_of_kind) noexcept
        : settings(its), place(number), site(all), marks(all.memory()) {
        site.random_seed = marks::layer_seed(all.random_seed, its.kind, number_of_kind);
    }

    const LayerSettings& settings;
    std::int64_t place; // in the list
    marks::Site site;   // with random numbers of its own
    marks::Marks marks;
};

class Generation {
public:
    Generation(const marks::Site& site, const SampleHint& samples, const Settings& settings,
               const base::Progress& progress)
        : site_(site), samples_(samples), settings_(settings), progress_(progress), seeds_(site.memory()),
          growing_(site.memory()), set_(site.memory()) {}

    marks::PointSet run();

private:
    void add_layers();
    [[nodiscard]] marks::LayerReport& report_of(const Growing& layer) noexcept {
        return set_.layers[layer.place].report;
    }
    [[nodiscard]] base::Progress progress_of(const Growing& layer) const noexcept;
    void published();
    void published_stipples(Growing& layer);
    void published_strokes(Growing& layer, const marks::Marks* stipples);
    [[nodiscard]] marks::Marks stipples_to_start_from() const;
    void blue_noise();
    void blue_noise_stipples(const stipples::SurfaceCells& cells, Growing& layer);
    void hatch(Growing& layer);
    void soften(const Growing& layer, const base::Progress& progress);
    void require_some() const;
    void finish();

    const marks::Site& site_;
    const SampleHint& samples_;
    const Settings& settings_;
    base::Progress progress_;
    marks::Seeds seeds_;
    base::List<Growing> growing_;
    std::optional<hatching::Ground> ground_; // of the last layer of hatching
    double area_ = 0.0;                      // of the surface, where it is known
    std::int64_t largest_ = 0;               // marks in one layer
    marks::PointSet set_;
};

void Generation::add_layers() {
    std::array<std::int64_t, marks::kind_count> of_kind{};
    for (const LayerSettings& settings : settings_.layers) {
        const std::int64_t number = of_kind[static_cast<std::size_t>(settings.kind)]++;
        growing_.add(site_, settings, growing_.size(), number);
        marks::Layer& layer = set_.layers.add(site_.memory(), settings.kind);
        layer.name = settings.name;
        layer.progressive = settings_.distribution == marks::Distribution::blue_noise;
    }
}

// Seeds take the first tenth, the last part is for assembling; the layers share the rest.
base::Progress Generation::progress_of(const Growing& layer) const noexcept {
    const double each = 0.75 / static_cast<double>(growing_.size());
    const double first = 0.2 + each * static_cast<double>(layer.place);
    return progress_.part(first, first + each);
}

// ---- PUBLISHED -----------------------------------------------------------------------------

void Generation::published_stipples(Growing& layer) {
    const base::Stopwatch watch;
    const published::Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
    published::GrowthSettings growth;
    growth.layer = layer.place;
    growth.levels = layer.settings.published.levels;
    growth.step = seeds_.step;
    growth.budget = layer.settings.budget;
    published::grow_stipples(layer.site, start, growth, layer.marks, report_of(layer), progress_of(layer));
    report_of(layer).seconds = watch.seconds();
}

// Where no layer of stipples is wanted.
marks::Marks Generation::stipples_to_start_from() const {
    std::int32_t levels = -1;
    for (const Growing& layer : growing_)
        if (layer.settings.published.from_stipples) levels = std::max(levels, layer.settings.published.start_level);
    marks::Marks stipples(site_.memory());
    if (levels < 0) return stipples;
    const published::Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
    published::GrowthSettings growth;
    growth.layer = -1;
    growth.levels = levels;
    growth.step = seeds_.step;
    marks::LayerReport report(site_.memory());
    published::grow_stipples(site_, start, growth, stipples, report, progress_.part(0.1, 0.2));
    return stipples;
}

published::Directions published_directions(const hatching::Settings& settings) noexcept {
    if (settings.direction.function != nullptr) return published::Directions::function;
    return settings.field.guide == hatching::Guide::combing ? published::Directions::combing
                                                            : published::Directions::principal;
}

void Generation::published_strokes(Growing& layer, const marks::Marks* stipples) {
    const base::Stopwatch watch;
    const LayerSettings& settings = layer.settings;
    published::GrowthSettings growth;
    growth.layer = layer.place;
    growth.levels = settings.published.levels;
    growth.step = seeds_.step;
    growth.budget = settings.budget;
    growth.directions = published_directions(settings.hatching);
    growth.function = settings.hatching.direction;
    marks::LayerReport& report = report_of(layer);
    if (settings.published.from_stipples) {
        geometry::VecArray position(site_.memory());
        geometry::VecArray normal(site_.memory());
        for (std::int64_t i = 0; i < stipples->count(); ++i) {
            if (stipples->level[i] > settings.published.start_level) continue;
            position.push_back(stipples->position[i]);
            normal.push_back(stipples->normal[i]);
        }
        const std::int64_t full = marks::grown_count(seeds_.report.attempted, 5, settings.published.start_level);
        published::grow_strokes(layer.site, {position, normal, full}, growth, layer.marks, report, progress_of(layer));
    } else {
        const published::Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
        published::grow_strokes(layer.site, start, growth, layer.marks, report, progress_of(layer));
    }
    report.seconds = watch.seconds();
}

void Generation::published() {
    const marks::Marks* stipples = nullptr; // of the first layer of them
    for (Growing& layer : growing_) {
        if (layer.settings.has_strokes()) continue;
        published_stipples(layer);
        if (stipples == nullptr) stipples = &layer.marks;
    }
    const marks::Marks hidden = stipples == nullptr ? stipples_to_start_from() : marks::Marks(site_.memory());
    for (Growing& layer : growing_)
        if (layer.settings.has_strokes()) published_strokes(layer, stipples != nullptr ? stipples : &hidden);
}

// ---- BLUE_NOISE ----------------------------------------------------------------------------

void Generation::blue_noise_stipples(const stipples::SurfaceCells& cells, Growing& layer) {
    const base::Stopwatch watch;
    marks::LayerReport& report = report_of(layer);
    stipples::EvenMarks even = stipples::spread_by_density(layer.site, cells, layer.settings.budget,
                                                           layer.settings.density, progress_of(layer));
    marks::Marks& marks = layer.marks;
    const std::int64_t count = even.position.size();
    marks.position = std::move(even.position);
    marks.normal = std::move(even.normal);
    marks.key.resize(count);
    marks.stroke.resize(count);
    marks.place.resize(count);
    marks.level.resize(count);
    for (std::int64_t i = 0; i < count; ++i) {
        marks.key[i] = static_cast<std::uint64_t>(i);
        marks.stroke[i] = static_cast<std::uint32_t>(i);
    }
    area_ = std::max(area_, even.area);
    report.of(0) = even.report;
    report.full_count = count;
    report.seconds = watch.seconds();
}

hatching::Settings hatching_of(const Growing& layer) {
    hatching::Settings settings = layer.settings.hatching;
    settings.layer = layer.place;
    settings.budget = layer.settings.budget;
    settings.field.diagonal = layer.site.implicit.diagonal();
    return settings;
}

// Layers of hatching that are alike but for their angles share what they are laid on.
// What that is does not depend on the other layers: it has cells of its own.
void Generation::hatch(Growing& layer) {
    const base::Stopwatch watch;
    const hatching::Settings settings = hatching_of(layer);
    const base::Progress progress = progress_of(layer);
    if (!ground_ || !settings.is_on_ground_of(ground_->settings()))
        ground_.emplace(site_,
                        stipples::cover_surface(site_, seeds_, samples_.spacing, hatching::hatching_tuning.most_samples,
                                                progress.part(0.0, 0.1)),
                        settings, progress.part(0.1, 0.6));
    ground_->lay_lines(site_, settings, layer.marks, report_of(layer), progress.part(0.6, 1.0));
    area_ = std::max(area_, ground_->area());
    report_of(layer).seconds = watch.seconds();
}

void Generation::blue_noise() {
    std::int64_t most = 1;
    for (const LayerSettings& layer : settings_.layers)
        if (!layer.has_strokes()) most = std::max(most, layer.budget);
    const stipples::SurfaceCells cells =
        stipples::cover_surface(site_, seeds_, samples_.spacing, most, progress_.part(0.1, 0.2));
    for (Growing& layer : growing_) {
        if (layer.settings.has_strokes())
            hatch(layer);
        else
            blue_noise_stipples(cells, layer);
    }
}

// --------------------------------------------------------------------------------------------

void Generation::require_some() const {
    marks::LevelReport all;
    bool lengths_given = false;
    for (const Growing& layer : growing_) {
        if (layer.marks.count() > 0) return;
        const hatching::Settings& hatching = layer.settings.hatching;
        lengths_given = lengths_given || hatching.separation > 0.0 || hatching.step > 0.0;
        for (const marks::LevelReport& level : set_.layers[layer.place].report.level) {
            all.attempted += level.attempted;
            all.dropped_not_converged += level.dropped_not_converged;
            all.dropped_strayed += level.dropped_strayed;
            all.dropped_degenerate += level.dropped_degenerate;
        }
    }
    if (all.attempted == 0 && !lengths_given) return;
    fail(Status::not_converged,
         "no mark could be placed: of %lld, %lld did not converge, %lld strayed and %lld were degenerate; with lines, "
         "set a smaller separation, and a step above the projection_tolerance",
         static_cast<long long>(all.attempted), static_cast<long long>(all.dropped_not_converged),
         static_cast<long long>(all.dropped_strayed), static_cast<long long>(all.dropped_degenerate));
}

void Generation::soften(const Growing& layer, const base::Progress& progress) {
    const double length = layer.settings.tone_smoothing * site_.implicit.diagonal();
    const marks::Marks& marks = layer.marks;
    if (!(length > 0.0) || marks.count() == 0) return;
    const double area = area_ > 0.0 ? area_ : set_.spacing * set_.spacing * static_cast<double>(largest_);
    const double spacing = std::sqrt(area / static_cast<double>(marks.count()));
    marks::soften_normals(layer.site, marks, length, spacing, set_.layers[layer.place].tone_normal, progress);
}

void Generation::finish() {
    require_some();
    base::Array<const geometry::VecArray*> positions(site_.memory());
    for (const Growing& layer : growing_) positions.push_back(&layer.marks.position);
    measure(site_.runtime, positions.span(), area_, set_, progress_.part(0.95, 0.95));
    for (const Growing& layer : growing_) largest_ = std::max(largest_, layer.marks.count());
    for (Growing& layer : growing_) {
        soften(layer, progress_.part(0.95, 1.0));
        marks::AssembleSettings settings;
        settings.strokes = layer.settings.has_strokes();
        settings.with_curvature = !layer.marks.curvature.empty() || layer.settings.with_curvature;
        settings.part = layer.settings.part;
        marks::assemble(layer.site, layer.marks, settings, set_.origin, set_.layers[layer.place],
                        progress_.part(0.95, 1.0));
        layer.marks = marks::Marks(site_.memory()); // gives the doubles back
    }
}

marks::PointSet Generation::run() {
    const base::Stopwatch watch;
    add_layers();
    seeds_ = make_seeds(site_, samples_, settings_, progress_.part(0.0, 0.1));
    set_.distribution = settings_.distribution;
    set_.seed_source = seeds_.source;
    set_.seeds = seeds_.report;
    set_.seconds_seeds = watch.seconds();
    if (settings_.distribution == marks::Distribution::published)
        published();
    else
        blue_noise();
    finish();
    set_.seconds_total = watch.seconds();
    progress_.update(1.0);
    return std::move(set_);
}

} // namespace

double expected_evaluations(const SampleHint& samples, const Settings& settings) noexcept {
    const bool published = settings.distribution == marks::Distribution::published;
    const std::int64_t seeds = settings.seeds.source == marks::SeedSource::points
                                   ? settings.seeds.points.count
                                   : static_cast<std::int64_t>(samples.position.size() / 3);
    constexpr std::int64_t candidates_each = 5; // of BLUE_NOISE, with cells and projection
    double evaluations = 0.0;
    for (const LayerSettings& layer : settings.layers) {
        const std::int64_t grown = layer.has_strokes() ? marks::grown_count(2 * seeds, 3, layer.published.levels)
                                                       : marks::grown_count(seeds, 5, layer.published.levels);
        const std::int64_t budget = layer.budget > 0 ? layer.budget : default_budget;
        // With Hessians on the way, or without.
        const bool by_curvature = layer.has_strokes() && published &&
                                  published_directions(layer.hatching) == published::Directions::principal;
        const double cost = by_curvature ? 8.0 : 3.0;
        evaluations += cost * static_cast<double>(published ? grown : candidates_each * budget);
    }
    return evaluations;
}

marks::PointSet generate(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                         const Settings& given, const base::Progress& progress) {
    const Settings settings = completed(given);
    check_request(implicit, settings);
    const InUnit in_unit(runtime, implicit, samples, settings);
    const marks::Site site = in_unit.site();
    marks::PointSet set = Generation(site, in_unit.samples(), in_unit.settings(), progress).run();
    to_callers_unit(set, site.unit);
    marks::cluster_marks(runtime, set, progress);
    for (const marks::Layer& layer : set.layers)
        runtime.log(base::LogLevel::info, "generate: %lld marks in layer '%s' in %.3f s",
                    static_cast<long long>(layer.count()), layer.name.data(), layer.report.seconds);
    return set;
}

} // namespace hrbfnpr::generate
