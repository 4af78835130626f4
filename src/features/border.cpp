// SPDX-License-Identifier: MIT
// 1. border_vertices: the mesh's edges without a neighbour, as chains of vertices.
// 2. thinned: of the vertices along the cut those that do not crowd.
// 3. halve_pieces: more points where the border turns, by Newton's steps to f = g = 0.
// 4. Points as lines, with the tangents of f = g = 0 where these fit.
#include "features/border.h"

#include "curves/chains.h"
#include "curves/clip_mesh.h"
#include "features/tuning.h"

#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr int most_rounds = 6; // each halves pieces

struct BorderPoint {
    CurvePoint at;
    bool exact = false; // on f = g = 0; else where the region ends
};

Chains<std::int32_t> border_vertices(base::Memory& memory, const SurfaceMesh& mesh) {
    HRBFNPR_ASSERT(mesh.neighbour.size() == mesh.corner.size());
    base::Array<std::int32_t> after(memory, mesh.vertices()); // 1 + the next vertex along the border
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0) after[start_of(mesh, e)] = 1 + end_of(mesh, e);
    Chains<std::int32_t> chains(memory);
    for (std::int64_t start = 0; start < mesh.vertices(); ++start) {
        if (after[start] == 0) continue;
        std::int64_t at = start;
        while (after[at] != 0) {
            chains.point.push_back(static_cast<std::int32_t>(at));
            at = std::exchange(after[at], 0) - 1;
        }
        if (at != start) chains.point.push_back(static_cast<std::int32_t>(at));
        chains.end(at == start);
    }
    return chains;
}

// Points of the cut that crowd are left out, but for those where the region's end begins.
Chains<BorderPoint> thinned_border(const Chains<std::int32_t>& border, const ClippedMesh& clipped) {
    HRBFNPR_ASSERT(clipped.mesh.vertices() - clipped.first_cut == clipped.cut.size());
    Chains<BorderPoint> chains(border.first.memory());
    for (std::int64_t c = 0; c < border.count(); ++c) {
        const std::int32_t* const vertex = border.point.data() + border.first[c];
        const std::int64_t count = border.size_of(c);
        const bool closed = border.closed[c] != 0;
        const std::int64_t first = chains.point.size();
        const auto is_cut = [&](std::int64_t i) {
            return (closed || (i >= 0 && i < count)) && vertex[(i + count) % count] >= clipped.first_cut;
        };
        for (std::int64_t i = 0; i < count; ++i) {
            BorderPoint p;
            p.exact = is_cut(i);
            if (p.exact) {
                p.at = clipped.cut[vertex[i] - clipped.first_cut];
            } else {
                p.at.position = clipped.mesh.position[vertex[i]];
                p.at.gradient = clipped.mesh.gradient[vertex[i]];
            }
            const auto crowds = [&](std::int64_t other) {
                return glm::distance(chains.point[other].at.position, p.at.position) <
                       feature_tuning.border_gap * clipped.mesh.side;
            };
            const std::int64_t size = chains.point.size();
            const bool last = closed && i + 1 == count;
            if (is_cut(i - 1) && is_cut(i) && is_cut(i + 1) && size > first + (last ? 2 : 0) &&
                (crowds(size - 1) || (last && crowds(first))))
                continue;
            chains.point.push_back(p);
        }
        chains.end(closed);
    }
    return chains;
}

} // namespace

SurfaceLines border_lines(base::Memory& memory, const SurfaceMesh& mesh) {
    const Chains<std::int32_t> border = border_vertices(memory, mesh);
    SurfaceLines lines(memory);
    LineBuilder builder(lines);
    for (std::int64_t c = 0; c < border.count(); ++c) {
        for (std::int64_t i = border.first[c]; i < border.first[c + 1]; ++i)
            builder.add(mesh.position[border.point[i]], mesh.gradient[border.point[i]], 1.0);
        builder.end(border.closed[c] != 0);
    }
    return lines;
}

SurfaceLines exact_border(const base::Runtime& runtime, const Level& level, const ClippedMesh& clipped,
                          const base::Progress& progress) {
    const double side = clipped.mesh.side;
    Chains<BorderPoint> chains = thinned_border(border_vertices(runtime.memory, clipped.mesh), clipped);
    const auto wanted = [&](std::int64_t, std::int64_t i, std::int64_t j, BorderPoint& p) {
        const BorderPoint& a = chains.point[i];
        const BorderPoint& b = chains.point[j];
        if (!a.exact || !b.exact) return false;
        const bool turns =
            glm::dot(glm::normalize(a.at.direction()), glm::normalize(b.at.direction())) < feature_tuning.border_turn;
        const double length = glm::distance(a.at.position, b.at.position) / side;
        p.exact = true;
        p.at.position = CubicPiece(a.at, b.at).at(0.5);
        return length > feature_tuning.longest_border_piece || (turns && length > feature_tuning.shortest_border_piece);
    };
    const auto bring = [&](base::Array<BorderPoint>& added, const auto&, const auto&) {
        base::Array<CurvePoint> points(runtime.memory);
        for (const BorderPoint& p : added) points.push_back(p.at);
        base::Array<std::uint8_t> found(runtime.memory);
        bring_to_curve(runtime, level, {1e-9 * side, 0.2 * side}, points, found, progress);
        for (std::int64_t k = 0; k < added.size(); ++k) added[k].at = points[k];
        return found;
    };
    for (int round = 0; round < most_rounds && halve_pieces(chains, wanted, bring); ++round) continue;
    SurfaceLines lines(runtime.memory);
    LineBuilder builder(lines);
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const CurvePoint& p = chains.point[i].at;
            builder.add(p.position, p.gradient, 1.0, chains.point[i].exact ? p.direction() : glm::dvec3(0.0));
        }
        builder.end(chains.closed[c] != 0);
    }
    return lines;
}

bool is_all_cut(const ClippedMesh& clipped) noexcept {
    const SurfaceMesh& mesh = clipped.mesh;
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0 && (start_of(mesh, e) < clipped.first_cut || end_of(mesh, e) < clipped.first_cut))
            return false;
    return true;
}

} // namespace hrbfnpr::curves
