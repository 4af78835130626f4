// SPDX-License-Identifier: MIT
// 1. smoothed_mesh spreads the normals and places of the vertices over the mesh, as heat spreads for a given time.
// 2. bends_of computes curvatures at the vertices from how the smoothed normals change along the smoothed mesh.
// 3. crest_values and find_candidates find chains of edges of the mesh on which the curvature is greatest.
// 4. measure_turns walks from each point of a chain to both sides, straight over the mesh, and measures how far its
//    true normals turn.
// 5. add_lines averages strengths and places along the chains, selects strong and long parts, and brings them onto the
//    surface.
#include "features/soft_edges.h"

#include "base/assert.h"
#include "curves/mesh_edges.h"
#include "features/feature_lines.h"
#include "features/tuning.h"
#include "geometry/tangent_frame.h"
#include "surface/curvature.h"
#include "surface/project.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t vertices_a_task = 4096;

// ---- Means over the mesh

// A triangle at a vertex.
struct Corner {
    std::int32_t triangle;
    std::int32_t next, previous; // the other two corners of the triangle
    float weight;                // the share of the triangle's area in the area around the vertex
};

// The triangles around each vertex. Those of vertex v are corner[first[v]] to corner[first[v + 1] - 1].
struct Rings {
    explicit Rings(base::Memory& memory) : first(memory), corner(memory) {}

    base::Array<std::int32_t> first;
    base::Array<Corner> corner;
    double edge = 0.0; // the length of an edge if all triangles were equal
};

Rings rings_of(const base::Work& work, const SurfaceMesh& mesh) {
    Rings rings(work.memory);
    rings.first.resize(mesh.vertices() + 1);
    for (const std::int64_t e : work.over(mesh.corner.size())) ++rings.first[mesh.corner[e] + 1];
    for (std::int64_t v = 0; v < mesh.vertices(); ++v) rings.first[v + 1] += rings.first[v];
    base::Array<std::int32_t> next(work.memory, mesh.vertices());
    std::copy(rings.first.begin(), rings.first.end() - 1, next.begin());
    rings.corner.resize_for_overwrite(mesh.corner.size());
    double sum = 0.0;
    for (const std::int64_t t : work.over(mesh.triangles())) {
        const auto [a, b, c] = corners_of(mesh, t);
        const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
        sum += area;
        for (std::int64_t e = 3 * t; e < 3 * t + 3; ++e) {
            const std::int64_t after = next_in_triangle(e);
            rings.corner[next[mesh.corner[e]]++] = {static_cast<std::int32_t>(t), mesh.corner[after],
                                                    mesh.corner[next_in_triangle(after)], static_cast<float>(area)};
        }
    }
    rings.edge = 2.0 * std::sqrt(sum / (std::sqrt(3.0) * static_cast<double>(mesh.triangles())));
    work.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) {
            float area = 0.0F;
            for (std::int32_t k = rings.first[v]; k < rings.first[v + 1]; ++k) area += rings.corner[k].weight;
            for (std::int32_t k = rings.first[v]; k < rings.first[v + 1]; ++k)
                rings.corner[k].weight = area > 0.0F ? rings.corner[k].weight / area : 0.0F;
        }
    });
    return rings;
}

// Returns for each vertex the mean of a value over the triangles around it, weighted by their areas.
template <class T, class OfTriangle>
base::Array<T> means_at_vertices(const base::Work& work, const SurfaceMesh& mesh, const Rings& rings,
                                 const OfTriangle& of_triangle) {
    base::Array<T> value(work.memory), mean(work.memory);
    value.resize_for_overwrite(mesh.triangles());
    work.for_chunks(value.size(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) value[t] = of_triangle(t);
    });
    mean.resize_for_overwrite(mesh.vertices());
    work.for_chunks(mean.size(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) {
            T sum{};
            for (std::int32_t k = rings.first[v]; k < rings.first[v + 1]; ++k)
                sum += rings.corner[k].weight * value[rings.corner[k].triangle];
            mean[v] = sum;
        }
    });
    return mean;
}

