// SPDX-License-Identifier: MIT
#include "curves/clip_mesh.h"

#include "curves/mesh_topology.h"
#include "curves/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

struct CutEdge {
    std::int32_t kept, lost; // vertices

    [[nodiscard]] auto operator<=>(const CutEdge&) const noexcept = default;
};

double area_of(const SurfaceMesh& mesh) noexcept {
    double sum = 0.0;
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        const std::array<glm::dvec3, 3> p = corners_of(mesh, t);
        sum += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    }
    return sum;
}

// The place where g is 0 on each of the edges, by Newton's steps from where it is 0 by its values at the ends; where
// these fail, from where halving leads.
base::Array<CurvePoint> find_cut_points(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                                        const base::Array<double>& value, const base::Array<CutEdge>& edges,
                                        const base::Progress& progress) {
    const double tolerance = curve_tuning.exact * mesh.side;
    base::Array<CurvePoint> points(runtime.memory, edges.size());
    for (std::int64_t i = 0; i < edges.size(); ++i) {
        const auto [kept, lost] = edges[i];
        const double share = value[kept] / (value[kept] - value[lost]);
        points[i].position = glm::mix(mesh.position[kept], mesh.position[lost], share);
    }
    base::Array<std::uint8_t> found(runtime.memory);
    bring_to_curve(runtime, level, {tolerance, curve_tuning.farthest_cut * mesh.side}, points, found, progress);
    base::Array<Straddle> places(runtime.memory);
    base::Array<std::int64_t> which(runtime.memory);
    for (std::int64_t i = 0; i < edges.size(); ++i) {
        if (found[i] != 0) continue;
        places.push_back({mesh.position[edges[i].kept], mesh.position[edges[i].lost]});
        which.push_back(i);
    }
    base::Array<CurvePoint> halved(runtime.memory);
    halve(runtime, level, places, curve_tuning.cut_halvings, halved, progress);
    for (std::int64_t i = 0; i < which.size(); ++i) points[which[i]] = halved[i];
    return points;
}

} // namespace

std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    const std::int64_t triangle = mesh.neighbour[edge];
    if (triangle < 0) return -1;
    for (std::int64_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
        if (start_of(mesh, e) == end_of(mesh, edge) && end_of(mesh, e) == start_of(mesh, edge)) return e;
    return -1;
}

void cut_at_middles(const base::Runtime& runtime, const base::Array<std::int32_t>& middle, SurfaceMesh& mesh) {
    HRBFNPR_ASSERT(middle.size() == mesh.corner.size());
    base::Array<std::int32_t> corner(runtime.memory);
    corner.reserve(mesh.corner.size());
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        const auto at = [&](int k) { return mesh.corner[3 * t + k % 3]; };
        const auto cut = [&](int k) { return middle[3 * t + k % 3]; };
        const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
            for (const std::int32_t v : {a, b, c}) corner.push_back(v);
        };
        const int cuts = (cut(0) >= 0 ? 1 : 0) + (cut(1) >= 0 ? 1 : 0) + (cut(2) >= 0 ? 1 : 0);
        int k = 0;
        if (cuts == 0) {
            add(at(0), at(1), at(2));
        } else if (cuts == 1) {
            while (cut(k) < 0) ++k;
            add(at(k), cut(k), at(k + 2));
            add(cut(k), at(k + 1), at(k + 2));
        } else if (cuts == 2) {
            // Edges k and k + 1 are cut, and their corner k + 1 is cut off. The shorter diagonal divides the rest.
            while (cut(k + 2) >= 0) ++k;
            add(cut(k), at(k + 1), cut(k + 1));
            const bool first = glm::distance(mesh.position[cut(k)], mesh.position[at(k + 2)]) <
                               glm::distance(mesh.position[at(k)], mesh.position[cut(k + 1)]);
            if (first)
                add(cut(k), cut(k + 1), at(k + 2));
            else
                add(at(k), cut(k), cut(k + 1));
            add(at(k), first ? cut(k) : cut(k + 1), at(k + 2));
        } else {
            for (k = 0; k < 3; ++k) add(at(k), cut(k), cut(k + 2));
            add(cut(0), cut(1), cut(2));
        }
    }
    mesh.corner = std::move(corner);
    mesh.neighbour = find_neighbours(runtime, mesh.corner, mesh.vertices());
}

ClippedMesh clip(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                 const base::Progress& progress) {
    base::Array<double> value(runtime.memory);
    level.at_vertices(runtime, mesh, value, progress);
    HRBFNPR_ASSERT(value.size() == mesh.vertices());
    const auto keeps = [&](std::int32_t vertex) { return value[vertex] <= 0.0; };

    ClippedMesh clipped(runtime.memory);
    SurfaceMesh& to = clipped.mesh;
    to.region = mesh.region;
    to.side = mesh.side;
    to.unresolved = mesh.unresolved;
    to.missed_seeds = mesh.missed_seeds;
    base::Array<std::int32_t> number(runtime.memory, mesh.vertices()); // the new numbers of the vertices that are kept
    for (std::int32_t v = 0; v < mesh.vertices(); ++v) {
        if (!keeps(v)) continue;
        number[v] = static_cast<std::int32_t>(to.vertices());
        to.position.push_back(mesh.position[v]);
        to.gradient.push_back(mesh.gradient[v]);
    }
    clipped.first_cut = to.vertices();

    base::Array<CutEdge> edges(runtime.memory);
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e) {
        const std::int32_t a = start_of(mesh, e);
        const std::int32_t b = end_of(mesh, e);
        if (keeps(a) != keeps(b)) edges.push_back(keeps(a) ? CutEdge{a, b} : CutEdge{b, a});
    }
    std::sort(edges.begin(), edges.end());
    edges.resize(std::unique(edges.begin(), edges.end()) - edges.begin());
    clipped.cut = find_cut_points(runtime, level, mesh, value, edges, progress);
    for (const CurvePoint& p : clipped.cut) {
        to.position.push_back(p.position);
        to.gradient.push_back(p.gradient);
    }

    const auto cut_of = [&](std::int32_t kept, std::int32_t lost) {
        const CutEdge* const at = std::lower_bound(edges.begin(), edges.end(), CutEdge{kept, lost});
        return static_cast<std::int32_t>(clipped.first_cut + (at - edges.begin()));
    };
    const auto put = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        for (const std::int32_t v : {a, b, c}) to.corner.push_back(v);
    };
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        const std::int32_t* const v = mesh.corner.data() + 3 * t;
        const int kept = static_cast<int>(keeps(v[0])) + static_cast<int>(keeps(v[1])) + static_cast<int>(keeps(v[2]));
        if (kept == 0) continue;
        if (kept == 3) {
            to.turned += is_turned(mesh, t) ? 1 : 0;
            put(number[v[0]], number[v[1]], number[v[2]]);
            continue;
        }
        int odd = 0; // the corner that stands alone
        while (keeps(v[odd]) != (kept == 1)) ++odd;
        const std::int32_t a = v[odd];
        const std::int32_t b = v[(odd + 1) % 3];
        const std::int32_t c = v[(odd + 2) % 3];
        if (kept == 1) {
            put(number[a], cut_of(a, b), cut_of(a, c));
            continue;
        }
        put(number[b], number[c], cut_of(c, a));
        put(number[b], cut_of(c, a), cut_of(b, a));
    }
    to.neighbour = find_neighbours(runtime, to.corner, to.vertices());
    const double before = area_of(mesh);
    clipped.left_out = before > 0.0 ? std::max(0.0, 1.0 - area_of(to) / before) : 0.0;
    return clipped;
}

} // namespace hrbfnpr::curves
