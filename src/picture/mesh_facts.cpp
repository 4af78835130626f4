// SPDX-License-Identifier: MIT
#include "picture/mesh_facts.h"

#include "base/status.h"
#include "mesh/edges.h"
#include "picture/faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hrbfnpr::picture {
namespace {

bool has_finite_corners(const Points& points, const Triangle& face) noexcept {
    return std::all_of(face.begin(), face.end(), [&](std::int64_t corner) {
        const glm::dvec3& p = points[static_cast<std::size_t>(corner)];
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

// A mesh whose vertices at the same place are joined.
struct JoinedMesh {
    Points places; // The places of the vertices, in ascending order.
    Vector<Triangle> faces;
};

// Joins the vertices of faces with finite corners, and counts the faces and vertices that are left out.
JoinedMesh join_vertices(const Shape& shape, MeshFacts& facts, Pool& pool) {
    const std::size_t count = shape.points.size();
    constexpr std::int64_t unused = -1;
    constexpr std::int64_t used = 0;
    Vector<std::int64_t> place_of(count, unused, &pool);
    Vector<std::uint8_t> is_corner(count, 0, &pool);
    JoinedMesh joined{Points(&pool), Vector<Triangle>(&pool)};
    for (const Triangle& face : shape.triangles) {
        const bool finite = has_finite_corners(shape.points, face);
        for (const std::int64_t corner : face) {
            is_corner[static_cast<std::size_t>(corner)] = 1;
            if (finite) place_of[static_cast<std::size_t>(corner)] = used;
        }
        if (finite) joined.faces.push_back(face);
    }
    facts.faces_not_finite = static_cast<std::int64_t>(shape.triangles.size() - joined.faces.size());
    facts.unused_vertices = std::count(is_corner.begin(), is_corner.end(), std::uint8_t{0});

    Vector<std::size_t> order(&pool);
    for (std::size_t i = 0; i < count; ++i)
        if (place_of[i] == used) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const glm::dvec3& a = shape.points[i];
        const glm::dvec3& b = shape.points[j];
        if (a.x != b.x) return a.x < b.x;
        return a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    for (const std::size_t i : order) {
        if (joined.places.empty() || joined.places.back() != shape.points[i]) joined.places.push_back(shape.points[i]);
        place_of[i] = static_cast<std::int64_t>(joined.places.size()) - 1;
    }
    facts.joined_vertices = static_cast<std::int64_t>(order.size() - joined.places.size());
    for (Triangle& face : joined.faces)
        for (std::int64_t& corner : face) corner = place_of[static_cast<std::size_t>(corner)];
    return joined;
}

// Removes the faces that have no area.
void leave_out_degenerate(JoinedMesh& mesh, MeshFacts& facts, Pool& pool) {
    Vector<double> doubled(&pool);
    std::size_t to = 0;
    for (const Triangle& face : mesh.faces) {
        doubled.push_back(glm::length(doubled_area_of(mesh.places, face)));
        facts.degenerate_faces += doubled.back() <= 0.0 ? 1 : 0;
        // For a NaN area the comparison is false, so the face is removed.
        if (doubled.back() > 0.0) mesh.faces[to++] = face;
    }
    mesh.faces.resize(to);
    facts.area = sum_in_pairs(doubled) / 2.0;
}

std::int64_t count_repeated(Vector<Triangle> faces) {
    for (Triangle& face : faces) std::sort(face.begin(), face.end());
    std::sort(faces.begin(), faces.end());
    return faces.end() - std::unique(faces.begin(), faces.end());
}

// Returns whether a half-edge of a face goes from its vertex with the lower index to its vertex with the higher index.
bool goes_up(const FaceEdges& edges, const Vector<Triangle>& faces, std::int64_t side) noexcept {
    const auto k = static_cast<std::size_t>(side / edges.faces);
    const Triangle& face = faces[edges.face(side)];
    return face[k] < face[(k + 1) % 3];
}

// Counts the edges that a closed surface cannot have. Returns the border edges.
Vector<Edge> look_at_edges(const JoinedMesh& mesh, MeshFacts& facts, Pool& pool) {
    const FaceEdges edges = find_edges(mesh.faces, mesh.places.size(), pool);
    Vector<Edge> border(&pool);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides_of(e);
        if (sides.size() == 1) {
            border.push_back(edges.ends[e]);
        } else if (sides.size() > 2) {
            ++facts.nonmanifold_edges;
        } else if (goes_up(edges, mesh.faces, sides[0]) == goes_up(edges, mesh.faces, sides[1])) {
            ++facts.contrary_edges;
        }
    }
    facts.boundary_edges = static_cast<std::int64_t>(border.size());
    return border;
}

std::int32_t as_vertex(std::int64_t i) noexcept { return static_cast<std::int32_t>(i); }

std::int64_t count_loops(const Vector<Edge>& border, std::size_t vertices, Pool& pool) {
    mesh::UnionFind joined(pool.memory(), static_cast<std::int64_t>(vertices));
    for (const Edge& edge : border) joined.join(as_vertex(edge[0]), as_vertex(edge[1]));
    // A loop is identified by the index of one of its vertices.
    Vector<std::int64_t> names(&pool);
    for (const Edge& edge : border) names.push_back(joined.find(as_vertex(edge[0])));
    std::sort(names.begin(), names.end());
    return std::unique(names.begin(), names.end()) - names.begin();
}

// Counts the parts, and finds the volume of the mesh and of each part. For each face, adds six times the volume of the
// tetrahedron between the face and a middle point.
void look_at_parts(const JoinedMesh& mesh, const Vector<Edge>& border, MeshFacts& facts, Pool& pool) {
    mesh::UnionFind joined(pool.memory(), static_cast<std::int64_t>(mesh.places.size()));
    for (const Triangle& face : mesh.faces) {
        joined.join(as_vertex(face[0]), as_vertex(face[1]));
        joined.join(as_vertex(face[1]), as_vertex(face[2]));
    }
    constexpr std::int64_t none = -1;
    // For the vertex that represents a part: the index of the part. For all other vertices: `none`.
    Vector<std::int64_t> part_of(mesh.places.size(), none, &pool);
    const auto part_at = [&](std::int64_t vertex) -> std::int64_t& {
        return part_of[static_cast<std::size_t>(joined.find(as_vertex(vertex)))];
    };
    for (const Triangle& face : mesh.faces) part_at(face[0]) = 0;
    for (std::int64_t& part : part_of)
        if (part != none) part = facts.components++;

    const glm::dvec3 middle = std::accumulate(mesh.places.begin(), mesh.places.end(), glm::dvec3(0.0)) /
                              static_cast<double>(std::max<std::size_t>(mesh.places.size(), 1));
    Vector<double> volumes(static_cast<std::size_t>(facts.components), 0.0, &pool);
    for (const Triangle& face : mesh.faces) {
        const auto corner = [&](std::size_t k) { return mesh.places[static_cast<std::size_t>(face[k])] - middle; };
        volumes[static_cast<std::size_t>(part_at(face[0]))] += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    for (double& volume : volumes) volume /= 6.0;
    const double volume = sum_in_pairs(volumes);
    facts.inside_out = facts.closed && volume < 0.0;
    facts.volume = facts.closed ? volume : 0.0;
    // The volume of a part with a border counts as 0.
    for (const Edge& edge : border) volumes[static_cast<std::size_t>(part_at(edge[0]))] = 0.0;
    facts.components_inside_out = std::count_if(volumes.begin(), volumes.end(), [](double v) { return v < 0.0; });
}

} // namespace

MeshFacts mesh_facts_of(const Shape& shape, Pool& pool) {
    HRBFNPR_ASSERT(shape.is_mesh());
    if (shape.points.size() > static_cast<std::size_t>(mesh::most_vertices))
        fail(Status::invalid_argument, "the mesh has %zu vertices; at most %lld are possible", shape.points.size(),
             static_cast<long long>(mesh::most_vertices));
    MeshFacts facts;
    JoinedMesh mesh = join_vertices(shape, facts, pool);
    leave_out_degenerate(mesh, facts, pool);
    facts.repeated_faces = count_repeated(mesh.faces);
    const Vector<Edge> border = look_at_edges(mesh, facts, pool);
    facts.boundary_loops = count_loops(border, mesh.places.size(), pool);
    facts.closed = !mesh.faces.empty() && border.empty() && facts.nonmanifold_edges == 0 && facts.contrary_edges == 0;
    look_at_parts(mesh, border, facts, pool);
    return facts;
}

} // namespace hrbfnpr::picture
