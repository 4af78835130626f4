#include "sampling/surface_cells.h"

#include "geometry/morton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::sampling {
namespace {

using Cell = geometry::CellGrid::Cell;

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// Calls visit on a cell and its 26 neighbours.
template <class Visit>
void for_neighbourhood(const Cell& cell, Visit&& visit) {
    for (std::int64_t i = -1; i <= 1; ++i)
        for (std::int64_t j = -1; j <= 1; ++j)
            for (std::int64_t k = -1; k <= 1; ++k) visit(Cell{cell[0] + i, cell[1] + j, cell[2] + k});
}

// A plane's error within a cell, in sides, up to which its word about the next cells is taken; and what is left to
// them.
constexpr double trusted = 0.1;
constexpr double slack = 0.3;

class Flood {
public:
    Flood(const Site& site, SurfaceCells& cells)
        : site_(site), cells_(cells), centres_(cells.region.grown(0.5 * cells.grid.side)), known_(site.memory()),
          front_(site.memory()), next_(site.memory()), centre_(site.memory()), field_(site.memory()) {}

    void start(const geometry::VecArray& seeds);
    void run(const base::Progress& progress);

private:
    struct Offer {
        std::uint64_t cell; // packed
        double expected;    // distance by the plane of the cell that it was offered by; NaN: there is none
    };

    void offer(const Cell& cell, double expected, base::Array<Offer>& front);
    void judge(std::int64_t i, bool first);
    void go_on(const Cell& place, const SurfaceCell& cell, bool anywhere);

    const Site& site_;
    SurfaceCells& cells_;
    geometry::Bounds centres_; // of all cells that meet the region
    geometry::CellSet known_;
    base::Array<Offer> front_, next_; // cells to look at in this wave and in the next one
    geometry::VecArray centre_;
    FieldSamples field_;
    std::int64_t seeded_ = 0; // cells of the first wave that hold a seed come first
};

void Flood::offer(const Cell& cell, double expected, base::Array<Offer>& front) {
    if (!geometry::CellGrid::inside(cell)) return;
    if (!centres_.contains(cells_.grid.centre(cell))) return; // does not meet the region
    const std::uint64_t packed = geometry::CellGrid::pack(cell);
    if (known_.insert(packed)) front.push_back({packed, expected});
}

void Flood::start(const geometry::VecArray& seeds) {
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (cells_.region.contains(seeds[i])) offer(cells_.grid.cell_of(seeds[i]), nowhere, front_);
    seeded_ = front_.size();
}

// A cell belongs if its centre is near enough to the surface, to first order, for some of its points
// to be in the band; a seed's own cell belongs in any case.  The flood goes on only from cells that the
// surface may pass through, so that it does not jump to a sheet a few cells away: a point of the band
// has its nearest surface point at most one cell further (along each axis, 1/2 + 1/2 sqrt 3 + 1/2 < 2).
void Flood::judge(std::int64_t i, bool first) {
    const double distance = field_.distance(i);
    const bool near = std::abs(distance) <= cells_.reach();
    const bool seeded = first && i < seeded_;
    if (!near && !seeded) return;
    const Cell place = geometry::CellGrid::unpack(front_[i].cell);
    SurfaceCell cell{geometry::morton_code(place), nowhere, glm::dvec3(0.0)};
    if (near) {
        cell.distance = distance;
        cell.normal = glm::normalize(field_.gradient[i]);
    }
    cells_.cell.push_back(cell);
    if (seeded || std::abs(distance) <= cells_.half_diagonal())
        go_on(place, cell, !(std::abs(front_[i].expected - distance) <= trusted * cells_.grid.side));
}

// What a cell's plane calls too far off is left to a neighbour whose plane does not.  Where planes have been wrong, as
// at a sharp rim or if the function is no distance, all neighbours are looked at.
void Flood::go_on(const Cell& place, const SurfaceCell& cell, bool anywhere) {
    const double side = cells_.grid.side;
    for_neighbourhood(place, [&](const Cell& next) {
        const glm::dvec3 way(static_cast<double>(next[0] - place[0]), static_cast<double>(next[1] - place[1]),
                             static_cast<double>(next[2] - place[2]));
        const double expected = cell.distance + side * glm::dot(cell.normal, way);
        if (anywhere || !(std::abs(expected) > cells_.reach() + slack * side)) offer(next, expected, next_);
    });
}

void Flood::run(const base::Progress& progress) {
    for (bool first = true; !front_.empty(); first = false) {
        progress.check();
        centre_.resize(front_.size());
        for (std::int64_t i = 0; i < front_.size(); ++i)
            centre_.set(i, cells_.grid.centre(geometry::CellGrid::unpack(front_[i].cell)));
        evaluate(site_, centre_, field_, progress);
        next_.clear();
        for (std::int64_t i = 0; i < front_.size(); ++i) judge(i, first);
        std::swap(front_, next_);
    }
}

} // namespace

double SurfaceCells::half_diagonal() const noexcept { return 0.5 * std::sqrt(3.0) * grid.side; }

SurfaceCells find_surface_cells(const Site& site, const geometry::VecArray& seeds, const geometry::Bounds& region,
                                double side, const base::Progress& progress) {
    SurfaceCells cells(site.memory());
    cells.grid = {region.min - 2.5 * side, side};
    cells.region = region;
    cells.band = 0.5 * side;
    Flood flood(site, cells);
    flood.start(seeds);
    flood.run(progress);
    std::sort(cells.cell.begin(), cells.cell.end(),
              [](const SurfaceCell& a, const SurfaceCell& b) { return a.code < b.code; });
    progress.update(1.0);
    return cells;
}

} // namespace hrbfnpr::sampling
