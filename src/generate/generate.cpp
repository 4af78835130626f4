// SPDX-License-Identifier: MIT
#include "generate/generate.h"

#include "base/assert.h"
#include "base/clock.h"
#include "base/random.h"
#include "generate/tuning.h"
#include "geometry/tangent_frame.h"
#include "geometry/unit.h"
#include "hatching/hatching.h"
#include "implicit/scaled.h"
#include "marks/assemble.h"
#include "marks/point_set.h"
#include "published/growth.h"
#include "stipples/blue_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

namespace hrbfnpr::generate {
namespace {

// ---- The model's unit

// A model, its samples and the lengths of the settings in a unit of about the model's size, so that floats can hold
// squares and cubes of lengths.
struct ScaledInput {
    // The settings must have passed check_request(). All arguments must outlive this object.
    ScaledInput(const base::Work& work, const implicit::Implicit& implicit, const SampleHint& given_samples,
                const Settings& given)
        : work_of_all(work), unscaled(implicit), unit(geometry::unit_for(implicit.diagonal())),
          sample_position(work.memory), seed_position(work.memory), samples(given_samples), settings(given) {
        if (unit == 1.0) return;
        HRBFNPR_ASSERT(unit > 0.0);
        scaled.emplace(implicit, unit);
        for (const double coordinate : given_samples.position) sample_position.push_back(coordinate / unit);
        samples = {sample_position.span(), given_samples.spacing / unit};
        const base::InView& seeds = given.seeds.points;
        for (std::int64_t i = 0; i < seeds.count; ++i)
            for (std::uint32_t axis = 0; axis < 3; ++axis) seed_position.push_back(seeds.get(i, axis) / unit);
        if (!seeds.empty())
            settings.seeds.points = {reinterpret_cast<const std::byte*>(seed_position.data()), seeds.count,
                                     3 * std::int64_t{sizeof(double)}, base::Scalar::float64, 3};
        settings.seeds.initial_step /= unit;
        for (LayerSettings& layer : settings.layers)
            for (double* length : {&layer.hatching.separation, &layer.hatching.step}) *length /= unit;
    }

    [[nodiscard]] marks::Site site() const noexcept {
        return {work_of_all, scaled ? *scaled : unscaled, settings.projection_tolerance, settings.random_seed, unit};
    }

    base::Work work_of_all;
    const implicit::Implicit& unscaled;
    double unit;
    std::optional<implicit::Scaled> scaled; // empty if the unit is the caller's unit
    base::Array<double> sample_position, seed_position;
    SampleHint samples;
    Settings settings;
};

// Converts the lengths of a finished set to the caller's unit. Throws Error{invalid_argument} for lengths that a float
// cannot hold.
void to_callers_unit(marks::PointSet& set, double unit) {
    if (unit == 1.0) return;
    set.origin *= unit;
    set.bounds = {unit * set.bounds.min, unit * set.bounds.max};
    set.spacing *= unit;
    if (const double side = set.bounds.longest_side(); side > 0.0)
        marks::require_size("the marks are", side, "samples (or a custom model's function)");
    constexpr double largest = std::numeric_limits<float>::max();
    for (marks::Layer& layer : set.layers) {
        for (float& number : layer.position) number = static_cast<float>(unit * double{number});
        for (std::int64_t i = 0; i < layer.curvature.size(); ++i) { // the third number, the confidence, is not scaled
            float& k = layer.curvature[i];
            if (i % 3 != 2) k = static_cast<float>(std::clamp((1.0 / unit) * double{k}, -largest, largest));
        }
        layer.report.step *= unit;
    }
}

void check_length(const char* field, double length, double diagonal) {
    const double part = length / diagonal;
    if (length == 0.0 || (part >= generate_tuning.shortest_length && part <= generate_tuning.longest_length)) return;
    fail(Status::invalid_argument,
         "generate_desc.%s is %g, %.2g times the model's diagonal; it must be 0, or %g to %g times the diagonal", field,
         length, part, generate_tuning.shortest_length, generate_tuning.longest_length);
}

// ---- Layers

// The inputs that all layers have in common.
struct GenerateInput {
    const marks::Site& site;
    const SampleHint& samples;
    const Settings& settings;
    const marks::Seeds& seeds;
};

// A layer while it grows.
struct GrowingLayer {
    GrowingLayer(const marks::Site& all, const LayerSettings& its, std::int64_t number,
                 std::int64_t number_of_kind) noexcept
        : settings(its), place(number), site(all), marks(all.memory()) {
        site.random_seed = marks::layer_seed(all.random_seed, its.kind, number_of_kind);
    }
    // Returns the site with the layer's share of the progress. Seeds take the first tenth of the whole progress, the
    // preparation of the layers takes the second tenth, and assembling takes the last twentieth. The layers share the
    // rest equally.
    [[nodiscard]] marks::Site part_of(const GenerateInput& input) const noexcept {
        const double each = 0.75 / static_cast<double>(input.settings.layers.size());
        const double first = 0.2 + each * static_cast<double>(place);
        return site.part(first, first + each);
    }

