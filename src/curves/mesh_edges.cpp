// SPDX-License-Identifier: MIT
#include "curves/mesh_edges.h"

#include "base/long_array.h"
#include "curves/tuning.h"
#include "geometry/long_vec_array.h"
#include "surface/project.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace hrbfnpr::curves {
namespace {

struct CutEdge {
    std::int32_t kept, lost; // indices of the vertices at the ends of the edge

    [[nodiscard]] auto operator<=>(const CutEdge&) const noexcept = default;
};

// Divides each triangle into one to four triangles. middle[e] is the index of the vertex in the middle of half-edge e.
// It is the same for both half-edges of an edge, and below 0 if the edge has no such vertex.
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
            // Edges k and k + 1 have a middle, so corner k + 1 is cut off. The remaining quadrilateral is divided along
            // its shorter diagonal.
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

constexpr std::int64_t triangles_a_sum = 8192;

// Returns the sum of of(t) over all triangles t. It is added up in the same order for any number of threads.
template <class T, class Of>
T sum_over_triangles(const base::Work& work, const SurfaceMesh& mesh, const Of& of) {
    base::Array<T> sums(work.memory, (mesh.triangles() + triangles_a_sum - 1) / triangles_a_sum);
    work.for_chunks(mesh.triangles(), triangles_a_sum, [&](std::int64_t begin, std::int64_t end) {
        T sum{};
        for (std::int64_t t = begin; t < end; ++t) sum += of(t);
        sums[begin / triangles_a_sum] = sum;
    });
    return std::accumulate(sums.begin(), sums.end(), T{});
}

double area_of(const base::Work& work, const SurfaceMesh& mesh) {
    return sum_over_triangles<double>(work, mesh, [&](std::int64_t t) {
        const std::array<glm::dvec3, 3> p = corners_of(mesh, t);
        return 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    });
}

// Returns the edges where g changes its sign, in ascending order. `value` has at least the sign of g at each vertex,
// and gets its value at the ends of these edges.
base::Array<CutEdge> find_cut_edges(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                                    base::Array<double>& value) {
    base::Array<CutEdge> edges(work.memory);
    for (const std::int64_t e : work.over(mesh.corner.size())) {
        const std::int32_t a = start_of(mesh, e);
        const std::int32_t b = end_of(mesh, e);
        const bool keeps_a = value[a] <= 0.0;
        if (keeps_a != (value[b] <= 0.0)) edges.push_back(keeps_a ? CutEdge{a, b} : CutEdge{b, a});
    }
    std::sort(edges.begin(), edges.end());
    edges.resize(std::unique(edges.begin(), edges.end()) - edges.begin());
    base::Array<std::int32_t> ends(work.memory);
    for (const CutEdge& edge : edges)
        for (const std::int32_t vertex : {edge.kept, edge.lost}) ends.push_back(vertex);
    std::sort(ends.begin(), ends.end());
    ends.resize(std::unique(ends.begin(), ends.end()) - ends.begin());
    SurfaceMesh only_ends(work.memory);
    for (const std::int32_t vertex : ends) {
        only_ends.position.push_back(mesh.position[vertex]);
        only_ends.gradient.push_back(mesh.gradient[vertex]);
    }
    base::Array<double> exact(work.memory);
    level.at_vertices(work, only_ends, exact);
    for (std::int64_t i = 0; i < ends.size(); ++i) value[ends[i]] = exact[i];
    return edges;
}

// Finds the zero of g on each edge by Newton's method, starting from linear interpolation. Where Newton's method fails,
// it bisects.
base::Array<CurvePoint> find_cut_points(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                                        const base::Array<double>& value, const base::Array<CutEdge>& edges) {
    const double tolerance = curve_tuning.exact * mesh.side;
    base::Array<CurvePoint> points(work.memory, edges.size());
    for (std::int64_t i = 0; i < edges.size(); ++i) {
        const auto [kept, lost] = edges[i];
        const double share = value[kept] / (value[kept] - value[lost]);
        points[i].position = glm::mix(mesh.position[kept], mesh.position[lost], share);
    }
    base::Array<std::uint8_t> found(work.memory);
    bring_to_curve(work, level, {tolerance, curve_tuning.farthest_cut * mesh.side}, points, found);
    base::Array<Bracket> places(work.memory);
    base::Array<std::int64_t> which(work.memory);
    for (std::int64_t i = 0; i < edges.size(); ++i) {
        if (found[i] != 0) continue;
        places.push_back({mesh.position[edges[i].kept], mesh.position[edges[i].lost]});
        which.push_back(i);
    }
    base::Array<CurvePoint> halved(work.memory);
    bisect(work, level, places, curve_tuning.cut_halvings, halved);
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

base::Array<std::int32_t> find_neighbours(const base::Work& work, const base::Array<std::int32_t>& corner,
                                          std::int64_t vertices) {
    HRBFNPR_ASSERT(corner.size() % 3 == 0);
    // Lists for each vertex the half-edges that start there. Half-edge e = 3 t + k goes from corner k of triangle t to
    // the next corner.
    base::Array<std::int64_t> begin(work.memory);
    base::resize_long(begin, vertices + 2, work);
    for (const std::int64_t e : work.over(corner.size())) {
        ++begin[corner[e] + 2];
    }
    for (std::int64_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    work.check();
    base::Array<std::int64_t> edge(work.memory);
    base::resize_long(edge, corner.size(), work);
    for (const std::int64_t e : work.over(corner.size())) {
        edge[begin[corner[e] + 1]++] = e;
    }
    base::Array<std::int32_t> neighbour(work.memory);
    neighbour.resize_for_overwrite(corner.size());
    work.for_chunks(corner.size(), 8192, [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t e = first; e < end; ++e) {
            const std::int32_t to = corner[next_in_triangle(e)];
            neighbour[e] = -1;
            for (std::int64_t i = begin[to]; i < begin[to + 1]; ++i)
                if (corner[next_in_triangle(edge[i])] == corner[e])
                    neighbour[e] = static_cast<std::int32_t>(edge[i] / 3);
        }
    });
    return neighbour;
}

bool halve_edges(const base::Work& work, const implicit::Implicit& implicit, const base::Array<std::int64_t>& edges,
                 double farthest, bool smooth, SurfaceMesh& mesh) {
    const auto between = [&](std::int64_t e) {
        HRBFNPR_ASSERT(e >= 0 && e < mesh.corner.size());
        return 0.5 * (mesh.position[start_of(mesh, e)] + mesh.position[end_of(mesh, e)]);
    };
    surface::Projection at(work.memory);
    for (const std::int64_t e : edges) at.position.push_back(between(e));
    surface::project(work, implicit, {}, at);
    base::Array<std::int32_t> middle(work.memory);
    middle.resize_for_overwrite(mesh.corner.size());
    std::fill(middle.begin(), middle.end(), -1);
    const std::int64_t before = mesh.vertices();
    for (const std::int64_t i : work.over(edges.size())) {
        const std::int64_t e = edges[i];
        const double length = glm::distance(mesh.position[start_of(mesh, e)], mesh.position[end_of(mesh, e)]);
        const auto agrees = [&](std::int32_t end) { return glm::dot(at.gradient[i], mesh.gradient[end]) > 0.0; };
        if (at.status[i] != surface::ProjectionStatus::converged ||
            !(glm::distance(at.position[i], between(e)) < farthest * length) ||
            (smooth && !(agrees(start_of(mesh, e)) && agrees(end_of(mesh, e)))))
            continue;
        middle[e] = static_cast<std::int32_t>(mesh.vertices());
        if (const std::int64_t other = opposite_of(mesh, e); other >= 0) middle[other] = middle[e];
        geometry::push_back_long(mesh.position, at.position[i], work);
        geometry::push_back_long(mesh.gradient, at.gradient[i], work);
    }
    if (mesh.vertices() == before) return false;
    cut_at_middles(work, middle, mesh);
    return true;
}

ClippedMesh clip(const base::Work& work, const Level& level, const SurfaceMesh& mesh) {
    base::Array<double> value(work.memory);
    level.signs_at_vertices(work, mesh, value);
    HRBFNPR_ASSERT(value.size() == mesh.vertices());
    const base::Array<CutEdge> edges = find_cut_edges(work, level, mesh, value);
    const auto keeps = [&](std::int32_t vertex) { return value[vertex] <= 0.0; };

    ClippedMesh clipped(work.memory);
    SurfaceMesh& to = clipped.mesh;
    to.region = mesh.region;
    to.side = mesh.side;
    to.unresolved = mesh.unresolved;
    to.missed_seeds = mesh.missed_seeds;
    base::Array<std::int32_t> number(work.memory, mesh.vertices()); // for each vertex that is kept: its new index
    for (std::int32_t v = 0; v < mesh.vertices(); ++v) {
        if (!keeps(v)) continue;
        number[v] = static_cast<std::int32_t>(to.vertices());
        to.position.push_back(mesh.position[v]);
        to.gradient.push_back(mesh.gradient[v]);
    }
    clipped.first_cut = to.vertices();

    clipped.cut = find_cut_points(work, level, mesh, value, edges);
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
            put(number[v[0]], number[v[1]], number[v[2]]);
            continue;
        }
        int odd = 0; // the corner that differs from the other two: it alone is kept, or it alone is lost
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
    to.neighbour = find_neighbours(work, to.corner, to.vertices());
    to.turned = sum_over_triangles<std::int64_t>(work, mesh, [&](std::int64_t t) {
        const std::int32_t* const v = mesh.corner.data() + 3 * t;
        return keeps(v[0]) && keeps(v[1]) && keeps(v[2]) && is_turned(mesh, t) ? 1 : 0;
    });
    const double before = area_of(work, mesh);
    clipped.left_out = before > 0.0 ? std::max(0.0, 1.0 - area_of(work, to) / before) : 0.0;
    return clipped;
}

Chains<EdgeCrossing> find_edge_crossings(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                         const base::Array<double>& level) {
    constexpr std::int64_t triangles_a_task = 8192;
    HRBFNPR_ASSERT(level.size() == mesh.vertices());
    base::Array<std::uint8_t> crossed(runtime.memory, mesh.triangles());
    runtime.parallel.for_chunks(mesh.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) {
            const std::int32_t* const corner = mesh.corner.data() + 3 * t;
            const bool a = level[corner[0]] < 0.0;
            const bool b = level[corner[1]] < 0.0;
            const bool c = level[corner[2]] < 0.0;
            if (a == b && b == c) continue; // Nearly all triangles end here.
            crossed[t] = static_cast<std::uint8_t>((a != b ? 1 : 0) | (b != c ? 2 : 0) | (c != a ? 4 : 0));
        }
    });
    // A walk enters a triangle through an edge whose start is negative, so that negative g is to its left.
    const auto enters = [&](std::int64_t edge) { return level[start_of(mesh, edge)] < 0.0; };
    Chains<std::int64_t> edges = walk_chains(mesh, crossed, enters);
    Chains<EdgeCrossing> chains(runtime.memory);
    chains.point.resize(edges.point.size());
    runtime.parallel.for_chunks(edges.count(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            EdgeCrossing* const crossing = chains.point.data() + edges.first[c];
            const std::int64_t count = edges.size_of(c);
            for (std::int64_t i = 0; i < count; ++i) {
                const std::int64_t edge = edges.point[edges.first[c] + i];
                const auto [a, b] = enters(edge) ? std::pair(start_of(mesh, edge), end_of(mesh, edge))
                                                 : std::pair(end_of(mesh, edge), start_of(mesh, edge));
                const double drop = level[b] - level[a];
                const Bracket places{mesh.position[a], mesh.position[b]};
                const double share = drop > 0.0 ? -level[a] / drop : 0.5;
                crossing[i] = {a, b, places, places.negative + share * (places.positive - places.negative),
                               glm::dvec3(0.0)};
            }
            const bool closed = edges.closed[c] != 0;
            for (std::int64_t i = 0; i < count; ++i) {
                const std::int64_t before = i > 0 ? i - 1 : closed ? count - 1 : 0;
                const std::int64_t after = i + 1 < count ? i + 1 : closed ? 0 : count - 1;
                crossing[i].way = crossing[after].place - crossing[before].place;
            }
        }
    });
    chains.first = std::move(edges.first);
    chains.closed = std::move(edges.closed);
    return chains;
}

} // namespace hrbfnpr::curves
