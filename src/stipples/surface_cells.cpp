// SPDX-License-Identifier: MIT
#include "stipples/surface_cells.h"

#include "base/sort.h"
#include "geometry/cell_block.h"
#include "geometry/cell_set.h"
#include "geometry/long_vec_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace hrbfnpr::stipples {
namespace {

using Cell = geometry::CellGrid::Cell;

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// A plane's error within a cell, in sides, up to which its word about the next cells is taken; and what is left to
// them.
constexpr double trusted = 0.1;
constexpr double slack = 0.3;

class Flood {
public:
    Flood(const marks::Site& site, SurfaceCells& cells)
        : site_(site), cells_(cells), centres_(cells.region.grown(0.5 * cells.grid.side)), known_(site.memory()),
          front_(site.memory()), next_(site.memory()), centre_(site.memory()), field_(site.memory()),
          judged_(site.memory()) {}

    void start(const geometry::VecArray& seeds);
    void run(const base::Progress& progress);

private:
    struct Offer {
        std::uint64_t cell; // packed
        double expected;    // distance by the plane of the cell that it was offered by; NaN: there is none
    };

    // What was found of a cell: whether it belongs, and to which of the 27 around it the flood goes on, a bit for each.
    struct Judged {
        SurfaceCell cell;
        bool belongs;
        std::uint32_t onward;
    };

    [[nodiscard]] bool meets_region(const Cell& cell) const noexcept;
    [[nodiscard]] Judged judge(std::int64_t i, bool first) const noexcept;
    [[nodiscard]] std::uint32_t onward(const Cell& place, const SurfaceCell& cell, bool anywhere) const noexcept;
    void go_on(const Judged& from, const base::Progress& progress);

    const marks::Site& site_;
    SurfaceCells& cells_;
    geometry::Bounds centres_; // of all cells that meet the region
    geometry::CellSet known_;
    base::Array<Offer> front_, next_; // cells to look at in this wave and in the next one
    geometry::VecArray centre_;
    marks::FieldSamples field_;
    base::Array<Judged> judged_;
    std::int64_t seeded_ = 0; // cells of the first wave that hold a seed come first
};

bool Flood::meets_region(const Cell& cell) const noexcept {
    return geometry::CellGrid::inside(cell) && centres_.contains(cells_.grid.centre(cell));
}

void Flood::start(const geometry::VecArray& seeds) {
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (const Cell cell = cells_.grid.cell_of(seeds[i]); cells_.region.contains(seeds[i]) && meets_region(cell))
            if (const std::uint64_t packed = geometry::CellGrid::pack(cell); known_.insert(packed))
                front_.push_back({packed, nowhere});
    seeded_ = front_.size();
}

// A cell belongs if its centre is near enough to the surface, to first order, for some of its points
// to be in the band; a seed's own cell belongs in any case.  The flood goes on only from cells that the
// surface may pass through, so that it does not jump to a sheet a few cells away: a point of the band
// has its nearest surface point at most one cell further (along each axis, 1/2 + 1/2 sqrt 3 + 1/2 < 2).
Flood::Judged Flood::judge(std::int64_t i, bool first) const noexcept {
    const double distance = field_.distance(i);
    const bool near = std::abs(distance) <= cells_.reach();
    const bool seeded = first && i < seeded_;
    const Cell place = geometry::CellGrid::unpack(front_[i].cell);
    Judged judged{{geometry::morton_code(place), nowhere, glm::dvec3(0.0)}, near || seeded, 0};
    if (near) {
        judged.cell.distance = distance;
        judged.cell.normal = glm::normalize(field_.gradient[i]);
    }
    // Nor beyond the end of a surface that is trimmed.
    if (near && !site_.implicit.holds(centre_[i] - distance * judged.cell.normal, judged.cell.normal)) return judged;
    if (seeded || std::abs(distance) <= cells_.half_diagonal())
        judged.onward =
            onward(place, judged.cell, !(std::abs(front_[i].expected - distance) <= trusted * cells_.grid.side));
    return judged;
}

glm::dvec3 way_to(const Cell& next, const Cell& place) noexcept {
    return {static_cast<double>(next[0] - place[0]), static_cast<double>(next[1] - place[1]),
            static_cast<double>(next[2] - place[2])};
}

// What a cell's plane calls too far off is left to a neighbour whose plane does not.  Where planes have been wrong, as
// at a sharp rim or if the function is no distance, all neighbours are looked at.
std::uint32_t Flood::onward(const Cell& place, const SurfaceCell& cell, bool anywhere) const noexcept {
    const double side = cells_.grid.side;
    const double farthest = cells_.reach() + slack * side;
    const bool inside = centres_.contains(cells_.grid.centre(place) - side) &&
                        centres_.contains(cells_.grid.centre(place) + side) && geometry::CellGrid::inside(place);
    std::uint32_t found = 0;
    for (int step = 0; step < geometry::neighbour_count; ++step) {
        const Cell next = geometry::neighbour(place, step);
        const double expected = cell.distance + side * glm::dot(cell.normal, way_to(next, place));
        if ((anywhere || !(std::abs(expected) > farthest)) && (inside || meets_region(next))) found |= 1U << step;
    }
    return found;
}

void Flood::go_on(const Judged& from, const base::Progress& progress) {
    if (!from.belongs) return;
    base::push_back_long(cells_.cell, from.cell, progress);
    const Cell place = geometry::morton_cell(from.cell.code);
    for (std::uint32_t left = known_.insert_around(place, from.onward); left != 0; left &= left - 1) {
        const Cell next = geometry::neighbour(place, std::countr_zero(left));
        next_.push_back({geometry::CellGrid::pack(next),
                         from.cell.distance + cells_.grid.side * glm::dot(from.cell.normal, way_to(next, place))});
    }
}

void Flood::run(const base::Progress& progress) {
    for (bool first = true; !front_.empty(); first = false) {
        progress.check();
        resize_long(centre_, front_.size(), progress);
        for (std::int64_t i = 0; i < front_.size(); ++i) {
            if (i % 16384 == 0) progress.check();
            centre_.set(i, cells_.grid.centre(geometry::CellGrid::unpack(front_[i].cell)));
        }
        evaluate(site_, centre_, field_, progress);
        judged_.resize_for_overwrite(front_.size());
        site_.runtime.parallel.for_chunks(front_.size(), 1024, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) judged_[i] = judge(i, first);
        });
        next_.clear();
        for (std::int64_t i = 0; i < judged_.size(); ++i) {
            if (i % 4096 == 0) progress.check();
            go_on(judged_[i], progress);
        }
        std::swap(front_, next_);
    }
}

} // namespace

double SurfaceCells::half_diagonal() const noexcept { return 0.5 * std::sqrt(3.0) * grid.side; }

SurfaceCells find_surface_cells(const marks::Site& site, const geometry::VecArray& seeds,
                                const geometry::Bounds& region, double side, const base::Progress& progress) {
    SurfaceCells cells(site.memory());
    cells.grid = {region.min - 2.5 * side, side};
    cells.region = region;
    cells.band = 0.5 * side;
    Flood flood(site, cells);
    flood.start(seeds);
    flood.run(progress);
    base::sort_long(
        cells.cell.begin(), cells.cell.end(),
        [](const SurfaceCell& a, const SurfaceCell& b) { return a.code < b.code; }, progress);
    progress.update(1.0);
    return cells;
}

} // namespace hrbfnpr::stipples
