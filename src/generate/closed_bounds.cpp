// SPDX-License-Identifier: MIT
#include "generate/closed_bounds.h"

#include "geometry/along_curves.h"
#include "geometry/morton.h"
#include "stipples/surface_cells.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::generate {
namespace {

using geometry::Bounds;

constexpr std::int64_t most_samples = 20000; // of more, following the surface takes longer than the fit
constexpr double reach = 1.0 / 3.0;          // diagonals
constexpr double cells = 64.0;               // in a diagonal

} // namespace

Bounds closed_bounds(const base::Runtime& runtime, const implicit::Implicit& implicit,
                     const geometry::VecArray& position, const base::Progress& progress) {
    Bounds bounds = implicit.bounds();
    if (position.size() > most_samples) return bounds;
    if (!geometry::along_curves(geometry::PointTree(position, progress.part(0.0, 0.1)))) return bounds;
    const Bounds region = bounds.grown(reach * implicit.diagonal());
    const marks::Site site{runtime, implicit, 1e-7, 1};
    const stipples::SurfaceCells found =
        stipples::find_surface_cells(site, position, region, implicit.diagonal() / cells, progress.part(0.1, 1.0));
    const Bounds inside = region.grown(-found.grid.side);
    for (const stipples::SurfaceCell& cell : found.cell) {
        const glm::dvec3 centre = found.grid.centre(geometry::morton_cell(cell.code));
        if (!inside.contains(centre)) return implicit.bounds();
        if (std::abs(cell.distance) < found.grid.side) bounds.extend(centre - cell.distance * cell.normal);
    }
    return bounds;
}

} // namespace hrbfnpr::generate
