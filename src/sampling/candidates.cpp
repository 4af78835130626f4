#include "sampling/candidates.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::sampling {
namespace {

constexpr std::uint32_t most_rounds = 4;

// Points are drawn uniformly in the volume of the cells and kept within `band` of the surface: a
// layer of constant thickness holds as many points per area everywhere, to second order in
// band * curvature.  They are then projected.
class Drawing {
public:
    Drawing(const Site& site, const SurfaceCells& cells, Group group, Candidates& candidates)
        : site_(site), cells_(cells), group_(group), candidates_(candidates), settler_(site), trial_(site.memory()),
          field_(site.memory()) {}

    // `trials` points, spread evenly over the cells.
    void round(std::uint32_t number, double trials, const base::Progress& progress);

    // The share of all trials that were within the band.
    [[nodiscard]] double share() const noexcept { return trials_ > 0 ? static_cast<double>(near_) / trials_ : 0.0; }

private:
    void draw_in(const SurfaceCell& cell, std::uint32_t round, double per_cell);
    void settle_trials(const base::Progress& progress);

    const Site& site_;
    const SurfaceCells& cells_;
    Group group_;
    Candidates& candidates_;
    Settler settler_;
    geometry::VecArray trial_; // of the chunk, those near enough to be worth evaluating
    FieldSamples field_;
    double trials_ = 0.0;
    std::int64_t near_ = 0;
};

void Drawing::draw_in(const SurfaceCell& cell, std::uint32_t round, double per_cell) {
    const glm::dvec3 corner = cells_.grid.corner(geometry::CellGrid::unpack(cell.packed));
    const double side = cells_.grid.side;
    // Number 0 of a cell and round decides whether the fraction of a trial becomes one.
    const std::uint32_t lane = lane_of(group_, round) << 16U;
    const double extra = base::uniform4(site_.random_seed, cell.packed, base::Purpose::candidate, lane)[0];
    const auto count = static_cast<std::uint32_t>(std::min(per_cell + extra, 65535.0));
    trials_ += count;
    // What the cell's plane calls this far off the band is not evaluated: its error within the cell is
    // 3/8 side^2 curvature, so this holds where the surface bends with radii above 1.5 sides.
    const double unlikely = cells_.band + 0.25 * side;
    for (std::uint32_t number = 1; number <= count; ++number) {
        const auto u = base::uniform4(site_.random_seed, cell.packed, base::Purpose::candidate, lane | number);
        const glm::dvec3 offset = side * glm::dvec3(u[0], u[1], u[2]);
        const double distance = cell.distance + glm::dot(cell.normal, offset - 0.5 * side);
        if (std::abs(distance) > unlikely) continue; // NaN goes on
        trial_.push_back(corner + offset);
    }
}

void Drawing::settle_trials(const base::Progress& progress) {
    evaluate(site_, trial_, field_, progress);
    settler_.start.clear();
    for (std::int64_t i = 0; i < trial_.size(); ++i) {
        const double distance = field_.distance(i);
        if (!(std::abs(distance) <= cells_.band)) continue;
        ++near_;
        // A Newton step ahead of the projection, with the gradient that is there already.
        settler_.start.push_back(trial_[i] - distance * glm::normalize(field_.gradient[i]));
    }
    // Farther than a cell is another sheet.
    settler_.settle(cells_.grid.side, candidates_.report, progress);
    for (std::int64_t i = 0; i < settler_.start.size(); ++i) {
        if (!settler_.placed(i)) continue;
        if (!cells_.region.contains(settler_.position(i))) {
            settler_.drop(i, candidates_.report.dropped_strayed, candidates_.report);
            continue;
        }
        candidates_.position.push_back(settler_.position(i));
        candidates_.normal.push_back(settler_.normal(i));
    }
    trial_.clear();
}

void Drawing::round(std::uint32_t number, double trials, const base::Progress& progress) {
    const double per_cell = trials / static_cast<double>(cells_.cell.size());
    for (std::int64_t i = 0; i < cells_.cell.size(); ++i) {
        draw_in(cells_.cell[i], number, per_cell);
        if (trial_.size() < chunk_size && i + 1 < cells_.cell.size()) continue;
        settle_trials(base::Progress(progress).part(0.0, 0.0));
        progress.update(static_cast<double>(i + 1) / static_cast<double>(cells_.cell.size()));
    }
}

} // namespace

Candidates draw_candidates(const Site& site, const SurfaceCells& cells, std::int64_t wanted, Group group,
                           const base::Progress& progress) {
    Candidates candidates(site.memory());
    if (cells.cell.empty()) return candidates;
    Drawing drawing(site, cells, group, candidates);
    double share = cells.band / cells.reach();
    for (std::uint32_t round = 0; round < most_rounds && share > 0.0; ++round) {
        const std::int64_t missing = wanted - candidates.position.size();
        if (missing <= 0) break;
        drawing.round(round, 1.02 * static_cast<double>(missing) / share,
                      progress.part(round == 0 ? 0.0 : 0.8, round == 0 ? 0.8 : 1.0));
        share = drawing.share();
    }
    // near / trials is the part of the volume that is in the band of thickness 2 band.  What lies in
    // the region is all that is placed; of what is near, that is the same part as of the area.
    const LevelReport& report = candidates.report;
    if (report.attempted > 0)
        candidates.area = share * cells.volume() / (2.0 * cells.band) * static_cast<double>(report.placed) /
                          static_cast<double>(report.attempted);
    return candidates;
}

} // namespace hrbfnpr::sampling
