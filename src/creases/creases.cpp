// SPDX-License-Identifier: MIT
// split_at_creases makes the mesh:
// 1. find_sheets finds the sheet of each vertex.
// 2. settle_alone and settle_equal assign vertices where sheets nearly coincide to the first of these sheets.
// 3. find_edges finds where the sheets of an edge's ends meet; find_corners does the same in triangles of three sheets.
// 4. halve_unclear halves edges where another sheet covers the crease; then steps 2 to 4 are repeated.
// 5. place_rest places the remaining nodes near the surface.
// 6. find_chains makes chains of the nodes of creases.
// 7. build cuts triangles at the nodes.
// Afterwards sheet_surfaces splits the mesh into one for each sheet.
//
// trace_creases runs once for a model:
// 1. add_chain makes points of the mesh's nodes, without crowded ones, and cuts chains where sheets do not meet.
// 2. set_normals sets the normals of both sheets at each point.
// 3. drop_returns drops points that are out of order.
// 4. find_tangents and halve_pieces add points where a crease turns.
// parts_in_view runs for each camera: it cuts creases where one of their sheets turns away from the eye.
#include "creases/creases.h"

#include "creases/tuning.h"
#include "curves/mesh_edges.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/segment.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// ---- The mesh

constexpr std::int64_t nodes_a_task = 32;
// The tolerance for the position of a place where sheets meet, in sides of the mesh's cells.
constexpr double meeting_tolerance = 1e-9;

// A node of an edge whose ends belong to different sheets.
struct EdgeNode {
    std::int64_t edge;                 // the index of the first of the two opposite edges
    std::array<std::int32_t, 2> ends;  // the start and end vertex of the edge
    std::array<std::int32_t, 2> sheet; // the sheets of the start and end vertex
    CreaseNode place;
    std::array<glm::dvec3, 2> gradient; // the gradients of both sheets at the node
    // Whether the start may belong to the end's sheet, and whether the end may belong to the start's sheet, because the
    // two sheets coincide there.
    std::array<bool, 2> equal;
    bool alike; // whether the sheets nearly coincide at both ends
    bool meet;  // whether the sheets meet near the edge, on or off the surface
    bool near;  // whether the sheets meet at an angle slightly off the surface
};

// A node of a triangle whose corners belong to three sheets.
struct CornerNode {
    std::int64_t triangle;
    CreaseNode place;
    std::array<glm::dvec3, 3> gradient; // the gradients of the three corners' sheets at the node
};

// A mesh with the sheets of its vertices, and with nodes where its edges cross creases.
struct SheetMesh {
    SheetMesh(base::Memory& memory, const implicit::Implicit& of, SurfaceMesh given)
        : implicit(of), sheets(*of.sheets()), mesh(std::move(given)), sheet(memory), node(memory), edges(memory),
          corners(memory) {}

    const implicit::Implicit& implicit;
    const implicit::Sheets& sheets;
    SurfaceMesh mesh;
    base::Array<std::int32_t> sheet; // the sheet of each vertex
    // For each edge of each triangle, the index of its node in `edges`. Opposite edges have the same node. -1: the edge
    // crosses no crease.
    base::Array<std::int32_t> node;
    base::Array<EdgeNode> edges;
    base::Array<CornerNode> corners; // sorted by triangle

    [[nodiscard]] std::int32_t sheet_at(std::int64_t edge) const noexcept { return sheet[start_of(mesh, edge)]; }
    [[nodiscard]] int sheets_of(std::int64_t triangle) const noexcept {
        const std::int32_t a = sheet_at(3 * triangle);
        const std::int32_t b = sheet_at(3 * triangle + 1);
        const std::int32_t c = sheet_at(3 * triangle + 2);
        return a == b && b == c ? 1 : a != b && b != c && a != c ? 3 : 2;
    }
    // Returns the corner of creases in a triangle; null if the triangle has no corner.
    [[nodiscard]] const CornerNode* corner_of(std::int64_t triangle) const noexcept {
        const CornerNode* const at =
            std::lower_bound(corners.begin(), corners.end(), triangle,
                             [](const CornerNode& one, std::int64_t wanted) { return one.triangle < wanted; });
        return at != corners.end() && at->triangle == triangle ? at : nullptr;
    }
    [[nodiscard]] double length_of(std::int64_t edge) const noexcept {
        return glm::distance(mesh.position[start_of(mesh, edge)], mesh.position[end_of(mesh, edge)]);
    }
    [[nodiscard]] surface::SheetValue value(const glm::dvec3& place) const {
        surface::SheetValue f;
        implicit.evaluate({&place.x, &place.y, &place.z, 1},
                          {&f.value, {&f.gradient.x, &f.gradient.y, &f.gradient.z}, {}});
        return f;
    }
    // Returns the distance between a place and the whole surface, in sides.
    [[nodiscard]] double off_surface(const glm::dvec3& place) const {
        const surface::SheetValue f = value(place);
        return std::abs(f.value) / (mesh.side * glm::length(f.gradient));
    }
    [[nodiscard]] surface::MeetingPlace meeting(std::span<const std::int32_t> vertices, const glm::dvec3& from,
                                                double reach) const {
        surface::Meeting all;
        for (const std::int32_t vertex : vertices) all.add(sheet[vertex]);
        return surface::find_meeting(sheets, all, from, meeting_tolerance * mesh.side,
                                     crease_tuning.farthest_meeting * reach);
    }
};

