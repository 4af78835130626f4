// SPDX-License-Identifier: MIT
#include "picture/subdivide.h"

#include "base/assert.h"
#include "mesh/edges.h"
#include "picture/faces.h"
#include "picture/tuning_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hrbfnpr::picture {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double all_smooth = 180.0; // No edge bends by more than this, in degrees.

// One flag for each edge, vertex or face.
using Flags = Vector<std::uint8_t>;

const glm::dvec3& at(const Points& points, std::int64_t i) noexcept { return points[static_cast<std::size_t>(i)]; }
glm::dvec3& at(Points& points, std::int64_t i) noexcept { return points[static_cast<std::size_t>(i)]; }

// ---- Sharp edges, and the coarseness of the others

// The plain edges of a mesh (those with two faces), and the angles by which they bend.
struct Bends {
    explicit Bends(Pool& pool) : plain(&pool), angle(&pool), length(&pool), area(&pool) {}

    Vector<PlainEdge> plain;
    Vector<double> angle;  // angle of each plain edge, in radians
    Vector<double> length; // length of each plain edge
    Vector<double> area;   // area of each face
};

Bends bends_of(const Shape& shape, const FaceEdges& edges, Pool& pool) {
    Bends bends(pool);
    bends.plain = plain_edges(edges, pool);
    Points normal(&pool);
    for (const Triangle& face : shape.triangles) {
        const glm::dvec3 doubled = doubled_area_of(shape.points, face);
        normal.push_back(unit_or_zero(doubled));
        bends.area.push_back(glm::length(doubled) / 2.0);
    }
    for (const PlainEdge& p : bends.plain) {
        bends.angle.push_back(std::acos(std::clamp(glm::dot(normal[p.one], normal[p.other]), -1.0, 1.0)));
        const Edge& ends = edges.ends[p.edge];
        bends.length.push_back(glm::length(at(shape.points, ends[0]) - at(shape.points, ends[1])));
    }
    return bends;
}

// Joins the two faces at each plain edge i for which joins(i) is true. Returns for each face the smallest index of a
// face in its set.
template <class Joins>
Vector<std::size_t> joined_faces(const Bends& bends, Pool& pool, Joins&& joins) {
    mesh::UnionFind sets(pool.memory(), static_cast<std::int64_t>(bends.area.size()));
    for (std::size_t i = 0; i < bends.plain.size(); ++i)
        if (joins(i))
            sets.join(static_cast<std::int32_t>(bends.plain[i].one), static_cast<std::int32_t>(bends.plain[i].other));
    Vector<std::size_t> name(&pool);
    name.reserve(bends.area.size());
    for (std::size_t f = 0; f < bends.area.size(); ++f)
        name.push_back(static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(f))));
    return name;
}

// Returns for each plain edge whether it belongs to a bevelled part. On such a part, most smooth edges lie between a
// flat face and a narrow one.
Flags edges_of_bevelled_parts(const Bends& bends, const Flags& smooth, Pool& pool) {
    const Vector<std::size_t> face =
        joined_faces(bends, pool, [&](std::size_t i) { return bends.angle[i] < subdivide_tuning.flat_angle * degree; });
    // For each triangle: the area of the flat face that it belongs to.
    Vector<double> area(bends.area.size(), 0.0, &pool);
    for (std::size_t f = 0; f < face.size(); ++f) area[face[f]] += bends.area[f];
    const Vector<std::size_t> part = joined_faces(bends, pool, [](std::size_t) { return true; });
    Vector<double> of_bevels(bends.area.size(), 0.0, &pool); // for each part: the length of its edges beside bevels
    Vector<double> of_all(bends.area.size(), 0.0, &pool);
    Flags is_bend(bends.plain.size(), 0, &pool);
    for (std::size_t i = 0; i < bends.plain.size(); ++i) {
        if (smooth[i] == 0 || !(bends.angle[i] > subdivide_tuning.bevel_angle * degree)) continue;
        is_bend[i] = 1;
        const double one = area[face[bends.plain[i].one]];
        const double other = area[face[bends.plain[i].other]];
        const std::size_t name = part[bends.plain[i].one];
        of_all[name] += bends.length[i];
        if (std::min(one, other) <= subdivide_tuning.narrow * std::max(one, other)) of_bevels[name] += bends.length[i];
    }
    for (std::size_t i = 0; i < is_bend.size(); ++i) {
        const std::size_t name = part[bends.plain[i].one];
        if (!(2.0 * of_bevels[name] > of_all[name])) is_bend[i] = 0;
    }
    return is_bend;
}