// Returns the mean of a value over the corners of the triangles around a vertex.
template <class T>
T mean_around(const Rings& rings, const base::Array<T>& value, std::int64_t v) noexcept {
    T sum{};
    for (std::int32_t k = rings.first[v]; k < rings.first[v + 1]; ++k) {
        const Corner& c = rings.corner[k];
        sum += c.weight * (value[c.next] + value[c.previous]);
    }
    return (value[v] + sum) * (1.0F / 3.0F);
}

// ---- Smoothing

// A vertex: its normal, and its place in units from the middle of the region.
struct Vertex {
    glm::vec3 normal{0.0F};
    glm::vec3 place{0.0F};

    Vertex& operator+=(const Vertex& other) noexcept {
        normal += other.normal;
        place += other.place;
        return *this;
    }
};
Vertex operator+(Vertex a, const Vertex& b) noexcept { return a += b; }
Vertex operator*(const Vertex& v, float factor) noexcept { return {v.normal * factor, v.place * factor}; }
Vertex operator*(float factor, const Vertex& v) noexcept { return v * factor; }

// Returns the coefficients of Chebyshev's polynomials whose sum is exp(x (y - 1)) for y from -1 to 1, but for an error
// that cannot be seen. They are the modified Bessel functions I_k(x), by Miller's backward recurrence, times 2 exp(-x).
base::Array<double> heat_coefficients(base::Memory& memory, double x) {
    HRBFNPR_ASSERT(x > 0.0);
    const auto count = static_cast<std::int64_t>(std::ceil(3.0 + 2.5 * std::sqrt(x)));
    const std::int64_t start = 2 * count + 10;
    base::Array<double> bessel(memory, start + 2);
    bessel[start] = 1e-200;
    for (std::int64_t k = start; k > 0; --k)
        bessel[k - 1] = bessel[k + 1] + 2.0 * static_cast<double>(k) / x * bessel[k];
    double sum = bessel[0];
    for (std::int64_t k = 1; k < count; ++k) sum += 2.0 * bessel[k];
    base::Array<double> coefficients(memory, count);
    for (std::int64_t k = 0; k < count; ++k) coefficients[k] = (k == 0 ? 1.0 : 2.0) * bessel[k] / sum;
    return coefficients;
}

// Lets normals and places spread as heat does, so that each is averaged over a bell curve of the standard deviation
// `blur`. Normals and places are smoothed alike, so that irregular triangles do not appear in their quotients.
// mean_around() is the operator A, whose eigenvalues are from 0 to 1 and whose variance along an axis is a third of the
// square of an edge. exp(time (A - 1)) is a sum of Chebyshev's polynomials of 2 A - 1, which needs about the square
// root of as many averages as a power of A.
base::Array<Vertex> smoothed_mesh(const base::Work& work, const SurfaceMesh& mesh, const Rings& rings, double blur) {
    const double time = 3.0 * blur * blur / (rings.edge * rings.edge);
    const base::Array<double> coefficient = heat_coefficients(work.memory, 0.5 * time);
    const glm::dvec3 middle = 0.5 * (mesh.region.min + mesh.region.max);
    base::Array<Vertex> last(work.memory), now(work.memory), sum(work.memory);
    for (base::Array<Vertex>* const array : {&last, &now, &sum}) array->resize_for_overwrite(mesh.vertices());
    const auto for_vertices = [&](const auto& f) {
        work.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t v = begin; v < end; ++v) f(v);
        });
    };
    // T_0 = 1 and T_1 = y, where y = 2 A - 1.
    for_vertices([&](std::int64_t v) {
        last[v] = {glm::vec3(glm::normalize(mesh.gradient[v])), glm::vec3((mesh.position[v] - middle) / blur)};
    });
    for_vertices([&](std::int64_t v) {
        now[v] = 2.0F * mean_around(rings, last, v) + -1.0F * last[v];
        sum[v] = static_cast<float>(coefficient[0]) * last[v] + static_cast<float>(coefficient[1]) * now[v];
    });
    for (std::int64_t k = 2; k < coefficient.size(); ++k) {
        work.update(static_cast<double>(k) / static_cast<double>(coefficient.size()));
        const auto factor = static_cast<float>(coefficient[k]);
        for_vertices([&](std::int64_t v) { // T_k = 2 y T_(k - 1) - T_(k - 2)
            last[v] = 4.0F * mean_around(rings, now, v) + -2.0F * now[v] + -1.0F * last[v];
            sum[v] += factor * last[v];
        });
        std::swap(last, now);
    }
    return sum;
}

