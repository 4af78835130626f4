// SPDX-License-Identifier: MIT
// split_at_creases makes the mesh:
// 1. find_sheets finds the sheet of each vertex.
// 2. settle_alone and settle_equal assign vertices where sheets nearly coincide to the first of these sheets.
// 3. find_edges finds where the sheets of an edge's ends meet; update_edges finds it again where settle_equal changed
//    sheets; find_corners does the same in triangles of three sheets.
// 4. halve_unclear halves edges where another sheet covers the crease; then steps 2 to 4 are repeated.
// 5. place_rest places the remaining nodes near the surface.
// 6. find_chains makes chains of the nodes of creases.
// 7. build cuts triangles at the nodes.
#include "base/list.h"
#include "creases/creases.h"
#include "creases/tuning.h"
#include "curves/mesh_edges.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// The number of nodes that are examined together.
constexpr std::int64_t nodes_a_task = 64;
template <class T>
using OfNodes = std::array<T, static_cast<std::size_t>(nodes_a_task)>;
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
    [[nodiscard]] surface::MeetingSearch search(std::span<const std::int32_t> vertices, const glm::dvec3& from,
                                                double reach) const noexcept {
        surface::Meeting all;
        for (const std::int32_t vertex : vertices) all.add(sheet[vertex]);
        return {all, from, crease_tuning.farthest_meeting * reach};
    }
    void find_meetings(std::span<const surface::MeetingSearch> searches, surface::MeetingPlace* places) const {
        surface::find_meetings(sheets, searches, meeting_tolerance * mesh.side, places);
    }
};

// The whole function at up to two places for each node.
struct WholeValues {
    void add(const glm::dvec3& place) noexcept {
        HRBFNPR_ASSERT(count < std::int64_t(2 * nodes_a_task));
        for (int c = 0; c < 3; ++c) at[c][count] = place[c];
        ++count;
    }
    void evaluate(const implicit::Implicit& implicit) {
        if (count > 0)
            implicit.evaluate({at[0], at[1], at[2], count}, {value, {gradient[0], gradient[1], gradient[2]}, {}});
    }
    [[nodiscard]] double slope(std::int64_t k) const noexcept {
        return glm::length(glm::dvec3(gradient[0][k], gradient[1][k], gradient[2][k]));
    }
    // Returns the distance between a place and the whole surface, in sides.
    [[nodiscard]] double off_surface(std::int64_t k, double side) const noexcept {
        return std::abs(value[k]) / (side * slope(k));
    }

    std::int64_t count = 0;
    double at[3][2 * nodes_a_task];
    double value[2 * nodes_a_task];
    double gradient[3][2 * nodes_a_task];
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

// A node, and the distance from it at which f is evaluated to test it.
struct FoldTest {
    const EdgeNode* node;
    double far;
};

// Tells for each node whether f equals the maximum or the minimum of its two sheets around it, as at a crease. This is
// false where a third sheet covers the crease: f may then be 0 at the node but follow only one of the two sheets. In
// that case f has opposite signs on the two sides of the node, in the direction in which the sheets differ most.
void find_folds(const SheetMesh& in, std::span<const FoldTest> tests, bool* is_folded) {
    HRBFNPR_ASSERT(std::int64_t(tests.size()) <= nodes_a_task);
    OfNodes<double> sine; // the sine of half the angle between the sheets
    WholeValues f;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const EdgeNode& node = *tests[i].node;
        const glm::dvec3 across = glm::normalize(node.gradient[0]) - glm::normalize(node.gradient[1]);
        sine[i] = 0.5 * glm::length(across);
        if (!(sine[i] > crease_tuning.least_sine)) continue;
        const glm::dvec3 way = tests[i].far / (2.0 * sine[i]) * across;
        f.add(node.place.position + way);
        f.add(node.place.position - way);
    }
    f.evaluate(in.implicit);
    std::int64_t k = 0;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        is_folded[i] = true;
        if (!(sine[i] > crease_tuning.least_sine)) continue;
        const double a = f.value[k] / f.slope(k);
        const double b = f.value[k + 1] / f.slope(k + 1);
        k += 2;
        // At a distance d from a fold, in the direction of `across`, |f| is d times the sine.
        is_folded[i] = !(a * b < 0.0 && std::min(std::abs(a), std::abs(b)) > 0.5 * sine[i] * tests[i].far);
    }
}

