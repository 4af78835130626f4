// SPDX-License-Identifier: MIT
#include "stipples/plane_candidates.h"

#include "base/random.h"
#include "geometry/morton.h"
#include "stipples/order_loops.h"
#include "surface/creased.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hrbfnpr::stipples {
namespace {

constexpr std::int64_t plane_cells_of_task = 2048;
// Of the planes of flat neighbours: how far they may miss each other's centres, in sides, and the cosine between them.
constexpr double expected_share = 0.1;
constexpr double straight_plane = 0.97;
// A plane that passes a cell by at this distance, in sides, is trusted to.
constexpr double clearly = 0.25;
// The second power's root of x^3 = x + 1: the multiples of 1/x and 1/x^2 fill the unit square evenly, however many
// there are (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
constexpr std::uint32_t long_step = 3242174889; // in 2^-32
constexpr std::uint32_t short_step = 2447445414;

// Trials in a cell: as many as any is allowed, and the most.
constexpr double fewest_in_cell = 64.0;
constexpr double most_of_cell = 1e6;

int longest_axis(const glm::dvec3& n) noexcept {
    const glm::dvec3 a = glm::abs(n);
    return a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
}

} // namespace

PlaneCandidates::PlaneCandidates(const marks::Site& site, const SurfaceCells& cells, const CellMap& numbers,
                                 std::uint32_t stream, const base::Progress& progress)
    : site_(site), cells_(cells), stream_(stream | 0xffff0000U), kind_(site.memory(), cells.cell.size()),
      curvature_(site.memory(), cells.cell.size()), count_(site.memory(), cells.cell.size()) {
    site.runtime.parallel.for_chunks(kind_.size(), plane_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        CellNeighbours around(numbers);
        for (std::int64_t i = begin; i < end; ++i) {
            const Judged judged = judge(cells_.cell[i], around);
            kind_[i] = judged.kind;
            curvature_[i] = judged.curvature;
        }
    });
}

// A crease may cut off no more than an edge or a corner of the cell.
bool PlaneCandidates::is_at_crease(const SurfaceCell& cell, const CellNeighbours& around) const noexcept {
    for (std::size_t step = 0; step < CellNeighbours::count; ++step)
        if (around[step] >= 0 && !(glm::dot(cell.normal, cells_.cell[around[step]].normal) >= surface::smooth_cosine))
            return true;
    return false;
}

// A plane is the surface where those of all cells beside it are the same one: none is nearer to another sheet, or
// around a bend.  What they turn is the divergence of the normals, twice the mean curvature.
PlaneCandidates::Judged PlaneCandidates::judge(const SurfaceCell& cell, CellNeighbours& around) const noexcept {
    const double side = cells_.grid.side;
    const glm::dvec3 along = glm::abs(cell.normal);
    if (std::isnan(cell.distance)) return {CellKind::bent, 0.0F};
    if (const implicit::Extent* const extent = site_.implicit.extent(); extent != nullptr)
        if (extent->may_end_near(cells_.grid.centre(geometry::morton_cell(cell.code)), 0.5 * side))
            return {CellKind::bent, 0.0F};
    if (std::abs(cell.distance) > side * (0.5 * (along.x + along.y + along.z) + clearly))
        return {CellKind::clear, 0.0F};
    around.go_to(cell.code);
    if (site_.implicit.sheets() != nullptr && is_at_crease(cell, around)) return {CellKind::bent, 0.0F};
    double divergence = 0.0;
    bool known = true;
    for (int axis = 0; axis < 3; ++axis) {
        double turn = 0.0;
        int beside = 0;
        for (const int way : {-1, 1}) {
            const std::size_t step = CellNeighbours::step_along[axis];
            const std::int32_t number = around[way < 0 ? CellNeighbours::itself - step : CellNeighbours::itself + step];
            if (number < 0) continue;
            const SurfaceCell& there = cells_.cell[number];
            const double distance = cell.distance + way * side * cell.normal[axis];
            if (!(std::abs(distance - there.distance) <= expected_share * side) ||
                !(glm::dot(cell.normal, there.normal) >= straight_plane))
                return {CellKind::bent, 0.0F};
            turn += way * (there.normal[axis] - cell.normal[axis]);
            ++beside;
        }
        known = known && beside > 0;
        divergence += beside > 0 ? turn / (side * beside) : 0.0;
    }
    return {CellKind::flat, known ? static_cast<float>(0.5 * divergence) : 0.0F};
}

// Trials stand above a face of the cell, evenly; those whose place on the plane is in the cell are candidates.
// Along the face they are counted in 2^-32 sides from its middle, and wrap around.
struct PlaneCandidates::Trials {
    static constexpr double unit = 1.0 / 4294967296.0;
    std::int32_t count;
    std::uint32_t u, v; // of the first one
    std::uint32_t step_u, step_v;
    double before; // what was left of a trial: the ticket of trial k is (k + before) / count
    double level, slope_u, slope_v;

