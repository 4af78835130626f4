// SPDX-License-Identifier: MIT
#include "creases/crease_mesh.h"

#include "creases/crease_nodes.h"
#include "creases/settle_alone.h"
#include "curves/edge_halving.h"
#include "curves/mesh_topology.h"
#include "surface/project.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr int mesh_rounds = 6;
constexpr int most_settlings = 20;
constexpr std::int64_t grain = 32;
// In sides.
constexpr double shortest_edge = 0.01; // that is halved

class Splitter {
public:
    Splitter(const base::Runtime& runtime, const implicit::Implicit& implicit, SurfaceMesh mesh)
        : runtime_(runtime), implicit_(implicit), sheets_(*implicit.sheets()), mesh_(std::move(mesh)),
          sheet_(runtime.memory), node_(runtime.memory), edges_(runtime.memory), looked_at_(runtime.memory),
          known_node_(runtime.memory), known_(runtime.memory), corners_(runtime.memory), taken_(runtime.memory),
          out_(runtime.memory) {}

    SharpMesh run(const base::Progress& progress);

private:
    struct Known {
        std::array<std::int32_t, 2> ends;
        std::int32_t node;
    };

    [[nodiscard]] base::Parallel threads() const noexcept { return implicit_.threads(runtime_.parallel); }
    [[nodiscard]] std::int32_t sheet_of(std::int64_t triangle, int k) const noexcept {
        return sheet_[mesh_.corner[3 * triangle + k % 3]];
    }
    [[nodiscard]] int sheets_of(std::int64_t triangle) const noexcept {
        const std::int32_t a = sheet_of(triangle, 0);
        const std::int32_t b = sheet_of(triangle, 1);
        const std::int32_t c = sheet_of(triangle, 2);
        return a == b && b == c ? 1 : a != b && b != c && a != c ? 3 : 2;
    }
    void find_sheets(std::int64_t from, const base::Progress& progress);
    void remember_edges();
    [[nodiscard]] const EdgeNode* known(const EdgeNode& edge) const noexcept;
    void find_edges(const base::Progress& progress);
    [[nodiscard]] bool settle_equal();
    void find_corners(const base::Progress& progress);
    [[nodiscard]] double length_of(std::int64_t edge) const noexcept;
    void add_middles(const base::Array<std::int64_t>& edge, base::Array<std::int32_t>& middle,
                     const base::Progress& progress);
    [[nodiscard]] bool halve(const base::Progress& progress);
    void place_rest();
    [[nodiscard]] std::int32_t vertex_of(std::int64_t edge, bool at_start) const noexcept;
    void add_vertices();
    void add_triangle(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t sheet);
    void add_quad(const std::array<std::int32_t, 4>& vertex, std::int32_t sheet);
    void cut_in_two(std::int64_t triangle);
    void cut_in_three(std::int64_t triangle, std::int64_t corner);
    void build(const base::Progress& progress);
    [[nodiscard]] std::int64_t exit_of(std::int64_t entered) const noexcept;
    void put(std::int64_t edge) { out_.creases.node.push_back(edges_[node_[edge]].at); }
    void follow(std::int64_t entered);
    void end_chain(std::int64_t edge, bool closed);
    void find_chains();
    [[nodiscard]] const CornerNode* corner_of(std::int64_t triangle) const noexcept;

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const implicit::Sheets& sheets_;
    SurfaceMesh mesh_;
    base::Array<std::int32_t> sheet_; // of each vertex
    base::Array<std::int32_t> node_;  // of each edge, of both: among edges_; -1: it crosses no crease
    CreaseNodes nodes_{implicit_, mesh_, sheet_};
    base::Array<EdgeNode> edges_;
    base::Array<std::int32_t> looked_at_; // of edges_: those that were not known
    base::Array<EdgeNode> known_node_;    // of the edges before
    base::Array<Known> known_;
    base::Array<CornerNode> corners_; // by triangle
    base::Array<std::uint8_t> taken_; // edges that chains have passed
    SharpMesh out_;
    std::int32_t first_of_edges_ = 0, first_of_corners_ = 0; // vertices
};

