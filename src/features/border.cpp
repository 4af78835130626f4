// SPDX-License-Identifier: MIT
#include "features/border.h"

#include <utility>

namespace hrbfnpr::curves {
namespace {

// In sides: points of the mesh that are nearer to the one before say nothing more.
constexpr double nearest = 0.1;
constexpr double shortest = 1e-3;
constexpr double tolerance = 1e-9;
constexpr double farthest = 0.2;
// Between points, by the cosine: 0.1 radians.  Finer than curves elsewhere, as contours run beside it where they end.
constexpr double turn = 0.995;
constexpr double longest = 0.5; // in sides
constexpr int most_rounds = 6;
// The cosine between a tangent and the ways along the border: others are of a kink.
constexpr double least_along = 0.5;

// A point of the border, where it was cut or where the region ends.
struct BorderPoint {
    CurvePoint at;
    bool exact;
};

struct Chains {
    explicit Chains(base::Memory& memory) : first(memory), closed(memory), point(memory) { first.push_back(0); }
    void end(bool is_closed) {
        first.push_back(point.size());
        closed.push_back(is_closed ? 1 : 0);
    }
    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }

    base::Array<std::int64_t> first;
    base::Array<std::uint8_t> closed;
    base::Array<BorderPoint> point;
};

class Borders {
public:
    Borders(const base::Runtime& runtime, const Level& level, const ClippedMesh& clipped)
        : runtime_(runtime), level_(level), clipped_(clipped), mesh_(clipped.mesh) {}

    [[nodiscard]] SurfaceLines run(const base::Progress& progress) const;

private:
    [[nodiscard]] Chains chains() const;
    [[nodiscard]] BorderPoint point_of(std::int32_t vertex) const;
    void add_chain(const base::Array<std::int32_t>& vertices, bool closed, Chains& chains) const;
    [[nodiscard]] Chains refined(const Chains& chains, bool& changed, const base::Progress& progress) const;
    [[nodiscard]] bool fits(const Chains& chains, std::int64_t c, std::int64_t i) const;
    [[nodiscard]] SurfaceLines lines(const Chains& chains) const;

    const base::Runtime& runtime_;
    const Level& level_;
    const ClippedMesh& clipped_;
    const SurfaceMesh& mesh_;
};

BorderPoint Borders::point_of(std::int32_t vertex) const {
    if (vertex >= clipped_.first_cut) return {clipped_.cut[vertex - clipped_.first_cut], true};
    CurvePoint p;
    p.position = mesh_.position[vertex];
    p.gradient = mesh_.gradient[vertex];
    return {p, false};
}

// Points of the cut that crowd are left out, but for those where the region's end begins.
void Borders::add_chain(const base::Array<std::int32_t>& vertices, bool closed, Chains& chains) const {
    const std::int64_t count = vertices.size();
    const auto is_cut = [&](std::int64_t i) {
        return (closed || (i >= 0 && i < count)) && vertices[(i + count) % count] >= clipped_.first_cut;
    };
    const std::int64_t first = chains.point.size();
    for (std::int64_t i = 0; i < count; ++i) {
        const BorderPoint p = point_of(vertices[i]);
        const bool along_cut = is_cut(i - 1) && is_cut(i) && is_cut(i + 1);
        const std::int64_t size = chains.point.size();
        const auto crowds = [&](const BorderPoint& other) {
            return glm::distance(other.at.position, p.at.position) < nearest * mesh_.side;
        };
        const bool last = closed && i + 1 == count;
        if (along_cut && size > first + (last ? 2 : 0) &&
            (crowds(chains.point[size - 1]) || (last && crowds(chains.point[first]))))
            continue;
        chains.point.push_back(p);
    }
    chains.end(closed);
}

Chains Borders::chains() const {
    base::Array<std::int32_t> after(runtime_.memory, mesh_.vertices()); // 1 + the next vertex along the border
    for (std::int64_t e = 0; e < mesh_.corner.size(); ++e)
        if (mesh_.neighbour[e] < 0) after[mesh_.corner[e]] = 1 + mesh_.corner[e - e % 3 + (e + 1) % 3];
    Chains found(runtime_.memory);
    base::Array<std::int32_t> vertices(runtime_.memory);
    for (std::int64_t start = 0; start < mesh_.vertices(); ++start) {
        if (after[start] == 0) continue;
        vertices.clear();
        std::int64_t at = start;
        while (after[at] != 0) {
            vertices.push_back(static_cast<std::int32_t>(at));
            at = std::exchange(after[at], 0) - 1;
        }
        if (at != start) vertices.push_back(static_cast<std::int32_t>(at));
        add_chain(vertices, at == start, found);
    }
    return found;
}

// A point more where the border turns too much between two.
Chains Borders::refined(const Chains& chains, bool& changed, const base::Progress& progress) const {
    const auto next = [&](std::int64_t c, std::int64_t i) {
        return i + 1 < chains.first[c + 1] ? i + 1 : chains.closed[c] != 0 ? chains.first[c] : -1;
    };
    base::Array<CurvePoint> added(runtime_.memory);
    base::Array<std::int64_t> after(runtime_.memory);
    for (std::int64_t c = 0; c < chains.count(); ++c)
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const std::int64_t j = next(c, i);
            if (j < 0 || !chains.point[i].exact || !chains.point[j].exact) continue;
            const CurvePoint& a = chains.point[i].at;
            const CurvePoint& b = chains.point[j].at;
            const bool turns = glm::dot(glm::normalize(a.direction()), glm::normalize(b.direction())) < turn;
            const double length = glm::distance(a.position, b.position) / mesh_.side;
            if (!(length > longest || (turns && length > shortest))) continue;
            CurvePoint p;
            p.position = CubicPiece(a, b).at(0.5);
            added.push_back(p);
            after.push_back(i);
        }
    base::Array<std::uint8_t> found(runtime_.memory);
    bring_to_curve(runtime_, level_, {tolerance * mesh_.side, farthest * mesh_.side}, added, found, progress);
    Chains finer(runtime_.memory);
    std::int64_t k = 0;
    changed = false;
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            finer.point.push_back(chains.point[i]);
            if (k >= after.size() || after[k] != i) continue;
            if (found[k] != 0) finer.point.push_back({added[k], true});
            changed = changed || found[k] != 0;
            ++k;
        }
        finer.end(chains.closed[c] != 0);
    }
    return finer;
}

