#include "sampling/blue_noise.h"

#include "geometry/point_grid.h"
#include "sampling/candidates.h"
#include "sampling/progressive_order.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::sampling {
namespace {

// Cells are never coarser than this part of the diagonal, so that they see the shape ...
constexpr double coarsest_cells = 96.0;
// ... nor finer than this, so that no budget asks for more cells than there is memory for.
constexpr double finest_cells = 4096.0;
// A cell's side in spacings of marks: wide enough for the energies of the order, and few enough to be found quickly.
constexpr double cell_spacings = 2.2;
constexpr std::int64_t candidates_per_mark = 5;
constexpr std::int64_t fewest_candidates = 6000;
constexpr std::int64_t settled_at_once = 65536;
// Of the densest packing's distance; the order keeps 0.70.
constexpr double least_apart = 0.66;

// The samples' box and as much around it as the surface is known beyond its samples.  Another sheet
// that the function happens to have farther out, and an open sheet's continuation, stay outside.
geometry::Bounds region_of(const Site& site, const Seeds& seeds, const SampleHint& samples) {
    const geometry::Bounds& bounds = site.implicit.bounds();
    const double diagonal = site.implicit.diagonal();
    const double margin = bounds.diagonal() > 0.0 ? std::clamp(samples.spacing, 0.03 * diagonal, 0.10 * diagonal)
                                                  : 0.5 * diagonal; // one sample: a square of its plane
    geometry::Bounds region = bounds.grown(margin);
    const auto inside = [&] {
        for (std::int64_t i = 0; i < seeds.position.size(); ++i)
            if (region.contains(seeds.position[i])) return true;
        return false;
    };
    // Points that the caller chose are wanted wherever they are.
    if (seeds.source == SeedSource::points || !inside())
        for (std::int64_t i = 0; i < seeds.position.size(); ++i) region.extend(seeds.position[i]);
    return region;
}

// Two marks that are nearer than all others.
struct Crowd {
    std::int64_t later, earlier;
    [[nodiscard]] bool operator<(const Crowd& other) const noexcept {
        return later != other.later ? later < other.later : earlier < other.earlier;
    }
};

// Finds the crowds that a mark has wandered into.  The later of two says how far they must be apart, so marks are
// looked at in octaves, in each of which that is nearly the same distance.
class Crowds {
public:
    Crowds(const Site& site, const EvenMarks& marks, const base::Array<std::int64_t>& wandered)
        : site_(site), marks_(marks), wandered_(wandered), near_(site.memory()), found_(site.memory()) {}

    // In ascending order.
    base::Array<Crowd> find() {
        const std::int64_t count = marks_.position.size();
        for (std::int64_t begin = 0, end = 1; begin < count; begin = end, end = std::min(2 * end, count))
            look_through(begin, end);
        std::sort(found_.begin(), found_.end());
        return std::move(found_);
    }

private:
    [[nodiscard]] double apart(std::int64_t later) const noexcept {
        return least_apart * densest_distance(marks_.area, static_cast<double>(later + 1));
    }

    void look_through(std::int64_t begin, std::int64_t end) {
        geometry::VecArray position(site_.memory());
        for (const std::int64_t i : wandered_)
            if (i < end) position.push_back(marks_.position[i]);
        if (position.empty()) return;
        const geometry::PointGrid grid(position, apart(begin));
        near_.resize(end);
        site_.runtime.parallel.for_chunks(end, 8192, [&](std::int64_t from, std::int64_t to) {
            for (std::int64_t j = from; j < to; ++j) {
                near_[j] = 0;
                visit(grid, begin, j, [&](const Crowd&) { near_[j] = 1; });
            }
        });
        for (std::int64_t j = 0; j < end; ++j)
            if (near_[j] != 0) visit(grid, begin, j, [&](const Crowd& crowd) { found_.push_back(crowd); });
    }

    // The crowds of mark j and one that wandered, of which the later one is not before `begin`.
    template <class Visit>
    void visit(const geometry::PointGrid& grid, std::int64_t begin, std::int64_t j, Visit&& visit) const {
        grid.around(marks_.position[j], [&](std::int64_t at) {
            const std::int64_t i = wandered_[grid.index(at)];
            const std::int64_t later = std::max(i, j);
            if (i == j || later < begin) return;
            const glm::dvec3 between = marks_.position[i] - marks_.position[j];
            if (glm::dot(between, between) >= apart(later) * apart(later)) return;
            if (glm::dot(marks_.normal[i], marks_.normal[j]) >= 0.0) visit(Crowd{later, std::min(i, j)});
        });
    }