void Splitter::find_sheets(std::int64_t from, const base::Progress& progress) {
    sheet_.resize(mesh_.vertices());
    threads().for_chunks(mesh_.vertices() - from, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        const std::int64_t at = from + begin;
        sheets_.active(
            {mesh_.position.x.data() + at, mesh_.position.y.data() + at, mesh_.position.z.data() + at, end - begin},
            sheet_.data() + at);
    });
}

// Of the edges as they are now, by their ends.
void Splitter::remember_edges() {
    std::swap(edges_, known_node_);
    edges_.clear();
    known_.clear();
    for (std::int64_t i = 0; i < known_node_.size(); ++i)
        known_.push_back({known_node_[i].ends, static_cast<std::int32_t>(i)});
    std::sort(known_.begin(), known_.end(), [](const Known& a, const Known& b) { return a.ends < b.ends; });
}

// What was known of an edge with the same ends, if these have the same sheets; else null.
const EdgeNode* Splitter::known(const EdgeNode& edge) const noexcept {
    const Known* const at =
        std::lower_bound(known_.begin(), known_.end(), edge.ends,
                         [](const Known& one, const std::array<std::int32_t, 2>& wanted) { return one.ends < wanted; });
    if (at == known_.end() || at->ends != edge.ends || known_node_[at->node].sheet != edge.sheet) return nullptr;
    return &known_node_[at->node];
}

void Splitter::find_edges(const base::Progress& progress) {
    remember_edges();
    looked_at_.clear();
    node_.resize(mesh_.corner.size());
    for (std::int64_t e = 0; e < mesh_.corner.size(); ++e) {
        node_[e] = -1;
        const std::array<std::int32_t, 2> ends{start_of(mesh_, e), end_of(mesh_, e)};
        if (!is_first(mesh_, e) || sheet_[ends[0]] == sheet_[ends[1]]) continue;
        EdgeNode edge{e, ends, {sheet_[ends[0]], sheet_[ends[1]]}, {}, {}, {}, false, false, false};
        node_[e] = static_cast<std::int32_t>(edges_.size());
        if (const EdgeNode* const before = known(edge)) {
            edge = *before;
            edge.edge = e;
        } else {
            looked_at_.push_back(node_[e]);
        }
        edges_.push_back(edge);
    }
    for (std::int64_t i = 0; i < edges_.size(); ++i)
        if (const std::int64_t other = opposite_of(mesh_, edges_[i].edge); other >= 0)
            node_[other] = static_cast<std::int32_t>(i);
    threads().for_chunks(looked_at_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) nodes_.look_at(edges_[looked_at_[i]]);
    });
}

// Where sheets lie upon each other any is active: the first of them gets all.  Returns whether anything changed.
bool Splitter::settle_equal() {
    bool changed = false;
    for (const EdgeNode& node : edges_) {
        std::int32_t& start = sheet_[start_of(mesh_, node.edge)];
        std::int32_t& end = sheet_[end_of(mesh_, node.edge)];
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

void Splitter::find_corners(const base::Progress& progress) {
    corners_.clear();
    for (std::int64_t t = 0; t < mesh_.triangles(); ++t)
        if (sheets_of(t) == 3) corners_.push_back({t, {}, {}});
    threads().for_chunks(corners_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            CornerNode& node = corners_[i];
            glm::dvec3 middle(0.0);
            for (std::int64_t e = 3 * node.triangle; e < 3 * node.triangle + 3; ++e)
                middle += edges_[node_[e]].at.position / 3.0;
            nodes_.look_at(node, middle);
        }
    });
}

double Splitter::length_of(std::int64_t edge) const noexcept {
    return glm::distance(mesh_.position[start_of(mesh_, edge)], mesh_.position[end_of(mesh_, edge)]);
}