void find_sheets(const base::Work& work, SheetMesh& at) {
    const std::int64_t from = at.sheet.size();
    const geometry::VecArray& p = at.mesh.position;
    at.sheet.resize(p.size());
    at.implicit.threads(work).for_chunks(
        p.size() - from, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
            const std::int64_t i = from + begin;
            at.sheets.active({p.x.data() + i, p.y.data() + i, p.z.data() + i, end - begin}, at.sheet.data() + i);
        });
}

// Handles vertices that are on another sheet than all their neighbours. Where two sheets nearly coincide, this happens
// by chance. If the sheets of all neighbours nearly coincide there, the vertex is assigned to the first of these
// sheets, and moves onto it.
void settle_alone(const base::Work& work, SheetMesh& at) {
    constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
    constexpr std::int32_t not_alone = -1;
    SurfaceMesh& mesh = at.mesh;
    // For each vertex, the first of the sheets of its neighbours.
    base::Array<std::int32_t> first(work.memory, mesh.vertices());
    std::fill(first.begin(), first.end(), none);
    const auto for_neighbours = [&](const auto& visit) {
        for (const std::int64_t e : work.over(mesh.corner.size())) {
            visit(start_of(mesh, e), end_of(mesh, e));
            visit(end_of(mesh, e), start_of(mesh, e));
        }
    };
    for_neighbours([&](std::int32_t vertex, std::int32_t other) {
        first[vertex] = at.sheet[vertex] == at.sheet[other] ? not_alone : std::min(first[vertex], at.sheet[other]);
    });
    for_neighbours([&](std::int32_t vertex, std::int32_t other) {
        if (first[vertex] == not_alone) return;
        const surface::SheetValue a = surface::sheet_at(at.sheets, first[vertex], mesh.position[vertex]);
        const surface::SheetValue b = surface::sheet_at(at.sheets, at.sheet[other], mesh.position[vertex]);
        const double slope = glm::length(b.gradient);
        if (!(std::abs(b.value) <= crease_tuning.alike * mesh.side * slope &&
              glm::distance(a.gradient / glm::length(a.gradient), b.gradient / slope) <= crease_tuning.alike))
            first[vertex] = not_alone;
    });
    for (std::int32_t vertex = 0; vertex < mesh.vertices(); ++vertex) {
        if (first[vertex] == not_alone || first[vertex] == none) continue;
        const surface::SheetValue to = surface::sheet_at(at.sheets, first[vertex], mesh.position[vertex]);
        mesh.position.set(vertex, mesh.position[vertex] - to.value / glm::dot(to.gradient, to.gradient) * to.gradient);
        mesh.gradient.set(vertex, to.gradient);
        at.sheet[vertex] = first[vertex];
    }
}

// Returns whether f equals the maximum or the minimum of the two sheets around the node, as at a crease. This is false
// where a third sheet covers the crease: f may then be 0 at the node but follow only one of the two sheets. In that
// case f has opposite signs on the two sides of the node, in the direction in which the sheets differ most. `far` is
// the distance from the node at which f is evaluated.
bool is_folded(const SheetMesh& in, const EdgeNode& node, double far) {
    const glm::dvec3 across = glm::normalize(node.gradient[0]) - glm::normalize(node.gradient[1]);
    // The sine of half the angle between the sheets. At a distance d from a fold, in the direction of `across`, |f| is
    // d times this sine.
    const double sine = 0.5 * glm::length(across);
    if (!(sine > crease_tuning.least_sine)) return true;
    const glm::dvec3 way = far / (2.0 * sine) * across;
    const auto off = [&](const glm::dvec3& place) {
        const surface::SheetValue f = in.value(place);
        return f.value / glm::length(f.gradient);
    };
    const double a = off(node.place.position + way);
    const double b = off(node.place.position - way);
    return !(a * b < 0.0 && std::min(std::abs(a), std::abs(b)) > 0.5 * sine * far);
}

// Searches for the place where the sheets meet. It starts at the point of the edge where the difference of the sheets
// is 0 by linear interpolation.
void examine_edge(const SheetMesh& in, EdgeNode& node) {
    const std::array<glm::dvec3, 2> place{in.mesh.position[node.ends[0]], in.mesh.position[node.ends[1]]};
    std::array<double, 2> off{}; // the signed distance of each end from the sheet of the other end
    node.alike = true;
    for (std::size_t k = 0; k < 2; ++k) {
        const surface::SheetValue other = surface::sheet_at(in.sheets, node.sheet[1 - k], place[k]);
        const double slope = glm::length(other.gradient);
        off[k] = other.value / slope;
        const double apart =
            std::max(std::abs(off[k]) / in.mesh.side,
                     glm::distance(glm::normalize(in.mesh.gradient[node.ends[k]]), other.gradient / slope));
        node.equal[k] = apart <= crease_tuning.equal;
        node.alike = node.alike && apart <= crease_tuning.alike;
    }
    double share = off[0] / (off[0] + off[1]);
    if (!(share > 0.0 && share < 1.0)) share = 0.5;
    const glm::dvec3 from = glm::mix(place[0], place[1], share);
    const surface::MeetingPlace found =
        in.meeting(node.ends, from, std::min(in.mesh.side, 2.0 * glm::distance(place[0], place[1])));
    node.place.position = found.found ? found.position : from;
    node.meet = found.found;
    node.gradient = {found.gradient[0], found.gradient[1]};
    const double away = found.found ? in.off_surface(found.position) : crease_tuning.beside_surface;
    node.place.exact = away <= crease_tuning.on_surface && is_folded(in, node, crease_tuning.on_surface * in.mesh.side);
    const double sine = 0.5 * glm::distance(glm::normalize(node.gradient[0]), glm::normalize(node.gradient[1]));
    // A fold slightly off the surface is tested at a distance where the exact place of the fold does not matter.
    node.near = !node.place.exact && away < crease_tuning.beside_surface && sine > crease_tuning.sharp_sine &&
                is_folded(in, node, 2.0 * crease_tuning.beside_surface / sine * in.mesh.side);
}