// ---- Curvature

// The curvatures at a vertex at the scale of the smoothed mesh, in 1 / unit. Signs are those of ShapePoint.
struct Bend {
    glm::vec3 normal{0.0F};
    glm::vec3 d1{0.0F};
    float k1 = 0.0F;
    float k2 = 0.0F;
};

// Returns the gradients of the three barycentric coordinates of a triangle of the smoothed mesh.
std::array<glm::vec3, 3> barycentric_gradients(const base::Array<Vertex>& vertex, const std::int32_t* corner) noexcept {
    const glm::vec3& a = vertex[corner[0]].place;
    const glm::vec3& b = vertex[corner[1]].place;
    const glm::vec3& c = vertex[corner[2]].place;
    const glm::vec3 n = glm::cross(b - a, c - a);
    const float square = glm::dot(n, n);
    if (!(square > 0.0F)) return {};
    return {glm::cross(n, c - b) / square, glm::cross(n, a - c) / square, glm::cross(n, b - a) / square};
}

base::Array<Bend> bends_of(const base::Work& work, const SurfaceMesh& mesh, const Rings& rings,
                           const base::Array<Vertex>& vertex) {
    const auto change_of_normal = [&](std::int64_t t) {
        const std::int32_t* const corner = mesh.corner.data() + 3 * t;
        const std::array<glm::vec3, 3> gradient = barycentric_gradients(vertex, corner);
        glm::mat3 change(0.0F);
        for (std::size_t k = 0; k < 3; ++k)
            change += glm::outerProduct(glm::normalize(vertex[corner[k]].normal), gradient[k]);
        return change;
    };
    const base::Array<glm::mat3> change = means_at_vertices<glm::mat3>(work, mesh, rings, change_of_normal);
    base::Array<Bend> bend(work.memory);
    bend.resize_for_overwrite(mesh.vertices());
    work.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) {
            const glm::dvec3 normal = glm::normalize(glm::dvec3(vertex[v].normal));
            const glm::dmat3 m(mean_around(rings, change, v));
            const geometry::TangentFrame frame = geometry::combing_frame(normal);
            const surface::Eigen2 eigen =
                surface::symmetric_eigen2(-glm::dot(frame.r, m * frame.r),
                                          -0.5 * (glm::dot(frame.u, m * frame.r) + glm::dot(frame.r, m * frame.u)),
                                          -glm::dot(frame.u, m * frame.u));
            bend[v] = {glm::vec3(normal), glm::vec3(eigen.cosine * frame.r + eigen.sine * frame.u),
                       static_cast<float>(eigen.high), static_cast<float>(eigen.low)};
        }
    });
    return bend;
}

// Returns values for find_candidates(). g is the derivative of the curvature across the edge, and the strength is the
// curvature across the edge less the absolute curvature along it, both in 1 / unit.
base::Array<FeatureValue> crest_values(const base::Work& work, const SurfaceMesh& mesh, const Rings& rings,
                                       const base::Array<Vertex>& vertex, const base::Array<Bend>& bend, bool concave) {
    const auto across = [&](std::int64_t v) { return concave ? bend[v].k1 : -bend[v].k2; };
    const base::Array<glm::vec3> slope = means_at_vertices<glm::vec3>(work, mesh, rings, [&](std::int64_t t) {
        const std::int32_t* const corner = mesh.corner.data() + 3 * t;
        const std::array<glm::vec3, 3> gradient = barycentric_gradients(vertex, corner);
        return across(corner[0]) * gradient[0] + across(corner[1]) * gradient[1] + across(corner[2]) * gradient[2];
    });
    base::Array<FeatureValue> value(work.memory);
    value.resize_for_overwrite(mesh.vertices());
    work.for_chunks(mesh.vertices(), vertices_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) {
            const glm::vec3 along = concave ? bend[v].d1 : glm::cross(bend[v].normal, bend[v].d1);
            const float beside = std::abs(concave ? bend[v].k2 : bend[v].k1);
            value[v] = {static_cast<double>(glm::dot(slope[v], along)), static_cast<double>(across(v) - beside), 1.0,
                        glm::dvec3(along), glm::dvec3(0.0)};
        }
    });
    return value;
}