// Vertices on the surface beside the middles of edges, where there is such a place; middle: of edges, -1: none.
void Splitter::add_middles(const base::Array<std::int64_t>& edge, base::Array<std::int32_t>& middle,
                           const base::Progress& progress) {
    surface::Projection at(runtime_.memory);
    for (const std::int64_t e : edge)
        at.position.push_back(0.5 * (mesh_.position[start_of(mesh_, e)] + mesh_.position[end_of(mesh_, e)]));
    surface::project(runtime_, implicit_, {}, at, progress.part(0.0, 0.0));
    for (std::int64_t i = 0; i < edge.size(); ++i) {
        const std::int64_t e = edge[i];
        const glm::dvec3 between = 0.5 * (mesh_.position[start_of(mesh_, e)] + mesh_.position[end_of(mesh_, e)]);
        middle[e] = -1;
        if (at.status[i] != surface::ProjectionStatus::converged ||
            !(glm::distance(at.position[i], between) < 0.5 * length_of(e)))
            continue;
        middle[e] = static_cast<std::int32_t>(mesh_.vertices());
        if (const std::int64_t other = opposite_of(mesh_, e); other >= 0) middle[other] = middle[e];
        mesh_.position.push_back(at.position[i]);
        mesh_.gradient.push_back(at.gradient[i]);
    }
}

// Edges whose sheets meet beside them, but not on the surface, and the longest of triangles that have no corner where
// theirs do.  Returns whether there were any.
bool Splitter::halve(const base::Progress& progress) {
    base::Array<std::int32_t> middle(runtime_.memory, mesh_.corner.size());
    std::fill(middle.begin(), middle.end(), -1);
    base::Array<std::int64_t> edge(runtime_.memory);
    const auto add = [&](std::int64_t e) {
        if (const std::int64_t other = opposite_of(mesh_, e); !is_first(mesh_, e) && other >= 0) e = other;
        if (middle[e] == 0 || length_of(e) < shortest_edge * mesh_.side) return;
        middle[e] = 0;
        edge.push_back(e);
    };
    for (const EdgeNode& node : edges_)
        if (node.passes_another()) add(node.edge);
    for (const CornerNode& node : corners_) {
        if (node.at.exact) continue;
        std::int64_t longest = 3 * node.triangle;
        for (std::int64_t e = longest; e < 3 * node.triangle + 3; ++e)
            if (length_of(e) > length_of(longest)) longest = e;
        add(longest);
    }
    const std::int64_t before = mesh_.vertices();
    add_middles(edge, middle, progress);
    if (mesh_.vertices() == before) return false;
    cut_at_middles(runtime_, middle, mesh_);
    find_sheets(before, progress);
    return true;
}

// What is left lies where it was looked for, with the gradients of its sheets there.  Beside a seam f is a mean of both
// parts, and a little off either one: what the crease of one part with another sheet is there is good enough.
void Splitter::place_rest() {
    for (EdgeNode& node : edges_) {
        if (node.at.exact) continue;
        node.at.exact = node.near;
        if (node.near) continue;
        ++out_.unresolved;
        node.gradient = {surface::sheet_at(sheets_, sheet_[start_of(mesh_, node.edge)], node.at.position).gradient,
                         surface::sheet_at(sheets_, sheet_[end_of(mesh_, node.edge)], node.at.position).gradient};
    }
    for (CornerNode& node : corners_) {
        if (node.at.exact) continue;
        for (std::int64_t e = 3 * node.triangle; e < 3 * node.triangle + 3 && !node.at.exact; ++e)
            if (const EdgeNode& beside = edges_[node_[e]]; beside.at.exact && nodes_.place_at_seam(node, beside)) break;
        out_.unresolved += node.at.exact ? 0 : 1;
        for (int k = 0; k < 3; ++k)
            node.gradient[static_cast<std::size_t>(k)] =
                surface::sheet_at(sheets_, sheet_of(node.triangle, k), node.at.position).gradient;
    }
}

// On an edge, of the sheet of its start or its end.
std::int32_t Splitter::vertex_of(std::int64_t edge, bool at_start) const noexcept {
    const bool first = edges_[node_[edge]].edge == edge;
    return first_of_edges_ + 2 * node_[edge] + (first == at_start ? 0 : 1);
}