// Finds the nodes of edges. Nodes of unchanged edges with unchanged sheets are kept.
void find_edges(const base::Work& work, SheetMesh& in) {
    const auto by_ends = [](const EdgeNode& a, const EdgeNode& b) { return a.ends < b.ends; };
    base::Array<EdgeNode> before(work.memory);
    std::swap(in.edges, before);
    std::sort(before.begin(), before.end(), by_ends);
    base::Array<std::int32_t> fresh(work.memory);
    in.node.resize(in.mesh.corner.size());
    for (std::int64_t e = 0; e < in.mesh.corner.size(); ++e) {
        in.node[e] = -1;
        EdgeNode edge{};
        edge.ends = {start_of(in.mesh, e), end_of(in.mesh, e)};
        edge.sheet = {in.sheet[edge.ends[0]], in.sheet[edge.ends[1]]};
        if (!is_first(in.mesh, e) || edge.sheet[0] == edge.sheet[1]) continue;
        in.node[e] = static_cast<std::int32_t>(in.edges.size());
        const EdgeNode* const known = std::lower_bound(before.begin(), before.end(), edge, by_ends);
        if (known != before.end() && known->ends == edge.ends && known->sheet == edge.sheet)
            edge = *known;
        else
            fresh.push_back(in.node[e]);
        edge.edge = e;
        in.edges.push_back(edge);
    }
    for (std::int64_t i = 0; i < in.edges.size(); ++i)
        if (const std::int64_t other = opposite_of(in.mesh, in.edges[i].edge); other >= 0)
            in.node[other] = static_cast<std::int32_t>(i);
    in.implicit.threads(work).for_chunks(fresh.size(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) examine_edge(in, in.edges[fresh[i]]);
    });
}

// Where sheets coincide, any of them may be active. Assigns all vertices there to the first of these sheets. Returns
// whether a vertex changed.
bool settle_equal(SheetMesh& in) {
    bool changed = false;
    for (const EdgeNode& node : in.edges) {
        std::int32_t& start = in.sheet[node.ends[0]];
        std::int32_t& end = in.sheet[node.ends[1]];
        if (end < start && node.equal[0])
            start = end;
        else if (start < end && node.equal[1])
            end = start;
        else
            continue;
        changed = true;
    }
    return changed;
}

void find_corners(const base::Work& work, SheetMesh& in) {
    in.corners.clear();
    for (std::int64_t t = 0; t < in.mesh.triangles(); ++t)
        if (in.sheets_of(t) == 3) in.corners.push_back({t, {}, {}});
    in.implicit.threads(work).for_chunks(in.corners.size(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            CornerNode& node = in.corners[i];
            glm::dvec3 middle(0.0);
            for (std::int64_t e = 3 * node.triangle; e < 3 * node.triangle + 3; ++e)
                middle += in.edges[in.node[e]].place.position / 3.0;
            const surface::MeetingPlace found =
                in.meeting({in.mesh.corner.data() + 3 * node.triangle, 3}, middle, in.mesh.side);
            node.place.position = found.found ? found.position : middle;
            node.gradient = found.gradient;
            node.place.exact = found.found && in.off_surface(found.position) <= crease_tuning.on_surface;
        }
    });
}

// Halves edges whose sheets meet near the edge but off the surface, because another sheet lies between them. Also
// halves the longest edge of each triangle of three sheets that do not meet on the surface. Returns whether an edge was
// halved.
bool halve_unclear(const base::Work& work, SheetMesh& in) {
    base::Array<std::uint8_t> chosen(work.memory, in.mesh.corner.size());
    base::Array<std::int64_t> edges(work.memory);
    const auto add = [&](std::int64_t e) {
        e = in.edges[in.node[e]].edge;
        if (chosen[e] != 0 || in.length_of(e) < crease_tuning.shortest_edge * in.mesh.side) return;
        chosen[e] = 1;
        edges.push_back(e);
    };
    for (const EdgeNode& node : in.edges)
        if (!node.place.exact && !node.alike && node.meet) add(node.edge);
    for (const CornerNode& node : in.corners) {
        if (node.place.exact) continue;
        std::int64_t longest = 3 * node.triangle;
        for (std::int64_t e = longest; e < 3 * node.triangle + 3; ++e)
            if (in.length_of(e) > in.length_of(longest)) longest = e;
        add(longest);
    }
    if (!halve_edges(work, in.implicit, edges, 0.5, false, in.mesh)) return false;
    find_sheets(work, in);
    return true;
}

