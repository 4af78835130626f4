// SPDX-License-Identifier: MIT
// The steps of compare(), in order:
//
//   find_surface     finds the surface as triangles, from places on the mesh and from a coarse lattice
//   parts_of         counts components and handles of the surface; if the mesh has other numbers, cells are halved once
//   measure_surface  measures the distances to the mesh from places on the surface, which sample_surface() spreads
//   measure_mesh     measures the distances to the surface from places on the mesh, and angles between the normals
#include "mesh/fit/compare.h"

#include "base/clock.h"
#include "curves/surface_mesh.h"
#include "mesh/edges.h"
#include "mesh/fit/outer.h"
#include "mesh/fit/tuning.h"
#include "mesh/plan.h"
#include "mesh/sample.h"
#include "surface/project.h"
#include "surface/region.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// The indices of the streams of random numbers that choose places. A fit uses other streams, so the places are not
// those of the fit.
constexpr std::uint32_t places_of_mesh = 77;
constexpr std::uint32_t places_of_surface = 1U << 16U;

struct CompareTask {
    const base::Work& work;
    const implicit::Implicit& implicit;
    const SurfaceSearch& search;
};

[[nodiscard]] surface::Projection projected(const CompareTask& task, const geometry::VecArray& places, int evaluations,
                                            double tolerance, const base::Progress& progress) {
    surface::Projection on(task.work.memory);
    on.position.reserve(places.size());
    for (std::int64_t i = 0; i < places.size(); ++i) on.position.push_back(places[i]);
    surface::ProjectionSettings settings;
    settings.evaluation_limit = evaluations;
    settings.tolerance = tolerance;
    surface::project({task.work, progress}, task.implicit, settings, on);
    return on;
}

// Returns distance(i) for all i, in small tasks, because a distance may take long where a place is far from all faces.
template <class Distance>
[[nodiscard]] base::Array<double> distances(const CompareTask& task, std::int64_t count, Distance&& distance) {
    base::Array<double> result(task.work.memory, count);
    task.work.for_chunks(count, 256, [&](std::int64_t begin, std::int64_t end) {
        for (const std::int64_t i : task.work.over(begin, end)) {
            result[i] = distance(i);
        }
    });
    return result;
}

// ---- The surface as triangles

void add_lattice(const CompareTask& task, geometry::VecArray& seeds) {
    const std::int64_t n = mesh_fit_tuning.lattice;
    const geometry::Bounds& region = task.search.region;
    const glm::dvec3 step = region.size() / static_cast<double>(n);
    geometry::VecArray lattice(task.work.memory);
    for (std::int64_t i = 0; i < n * n * n; ++i)
        lattice.push_back(region.min + step * (glm::dvec3(i % n, i / n % n, i / (n * n)) + 0.5));
    const surface::Projection on =
        projected(task, lattice, mesh_fit_tuning.place_evaluations, mesh_fit_tuning.on_surface_of_seeds, task.work);
    for (std::int64_t i = 0; i < on.position.size(); ++i)
        if (on.status[i] == surface::ProjectionStatus::converged && region.contains(on.position[i]))
            seeds.push_back(on.position[i]);
}

// Returns whether parts of the surface are too thin for the cells, so that finer cells may show more of it. Returns
// false if finer cells would make too many triangles.
[[nodiscard]] bool too_thin(const curves::SurfaceMesh& surface) noexcept {
    const auto triangles = static_cast<double>(surface.triangles());
    const bool thin =
        static_cast<double>(surface.turned) > mesh_fit_tuning.turned_share * triangles || surface.missed_seeds > 0;
    return thin && 4 * surface.triangles() <= mesh_fit_tuning.most_triangles;
}

struct SurfaceParts {
    std::int64_t components = 0;
    std::int64_t genus = -1; // the sum over all components; -1 if the surface has a border
};

[[nodiscard]] SurfaceParts parts_of(const base::Runtime& runtime, const curves::SurfaceMesh& surface) {
    SurfaceParts parts;
    UnionFind sets(runtime.memory, surface.vertices());
    for (std::int64_t t = 0; t < surface.triangles(); ++t) {
        const std::int32_t* const corner = surface.corner.data() + 3 * t;
        sets.join(corner[0], corner[1]);
        sets.join(corner[0], corner[2]);
    }
    base::Array<std::uint8_t> used(runtime.memory, surface.vertices());
    for (const std::int32_t corner : surface.corner) used[corner] = 1;
    std::int64_t vertices = 0;
    for (std::int64_t v = 0; v < surface.vertices(); ++v) {
        vertices += used[v];
        parts.components += used[v] != 0 && sets.find(static_cast<std::int32_t>(v)) == v ? 1 : 0;
    }
    const bool border =
        std::any_of(surface.neighbour.begin(), surface.neighbour.end(), [](std::int32_t beyond) { return beyond < 0; });
    // A closed surface has 3/2 times as many edges as triangles.
    const std::int64_t euler = vertices - surface.triangles() / 2;
    if (!border && surface.triangles() > 0 && euler % 2 == 0) parts.genus = parts.components - euler / 2;
    return parts;
}