void Splitter::add_vertices() {
    SurfaceMesh& to = out_.mesh;
    to.position = std::move(mesh_.position);
    to.gradient = std::move(mesh_.gradient);
    first_of_edges_ = static_cast<std::int32_t>(to.vertices());
    for (const EdgeNode& node : edges_)
        for (const glm::dvec3& gradient : node.gradient) {
            to.position.push_back(node.at.position);
            to.gradient.push_back(gradient);
        }
    first_of_corners_ = static_cast<std::int32_t>(to.vertices());
    for (const CornerNode& node : corners_)
        for (const glm::dvec3& gradient : node.gradient) {
            to.position.push_back(node.at.position);
            to.gradient.push_back(gradient);
        }
}

void Splitter::add_triangle(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t sheet) {
    for (const std::int32_t vertex : {a, b, c}) out_.mesh.corner.push_back(vertex);
    out_.sheet.push_back(sheet);
}

// Along the diagonal that leaves the larger of least areas, as seen along the gradient: beside a corner one of them may
// lie outside.
void Splitter::add_quad(const std::array<std::int32_t, 4>& vertex, std::int32_t sheet) {
    const SurfaceMesh& mesh = out_.mesh;
    const auto least = [&](std::size_t first) {
        double area = std::numeric_limits<double>::infinity();
        for (const std::size_t k : {first + 1, first + 2}) {
            const glm::dvec3 a = mesh.position[vertex[first]];
            const glm::dvec3 cross =
                glm::cross(mesh.position[vertex[k % 4]] - a, mesh.position[vertex[(k + 1) % 4]] - a);
            for (const std::size_t i : {first, k % 4, (k + 1) % 4})
                area = std::min(area, glm::dot(cross, glm::normalize(mesh.gradient[vertex[i]])));
        }
        return area;
    };
    const std::size_t first = least(0) >= least(1) ? 0 : 1;
    add_triangle(vertex[first], vertex[first + 1], vertex[first + 2], sheet);
    add_triangle(vertex[first], vertex[first + 2], vertex[(first + 3) % 4], sheet);
}

void Splitter::cut_in_two(std::int64_t triangle) {
    int k = 0; // the corner that stands alone
    while (sheet_of(triangle, k) == sheet_of(triangle, k + 1) || sheet_of(triangle, k) == sheet_of(triangle, k + 2))
        ++k;
    const std::int64_t ab = 3 * triangle + k;
    const std::int64_t ca = 3 * triangle + (k + 2) % 3;
    const auto at = [&](int i) { return mesh_.corner[3 * triangle + i % 3]; };
    add_triangle(at(k), vertex_of(ab, true), vertex_of(ca, false), sheet_of(triangle, k));
    const std::array<std::int32_t, 4> rest{vertex_of(ab, false), at(k + 1), at(k + 2), vertex_of(ca, true)};
    add_quad(rest, sheet_of(triangle, k + 1));
}

void Splitter::cut_in_three(std::int64_t triangle, std::int64_t corner) {
    for (int k = 0; k < 3; ++k) {
        const std::int32_t at = mesh_.corner[3 * triangle + k];
        const std::int32_t middle = first_of_corners_ + 3 * static_cast<std::int32_t>(corner) + k;
        add_quad({at, vertex_of(3 * triangle + k, true), middle, vertex_of(3 * triangle + (k + 2) % 3, false)},
                 sheet_[at]);
    }
}

void Splitter::build(const base::Progress& progress) {
    SurfaceMesh& to = out_.mesh;
    to.region = mesh_.region;
    to.end = mesh_.end;
    to.side = mesh_.side;
    to.unresolved = mesh_.unresolved;
    to.missed_seeds = mesh_.missed_seeds;
    add_vertices();
    std::int64_t corner = 0;
    for (std::int64_t t = 0; t < mesh_.triangles(); ++t) {
        if (t % 4096 == 0) progress.check();
        const int count = sheets_of(t);
        if (count == 1) {
            add_triangle(mesh_.corner[3 * t], mesh_.corner[3 * t + 1], mesh_.corner[3 * t + 2], sheet_of(t, 0));
            to.turned += is_turned(to, to.triangles() - 1) ? 1 : 0; // what is cut has slivers, which say nothing
        } else if (count == 2)
            cut_in_two(t);
        else
            cut_in_three(t, corner++);
    }
    to.neighbour = find_neighbours(runtime_, to.corner, to.vertices());
}