// Completes the nodes whose search failed. Such nodes stay where the search started, with the gradients of their sheets
// there. At a seam f blends two patches and differs slightly from both. There the crease between one patch and another
// sheet is accurate enough. Two sheets of a corner may be adjacent patches that nearly coincide at their seam and do
// not meet there. A crease reaches the seam on one patch and continues on the other. So the corner is where the third
// sheet meets one of the patches.
void place_rest(SheetMesh& in) {
    for (EdgeNode& node : in.edges) {
        if (node.place.exact) continue;
        node.place.exact = node.near;
        for (std::size_t k = 0; k < 2 && !node.near; ++k)
            node.gradient[k] = surface::sheet_at(in.sheets, node.sheet[k], node.place.position).gradient;
    }
    for (CornerNode& node : in.corners) {
        if (node.place.exact) continue;
        for (std::int64_t e = 3 * node.triangle; e < 3 * node.triangle + 3 && !node.place.exact; ++e) {
            const EdgeNode& beside = in.edges[in.node[e]];
            if (!beside.place.exact) continue;
            const surface::MeetingPlace found = in.meeting(beside.ends, node.place.position, in.mesh.side);
            node.place.exact = found.found && in.off_surface(found.position) < crease_tuning.beside_surface;
            if (node.place.exact) node.place.position = found.position;
        }
        for (std::size_t k = 0; k < 3; ++k)
            node.gradient[k] =
                surface::sheet_at(in.sheets, in.sheet_at(3 * node.triangle + static_cast<std::int64_t>(k)),
                                  node.place.position)
                    .gradient;
    }
}

// Makes chains. Open chains start at corners and at the border; all other chains are closed.
void find_chains(const SheetMesh& in, CreaseChains& chains) {
    const SurfaceMesh& mesh = in.mesh;
    // A flag for each edge that a chain has passed.
    base::Array<std::uint8_t> taken(chains.first.memory(), mesh.corner.size());
    const auto put = [&](std::int64_t edge) { chains.point.push_back(in.edges[in.node[edge]].place); };
    const auto end = [&](std::int32_t left, std::int32_t right, bool closed) {
        chains.end(closed);
        chains.left.push_back(left);
        chains.right.push_back(right);
    };
    // Follows a chain into the triangle of an edge and onwards. The sheet of the edge's start is on the left.
    const auto follow = [&](std::int64_t entered) {
        bool closed = false;
        for (std::int64_t e = entered; e >= 0 && taken[e] == 0;) {
            put(e);
            taken[e] = 1;
            if (const CornerNode* const corner = in.corner_of(e / 3)) {
                chains.point.push_back(corner->place);
                break;
            }
            std::int64_t exit = next_in_triangle(e);
            if (in.node[exit] < 0) exit = next_in_triangle(exit);
            taken[exit] = 1;
            e = opposite_of(mesh, exit);
            if (e < 0) put(exit);
            closed = e == entered;
        }
        end(in.sheet_at(entered), in.sheet_at(next_in_triangle(entered)), closed);
    };
    for (const CornerNode& corner : in.corners)
        for (std::int64_t e = 3 * corner.triangle; e < 3 * corner.triangle + 3; ++e) {
            if (taken[e] != 0) continue;
            taken[e] = 1;
            chains.point.push_back(corner.place);
            if (const std::int64_t next = opposite_of(mesh, e); next >= 0) {
                follow(next);
                continue;
            }
            put(e); // a chain of two nodes, with left and right exchanged
            end(in.sheet_at(next_in_triangle(e)), in.sheet_at(e), false);
        }
    for (const bool border : {true, false})
        for (const EdgeNode& node : in.edges)
            if (taken[node.edge] == 0 && (mesh.neighbour[node.edge] < 0) == border) follow(node.edge);
}

void build(const base::Work& work, SheetMesh& in, SharpMesh& out) {
    SurfaceMesh& to = out.mesh;
    to.region = in.mesh.region;
    to.domain = in.mesh.domain;
    to.side = in.mesh.side;
    to.unresolved = in.mesh.unresolved;
    to.missed_seeds = in.mesh.missed_seeds;
    std::swap(to.position, in.mesh.position);
    std::swap(to.gradient, in.mesh.gradient);
    const auto add_vertices = [&](const auto& nodes) { // adds one vertex for each pair of a node and one of its sheets
        const auto first = static_cast<std::int32_t>(to.vertices());
        for (const auto& node : nodes)
            for (const glm::dvec3& gradient : node.gradient) {
                to.position.push_back(node.place.position);
                to.gradient.push_back(gradient);
            }
        return first;
    };
    const std::int32_t first_of_edges = add_vertices(in.edges);
    const std::int32_t first_of_corners = add_vertices(in.corners);
    // Returns the vertex of an edge's node for the sheet of the edge's start or end.
    const auto vertex_of = [&](std::int64_t edge, bool at_start) {
        const bool first = in.edges[in.node[edge]].edge == edge;
        return first_of_edges + 2 * in.node[edge] + (first == at_start ? 0 : 1);
    };
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t sheet) {
        for (const std::int32_t vertex : {a, b, c}) to.corner.push_back(vertex);
        out.sheet.push_back(sheet);
    };
    const auto add_quad = [&](const std::array<std::int32_t, 4>& vertex, std::int32_t sheet) {
        add(vertex[0], vertex[1], vertex[2], sheet);
        add(vertex[0], vertex[2], vertex[3], sheet);
    };
    std::int32_t corner = first_of_corners;
    for (const std::int64_t t : work.over(in.mesh.triangles())) {
        const auto edge = [&](std::int64_t k) { return 3 * t + k % 3; };
        const auto at = [&](std::int64_t k) { return in.mesh.corner[edge(k)]; };
        const int count = in.sheets_of(t);
        if (count == 1) {
            add(at(0), at(1), at(2), in.sheet[at(0)]);
            to.turned += is_turned(to, to.triangles() - 1) ? 1 : 0; // cut triangles that are slivers do not count
        } else if (count == 2) {
            std::int64_t k = 0; // the index of the corner whose sheet differs from the other two
            while (in.sheet[at(k)] == in.sheet[at(k + 1)] || in.sheet[at(k)] == in.sheet[at(k + 2)]) ++k;
            add(at(k), vertex_of(edge(k), true), vertex_of(edge(k + 2), false), in.sheet[at(k)]);
            add_quad({vertex_of(edge(k), false), at(k + 1), at(k + 2), vertex_of(edge(k + 2), true)},
                     in.sheet[at(k + 1)]);
        } else {
            for (std::int64_t k = 0; k < 3; ++k)
                add_quad({at(k), vertex_of(edge(k), true), corner++, vertex_of(edge(k + 2), false)}, in.sheet[at(k)]);
        }
    }
    HRBFNPR_ASSERT(corner == static_cast<std::int32_t>(to.vertices()));
    to.neighbour = find_neighbours(work, to.corner, to.vertices());
}

