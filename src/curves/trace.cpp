// SPDX-License-Identifier: MIT
#include "curves/trace.h"

#include "curves/chain_runs.h"
#include "curves/clip_curves.h"
#include "curves/follow.h"
#include "curves/near_curves.h"
#include "curves/small_loops.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides of the mesh: so far may a place on the mesh be off the curve that it stands for; nearer to each other, two
// starts are one.
constexpr double trace_reach = 1.0;
constexpr double covered = 0.35;
constexpr double same_seed = 1e-3;
constexpr double found_already = 0.02;
constexpr int trace_halvings = 8;
// Where no curve is found for changes of sign: cells are so many times smaller, and so many along a box's diagonal.
constexpr double closer = 8.0;
constexpr double most_cells = 128.0;
constexpr std::int64_t most_lost = 2000; // changes of sign: a surface that has more is torn, in smaller cells as well

// Each a run of its own.
Curves runs_of(const base::Array<CurvePoint>& starts) {
    Curves runs(starts.memory());
    runs.first.push_back(0);
    for (const CurvePoint& p : starts) {
        runs.point.push_back(p);
        runs.first.push_back(runs.point.size());
        runs.closed.push_back(0);
    }
    return runs;
}

class Rounds {
public:
    Rounds(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
           TraceReport& report, const base::Progress& progress)
        : runtime_(runtime), level_(level), mesh_(mesh), settings_(settings), report_(report), progress_(progress),
          curves_(runtime.memory) {
        curves_.first.push_back(0);
    }

    // Along starts that follow each other.
    void from(const Curves& starts) { add(runs_from(runtime_, level_, mesh_, starts, settings_, report_, progress_)); }
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
    [[nodiscard]] NearCurves near_curves() const {
        return {runtime_.memory, curves_, settings_.longest * mesh_.side, covered * mesh_.side};
    }
    void add(const Curves& runs) {
        report_.starts += runs.count();
        follow(runtime_, level_, mesh_, runs, settings_, curves_, report_, progress_);
    }
    [[nodiscard]] base::Array<std::uint8_t> on_curves(const base::Array<CurvePoint>& points) const;

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const TraceSettings& settings_;
    TraceReport& report_;
    const base::Progress& progress_;
    Curves curves_;
};

// Which points lie on a curve that there is.  Where samples lie a cubic may be off its curve by some percent of its
// length: then its foot is brought onto the curve, and the point must lie along that from there.
base::Array<std::uint8_t> Rounds::on_curves(const base::Array<CurvePoint>& points) const {
    const NearCurves near = near_curves();
    base::Array<std::uint8_t> on(runtime_.memory, points.size());
    base::Array<CurvePoint> feet(runtime_.memory);
    base::Array<std::int64_t> of(runtime_.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const NearCurves::Foot foot = near.nearest(points[i].position, points[i].direction());
        on[i] = foot.distance <= found_already * mesh_.side ? 1 : 0;
        if (on[i] != 0 || foot.distance > covered * mesh_.side) continue;
        feet.push_back({foot.place});
        of.push_back(i);
    }
    base::Array<std::uint8_t> found(runtime_.memory);
    const NewtonSettings newton{settings_.tolerance * mesh_.side, covered * mesh_.side};
    report_.evaluations += bring_to_curve(runtime_, level_, newton, feet, found, progress_);
    for (std::int64_t i = 0; i < of.size(); ++i) {
        const glm::dvec3 way = points[of[i]].position - feet[i].position;
        const glm::dvec3 along = glm::normalize(feet[i].direction());
        const double off = glm::length(way - glm::dot(way, along) * along);
        on[of[i]] = found[i] != 0 && off <= found_already * mesh_.side ? 1 : 0;
    }
    return on;
}

base::Array<Bead> Rounds::uncovered(const base::Array<Bead>& beads) const {
    const NearCurves near = near_curves();
    base::Array<std::uint8_t> is_covered(runtime_.memory, beads.size());
    runtime_.parallel.for_chunks(beads.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t point = -1; // beads of a chain follow each other, as a curve's points do
        for (std::int64_t i = begin; i < end; ++i) {
            point = near.point_by(beads[i].place, beads[i].way, covered * mesh_.side, point);
            is_covered[i] = point >= 0 ? 1 : 0;
        }
    });
    base::Array<Bead> left(runtime_.memory);
    for (std::int64_t i = 0; i < beads.size(); ++i)
        if (is_covered[i] == 0) left.push_back(beads[i]);
    return left;
}

// Each place once, and none that a curve passes through already.
base::Array<CurvePoint> Rounds::new_ones(const base::Array<CurvePoint>& points,
                                         const base::Array<std::uint8_t>& found) const {
    const base::Array<std::uint8_t> known = on_curves(points);
    base::Array<CurvePoint> fresh(runtime_.memory);
    geometry::VecArray places(runtime_.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const CurvePoint& p = points[i];
        if (found[i] == 0 || known[i] != 0) continue;
        fresh.push_back(p);
        places.push_back(p.position);
    }
    const geometry::PointGrid grid(places, same_seed * mesh_.side);
    base::Array<CurvePoint> apart(runtime_.memory);
    for (std::int64_t i = 0; i < fresh.size(); ++i) {
        bool first = true;
        grid.around(places[i], [&](std::int64_t at) {
            const std::int64_t other = grid.index(at);
            first = first && !(other < i && glm::distance(places[other], places[i]) <= same_seed * mesh_.side &&
                               glm::dot(fresh[other].direction(), fresh[i].direction()) > 0.0);
        });
        if (first) apart.push_back(fresh[i]);
    }
    return apart;
}