const CornerNode* Splitter::corner_of(std::int64_t triangle) const noexcept {
    const CornerNode* const at =
        std::lower_bound(corners_.begin(), corners_.end(), triangle,
                         [](const CornerNode& node, std::int64_t wanted) { return node.triangle < wanted; });
    return at != corners_.end() && at->triangle == triangle ? at : nullptr;
}

// Of a triangle that a crease passes through, the other edge that it crosses.
std::int64_t Splitter::exit_of(std::int64_t entered) const noexcept {
    const std::int64_t next = next_in_triangle(entered);
    return node_[next] >= 0 ? next : next_in_triangle(next);
}

// Through the triangle of an edge, and on; the sheet of the edge's start lies to the left.
void Splitter::follow(std::int64_t entered) {
    std::int64_t e = entered;
    bool closed = false;
    while (true) {
        put(e);
        taken_[e] = 1;
        if (const CornerNode* const corner = corner_of(e / 3)) {
            out_.creases.node.push_back(corner->at);
            break;
        }
        const std::int64_t out = exit_of(e);
        taken_[out] = 1;
        const std::int64_t next = opposite_of(mesh_, out);
        if (next < 0) {
            put(out);
            break;
        }
        e = next;
        closed = e == entered;
        if (closed || taken_[e] != 0) break;
    }
    end_chain(entered, closed);
}

void Splitter::end_chain(std::int64_t edge, bool closed) {
    CreaseChains& to = out_.creases;
    to.first.push_back(to.node.size());
    to.closed.push_back(closed ? 1 : 0);
    to.left.push_back(sheet_[start_of(mesh_, edge)]);
    to.right.push_back(sheet_[end_of(mesh_, edge)]);
}

// From corners and from the border first; what is left is closed.
void Splitter::find_chains() {
    taken_.resize(mesh_.corner.size());
    out_.creases.first.push_back(0);
    for (const CornerNode& corner : corners_)
        for (std::int64_t e = 3 * corner.triangle; e < 3 * corner.triangle + 3; ++e) {
            if (taken_[e] != 0) continue;
            taken_[e] = 1;
            const std::int64_t next = opposite_of(mesh_, e);
            out_.creases.node.push_back(corner.at);
            if (next >= 0) {
                follow(next);
                continue;
            }
            put(e);
            CreaseChains& to = out_.creases; // of two nodes, with its sides the other way round
            to.first.push_back(to.node.size());
            to.closed.push_back(0);
            to.left.push_back(sheet_[end_of(mesh_, e)]);
            to.right.push_back(sheet_[start_of(mesh_, e)]);
        }
    for (const bool border : {true, false})
        for (const EdgeNode& node : edges_)
            if (taken_[node.edge] == 0 && (mesh_.neighbour[node.edge] < 0) == border) follow(node.edge);
}

SharpMesh Splitter::run(const base::Progress& progress) {
    find_sheets(0, progress);
    for (int round = 0;; ++round) {
        settle_alone(runtime_, sheets_, alike_sheets, mesh_, sheet_, progress);
        find_edges(progress.part(0.0, 0.0));
        for (int i = 0; i < most_settlings && settle_equal(); ++i) find_edges(progress.part(0.0, 0.0));
        find_corners(progress.part(0.0, 0.0));
        if (round == mesh_rounds || !halve(progress)) break;
    }
    place_rest();
    find_chains();
    build(progress);
    return std::move(out_);
}

} // namespace

SharpMesh split_at_creases(const base::Runtime& runtime, const implicit::Implicit& implicit, SurfaceMesh mesh,
                           const base::Progress& progress) {
    return Splitter(runtime, implicit, std::move(mesh)).run(progress);
}

} // namespace hrbfnpr::curves