// ---- Curves

constexpr std::int64_t crease_points_a_task = 16;
constexpr int crease_rounds = 8; // pieces are halved at most this many times

CurvePoint as_curve_point(const CreasePoint& p) noexcept {
    CurvePoint point;
    point.position = p.position;
    point.gradient = glm::normalize(p.left - glm::dot(p.left, p.tangent) * p.tangent);
    point.level_gradient = glm::cross(p.tangent, point.gradient);
    return point;
}

void set_normals(const implicit::Sheets& sheets, const Creases& creases, std::int64_t crease, CreasePoint& p) {
    p.left = glm::normalize(surface::sheet_at(sheets, creases.left[crease], p.position).gradient);
    p.right = glm::normalize(surface::sheet_at(sheets, creases.right[crease], p.position).gradient);
}

// Ends a crease: makes it of the points added since the last crease, unless it is too short.
void end_crease(Creases& creases, bool closed, std::int32_t left, std::int32_t right, double side) {
    const std::int64_t first = creases.first.back();
    double length = 0.0;
    for (std::int64_t i = first + 1; i < creases.point.size(); ++i)
        length += glm::distance(creases.point[i - 1].position, creases.point[i].position);
    if (creases.point.size() - first < (closed ? 3 : 2) || !(length > crease_tuning.shortest_piece * side))
        return creases.point.resize(first);
    creases.end(closed);
    creases.left.push_back(left);
    creases.right.push_back(right);
}

void add_chain(const CreaseChains& chains, std::int64_t chain, double side, Creases& creases) {
    const std::int64_t count = chains.size_of(chain);
    const CreaseNode* const node = chains.point.data() + chains.first[chain];
    const double nearest = crease_tuning.nearest_node * side;
    const auto exact = [&](std::int64_t i) { return node[i].exact; };
    for_parts(count, chains.closed[chain] != 0, exact, [&](std::int64_t begin, std::int64_t end, bool whole) {
        const std::int64_t first = creases.first.back();
        const auto crowds = [&](std::int64_t i, const glm::dvec3& place) {
            return glm::distance(creases.point[i].position, place) < nearest;
        };
        // Narrow gaps are bridged. A crease continues across them.
        if (creases.point.size() > first && !crowds(creases.point.size() - 1, node[begin % count].position))
            end_crease(creases, false, chains.left[chain], chains.right[chain], side);
        const std::int64_t start = creases.first.back();
        for (std::int64_t i = begin; i < end; ++i) {
            CreasePoint p;
            p.position = node[i % count].position;
            const bool last = i + 1 == end && !whole;
            const std::int64_t size = creases.point.size();
            if (!last && size > start && crowds(size - 1, p.position)) continue;
            if (whole && size > start + 2 && crowds(start, p.position)) continue;
            if (size > start && creases.point.back().position == p.position) continue;
            creases.point.push_back(p);
        }
        if (whole) end_crease(creases, true, chains.left[chain], chains.right[chain], side);
    });
    end_crease(creases, false, chains.left[chain], chains.right[chain], side);
}

// Returns whether the path from a through p to b reverses at p: one of its two steps goes forwards along the crease,
// and the other backwards.
bool turns_back(const CreasePoint& a, const CreasePoint& p, const CreasePoint& b) noexcept {
    const glm::dvec3 along = glm::cross(p.left, p.right);
    const double size = glm::length(along);
    if (!(size > crease_tuning.least_crease_sine)) return false;
    const double in = glm::dot(along, glm::normalize(p.position - a.position)) / size;
    const double out = glm::dot(along, glm::normalize(b.position - p.position)) / size;
    return in * out < 0.0 && std::min(std::abs(in), std::abs(out)) > crease_tuning.returns;
}

// Drops nodes that are out of order along a crease. Near a corner this happens because Newton's steps move nodes along
// the crease.
Creases drop_returns(const Creases& found, double side) {
    Creases kept(found.first.memory());
    for (std::int64_t c = 0; c < found.count(); ++c) {
        const std::int64_t first = kept.point.size();
        for (std::int64_t i = found.first[c]; i < found.first[c + 1]; ++i) {
            const CreasePoint& p = found.point[i];
            while (kept.point.size() >= first + 2 &&
                   turns_back(kept.point[kept.point.size() - 2], kept.point.back(), p))
                kept.point.resize(kept.point.size() - 1);
            if (kept.point.size() == first || kept.point.back().position != p.position) kept.point.push_back(p);
        }
        end_crease(kept, found.closed[c] != 0, found.left[c], found.right[c], side);
    }
    return kept;
}

