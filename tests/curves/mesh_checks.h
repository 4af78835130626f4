// SPDX-License-Identifier: MIT
// Measures of a mesh.
#pragma once

#include "curves/surface_mesh.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace hrbfnpr::curves::test_checks {

struct Measures {
    double area = 0.0;
    double volume = 0.0;          // by the divergence theorem
    std::int64_t euler = 0;       // V - E + F; edges are counted without the neighbour table
    std::int64_t border = 0;      // edges with one triangle
    std::int64_t turned = 0;      // triangles that face away from the mean of their gradients
    std::int64_t bad_edges = 0;   // edges with more than two triangles, or with the same direction in two triangles
    std::int64_t bad_across = 0;  // neighbours that do not share the edge, or do not refer to each other
    std::int64_t unused = 0;      // vertices that belong to no triangle
    double off = 0.0;             // the largest |f| / |grad f|
    double gradient_off = 0.0;    // the largest difference of a stored gradient
    double smallest_area = 1e300; // the smallest area of a triangle
};

inline glm::dvec3 corner(const SurfaceMesh& mesh, std::int64_t t, std::int64_t k) {
    return mesh.position[mesh.corner[3 * t + k % 3]];
}

inline bool across(const SurfaceMesh& mesh, std::int64_t t, std::int64_t k) {
    const std::int64_t other = mesh.neighbour[3 * t + k];
    const std::int32_t a = mesh.corner[3 * t + k];
    const std::int32_t b = mesh.corner[3 * t + (k + 1) % 3];
    for (std::int64_t m = 0; m < 3; ++m)
        if (mesh.corner[3 * other + m] == b && mesh.corner[3 * other + (m + 1) % 3] == a)
            return mesh.neighbour[3 * other + m] == t;
    return false;
}

inline void measure_edges(const SurfaceMesh& mesh, Measures& found) {
    std::map<std::pair<std::int32_t, std::int32_t>, int> directed;
    std::set<std::int32_t> used;
    for (std::int64_t t = 0; t < mesh.triangles(); ++t)
        for (std::int64_t k = 0; k < 3; ++k) {
            const std::int32_t a = mesh.corner[3 * t + k];
            const std::int32_t b = mesh.corner[3 * t + (k + 1) % 3];
            used.insert(a);
            if (++directed[{a, b}] > 1 || a == b) ++found.bad_edges;
            const bool none = mesh.neighbour[3 * t + k] < 0;
            if (!none && !across(mesh, t, k)) ++found.bad_across;
        }
    std::int64_t edges = 0;
    for (const auto& [edge, count] : directed) {
        const bool twice = directed.count({edge.second, edge.first}) != 0;
        if (!twice) ++found.border;
        if (!twice || edge.first < edge.second) ++edges;
    }
    const std::int64_t without = std::count(mesh.neighbour.begin(), mesh.neighbour.end(), -1);
    if (without != found.border) found.bad_across += std::abs(without - found.border);
    found.unused = mesh.vertices() - static_cast<std::int64_t>(used.size());
    found.euler = mesh.vertices() - edges + mesh.triangles();
}

inline Measures measure(const SurfaceMesh& mesh, const implicit::Implicit& implicit) {
    Measures found;
    measure_edges(mesh, found);
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        const glm::dvec3 a = corner(mesh, t, 0);
        const glm::dvec3 twice = glm::cross(corner(mesh, t, 1) - a, corner(mesh, t, 2) - a);
        glm::dvec3 mean(0.0);
        for (std::int64_t k = 0; k < 3; ++k) mean += glm::normalize(mesh.gradient[mesh.corner[3 * t + k]]);
        if (!(glm::dot(twice, mean) > 0.0)) ++found.turned;
        found.area += 0.5 * glm::length(twice);
        found.smallest_area = std::min(found.smallest_area, 0.5 * glm::length(twice));
        found.volume += glm::dot(a, twice) / 6.0;
    }
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) {
        const glm::dvec3 p = mesh.position[i];
        double f = 0.0;
        glm::dvec3 g(0.0);
        implicit.evaluate({&p.x, &p.y, &p.z, 1}, {&f, {&g.x, &g.y, &g.z}, {}});
        found.off = std::max(found.off, std::abs(f) / glm::length(g));
        found.gradient_off = std::max(found.gradient_off, glm::distance(g, mesh.gradient[i]));
    }
    return found;
}

} // namespace hrbfnpr::curves::test_checks