// Compares the sheets of each edge's ends, and starts a search for the place where they meet: at the point of the edge
// where the difference of the sheets is 0 by linear interpolation.
void compare_sheets(const SheetMesh& in, std::span<EdgeNode* const> nodes, surface::MeetingSearch* searches) {
    OfNodes<std::array<surface::SheetRequest, 2>> requests;
    OfNodes<std::array<surface::SheetValue, 2>> values;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)
            requests[i][k] = {nodes[i]->sheet[1 - k], in.mesh.position[nodes[i]->ends[k]]};
    surface::sheets_at(in.sheets, {requests[0].data(), 2 * nodes.size()}, values[0].data());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EdgeNode& node = *nodes[i];
        std::array<double, 2> off{}; // the signed distance of each end from the sheet of the other end
        node.alike = true;
        for (std::size_t k = 0; k < 2; ++k) {
            const surface::SheetValue& other = values[i][k];
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
        const glm::dvec3 a = requests[i][0].place;
        const glm::dvec3 b = requests[i][1].place;
        searches[i] = in.search(node.ends, glm::mix(a, b, share), std::min(in.mesh.side, 2.0 * glm::distance(a, b)));
    }
}

// Searches for the places where the sheets of edges meet, and classifies these places.
void examine_edges(const SheetMesh& in, std::span<EdgeNode* const> nodes) {
    HRBFNPR_ASSERT(std::int64_t(nodes.size()) <= nodes_a_task);
    OfNodes<surface::MeetingSearch> searches;
    OfNodes<surface::MeetingPlace> found;
    compare_sheets(in, nodes, searches.data());
    in.find_meetings(std::span(searches).first(nodes.size()), found.data());
    WholeValues f;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EdgeNode& node = *nodes[i];
        node.meet = found[i].found;
        node.place.position = node.meet ? found[i].position : searches[i].from;
        node.gradient = {found[i].gradient[0], found[i].gradient[1]};
        if (node.meet) f.add(node.place.position);
    }
    f.evaluate(in.implicit);
    OfNodes<double> away; // the distances of the nodes from the whole surface, in sides
    std::int64_t next = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        away[i] = nodes[i]->meet ? f.off_surface(next++, in.mesh.side) : crease_tuning.beside_surface;
    // Tests the nodes for which far() returns a distance above 0.
    const auto test = [&](const auto& far, const auto& set) {
        OfNodes<FoldTest> tests;
        OfNodes<std::size_t> which;
        OfNodes<bool> is_folded;
        std::size_t count = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double distance = far(i);
            if (!(distance > 0.0)) continue;
            which[count] = i;
            tests[count++] = {nodes[i], distance};
        }
        find_folds(in, std::span(tests).first(count), is_folded.data());
        for (std::size_t k = 0; k < count; ++k) set(*nodes[which[k]], is_folded[k]);
    };
    test(
        [&](std::size_t i) {
            return away[i] <= crease_tuning.on_surface ? crease_tuning.on_surface * in.mesh.side : 0.0;
        },
        [](EdgeNode& node, bool is_folded) { node.place.exact = is_folded; });
    // A fold slightly off the surface is tested at a distance where the exact place of the fold does not matter.
    test(
        [&](std::size_t i) {
            const auto& gradient = nodes[i]->gradient;
            const double sine = 0.5 * glm::distance(glm::normalize(gradient[0]), glm::normalize(gradient[1]));
            const bool may_be =
                !nodes[i]->place.exact && away[i] < crease_tuning.beside_surface && sine > crease_tuning.sharp_sine;
            return may_be ? 2.0 * crease_tuning.beside_surface / sine * in.mesh.side : 0.0;
        },
        [](EdgeNode& node, bool is_folded) { node.near = is_folded; });
}

// The half-edges that start at each vertex.
struct EdgesAtVertices {
    EdgesAtVertices(base::Memory& memory, const SurfaceMesh& mesh)
        : begin(memory, mesh.vertices() + 2), edge(memory, mesh.corner.size()) {
        for (const std::int32_t vertex : mesh.corner) ++begin[vertex + 2];
        for (std::int64_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
        for (std::int64_t e = 0; e < mesh.corner.size(); ++e) edge[begin[mesh.corner[e] + 1]++] = e;
    }

    base::Array<std::int64_t> begin; // for each vertex, where its list in `edge` begins
    base::Array<std::int64_t> edge;
};

// Returns whether this is the first half-edge of an edge whose ends belong to different sheets.
bool is_crossed(const SheetMesh& in, std::int64_t edge) noexcept {
    return is_first(in.mesh, edge) && in.sheet_at(edge) != in.sheet_at(next_in_triangle(edge));
}

// Returns all half-edges for which is_crossed() holds, in ascending order.
base::Array<std::int64_t> crossed_edges(const base::Work& work, const SheetMesh& in) {
    constexpr std::int64_t edges_a_task = 32768;
    const std::int64_t edges = in.mesh.corner.size();
    base::List<base::Array<std::int64_t>> found(work.memory); // the edges found by each task
    for (std::int64_t e = 0; e < edges; e += edges_a_task) found.add(work.memory);
    work.for_chunks(edges, edges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t e = begin; e < end; ++e)
            if (is_crossed(in, e)) found[begin / edges_a_task].push_back(e);
    });
    base::Array<std::int64_t> all(work.memory);
    for (const base::Array<std::int64_t>& some : found)
        for (const std::int64_t e : some) all.push_back(e);
    return all;
}