// Returns whether a closed mesh and the surface have different numbers of components or handles. The numbers differ
// where a wall or a gap is too thin for the cells.
[[nodiscard]] bool differ(const SurfaceParts& parts, const MeshReport& report) noexcept {
    return report.closed &&
           (parts.genus != report.genus || parts.components != report.components - report.left_out_components);
}

// Returns a tree of the triangles.
[[nodiscard]] FaceTree tree_of(const base::Work& work, const curves::SurfaceMesh& surface) {
    base::Array<glm::dvec3> vertex(work.memory);
    base::Array<Triangle> triangle(work.memory);
    vertex.reserve(surface.vertices());
    triangle.reserve(surface.triangles());
    for (std::int64_t v = 0; v < surface.vertices(); ++v) vertex.push_back(surface.position[v]);
    for (std::int64_t t = 0; t < surface.triangles(); ++t)
        triangle.push_back({surface.corner[3 * t], surface.corner[3 * t + 1], surface.corner[3 * t + 2]});
    return {work, vertex, triangle};
}

// ---- Distances from places on the surface to the mesh

// Returns places on the surface, spread evenly over its area. If a projection fails, the place stays on its triangle.
[[nodiscard]] SurfacePlaces sample_surface(const CompareTask& task, const curves::SurfaceMesh& surface,
                                           const base::Progress& progress) {
    SurfacePlaces places(task.work.memory);
    if (surface.triangles() == 0) return places;
    const auto corners = [&](std::int64_t t) {
        const std::int32_t* const v = surface.corner.data() + 3 * t;
        return std::array<glm::dvec3, 3>{surface.position[v[0]], surface.position[v[1]], surface.position[v[2]]};
    };
    const RandomPlaces random(task.work.memory, surface.triangles(), corners, task.work);
    geometry::VecArray flat(task.work.memory, task.search.count);
    task.work.for_chunks(flat.size(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto [t, s] = random.at(task.search.seed, i, places_of_surface);
            const auto p = corners(t);
            flat.set(i, s.x * p[0] + s.y * p[1] + s.z * p[2]);
        }
    });
    const surface::Projection on =
        projected(task, flat, mesh_fit_tuning.place_evaluations, mesh_fit_tuning.on_surface, progress);
    for (std::int64_t i = 0; i < flat.size(); ++i) {
        const bool good = on.status[i] == surface::ProjectionStatus::converged &&
                          glm::distance(on.position[i], flat[i]) <= surface.side;
        places.position.push_back(good ? on.position[i] : flat[i]);
        places.gradient.push_back(on.gradient[i]);
    }
    return places;
}

void measure_surface(const CompareTask& task, const Mesh& mesh, const curves::SurfaceMesh& surface,
                     const OuterFaces& outer, double far, Comparison& result) {
    SurfacePlaces places = sample_surface(task, surface, task.work.part(0.4, 0.6));
    const std::int64_t found = places.position.size();
    drop_unsupported(task.work.part(0.4, 0.6), task.search, places);
    base::Array<double> distance = distances(task, places.position.size(), [&](std::int64_t i) {
        const FaceTree::Nearest nearest = outer.tree().nearest(places.position[i]);
        return on_border(mesh, nearest.face, nearest.place) ? -1.0 : std::sqrt(nearest.squared);
    });
    distance.resize(std::remove_if(distance.begin(), distance.end(), [](double d) { return d < 0.0; }) -
                    distance.begin());
    result.left_out =
        static_cast<double>(found - distance.size()) / static_cast<double>(std::max<std::int64_t>(found, 1));
    result.surface = statistics_of(distance, result.tolerance, far);
}

// ---- Distances from places on the mesh to the surface

// Measures two distances from each place and uses the smaller one: to the place's projection onto the surface, and to
// the nearest triangle. The projection may miss the nearest point of the surface, and the triangles are only close to
// the surface.
void measure_mesh(const CompareTask& task, const curves::SurfaceMesh& surface, const MeshSamples& samples, double far,
                  Comparison& result) {
    const surface::Projection on = projected(task, samples.position, mesh_fit_tuning.mesh_evaluations,
                                             mesh_fit_tuning.on_surface, task.work.part(0.7, 0.9));
    base::Array<double> distance(task.work.memory, samples.position.size());
    std::fill(distance.begin(), distance.end(), std::numeric_limits<double>::infinity());
    if (surface.triangles() > 0) {
        const FaceTree tree = tree_of(task.work, surface);
        distance = distances(task, samples.position.size(),
                             [&](std::int64_t i) { return tree.distance(samples.position[i]); });
    }
    base::Array<double> angle(task.work.memory);
    for (std::int64_t i = 0; i < distance.size(); ++i) {
        const double slope = glm::length(on.gradient[i]);
        if (on.status[i] != surface::ProjectionStatus::converged || !(slope > 0.0)) continue;
        distance[i] = std::min(distance[i], glm::distance(on.position[i], samples.position[i]));
        if (distance[i] > far) continue;
        const double cosine = glm::dot(on.gradient[i], samples.normal[i]) / slope;
        angle.push_back(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
    }
    result.mesh = statistics_of(distance, result.tolerance, far);
    const DistanceStatistics normals = statistics_of(angle, 180.0, 180.0);
    result.normal_mean = normals.mean;
    result.normal_p99 = normals.p99;
}

} // namespace

