// SPDX-License-Identifier: MIT
#include "stipples/blue_noise.h"

#include "geometry/long_vec_array.h"
#include "geometry/morton.h"
#include "stipples/candidates.h"
#include "stipples/distance_repair.h"
#include "stipples/progressive_order.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::stipples {
namespace {

// Cells are never coarser than this part of the diagonal, so that they see the shape ...
constexpr double coarsest_cells = 96.0;
// ... nor finer than this, so that no budget asks for more cells than there is memory for.
constexpr double finest_cells = 4096.0;
// A cell's side in spacings of marks: wide enough for the energies of the order, and few enough to be found quickly.
constexpr double cell_spacings = 2.2;
constexpr double candidates_per_mark = 3.5;
constexpr std::int64_t fewest_candidates = 6000;
constexpr std::int64_t settled_at_once = 262144;
constexpr std::int64_t appended_at_once = 16384; // without a look for a cancel

constexpr int most_rounds = 8;
// Cells along the longest side of a surface that is to be drawn.
constexpr std::int64_t fewest_across = 8;

// Later rounds are those of small surfaces in large boxes.
base::Progress part_of(const base::Progress& progress, int round) noexcept {
    return progress.part(1.0 - std::exp2(-round), 1.0 - std::exp2(-round - 1));
}

// Of the box around all cells, the longest side.
std::int64_t cells_across(const SurfaceCells& cells) noexcept {
    if (cells.cell.empty()) return 0;
    geometry::CellGrid::Cell low = geometry::morton_cell(cells.cell[0].code);
    geometry::CellGrid::Cell high = low;
    for (const SurfaceCell& cell : cells.cell) {
        const geometry::CellGrid::Cell at = geometry::morton_cell(cell.code);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], at[axis]);
            high[axis] = std::max(high[axis], at[axis]);
        }
    }
    return 1 + std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

// The samples' box and as much around it as the surface is known beyond its samples.  Another sheet
// that the function happens to have farther out, and an open sheet's continuation, stay outside.
geometry::Bounds region_of(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing) {
    const geometry::Bounds& bounds = site.implicit.bounds();
    const double diagonal = site.implicit.diagonal();
    const double margin = bounds.diagonal() > 0.0 ? std::clamp(sample_spacing, 0.03 * diagonal, 0.10 * diagonal)
                                                  : 0.5 * diagonal; // one sample: a square of its plane
    geometry::Bounds region = bounds.grown(margin);
    const auto inside = [&] {
        for (std::int64_t i = 0; i < seeds.position.size(); ++i)
            if (region.contains(seeds.position[i])) return true;
        return false;
    };
    // Points that the caller chose are wanted wherever they are.
    if (seeds.source == marks::SeedSource::points || !inside())
        for (std::int64_t i = 0; i < seeds.position.size(); ++i) region.extend(seeds.position[i]);
    return region;
}

// Projects the chosen; those that do not arrive leave a gap in the order, and are counted.
class Projecting {
public:
    Projecting(const marks::Site& site, const SurfaceCells& cells, const OrderedMarks& chosen, EvenMarks& marks)
        : site_(site), cells_(cells), chosen_(chosen), marks_(marks), settler_(site), normal_(site.memory()),
          fate_(site.memory()), wandered_(site.memory()) {}