void find_tangents(Creases& creases) {
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        const std::int64_t count = creases.size_of(c);
        const bool closed = creases.closed[c] != 0;
        CreasePoint* const point = creases.point.data() + creases.first[c];
        const auto at = [&](std::int64_t i) {
            return point[closed ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1)].position;
        };
        for (std::int64_t i = 0; i < count; ++i) {
            CreasePoint& p = point[i];
            const glm::dvec3 along = tangent_between(at(i) - at(i - 1), at(i + 1) - at(i));
            const glm::dvec3 cross = glm::cross(p.left, p.right);
            p.tangent = glm::length(cross) > crease_tuning.least_crease_sine
                            ? glm::normalize(glm::dot(cross, along) < 0.0 ? -cross : cross)
                            : glm::normalize(along);
        }
    }
}

// Returns the parameter along a piece at which n . v is 0, where n is the normal of a sheet and v is the line of sight.
// `from` and `to` are the values of n . v at the two ends of the piece.
double turn_of(const implicit::Sheets& sheets, std::int32_t sheet, const CubicPiece& piece, double from, double to,
               const View& view) {
    Illinois root(from, to);
    for (int step = 0; step < curve_tuning.most_steps && !root.done(curve_tuning.exact); ++step) {
        const glm::dvec3 place = piece.at(root.trial);
        const glm::dvec3 gradient = surface::sheet_at(sheets, sheet, place).gradient;
        root.take(glm::dot(gradient, view.sight(place)) / glm::length(gradient));
    }
    return std::clamp(root.trial, root.low, root.high);
}

// Returns the points of a crease, with additional points where a sheet turns towards the eye or away from it.
base::Array<CreasePoint> path_of(base::Memory& memory, const implicit::Sheets& sheets, const Creases& creases,
                                 std::int64_t crease, const View& view) {
    base::Array<CreasePoint> path(memory);
    for (std::int64_t i = creases.first[crease]; i < creases.first[crease + 1]; ++i) {
        const CreasePoint& p = creases.point[i];
        path.push_back(p);
        const std::int64_t j = creases.next(crease, i);
        if (j < 0) continue;
        const CreasePoint& q = creases.point[j];
        const CubicPiece piece(as_curve_point(p), as_curve_point(q));
        std::array<double, 2> share{};
        std::size_t count = 0;
        for (const bool left : {true, false}) {
            const double from = glm::dot(left ? p.left : p.right, view.sight(p.position));
            const double to = glm::dot(left ? q.left : q.right, view.sight(q.position));
            if ((from < 0.0) == (to < 0.0)) continue;
            const double at =
                turn_of(sheets, left ? creases.left[crease] : creases.right[crease], piece, from, to, view);
            if (at > curve_tuning.at_point && at < 1.0 - curve_tuning.at_point) share[count++] = at;
        }
        if (count == 2 && share[1] < share[0]) std::swap(share[0], share[1]);
        for (std::size_t k = 0; k < count; ++k) {
            CreasePoint turn;
            turn.position = piece.at(share[k]);
            turn.tangent = glm::normalize(piece.derivative(share[k]));
            set_normals(sheets, creases, crease, turn);
            path.push_back(turn);
        }
    }
    return path;
}

void add_parts(const base::Array<CreasePoint>& path, bool closed, const AngleRange& angles, const View& view,
               CreaseParts& parts) {
    const std::int64_t size = path.size();
    HRBFNPR_ASSERT(size >= 2);
    // Tells which of the two sheets face the eye between point k and the next point. The test is made midway between
    // the two points, because a sheet may be just turning away at a point.
    struct Facing {
        bool left, right;
        bool operator==(const Facing&) const = default;
    };
    const auto facing_after = [&](std::int64_t k) {
        const CreasePoint& a = path[k % size];
        const CreasePoint& b = path[(k + 1) % size];
        const glm::dvec3 sight = view.sight(0.5 * (a.position + b.position));
        return Facing{glm::dot(a.left + b.left, sight) < 0.0, glm::dot(a.right + b.right, sight) < 0.0};
    };
    const auto joined = [&](std::int64_t k) { return facing_after(k) == facing_after(k + 1); };
    for_joined(closed ? size : size - 1, closed, joined, [&](std::int64_t begin, std::int64_t end, bool whole) {
        const Facing facing = facing_after(begin);
        const bool fold = facing.left != facing.right;
        const bool backwards = fold && facing.right;
        SurfaceLines& to = fold ? parts.folds : facing.left ? parts.outside : parts.inside;
        base::Array<AngleRange>& of = facing.left ? parts.of_outside : parts.of_inside;
        LineBuilder builder(to, true);
        const std::int64_t last = whole ? end - 1 : end;
        for (std::int64_t k = begin; k <= last; ++k) {
            const CreasePoint& p = path[(backwards ? last - (k - begin) : k) % size];
            const glm::dvec3 normal = !fold ? p.left + p.right : facing.left ? p.left : p.right;
            builder.add(p.position, normal, p.angle(), backwards ? -p.tangent : p.tangent);
        }
        builder.end(whole);
        if (!fold && of.size() < to.curves.count()) of.push_back(angles);
    });
}

// ---- Sheets

// The domain of one sheet of a whole surface: the places where this sheet is active.
class SheetDomain final : public implicit::Domain {
public:
    // `creases` are places along the creases of all sheets, at most a mesh side apart. A sheet may end near any crease.
    // A curve that leaves a sheet may reach another sheet with the same function, for example where two cylinders have
    // the same axis. `own` has the triangles of the sheet, and must outlive this object. `base` is the domain of the
    // whole surface, or null.
    SheetDomain(const implicit::Implicit& whole, std::int32_t sheet, std::shared_ptr<const geometry::PointGrid> creases,
                const SurfaceMesh& own, const implicit::Domain* base)
        : whole_(whole), sheet_(sheet), own_(own), creases_(std::move(creases)),
          vertices_(own.position, curve_tuning.vertex_reach * own.side), base_(base) {
        HRBFNPR_ASSERT(whole.sheets() != nullptr && sheet >= 0 && sheet < whole.sheets()->count());
    }