geometry::Bounds search_region(const Mesh& mesh) noexcept {
    return mesh.bounds.grown(surface::region_margin * mesh.bounds.diagonal());
}

DistanceStatistics statistics_of(base::Array<double>& distance, double tolerance, double far) {
    DistanceStatistics spread;
    spread.points = distance.size();
    if (distance.empty()) return spread;
    const auto count = static_cast<double>(distance.size());
    double sum = 0.0;
    std::int64_t within = 0;
    std::int64_t beyond = 0;
    spread.most = 0.0;
    for (const double d : distance) {
        sum += d;
        within += d <= tolerance ? 1 : 0;
        beyond += d > far ? 1 : 0;
        spread.most = std::max(spread.most, d);
    }
    spread.mean = sum / count;
    spread.share = static_cast<double>(within) / count;
    spread.beyond = static_cast<double>(beyond) / count;
    double* const at = distance.begin() + std::min(distance.size() - 1, distance.size() * 99 / 100);
    std::nth_element(distance.begin(), at, distance.end());
    spread.p99 = *at;
    return spread;
}

curves::SurfaceMesh find_surface(const base::Work& work, const implicit::Implicit& implicit,
                                 const geometry::VecArray& seeds, const SurfaceSearch& search) {
    HRBFNPR_ASSERT(search.side > 0.0 && !search.region.empty());
    geometry::VecArray all(work.memory);
    all.reserve(seeds.size());
    for (std::int64_t i = 0; i < seeds.size(); ++i) all.push_back(seeds[i]);
    add_lattice({work, implicit, search}, all);
    curves::MeshSettings settings{search.region, search.side};
    settings.tolerance = search.precision;
    curves::SurfaceMesh surface = curves::triangulate_of_any_size(work, implicit, all, settings);
    const double least = implicit.diagonal() / mesh_fit_tuning.most_cells;
    while ((search.finer && too_thin(surface)) || (surface.triangles() == 0 && settings.side > least)) {
        settings.side *= 0.5;
        surface = curves::triangulate(work, implicit, all, settings);
    }
    return surface;
}

void drop_unsupported(const base::Work& work, const SurfaceSearch& search, SurfacePlaces& places) {
    HRBFNPR_ASSERT(places.position.size() == places.gradient.size());
    if (search.support == nullptr) return;
    base::Array<double> beyond(work.memory);
    search.support->evaluate_all(work, places.position, places.gradient, beyond);
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < beyond.size(); ++i) {
        if (!(beyond[i] <= search.limit)) continue;
        places.position.set(kept, places.position[i]);
        places.gradient.set(kept++, places.gradient[i]);
    }
    places.position.resize(kept);
    places.gradient.resize(kept);
}

Comparison compare(const base::Work& work, const implicit::Implicit& implicit, const Mesh& mesh, const FaceTree& tree,
                   const surface::Support* support, const CompareSettings& settings) {
    const base::Stopwatch watch;
    const OuterFaces outer(work, mesh, tree);
    Comparison result;
    result.diagonal = mesh.bounds.diagonal();
    result.tolerance = plan_tolerance(settings.tolerance, result.diagonal);
    const double far = settings.far > 0.0 ? settings.far : default_far * result.diagonal;
    SurfaceSearch search;
    search.region = search_region(mesh);
    search.finer = !(settings.cell_size > 0.0);
    search.side = search.finer ? result.diagonal / cells_a_diagonal : settings.cell_size;
    search.count = settings.points > 0 ? settings.points : default_points;
    search.seed = settings.seed;
    search.support = settings.support > 0.0 ? support : nullptr;
    search.limit = settings.support;

    MeshSamples samples = random_samples(work, mesh, search.count, search.seed, places_of_mesh);
    keep_outer(work, mesh, tree, samples.position, samples.normal);
    curves::SurfaceMesh surface = find_surface(work.part(0.1, 0.3), implicit, samples.position, search);
    SurfaceParts parts = parts_of(work, surface);
    if (search.finer && differ(parts, mesh.report) && surface.triangles() < mesh_fit_tuning.most_to_look_closer) {
        search.side = 0.5 * surface.side;
        surface = find_surface(work.part(0.3, 0.4), implicit, samples.position, search);
        parts = parts_of(work, surface);
    }
    result.components = parts.components;
    result.genus = parts.genus;
    const CompareTask task{work, implicit, search};
    measure_surface(task, mesh, surface, outer, far, result);
    measure_mesh(task, surface, samples, far, result);
    result.seconds = watch.seconds();
    work.update(1.0);
    return result;
}

} // namespace hrbfnpr::mesh