    const Site& site_;
    const EvenMarks& marks_;
    const base::Array<std::int64_t>& wandered_;
    base::Array<std::uint8_t> near_;
    base::Array<Crowd> found_;
};

// Where the surface bends within the spacing of marks, they may come to rest beside each other.  Of two that are nearer
// than all others the later one is dropped.
void keep_apart(const Site& site, const base::Array<std::int64_t>& wandered, EvenMarks& marks, LevelReport& report) {
    base::Array<std::uint8_t> dropped(site.memory(), marks.position.size());
    for (const Crowd& crowd : Crowds(site, marks, wandered).find())
        if (dropped[crowd.earlier] == 0) dropped[crowd.later] = 1;
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < dropped.size(); ++i) {
        if (dropped[i] != 0) continue;
        marks.position.set(kept, marks.position[i]);
        marks.normal.set(kept++, marks.normal[i]);
    }
    report.placed = kept;
    report.dropped_strayed += dropped.size() - kept;
    marks.position.resize(kept);
    marks.normal.resize(kept);
}

// Projects the chosen; those that do not arrive leave a gap in the order, and are counted.
void bring_to_rest(const Site& site, const SurfaceCells& cells, const OrderedMarks& chosen, EvenMarks& marks,
                   const base::Progress& progress) {
    Settler settler(site);
    LevelReport report;
    base::Array<std::int64_t> wandered(site.memory());
    const std::int64_t count = chosen.size();
    marks.position.reserve(count);
    marks.normal.reserve(count);
    for (std::int64_t begin = 0; begin < count; begin += settled_at_once) {
        const std::int64_t end = std::min(count, begin + settled_at_once);
        settler.start.clear();
        for (std::int64_t i = begin; i < end; ++i)
            settler.start.push_back(cells.grid.origin +
                                    glm::dvec3(chosen[i].position[0], chosen[i].position[1], chosen[i].position[2]));
        const auto all = static_cast<double>(count);
        // Farther than a cell is another sheet.
        settler.settle(cells.grid.side, report,
                       progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
        for (std::int64_t i = 0; i < end - begin; ++i) {
            if (!settler.placed(i)) continue;
            if (!cells.region.contains(settler.position(i))) {
                settler.drop(i, report.dropped_strayed, report);
                continue;
            }
            const OrderMark& mark = chosen[begin + i];
            const double way = glm::distance(settler.position(i), settler.start[i]);
            const double turn = glm::dot(settler.normal(i), glm::dvec3(mark.normal[0], mark.normal[1], mark.normal[2]));
            if (way > 0.04 * densest_distance(marks.area, static_cast<double>(begin + i + 1)) ||
                turn < 0.95 * double{unpacked_length})
                wandered.push_back(marks.position.size());
            marks.position.push_back(settler.position(i));
            marks.normal.push_back(settler.normal(i));
        }
    }
    if (!wandered.empty()) keep_apart(site, wandered, marks, report);
    LevelReport& all = marks.report;
    all.dropped_budget = all.placed - count;
    all.placed = report.placed;
    all.dropped_not_converged += report.dropped_not_converged;
    all.dropped_strayed += report.dropped_strayed;
    all.dropped_degenerate += report.dropped_degenerate;
}

} // namespace

SurfaceCells cover_surface(const Site& site, const Seeds& seeds, const SampleHint& samples, std::int64_t marks,
                           const base::Progress& progress) {
    const geometry::Bounds region = region_of(site, seeds, samples);
    const double diagonal = region.diagonal();
    SurfaceCells cells(site.memory());
    // A small surface in a large box tells its area only by cells that are small to it: as long as the
    // estimate asks for cells of less than half the side, they are found anew.
    double side = diagonal / coarsest_cells;
    for (int round = 0; round < 4; ++round) {
        cells = find_surface_cells(site, seeds.position, region, side, progress.part(0.25 * round, 0.25 * (round + 1)));
        const double spacing = std::sqrt(cells.rough_area() / static_cast<double>(marks));
        const double wanted = std::max(cell_spacings * spacing, diagonal / finest_cells);
        if (wanted > 0.7 * side) break;
        side = wanted;
    }
    return cells;
}

EvenMarks spread_evenly(const Site& site, const SurfaceCells& cells, std::int64_t wanted, Group group,
                        const base::Progress& progress) {
    const Candidates candidates = draw_candidates(
        site, cells, std::max(candidates_per_mark * wanted, fewest_candidates), group, progress.part(0.0, 0.5));
    const OrderedMarks chosen = progressive_order(site, candidates, wanted, progress.part(0.5, 0.9));
    EvenMarks marks(site.memory());
    marks.report = candidates.report;
    marks.area = candidates.area;
    bring_to_rest(site, cells, chosen, marks, progress.part(0.9, 1.0));
    if (marks.position.empty())
        fail(Status::not_converged,
             "no mark could be placed in %lld cells near the surface: %lld points were tried, %lld did not "
             "converge, %lld strayed, %lld were degenerate; raise projection_tolerance or use PAPER",
             static_cast<long long>(cells.cell.size()), static_cast<long long>(marks.report.attempted),
             static_cast<long long>(marks.report.dropped_not_converged),
             static_cast<long long>(marks.report.dropped_strayed),
             static_cast<long long>(marks.report.dropped_degenerate));
    return marks;
}

} // namespace hrbfnpr::sampling