    const LayerSettings& settings;
    std::int64_t place; // the layer's index in the list of layers
    marks::Site site;   // the site, with the random seed of the layer
    marks::Marks marks;
};

// ---- PUBLISHED

[[nodiscard]] published::Directions published_directions(const hatching::Settings& settings) noexcept {
    if (settings.direction.function != nullptr) return published::Directions::function;
    return settings.field.guide == hatching::Guide::combing ? published::Directions::combing
                                                            : published::Directions::principal;
}

[[nodiscard]] published::GrowthSettings growth_of(const GenerateInput& input, const GrowingLayer& layer) {
    published::GrowthSettings growth;
    growth.layer = layer.place;
    growth.levels = layer.settings.published.levels;
    growth.step = input.seeds.step;
    growth.budget = layer.settings.budget;
    growth.directions = published_directions(layer.settings.hatching);
    growth.function = layer.settings.hatching.direction;
    return growth;
}

// Grows all layers. Strokes start from seeds, from the first layer of stipples, or from stipples made only for them.
void grow_published(const GenerateInput& input, base::List<GrowingLayer>& growing, marks::PointSet& set) {
    const marks::Seeds& seeds = input.seeds;
    const published::Start from_seeds{seeds.position, seeds.normal, seeds.report.attempted};
    const marks::Marks* stipples = nullptr;
    std::int32_t levels_to_start = -1;
    for (GrowingLayer& layer : growing) {
        if (layer.settings.published.from_stipples)
            levels_to_start = std::max(levels_to_start, layer.settings.published.start_level);
        if (layer.settings.has_strokes()) continue;
        const base::Stopwatch watch;
        marks::LayerReport& report = set.layers[layer.place].report;
        published::grow_stipples(layer.part_of(input), from_seeds, growth_of(input, layer), layer.marks, report);
        report.seconds = watch.seconds();
        if (stipples == nullptr) stipples = &layer.marks;
    }
    marks::Marks hidden(input.site.memory());
    if (stipples == nullptr && levels_to_start >= 0) {
        published::GrowthSettings growth;
        growth.layer = -1;
        growth.levels = levels_to_start;
        growth.step = seeds.step;
        marks::LayerReport report(input.site.memory());
        published::grow_stipples(input.site.part(0.1, 0.2), from_seeds, growth, hidden, report);
    }
    if (stipples == nullptr) stipples = &hidden;
    for (GrowingLayer& layer : growing) {
        if (!layer.settings.has_strokes()) continue;
        const base::Stopwatch watch;
        marks::LayerReport& report = set.layers[layer.place].report;
        const published::Settings& its = layer.settings.published;
        geometry::VecArray position(input.site.memory());
        geometry::VecArray normal(input.site.memory());
        for (std::int64_t i = 0; its.from_stipples && i < stipples->count(); ++i) {
            if (stipples->level[i] > its.start_level) continue;
            position.push_back(stipples->position[i]);
            normal.push_back(stipples->normal[i]);
        }
        const published::Start from_stipples{position, normal,
                                             marks::grown_count(seeds.report.attempted, 5, its.start_level)};
        published::grow_strokes(layer.part_of(input), its.from_stipples ? from_stipples : from_seeds,
                                growth_of(input, layer), layer.marks, report);
        report.seconds = watch.seconds();
    }
}

// ---- BLUE_NOISE

// Makes even stipples for all layers of stipples. Returns the area of the surface.
double spread_stipples(const GenerateInput& input, const stipples::SurfaceCells& cells, GrowingLayer& layer,
                       marks::LayerReport& report) {
    const base::Stopwatch watch;
    stipples::EvenMarks even =
        stipples::spread_by_density(layer.part_of(input), cells, layer.settings.budget, layer.settings.density);
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
    // The first mark gets the highest rank.
    for (const double place : even.place) marks.rank.push_back(marks::rank_of(1.0 - place));
    marks.whole = even.whole;
    report.of(0) = even.report;
    report.full_count = count;
    report.seconds = watch.seconds();
    return even.area;
}

// Places the lines of a layer of hatching. Layers that differ only in the angle of their lines share a HatchingField,
// through `last`. The field has its own cells and uses the random seed of the set, so it does not depend on the other
// layers. Returns the area of the surface.
double place_hatching(const GenerateInput& input, GrowingLayer& layer, std::optional<hatching::HatchingField>& last,
                      marks::LayerReport& report) {
    const base::Stopwatch watch;
    // The samples use the random seed of the whole set, not the layer's.
    marks::Site site = input.site.with(layer.part_of(input).work);
    site.need = layer.site.need;
    hatching::Settings settings = layer.settings.hatching;
    settings.layer = layer.place;
    settings.budget = layer.settings.budget;
    settings.field.diagonal = site.implicit.diagonal();
    const bool is_covered = last && (last->is_whole() || site.need != nullptr);
    if (!is_covered || !settings.shares_field_with(last->settings()))
        last.emplace(site.part(0.1, 0.6),
                     stipples::cover_surface(site.part(0.0, 0.1), input.seeds, input.samples.spacing,
                                             hatching::hatching_tuning.most_samples),
                     settings);
    last->place_lines(site.part(0.6, 1.0), settings, layer.marks, report);
    report.seconds = watch.seconds();
    return last->area();
}

// The needs of a still picture for each layer. It is empty if all marks are placed.
class StillNeeds {
public:
    StillNeeds(const GenerateInput& input, base::List<GrowingLayer>& growing, double area) {
        const frame::Still* const still = input.settings.still;
        if (still == nullptr || still->style.visibility == frame::Visibility::published) return;
        const marks::Site& site = input.site;
        const geometry::Bounds& bounds = site.implicit.bounds();
        view_.emplace(site.memory(), *still, geometry::Bounds{site.unit * bounds.min, site.unit * bounds.max},
                      site.unit);
        needs_.reserve(static_cast<std::size_t>(growing.size()));
        for (GrowingLayer& layer : growing) {
            const marks::TonePart& part = layer.settings.part[0];
            // The share of the order that a tone shows is at most the share for the whole range of tones, if the range
            // of the layer ends at the darkest tone. If it ends before, all marks are placed.
            const bool is_bounded = part.end == 1.0 && (part.begin == 0.0 || !layer.settings.has_strokes());
            if (!is_bounded) continue;
            needs_.emplace_back(*view_, need_of(layer, growing, area));
            layer.site.need = &needs_.back();
        }
    }