// Returns for each edge whether it stays sharp.
Flags sharp_edges_of(const Shape& shape, const FaceEdges& edges, const Bends& bends, double crease_angle, Pool& pool) {
    Flags sharp(edges.size(), 1, &pool); // Edges that do not have exactly two faces stay sharp.
    for (std::size_t i = 0; i < bends.plain.size(); ++i)
        sharp[bends.plain[i].edge] = bends.angle[i] > crease_angle * degree ? 1 : 0;
    if (!shape.has_sharp_edges) return sharp;
    Vector<Edge> given(&pool);
    for (const Edge& edge : shape.sharp_edges) given.push_back(edge[0] < edge[1] ? edge : Edge{edge[1], edge[0]});
    std::sort(given.begin(), given.end());
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (std::binary_search(given.begin(), given.end(), edges.ends[e])) sharp[e] = 1;
    Flags smooth(&pool);
    for (const PlainEdge& plain : bends.plain) smooth.push_back(sharp[plain.edge] == 0 ? 1 : 0);
    const Flags bevelled = edges_of_bevelled_parts(bends, smooth, pool);
    for (std::size_t i = 0; i < bends.plain.size(); ++i)
        if (bevelled[i] != 0) sharp[bends.plain[i].edge] = 1;
    return sharp;
}

// Returns how much the surface bulges at each plain edge, as a share of the diagonal. The value is 0 for sharp edges.
Vector<double> bulges_of(const Shape& shape, const Bends& bends, const Flags& sharp, Pool& pool) {
    constexpr double least_length = 1e-300;
    Vector<double> bulge(bends.plain.size(), 0.0, &pool);
    const double diagonal = box_diagonal_of(shape.points);
    if (!(diagonal > 0.0)) return bulge;
    // With this factor, the extent of an equilateral triangle equals the length of its edge.
    const double equilateral = 4.0 / std::sqrt(3.0);
    for (std::size_t i = 0; i < bends.plain.size(); ++i) {
        const PlainEdge& plain = bends.plain[i];
        if (sharp[plain.edge] != 0) continue;
        const double length = std::max(bends.length[i], least_length);
        const double across =
            std::min(equilateral * bends.area[plain.one] / length, equilateral * bends.area[plain.other] / length);
        bulge[i] = bends.angle[i] * across / (8.0 * diagonal);
    }
    return bulge;
}

// ---- Rounds

// The data about a mesh that one round of subdivision needs.
struct Round {
    FaceEdges edges;
    Flags sharp;                // one flag for each edge
    Flags on_line;              // one flag for each vertex: it is an inner vertex of a sharp line
    Flags stays;                // one flag for each vertex: it does not move
    Vector<Triangle> triangles; // the faces after the round
};

Vector<std::int64_t> lines_at_vertices(const FaceEdges& edges, const Flags& sharp, std::size_t vertices, Pool& pool) {
    Vector<std::int64_t> lines(vertices, 0, &pool);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (sharp[e] != 0)
            for (const std::int64_t end : edges.ends[e]) ++lines[static_cast<std::size_t>(end)];
    return lines;
}

// Returns the vertices that stay: ends, crossings and corners of sharp lines.
Flags staying_vertices(const Points& points, const FaceEdges& edges, const Flags& sharp,
                       const Vector<std::int64_t>& lines, Pool& pool) {
    // For each vertex, the sum of unit vectors along its sharp edges, pointing away from the vertex.
    Points way(points.size(), glm::dvec3(0.0), &pool);
    for (const bool to_end : {false, true})
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (sharp[e] == 0) continue;
            const Edge& ends = edges.ends[e];
            const glm::dvec3 unit = unit_or_zero(at(points, ends[1]) - at(points, ends[0]));
            at(way, ends[to_end ? 1 : 0]) += to_end ? -unit : unit;
        }
    // The limit of |a + b|^2 for the unit vectors a and b along two sharp edges away from a vertex: 2 + 2 a . b. For a
    // straight line it is 0.
    const double corner = 2.0 - 2.0 * std::cos(subdivide_tuning.corner_angle * degree);
    Flags stays(points.size(), 0, &pool);
    for (std::size_t v = 0; v < points.size(); ++v) {
        const glm::dvec3 square = way[v] * way[v];
        const bool turns = lines[v] == 2 && square.x + square.y + square.z > corner;
        stays[v] = lines[v] == 1 || lines[v] > 2 || turns ? 1 : 0;
    }
    return stays;
}

