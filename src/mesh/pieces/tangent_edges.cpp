// SPDX-License-Identifier: MIT
// The steps of find_tangent_edges(), in order:
//
//   flat_polygons      finds the faces that lie in one plane
//   find_candidates    compares the bend at each edge with the bends beside it
//   follow_chains      joins candidates that continue each other, and judges the lines that they form
//   drop_unsure        drops the lines of components in which most candidates form no line
#include "mesh/pieces/tangent_edges.h"

#include "mesh/pieces/half_edges.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

constexpr const TangentTuning& tuned = tangent_tuning;

// All steps read this data.
struct TangentTask {
    const base::Work& work;
    const HalfEdgeMesh& sided;
    double rounding; // the rounding error of the coordinates, in units of the mesh

    // Returns the largest bend that rounding alone may cause at a side, in degrees.
    [[nodiscard]] double flat_at(std::int64_t side) const noexcept {
        const double other = sided.beyond[side] < 0 ? sided.height(side) : sided.height(sided.beyond[side]);
        return tuned.flat + tuned.degrees * rounding / std::min(sided.height(side), other);
    }
    [[nodiscard]] bool is_flat(std::int64_t side) const noexcept { return std::abs(sided.bend[side]) <= flat_at(side); }
};

// Returns for each face the number of faces of its flat polygon.
base::Array<std::int32_t> flat_polygons(const TangentTask& task) {
    const std::int64_t faces = task.sided.mesh.faces();
    UnionFind polygons(task.work.memory, faces);
    for_plain_edges(task.sided, task.work, [&](std::int64_t side, std::int64_t other) {
        if (task.is_flat(side))
            polygons.join(static_cast<std::int32_t>(side / 3), static_cast<std::int32_t>(other / 3));
    });
    base::Array<std::int32_t> count(task.work.memory, faces);
    for (std::int32_t face = 0; face < faces; ++face) ++count[polygons.find(face)];
    for (std::int32_t face = 0; face < faces; ++face) count[face] = count[polygons.find(face)];
    return count;
}

// The mesh on one side of an edge, along a walk at right angles to the edge.
struct Beside {
    double width = 0.0;     // the length of the walk on the first flat polygon
    double curvature = 0.0; // the turn of the mesh beyond that polygon for each unit of length, in degrees
    bool is_steady = false; // whether the curvature is the same farther on
};

// `is_polygon` tells whether the face belongs to a flat polygon of several faces. The width of a single triangle is its
// height, because the walk leaves it before its tip.
Beside look_beside(const TangentTask& task, std::int64_t side, bool is_polygon) noexcept {
    const HalfEdgeMesh& sided = task.sided;
    const double enough = tuned.reach * sided.height(side);
    int count = 0; // the number of bends
    double turn = 0.0, first = 0.0, last = 0.0, before = 0.0, last_bend = 0.0;
    Beside seen;
    const auto curvature_up_to = [&](double place) { return 2.0 * turn / (place + last - first); };
    bool is_known = false;
    const double walked =
        walk_beside(sided, side, std::numeric_limits<double>::infinity(), tuned.most_faces, [&](const Crossing& at) {
            if (task.is_flat(at.side)) return true;
            if (is_known) { // One more bend shows whether the curvature is steady.
                const double next = 2.0 * last_bend / (at.distance - before);
                seen.is_steady = std::abs(next - seen.curvature) <= tuned.steady * std::abs(seen.curvature);
                return false;
            }
            if (count > 0) seen.curvature = curvature_up_to(at.distance);
            is_known = count > 0 && at.distance >= enough;
            if (count++ == 0) first = at.distance;
            before = last;
            last = at.distance;
            last_bend = sided.bend[at.side] * at.across;
            turn += last_bend;
            return true;
        });
    seen.width = count == 0 ? walked : is_polygon ? first : std::max(first, sided.height(side));
    if (count > 0 && !is_known) seen.curvature = curvature_up_to(walked);
    return seen;
}

// An edge that may be tangent.
struct Candidate {
    std::int64_t side;
    double length;
    double bend,
        expected; // the bend of the mesh, and that of a tangent edge between the surfaces beside it, in degrees
    double width; // the width of the faces on the side that bends more
};