    void run(const base::Progress& progress) {
        const std::int64_t count = chosen_.size();
        marks_.position.reserve(count);
        marks_.normal.reserve(count);
        const auto all = static_cast<double>(count);
        for (std::int64_t begin = 0; begin < count; begin += settled_at_once) {
            const std::int64_t end = std::min(count, begin + settled_at_once);
            settle(begin, end, progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
            append(progress);
        }
        if (!wandered_.empty()) repair_distances(site_, wandered_, marks_, report_);
        marks::LevelReport& report = marks_.report;
        report.dropped_budget = report.placed - count;
        report.placed = report_.placed;
        report.dropped_not_converged += report_.dropped_not_converged;
        report.dropped_strayed += report_.dropped_strayed;
        report.dropped_degenerate += report_.dropped_degenerate;
    }

private:
    enum class Fate : std::uint8_t { dropped, outside, near, wandered };

    template <class Visit>
    void for_batch(std::int64_t count, Visit&& visit) {
        site_.runtime.parallel.for_chunks(count, 4096, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) visit(i);
        });
    }

    void settle(std::int64_t begin, std::int64_t end, const base::Progress& progress) {
        const std::int64_t count = end - begin;
        settler_.start.resize(count);
        for_batch(count, [&](std::int64_t i) {
            const float(&p)[3] = chosen_[begin + i].position;
            settler_.start.set(i, cells_.grid.origin + glm::dvec3(p[0], p[1], p[2]));
        });
        settler_.settle(cells_.grid.side, report_, progress); // farther is another sheet
        normal_.resize(count);
        fate_.resize(count);
        for_batch(count, [&](std::int64_t i) {
            if (settler_.placed(i)) normal_.set(i, settler_.normal(i));
            fate_[i] = fate_of(i, begin + i);
        });
    }

    [[nodiscard]] Fate fate_of(std::int64_t i, std::int64_t number) const noexcept {
        if (!settler_.placed(i)) return Fate::dropped;
        if (!cells_.region.contains(settler_.position(i))) return Fate::outside;
        const float(&n)[3] = chosen_[number].normal;
        const double way = glm::distance(settler_.position(i), settler_.start[i]);
        const double turn = glm::dot(normal_[i], glm::dvec3(n[0], n[1], n[2]));
        const bool far = way > 0.04 * densest_distance(marks_.area, static_cast<double>(number + 1));
        return far || turn < 0.95 * double{unpacked_length} ? Fate::wandered : Fate::near;
    }

    void append(const base::Progress& progress) {
        for (std::int64_t i = 0; i < fate_.size(); ++i) {
            if (i % appended_at_once == 0) progress.check();
            if (fate_[i] == Fate::outside) settler_.drop(i, report_.dropped_strayed, report_);
            if (fate_[i] < Fate::near) continue;
            if (fate_[i] == Fate::wandered) wandered_.push_back(marks_.position.size());
            geometry::push_back_long(marks_.position, settler_.position(i), progress);
            geometry::push_back_long(marks_.normal, normal_[i], progress);
        }
    }

    const marks::Site& site_;
    const SurfaceCells& cells_;
    const OrderedMarks& chosen_;
    EvenMarks& marks_;
    marks::Settler settler_;
    geometry::VecArray normal_; // of the batch
    base::Array<Fate> fate_;
    base::Array<std::int64_t> wandered_;
    marks::LevelReport report_;
};

} // namespace

SurfaceCells cover_surface(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing,
                           std::int64_t marks, const base::Progress& progress) {
    const geometry::Bounds region = region_of(site, seeds, sample_spacing);
    const double diagonal = region.diagonal();
    SurfaceCells cells(site.memory());
    // A small surface in a large box tells its area only by cells that are small to it: as long as the
    // estimate asks for finer cells by more than a tenth, they are found anew.
    const double finest = diagonal / finest_cells;
    double side = diagonal / coarsest_cells;
    for (int round = 0; round < most_rounds; ++round) {
        cells = find_surface_cells(site, seeds.position, region, side, part_of(progress, round));
        const double spacing = std::sqrt(cells.rough_area() / static_cast<double>(marks));
        // What a few cells hold tells neither its shape nor its area.
        const bool known = cells_across(cells) >= fewest_across;
        const double wanted = known ? std::max(cell_spacings * spacing, finest) : std::max(0.25 * side, finest);
        if (wanted > 0.9 * side) break;
        side = wanted;
    }
    if (cells_across(cells) < fewest_across)
        fail(Status::invalid_argument,
             "the surface is no more than %.2g across, and the bounds that its marks may lie in are %.2g: give "
             "bounds_min and bounds_max that fit it (at most %g times as wide)",
             site.unit * side * static_cast<double>(cells_across(cells)), site.unit * diagonal,
             finest_cells / static_cast<double>(fewest_across));
    return cells;
}

EvenMarks spread_evenly(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted, marks::Kind kind,
                        const base::Progress& progress) {
    const auto many = static_cast<std::int64_t>(candidates_per_mark * static_cast<double>(wanted));
    Candidates candidates =
        draw_candidates(site, cells, std::max(many, fewest_candidates), kind, progress.part(0.0, 0.5));
    const OrderedMarks chosen = progressive_order(site, candidates, wanted, progress.part(0.5, 0.9));
    EvenMarks marks(site.memory());
    marks.report = candidates.report;
    marks.area = candidates.area;
    Projecting(site, cells, chosen, marks).run(progress.part(0.9, 1.0));
    if (marks.position.empty())
        fail(Status::not_converged,
             "no mark could be placed in %lld cells near the surface: %lld points were tried, %lld did not "
             "converge, %lld strayed, %lld were degenerate; raise projection_tolerance or use PUBLISHED",
             static_cast<long long>(cells.cell.size()), static_cast<long long>(marks.report.attempted),
             static_cast<long long>(marks.report.dropped_not_converged),
             static_cast<long long>(marks.report.dropped_strayed),
             static_cast<long long>(marks.report.dropped_degenerate));
    return marks;
}

} // namespace hrbfnpr::stipples