// Divides each face into four: three at the corners, and one in the middle.
Vector<Triangle> quartered(const Vector<Triangle>& triangles, const FaceEdges& edges, std::size_t vertices,
                           Pool& pool) {
    const std::size_t faces = triangles.size();
    Vector<Triangle> finer(4 * faces, Triangle{}, &pool);
    for (std::size_t f = 0; f < faces; ++f) {
        std::array<std::int64_t, 3> middle{};
        for (std::size_t k = 0; k < 3; ++k)
            middle[k] = static_cast<std::int64_t>(vertices) + edges.of_side[k * faces + f];
        const Triangle& corner = triangles[f];
        finer[f] = {corner[0], middle[0], middle[2]};
        finer[faces + f] = {corner[1], middle[1], middle[0]};
        finer[2 * faces + f] = {corner[2], middle[2], middle[1]};
        finer[3 * faces + f] = {middle[0], middle[1], middle[2]};
    }
    return finer;
}

// Returns the two halves of all edges that were sharp before a round, in ascending order.
Vector<Edge> halves_of(const FaceEdges& edges, const Flags& sharp, std::size_t vertices, Pool& pool) {
    Vector<Edge> halves(&pool);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (sharp[e] != 0)
            for (const std::int64_t end : edges.ends[e])
                halves.push_back({end, static_cast<std::int64_t>(vertices + e)});
    std::sort(halves.begin(), halves.end());
    return halves;
}

struct Rounds {
    explicit Rounds(Pool& pool) : rounds(&pool), sharp_edges(&pool) {}

    Vector<Round> rounds;
    Vector<Edge> sharp_edges; // the sharp edges after the last round, if the shape knows its sharp edges
};

Rounds plan_rounds(const Shape& shape, std::int32_t count, double crease_angle, Pool& pool,
                   const base::Progress& progress) {
    Rounds plan(pool);
    plan.rounds.reserve(static_cast<std::size_t>(count));
    std::size_t vertices = shape.points.size();
    FaceEdges edges = find_edges(shape.triangles, vertices, pool);
    Flags sharp = sharp_edges_of(shape, edges, bends_of(shape, edges, pool), crease_angle, pool);
    Vector<std::int64_t> lines = lines_at_vertices(edges, sharp, vertices, pool);
    Flags stays = staying_vertices(shape.points, edges, sharp, lines, pool);
    for (std::int32_t i = 0; i < count; ++i) {
        progress.check();
        Flags on_line(&pool);
        for (const std::int64_t at_vertex : lines) on_line.push_back(at_vertex == 2 ? 1 : 0);
        const Vector<Triangle>& before = i == 0 ? shape.triangles : plan.rounds.back().triangles;
        Vector<Triangle> finer = quartered(before, edges, vertices, pool);
        const Vector<Edge> halves = halves_of(edges, sharp, vertices, pool);
        const std::size_t after = vertices + edges.size();
        plan.rounds.push_back(
            {std::move(edges), std::move(sharp), std::move(on_line), Flags(stays, &pool), std::move(finer)});
        stays.resize(after, 0);
        vertices = after;
        if (i + 1 == count) { // After the last round, only the sharp edges remain to be computed.
            if (shape.has_sharp_edges) plan.sharp_edges = halves;
            break;
        }
        edges = find_edges(plan.rounds.back().triangles, vertices, pool);
        sharp.assign(edges.size(), 0);
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (std::binary_search(halves.begin(), halves.end(), edges.ends[e])) sharp[e] = 1;
        lines = lines_at_vertices(edges, sharp, vertices, pool);
    }
    return plan;
}

// Returns, for each point, the sum of the points at the other ends of its edges. If `wanted` is not null, only edges
// whose element is 1 are used.
Points sums_around(const Points& points, const FaceEdges& edges, const Flags* wanted, Pool& pool) {
    Points sums(points.size(), glm::dvec3(0.0), &pool);
    for (const std::size_t from : {std::size_t{0}, std::size_t{1}})
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (wanted == nullptr || (*wanted)[e] != 0)
                at(sums, edges.ends[e][from]) += at(points, edges.ends[e][1 - from]);
    return sums;
}

