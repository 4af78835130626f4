// SPDX-License-Identifier: MIT
#include "generate/find_trim.h"

#include "base/assert.h"
#include "generate/tuning.h"
#include "geometry/along_curves.h"
#include "implicit/trimmed.h"
#include "stipples/surface_cells.h"
#include "stipples/tuning.h"
#include "surface/region.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::generate {
namespace {

using geometry::CellGrid;

constexpr double unused_tolerance = 1e-7; // the tolerance of projections, which are not used here

// The domain in which the first look follows the surface. It includes all places whose nearest sample is not
// surrounded, and ends where surrounded samples support the surface.
class UnsupportedDomain final : public implicit::Domain {
public:
    UnsupportedDomain(const surface::Support& support, double limit) noexcept : support_(support), limit_(limit) {}

    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept override {
        return support_.nearest_sample(place).surrounded ? limit_ - support_.value(place, gradient) : -limit_;
    }

private:
    const surface::Support& support_;
    double limit_;
};

// A connected set of cells in which s (surface/support.h) exceeds the limit.
struct UnsupportedPart {
    double highest = 0.0;            // the highest s in its cells
    double farthest = 0.0;           // the largest distance of its places from the nearest sample
    bool reaches_region_end = false; // true if it reaches the end of the region
    bool left_out = false;
    std::int64_t cells = 0;
};
constexpr std::int32_t supported = -1;
constexpr std::int32_t unassigned = -2;

// The cells that the surface passes through, and their parts.
struct FollowedSurface {
    explicit FollowedSurface(stipples::SurfaceCells found)
        : cells(std::move(found)), number(cells), part_of(cells.cell.memory(), cells.cell.size()),
          part(cells.cell.memory()) {}

    // Returns the place on the surface that is nearest to the centre of a cell.
    [[nodiscard]] glm::dvec3 place(std::int64_t cell) const noexcept {
        return cells.centre(cell) - cells.cell[cell].distance * cells.cell[cell].normal;
    }
    // Calls visit(cell, number) for a cell and its neighbours. `number` is the cell's index, or -1 if the surface does
    // not pass through it.
    template <class Visit>
    void for_neighbours(std::int64_t cell, Visit&& visit) const {
        const CellGrid::Cell at = geometry::morton_cell(cells.cell[cell].code);
        for (int step = 0; step < geometry::neighbour_count; ++step) {
            const CellGrid::Cell there = geometry::neighbour(at, step);
            if (CellGrid::inside(there)) visit(there, number.find(geometry::morton_code(there)));
        }
    }
    [[nodiscard]] bool is_left_out(std::int64_t cell) const noexcept {
        HRBFNPR_ASSERT(part_of[cell] < part.size());
        return part_of[cell] >= 0 && part[part_of[cell]].left_out;
    }

    stipples::SurfaceCells cells;
    stipples::CellMap number;
    base::Array<std::int32_t> part_of; // for each cell, the index of its part, or `supported`
    base::Array<UnsupportedPart> part;
};

// Follows the surface from samples, finds its parts, and reports the parts that are left out. A cautious look uses
// fewer cells and lower limits.
[[nodiscard]] FollowedSurface follow(const base::Work& work, const implicit::Implicit& implicit,
                                     const surface::Support& support, const TrimSettings& settings, bool wary,
                                     const geometry::VecArray& samples, TrimReport& report) {
    const double diagonal = implicit.diagonal();
    const geometry::Bounds region = implicit.bounds().grown(stipples::stipple_tuning.most_margin * diagonal);
    const double a_spacing = wary ? 1.0 : generate_tuning.cells_a_spacing;
    const double side =
        std::clamp(support.median_spacing() / a_spacing, region.diagonal() / generate_tuning.finest_cells,
                   region.diagonal() / generate_tuning.coarsest_cells);
    const marks::Site site{work, implicit, unused_tolerance, 1};
    FollowedSurface found(stipples::find_surface_cells(site.part(0.0, 0.6), samples, region, side));
    const stipples::SurfaceCells& cells = found.cells;
    const std::int64_t count = cells.cell.size();
    base::Array<double> value(work.memory, count); // s at the surface near the centre of each cell
    constexpr std::int64_t cells_a_task = 256;
    work.for_chunks(count, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const stipples::SurfaceCell& cell = cells.cell[i];
            value[i] = std::isnan(cell.distance) ? 0.0 : support.value(found.place(i), cell.normal);
            found.part_of[i] = value[i] > settings.limit ? unassigned : supported;
        }
    });
    const bool along_curves = !wary && settings.closest == 0.0 && support.samples_lie_along_curves();
    const double share = wary ? generate_tuning.caution_factor : 1.0;
    const geometry::Bounds inner = region.grown(-side);
    std::int64_t left_out = 0;
    base::Array<std::int64_t> front(work.memory);
    for (std::int64_t first = 0; first < count; ++first) {
        if (found.part_of[first] != unassigned) continue;
        UnsupportedPart part;
        front.clear();
        const auto take = [&](std::int64_t cell) {
            found.part_of[cell] = static_cast<std::int32_t>(found.part.size());
            front.push_back(cell);
            part.highest = std::max(part.highest, value[cell]);
            part.farthest = std::max(part.farthest, support.nearest_sample(found.place(cell)).distance);
            part.reaches_region_end = part.reaches_region_end || !inner.contains(cells.centre(cell));
        };
        take(first);
        for (std::int64_t next = 0; next < front.size(); ++next) {
            work.check();
            found.for_neighbours(front[next], [&](const CellGrid::Cell&, std::int32_t there) {
                if (there >= 0 && found.part_of[there] == unassigned) take(there);
            });
        }
        part.cells = front.size();
        // If samples are denser than the surface is accurate, gaps between them are not holes. If samples lie along
        // curves, the surface between the curves stays, however far from samples it is.
        const bool sure = settings.closest > 0.0 || part.highest >= share * generate_tuning.unsupported_limit;
        part.left_out =
            part.reaches_region_end || (!along_curves && sure && part.farthest > share * settings.hole * diagonal);
        found.part.push_back(part);
        if (!part.left_out) continue;
        ++report.parts;
        report.parts_to_end += part.reaches_region_end ? 1 : 0;
        report.farthest = std::max(report.farthest, part.farthest);
        left_out += part.cells;
    }
    if (left_out > 0) report.share = static_cast<double>(left_out) / static_cast<double>(count);
    return found;
}