// ---- Turns

// A half-edge with its triangle as a plane.
struct Hinge {
    glm::dvec3 begin, end, tip; // the ends of the edge, and the third corner
    glm::dvec3 along, inward;   // unit vectors along the edge, and across it towards the third corner

    Hinge(const SurfaceMesh& mesh, std::int64_t edge) noexcept
        : begin(mesh.position[start_of(mesh, edge)]), end(mesh.position[end_of(mesh, edge)]),
          tip(mesh.position[end_of(mesh, next_in_triangle(edge))]), along(glm::normalize(end - begin)),
          inward(glm::normalize(tip - begin - glm::dot(tip - begin, along) * along)) {}
};

// The angles by which normals turn along a way: up to the reach, and from there up to twice the reach. They are
// positive where the surface is convex.
struct Turns {
    double near = 0.0;
    double far = 0.0;
};

// Follows a straight line over the mesh. It starts on the half-edge `edge`, at the given share of its length, in the
// direction `way`. The line ends at a border.
Turns turns_along(const SurfaceMesh& mesh, std::int64_t edge, double share, glm::dvec3 way, double reach) noexcept {
    constexpr int most_triangles = 1000;
    Turns turns;
    if (glm::dot(Hinge(mesh, edge).inward, way) < 0.0) {
        edge = opposite_of(mesh, edge);
        share = 1.0 - share;
    }
    const auto normal_on = [&](std::int64_t e, double at) {
        return glm::normalize(glm::mix(glm::normalize(mesh.gradient[start_of(mesh, e)]),
                                       glm::normalize(mesh.gradient[end_of(mesh, e)]), at));
    };
    if (edge < 0) return turns;
    glm::dvec3 normal = normal_on(edge, share);
    double length = 0.0;
    for (int step = 0; step < most_triangles && edge >= 0 && length < 2.0 * reach; ++step) {
        const Hinge hinge(mesh, edge);
        // The triangle is unfolded into the plane of the last one, so that the line stays straight.
        const double cosine = std::clamp(glm::dot(way, hinge.along), -0.999, 0.999);
        way = cosine * hinge.along + std::sqrt(1.0 - cosine * cosine) * hinge.inward;
        const glm::dvec3 up = glm::cross(hinge.along, hinge.inward);
        const glm::dvec3 left = glm::cross(up, way);
        const glm::dvec3 from = glm::mix(hinge.begin, hinge.end, share);
        const double of_tip = glm::dot(left, hinge.tip - from);
        const bool exits_right = of_tip > 0.0; // through the edge from hinge.end to the tip
        const double of_other = glm::dot(left, (exits_right ? hinge.end : hinge.begin) - from);
        const double cut = std::clamp(of_tip / (of_tip - of_other), 0.0, 1.0);
        const glm::dvec3 to = glm::mix(hinge.tip, exits_right ? hinge.end : hinge.begin, cut);
        const std::int64_t next = next_in_triangle(edge);
        const std::int64_t exit = exits_right ? next : next_in_triangle(next);
        const double exit_share = exits_right ? 1.0 - cut : cut;
        const glm::dvec3 turned = normal_on(exit, exit_share);
        const double turn = std::atan2(glm::dot(turned, way), glm::dot(turned, up)) -
                            std::atan2(glm::dot(normal, way), glm::dot(normal, up));
        const double piece = glm::distance(from, to);
        if (!std::isfinite(turn) || !std::isfinite(piece)) return turns; // a triangle without area
        const auto share_before = [&](double end) {
            return length + piece <= end ? 1.0 : length >= end ? 0.0 : (end - length) / piece;
        };
        const double is_near = share_before(reach);
        turns.near += is_near * turn;
        turns.far += (share_before(2.0 * reach) - is_near) * turn;
        length += piece;
        normal = turned;
        edge = opposite_of(mesh, exit);
        share = 1.0 - exit_share;
    }
    return turns;
}

