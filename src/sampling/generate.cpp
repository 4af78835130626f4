#include "sampling/generate.h"

#include "base/clock.h"
#include "sampling/assemble.h"
#include "sampling/blue_noise.h"
#include "sampling/graded.h"
#include "sampling/growth.h"
#include "sampling/hatch.h"
#include "sampling/in_unit.h"
#include "sampling/seeds.h"

#include <algorithm>

namespace hrbfnpr::sampling {
namespace {

constexpr std::int64_t default_budget = 40000; // BLUE_NOISE

std::size_t at(Group group) noexcept { return static_cast<std::size_t>(group); }

class Generation {
public:
    Generation(const Site& site, const SampleHint& samples, const GenerateSettings& settings,
               const base::Progress& progress)
        : site_(site), samples_(samples), settings_(settings), progress_(progress),
          seeds_(site.memory()), marks_{Marks(site.memory()), Marks(site.memory()), Marks(site.memory())},
          set_(site.memory()) {}

    PointSet run();

private:
    [[nodiscard]] bool wanted(Group group) const noexcept { return settings_.group[at(group)].wanted; }
    [[nodiscard]] base::Progress group_progress(Group group) const noexcept;
    void paper();
    void paper_stipples();
    void paper_strokes(Group group);
    void blue_noise();
    void blue_noise_stipples(const SurfaceCells& cells);
    void blue_noise_strokes(const SurfaceCells& cells, Group group);
    [[nodiscard]] std::int64_t budget_of(Group group) const noexcept;
    [[nodiscard]] std::int64_t stroke_budget(Group group) const;
    [[nodiscard]] std::int64_t spread_marks(Group group) const;
    void require_some() const;
    void finish();