// Returns whether an edge lies between a surface that is flat at right angles to it and one that bends.
bool ends_flat(double bend, const Beside& flat, const Beside& bent, bool is_polygon, double least_bend,
               Candidate& found) noexcept {
    if (!is_polygon && flat.width < tuned.surely_wide * bent.width) return false;
    const double expected = 0.5 * bent.width * bent.curvature;
    if (!(bend * expected > 0.0) || std::abs(expected) <= least_bend) return false;
    const double off = std::abs(bend / expected - 1.0);
    if (!(off <= tuned.off_of_edge * std::min(1.0, flat.width / bent.width))) return false;
    // Beyond a narrow plane the mesh may bend again. Only exact bends show then that it is a plane.
    const bool stays_flat = std::abs(flat.curvature) <= tuned.stays_flat * std::abs(bent.curvature);
    if (!stays_flat && !(bent.is_steady && off <= tuned.off_of_exact)) return false;
    found.expected = expected;
    found.width = bent.width;
    return true;
}

// Returns whether an edge lies between two surfaces of steady but different curvatures.
bool changes_curvature(double bend, const Beside& one, const Beside& other, Candidate& found) noexcept {
    if (!one.is_steady || !other.is_steady) return false;
    const double most = std::max(std::abs(one.curvature), std::abs(other.curvature));
    if (!(std::abs(one.curvature - other.curvature) >= tuned.change * most)) return false;
    const double expected = 0.5 * (one.width * one.curvature + other.width * other.curvature);
    if (!(std::abs(bend - expected) <= tuned.steady * std::abs(expected))) return false;
    found.expected = expected;
    found.width = std::max(one.width, other.width);
    return true;
}

base::Array<Candidate> find_candidates(const TangentTask& task) {
    const HalfEdgeMesh& sided = task.sided;
    const base::Array<std::int32_t> faces = flat_polygons(task);
    base::Array<Candidate> found(task.work.memory);
    for_plain_edges(sided, task.work, [&](std::int64_t side, std::int64_t other) {
        if (task.is_flat(side)) return;
        const bool is_one_here = faces[side / 3] >= 2, is_one_there = faces[other / 3] >= 2;
        const Beside here = look_beside(task, side, is_one_here), there = look_beside(task, other, is_one_there);
        const double bend = sided.bend[side];
        const double least = task.flat_at(side);
        Candidate candidate{side, sided.length(side), bend, 0.0, 0.0};
        if (ends_flat(bend, here, there, is_one_here, least, candidate) ||
            ends_flat(bend, there, here, is_one_there, least, candidate) ||
            (is_one_here && is_one_there && changes_curvature(bend, here, there, candidate)))
            found.push_back(candidate);
    });
    return found;
}

// Joins candidates that continue each other to lines, and calls visit(line) for each with the indices of its
// candidates.
template <class Visit>
void follow_chains(const TangentTask& task, const base::Array<Candidate>& candidates, Visit&& visit) {
    const HalfEdgeMesh& sided = task.sided;
    const auto ends = [&](std::int64_t i) {
        const std::int64_t side = candidates[i].side;
        return std::pair(sided.start(side), sided.start(HalfEdgeMesh::next(side)));
    };
    const base::Groups at(task.work.memory, sided.mesh.vertex.size(), [&](auto&& put) {
        for (std::int32_t i = 0; i < candidates.size(); ++i) {
            put(ends(i).first, i);
            put(ends(i).second, i);
        }
    });
    base::Array<std::uint8_t> used(task.work.memory, candidates.size());
    base::Array<std::int64_t> line(task.work.memory);
    const auto way_from = [&](std::int64_t i, std::int32_t vertex) {
        const auto [from, to] = ends(i);
        return glm::normalize(sided.mesh.vertex[from == vertex ? to : from] - sided.mesh.vertex[vertex]);
    };
    for (std::int64_t start = 0; start < candidates.size(); ++start) {
        if (used[start] != 0) continue;
        used[start] = 1;
        line.clear();
        line.push_back(start);
        for (const bool forward : {true, false}) {
            std::int64_t last = start;
            std::int32_t vertex = forward ? ends(start).second : ends(start).first;
            while (true) {
                double best = tuned.aligned;
                std::int64_t next = -1;
                for (const std::int32_t i : at[vertex]) {
                    const double cosine = used[i] != 0 ? -1.0 : -glm::dot(way_from(last, vertex), way_from(i, vertex));
                    if (!(cosine > best)) continue;
                    best = cosine;
                    next = i;
                }
                if (next < 0) break;
                used[next] = 1;
                line.push_back(next);
                vertex = ends(next).first == vertex ? ends(next).second : ends(next).first;
                last = next;
            }
        }
        visit(std::as_const(line));
    }
}

