// SPDX-License-Identifier: MIT
#include "curves/trace.h"

#include "curves/follow.h"
#include "curves/level_roots.h"
#include "curves/mesh_chains.h"
#include "curves/small_loops.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides of the mesh: so far may a place on the mesh be off the curve that it stands for; nearer to each other, two
// starts are one.
constexpr double reach = 1.0;
constexpr double covered = 0.35;
constexpr double same = 1e-3;
constexpr double on_curve = 0.02;
constexpr int halvings = 8;

// A sign change that the mesh sees, and which way its chain runs there.
struct Bead {
    glm::dvec3 place;
    glm::dvec3 way;
    Straddle edge;
};

base::Array<Bead> beads_of(base::Memory& memory, const SurfaceMesh& mesh, const MeshChains& chains) {
    base::Array<Bead> beads(memory);
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        const std::int64_t begin = chains.first[c];
        const std::int64_t count = chains.first[c + 1] - begin;
        const bool closed = chains.closed[c] != 0;
        const auto place = [&](std::int64_t i) {
            const std::int64_t at = closed ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1);
            return chains.crossing[begin + at].place(mesh);
        };
        for (std::int64_t i = 0; i < count; ++i) {
            const Crossing& crossing = chains.crossing[begin + i];
            beads.push_back({place(i),
                             place(i + 1) - place(i - 1),
                             {mesh.position[crossing.negative], mesh.position[crossing.positive]}});
        }
    }
    return beads;
}

class Rounds {
public:
    Rounds(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
           TraceReport& report, const base::Progress& progress)
        : runtime_(runtime), level_(level), mesh_(mesh), settings_(settings), report_(report), progress_(progress),
          curves_(runtime.memory) {
        curves_.first.push_back(0);
    }

    // Follows curves from those of the points that can be brought onto one, and are on none that there is.
    // Returns which of the points could not.
    base::Array<std::int64_t> from(base::Array<CurvePoint> points);
    // The same from a zero of g between these places.
    base::Array<std::int64_t> from(const base::Array<Straddle>& places);
    // Of these, those that no curve passes by.
    [[nodiscard]] base::Array<Bead> uncovered(const base::Array<Bead>& beads) const;
    [[nodiscard]] Curves result() && { return std::move(curves_); }

private:
    [[nodiscard]] base::Array<CurvePoint> new_ones(const base::Array<CurvePoint>& points,
                                                   const base::Array<std::uint8_t>& found) const;
    [[nodiscard]] bool passes(const geometry::PointGrid& grid, const glm::dvec3& place, const glm::dvec3& way,
                              double distance) const;
    [[nodiscard]] double distance_to(std::int64_t point, const glm::dvec3& place, const glm::dvec3& way) const noexcept;
    [[nodiscard]] geometry::PointGrid grid_of_points() const;

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const TraceSettings& settings_;
    TraceReport& report_;
    const base::Progress& progress_;
    Curves curves_;
};

geometry::PointGrid Rounds::grid_of_points() const {
    geometry::VecArray places(runtime_.memory);
    places.reserve(curves_.point.size());
    for (const CurvePoint& p : curves_.point) places.push_back(p.position);
    return {places, (settings_.longest + covered) * mesh_.side};
}

// From the pieces on both sides of a point of a curve, if they run the bead's way.
double Rounds::distance_to(std::int64_t point, const glm::dvec3& place, const glm::dvec3& along) const noexcept {
    const std::int64_t curve =
        std::upper_bound(curves_.first.begin(), curves_.first.end(), point) - curves_.first.begin() - 1;
    const std::int64_t begin = curves_.first[curve];
    const std::int64_t end = curves_.first[curve + 1];
    const CurvePoint& p = curves_.point[point];
    if (!(glm::dot(p.direction(), along) >= 0.0)) return HUGE_VAL;
    double nearest = glm::distance(p.position, place);
    for (const std::int64_t other : {point - 1, point + 1}) {
        std::int64_t at = other;
        if (other < begin || other >= end) {
            if (curves_.closed[curve] == 0) continue;
            at = other < begin ? end - 1 : begin;
        }
        const glm::dvec3 way = curves_.point[at].position - p.position;
        const double share = glm::dot(place - p.position, way) / glm::dot(way, way);
        if (!(share > 0.0 && share < 1.0)) continue;
        const CurvePoint& q = curves_.point[at];
        const glm::dvec3 foot = other > point ? CubicPiece(p, q).at(share) : CubicPiece(q, p).at(1.0 - share);
        nearest = std::min(nearest, glm::distance(foot, place));
    }
    return nearest;
}

bool Rounds::passes(const geometry::PointGrid& grid, const glm::dvec3& place, const glm::dvec3& way,
                    double distance) const {
    bool found = false;
    grid.around(place, [&](std::int64_t at) { found = found || distance_to(grid.index(at), place, way) <= distance; });
    return found;
}

