// SPDX-License-Identifier: MIT
#include "mesh/pieces/has_creases.h"

#include "base/assert.h"
#include "mesh/edges.h"
#include "mesh/pieces/half_edges.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

constexpr double degrees = 57.29577951308232;

// ---- The mesh beside an edge

// How far a mesh turns along a walk, in degrees.
struct TotalTurn {
    double all = 0.0; // the sum of the magnitudes of the turns
    double net = 0.0; // the sum of the turns: positive on a hill, negative in a hollow
};

// Sums how far the mesh turns about a side beside it, up to a distance. The bend at the side does not count.
TotalTurn turn_beside(const HalfEdgeMesh& sided, std::int64_t side, double reach) noexcept {
    TotalTurn turn;
    walk_beside(sided, side, reach, has_creases_tuning.most_faces, [&](const Crossing& crossed) {
        turn.all += std::abs(sided.bend[crossed.side]) * crossed.across;
        turn.net += sided.bend[crossed.side] * crossed.across;
        return true;
    });
    return turn;
}

// Returns the least bend at the two other sides of a side's face, in degrees; infinity if both are borders.
double least_bend_beside(const HalfEdgeMesh& sided, std::int64_t side) noexcept {
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t other = HalfEdgeMesh::next(side); other != side; other = HalfEdgeMesh::next(other))
        if (sided.beyond[other] >= 0) least = std::min(least, std::abs(sided.bend[other]));
    return least;
}

// Calls visit(side, opposite side) for each edge that bends by more than an angle, in degrees.
template <class Visit>
void for_bent_edges(const HalfEdgeMesh& sided, double angle, const base::Progress& progress, Visit&& visit) {
    for_plain_edges(sided, progress, [&](std::int64_t side, std::int64_t other) {
        if (bends_more(std::abs(sided.bend[side]), angle)) visit(side, other);
    });
}

// Returns for each vertex the number of edges there that bend by more than the angle, and of sides without another
// face.
base::Array<std::int32_t> bent_edges_at_vertices(const base::Work& work, const HalfEdgeMesh& sided, double angle) {
    base::Array<std::int32_t> count(work.memory, sided.mesh.vertex.size());
    for (const std::int64_t side : work.over(sided.beyond.size())) {
        const bool counts =
            sided.beyond[side] < 0 || (sided.beyond[side] > side && bends_more(std::abs(sided.bend[side]), angle));
        if (!counts) continue;
        ++count[sided.start(side)];
        ++count[sided.start(HalfEdgeMesh::next(side))];
    }
    return count;
}

// The result of examining the mesh on the two sides of an edge.
struct EdgeEvidence {
    bool stands_out = false;
    // True if the mesh continues to turn in the same sense on both sides, as a round wall or a fillet does.
    bool is_round = false;
};

// Examines the mesh on both sides of an edge. The edge stands out if the mesh turns little on both sides. If one of its
// faces belongs to a flat polygon, the edge also stands out if the mesh turns little on one side, or if it is too sharp
// to be round. The test of a single side reaches only as far as the height of the lower face, which may be the face of
// a chamfer.
EdgeEvidence examine_edge(const HalfEdgeMesh& sided, std::int64_t side, std::int64_t other) noexcept {
    const double bend = std::abs(sided.bend[side]);
    const double little = bend / has_creases_tuning.stands_out;
    const double reach = has_creases_tuning.reach * sided.height(side);
    const double other_reach = has_creases_tuning.reach * sided.height(other);
    const TotalTurn turn = turn_beside(sided, side, reach), other_turn = turn_beside(sided, other, other_reach);
    EdgeEvidence seen;
    const double way = sided.bend[side] < 0.0 ? -1.0 : 1.0;
    seen.is_round = bend <= has_creases_tuning.surely_sharp && way * turn.net > little && way * other_turn.net > little;
    seen.stands_out = turn.all <= little && other_turn.all <= little;
    if (seen.stands_out) return seen;
    const double flattest = std::min(least_bend_beside(sided, side), least_bend_beside(sided, other));
    if (flattest >= has_creases_tuning.flat) return seen;
    const double lower = std::min(reach, other_reach);
    seen.stands_out = bend > has_creases_tuning.surely_sharp || turn_beside(sided, side, lower).all <= little ||
                      turn_beside(sided, other, lower).all <= little;
    return seen;
}