base::Array<std::int64_t> Rounds::from(base::Array<CurvePoint> points) {
    base::Array<std::uint8_t> found(runtime_.memory);
    const NewtonSettings newton{settings_.tolerance * mesh_.side, trace_reach * mesh_.side};
    report_.evaluations += bring_to_curve(runtime_, level_, newton, points, found, progress_);
    add(runs_of(new_ones(points, found)));
    base::Array<std::int64_t> lost(runtime_.memory);
    for (std::int64_t i = 0; i < found.size(); ++i)
        if (found[i] == 0) lost.push_back(i);
    return lost;
}

base::Array<std::int64_t> Rounds::from(const base::Array<Straddle>& places) {
    base::Array<CurvePoint> points(runtime_.memory);
    report_.evaluations += halve(runtime_, level_, places, trace_halvings, points, progress_);
    return from(std::move(points));
}

base::Array<CurvePoint> at_places(base::Memory& memory, const base::Array<Bead>& beads) {
    base::Array<CurvePoint> points(memory, beads.size());
    for (std::int64_t i = 0; i < beads.size(); ++i) points[i].position = beads[i].place;
    return points;
}

// Boxes around the places that are near each other.
base::Array<geometry::Bounds> boxes_around(base::Memory& memory, const base::Array<Straddle>& edges, double margin) {
    base::Array<geometry::Bounds> boxes(memory);
    const auto box_of = [&](const Straddle& edge) {
        return geometry::Bounds{glm::min(edge.negative, edge.positive) - margin,
                                glm::max(edge.negative, edge.positive) + margin};
    };
    for (const Straddle& edge : edges) {
        const geometry::Bounds own = box_of(edge);
        bool in_one = false;
        for (geometry::Bounds& box : boxes) {
            in_one = glm::all(glm::lessThan(own.min, box.max)) && glm::all(glm::lessThan(box.min, own.max));
            if (!in_one) continue;
            box = {glm::min(box.min, own.min), glm::max(box.max, own.max)};
            break;
        }
        if (!in_one) boxes.push_back(own);
    }
    return boxes;
}

// Changes of sign that no curve was found for: on a mesh of smaller cells there, which need not join what the surface
// does not, as where |grad f| nearly vanishes.
std::int64_t look_closer(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                         const base::Array<Straddle>& lost, Rounds& rounds, const base::Progress& progress) {
    geometry::VecArray seeds(runtime.memory);
    for (const Straddle& edge : lost) {
        seeds.push_back(edge.negative);
        seeds.push_back(edge.positive);
    }
    base::Array<Bead> beads(runtime.memory);
    for (const geometry::Bounds& box : boxes_around(runtime.memory, lost, mesh.side)) {
        MeshSettings settings;
        settings.region = {glm::max(box.min, mesh.region.min), glm::min(box.max, mesh.region.max)};
        settings.side = std::max(mesh.side / closer, glm::length(settings.region.size()) / most_cells);
        const SurfaceMesh part = triangulate(runtime, level.surface(), seeds, settings, {});
        base::Array<double> at_vertices(runtime.memory);
        level.at_vertices(runtime, part, at_vertices, progress);
        for (const Bead& bead : beads_of(runtime, part, find_chains(runtime, part, at_vertices))) beads.push_back(bead);
    }
    const base::Array<Bead> left = rounds.uncovered(beads);
    base::Array<Straddle> edges(runtime.memory);
    for (const std::int64_t i : rounds.from(at_places(runtime.memory, left))) edges.push_back(left[i].edge);
    return rounds.from(edges).size();
}

} // namespace

Curves trace(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
             TraceReport& report, const base::Progress& progress, const Curves* near) {
    report = TraceReport{};
    base::Array<double> at_vertices(runtime.memory);
    level.at_vertices(runtime, mesh, at_vertices, progress);
    const MeshChains chains = find_chains(runtime, mesh, at_vertices);
    const base::Array<Bead> beads = beads_of(runtime, mesh, chains);
    Rounds rounds(runtime, level, mesh, settings, report, progress);
    if (near != nullptr)
        rounds.from(thinned(runtime, mesh, *near, settings));
    else
        rounds.from(starts_of(runtime, mesh, chains, beads, settings));
    const std::int64_t first = report.starts;
    // Newton's steps from what is left, and halving where they fail.
    const base::Array<Bead> left = rounds.uncovered(beads);
    base::Array<Straddle> edges(runtime.memory);
    for (const std::int64_t i : rounds.from(at_places(runtime.memory, left))) edges.push_back(left[i].edge);
    base::Array<Straddle> lost(runtime.memory);
    for (const std::int64_t i : rounds.from(edges)) lost.push_back(edges[i]);
    const std::int64_t before = report.starts;
    const base::Array<Straddle> loops =
        find_small_loops(runtime, level, mesh, at_vertices, report.evaluations, progress);
    for (const std::int64_t i : rounds.from(loops)) lost.push_back(loops[i]);
    report.loops = report.starts - before;
    report.missed = lost.size() > most_lost ? lost.size() : look_closer(runtime, level, mesh, lost, rounds, progress);
    report.added = report.starts - first;
    Curves curves = std::move(rounds).result();
    return mesh.end != nullptr ? clip(runtime, level, *mesh.end, curves, progress) : std::move(curves);
}

} // namespace hrbfnpr::curves
