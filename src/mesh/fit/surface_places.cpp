// SPDX-License-Identifier: MIT
#include "mesh/fit/surface_places.h"

#include "base/random.h"
#include "base/status.h"
#include "curves/surface_mesh.h"
#include "mesh/edges.h"
#include "surface/project.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t lattice = 16;
constexpr std::int64_t places_a_task = 4096;
constexpr double tolerance = 1e-6; // of places, in diagonals
constexpr int place_evaluations = 12;
// More triangles that look away from the surface than sharp edges make.
constexpr double turned_share = 1e-2;
constexpr double cells_a_diagonal_at_most = 1024.0; // where those that are asked for show no surface at all
constexpr std::int64_t most_triangles_of_finer = 1'200'000;

void add_lattice(const base::Runtime& runtime, const implicit::Implicit& implicit, const geometry::Bounds& region,
                 geometry::VecArray& seeds, const base::Progress& progress) {
    surface::Projection points(runtime.memory);
    const glm::dvec3 step = region.size() / static_cast<double>(lattice);
    for (std::int64_t z = 0; z < lattice; ++z)
        for (std::int64_t y = 0; y < lattice; ++y)
            for (std::int64_t x = 0; x < lattice; ++x)
                points.position.push_back(region.min + step * (glm::dvec3(x, y, z) + 0.5));
    surface::ProjectionSettings settings;
    settings.evaluation_limit = place_evaluations;
    settings.tolerance = 1e-4;
    surface::project(runtime, implicit, settings, points, progress);
    for (std::int64_t i = 0; i < points.position.size(); ++i)
        if (points.status[i] == surface::ProjectionStatus::converged && region.contains(points.position[i]))
            seeds.push_back(points.position[i]);
}

[[nodiscard]] base::Array<double> running_area(const base::Runtime& runtime, const curves::SurfaceMesh& surface) {
    base::Array<double> area(runtime.memory);
    area.reserve(surface.triangles());
    double sum = 0.0;
    for (std::int64_t t = 0; t < surface.triangles(); ++t) {
        const std::int32_t* const v = surface.corner.data() + 3 * t;
        sum += glm::length(glm::cross(surface.position[v[1]] - surface.position[v[0]],
                                      surface.position[v[2]] - surface.position[v[0]]));
        area.push_back(sum);
    }
    return area;
}

// Whether finer cells would show another surface, and there is room for them.
[[nodiscard]] bool too_thin(const curves::SurfaceMesh& surface) noexcept {
    const auto triangles = static_cast<double>(surface.triangles());
    const bool thin = static_cast<double>(surface.turned) > turned_share * triangles || surface.missed_seeds > 0;
    return thin && 4 * surface.triangles() <= most_triangles_of_finer;
}

} // namespace

curves::SurfaceMesh find_surface(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                 const geometry::VecArray& seeds, const SurfaceSearch& search,
                                 const base::Progress& progress) {
    geometry::VecArray all(runtime.memory);
    all.reserve(seeds.size());
    for (std::int64_t i = 0; i < seeds.size(); ++i) all.push_back(seeds[i]);
    add_lattice(runtime, implicit, search.region, all, progress);
    curves::MeshSettings settings{search.region, search.side};
    settings.tolerance = search.precision;
    curves::SurfaceMesh surface = curves::triangulate_of_any_size(runtime, implicit, all, settings, progress);
    const double least = implicit.diagonal() / cells_a_diagonal_at_most;
    while ((search.finer && too_thin(surface)) || (surface.triangles() == 0 && settings.side > least)) {
        settings.side *= 0.5;
        surface = curves::triangulate(runtime, implicit, all, settings, progress);
    }
    return surface;
}

SurfaceParts parts_of(const base::Runtime& runtime, const curves::SurfaceMesh& surface) {
    SurfaceParts parts;
    Sets sets(runtime.memory, surface.vertices());
    bool border = false;
    for (std::int64_t t = 0; t < surface.triangles(); ++t) {
        const std::int32_t* const corner = surface.corner.data() + 3 * t;
        sets.join(corner[0], corner[1]);
        sets.join(corner[0], corner[2]);
        for (std::int64_t k = 0; k < 3; ++k) border = border || surface.neighbour[3 * t + k] < 0;
    }
    base::Array<std::uint8_t> used(runtime.memory, surface.vertices());
    for (const std::int32_t corner : surface.corner) used[corner] = 1;
    std::int64_t vertices = 0;
    for (std::int64_t v = 0; v < surface.vertices(); ++v) {
        vertices += used[v];
        parts.components += used[v] != 0 && sets.of(static_cast<std::int32_t>(v)) == v ? 1 : 0;
    }
    // A closed one has three edges for two triangles.
    const std::int64_t euler = vertices - surface.triangles() / 2;
    if (!border && surface.triangles() > 0 && euler % 2 == 0) parts.genus = parts.components - euler / 2;
    return parts;
}

void leave_out(const base::Runtime& runtime, const SurfaceSearch& search, SurfacePlaces& places,
               const base::Progress& progress) {
    if (search.support == nullptr) return;
    base::Array<double> beyond(runtime.memory);
    search.support->evaluate_all(runtime, places.position, places.gradient, beyond, progress);
    std::int64_t kept = 0;
    const std::int64_t count = places.position.size();
    for (std::int64_t i = 0; i < count; ++i) {
        if (!(beyond[i] <= search.limit)) continue;
        places.position.set(kept, places.position[i]);
        places.gradient.set(kept++, places.gradient[i]);
    }
    places.position.resize(kept);
    places.gradient.resize(kept);
}

SurfacePlaces places_on(const base::Runtime& runtime, const implicit::Implicit& implicit,
                        const curves::SurfaceMesh& surface, const SurfaceSearch& search,
                        const base::Progress& progress) {
    SurfacePlaces places(runtime.memory);
    if (surface.triangles() == 0) return places;
    const base::Array<double> area = running_area(runtime, surface);
    geometry::VecArray flat(runtime.memory, search.count);
    surface::Projection on(runtime.memory);
    on.position.resize(search.count);
    runtime.parallel.for_chunks(search.count, places_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto random =
                base::uniform4(search.seed, static_cast<std::uint64_t>(i), base::Purpose::mesh_sample, 1U << 16U);
            const double* const found = std::upper_bound(area.begin(), area.end(), random[0] * area[area.size() - 1]);
            const std::int64_t t = std::min<std::int64_t>(found - area.begin(), surface.triangles() - 1);
            const std::int32_t* const v = surface.corner.data() + 3 * t;
            const double root = std::sqrt(random[1]);
            flat.set(i, (1.0 - root) * surface.position[v[0]] + root * (1.0 - random[2]) * surface.position[v[1]] +
                            root * random[2] * surface.position[v[2]]);
            on.position.set(i, flat[i]);
        }
    });
    surface::ProjectionSettings settings;
    settings.evaluation_limit = place_evaluations;
    settings.tolerance = tolerance;
    surface::project(runtime, implicit, settings, on, progress);
    for (std::int64_t i = 0; i < search.count; ++i) {
        const bool good = on.status[i] == surface::ProjectionStatus::converged &&
                          glm::distance(on.position[i], flat[i]) <= surface.side;
        places.position.push_back(good ? on.position[i] : flat[i]);
        places.gradient.push_back(on.gradient[i]);
    }
    places.found = places.position.size();
    leave_out(runtime, search, places, progress);
    return places;
}

} // namespace hrbfnpr::mesh