// Returns whether a part of the surface may have to be left out. Such a part begins where samples are not surrounded.
[[nodiscard]] bool may_end(const base::Work& work, const ImplicitFor& implicit_for, const surface::Support& support,
                           const TrimSettings& settings) {
    if (!(settings.off <= generate_tuning.on_surface * support.median_spacing())) return true;
    const geometry::VecArray from = support.samples_not_surrounded();
    if (from.size() == 0) return false;
    if (2 * from.size() > support.samples()) return true;
    const double evaluations = generate_tuning.evaluations_of_sample * static_cast<double>(from.size());
    const implicit::Implicit& implicit = implicit_for(evaluations, work.without_progress());
    const UnsupportedDomain doubtful(support, settings.limit);
    const implicit::Trimmed some(implicit, doubtful);
    for (const bool wary : {true, false}) {
        TrimReport report;
        static_cast<void>(follow(work, some, support, settings, wary, from, report));
        if (report.parts == 0) return false;
    }
    return true;
}

} // namespace

FoundTrim find_trim(const base::Work& work, const ImplicitFor& implicit_for, const geometry::VecArray& position,
                    const geometry::VecArray& normal, const TrimSettings& settings) {
    HRBFNPR_ASSERT(position.size() > 0 && position.size() == normal.size());
    const double closest = settings.closest * implicit_for(0.0, {}).diagonal();
    surface::Support support(work.part(0.0, 0.2), position, normal, closest);
    FoundTrim trim;
    trim.report.samples = position.size();
    trim.report.spacing = support.median_spacing();
    if (!may_end(work.part(0.2, 0.3), implicit_for, support, settings)) return trim;
    const implicit::Implicit& implicit = implicit_for(generate_tuning.evaluations_of_surface, work.part(0.3, 0.5));
    const FollowedSurface found =
        follow(work.part(0.5, 1.0), implicit, support, settings, false, position, trim.report);
    if (trim.report.share == 1.0)
        fail(Status::not_converged, "no part of the surface is near the samples; give more samples, or a larger limit");
    if (trim.report.parts == 0) return trim;
    // The surface ends between a cell that is left out and one that is kept. Neighbours of left-out cells also count as
    // left out, except the cells of holes that stay closed.
    geometry::CellSet left_out(work.memory);
    for (std::int64_t i = 0; i < found.part_of.size(); ++i)
        if (found.is_left_out(i))
            found.for_neighbours(i, [&](const CellGrid::Cell& there, std::int32_t number) {
                if (number < 0 || found.part_of[number] < 0 || found.is_left_out(number))
                    left_out.insert(CellGrid::pack(there));
            });
    geometry::CellSet kept(work.memory);
    for (const stipples::SurfaceCell& cell : found.cells.cell)
        if (const std::uint64_t packed = CellGrid::pack(geometry::morton_cell(cell.code)); !left_out.contains(packed))
            kept.insert(packed);
    support.keep(found.cells.grid, std::move(kept), std::move(left_out), settings.limit);
    trim.trim = std::make_unique<surface::SupportDomain>(std::move(support), settings.limit, closest);
    work.update(1.0);
    return trim;
}

geometry::Bounds closed_bounds(const base::Work& work, const implicit::Implicit& implicit,
                               const geometry::VecArray& position) {
    geometry::Bounds bounds = implicit.bounds();
    if (position.size() > generate_tuning.most_samples_along_curves) return bounds;
    const bool along_curves = geometry::lie_along_curves(geometry::PointTree(position, work.part(0.0, 0.1)));
    if (!along_curves && position.size() > generate_tuning.few_samples) return bounds;
    const double diagonal = implicit.diagonal();
    const geometry::Bounds region = bounds.grown(generate_tuning.closing_distance * diagonal);
    const marks::Site site{work, implicit, unused_tolerance, 1};
    const stipples::SurfaceCells found =
        stipples::find_surface_cells(site.part(0.1, 1.0), position, region, diagonal / generate_tuning.cells_of_bounds);
    const geometry::Bounds inside = region.grown(-found.grid.side);
    for (std::int64_t i = 0; i < found.cell.size(); ++i) {
        const stipples::SurfaceCell& cell = found.cell[i];
        const glm::dvec3 centre = found.centre(i);
        if (!inside.contains(centre)) return implicit.bounds();
        if (std::abs(cell.distance) < found.grid.side) bounds.extend(centre - cell.distance * cell.normal);
    }
    // Between a few points that lie all over a surface, it bulges, mostly by less than the margin of the search box.
    const geometry::Bounds search_box = implicit.bounds().grown(surface::region_margin * diagonal);
    const bool fits = search_box.contains(bounds.min) && search_box.contains(bounds.max);
    return !along_curves && fits ? implicit.bounds() : bounds;
}

} // namespace hrbfnpr::generate