    // Notes in the set which drawing it is for, if marks were left out.
    void note(const GenerateInput& input, marks::PointSet& set) const {
        if (needs_.empty()) return;
        set.still = frame::still_key(input.site.memory(), *input.settings.still);
    }

private:
    // Returns about how many marks a layer would have on the whole surface.
    [[nodiscard]] static double expected_marks(const LayerSettings& layer, double area) noexcept {
        if (!layer.has_strokes() || layer.hatching.separation <= 0.0) return static_cast<double>(layer.budget);
        const double step = layer.hatching.step > 0.0 ? layer.hatching.step
                                                      : hatching::hatching_tuning.step * layer.hatching.separation;
        return area / (layer.hatching.separation * step);
    }

    [[nodiscard]] frame::StillLayer need_of(const GrowingLayer& layer, base::List<GrowingLayer>& growing,
                                            double area) const {
        const marks::Kind kind = layer.settings.kind;
        frame::StillLayer need{kind, &style_of(layer), false, true};
        double largest = 0.0;
        double stipples = 0.0;
        for (const GrowingLayer& other : growing) {
            if (&other != &layer && style_of(other).shown && style_of(other).shape != frame::Shape::hatch)
                need.makes_tone_alone = false;
            if (!style_of(other).shown && !style_of(other).contours) continue;
            const double expected = expected_marks(other.settings, area);
            largest = std::max(largest, expected);
            if (!other.settings.has_strokes()) stipples = std::max(stipples, expected);
        }
        const double share = stipples / largest;
        const double limit = frame::scene_tuning.enough_stipples;
        need.may_be_splats = kind == marks::Kind::stipples ? share > 0.8 * limit : !(share > 1.25 * limit);
        return need;
    }

