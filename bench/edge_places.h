// SPDX-License-Identifier: MIT
// Places on the edges of a mesh, for measuring how sharply a model reproduces them.
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
    BruteMesh::Point out; // unit: halfway between the normals of both sides
    // The ends of the edge. If `radius` is not 0, the edge is an arc about the z axis.
    BruteMesh::Point from, to;
    BruteMesh::Point from_tangent{}, to_tangent{}; // unit, of the smooth curve through the ends; 0: straight
    double radius = 0.0;
    double angle = 0.0; // between the normals of its faces, degrees
};

// Returns the place of the segment that is nearest to p.
inline BruteMesh::Point foot_on(const BruteMesh::Point& from, const BruteMesh::Point& to, const BruteMesh::Point& p) {
    const BruteMesh::Point along = BruteMesh::less(to, from);
    const double share = BruteMesh::dot(BruteMesh::less(p, from), along) / BruteMesh::dot(along, along);
    BruteMesh::Point foot;
    for (std::size_t c = 0; c < 3; ++c) foot[c] = from[c] + std::clamp(share, 0.0, 1.0) * along[c];
    return foot;
}

// Returns a place on an edge's smooth curve: a cubic whose handles fit an arc; their length is the chord over cos^2 of
// a quarter of its angle.
inline BruteMesh::Point on_smooth_edge(const EdgePlace& e, double t) {
    const BruteMesh::Point chord = BruteMesh::less(e.to, e.from);
    const double size = BruteMesh::length(chord);
    const auto handle = [&](const BruteMesh::Point& tangent) {
        const double straight = BruteMesh::length(tangent) > 0.0 ? BruteMesh::dot(tangent, chord) / size : 1.0;
        return size * 2.0 / (1.0 + straight);
    };
    const double a = handle(e.from_tangent);
    const double b = handle(e.to_tangent);
    const double s = 1.0 - t;
    BruteMesh::Point p;
    for (std::size_t c = 0; c < 3; ++c)
        p[c] = s * s * (1.0 + 2.0 * t) * e.from[c] + t * t * (1.0 + 2.0 * s) * e.to[c] +
               s * s * t * a * e.from_tangent[c] - t * t * s * b * e.to_tangent[c];
    return p;
}

inline double distance_to_edge(const EdgePlace& e, const BruteMesh::Point& p) {
    constexpr int parts = 16;
    BruteMesh::Point foot = foot_on(e.from, e.to, p);
    if (e.radius > 0.0) {
        const double by = e.radius / std::hypot(foot[0], foot[1]);
        foot[0] *= by;
        foot[1] *= by;
    }
    double least = BruteMesh::length(BruteMesh::less(p, foot));
    if (e.radius > 0.0 || (BruteMesh::length(e.from_tangent) == 0.0 && BruteMesh::length(e.to_tangent) == 0.0) ||
        least > BruteMesh::length(BruteMesh::less(e.to, e.from)))
        return least;
    least = 1e300;
    BruteMesh::Point last = e.from;
    for (int k = 1; k <= parts; ++k) {
        const BruteMesh::Point next = on_smooth_edge(e, static_cast<double>(k) / parts);
        least = std::min(least, BruteMesh::length(BruteMesh::less(p, foot_on(last, next, p))));
        last = next;
    }
    return least;
}

// Returns the distance to the nearest edge that bends by at least `least_angle` degrees. Skips the second place of each
// edge.
inline double distance_to_edges(const std::vector<EdgePlace>& places, double least_angle, const BruteMesh::Point& p) {
    double least = 1e300;
    for (std::size_t i = 0; i < places.size(); i += 2)
        if (places[i].angle >= least_angle) least = std::min(least, distance_to_edge(places[i], p));
    return least;
}

// Sets the tangents of edges: a curved edge of the shape is a row of chords in its mesh. Where two chords are the
// straightest continuation of each other at a vertex, and turn by less than 40 degrees, the tangent is that of the
// circle through their three ends. Beside a corner, the edge is an arc that fits its other tangent.
inline void find_tangents(std::vector<EdgePlace>& places) {
    constexpr double corner = 0.766;
    using Point = BruteMesh::Point;
    std::map<Point, std::vector<std::pair<std::size_t, Point>>> at; // edges at a vertex, their vectors from it
    for (std::size_t i = 0; i < places.size(); i += 2) {
        at[places[i].from].emplace_back(i, BruteMesh::less(places[i].to, places[i].from));
        at[places[i].to].emplace_back(i, BruteMesh::less(places[i].from, places[i].to));
    }
    for (const auto& [vertex, ways] : at) {
        const auto straight = [&, &ways = ways](std::size_t i, std::size_t k) {
            const Point& a = ways[i].second;
            const Point& b = ways[k].second;
            return -BruteMesh::dot(a, b) / (BruteMesh::length(a) * BruteMesh::length(b));
        };
        const auto next = [&, &ways = ways](std::size_t i) { // i itself if the edge ends here
            std::size_t best = i;
            for (std::size_t k = 0; k < ways.size(); ++k)
                if (k != i && straight(i, k) > (best == i ? corner : straight(i, best))) best = k;
            return best;
        };
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const std::size_t k = next(i);
            if (k == i || next(k) != i) continue;
            const Point& a = ways[i].second;
            const Point& b = ways[k].second;
            Point out; // the tangent, in the direction of a
            for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] / BruteMesh::dot(a, a) - b[c] / BruteMesh::dot(b, b);
            EdgePlace& e = places[ways[i].first];
            const double size = (e.from == vertex ? 1.0 : -1.0) * BruteMesh::length(out);
            for (std::size_t c = 0; c < 3; ++c) (e.from == vertex ? e.from_tangent : e.to_tangent)[c] = out[c] / size;
        }
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        EdgePlace& e = places[i];
        if (i % 2 == 1) {
            e.from_tangent = places[i - 1].from_tangent;
            e.to_tangent = places[i - 1].to_tangent;
            continue;
        }
        const Point chord = BruteMesh::less(e.to, e.from);
        const auto mirror = [&](const Point& tangent, Point& to) { // mirrors about the chord
            const double along = 2.0 * BruteMesh::dot(tangent, chord) / BruteMesh::dot(chord, chord);
            for (std::size_t c = 0; c < 3; ++c) to[c] = along * chord[c] - tangent[c];
        };
        const bool has_from = BruteMesh::length(e.from_tangent) > 0.0;
        const bool has_to = BruteMesh::length(e.to_tangent) > 0.0;
        if (has_from && !has_to) mirror(e.from_tangent, e.to_tangent);
        if (has_to && !has_from) mirror(e.to_tangent, e.from_tangent);
    }
}

// Returns two places, near an end and in the middle, of each edge that bends by more than `least_angle` degrees. Edges
// about the z axis with a radius from `round` are arcs.
inline std::vector<EdgePlace> edge_places(const hrbfnpr::test::Triangles& mesh, const std::vector<double>& round,
                                          double least_angle = 30.0) {
    constexpr double degree = 0.017453292519943295;
    using Point = BruteMesh::Point;
    // Merge vertices at the same place.
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
            places.push_back({p, out, a, b, {}, {}, arc, angle});
        }
    }
    find_tangents(places);
    return places;
}

} // namespace bench
