// SPDX-License-Identifier: MIT
#include "stipples/progressive_order.h"

#include "stipples/order_stage.h"

#include "base/bits.h"
#include "geometry/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::stipples {
namespace {

// The distance that marks keep, in that of the densest packing of as many: docs/quality.md.
constexpr double kept_distance = 0.70;
// It is that of a number of marks this much larger, which one step of a sweep is to reach.
constexpr double growth_of_step = 1.015;
// Where no place is left, a smaller distance will have to do.
constexpr double concession = 0.98;
// Down to this one only if all candidates are looked at again.
constexpr double least_distance = 0.65;
constexpr double growth_between_cleanings = 2.2;
// Reach of a mark's energy, in distances of the densest packing at the end of a stage.
constexpr double reach_of_energy = 1.8;
// Below it all places count as equally empty.
constexpr float least_threshold = 0.05F;
// Sweeps of large orders have many steps: each takes all candidates through the processor's caches.
constexpr std::size_t steps_of_sweep = 12;
constexpr double fewest_for_many_steps = 2000.0;
// The threshold grows about with this power of the number of marks (from 0.06 to 2 in a stage, measured) ...
constexpr double slope_of_threshold = 2.5;
constexpr float threshold_of_step = 1.038F; // growth_of_step ^ slope_of_threshold
// ... and where a sweep added little, the next one takes energies up to this much higher.
constexpr float rise = 1.06F;
constexpr float small_rise = 1.02F; // when the stage is nearly full
// Earlier stages have more candidates for each mark to choose from.
constexpr double candidates_of_early_marks = 12.0;

class Ordering {
public:
    Ordering(const marks::Site& site, Candidates& candidates, std::int64_t wanted)
        : site_(site), candidates_(candidates), wanted_(wanted), home_(site.memory()), marks_(site.memory()),
          sweep_(site.memory()), step_(site.memory()) {}

    OrderedMarks run(const base::Progress& progress);

private:
    // Of the densest packing of that many marks.
    [[nodiscard]] double densest(double marks) const noexcept { return densest_distance(candidates_.area, marks); }
    [[nodiscard]] double side(std::int32_t level) const noexcept { return std::ldexp(candidates_.grid.side, level); }
    void find_home();
    [[nodiscard]] StageSettings settings_of(std::int32_t level, std::int64_t marks) const noexcept;
    bool run_stage(Candidates& candidates, std::int32_t level, std::int64_t last, const base::Progress& progress);
    [[nodiscard]] std::int64_t marks_at(std::int32_t level) const noexcept;
    bool fill(OrderStage& stage, std::int64_t last, double closest, double needless, const base::Progress& progress);
    void note_steps(const OrderStage& stage);
    [[nodiscard]] OrderedMarks shuffled() const;

