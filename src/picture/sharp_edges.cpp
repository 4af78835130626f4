// SPDX-License-Identifier: MIT
#include "picture/sharp_edges.h"

#include "base/assert.h"
#include "picture/faces.h"
#include "picture/tuning_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hrbfnpr::picture {
namespace {

// Returns an index for the position of each point. Points at the same position have the same index. A point with NaN
// has an index that no other point has.
Vector<std::int64_t> places_of_points(const Points& points, Pool& pool) {
    Vector<std::int64_t> order(points.size(), 0, &pool);
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](std::int64_t i, int axis) {
        const double x = points[static_cast<std::size_t>(i)][axis];
        // NaN is replaced, because it would break the sorting order.
        return std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
    };
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        for (int axis = 0; axis < 3; ++axis)
            if (key(a, axis) != key(b, axis)) return key(a, axis) < key(b, axis);
        return a < b;
    });
    Vector<std::int64_t> place(points.size(), 0, &pool);
    std::int64_t count = -1;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto here = static_cast<std::size_t>(order[i]);
        if (i == 0 || points[here] != points[static_cast<std::size_t>(order[i - 1])]) ++count;
        place[here] = count;
    }
    return place;
}

Edge ascending(std::int64_t a, std::int64_t b) noexcept { return a < b ? Edge{a, b} : Edge{b, a}; }

glm::dvec3 unit_or_nan(const glm::dvec3& vector) noexcept { return vector / glm::length(vector); }

} // namespace

Vector<Edge> edges_among(const Points& points, const Vector<Edge>& edges, const Points& of, Pool& pool) {
    Points all(points.begin(), points.end(), &pool);
    all.insert(all.end(), of.begin(), of.end());
    const Vector<std::int64_t> place = places_of_points(all, pool);
    Vector<std::int64_t> number(all.size(), -1, &pool);
    for (std::size_t i = 0; i < points.size(); ++i)
        number[static_cast<std::size_t>(place[i])] = static_cast<std::int64_t>(i);
    const auto named = [&](std::int64_t i) {
        HRBFNPR_ASSERT(i >= 0 && static_cast<std::size_t>(i) < of.size());
        return number[static_cast<std::size_t>(place[points.size() + static_cast<std::size_t>(i)])];
    };
    Vector<Edge> moved(&pool);
    for (const Edge& edge : edges) {
        const Edge here{named(edge[0]), named(edge[1])};
        if (here[0] >= 0 && here[1] >= 0) moved.push_back(here);
    }
    return moved;
}

mesh::EdgesInFile said_of_edges(const Points& points, const Vector<Triangle>& triangles, const Vector<Edge>& sharp,
                                Pool& pool) {
    const Vector<std::int64_t> place = places_of_points(points, pool);
    const auto place_of = [&](std::int64_t i) {
        HRBFNPR_ASSERT(i >= 0 && static_cast<std::size_t>(i) < points.size());
        return place[static_cast<std::size_t>(i)];
    };
    Vector<Triangle> joined(&pool);
    Points normal(&pool);
    for (const Triangle& face : triangles) {
        joined.push_back({place_of(face[0]), place_of(face[1]), place_of(face[2])});
        normal.push_back(unit_or_nan(doubled_area_of(points, face)));
    }
    Vector<Edge> said(&pool);
    for (const Edge& edge : sharp) said.push_back(ascending(place_of(edge[0]), place_of(edge[1])));
    std::sort(said.begin(), said.end());
    const FaceEdges edges = find_edges(joined, points.size(), pool);
    const double flat = std::cos(sharp_edges_tuning.bend_angle * (std::numbers::pi / 180.0));
    std::int64_t bends = 0;
    std::int64_t are_sharp = 0;
    for (const PlainEdge& plain : plain_edges(edges, pool)) {
        const Edge& ends = edges.ends[plain.edge];
        if (ends[0] == ends[1] || !(glm::dot(normal[plain.one], normal[plain.other]) < flat)) continue;
        ++bends;
        if (std::binary_search(said.begin(), said.end(), ends)) ++are_sharp;
    }
    return mesh::plan_edges_of_file(bends, are_sharp);
}

} // namespace hrbfnpr::picture