    [[nodiscard]] const frame::LayerStyle& style_of(const GrowingLayer& layer) const {
        marks::Layer named(layer.site.memory(), layer.settings.kind);
        if (layer.settings.name[0] != '\0') named.name = layer.settings.name;
        return view_->item.style.of(named);
    }

    std::optional<frame::StillView> view_;
    std::vector<frame::StillNeed> needs_;
};

// Grows all layers of even stipples and lines. Returns the area of the surface.
double grow_even(const GenerateInput& input, base::List<GrowingLayer>& growing, marks::PointSet& set) {
    std::int64_t most = 1;
    for (const LayerSettings& layer : input.settings.layers)
        if (!layer.has_strokes()) most = std::max(most, layer.budget);
    const stipples::SurfaceCells cells =
        stipples::cover_surface(input.site.part(0.1, 0.2), input.seeds, input.samples.spacing, most);
    const StillNeeds needs(input, growing, cells.rough_area());
    double area = 0.0;
    std::optional<hatching::HatchingField> last;
    for (GrowingLayer& layer : growing) {
        marks::LayerReport& report = set.layers[layer.place].report;
        area = std::max(area, layer.settings.has_strokes() ? place_hatching(input, layer, last, report)
                                                           : spread_stipples(input, cells, layer, report));
    }
    needs.note(input, set);
    return area;
}

// ---- The set

void require_marks(base::List<GrowingLayer>& growing, marks::PointSet& set) {
    marks::LevelReport all;
    bool lengths_given = false;
    for (const GrowingLayer& layer : growing) {
        if (layer.marks.whole_count() > 0) return;
        const hatching::Settings& hatching = layer.settings.hatching;
        lengths_given = lengths_given || hatching.separation > 0.0 || hatching.step > 0.0;
        for (const marks::LevelReport& level : set.layers[layer.place].report.level) {
            all.attempted += level.attempted;
            all.dropped_not_converged += level.dropped_not_converged;
            all.dropped_strayed += level.dropped_strayed;
            all.dropped_degenerate += level.dropped_degenerate;
        }
    }
    if (all.attempted == 0) {
        if (!lengths_given) return;
        fail(Status::not_converged, "no line could be placed; use a smaller separation, or a step above "
                                    "projection_tolerance");
    }
    fail(Status::not_converged,
         "no mark could be placed: of %lld, %lld did not converge, %lld strayed and %lld were degenerate; use a "
         "smaller separation, or a step above projection_tolerance",
         static_cast<long long>(all.attempted), static_cast<long long>(all.dropped_not_converged),
         static_cast<long long>(all.dropped_strayed), static_cast<long long>(all.dropped_degenerate));
}

// Assembles the layers into the set. `area` is the area of the surface; 0: unknown.
void assemble_layers(const marks::Site& site, base::List<GrowingLayer>& growing, double area, marks::PointSet& set) {
    base::Array<const geometry::VecArray*> positions(site.memory());
    std::int64_t largest = 0; // the number of marks that the largest layer has on the whole surface
    for (const GrowingLayer& layer : growing) {
        positions.push_back(&layer.marks.position);
        largest = std::max(largest, layer.marks.whole_count());
    }
    measure(site.work.part(0.95, 0.95), positions.span(), area, largest, set);
    for (GrowingLayer& layer : growing) {
        marks::Layer& to = set.layers[layer.place];
        const double length = layer.settings.tone_smoothing * site.implicit.diagonal();
        if (length > 0.0 && layer.marks.count() > 0) {
            const double known = area > 0.0 ? area : set.spacing * set.spacing * static_cast<double>(largest);
            const double spacing = std::sqrt(known / static_cast<double>(layer.marks.whole_count()));
            marks::average_normals(layer.site, layer.marks, length, spacing, to.tone_normal);
        }
        marks::AssembleSettings settings;
        settings.strokes = layer.settings.has_strokes();
        settings.with_curvature = !layer.marks.curvature.empty() || layer.settings.with_curvature;
        settings.part = layer.settings.part;
        to.whole = layer.marks.whole;
        to.tone_begin = settings.part[0].begin;
        if (to.whole > 0) to.report.full_count = to.whole;
        marks::assemble(layer.site.part(0.95, 1.0), layer.marks, settings, set.origin, to);
        layer.marks = marks::Marks(site.memory()); // free the memory of the marks in double precision
    }
}

} // namespace

void check_request(const implicit::Implicit& implicit, const Settings& settings) {
    const double diagonal = implicit.diagonal();
    marks::require_size("the model's bounds are", diagonal, "samples (or a custom model's function)");
    if (settings.distribution == marks::Distribution::published)
        return check_length("initial_step", settings.seeds.initial_step, diagonal);
    for (std::size_t i = 0; i < settings.layers.size(); ++i) {
        if (!settings.layers[i].has_strokes()) continue;
        const hatching::Settings& lines = settings.layers[i].hatching;
        for (const auto& [field, length] : {std::pair("separation", lines.separation), std::pair("step", lines.step)}) {
            char name[64];
            std::snprintf(name, sizeof name, "layers[%zu].%s", i, field);
            check_length(name, length, diagonal);
        }
    }
}

double expected_evaluations(const SampleHint& samples, const Settings& settings) noexcept {
    const bool published = settings.distribution == marks::Distribution::published;
    const std::int64_t seeds = settings.seeds.source == marks::SeedSource::points
                                   ? settings.seeds.points.count
                                   : static_cast<std::int64_t>(samples.position.size() / 3);
    double evaluations = 0.0;
    for (const LayerSettings& layer : settings.layers) {
        const std::int64_t even = layer.budget > 0 ? layer.budget : default_budget;
        const std::int64_t grown = layer.has_strokes() ? marks::grown_count(2 * seeds, 3, layer.published.levels)
                                                       : marks::grown_count(seeds, 5, layer.published.levels);
        const bool by_curvature =
            layer.has_strokes() && published_directions(layer.hatching) == published::Directions::principal;
        const double each =
            by_curvature ? generate_tuning.evaluations_with_curvature : generate_tuning.evaluations_of_mark;
        evaluations += published ? each * static_cast<double>(grown)
                                 : generate_tuning.evaluations_of_even_mark * static_cast<double>(even);
    }
    return evaluations;
}

marks::PointSet generate(const base::Work& work, const implicit::Implicit& implicit, const SampleHint& samples,
                         const Settings& given) {
    const base::Stopwatch watch;
    const Settings complete = completed(given);
    check_request(implicit, complete);
    const ScaledInput scaled_input(work, implicit, samples, complete);
    const marks::Site site = scaled_input.site();
    const Settings& settings = scaled_input.settings;
    marks::PointSet set(site.memory());
    base::List<GrowingLayer> growing(site.memory());
    std::array<std::int64_t, marks::kind_count> of_kind{};
    for (const LayerSettings& its : settings.layers) {
        growing.add(site, its, growing.size(), of_kind[static_cast<std::size_t>(its.kind)]++);
        marks::Layer& layer = set.layers.add(site.memory(), its.kind);
        layer.name = its.name;
        layer.progressive = settings.distribution == marks::Distribution::blue_noise;
    }
    const marks::Seeds seeds = make_seeds(site.part(0.0, 0.1), scaled_input.samples, settings);
    set.distribution = settings.distribution;
    set.seed_source = seeds.source;
    set.seeds = seeds.report;
    set.seconds_seeds = watch.seconds();
    const GenerateInput input{site, scaled_input.samples, settings, seeds};
    double area = 0.0;
    if (settings.distribution == marks::Distribution::published)
        grow_published(input, growing, set);
    else
        area = grow_even(input, growing, set);
    require_marks(growing, set);
    assemble_layers(site, growing, area, set);
    set.seconds_total = watch.seconds();
    work.update(1.0);
    to_callers_unit(set, site.unit);
    marks::cluster_marks(work, set);
    for (const marks::Layer& layer : set.layers)
        work.runtime().log(base::LogLevel::info, "generate: %lld marks in layer '%s' in %.3f s",
                           static_cast<long long>(layer.count()), layer.name.data(), layer.report.seconds);
    return set;
}

double step_patches(const base::Work& work, const implicit::Implicit& implicit, const SampleHint& samples,
                    const Settings& given, const base::OutView& corners) {
    const Settings settings = completed(given);
    check_request(implicit, settings);
    const ScaledInput scaled_input(work, implicit, samples, settings);
    const marks::Site site = scaled_input.site();
    const marks::Seeds seeds = make_seeds(site, scaled_input.samples, scaled_input.settings);
    // Puts the seeds into a random order, so that patches are at different seeds as long as there are enough seeds.
    struct Ticket {
        std::uint64_t number;
        std::int64_t seed;
        [[nodiscard]] auto operator<=>(const Ticket& other) const noexcept = default;
    };
    base::Array<Ticket> order(site.memory(), seeds.position.size());
    HRBFNPR_ASSERT(!order.empty());
    for (std::int64_t i = 0; i < order.size(); ++i) {
        const base::Philox bits =
            base::philox(site.random_seed, {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32),
                                            static_cast<std::uint32_t>(base::Purpose::patch), 0});
        order[i] = {static_cast<std::uint64_t>(bits[0]) << 32U | bits[1], i};
    }
    std::sort(order.begin(), order.end());
    work.update(1.0); // the last place where the call can be cancelled, before output is written
    for (std::int64_t patch = 0; patch < corners.count; ++patch) {
        const std::int64_t seed = order[patch % order.size()].seed;
        const geometry::TangentFrame frame = geometry::stipple_frame(seeds.normal[seed]);
        // u x r = n, so the corners are counter-clockwise when seen from outside.
        constexpr std::array<std::array<double, 2>, 4> sides = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        std::uint32_t component = 0;
        for (const auto& [along_u, along_r] : sides) {
            const glm::dvec3 corner = seeds.position[seed] + seeds.step * (along_u * frame.u + along_r * frame.r);
            for (int axis = 0; axis < 3; ++axis) corners.set(patch, component++, site.unit * corner[axis]);
        }
    }
    return site.unit * seeds.step;
}

} // namespace hrbfnpr::generate