// Returns the distance of a side's face from a round surface that bends as much as the mesh bends at the side. The face
// is a chord of that surface.
double bulge(const HalfEdgeMesh& sided, std::int64_t side) noexcept {
    return 0.25 * sided.height(side) * std::tan(0.5 / degrees * std::min(std::abs(sided.bend[side]), 120.0));
}

// ---- The components

struct PartSizes {
    explicit PartSizes(base::Memory& memory) : diagonal(memory), area(memory) {}

    base::Array<double> diagonal, area; // the diagonal and the area of each component
};

PartSizes sizes_of_parts(const base::Runtime& runtime, const Mesh& mesh) {
    const std::int64_t parts = 1 + *std::max_element(mesh.component.begin(), mesh.component.end());
    PartSizes sizes(runtime.memory);
    sizes.area.resize(parts);
    base::Array<geometry::Bounds> bounds(runtime.memory);
    for (std::int64_t part = 0; part < parts; ++part) bounds.push_back({});
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const auto corners = mesh.corners(face);
        for (const glm::dvec3& p : corners) bounds[mesh.component[face]].extend(p);
        sizes.area[mesh.component[face]] += 0.5 * glm::length(doubled_area(corners));
    }
    for (const geometry::Bounds& each : bounds) sizes.diagonal.push_back(each.diagonal());
    return sizes;
}

// Judges the whole mesh from the sums over its components.
CreaseEvidence judged_whole(const base::Array<EdgeLengths>& lengths, const base::Array<CreaseEvidence>& part,
                            const PartSizes& sizes, double diagonal) noexcept {
    EdgeLengths all;
    double area = 0.0, area_with_creases = 0.0;
    for (std::int64_t i = 0; i < part.size(); ++i) {
        all.all += lengths[i].all;
        all.standing += lengths[i].standing;
        all.coarse += lengths[i].coarse;
        area += sizes.area[i];
        area_with_creases += part[i].creases ? sizes.area[i] : 0.0;
    }
    return judge_all_edges(all, diagonal, area_with_creases, area);
}

} // namespace

CreaseEvidenceOfParts look_for_creases_of_parts(const base::Work& work, const Mesh& mesh, double angle) {
    HRBFNPR_ASSERT(angle > 0.0 && mesh.faces() > 0);
    const HalfEdgeMesh sided = half_edges_of(work, mesh);
    const PartSizes sizes = sizes_of_parts(work, mesh);
    const base::Array<std::int32_t> bent_edges_at = bent_edges_at_vertices(work, sided, angle);
    CreaseEvidenceOfParts found{base::Array<CreaseEvidence>(work.memory, sizes.area.size()),
                                base::Array<std::uint8_t>(work.memory, 3 * mesh.faces()),
                                {}};
    base::Array<EdgeLengths> lengths(work.memory, sizes.area.size());
    for_bent_edges(sided, angle, work, [&](std::int64_t side, std::int64_t other) {
        const std::int64_t number = mesh.component[side / 3];
        EdgeLengths& part = lengths[number];
        const double length = sided.length(side);
        part.all += length;
        const EdgeEvidence seen = examine_edge(sided, side, other);
        // An edge of the shape continues at both ends. Single edges of a smooth mesh may bend by slightly more than
        // the angle.
        const bool continues = bent_edges_at[sided.start(side)] >= 2 && bent_edges_at[sided.start(other)] >= 2;
        if (seen.stands_out && continues) part.standing += length;
        if (!seen.is_round) found.sharp[side] = found.sharp[other] = 1;
        const double off = std::min(bulge(sided, side), bulge(sided, other));
        if (off >= has_creases_tuning.far_off * sizes.diagonal[number]) part.coarse += length;
    });
    for (std::int64_t i = 0; i < lengths.size(); ++i) found.part[i] = judge_edges(lengths[i], sizes.diagonal[i]);
    for_plain_edges(sided, work, [&](std::int64_t side, std::int64_t other) {
        const std::int64_t number = mesh.component[side / 3];
        if (!found.part[number].polyhedron) return;
        const double off = std::max(bulge(sided, side), bulge(sided, other));
        found.sharp[side] = found.sharp[other] = off >= has_creases_tuning.near_enough * sizes.diagonal[number] ? 1 : 0;
    });
    found.whole = judged_whole(lengths, found.part, sizes, mesh.bounds.diagonal());
    return found;
}

CreaseEvidence look_for_creases(const base::Work& work, const Mesh& mesh, double angle) {
    return look_for_creases_of_parts(work, mesh, angle).whole;
}

} // namespace hrbfnpr::mesh