    [[nodiscard]] bool near_end(const glm::dvec3& place) const noexcept override {
        return (base_ != nullptr && base_->near_end(place)) || creases_->any_around(place);
    }
    // If another sheet is active at the place, returns the distance between the place and the whole surface. If this
    // distance is 0, returns the side of a mesh cell instead. The exception is a place near a vertex of this sheet: two
    // equal sheets may coincide there, and either of them may be active.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
        const double on_surface = curve_tuning.on_sheet * own_.side;
        if (surface::active_at(*whole_.sheets(), place) != sheet_) {
            double value = 0.0;
            glm::dvec3 slope(0.0);
            whole_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&slope.x, &slope.y, &slope.z}, {}});
            const double off = std::abs(value) / glm::length(slope);
            if (!(off <= on_surface)) return off;
            bool is_own = false;
            vertices_.around(place, [&](std::int64_t at) {
                const glm::dvec3 vertex = own_.position[vertices_.index(at)];
                is_own = is_own || glm::distance(vertex, place) <= curve_tuning.vertex_reach * own_.side;
            });
            if (!is_own) return own_.side;
        }
        return base_ != nullptr && base_->near_end(place) ? base_->beyond(place, gradient) : -on_surface;
    }

private:
    const implicit::Implicit& whole_;
    std::int32_t sheet_;
    const SurfaceMesh& own_;
    std::shared_ptr<const geometry::PointGrid> creases_;
    geometry::PointGrid vertices_;
    const implicit::Domain* base_;
};

} // namespace

SharpMesh split_at_creases(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh mesh) {
    HRBFNPR_ASSERT(implicit.sheets() != nullptr && mesh.side > 0.0);
    const base::Work standing = work.without_progress();
    SheetMesh in(work.memory, implicit, std::move(mesh));
    find_sheets(standing, in);
    for (int round = 0;; ++round) {
        settle_alone(standing, in);
        find_edges(standing, in);
        for (int i = 0; i < crease_tuning.settlings && settle_equal(in); ++i) find_edges(standing, in);
        find_corners(standing, in);
        if (round == crease_tuning.rounds || !halve_unclear(standing, in)) break;
    }
    place_rest(in);
    SharpMesh out(work.memory);
    find_chains(in, out.creases);
    build(work, in, out);
    return out;
}

base::List<std::unique_ptr<SheetSurface>> sheet_surfaces(const base::Runtime& runtime, const implicit::Implicit& whole,
                                                         const SharpMesh& mesh) {
    base::List<std::unique_ptr<SheetSurface>> parts(runtime.memory);
    const implicit::Sheets* const all = whole.sheets();
    if (all == nullptr) return parts;
    const std::int32_t sheets = all->count();
    // The triangles of sheet s are order[begin[s]] to order[begin[s + 1] - 1].
    base::Array<std::int64_t> begin(runtime.memory, sheets + 2), order(runtime.memory, mesh.sheet.size());
    for (const std::int32_t sheet : mesh.sheet) ++begin[sheet + 2];
    for (std::int64_t s = 2; s < begin.size(); ++s) begin[s] += begin[s - 1];
    for (std::int64_t t = 0; t < mesh.sheet.size(); ++t) order[begin[mesh.sheet[t] + 1]++] = t;
    // For each vertex: 1 + its index in the part, or 0 if it is not in the part.
    base::Array<std::int32_t> number(runtime.memory, mesh.mesh.vertices());
    geometry::VecArray creases(runtime.memory);
    for (std::int32_t sheet = 0; sheet < sheets; ++sheet) {
        if (begin[sheet] == begin[sheet + 1]) continue;
        SheetSurface& part = *parts.add(std::make_unique<SheetSurface>(runtime.memory, whole, *all, sheet));
        base::Array<std::int32_t> used(runtime.memory);
        for (std::int64_t k = begin[sheet]; k < begin[sheet + 1]; ++k)
            for (std::int64_t i = 3 * order[k]; i < 3 * order[k] + 3; ++i) {
                const std::int32_t vertex = mesh.mesh.corner[i];
                if (number[vertex] == 0) {
                    part.mesh.position.push_back(mesh.mesh.position[vertex]);
                    part.mesh.gradient.push_back(mesh.mesh.gradient[vertex]);
                    number[vertex] = static_cast<std::int32_t>(part.mesh.vertices());
                    used.push_back(vertex);
                }
                part.mesh.corner.push_back(number[vertex] - 1);
            }
        for (const std::int32_t vertex : used) number[vertex] = 0;
        part.mesh.neighbour = find_neighbours(runtime, part.mesh.corner, part.mesh.vertices());
        part.mesh.region = mesh.mesh.region;
        part.mesh.side = mesh.mesh.side;
        for (std::int64_t e = 0; e < part.mesh.corner.size(); ++e)
            if (part.mesh.neighbour[e] < 0) creases.push_back(part.mesh.position[part.mesh.corner[e]]);
    }
    const auto grid = std::make_shared<const geometry::PointGrid>(creases, curve_tuning.border_reach * mesh.mesh.side);
    for (const std::unique_ptr<SheetSurface>& part : parts) {
        part->domain = std::make_unique<SheetDomain>(whole, part->sheet, grid, part->mesh, mesh.mesh.domain);
        part->mesh.domain = part->domain.get();
    }
    return parts;
}

