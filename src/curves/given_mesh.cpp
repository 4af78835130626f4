// SPDX-License-Identifier: MIT
#include "curves/given_mesh.h"

#include "curves/mesh_edges.h"
#include "curves/tuning.h"
#include "surface/project.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// Returns twice the area of a triangle, as a vector along its normal.
glm::dvec3 doubled_area(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::array<glm::dvec3, 3> p = corners_of(mesh, triangle);
    return glm::cross(p[1] - p[0], p[2] - p[0]);
}

// Adds a strip of triangles along each border edge. The strip continues the surface beyond its border.
void add_strips(const base::Work& work, double width, SurfaceMesh& mesh) {
    base::Array<std::int64_t> border(work.memory); // the half-edges of the border
    geometry::VecArray outward(work.memory, mesh.vertices());
    for (const std::int64_t e : work.over(mesh.corner.size())) {
        if (mesh.neighbour[e] >= 0) continue;
        border.push_back(e);
        const std::int32_t a = start_of(mesh, e);
        const std::int32_t b = end_of(mesh, e);
        const glm::dvec3 way = glm::cross(mesh.position[b] - mesh.position[a], doubled_area(mesh, e / 3));
        const double length = glm::length(way);
        if (!(length > 0.0)) continue;
        for (const std::int32_t end : {a, b}) outward.set(end, outward[end] + way / length);
    }
    base::Array<std::int32_t> beyond(work.memory, mesh.vertices()); // for each vertex: 1 + its vertex on the outer side
    const auto outer = [&](std::int32_t vertex) {
        if (beyond[vertex] != 0) return beyond[vertex] - 1;
        const double length = glm::length(outward[vertex]);
        const glm::dvec3 way = length > 0.0 ? outward[vertex] / length : glm::dvec3(0.0);
        mesh.position.push_back(glm::clamp(mesh.position[vertex] + width * way, mesh.region.min, mesh.region.max));
        beyond[vertex] = static_cast<std::int32_t>(mesh.position.size());
        return beyond[vertex] - 1;
    };
    for (const std::int64_t e : border) {
        const std::int32_t a = start_of(mesh, e);
        const std::int32_t b = end_of(mesh, e);
        const std::int32_t outer_a = outer(a);
        const std::int32_t outer_b = outer(b);
        for (const std::int32_t corner : {b, a, outer_a, b, outer_a, outer_b}) mesh.corner.push_back(corner);
    }
    mesh.neighbour = find_neighbours(work, mesh.corner, mesh.position.size());
}

// Moves each vertex into its largest face, so that no vertex of a sharp edge lies on the crease, where the surface has
// several gradients. Vertices of the border stay.
void move_off_creases(const base::Work& work, SurfaceMesh& mesh) {
    base::Array<std::int32_t> largest(work.memory, mesh.position.size()); // 1 + the triangle; -1 at the border
    base::Array<double> area(work.memory, mesh.position.size());
    for (const std::int64_t e : work.over(mesh.corner.size()))
        if (mesh.neighbour[e] < 0) largest[start_of(mesh, e)] = largest[end_of(mesh, e)] = -1;
    for (const std::int64_t e : work.over(mesh.corner.size())) {
        const std::int32_t vertex = start_of(mesh, e);
        const double own = glm::length(doubled_area(mesh, e / 3));
        if (largest[vertex] < 0 || !(own > area[vertex])) continue;
        largest[vertex] = static_cast<std::int32_t>(e / 3 + 1);
        area[vertex] = own;
    }
    geometry::VecArray moved(work.memory, mesh.position.size());
    for (const std::int64_t v : work.over(mesh.position.size())) {
        moved.set(v, mesh.position[v]);
        if (largest[v] <= 0) continue;
        const std::array<glm::dvec3, 3> p = corners_of(mesh, largest[v] - 1);
        moved.set(v, glm::mix(mesh.position[v], (p[0] + p[1] + p[2]) / 3.0, curve_tuning.off_crease));
    }
    mesh.position = std::move(moved);
}

// Moves all vertices onto the surface. Counts those that find none.
void move_onto_surface(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh& mesh) {
    surface::Projection points(work.memory);
    points.position = std::move(mesh.position);
    surface::project(work, implicit, {}, points);
    mesh.unresolved = std::count_if(points.status.begin(), points.status.end(), [](surface::ProjectionStatus s) {
        return s != surface::ProjectionStatus::converged;
    });
    mesh.position = std::move(points.position);
    mesh.gradient = std::move(points.gradient);
}

base::Array<std::int64_t> long_edges(const base::Work& work, const SurfaceMesh& mesh) {
    base::Array<std::int64_t> edges(work.memory);
    for (const std::int64_t e : work.over(mesh.corner.size())) {
        if (!is_first(mesh, e)) continue;
        if (glm::distance(mesh.position[start_of(mesh, e)], mesh.position[end_of(mesh, e)]) > mesh.side)
            edges.push_back(e);
    }
    return edges;
}

} // namespace

SurfaceMesh mesh_of_triangles(const base::Work& work, const implicit::Implicit& implicit, const GivenTriangles& given,
                              const GivenMeshSettings& settings) {
    HRBFNPR_ASSERT(settings.side > 0.0 && settings.strip >= 0.0);
    SurfaceMesh mesh(work.memory);
    mesh.region = settings.region;
    mesh.side = settings.side;
    for (const glm::dvec3& place : given.vertex)
        mesh.position.push_back(glm::clamp(place, mesh.region.min, mesh.region.max));
    for (const std::array<std::int32_t, 3>& corners : given.triangle)
        for (const std::int32_t corner : corners) mesh.corner.push_back(corner);
    mesh.neighbour = find_neighbours(work, mesh.corner, mesh.position.size());
    if (settings.strip > 0.0) add_strips(work, settings.strip, mesh);
    if (implicit.sheets() != nullptr) move_off_creases(work, mesh);
    move_onto_surface(work.part(0.0, 0.5), implicit, mesh);
    // An edge across a gap between two parts of the surface stays long, however often it is halved.
    for (int round = 0; round < curve_tuning.most_halvings && mesh.triangles() < settings.triangle_limit / 2; ++round) {
        const base::Array<std::int64_t> edges = long_edges(work, mesh);
        if (edges.empty() ||
            !halve_edges(work.part(0.5, 0.9), implicit, edges, curve_tuning.farthest_middle, false, mesh))
            break;
    }
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) mesh.turned += is_turned(mesh, t) ? 1 : 0;
    work.update(1.0);
    return mesh;
}

} // namespace hrbfnpr::curves