// Makes the nodes of the given edges, in their order. known[i] is the number of the node that edge i had before, or -1.
// The node is kept if the sheets of the edge's ends are the same as before.
void make_nodes(const base::Work& work, const base::Array<std::int64_t>& crossed,
                const base::Array<std::int32_t>& known, SheetMesh& in) {
    HRBFNPR_ASSERT(known.size() == crossed.size() && in.node.size() == in.mesh.corner.size());
    base::Array<EdgeNode> before(work.memory);
    std::swap(in.edges, before);
    in.edges.resize_for_overwrite(crossed.size());
    base::Array<std::int32_t> fresh(work.memory);
    for (std::int64_t i = 0; i < crossed.size(); ++i) {
        const std::int64_t e = crossed[i];
        const std::array<std::int32_t, 2> sheet{in.sheet_at(e), in.sheet_at(next_in_triangle(e))};
        if (known[i] >= 0 && before[known[i]].sheet == sheet) {
            in.edges[i] = before[known[i]];
        } else {
            in.edges[i] = EdgeNode{};
            in.edges[i].ends = {start_of(in.mesh, e), end_of(in.mesh, e)};
            in.edges[i].sheet = sheet;
            fresh.push_back(static_cast<std::int32_t>(i));
        }
        in.edges[i].edge = e;
        in.node[e] = static_cast<std::int32_t>(i);
        if (const std::int64_t other = opposite_of(in.mesh, e); other >= 0) in.node[other] = in.node[e];
    }
    in.implicit.threads(work).for_chunks(fresh.size(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        OfNodes<EdgeNode*> nodes;
        for (std::int64_t i = begin; i < end; ++i) nodes[static_cast<std::size_t>(i - begin)] = &in.edges[fresh[i]];
        examine_edges(in, std::span(nodes).first(static_cast<std::size_t>(end - begin)));
    });
}