struct LineLengths {
    double accepted = 0.0, rejected = 0.0;
};

// Judges lines as wholes, because single edges of irregular meshes are unsure.
// `is_anchored` tells whether a line goes from one crease or border to another, so that it cannot be longer.
bool is_tangent_line(const base::Array<Candidate>& candidates, const base::Array<std::int64_t>& line,
                     bool is_anchored) noexcept {
    double length = 0.0, bend = 0.0, expected = 0.0, width = 0.0, off = 0.0;
    for (const std::int64_t i : line) {
        const Candidate& one = candidates[i];
        length += one.length;
        bend += one.length * one.bend;
        expected += one.length * one.expected;
        width += one.length * one.width;
        off += one.length * std::abs(one.bend / one.expected - 1.0);
    }
    const bool is_exact = off <= tuned.off_of_exact * length;
    const double shortest = is_exact && is_anchored ? 0.0 : is_exact ? tuned.shortest_exact : tuned.shortest;
    return std::abs(bend / expected - 1.0) <= tuned.off_of_line && length * length >= shortest * width;
}

} // namespace

base::Array<std::int64_t> find_tangent_edges(const base::Work& work, const Mesh& mesh,
                                             const base::Array<std::uint8_t>& cut) {
    HRBFNPR_ASSERT(cut.empty() || cut.size() == 3 * mesh.faces());
    HalfEdgeMesh sided = half_edges_of(work, mesh);
    for (std::int64_t side = 0; side < cut.size(); ++side)
        if (cut[side] == 1) sided.beyond[side] = -1;
    const TangentTask task{work, sided, tuned.rounding * mesh.bounds.diagonal()};
    const base::Array<Candidate> candidates = find_candidates(task);
    base::Array<LineLengths> of_component(work.memory,
                                          1 + *std::max_element(mesh.component.begin(), mesh.component.end()));
    base::Array<std::uint8_t> at_end(work.memory, mesh.vertex.size()); // 1 for the vertices of creases and borders
    for (std::int64_t side = 0; side < sided.beyond.size(); ++side)
        if (sided.beyond[side] < 0) at_end[sided.start(side)] = at_end[sided.start(HalfEdgeMesh::next(side))] = 1;
    const auto is_anchored = [&](const base::Array<std::int64_t>& line) {
        int anchors = 0;
        for (const std::int64_t i : line)
            for (const std::int64_t end : {candidates[i].side, HalfEdgeMesh::next(candidates[i].side)})
                anchors += at_end[sided.start(end)];
        return anchors >= 2;
    };
    base::Array<std::int64_t> found(work.memory);
    follow_chains(task, candidates, [&](const base::Array<std::int64_t>& line) {
        const bool is_one = is_tangent_line(candidates, line, is_anchored(line));
        LineLengths& lengths = of_component[mesh.component[candidates[line[0]].side / 3]];
        for (const std::int64_t i : line) {
            (is_one ? lengths.accepted : lengths.rejected) += candidates[i].length;
            if (is_one) found.push_back(candidates[i].side);
        }
    });
    const auto unsure = [&](std::int64_t side) {
        const LineLengths& lengths = of_component[mesh.component[side / 3]];
        return lengths.rejected > tuned.most_rejected * lengths.accepted;
    };
    base::Array<std::int64_t> kept(work.memory);
    for (const std::int64_t side : found) {
        if (unsure(side)) continue;
        kept.push_back(side);
        kept.push_back(sided.beyond[side]);
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

} // namespace hrbfnpr::mesh