// Returns the new position of a vertex by Loop's rule, given the sum of its neighbours.
glm::dvec3 smooth_place(const glm::dvec3& place, const glm::dvec3& around, std::int64_t valence) noexcept {
    const auto most = static_cast<double>(std::max<std::int64_t>(valence, 3));
    const double near = 3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / most) / 4.0;
    const double share = 5.0 / 8.0 - near * near;
    return (1.0 - share) * place + share * around / static_cast<double>(std::max<std::int64_t>(valence, 1));
}

// Returns the vertices after a round: the moved vertices, then the new vertices on the edges. `corners` has the faces
// before the round.
Points refined_once(const Points& points, const Round& round, const Vector<Triangle>& corners, Pool& pool) {
    const FaceEdges& edges = round.edges;
    const std::size_t faces = corners.size();
    Points beside(edges.size(), glm::dvec3(0.0), &pool); // for each edge: the sum of the corners opposite to it
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t f = 0; f < faces; ++f)
            at(beside, edges.of_side[k * faces + f]) += at(points, corners[f][(k + 2) % 3]);
    Vector<std::int64_t> valence(points.size(), 0, &pool);
    for (const Edge& ends : edges.ends)
        for (const std::int64_t end : ends) ++valence[static_cast<std::size_t>(end)];
    const Points around = sums_around(points, edges, nullptr, pool);
    const Points along = sums_around(points, edges, &round.sharp, pool);
    Points finer(&pool);
    finer.reserve(points.size() + edges.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (round.stays[v] != 0 || valence[v] == 0)
            finer.push_back(points[v]);
        else if (round.on_line[v] != 0)
            finer.push_back(0.75 * points[v] + 0.125 * along[v]);
        else
            finer.push_back(smooth_place(points[v], around[v], valence[v]));
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const glm::dvec3 middle = 0.5 * (at(points, edges.ends[e][0]) + at(points, edges.ends[e][1]));
        finer.push_back(round.sharp[e] != 0 ? middle : 0.75 * middle + 0.125 * beside[e]);
    }
    return finer;
}

Points refined(const Points& points, const Shape& shape, const Vector<Round>& rounds, Pool& pool,
               const base::Progress& progress) {
    Points finer(points, &pool);
    const Vector<Triangle>* corners = &shape.triangles;
    for (const Round& round : rounds) {
        progress.check();
        finer = refined_once(finer, round, *corners, pool);
        corners = &round.triangles;
    }
    return finer;
}

} // namespace

Shape subdivide(const Shape& shape, std::int32_t rounds, double crease_angle, Pool& pool,
                const base::Progress& progress) {
    if (!shape.is_mesh()) fail(Status::invalid_argument, "there are no faces to subdivide");
    if (rounds < 0 || rounds > subdivide_tuning.most_rounds)
        fail(Status::invalid_argument, "rounds is %d; it must be from 0 to %d", static_cast<int>(rounds),
             static_cast<int>(subdivide_tuning.most_rounds));
    const auto faces = static_cast<std::int64_t>(shape.triangles.size());
    const std::int64_t after = faces << 2 * rounds;
    if (after > subdivide_tuning.most_faces)
        fail(Status::invalid_argument,
             "%lld faces become %lld after %d rounds of subdivision, and %lld are the most: use fewer rounds",
             static_cast<long long>(faces), static_cast<long long>(after), static_cast<int>(rounds),
             static_cast<long long>(subdivide_tuning.most_faces));
    Shape finer(pool);
    finer.has_sharp_edges = shape.has_sharp_edges;
    if (rounds == 0) {
        finer.points = shape.points;
        finer.triangles = shape.triangles;
        finer.sharp_edges = shape.sharp_edges;
        return finer;
    }
    Rounds plan = plan_rounds(shape, rounds, crease_angle, pool, progress);
    Points control(shape.points, &pool); // The control points. Their subdivision approximates the given vertices.
    for (std::int32_t i = 0; i < subdivide_tuning.corrections; ++i) {
        const Points made = refined(control, shape, plan.rounds, pool, progress);
        for (std::size_t v = 0; v < control.size(); ++v) control[v] = control[v] + shape.points[v] - made[v];
    }
    finer.points = refined(control, shape, plan.rounds, pool, progress);
    finer.triangles = std::move(plan.rounds.back().triangles);
    finer.sharp_edges = std::move(plan.sharp_edges);
    return finer;
}

Vector<std::int64_t> parents_of(std::size_t faces, std::size_t finer, Pool& pool) {
    Vector<std::int64_t> parents(&pool);
    parents.reserve(finer);
    // Each round divides every face into four. In the result, part k of face f has the index k * (number of faces) + f.
    for (std::size_t i = 0; i < finer; ++i) parents.push_back(static_cast<std::int64_t>(i % faces));
    return parents;
}