    [[nodiscard]] double along_u(std::int32_t k) const noexcept {
        return along(u + step_u * static_cast<std::uint32_t>(k));
    }
    [[nodiscard]] double along_v(std::int32_t k) const noexcept {
        return along(v + step_v * static_cast<std::uint32_t>(k));
    }
    [[nodiscard]] double height(std::int32_t k) const noexcept {
        return level + slope_u * along_u(k) + slope_v * along_v(k);
    }
    [[nodiscard]] static double along(std::uint32_t at) noexcept { return unit * static_cast<std::int32_t>(at); }
};

PlaneCandidates::Trials PlaneCandidates::trials_in(const SurfaceCell& cell) const noexcept {
    const base::Philox random = base::philox(
        site_.random_seed, {static_cast<std::uint32_t>(cell.code), static_cast<std::uint32_t>(cell.code >> 32U),
                            static_cast<std::uint32_t>(base::Purpose::candidate), stream_});
    const double side = cells_.grid.side;
    const int up = longest_axis(cell.normal);
    const double trials = density_ * side * side / std::abs(cell.normal[up]);
    // The points are a lattice; turned and mirrored in some cells, it leaves no trace in the whole.
    const bool turned = (random[3] & 1U) != 0;
    const bool mirrored = (random[3] & 2U) != 0;
    const std::uint32_t along_v = turned ? long_step : short_step;
    return {static_cast<std::int32_t>(std::min(trials, most_in_cell_) + Trials::unit * random[0]),
            random[1],
            random[2],
            turned ? short_step : long_step,
            mirrored ? 0U - along_v : along_v,
            Trials::unit * random[3],
            -cell.distance / (side * cell.normal[up]),
            -cell.normal[(up + 1) % 3] / cell.normal[up],
            -cell.normal[(up + 2) % 3] / cell.normal[up]};
}

// Calls visit(place, ticket), the ticket being in [0, 1).
template <class Visit>
void PlaneCandidates::for_points(const SurfaceCell& cell, Visit&& visit) const noexcept {
    const Trials trials = trials_in(cell);
    const int up = longest_axis(cell.normal);
    const double side = cells_.grid.side;
    const glm::dvec3 centre = cells_.grid.centre(geometry::morton_cell(cell.code));
    const bool inside = cells_.region.contains(centre - 0.5 * side) && cells_.region.contains(centre + 0.5 * side);
    for (std::int32_t k = 0; k < trials.count; ++k) {
        const double height = trials.height(k);
        if (!(height >= -0.5 && height < 0.5)) continue;
        glm::dvec3 offset;
        offset[up] = height;
        offset[(up + 1) % 3] = trials.along_u(k);
        offset[(up + 2) % 3] = trials.along_v(k);
        const glm::dvec3 place = centre + side * offset;
        if (inside || cells_.region.contains(place)) visit(place, (k + trials.before) / trials.count);
    }
}

void PlaneCandidates::draw(double density, double most_trials, const base::Progress& progress) {
    density_ = density;
    const auto flat = static_cast<double>(std::count(kind_.begin(), kind_.end(), CellKind::flat));
    most_in_cell_ = std::clamp(most_trials / std::max(flat, 1.0), fewest_in_cell, most_of_cell);
    site_.runtime.parallel.for_chunks(kind_.size(), plane_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            progress.check(); // a cell may have many
            std::int32_t count = 0;
            if (kind_[i] == CellKind::flat) for_points(cells_.cell[i], [&](const glm::dvec3&, double) { ++count; });
            count_[i] = count;
        }
    });
    all_ = std::accumulate(count_.begin(), count_.end(), std::int64_t{0});
}

// The plane touches the surface at a distance from the cell's centre; away from there by t, a surface of mean curvature
// k is 1/2 k t^2 below it, but for what the two principal curvatures differ.  Candidates stay in their cells, where the
// order looks for them.
void PlaneCandidates::put(std::int64_t cell, std::int64_t to, Candidates& candidates) const noexcept {
    const OrderBlock all = candidates.places();
    const SurfaceCell& c = cells_.cell[cell];
    const float bits =
        packed_normal({static_cast<float>(c.normal.x), static_cast<float>(c.normal.y), static_cast<float>(c.normal.z)});
    const glm::dvec3 centre = cells_.grid.centre(geometry::morton_cell(c.code));
    const double half_curvature = 0.5 * double{curvature_[cell]};
    for_points(c, [&](const glm::dvec3& place, double part) {
        const glm::dvec3 offset = place - centre;
        const double below = half_curvature * (glm::dot(offset, offset) - c.distance * c.distance);
        const glm::dvec3 lowered = offset - below * c.normal;
        const bool inside = glm::all(glm::lessThan(glm::abs(lowered), glm::dvec3(0.5 * cells_.grid.side)));
        const glm::vec3 p((inside ? centre + lowered : place) - cells_.grid.origin);
        all.at(OrderGroup::x, to) = p.x;
        all.at(OrderGroup::y, to) = p.y;
        all.at(OrderGroup::z, to) = p.z;
        all.at(OrderGroup::normal, to) = bits;
        candidates.ticket[to++] = static_cast<std::uint32_t>(part * 4294967296.0);
    });
}

} // namespace hrbfnpr::stipples
