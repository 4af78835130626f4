// SPDX-License-Identifier: MIT
#include "curves/line_set.h"

#include "base/clock.h"
#include "surface/project.h"
#include "surface/region.h"

#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr double sides_a_spacing = 2.0;
constexpr double sides_a_diagonal = 96.0; // where no spacing is known
constexpr std::int64_t lattice = 24;      // points of the bounds that seeds are looked for from, along each axis
// More triangles than this share that look away from the surface: walls are too thin for the cells.
constexpr double turned_share = 2e-4;
constexpr std::int64_t most_triangles_of_finer = 1'200'000;

geometry::VecArray given_seeds(base::Memory& memory, std::span<const double> given) {
    geometry::VecArray seeds(memory);
    for (std::size_t i = 0; i + 2 < given.size(); i += 3) seeds.push_back({given[i], given[i + 1], given[i + 2]});
    return seeds;
}

// Points of a lattice brought onto the surface: those that stay in the region.
geometry::VecArray found_seeds(const base::Runtime& runtime, const implicit::Implicit& surface,
                               const geometry::Bounds& region, const base::Progress& progress) {
    surface::Projection points(runtime.memory);
    const glm::dvec3 step = (region.max - region.min) / static_cast<double>(lattice);
    for (std::int64_t z = 0; z < lattice; ++z)
        for (std::int64_t y = 0; y < lattice; ++y)
            for (std::int64_t x = 0; x < lattice; ++x)
                points.position.push_back(region.min + step * (glm::dvec3(x, y, z) + 0.5));
    surface::project(runtime, surface, {}, points, progress);
    geometry::VecArray seeds(runtime.memory);
    for (std::int64_t i = 0; i < points.position.size(); ++i)
        if (points.status[i] == surface::ProjectionStatus::converged && region.contains(points.position[i]))
            seeds.push_back(points.position[i]);
    return seeds;
}

} // namespace

LineSet::LineSet(const base::Runtime& runtime, const implicit::Implicit& surface, const LineSetSettings& settings,
                 const base::Progress& progress)
    : surface_(surface) {
    const base::Stopwatch watch;
    MeshSettings mesh;
    mesh.region = surface::search_region(surface);
    mesh.side = settings.side;
    if (!(mesh.side > 0.0))
        mesh.side = settings.spacing > 0.0 ? settings.spacing / sides_a_spacing : surface.diagonal() / sides_a_diagonal;
    const geometry::VecArray seeds = settings.seeds.empty()
                                         ? found_seeds(runtime, surface, mesh.region, progress.part(0.0, 0.2))
                                         : given_seeds(runtime.memory, settings.seeds);
    for (double from = 0.2;; from = 0.5 * (1.0 + from)) {
        mesh_ = triangulate(runtime, surface, seeds, mesh, progress.part(from, 0.5 * (1.0 + from)));
        const auto triangles = static_cast<double>(mesh_->triangles());
        const bool thin = static_cast<double>(mesh_->turned) > turned_share * triangles || mesh_->missed_seeds > 0;
        if (settings.side > 0.0 || !thin || 4 * mesh_->triangles() > most_triangles_of_finer) break;
        mesh.side *= 0.5;
    }
    if (mesh_->triangles() == 0)
        fail(Status::not_converged, "no surface was found to draw lines of: f has no zero near the seeds; give "
                                    "seed_points on the surface");
    sheets_.emplace(runtime, *mesh_);
    seconds_ = watch.seconds();
    runtime.log(base::LogLevel::info,
                "lines: %lld triangles of cells of %.3g in %.3f s, %lld look away, %lld seeds missed",
                static_cast<long long>(mesh_->triangles()), mesh_->side, seconds_,
                static_cast<long long>(mesh_->turned), static_cast<long long>(mesh_->missed_seeds));
    progress.update(1.0);
}

} // namespace hrbfnpr::curves
