#include "generate/generate.h"

#include "base/clock.h"
#include "generate/in_unit.h"
#include "generate/make_seeds.h"
#include "marks/assemble.h"
#include "published/growth.h"
#include "stipples/blue_noise.h"
#include "stipples/density_thinning.h"
#include "strokes/hatch.h"

#include <algorithm>

namespace hrbfnpr::generate {
namespace {

constexpr std::int64_t default_budget = 40000; // BLUE_NOISE

std::size_t at(marks::Group group) noexcept { return static_cast<std::size_t>(group); }

class Generation {
public:
    Generation(const marks::Site& site, const SampleHint& samples, const Settings& settings,
               const base::Progress& progress)
        : site_(site), samples_(samples), settings_(settings), progress_(progress),
          seeds_(site.memory()), marks_{marks::Marks(site.memory()), marks::Marks(site.memory()),
                                        marks::Marks(site.memory())},
          set_(site.memory()) {}

    marks::PointSet run();

private:
    [[nodiscard]] bool wanted(marks::Group group) const noexcept { return settings_.group[at(group)].wanted; }
    [[nodiscard]] base::Progress group_progress(marks::Group group) const noexcept;
    void published();
    void published_stipples();
    void published_strokes(marks::Group group);
    void blue_noise();
    void blue_noise_stipples(const stipples::SurfaceCells& cells);
    void blue_noise_strokes(const stipples::SurfaceCells& cells, marks::Group group);
    [[nodiscard]] std::int64_t budget_of(marks::Group group) const noexcept;
    [[nodiscard]] std::int64_t stroke_budget(marks::Group group) const;
    [[nodiscard]] std::int64_t spread_marks(marks::Group group) const;
    void require_some() const;
    void finish();

