// SPDX-License-Identifier: MIT
#include "stipples/surface_cells.h"

#include "base/sort_on_threads.h"
#include "geometry/cell_set.h"
#include "geometry/long_vec_array.h"
#include "stipples/tuning.h"

#include <bit>
#include <limits>

namespace hrbfnpr::stipples {
namespace {

using Cell = geometry::CellGrid::Cell;

constexpr double no_plane = std::numeric_limits<double>::quiet_NaN();

// A cell that the flood has reached, but not judged.
struct FloodCell {
    std::uint64_t cell; // the packed coordinates
    // The distance of its centre from the surface, by the plane of the cell from which the flood came. NaN for the cell
    // of a seed.
    double expected;
};

// The judgement of a cell: whether it is one of the surface cells, and a bit for each of the 27 cells around it that
// the flood enters.
struct VisitedCell {
    SurfaceCell cell;
    bool is_surface_cell;
    std::uint32_t flooded_neighbours;
};

[[nodiscard]] bool is_in_region(const SurfaceCells& cells, const Cell& cell) noexcept {
    return geometry::CellGrid::inside(cell) &&
           cells.region.grown(0.5 * cells.grid.side).contains(cells.grid.centre(cell));
}

// Returns the distance between the surface and the centre of `next`, as estimated from the plane of `cell`, which is at
// `place`.
[[nodiscard]] double expected_at(const SurfaceCells& cells, const SurfaceCell& cell, const Cell& place,
                                 const Cell& next) noexcept {
    const glm::dvec3 way(static_cast<double>(next[0] - place[0]), static_cast<double>(next[1] - place[1]),
                         static_cast<double>(next[2] - place[2]));
    return cell.distance + cells.grid.side * glm::dot(cell.normal, way);
}

// Returns, as bits, the neighbours of a cell that the flood enters. A neighbour is skipped if, by the plane of this
// cell, its centre is too far from the surface. The flood may still enter a skipped neighbour from another cell. If
// `anywhere`, no neighbour is skipped for this reason, because an earlier plane was wrong. This happens at a sharp rim,
// or if f is not like a distance.
[[nodiscard]] std::uint32_t flooded_neighbours_of(const SurfaceCells& cells, const Cell& place, const SurfaceCell& cell,
                                                  bool anywhere) noexcept {
    const double side = cells.grid.side;
    const double farthest = cells.reach() + stipple_tuning.flood_slack * side;
    const geometry::Bounds centres = cells.region.grown(0.5 * side);
    const bool inside = centres.contains(cells.grid.centre(place) - side) &&
                        centres.contains(cells.grid.centre(place) + side) && geometry::CellGrid::inside(place);
    std::uint32_t found = 0;
    for (int step = 0; step < geometry::neighbour_count; ++step) {
        const Cell next = geometry::neighbour(place, step);
        if ((anywhere || !(std::abs(expected_at(cells, cell, place, next)) > farthest)) &&
            (inside || is_in_region(cells, next)))
            found |= 1U << step;
    }
    return found;
}

// Judges a cell. It is a surface cell if some of its points are in the band, by its first-order distance, or if it has
// a seed. The flood continues only from cells through which the surface may pass, so that it does not jump to another
// sheet a few cells away. The flood still reaches the whole band: for each point of the band, the nearest surface point
// is in the same cell or in a cell beside it (along each axis, 1/2 + 1/2 sqrt 3 + 1/2 < 2). The flood also stops at the
// end of a trimmed surface.
[[nodiscard]] VisitedCell visit_cell(const marks::Site& site, const SurfaceCells& cells, const FloodCell& from,
                                     bool seeded, double distance, const glm::dvec3& gradient) {
    const Cell place = geometry::CellGrid::unpack(from.cell);
    const bool near = std::abs(distance) <= cells.reach();
    VisitedCell visited{{geometry::morton_code(place), no_plane, glm::dvec3(0.0)}, near || seeded, 0};
    if (near) {
        visited.cell.distance = distance;
        visited.cell.normal = glm::normalize(gradient);
        if (!site.implicit.contains(cells.grid.centre(place) - distance * visited.cell.normal, visited.cell.normal))
            return visited;
    }
    if (seeded || std::abs(distance) <= cells.half_diagonal())
        visited.flooded_neighbours = flooded_neighbours_of(
            cells, place, visited.cell,
            !(std::abs(from.expected - distance) <= stipple_tuning.plane_error * cells.grid.side));
    return visited;
}

} // namespace

SurfaceCells find_surface_cells(const marks::Site& site, const geometry::VecArray& seeds,
                                const geometry::Bounds& region, double side) {
    HRBFNPR_ASSERT(side > 0.0);
    SurfaceCells cells(site.memory());
    cells.grid = {region.min - 2.5 * side, side};
    cells.region = region;
    cells.band = 0.5 * side;
    geometry::CellSet known(site.memory());
    base::Array<FloodCell> front(site.memory());
    base::Array<FloodCell> next(site.memory());
    for (std::int64_t i = 0; i < seeds.size(); ++i)
        if (const Cell cell = cells.grid.cell_of(seeds[i]); region.contains(seeds[i]) && is_in_region(cells, cell))
            if (const std::uint64_t packed = geometry::CellGrid::pack(cell); known.insert(packed))
                front.push_back({packed, no_plane});
    geometry::VecArray centre(site.memory());
    marks::FieldSamples field(site.memory());
    base::Array<VisitedCell> visited(site.memory());
    for (bool seeded = true; !front.empty(); seeded = false) {
        resize_long(centre, front.size(), site.work);
        for (const std::int64_t i : site.work.over(front.size())) {
            centre.set(i, cells.grid.centre(geometry::CellGrid::unpack(front[i].cell)));
        }
        evaluate(site, centre, field);
        visited.resize_for_overwrite(front.size());
        site.work.for_chunks(front.size(), cells_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i)
                visited[i] = visit_cell(site, cells, front[i], seeded, field.distance(i), field.gradient[i]);
        });
        next.clear();
        for (const std::int64_t i : site.work.over(visited.size())) {
            if (!visited[i].is_surface_cell) continue;
            const SurfaceCell& cell = visited[i].cell;
            base::push_back_long(cells.cell, cell, site.work);
            const Cell place = geometry::morton_cell(cell.code);
            for (std::uint32_t left = known.insert_around(place, visited[i].flooded_neighbours); left != 0;
                 left &= left - 1) {
                const Cell there = geometry::neighbour(place, std::countr_zero(left));
                next.push_back({geometry::CellGrid::pack(there), expected_at(cells, cell, place, there)});
            }
        }
        std::swap(front, next);
    }
    base::sort_on_threads(site.work, cells.cell,
                          [](const SurfaceCell& a, const SurfaceCell& b) { return a.code < b.code; });
    site.work.update(1.0);
    return cells;
}