    const marks::Site& site_;
    Candidates& candidates_;
    std::int64_t wanted_;
    std::int32_t home_level_ = 0; // of the last stage
    CellMap home_;
    OrderedMarks marks_;
    base::Array<std::int64_t> sweep_; // where each sweep's marks begin
    base::Array<std::uint8_t> step_;  // of the sweep, in which each mark was placed
};

void Ordering::find_home() {
    while (home_level_ < geometry::CellGrid::bits &&
           side(home_level_) < 0.85 * reach_of_energy * densest(static_cast<double>(wanted_)))
        ++home_level_;
    base::Array<std::uint64_t> codes(site_.memory());
    for (const std::uint64_t code : candidates_.code) {
        const std::uint64_t here = code >> static_cast<unsigned>(3 * home_level_);
        if (codes.empty() || codes.back() != here) codes.push_back(here);
    }
    home_ = CellMap(site_.memory(), codes);
}

StageSettings Ordering::settings_of(std::int32_t level, std::int64_t marks) const noexcept {
    StageSettings settings;
    settings.level = level;
    const double last = densest(static_cast<double>(marks));
    settings.reach = std::min(side(level), reach_of_energy * last);
    const auto all = static_cast<double>(candidates_.count);
    const double taken = std::min(all, std::max(64.0, candidates_of_early_marks * static_cast<double>(marks)));
    settings.ticket_limit = static_cast<std::uint64_t>(taken / all * 4294967296.0);
    settings.nearness = std::max(0.8, 1.0 - static_cast<double>(marks) / taken);
    // Into the cells next door at most, and no farther than candidates are true to the surface: they are many where
    // marks are few.
    settings.farthest_move = std::min(0.5 * (1.0 - kept_distance) * side(level), 0.25 * candidates_.grid.side);
    return settings;
}

// Returns false where no place is left for `last` marks that differ.
bool Ordering::run_stage(Candidates& candidates, std::int32_t level, std::int64_t last,
                         const base::Progress& progress) {
    for (const double least : {least_distance, 0.0}) {
        const StageSettings settings = settings_of(level, last);
        OrderStage stage(site_, candidates, home_, home_level_, settings, marks_, progress);
        const double end = densest(static_cast<double>(last));
        // Closer points are the same to float positions.
        const double closest = std::max(least, 1e-7 * candidates_.region.diagonal() / end);
        if (fill(stage, last, closest, settings.nearness * least * end, progress)) return true;
    }
    return false;
}

// Places marks until there are `last` of them, or they would have to be nearer than `closest` (of the densest
// packing).  Candidates nearer than `needless` to a mark will not be needed.
bool Ordering::fill(OrderStage& stage, std::int64_t last, double closest, double needless,
                    const base::Progress& progress) {
    double at_cleaning = 0.0;
    double distance = kept_distance;
    float threshold = least_threshold;
    bool missed = false; // candidates that only a sweep's later steps open, in cells that none of its marks is near
    while (marks_.size() < last) {
        progress.check();
        const auto before = static_cast<double>(marks_.size());
        if (before > growth_between_cleanings * at_cleaning) {
            stage.drop_nearer(needless);
            at_cleaning = before;
        }
        const bool nearly_full = before > 0.97 * static_cast<double>(last);
        const bool many = before >= fewest_for_many_steps && !nearly_full;
        std::array<SweepStep, steps_of_sweep> steps;
        std::size_t count = many ? steps.size() : 1;
        double expected = before;
        for (std::size_t k = 0; k < count; ++k) {
            expected = std::min(static_cast<double>(last), growth_of_step * expected + (many ? 0.0 : 1.0));
            if (many) threshold *= threshold_of_step;
            steps[k] = {distance * densest(expected), threshold};
        }
        if (std::exchange(missed, false)) {
            steps[0] = steps[count - 1];
            count = 1;
        }
        stage.sweep({steps.data(), count}, last - marks_.size(), marks_);
        note_steps(stage);
        const auto after = static_cast<double>(marks_.size());
        progress.update(after / static_cast<double>(wanted_));
        if (after - before > 0.25 * (expected - before)) {
            if (many) threshold *= static_cast<float>(std::pow(expected / after, slope_of_threshold));
            continue;
        }
        const float lowest = stage.lowest();
        missed = after == before && lowest < threshold;
        if (std::isfinite(lowest))
            threshold = (nearly_full ? small_rise : rise) * std::max(threshold, lowest);
        else if (after == before && (distance *= concession) < closest)
            return false;
    }
    return true;
}

void Ordering::note_steps(const OrderStage& stage) {
    sweep_.push_back(step_.size());
    for (const std::uint8_t step : stage.steps()) step_.push_back(step);
}

// Marks of one step stand tile by tile; in random order a part of them is spread like the whole.  Those of a sweep
// follow each other.
OrderedMarks Ordering::shuffled() const {
    struct Place {
        std::uint64_t lot; // its first eight bits are the step
        std::int64_t mark;
        [[nodiscard]] bool operator<(const Place& other) const noexcept { return lot < other.lot; }
    };
    base::Array<Place> place(site_.memory());
    OrderedMarks sorted(site_.memory());
    place.resize_for_overwrite(marks_.size());
    sorted.resize_for_overwrite(marks_.size());
    site_.runtime.parallel.for_each(sweep_.size(), [&](std::int64_t sweep) {
        const std::int64_t begin = sweep_[sweep];
        const std::int64_t end = sweep + 1 < sweep_.size() ? sweep_[sweep + 1] : marks_.size();
        for (std::int64_t i = begin; i < end; ++i) {
            std::uint64_t lot = 0;
            for (const float c : marks_[i].position) lot = geometry::mixed_bits(lot ^ base::bit_cast<std::uint32_t>(c));
            place[i] = {std::uint64_t{step_[i]} << 56U | lot >> 8U, i};
        }
        std::sort(place.data() + begin, place.data() + end);
        for (std::int64_t i = begin; i < end; ++i) sorted[i] = marks_[place[i].mark];
    });
    return sorted;
}

// That many marks are within a stage's reach of energies.
std::int64_t Ordering::marks_at(std::int32_t level) const noexcept {
    const double marks = std::floor(std::pow(reach_of_energy * densest(1.0) / side(level), 2.0));
    return std::min(static_cast<std::int64_t>(marks), wanted_);
}

OrderedMarks Ordering::run(const base::Progress& progress) {
    if (candidates_.count == 0 || wanted_ <= 0) return std::move(marks_);
    find_home();
    std::int32_t level = home_level_;
    while (level < geometry::CellGrid::bits && side(level) < reach_of_energy * densest(1.0)) ++level;
    // Early stages would only pass over most candidates.
    const std::int32_t early = home_level_ + 2;
    Candidates few =
        thinned(site_, candidates_, level < early ? 0 : settings_of(early, marks_at(early)).ticket_limit, progress);
    for (; level > home_level_; --level) {
        const std::int64_t last = std::max(marks_at(level), marks_.size());
        if (last > marks_.size() && !run_stage(level < early ? candidates_ : few, level, last, progress)) break;
    }
    run_stage(candidates_, home_level_, wanted_, progress);
    return shuffled();
}

} // namespace

OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted,
                               const base::Progress& progress) {
    Ordering ordering(site, candidates, wanted);
    return ordering.run(progress);
}

} // namespace hrbfnpr::stipples