// Finds the nodes of a new mesh. Nodes of edges that were in the mesh before are kept.
void find_edges(const base::Work& work, SheetMesh& in) {
    const base::Array<std::int64_t> crossed = crossed_edges(work, in);
    // The numbers of the known nodes, sorted by the starts of their edges: those of vertex v begin at begin[v].
    base::Array<std::int32_t> begin(work.memory, in.mesh.vertices() + 2), sorted(work.memory, in.edges.size());
    for (const EdgeNode& node : in.edges) ++begin[node.ends[0] + 2];
    for (std::int64_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    for (std::int32_t i = 0; i < in.edges.size(); ++i) sorted[begin[in.edges[i].ends[0] + 1]++] = i;
    base::Array<std::int32_t> known(work.memory);
    for (const std::int64_t e : crossed) {
        const std::int32_t start = start_of(in.mesh, e);
        const std::int32_t* const first = sorted.data() + begin[start];
        const std::int32_t* const end = sorted.data() + begin[start + 1];
        const std::int32_t* const at = std::find_if(
            first, end, [&](std::int32_t number) { return in.edges[number].ends[1] == end_of(in.mesh, e); });
        known.push_back(at != end ? *at : -1);
    }
    in.node.resize_for_overwrite(in.mesh.corner.size());
    std::fill(in.node.begin(), in.node.end(), -1);
    make_nodes(work, crossed, known, in);
}

// Finds the nodes again after the sheets of some vertices have changed. Only edges at these vertices are looked at.
void update_edges(const base::Work& work, const EdgesAtVertices& around, const base::Array<std::int32_t>& changed,
                  SheetMesh& in) {
    base::Array<std::int64_t> touched(work.memory); // the first half-edges of all edges at changed vertices
    for (const std::int32_t v : changed)
        for (std::int64_t k = around.begin[v]; k < around.begin[v + 1]; ++k)
            for (const std::int64_t e : {around.edge[k], next_in_triangle(next_in_triangle(around.edge[k]))})
                touched.push_back(is_first(in.mesh, e) ? e : opposite_of(in.mesh, e));
    std::sort(touched.begin(), touched.end());
    touched.resize(std::unique(touched.begin(), touched.end()) - touched.begin());
    base::Array<std::int64_t> crossed(work.memory);
    const std::int64_t* next = touched.begin();
    const auto add_touched_until = [&](std::int64_t edge) {
        for (; next != touched.end() && *next < edge; ++next)
            if (is_crossed(in, *next)) crossed.push_back(*next);
    };
    for (const EdgeNode& node : in.edges) {
        add_touched_until(node.edge);
        if (next == touched.end() || *next != node.edge) crossed.push_back(node.edge);
    }
    add_touched_until(in.mesh.corner.size());
    base::Array<std::int32_t> known(work.memory);
    for (const std::int64_t e : crossed) known.push_back(in.node[e]);
    for (const EdgeNode& node : in.edges) {
        in.node[node.edge] = -1;
        if (const std::int64_t other = opposite_of(in.mesh, node.edge); other >= 0) in.node[other] = -1;
    }
    make_nodes(work, crossed, known, in);
}

// Where sheets coincide, any of them may be active. Assigns all vertices there to the first of these sheets. Returns
// the vertices that changed.
base::Array<std::int32_t> settle_equal(SheetMesh& in) {
    base::Array<std::int32_t> changed(in.sheet.memory());
    for (const EdgeNode& node : in.edges) {
        std::int32_t& start = in.sheet[node.ends[0]];
        std::int32_t& end = in.sheet[node.ends[1]];
        if (end < start && node.equal[0]) {
            start = end;
            changed.push_back(node.ends[0]);
        } else if (start < end && node.equal[1]) {
            end = start;
            changed.push_back(node.ends[1]);
        }
    }
    return changed;
}

void settle_equal_sheets(const base::Work& work, SheetMesh& in) {
    base::Array<std::int32_t> changed = settle_equal(in);
    if (changed.empty()) return;
    const EdgesAtVertices around(work.memory, in.mesh);
    for (int i = 1;; ++i) {
        update_edges(work, around, changed, in);
        if (i == crease_tuning.settlings) return;
        changed = settle_equal(in);
        if (changed.empty()) return;
    }
}

void find_corners(const base::Work& work, SheetMesh& in) {
    in.corners.clear();
    for (std::int64_t t = 0; t < in.mesh.triangles(); ++t)
        if (in.sheets_of(t) == 3) in.corners.push_back({t, {}, {}});
    in.implicit.threads(work).for_chunks(in.corners.size(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        OfNodes<surface::MeetingSearch> searches;
        OfNodes<surface::MeetingPlace> found;
        const std::span<CornerNode> nodes(in.corners.data() + begin, static_cast<std::size_t>(end - begin));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::int64_t first = 3 * nodes[i].triangle;
            glm::dvec3 middle(0.0);
            for (std::int64_t e = first; e < first + 3; ++e) middle += in.edges[in.node[e]].place.position / 3.0;
            searches[i] = in.search({in.mesh.corner.data() + first, 3}, middle, in.mesh.side);
        }
        in.find_meetings(std::span(searches).first(nodes.size()), found.data());
        WholeValues f;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (found[i].found) f.add(found[i].position);
        f.evaluate(in.implicit);
        std::int64_t next = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            nodes[i].place.position = found[i].found ? found[i].position : searches[i].from;
            nodes[i].gradient = found[i].gradient;
            nodes[i].place.exact = found[i].found && f.off_surface(next++, in.mesh.side) <= crease_tuning.on_surface;
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
        if (!node.place.exact && !node.near && !node.alike && node.meet) add(node.edge);
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
            const surface::MeetingSearch search = in.search(beside.ends, node.place.position, in.mesh.side);
            surface::MeetingPlace found;
            in.find_meetings({&search, 1}, &found);
            WholeValues f;
            f.add(found.position);
            f.evaluate(in.implicit);
            node.place.exact = found.found && f.off_surface(0, in.mesh.side) < crease_tuning.beside_surface;
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

} // namespace

SharpMesh split_at_creases(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh mesh) {
    HRBFNPR_ASSERT(implicit.sheets() != nullptr && mesh.side > 0.0);
    const base::Work standing = work.without_progress();
    SheetMesh in(work.memory, implicit, std::move(mesh));
    find_sheets(standing, in);
    for (int round = 0;; ++round) {
        settle_alone(standing, in);
        find_edges(standing, in);
        settle_equal_sheets(standing, in);
        find_corners(standing, in);
        if (round == crease_tuning.rounds || !halve_unclear(standing, in)) break;
    }
    place_rest(in);
    SharpMesh out(work.memory);
    find_chains(in, out.creases);
    build(work, in, out);
    return out;
}

} // namespace hrbfnpr::curves