DividedParts subdivide_coarse_parts(const Shape& shape, std::int32_t rounds, double crease_angle, double tolerance,
                                    Pool& pool, const base::Progress& progress) {
    const FaceEdges edges = find_edges(shape.triangles, shape.points.size(), pool);
    const Bends bends = bends_of(shape, edges, pool);
    const Vector<std::size_t> part = joined_faces(bends, pool, [](std::size_t) { return true; });
    const Flags sharp = sharp_edges_of(shape, edges, bends, all_smooth, pool);
    const Vector<double> bulge = bulges_of(shape, bends, sharp, pool);
    Flags is_coarse(shape.triangles.size(), 0, &pool); // one flag for each part
    for (std::size_t i = 0; i < bulge.size(); ++i)
        if (bulge[i] > tolerance) is_coarse[part[bends.plain[i].one]] = 1;
    Shape coarse(pool);
    coarse.points = shape.points;
    coarse.has_sharp_edges = shape.has_sharp_edges;
    coarse.sharp_edges = shape.sharp_edges;
    Vector<Triangle> triangles(&pool); // first the faces that stay, then the faces of the divided parts
    Vector<std::int64_t> parents(&pool);
    Vector<std::int64_t> divided(&pool);
    for (std::size_t f = 0; f < shape.triangles.size(); ++f) {
        const bool divide = is_coarse[part[f]] != 0;
        (divide ? coarse.triangles : triangles).push_back(shape.triangles[f]);
        (divide ? divided : parents).push_back(static_cast<std::int64_t>(f));
    }
    if (divided.empty()) {
        coarse.triangles = std::move(triangles);
        return {std::move(coarse), std::move(parents)};
    }
    Shape finer = subdivide(coarse, rounds, crease_angle, pool, progress);
    for (std::size_t i = 0; i < finer.triangles.size(); ++i) parents.push_back(divided[i % divided.size()]);
    triangles.insert(triangles.end(), finer.triangles.begin(), finer.triangles.end());
    finer.triangles = std::move(triangles);
    return {std::move(finer), std::move(parents)};
}

double coarseness(const Shape& shape, double percent, Pool& pool) {
    const FaceEdges edges = find_edges(shape.triangles, shape.points.size(), pool);
    const Bends bends = bends_of(shape, edges, pool);
    const Flags sharp = sharp_edges_of(shape, edges, bends, all_smooth, pool);
    const Vector<double> bulge = bulges_of(shape, bends, sharp, pool);
    Vector<double> of_smooth(&pool);
    for (std::size_t i = 0; i < bulge.size(); ++i)
        if (sharp[bends.plain[i].edge] == 0) of_smooth.push_back(bulge[i]);
    return percentile(of_smooth, percent);
}

Vector<double> raised(const Shape& shape, const Shape& finer, const Vector<std::int64_t>& parents, Pool& pool) {
    HRBFNPR_ASSERT(parents.size() == finer.triangles.size());
    constexpr double least_diagonal = 1e-300;
    const double diagonal = std::max(box_diagonal_of(shape.points), least_diagonal);
    Vector<double> least(finer.points.size(), std::numeric_limits<double>::infinity(), &pool);
    for (std::size_t f = 0; f < finer.triangles.size(); ++f) {
        const Triangle& parent = shape.triangles[static_cast<std::size_t>(parents[f])];
        const glm::dvec3 normal = unit_or_zero(doubled_area_of(shape.points, parent));
        for (const std::int64_t v : finer.triangles[f]) {
            const double off = std::abs(glm::dot(at(finer.points, v) - at(shape.points, parent[0]), normal));
            double& known = least[static_cast<std::size_t>(v)];
            known = std::min(known, off);
        }
    }
    Vector<double> rise(&pool);
    for (const double off : least)
        if (std::isfinite(off)) rise.push_back(off / diagonal);
    return rise;
}

double mean_edge(const Shape& shape, Pool& pool) {
    Vector<double> length(&pool);
    for (const Triangle& face : shape.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            length.push_back(glm::length(at(shape.points, face[k]) - at(shape.points, face[(k + 2) % 3])));
    const double diagonal = box_diagonal_of(shape.points);
    if (length.empty() || !(diagonal > 0.0)) return 0.0;
    return sum_in_pairs(length) / static_cast<double>(length.size()) / diagonal;
}

} // namespace hrbfnpr::picture