    const marks::Site& site_;
    const SampleHint& samples_;
    const Settings& settings_;
    base::Progress progress_;
    marks::Seeds seeds_;
    std::array<marks::Marks, marks::group_count> marks_;
    double area_ = 0.0; // of the surface, where it is known
    marks::PointSet set_;
};

// Seeds take the first tenth, the last part is for assembling; the groups share the rest.
base::Progress Generation::group_progress(marks::Group group) const noexcept {
    const auto first = 0.2 + 0.25 * static_cast<double>(group);
    return progress_.part(first, first + 0.25);
}

// ---- PAPER ---------------------------------------------------------------------------------

std::int32_t stipple_levels_needed(const Settings& settings) noexcept {
    std::int32_t levels = settings.group[0].wanted ? settings.group[0].published.levels : -1;
    if (levels >= 0) return levels;
    for (const GroupSettings& group : settings.group)
        if (group.wanted && group.published.from_stipples) levels = std::max(levels, group.published.seed_level);
    return levels;
}

void Generation::published_stipples() {
    const std::int32_t levels = stipple_levels_needed(settings_);
    if (levels < 0) return;
    const base::Stopwatch watch;
    marks::GroupReport& report = set_.group[0].report;
    const published::Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
    const std::int64_t budget = wanted(marks::Group::stipple) ? settings_.group[0].budget : 0;
    published::grow_stipples(site_, start, {marks::Group::stipple, levels, seeds_.step, budget}, marks_[0], report,
                             group_progress(marks::Group::stipple));
    report.seconds = watch.seconds();
}

void Generation::published_strokes(marks::Group group) {
    const base::Stopwatch watch;
    const GroupSettings& settings = settings_.group[at(group)];
    marks::GroupReport& report = set_.group[at(group)].report;
    const published::GrowthSettings growth{group, settings.published.levels, seeds_.step, settings.budget};
    if (settings.published.from_stipples) {
        geometry::VecArray position(site_.memory());
        geometry::VecArray normal(site_.memory());
        for (std::int64_t i = 0; i < marks_[0].count(); ++i) {
            if (marks_[0].level[i] > settings.published.seed_level) continue;
            position.push_back(marks_[0].position[i]);
            normal.push_back(marks_[0].normal[i]);
        }
        const std::int64_t full = marks::grown_count(seeds_.report.attempted, 5, settings.published.seed_level);
        published::grow_strokes(site_, {position, normal, full}, growth, marks_[at(group)], report,
                                group_progress(group));
    } else {
        const published::Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
        published::grow_strokes(site_, start, growth, marks_[at(group)], report, group_progress(group));
    }
    report.seconds = watch.seconds();
}

void Generation::published() {
    published_stipples();
    for (const marks::Group group : {marks::Group::curvature, marks::Group::combing})
        if (wanted(group)) published_strokes(group);
    if (wanted(marks::Group::stipple)) return;
    marks_[0] = marks::Marks(site_.memory()); // they were only seeds of strokes
    set_.group[0].report = {};
}

// ---- BLUE_NOISE ----------------------------------------------------------------------------

// 0 = no limit: only where the separation of strokes limits them.
std::int64_t Generation::stroke_budget(marks::Group group) const {
    const std::int64_t budget = settings_.group[at(group)].budget;
    return budget == 0 && settings_.strokes.separation > 0.0 ? 0 : budget_of(group);
}

std::int64_t Generation::budget_of(marks::Group group) const noexcept {
    const GroupSettings& settings = settings_.group[at(group)];
    return settings.budget > 0 ? settings.budget : default_budget;
}

// Marks that are spread over the surface at once: stipples, or the samples of a field of directions.
std::int64_t Generation::spread_marks(marks::Group group) const {
    return group == marks::Group::stipple ? budget_of(group) : strokes::field_samples_for(budget_of(group));
}

void Generation::blue_noise_stipples(const stipples::SurfaceCells& cells) {
    const base::Stopwatch watch;
    marks::GroupReport& report = set_.group[0].report;
    stipples::EvenMarks even = stipples::spread_by_density(site_, cells, budget_of(marks::Group::stipple),
                                                           settings_.density, group_progress(marks::Group::stipple));
    marks::Marks& marks = marks_[0];
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
    report.level[0] = even.report;
    report.full_count = count;
    report.seconds = watch.seconds();
}

void Generation::blue_noise_strokes(const stipples::SurfaceCells& cells, marks::Group group) {
    const base::Stopwatch watch;
    marks::GroupReport& report = set_.group[at(group)].report;
    strokes::HatchSettings settings{settings_.strokes};
    settings.group = group;
    settings.budget = stroke_budget(group);
    area_ = std::max(area_, strokes::hatch(site_, cells, settings, marks_[at(group)], report, group_progress(group)));
    report.seconds = watch.seconds();
}

void Generation::blue_noise() {
    std::int64_t most = 1;
    for (const marks::Group group : {marks::Group::stipple, marks::Group::curvature, marks::Group::combing})
        if (wanted(group)) most = std::max(most, spread_marks(group));
    const stipples::SurfaceCells cells =
        stipples::cover_surface(site_, seeds_, samples_.spacing, most, progress_.part(0.1, 0.2));
    if (wanted(marks::Group::stipple)) blue_noise_stipples(cells);
    for (const marks::Group group : {marks::Group::curvature, marks::Group::combing})
        if (wanted(group)) blue_noise_strokes(cells, group);
}

// --------------------------------------------------------------------------------------------

void Generation::require_some() const {
    marks::LevelReport all;
    for (std::size_t group = 0; group < marks_.size(); ++group) {
        if (marks_[group].count() > 0) return;
        for (const marks::LevelReport& level : set_.group[group].report.level) {
            all.attempted += level.attempted;
            all.dropped_not_converged += level.dropped_not_converged;
            all.dropped_strayed += level.dropped_strayed;
            all.dropped_degenerate += level.dropped_degenerate;
        }
    }
    // A budget of a few marks may be too small for the shortest stroke.
    if (all.attempted == 0 && settings_.strokes.separation == 0.0 && settings_.strokes.step == 0.0) return;
    fail(Status::not_converged,
         "no mark could be placed: of %lld, %lld did not converge, %lld strayed and %lld were degenerate; no stroke is "
         "shorter than 2.5 times stroke_separation, or has a stroke_step below the projection_tolerance",
         static_cast<long long>(all.attempted), static_cast<long long>(all.dropped_not_converged),
         static_cast<long long>(all.dropped_strayed), static_cast<long long>(all.dropped_degenerate));
}

void Generation::finish() {
    require_some();
    const std::array<const geometry::VecArray*, marks::group_count> positions = {
        &marks_[0].position, &marks_[1].position, &marks_[2].position};
    measure(site_.runtime, positions, area_, set_, progress_.part(0.95, 0.95));
    for (const marks::Group group : {marks::Group::stipple, marks::Group::curvature, marks::Group::combing}) {
        if (!wanted(group)) continue;
        marks::AssembleSettings settings;
        settings.group = group;
        settings.with_curvature = group == marks::Group::curvature || settings_.group[at(group)].with_curvature;
        settings.progressive = settings_.distribution == marks::Distribution::blue_noise;
        settings.strokes = set_.group[at(group)].report.strokes;
        const std::size_t layer = group == marks::Group::stipple ? 0 : 2 * at(group) - 1;
        settings.part = {settings_.layer[layer], settings_.layer[group == marks::Group::stipple ? 0 : layer + 1]};
        marks::assemble(site_, marks_[at(group)], settings, set_.origin, set_.group[at(group)],
                        progress_.part(0.95, 1.0));
        marks_[at(group)] = marks::Marks(site_.memory()); // gives the doubles back
    }
}

marks::PointSet Generation::run() {
    const base::Stopwatch watch;
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
    for (std::size_t k = 0; k < settings.group.size(); ++k) {
        const GroupSettings& group = settings.group[k];
        if (!group.wanted) continue;
        const std::int64_t grown = k == 0 ? marks::grown_count(seeds, 5, group.published.levels)
                                          : marks::grown_count(2 * seeds, 3, group.published.levels);
        const std::int64_t budget = group.budget > 0 ? group.budget : default_budget;
        const double cost = k == 1 ? 8.0 : 3.0; // with Hessians on the way, or without
        evaluations += cost * static_cast<double>(published ? grown : candidates_each * budget);
    }
    return evaluations;
}

marks::PointSet generate(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                         const Settings& settings, const base::Progress& progress) {
    check_request(implicit, settings);
    const InUnit in_unit(runtime, implicit, samples, settings);
    const marks::Site site = in_unit.site();
    marks::PointSet set = Generation(site, in_unit.samples(), in_unit.settings(), progress).run();
    to_callers_unit(set, site.unit);
    return set;
}

} // namespace hrbfnpr::generate