    const Site& site_;
    const SampleHint& samples_;
    const GenerateSettings& settings_;
    base::Progress progress_;
    Seeds seeds_;
    std::array<Marks, group_count> marks_;
    double area_ = 0.0; // of the surface, where it is known
    PointSet set_;
};

// Seeds take the first tenth, the last part is for assembling; the groups share the rest.
base::Progress Generation::group_progress(Group group) const noexcept {
    const auto first = 0.2 + 0.25 * static_cast<double>(group);
    return progress_.part(first, first + 0.25);
}

// ---- PAPER ---------------------------------------------------------------------------------

std::int32_t stipple_levels_needed(const GenerateSettings& settings) noexcept {
    std::int32_t levels = settings.group[0].wanted ? settings.group[0].levels : -1;
    if (levels >= 0) return levels;
    for (const GroupSettings& group : settings.group)
        if (group.wanted && group.from_stipples) levels = std::max(levels, group.seed_level);
    return levels;
}

void Generation::paper_stipples() {
    const std::int32_t levels = stipple_levels_needed(settings_);
    if (levels < 0) return;
    const base::Stopwatch watch;
    GroupReport& report = set_.group[0].report;
    const Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
    const std::int64_t budget = wanted(Group::stipple) ? settings_.group[0].budget : 0;
    grow_stipples(site_, start, {Group::stipple, levels, seeds_.step, budget}, marks_[0], report,
                  group_progress(Group::stipple));
    report.seconds = watch.seconds();
}

void Generation::paper_strokes(Group group) {
    const base::Stopwatch watch;
    const GroupSettings& settings = settings_.group[at(group)];
    GroupReport& report = set_.group[at(group)].report;
    const GrowthSettings growth{group, settings.levels, seeds_.step, settings.budget};
    if (settings.from_stipples) {
        geometry::VecArray position(site_.memory());
        geometry::VecArray normal(site_.memory());
        for (std::int64_t i = 0; i < marks_[0].count(); ++i) {
            if (marks_[0].level[i] > settings.seed_level) continue;
            position.push_back(marks_[0].position[i]);
            normal.push_back(marks_[0].normal[i]);
        }
        const std::int64_t full = grown_count(seeds_.report.attempted, 5, settings.seed_level);
        grow_strokes(site_, {position, normal, full}, growth, marks_[at(group)], report, group_progress(group));
    } else {
        const Start start{seeds_.position, seeds_.normal, seeds_.report.attempted};
        grow_strokes(site_, start, growth, marks_[at(group)], report, group_progress(group));
    }
    report.seconds = watch.seconds();
}

void Generation::paper() {
    paper_stipples();
    for (const Group group : {Group::curvature, Group::combing})
        if (wanted(group)) paper_strokes(group);
    if (wanted(Group::stipple)) return;
    marks_[0] = Marks(site_.memory()); // they were only seeds of strokes
    set_.group[0].report = {};
}

// ---- BLUE_NOISE ----------------------------------------------------------------------------

// 0 = no limit: only where the separation of strokes limits them.
std::int64_t Generation::stroke_budget(Group group) const {
    const std::int64_t budget = settings_.group[at(group)].budget;
    return budget == 0 && settings_.stroke_separation > 0.0 ? 0 : budget_of(group);
}

std::int64_t Generation::budget_of(Group group) const noexcept {
    const GroupSettings& settings = settings_.group[at(group)];
    return settings.budget > 0 ? settings.budget : default_budget;
}

// Marks that are spread over the surface at once: stipples, or the samples of a field of directions.
std::int64_t Generation::spread_marks(Group group) const {
    return group == Group::stipple ? budget_of(group) : field_samples_for(budget_of(group));
}

void Generation::blue_noise_stipples(const SurfaceCells& cells) {
    const base::Stopwatch watch;
    GroupReport& report = set_.group[0].report;
    EvenMarks even =
        spread_by_density(site_, cells, budget_of(Group::stipple), settings_.density, group_progress(Group::stipple));
    Marks& marks = marks_[0];
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

void Generation::blue_noise_strokes(const SurfaceCells& cells, Group group) {
    const base::Stopwatch watch;
    GroupReport& report = set_.group[at(group)].report;
    HatchSettings settings;
    settings.group = group;
    settings.separation = settings_.stroke_separation;
    settings.step = settings_.stroke_step;
    settings.longest = settings_.stroke_length;
    settings.budget = stroke_budget(group);
    settings.field = settings_.stroke_field;
    area_ = std::max(area_, hatch(site_, cells, settings, marks_[at(group)], report, group_progress(group)));
    report.seconds = watch.seconds();
}

void Generation::blue_noise() {
    std::int64_t most = 1;
    for (const Group group : {Group::stipple, Group::curvature, Group::combing})
        if (wanted(group)) most = std::max(most, spread_marks(group));
    const SurfaceCells cells = cover_surface(site_, seeds_, samples_, most, progress_.part(0.1, 0.2));
    if (wanted(Group::stipple)) blue_noise_stipples(cells);
    for (const Group group : {Group::curvature, Group::combing})
        if (wanted(group)) blue_noise_strokes(cells, group);
}

// --------------------------------------------------------------------------------------------

void Generation::require_some() const {
    LevelReport all;
    for (std::size_t group = 0; group < marks_.size(); ++group) {
        if (marks_[group].count() > 0) return;
        for (const LevelReport& level : set_.group[group].report.level) {
            all.attempted += level.attempted;
            all.dropped_not_converged += level.dropped_not_converged;
            all.dropped_strayed += level.dropped_strayed;
            all.dropped_degenerate += level.dropped_degenerate;
        }
    }
    // A budget of a few marks may be too small for the shortest stroke.
    if (all.attempted == 0 && settings_.stroke_separation == 0.0 && settings_.stroke_step == 0.0) return;
    fail(Status::not_converged,
         "no mark could be placed: of %lld, %lld did not converge, %lld strayed and %lld were degenerate; no stroke is "
         "shorter than 2.5 times stroke_separation, or has a stroke_step below the projection_tolerance",
         static_cast<long long>(all.attempted), static_cast<long long>(all.dropped_not_converged),
         static_cast<long long>(all.dropped_strayed), static_cast<long long>(all.dropped_degenerate));
}

void Generation::finish() {
    require_some();
    const std::array<const geometry::VecArray*, group_count> positions = {&marks_[0].position, &marks_[1].position,
                                                                          &marks_[2].position};
    measure(site_.runtime, positions, area_, set_, progress_.part(0.95, 0.95));
    for (const Group group : {Group::stipple, Group::curvature, Group::combing}) {
        if (!wanted(group)) continue;
        AssembleSettings settings;
        settings.group = group;
        settings.with_curvature = group == Group::curvature || settings_.group[at(group)].with_curvature;
        settings.progressive = settings_.distribution == Distribution::blue_noise;
        settings.strokes = set_.group[at(group)].report.strokes;
        const std::size_t layer = group == Group::stipple ? 0 : 2 * at(group) - 1;
        settings.part = {settings_.layer[layer], settings_.layer[group == Group::stipple ? 0 : layer + 1]};
        assemble(site_, marks_[at(group)], settings, set_.origin, set_.group[at(group)], progress_.part(0.95, 1.0));
        marks_[at(group)] = Marks(site_.memory()); // gives the doubles back
    }
}

PointSet Generation::run() {
    const base::Stopwatch watch;
    seeds_ = make_seeds(site_, samples_, settings_, progress_.part(0.0, 0.1));
    set_.distribution = settings_.distribution;
    set_.seed_source = seeds_.source;
    set_.seeds = seeds_.report;
    set_.seconds_seeds = watch.seconds();
    if (settings_.distribution == Distribution::paper)
        paper();
    else
        blue_noise();
    finish();
    set_.seconds_total = watch.seconds();
    progress_.update(1.0);
    return std::move(set_);
}

} // namespace

double expected_evaluations(const SampleHint& samples, const GenerateSettings& settings) noexcept {
    const bool paper = settings.distribution == Distribution::paper;
    const std::int64_t seeds = settings.seed_source == SeedSource::points
                                   ? settings.seed_points.count
                                   : static_cast<std::int64_t>(samples.position.size() / 3);
    constexpr std::int64_t candidates_each = 5; // of BLUE_NOISE, with cells and projection
    double evaluations = 0.0;
    for (std::size_t k = 0; k < settings.group.size(); ++k) {
        const GroupSettings& group = settings.group[k];
        if (!group.wanted) continue;
        const std::int64_t grown =
            k == 0 ? grown_count(seeds, 5, group.levels) : grown_count(2 * seeds, 3, group.levels);
        const std::int64_t budget = group.budget > 0 ? group.budget : default_budget;
        const double cost = k == 1 ? 8.0 : 3.0; // with Hessians on the way, or without
        evaluations += cost * static_cast<double>(paper ? grown : candidates_each * budget);
    }
    return evaluations;
}

PointSet generate(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                  const GenerateSettings& settings, const base::Progress& progress) {
    check_request(implicit, settings);
    const InUnit in_unit(runtime, implicit, samples, settings);
    const Site site = in_unit.site();
    PointSet set = Generation(site, in_unit.samples(), in_unit.settings(), progress).run();
    to_callers_unit(set, site.unit);
    return set;
}

} // namespace hrbfnpr::sampling