CellMap::CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes) : CellMap(memory) {
    const auto begins_block = [&](std::int64_t i) {
        return i == 0 || codes[i] / geometry::cells_of_block != codes[i - 1] / geometry::cells_of_block;
    };
    std::int64_t blocks = 0;
    for (std::int64_t i = 0; i < codes.size(); ++i) blocks += begins_block(i) ? 1 : 0;
    slots_.resize(static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * blocks + 2))));
    number_.reserve(blocks);
    for (std::int64_t i = 0; i < codes.size(); ++i) {
        if (begins_block(i)) {
            const std::uint64_t block = codes[i] / geometry::cells_of_block;
            HRBFNPR_ASSERT(find_block(block) == nullptr); // The codes of a block must be consecutive.
            slots_[slot_of(block)] = {block + 1, number_.size()};
            number_.push_back({});
            number_.back().fill(-1);
        }
        std::int32_t& number = number_.back()[codes[i] % geometry::cells_of_block];
        HRBFNPR_ASSERT(number == -1);
        number = static_cast<std::int32_t>(i);
    }
}

CellMap::CellMap(const SurfaceCells& cells) : CellMap(cells.cell.memory()) {
    base::Array<std::uint64_t> codes(cells.cell.memory(), cells.cell.size());
    for (std::int64_t i = 0; i < codes.size(); ++i) codes[i] = cells.cell[i].code;
    *this = CellMap(codes.memory(), codes);
}

// Returns the slot of a block, or the free slot into which it would be put.
std::int64_t CellMap::slot_of(std::uint64_t block) const noexcept {
    HRBFNPR_ASSERT(!slots_.empty());
    const auto mask = static_cast<std::uint64_t>(slots_.size() - 1);
    std::uint64_t at = geometry::hash_bits(block) & mask;
    const auto key = [&] { return slots_[static_cast<std::int64_t>(at)].key; };
    while (key() != 0 && key() != block + 1) at = (at + 1) & mask;
    return static_cast<std::int64_t>(at);
}

CellMap::Around CellMap::around(std::uint64_t code, BlocksAround& blocks) const noexcept {
    Around found;
    if (const std::uint64_t block = code / geometry::cells_of_block; blocks.block != block) {
        blocks.block = block;
        for (std::size_t step = 0; step < found.size(); ++step) {
            const Cell there = geometry::neighbour(geometry::morton_cell(block), static_cast<int>(step));
            blocks.numbers[step] =
                geometry::CellGrid::inside(there) ? find_block(geometry::morton_code(there)) : nullptr;
        }
    }
    for (std::size_t step = 0; step < found.size(); ++step) {
        const geometry::InBlock& there = geometry::neighbours_in_blocks[code % geometry::cells_of_block][step];
        const std::int32_t* const numbers = blocks.numbers[there.block];
        found[step] = numbers == nullptr ? -1 : numbers[there.cell];
    }
    return found;
}

} // namespace hrbfnpr::stipples
