// SPDX-License-Identifier: MIT
#include "stipples/needed_cells.h"

#include "stipples/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::stipples {
namespace {

[[nodiscard]] base::Array<std::uint64_t> codes_of(const SurfaceCells& cells) {
    base::Array<std::uint64_t> code(cells.cell.memory(), cells.cell.size());
    for (std::int64_t i = 0; i < code.size(); ++i) code[i] = cells.cell[i].code;
    return code;
}

// The cells of a level, each with the largest share of the surface's cells inside.
struct CellsOfLevel {
    explicit CellsOfLevel(base::Memory& memory) noexcept : code(memory), share(memory), cell_of(memory) {}

    base::Array<std::uint64_t> code;
    base::Array<float> share;
    base::Array<std::int32_t> cell_of; // for each cell of the surface: the index of the cell of the level
};

[[nodiscard]] CellsOfLevel cells_of_level(const base::Array<std::uint64_t>& code, const base::Array<float>& share,
                                          std::int32_t level) {
    CellsOfLevel cells(code.memory());
    cells.cell_of.resize_for_overwrite(code.size());
    for (std::int64_t i = 0; i < code.size(); ++i) {
        const std::uint64_t here = code[i] >> static_cast<unsigned>(3 * level);
        if (cells.code.empty() || cells.code.back() != here) {
            cells.code.push_back(here);
            cells.share.push_back(0.0F);
        }
        cells.share.back() = std::max(cells.share.back(), share[i]);
        cells.cell_of[i] = static_cast<std::int32_t>(cells.code.size() - 1);
    }
    return cells;
}

} // namespace

double OrderStages::reach(double marks) const noexcept {
    return stipple_tuning.energy_reach * densest_distance(area, marks);
}

std::int32_t OrderStages::last_level() const noexcept {
    std::int32_t level = 0;
    while (level < geometry::CellGrid::bits &&
           side_of(level) < stipple_tuning.least_side_share * reach(static_cast<double>(wanted)))
        ++level;
    return level;
}

std::int32_t OrderStages::first_level() const noexcept {
    std::int32_t level = last_level();
    while (level < geometry::CellGrid::bits && side_of(level) < reach(1.0)) ++level;
    return level;
}

// Up to this number of marks, the energies of a stage reach at least one cell side. The last stage places the rest.
std::int64_t OrderStages::marks_at_end(std::int32_t level) const noexcept {
    if (level <= last_level()) return wanted;
    const double within = std::floor(std::pow(reach(1.0) / side_of(level), 2.0));
    return std::min(static_cast<std::int64_t>(within), wanted);
}

double OrderStages::candidates_of(std::int64_t marks_at_end, double all) noexcept {
    return std::min(all, std::max(64.0, stipple_tuning.early_candidates * static_cast<double>(marks_at_end)));
}

base::Array<float> largest_around(const base::Work& work, const base::Array<std::uint64_t>& code,
                                  const CellMap& numbers, const base::Array<float>& value) {
    HRBFNPR_ASSERT(code.size() == value.size());
    base::Array<float> largest(work.memory, code.size());
    work.for_chunks(code.size(), cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        CellMap::BlocksAround blocks;
        for (std::int64_t i = begin; i < end; ++i)
            for (const std::int32_t there : numbers.around(code[i], blocks))
                if (there >= 0) largest[i] = std::max(largest[i], value[there]);
    });
    return largest;
}

// The first marks are needed everywhere. A cell without a plane is needed whole, because its normals are unknown.
base::Array<float> needed_shares(const marks::Site& site, const SurfaceCells& cells, const marks::Need& need,
                                 std::int64_t wanted) {
    HRBFNPR_ASSERT(wanted > 0);
    const double spacing = std::sqrt(cells.rough_area() / static_cast<double>(wanted));
    const double least = std::min(1.0, stipple_tuning.needed_everywhere / static_cast<double>(wanted));
    base::Array<float> own(site.memory(), cells.cell.size());
    site.work.for_chunks(own.size(), cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const SurfaceCell& cell = cells.cell[i];
            const glm::dvec3 place = cells.centre(i) - cell.distance * cell.normal;
            own[i] = std::isnan(cell.distance)
                         ? 1.0F
                         : static_cast<float>(std::clamp(need.share(place, cell.normal, spacing), least, 1.0));
        }
    });
    return largest_around(site.work, codes_of(cells), CellMap(cells), own);
}

// A cell takes part in a stage if the stage begins with fewer marks than are needed in the cell of the stage or beside
// it. The cell is closed when it has these marks. The area of the surface is only estimated at this point, so cells
// take part a little longer than in the stage.
base::Array<float> candidate_shares(const base::Work& work, const SurfaceCells& cells, const base::Array<float>& share,
                                    const OrderStages& stages, double candidates, double least_share) {
    HRBFNPR_ASSERT(share.size() == cells.cell.size());
    const base::Array<std::uint64_t> code = codes_of(cells);
    base::Array<float> result(work.memory, code.size());
    std::fill(result.begin(), result.end(), static_cast<float>(least_share));
    const std::int32_t first = stages.first_level();
    for (std::int32_t level = first; level >= stages.last_level(); --level) {
        const std::int64_t begin = level == first ? 0 : stages.marks_at_end(level + 1);
        const auto limit = static_cast<float>(stipple_tuning.early_share * static_cast<double>(begin) /
                                              static_cast<double>(stages.wanted));
        const std::int64_t end = stages.marks_at_end(level);
        const auto share_for = [&](std::int64_t marks) {
            return static_cast<float>(OrderStages::candidates_of(marks, candidates) / candidates);
        };
        if (!(double{share_for(end)} > least_share)) continue;
        const CellsOfLevel of_level = cells_of_level(code, share, level);
        const CellMap numbers(work.memory, of_level.code);
        const base::Array<float> largest = largest_around(work, of_level.code, numbers, of_level.share);
        for (const std::int64_t i : work.over(code.size())) {
            const float most = largest[of_level.cell_of[i]];
            if (!(most > limit)) continue;
            const double needed = double{most} / stipple_tuning.early_share * static_cast<double>(stages.wanted);
            result[i] = std::max(result[i], share_for(std::min(end, static_cast<std::int64_t>(needed))));
        }
    }
    return result;
}

} // namespace hrbfnpr::stipples