base::Array<Bead> Rounds::uncovered(const base::Array<Bead>& beads) const {
    const geometry::PointGrid grid = grid_of_points();
    base::Array<std::uint8_t> is_covered(runtime_.memory, beads.size());
    runtime_.parallel.for_chunks(beads.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            is_covered[i] = passes(grid, beads[i].place, beads[i].way, covered * mesh_.side) ? 1 : 0;
    });
    base::Array<Bead> left(runtime_.memory);
    for (std::int64_t i = 0; i < beads.size(); ++i)
        if (is_covered[i] == 0) left.push_back(beads[i]);
    return left;
}

// Each place once, and none that a curve passes through already.
base::Array<CurvePoint> Rounds::new_ones(const base::Array<CurvePoint>& points,
                                         const base::Array<std::uint8_t>& found) const {
    const geometry::PointGrid before = grid_of_points();
    base::Array<CurvePoint> fresh(runtime_.memory);
    geometry::VecArray places(runtime_.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const CurvePoint& p = points[i];
        if (found[i] == 0 || passes(before, p.position, p.direction(), on_curve * mesh_.side)) continue;
        fresh.push_back(p);
        places.push_back(p.position);
    }
    const geometry::PointGrid grid(places, same * mesh_.side);
    base::Array<CurvePoint> apart(runtime_.memory);
    for (std::int64_t i = 0; i < fresh.size(); ++i) {
        bool first = true;
        grid.around(places[i], [&](std::int64_t at) {
            const std::int64_t other = grid.index(at);
            first = first && !(other < i && glm::distance(places[other], places[i]) <= same * mesh_.side &&
                               glm::dot(fresh[other].direction(), fresh[i].direction()) > 0.0);
        });
        if (first) apart.push_back(fresh[i]);
    }
    return apart;
}

base::Array<std::int64_t> Rounds::from(base::Array<CurvePoint> points) {
    base::Array<std::uint8_t> found(runtime_.memory);
    const NewtonSettings newton{settings_.tolerance * mesh_.side, reach * mesh_.side};
    report_.evaluations += bring_to_curve(runtime_, level_, newton, points, found, progress_);
    const base::Array<CurvePoint> starts = new_ones(points, found);
    report_.starts += starts.size();
    follow(runtime_, level_, mesh_, starts, settings_, curves_, report_, progress_);
    base::Array<std::int64_t> lost(runtime_.memory);
    for (std::int64_t i = 0; i < found.size(); ++i)
        if (found[i] == 0) lost.push_back(i);
    return lost;
}

base::Array<std::int64_t> Rounds::from(const base::Array<Straddle>& places) {
    base::Array<CurvePoint> points(runtime_.memory);
    report_.evaluations += halve(runtime_, level_, places, halvings, points, progress_);
    return from(std::move(points));
}

base::Array<CurvePoint> at_places(base::Memory& memory, const base::Array<Bead>& beads) {
    base::Array<CurvePoint> points(memory, beads.size());
    for (std::int64_t i = 0; i < beads.size(); ++i) points[i].position = beads[i].place;
    return points;
}

// Every so many crossings, and one in the middle of each short chain.
base::Array<Bead> first_beads(base::Memory& memory, const MeshChains& chains, const base::Array<Bead>& beads,
                              std::int64_t apart) {
    base::Array<Bead> chosen(memory);
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        const std::int64_t count = chains.first[c + 1] - chains.first[c];
        const std::int64_t starts = std::max<std::int64_t>(1, count / apart);
        for (std::int64_t s = 0; s < starts; ++s)
            chosen.push_back(beads[chains.first[c] + (2 * s + 1) * count / (2 * starts)]);
    }
    return chosen;
}

} // namespace

Curves trace(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
             TraceReport& report, const base::Progress& progress) {
    report = TraceReport{};
    base::Array<double> at_vertices(runtime.memory);
    level.at_vertices(runtime, mesh, at_vertices, progress);
    const MeshChains chains = find_chains(runtime, mesh, at_vertices);
    const base::Array<Bead> beads = beads_of(runtime.memory, mesh, chains);
    Rounds rounds(runtime, level, mesh, settings, report, progress);
    rounds.from(at_places(runtime.memory, first_beads(runtime.memory, chains, beads, settings.apart)));
    const std::int64_t first = report.starts;
    // Newton's steps from what is left, and halving where they fail.
    const base::Array<Bead> left = rounds.uncovered(beads);
    base::Array<Straddle> edges(runtime.memory);
    for (const std::int64_t i : rounds.from(at_places(runtime.memory, left))) edges.push_back(left[i].edge);
    report.missed = rounds.from(edges).size();
    const std::int64_t before = report.starts;
    report.missed +=
        rounds.from(find_small_loops(runtime, level, mesh, at_vertices, report.evaluations, progress)).size();
    report.loops = report.starts - before;
    report.added = report.starts - first;
    return std::move(rounds).result();
}

} // namespace hrbfnpr::curves