// Returns the strength at each crossing, in degrees. One crossing of several is measured, and its neighbours get
// the same strength, since crossings are much closer together than the reach.
base::Array<double> measure_turns(const base::Work& work, const SurfaceMesh& mesh,
                                  const base::Array<FeatureValue>& value, const Chains<FeatureCrossing>& chains,
                                  bool concave, double reach) {
    base::Array<double> strength(work.memory);
    strength.resize_for_overwrite(chains.point.size());
    const auto strength_at = [&](const FeatureCrossing& c) {
        const glm::dvec3& a = value[c.a].along;
        const glm::dvec3& b = value[c.b].along;
        const glm::dvec3 way = glm::normalize(glm::dot(a, b) < 0.0 ? a - b : a + b);
        const double share = start_of(mesh, c.edge) == c.a ? c.share : 1.0 - c.share;
        const Turns left = turns_along(mesh, c.edge, share, way, reach);
        const Turns right = turns_along(mesh, c.edge, share, -way, reach);
        const double turn = (concave ? -1.0 : 1.0) * (left.near + right.near);
        return (turn - std::abs(left.far) - std::abs(right.far)) * 180.0 / std::numbers::pi;
    };
    work.for_each(chains.count(), [&](std::int64_t c) {
        for (std::int64_t begin = chains.first[c]; begin < chains.first[c + 1];) {
            const std::int64_t end = std::min(begin + feature_tuning.crossings_a_turn, chains.first[c + 1]);
            std::fill(strength.begin() + begin, strength.begin() + end, strength_at(chains.point[(begin + end) / 2]));
            begin = end;
        }
    });
    return strength;
}

// ---- Lines

// A point of a line, `at` a distance along it.
struct EdgePoint {
    glm::dvec3 place{0.0};
    double at = 0.0;
    double strength = 0.0;
};

// Returns the mean of the points within `reach` along the line. Nearer points weigh more.
EdgePoint mean_along(const base::Array<EdgePoint>& line, std::int64_t i, double reach) noexcept {
    EdgePoint mean;
    double sum = 0.0;
    const double at = line[i].at;
    const auto add = [&](const EdgePoint& p) {
        const double weight = 1.0 - std::abs(p.at - at) / reach;
        mean.place += weight * p.place;
        mean.strength += weight * p.strength;
        sum += weight;
    };
    add(line[i]);
    for (std::int64_t k = i - 1; k >= 0 && at - line[k].at < reach; --k) add(line[k]);
    for (std::int64_t k = i + 1; k < line.size() && line[k].at - at < reach; ++k) add(line[k]);
    return {mean.place / sum, at, mean.strength / sum};
}

// Returns the points of a chain, averaged along it. A closed chain is continued on both sides by copies of itself.
base::Array<EdgePoint> averaged_chain(const Chains<EdgePoint>& chains, std::int64_t chain, double reach) {
    base::Array<EdgePoint> line(chains.point.memory()), mean(chains.point.memory());
    const std::int64_t count = chains.size_of(chain);
    const int copies = chains.closed[chain] != 0 ? 3 : 1;
    for (int copy = 0; copy < copies; ++copy)
        for (std::int64_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i) {
            EdgePoint p = chains.point[i];
            if (!line.empty()) {
                const EdgePoint& last = line[line.size() - 1];
                p.at = last.at + glm::distance(p.place, last.place);
            }
            line.push_back(p);
        }
    for (std::int64_t i = copies / 2 * count; i < (copies / 2 + 1) * count; ++i) {
        mean.push_back(mean_along(line, i, reach));
        mean.back().strength = mean_along(line, i, feature_tuning.strength_reach * reach).strength;
    }
    return mean;
}