double CreasePoint::angle() const noexcept {
    const glm::dvec3 cross = glm::cross(left, right);
    const double size = 180.0 / std::numbers::pi * std::atan2(glm::length(cross), glm::dot(left, right));
    return glm::dot(cross, tangent) < 0.0 ? -size : size;
}

Creases trace_creases(const base::Work& work, const implicit::Implicit& implicit, const CreaseChains& chains,
                      double side) {
    HRBFNPR_ASSERT(side > 0.0 && chains.left.size() == chains.count() && chains.right.size() == chains.count());
    const implicit::Sheets& sheets = *implicit.sheets();
    const base::Work threads = implicit.threads(work);
    Creases creases(work.memory);
    for (std::int64_t c = 0; c < chains.count(); ++c) add_chain(chains, c, side, creases);
    threads.for_each(creases.count(), [&](std::int64_t c) {
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i)
            set_normals(sheets, creases, c, creases.point[i]);
    });
    creases = drop_returns(creases, side);
    const auto wanted = [&](std::int64_t, std::int64_t i, std::int64_t j, CreasePoint& p) {
        const CreasePoint& a = creases.point[i];
        const CreasePoint& b = creases.point[j];
        const double length = glm::distance(a.position, b.position) / side;
        const glm::dvec3 chord = (b.position - a.position) / (length * side);
        const bool turns =
            std::min(glm::dot(a.tangent, chord), glm::dot(b.tangent, chord)) < crease_tuning.straight_turn;
        p.position = CubicPiece(as_curve_point(a), as_curve_point(b)).at(0.5);
        return length > crease_tuning.longest_piece || (turns && length > crease_tuning.shortest_piece);
    };
    const auto bring = [&](base::Array<CreasePoint>& added, const base::Array<std::int64_t>& of, const auto&) {
        base::Array<std::uint8_t> found(work.memory, added.size());
        threads.for_chunks(added.size(), crease_points_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = begin; k < end; ++k) {
                surface::Meeting meeting;
                meeting.add(creases.left[of[k]]);
                meeting.add(creases.right[of[k]]);
                const surface::MeetingPlace at =
                    surface::find_meeting(sheets, meeting, added[k].position, 1e-9 * side, 0.5 * side);
                found[k] = at.found ? 1 : 0;
                if (!at.found) continue;
                added[k].position = at.position;
                added[k].left = glm::normalize(at.gradient[0]);
                added[k].right = glm::normalize(at.gradient[1]);
            }
        });
        return found;
    };
    bool changed = true;
    for (int round = 0; changed; ++round) {
        find_tangents(creases);
        changed = round < crease_rounds && halve_pieces(creases, wanted, bring);
    }
    return creases;
}

NearCreases::NearCreases(base::Memory& memory, const Creases& creases, double least, double side)
    : most_(crease_tuning.farthest_beside * side), from_(memory), to_(memory) {
    HRBFNPR_ASSERT(side > 0.0);
    geometry::VecArray middle(memory);
    const auto sharp = [&](std::int64_t i) { return std::abs(creases.point[i].angle()) >= least; };
    for (std::int64_t c = 0; c < creases.count(); ++c)
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const std::int64_t j = creases.next(c, i);
            if (j < 0 || !sharp(i) || !sharp(j)) continue;
            from_.push_back(creases.point[i].position);
            to_.push_back(creases.point[j].position);
            middle.push_back(0.5 * (creases.point[i].position + creases.point[j].position));
        }
    grid_.emplace(middle, 0.5 * crease_tuning.longest_piece * side + most_);
}

bool NearCreases::has(const glm::dvec3& place, double reach) const noexcept {
    bool found = false;
    grid_->around(place, [&](std::int64_t at) {
        const std::int64_t i = grid_->index(at);
        found = found || geometry::distance_to_segment(place, from_[i], to_[i]) <= std::min(reach, most_);
    });
    return found;
}

CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                          const View& view) {
    CreaseParts parts(runtime.memory);
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        AngleRange angles;
        for (std::int64_t i = creases.first[c]; i < creases.first[c + 1]; ++i) {
            const auto angle = static_cast<float>(creases.point[i].angle());
            angles = {std::min(angles.least, angle), std::max(angles.most, angle)};
        }
        add_parts(path_of(runtime.memory, sheets, creases, c, view), creases.closed[c] != 0, angles, view, parts);
    }
    return parts;
}

SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines, const base::Array<AngleRange>& of,
                        CreaseSide side, double lower, double upper) {
    const Curves& curves = lines.curves;
    HRBFNPR_ASSERT(of.size() == curves.count());
    // The lines whose creases bend by at least `upper` degrees somewhere. Angles are positive if a crease bends to
    // `side`.
    SurfaceLines bent(memory);
    LineBuilder builder(bent, true);
    base::Array<double> above(memory);
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        if (static_cast<double>(std::max(angle_on(side, of[c].least), angle_on(side, of[c].most))) < upper) continue;
        for (std::int64_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const auto angle = static_cast<double>(angle_on(side, lines.strength[i]));
            builder.add(curves.point[i].position, curves.point[i].gradient, angle, curves.point[i].direction());
        }
        builder.end(curves.closed[c] != 0);
    }
    for (const float angle : bent.strength) above.push_back(static_cast<double>(angle) - lower);
    return parts_where(bent, above, false, true);
}

} // namespace hrbfnpr::curves