// Whether a tangent fits to the ways from the point before and to the one behind.  Where the nearest samples change, s
// has a kink, and tangents of both sides meet there.
bool Borders::fits(const Chains& chains, std::int64_t c, std::int64_t i) const {
    const std::int64_t first = chains.first[c];
    const std::int64_t count = chains.first[c + 1] - first;
    const CurvePoint& p = chains.point[i].at;
    const glm::dvec3 tangent = glm::normalize(p.direction());
    const auto along = [&](std::int64_t from, std::int64_t to) {
        if (chains.closed[c] == 0 && (from < first || to >= first + count)) return true;
        const glm::dvec3 way = chains.point[first + (to - first + count) % count].at.position -
                               chains.point[first + (from - first + count) % count].at.position;
        return glm::dot(way, tangent) >= least_along * glm::length(way);
    };
    return along(i - 1, i) && along(i, i + 1);
}

SurfaceLines Borders::lines(const Chains& chains) const {
    SurfaceLines found(runtime_.memory);
    LineBuilder builder(found);
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const CurvePoint& p = chains.point[i].at;
            if (chains.point[i].exact && fits(chains, c, i))
                builder.add(p.position, p.gradient, 1.0, p.direction());
            else
                builder.add(p.position, p.gradient, 1.0);
        }
        builder.end(chains.closed[c] != 0);
    }
    return found;
}

SurfaceLines Borders::run(const base::Progress& progress) const {
    Chains found = chains();
    bool changed = true;
    for (int round = 0; round < most_rounds && changed; ++round) found = refined(found, changed, progress);
    return lines(found);
}

} // namespace

SurfaceLines exact_border(const base::Runtime& runtime, const Level& level, const ClippedMesh& clipped,
                          const base::Progress& progress) {
    return Borders(runtime, level, clipped).run(progress);
}

bool is_all_cut(const ClippedMesh& clipped) noexcept {
    const SurfaceMesh& mesh = clipped.mesh;
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0 &&
            (mesh.corner[e] < clipped.first_cut || mesh.corner[e - e % 3 + (e + 1) % 3] < clipped.first_cut))
            return false;
    return true;
}

SurfaceLines border_lines(base::Memory& memory, const SurfaceMesh& mesh) {
    base::Array<std::int32_t> after(memory, mesh.vertices()); // 1 + the next vertex along the border
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        if (mesh.neighbour[e] < 0) after[mesh.corner[e]] = 1 + mesh.corner[e - e % 3 + (e + 1) % 3];
    SurfaceLines lines(memory);
    LineBuilder builder(lines);
    for (std::int64_t start = 0; start < mesh.vertices(); ++start) {
        if (after[start] == 0) continue;
        std::int64_t at = start;
        while (after[at] != 0) {
            builder.add(mesh.position[at], mesh.gradient[at], 1.0);
            at = std::exchange(after[at], 0) - 1;
        }
        builder.end(at == start);
    }
    return lines;
}

} // namespace hrbfnpr::curves