// Adds the strong parts of a chain.
void add_parts(const base::Array<EdgePoint>& line, bool closed, const SoftEdgeRequest& request, double diagonal,
               Chains<EdgePoint>& parts) {
    const std::int64_t count = line.size();
    const auto is_strong = [&](std::int64_t i) { return line[i].strength > request.lower; };
    for_parts(count, closed, is_strong, [&](std::int64_t begin, std::int64_t end, bool whole) {
        double strongest = 0.0;
        double length = 0.0;
        double sum = 0.0;
        for (std::int64_t i = begin; i < end; ++i) {
            const EdgePoint& p = line[i % count];
            strongest = std::max(strongest, p.strength);
            if (i == begin) continue;
            const double piece = glm::distance(p.place, line[(i - 1) % count].place);
            length += piece;
            sum += piece * (p.strength - request.lower);
        }
        if (strongest < request.upper || length < request.shortest * diagonal ||
            sum < feature_tuning.least_soft_edge * diagonal)
            return;
        for (std::int64_t i = begin; i < end; ++i) parts.point.push_back(line[i % count]);
        parts.end(whole);
    });
}

// Brings the parts onto the surface and makes lines of them.
SurfaceLines as_lines(const base::Work& work, const implicit::Implicit& surface, const Chains<EdgePoint>& parts) {
    SurfaceLines lines(work.memory);
    surface::Projection on(work.memory);
    for (const EdgePoint& p : parts.point) on.position.push_back(p.place);
    surface::project(work.without_progress(), surface, {}, on);
    LineBuilder builder(lines);
    for (std::int64_t c = 0; c < parts.count(); ++c) {
        for (std::int64_t i = parts.first[c]; i < parts.first[c + 1]; ++i)
            if (on.status[i] == surface::ProjectionStatus::converged)
                builder.add(on.position[i], glm::normalize(on.gradient[i]), parts.point[i].strength);
        builder.end(parts.closed[c] != 0);
    }
    return lines;
}

} // namespace

SoftEdges find_soft_edges(const base::Work& work, const implicit::Implicit& surface, const SurfaceMesh& mesh,
                          const SoftEdgeRequest& request) {
    SoftEdges found(work.memory);
    if (mesh.triangles() == 0) return found;
    const double diagonal = surface.diagonal();
    const double blur = std::max(feature_tuning.blur_sides * mesh.side, feature_tuning.blur_diagonals * diagonal);
    const double reach = feature_tuning.turn_reach * blur;
    const Rings rings = rings_of(work, mesh);
    if (!(rings.edge > 0.0)) return found;
    const base::Array<Vertex> vertex = smoothed_mesh(work.part(0.0, 0.5), mesh, rings, blur);
    const base::Array<Bend> bend = bends_of(work, mesh, rings, vertex);
    for (const bool concave : {false, true}) {
        work.update(concave ? 0.8 : 0.6);
        const base::Array<FeatureValue> value = crest_values(work, mesh, rings, vertex, bend, concave);
        // find_candidates() finds maxima of the curvature, as on valleys. On a way of twice the reach, a turn by the
        // angle `lower` needs at least this mean curvature.
        FeatureRequest crest;
        crest.kind = FeatureKind::valley;
        const double per_degree = std::numbers::pi / 180.0 * blur / (2.0 * reach);
        crest.lower = request.lower * per_degree;
        crest.upper = request.upper * per_degree;
        std::int64_t weak = 0;
        const Chains<FeatureCrossing> chains = find_candidates(work, mesh, value, crest, weak);
        const base::Array<double> strength =
            measure_turns(work.without_progress(), mesh, value, chains, concave, reach);
        Chains<EdgePoint> places(work.memory), parts(work.memory);
        for (std::int64_t c = 0; c < chains.count(); ++c) {
            for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
                const FeatureCrossing& x = chains.point[i];
                places.point.push_back({glm::mix(mesh.position[x.a], mesh.position[x.b], x.share), 0.0, strength[i]});
            }
            places.end(chains.closed[c] != 0);
            add_parts(averaged_chain(places, c, reach), places.closed[c] != 0, request, diagonal, parts);
        }
        (concave ? found.concave : found.convex) = as_lines(work, surface, parts);
    }
    return found;
}

} // namespace hrbfnpr::curves
