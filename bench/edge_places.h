// SPDX-License-Identifier: MIT
// Places on the edges of a mesh, for measuring how sharp a model has them.
#pragma once

#include "brute_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace bench {

struct EdgePlace {
    BruteMesh::Point place;
    BruteMesh::Point out; // unit: in the middle between the normals of both sides
    // Its edge, an arc about the z axis where the radius is not 0.
    BruteMesh::Point from, to;
    double radius = 0.0;
    double angle = 0.0; // between the faces, degrees
};

// From the nearest of the places' edges that bend by so many degrees; the second place of each edge is passed over.
inline double distance_to_edges(const std::vector<EdgePlace>& places, double least_angle, const BruteMesh::Point& p) {
    double least = 1e300;
    for (std::size_t i = 0; i < places.size(); i += 2) {
        const EdgePlace& e = places[i];
        if (e.angle < least_angle) continue;
        const BruteMesh::Point along = BruteMesh::less(e.to, e.from);
        const double share = BruteMesh::dot(BruteMesh::less(p, e.from), along) / BruteMesh::dot(along, along);
        BruteMesh::Point foot;
        for (std::size_t c = 0; c < 3; ++c) foot[c] = e.from[c] + std::clamp(share, 0.0, 1.0) * along[c];
        if (e.radius > 0.0) {
            const double by = e.radius / std::hypot(foot[0], foot[1]);
            foot[0] *= by;
            foot[1] *= by;
        }
        least = std::min(least, BruteMesh::length(BruteMesh::less(p, foot)));
    }
    return least;
}

// Edges that bend by more than some degrees, at their ends and in between; those about the z axis whose radius is one
// of these are arcs.
inline std::vector<EdgePlace> edge_places(const hrbfnpr::test::Triangles& mesh, const std::vector<double>& round,
                                          double least_angle = 30.0) {
    constexpr double degree = 0.017453292519943295;
    using Point = BruteMesh::Point;
    // Vertices may be in the same place.
    std::map<Point, std::size_t> known;
    std::vector<Point> vertex;
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        const Point p{mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]};
        const auto [found, added] = known.try_emplace(p, vertex.size());
        if (added) vertex.push_back(p);
        of.push_back(found->second);
    }
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Point>> normals;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        std::size_t v[3];
        for (std::size_t k = 0; k < 3; ++k) v[k] = of[static_cast<std::size_t>(mesh.triangles[i + k])];
        Point n =
            BruteMesh::cross(BruteMesh::less(vertex[v[1]], vertex[v[0]]), BruteMesh::less(vertex[v[2]], vertex[v[0]]));
        const double size = BruteMesh::length(n);
        if (!(size > 0.0)) continue;
        for (double& c : n) c /= size;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = v[k], b = v[(k + 1) % 3];
            normals[{std::min(a, b), std::max(a, b)}].push_back(n);
        }
    }
    std::vector<EdgePlace> places;
    for (const auto& [edge, n] : normals) {
        if (n.size() != 2 || BruteMesh::dot(n[0], n[1]) > std::cos(least_angle * degree)) continue;
        const Point& a = vertex[edge.first];
        const Point& b = vertex[edge.second];
        Point out{n[0][0] + n[1][0], n[0][1] + n[1][1], n[0][2] + n[1][2]};
        const double size = BruteMesh::length(out);
        for (double& c : out) c /= size;
        const double angle = std::acos(std::clamp(BruteMesh::dot(n[0], n[1]), -1.0, 1.0)) / degree;
        for (const double t : {0.1, 0.5}) {
            Point p;
            double arc = 0.0;
            for (std::size_t c = 0; c < 3; ++c) p[c] = a[c] + t * (b[c] - a[c]);
            for (const double radius : round) {
                if (std::abs(std::hypot(a[0], a[1]) - radius) > 1e-9 ||
                    std::abs(std::hypot(b[0], b[1]) - radius) > 1e-9 || std::abs(a[2] - b[2]) > 1e-9)
                    continue;
                const double by = radius / std::hypot(p[0], p[1]);
                p[0] *= by;
                p[1] *= by;
                arc = radius;
                break;
            }
            places.push_back({p, out, a, b, arc, angle});
        }
    }
    return places;
}

} // namespace bench
