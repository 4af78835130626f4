// SPDX-License-Identifier: MIT
// The steps of tracing:
//
//   find_edge_crossings      (mesh_edges.h) finds crossings: places on edges of the mesh where g changes its sign
//   runs_from                makes runs of points on curves, from crossings or from the curves of the previous view: it
//                            moves all starts onto curves at once, and halves each gap between two points until a
//                            cubic links them or it is known that the curve does not connect them
//   follow                   follows the curve from the end of each run to the beginning of the next run, with a
//                            predictor and a corrector
//   crossings_without_curve  finds crossings without a curve near them; Newton's method or bisection moves them onto
//                            further curves
//   find_small_loops         finds curves between the mesh's vertices, around extrema of g
//   trace_on_finer_mesh      makes a finer mesh around changes of sign for which no curve was found
//   clip                     (curve_changes.h) keeps the parts of curves that lie on the surface
#include "curves/trace.h"

#include "base/list.h"
#include "curves/curve_changes.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// ---- Runs

glm::dvec3 unit_direction(const CurvePoint& p) noexcept { return glm::normalize(p.direction()); }

// Whether the curve is known to connect a point of a chain to the next point.
enum class Link : std::uint8_t { unknown, linked, parted };

struct RunPoint {
    CurvePoint point;
    Link link = Link::unknown;
};

// Returns whether the cubic between two points follows the curve.
bool is_linked(const CurvePoint& a, const CurvePoint& b, double side, const TraceSettings& settings) noexcept {
    const glm::dvec3 way = b.position - a.position;
    const double length = glm::length(way);
    if (!(length <= settings.longest * side)) return false;
    const double limit = length < curve_tuning.kink_length * side ? curve_tuning.sharpest_kink : settings.turn;
    const glm::dvec3 begin = unit_direction(a);
    const glm::dvec3 end = unit_direction(b);
    return glm::distance(begin, end) <= limit && glm::distance(begin, way / length) <= curve_tuning.off_chord * limit &&
           glm::distance(end, way / length) <= curve_tuning.off_chord * limit;
}

// Returns whether p follows `before` along the curve. Newton steps also move points along the curve, so points may
// coincide or change their order. Where the curve turns sharply this cannot be decided, and it returns true.
bool in_order(const CurvePoint& before, const CurvePoint& p, double side, const TraceSettings& settings) noexcept {
    const glm::dvec3 way = p.position - before.position;
    const glm::dvec3 a = unit_direction(before);
    const glm::dvec3 b = unit_direction(p);
    return glm::distance(a, b) > settings.turn ||
           (glm::length(way) > curve_tuning.least_run * settings.longest * side && glm::dot(a, way) > 0.0 &&
            glm::dot(b, way) > 0.0);
}

bool is_between(const CurvePoint& m, const CurvePoint& a, const CurvePoint& b) noexcept {
    const glm::dvec3 way = b.position - a.position;
    return glm::dot(m.position - a.position, way) > 0.0 && glm::dot(b.position - m.position, way) > 0.0 &&
           glm::dot(m.direction(), way) > 0.0;
}

// Drops points that are near a longer run. They occur where the mesh crosses a curve back and forth.
Curves without_duplicates(const base::Runtime& runtime, const Curves& runs, double distance, double longest) {
    const NearCurves near(runs, longest, distance);
    base::Array<std::uint8_t> is_duplicate(runtime.memory, runs.point.size());
    const auto is_longer = [&](std::int64_t s, std::int64_t r) {
        return runs.size_of(s) > runs.size_of(r) || (runs.size_of(s) == runs.size_of(r) && s < r);
    };
    runtime.parallel.for_chunks(runs.count(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t r = begin; r < end; ++r)
            for (std::int64_t i = runs.first[r]; i < runs.first[r + 1]; ++i) {
                const std::int64_t s = near.passing(runs.point[i].position, runs.point[i].direction(), distance, r);
                is_duplicate[i] = s >= 0 && is_longer(s, r) ? 1 : 0;
            }
    });
    Curves kept(runtime.memory);
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        const std::int64_t first = runs.first[r];
        const std::int64_t count = runs.size_of(r);
        for_parts(
            count, false, [&](std::int64_t i) { return is_duplicate[first + i] == 0; },
            [&](std::int64_t begin, std::int64_t end, bool) {
                for (std::int64_t i = begin; i < end; ++i) kept.point.push_back(runs.point[first + i]);
                kept.end(end - begin == count && runs.closed[r] != 0);
            });
    }
    return kept;
}

// Chooses some crossings of each chain as starts. The distance between two starts is a fixed share of the longest step.
// Sets only the positions of the starts.
Curves starts_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const Chains<EdgeCrossing>& crossings,
                 const TraceSettings& settings) {
    Curves starts(runtime.memory);
    const double apart = curve_tuning.chosen_apart * settings.longest * mesh.side;
    for (std::int64_t c = 0; c < crossings.count(); ++c) {
        double way = apart;
        for (std::int64_t i = crossings.first[c]; i < crossings.first[c + 1]; ++i) {
            if (i > crossings.first[c]) way += glm::distance(crossings.point[i].place, crossings.point[i - 1].place);
            if (way < apart) continue;
            starts.point.push_back({crossings.point[i].place});
            way = 0.0;
        }
        starts.end(crossings.closed[c] != 0);
    }
    return starts;
}

// Leaves out some of the starts whose directions are known. The distances between the remaining starts are about as
// long as in starts_of(), but shorter where the curve turns.
Curves thinned(const base::Runtime& runtime, const SurfaceMesh& mesh, const Curves& starts,
               const TraceSettings& settings) {
    const double apart = curve_tuning.chosen_apart * settings.longest * mesh.side;
    Curves kept(runtime.memory);
    for (std::int64_t c = 0; c < starts.count(); ++c) {
        std::int64_t last = starts.first[c];
        for (std::int64_t i = last; i < starts.first[c + 1]; ++i) {
            const bool needed = i == last || i + 1 == starts.first[c + 1] ||
                                glm::distance(starts.point[i + 1].position, starts.point[last].position) > apart ||
                                glm::distance(unit_direction(starts.point[i + 1]), unit_direction(starts.point[last])) >
                                    curve_tuning.kept_turn * settings.turn;
            if (!needed) continue;
            kept.point.push_back(starts.point[i]);
            last = i;
        }
        kept.end(starts.closed[c] != 0);
    }
    return kept;
}

// Makes runs of points from starts. A run is a part of a curve, or a whole closed curve. Runs overlap only near their
// ends. The starts must be in order along their curves.
Curves runs_from(const base::Work& work, const Level& level, const SurfaceMesh& mesh, const Curves& starts,
                 const TraceSettings& settings, TraceReport& report) {
    const double side = mesh.side;
    HRBFNPR_ASSERT(side > 0.0 && settings.longest > 0.0);
    const auto bring_points = [&](base::Array<CurvePoint>& points, double farthest) {
        base::Array<std::uint8_t> found(work.memory);
        report.evaluations += bring_to_curve(work, level, {settings.tolerance * side, farthest}, points, found);
        return found;
    };
    base::Array<CurvePoint> points(work.memory, starts.point.size());
    std::copy(starts.point.begin(), starts.point.end(), points.begin());
    const base::Array<std::uint8_t> brought = bring_points(points, curve_tuning.start_reach * side);
    Chains<RunPoint> chains(work.memory); // the starts after moving onto curves
    for (std::int64_t c = 0; c < starts.count(); ++c) {
        for (std::int64_t i = starts.first[c]; i < starts.first[c + 1]; ++i)
            if (brought[i] != 0 && (chains.point.size() == chains.first.back() ||
                                    in_order(chains.point.back().point, points[i], side, settings)))
                chains.point.push_back({points[i]});
        chains.end(starts.closed[c] != 0);
    }
    // A chain of two points has only one gap, even if it is closed.
    const auto is_gap_between = [&](std::int64_t c, std::int64_t i, std::int64_t j) {
        return j > i || (j >= 0 && chains.size_of(c) > 2);
    };
    const auto wanted = [&](std::int64_t c, std::int64_t i, std::int64_t j, RunPoint& p) {
        RunPoint& a = chains.point[i];
        const RunPoint& b = chains.point[j];
        if (!is_gap_between(c, i, j) || a.link != Link::unknown) return false;
        if (is_linked(a.point, b.point, side, settings)) {
            a.link = Link::linked;
            return false;
        }
        const double width = glm::distance(a.point.position, b.point.position) / side;
        if (!(width <= curve_tuning.widest_gap * settings.longest && width >= curve_tuning.kink_length)) {
            a.link = Link::parted;
            return false;
        }
        p.point.position = CubicPiece(a.point, b.point).at(0.5);
        return true;
    };
    const auto bring = [&](base::Array<RunPoint>& added, const base::Array<std::int64_t>& of,
                           const base::Array<std::int64_t>& after) {
        base::Array<CurvePoint> middle(work.memory);
        for (const RunPoint& p : added) middle.push_back(p.point);
        base::Array<std::uint8_t> found = bring_points(middle, 0.5 * settings.longest * side);
        for (std::int64_t k = 0; k < added.size(); ++k) {
            added[k].point = middle[k];
            RunPoint& a = chains.point[after[k]];
            const RunPoint& b = chains.point[chains.next(of[k], after[k])];
            if (found[k] != 0 && !is_between(middle[k], a.point, b.point)) found[k] = 0;
            if (found[k] == 0) a.link = Link::parted;
        }
        return found;
    };
    for (int round = 0; round < curve_tuning.gap_halvings && halve_pieces(chains, wanted, bring); ++round) work.check();
    Curves runs(work.memory);
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        const std::int64_t first = chains.first[c];
        const std::int64_t count = chains.size_of(c);
        const auto joined = [&](std::int64_t k) {
            const RunPoint& a = chains.point[first + k];
            const std::int64_t j = chains.next(c, first + k);
            return is_gap_between(c, first + k, j) &&
                   (a.link == Link::linked ||
                    (a.link == Link::unknown && is_linked(a.point, chains.point[j].point, side, settings)));
        };
        for_joined(count, chains.closed[c] != 0, joined, [&](std::int64_t begin, std::int64_t end, bool whole) {
            for (std::int64_t k = begin; k < end; ++k) runs.point.push_back(chains.point[first + k % count].point);
            if (begin == end) return;
            runs.end(whole);
        });
    }
    return without_duplicates(work, runs, curve_tuning.found_already * side, settings.longest * side);
}

// ---- Following

enum class PathEnd : std::uint8_t { none, at_run, border, broken };

// A curve that is being followed.
struct Path {
    std::int64_t start; // the index of the run at which the path starts
    double sense;       // 1 for a path that is followed forwards, -1 backwards
    CurvePoint last;
    glm::dvec3 tangent;   // unit tangent in the direction of the path
    glm::dvec3 bend{0.0}; // the change of the tangent in the last step, divided by the length of the step
    double step;
    CurvePoint trial;
    glm::dvec3 predicted{0.0};
    int iteration = 0;
    std::int32_t steps = 0, evaluations = 0;
    std::int64_t passed = -1; // the index of the last point in Paths::passed, or -1
    std::int64_t met = -1;    // the run that the path met, or -1
    // The point of the run `met` that the path met. It is the first point, or a later one if the ends overlap.
    std::int64_t met_point = 0;
    PathEnd end = PathEnd::none;
};

// A point of a path, with the index of the point before it, or -1 for the first point.
struct PathPoint {
    CurvePoint point;
    std::int64_t before;
};

// The paths between runs, and the data that they share.
struct Paths {
    Paths(const SurfaceMesh& meshed, const Curves& known, const TraceSettings& by)
        : mesh(meshed), runs(known), settings(by), path(runs.point.memory()), passed(runs.point.memory()),
          forward(runs.point.memory(), runs.count()), backward(runs.point.memory(), runs.count()),
          before(runs.point.memory(), runs.count()), passed_by(runs.point.memory(), runs.count()),
          run_of(curve_of_points(runs)), grid(positions_of(runs.point), 0.75 * settings.longest * mesh.side) {
        for (base::Array<std::int64_t>* const all : {&forward, &backward, &before})
            std::fill(all->begin(), all->end(), -1);
    }

    const SurfaceMesh& mesh;
    const Curves& runs;
    const TraceSettings& settings;
    base::Array<Path> path;
    base::Array<PathPoint> passed;
    // For each run: the indices of its path forwards and of its path backwards, and of the run from which a path leads
    // to it. -1: no path or run.
    base::Array<std::int64_t> forward, backward, before;
    base::Array<std::uint8_t> passed_by; // 1 if another path passes this run, which is then left out
    base::Array<std::int32_t> run_of;    // for each point of the runs: its run
    geometry::PointGrid grid;            // a grid of the positions of the runs' points
};

// Returns the largest turn that is allowed in a step, in radians. The length of the step is in sides.
double turn_limit(const TraceSettings& settings, double step) noexcept {
    return step < curve_tuning.kink_length ? curve_tuning.sharpest_kink : settings.turn;
}

glm::dvec3 unit_along(const CurvePoint& p, double sense) noexcept { return sense * glm::normalize(p.direction()); }

void predict(Path& path) noexcept {
    const double h = path.step;
    path.predicted = path.last.position + h * path.tangent + 0.5 * h * h * path.bend;
    path.trial.position = path.predicted;
    path.iteration = 0;
}

void shorten(const Paths& paths, Path& path, double share) noexcept {
    path.step *= share;
    if (path.step < paths.settings.shortest * paths.mesh.side || path.evaluations > paths.settings.evaluation_limit)
        path.end = PathEnd::broken;
    else
        predict(path);
}

// Finds the first point of a run that the path meets in this step, and sets `met` to the run. Distances are measured
// from the cubic through both ends of the step, which approximates the curve.
bool meets_run(const Paths& paths, Path& path, const glm::dvec3& tangent) {
    const double within = curve_tuning.beside;
    const glm::dvec3 a = path.last.position;
    const glm::dvec3 chord = path.trial.position - a;
    const double length = glm::length(chord);
    const CubicPiece cubic = path.sense > 0.0 ? CubicPiece(path.last, path.trial) : CubicPiece(path.trial, path.last);
    double first = 2.0;
    paths.grid.around(a + 0.5 * chord, [&](std::int64_t at) {
        const std::int64_t point = paths.grid.index(at);
        const std::int64_t run = paths.run_of[point];
        if (paths.runs.closed[run] != 0) return;
        if (run == path.start && path.steps < curve_tuning.fewest_steps_of_loop) return;
        const CurvePoint& p = paths.runs.point[point];
        const double u = glm::dot(p.position - a, chord) / (length * length);
        if (!(u > 1e-9 && u <= 1.0 + within && u < first)) return;
        const glm::dvec3 off = p.position - cubic.at(path.sense > 0.0 ? u : 1.0 - u);
        const double along = glm::dot(off, chord) / length;
        if (glm::dot(off, off) - along * along > within * within * length * length) return;
        if (glm::dot(unit_along(p, path.sense), tangent) < curve_tuning.same_way) return;
        path.met = run;
        path.met_point = point;
        first = u;
    });
    return path.met >= 0;
}

// Makes the trial the next point of the path.
void accept(Paths& paths, Path& path, const glm::dvec3& tangent) {
    const double side = paths.mesh.side;
    HRBFNPR_ASSERT(std::abs(glm::length(tangent) - 1.0) < 1e-9);
    const bool meets = meets_run(paths, path, tangent);
    const double length = glm::distance(path.trial.position, path.last.position);
    const glm::dvec3 turned = tangent - path.tangent;
    path.bend = turned / length;
    path.last = path.trial;
    path.tangent = tangent;
    ++path.steps;
    if (meets) {
        path.end = PathEnd::at_run;
        return;
    }
    paths.passed.push_back({path.trial, path.passed});
    path.passed = paths.passed.size() - 1;
    const double turn = glm::length(turned);
    const double wanted = curve_tuning.step_safety * paths.settings.turn;
    path.step *= turn > 0.0 ? std::clamp(wanted / turn, 0.5, 2.0) : 2.0;
    path.step = std::min(path.step, paths.settings.longest * side);
    predict(path);
}

// Decides about a trial after its evaluation: it is accepted, corrected, or tried with a shorter step.
void take(Paths& paths, Path& path) {
    if (++path.evaluations > paths.settings.evaluation_limit) {
        path.end = PathEnd::broken;
        return;
    }
    const glm::dvec3 way = path.trial.newton_step();
    const double off = glm::distance(path.trial.position + way, path.predicted);
    const double limit = turn_limit(paths.settings, path.step / paths.mesh.side);
    if (!(off <= limit * path.step)) return shorten(paths, path, 0.5);
    path.trial.position += way;
    if (glm::length(way) > curve_tuning.converged * path.step) {
        if (++path.iteration >= curve_tuning.corrector_steps) shorten(paths, path, 0.5);
        return;
    }
    const glm::dvec3 tangent = unit_along(path.trial, path.sense);
    const double turn = glm::distance(tangent, path.tangent);
    if (!(turn <= limit)) return shorten(paths, path, std::clamp(curve_tuning.step_safety * limit / turn, 0.25, 0.7));
    if (paths.mesh.region.contains(path.trial.position)) return accept(paths, path, tangent);
    // Near the wall of the region, steps become shorter.
    if (path.step <= curve_tuning.close * paths.mesh.side)
        path.end = PathEnd::border;
    else
        shorten(paths, path, 0.5);
}

// Follows a path from each of the given runs, all in parallel: forwards from the last point of the run, or backwards
// from the first.
void follow_from(const base::Work& work, const Level& level, const base::Array<std::int64_t>& from, double sense,
                 Paths& paths, TraceReport& report) {
    const Curves& runs = paths.runs;
    base::Array<std::int64_t> active(work.memory);
    for (const std::int64_t r : from) {
        if (runs.closed[r] != 0) continue;
        const CurvePoint& last = runs.point[sense > 0.0 ? runs.first[r + 1] - 1 : runs.first[r]];
        Path path{r, sense, last, unit_along(last, sense), glm::dvec3(0.0), curve_tuning.first_step * paths.mesh.side,
                  {}};
        // The points of the run count as steps of the path.
        if (sense > 0.0) path.steps = static_cast<std::int32_t>(runs.size_of(r) - 1);
        predict(path);
        (sense > 0.0 ? paths.forward : paths.backward)[r] = paths.path.size();
        active.push_back(paths.path.size());
        paths.path.push_back(path);
    }
    base::Array<CurvePoint> trial(work.memory);
    while (!active.empty()) {
        trial.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) trial[i].position = paths.path[active[i]].trial.position;
        evaluate(work, level, trial);
        report.evaluations += trial.size();
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            Path& path = paths.path[active[i]];
            path.trial = trial[i];
            take(paths, path);
            if (path.end == PathEnd::none) active[left++] = active[i];
        }
        active.resize(left);
    }
}

// Returns whether this is an open run to which no path leads.
bool is_first(const Paths& paths, std::int64_t r) noexcept {
    return paths.runs.closed[r] == 0 && paths.before[r] < 0 && paths.passed_by[r] == 0;
}

// Adds the curves. Each consists of runs and the paths between them.
void add_curves(const Paths& paths, Curves& curves, TraceReport& report) {
    const Curves& runs = paths.runs;
    base::Array<std::uint8_t> done(runs.point.memory(), runs.count());
    const auto add_path = [&](std::int64_t number, bool reversed) {
        if (number < 0) return;
        const std::int64_t begin = curves.point.size();
        for (std::int64_t i = paths.path[number].passed; i >= 0; i = paths.passed[i].before)
            curves.point.push_back(paths.passed[i].point);
        if (!reversed) std::reverse(curves.point.begin() + begin, curves.point.end());
    };
    const auto add_from = [&](std::int64_t run) {
        while (run >= 0 && done[run] == 0) {
            done[run] = 1;
            const bool closed = runs.closed[run] != 0;
            // The path may have met a point of the run after its first one. The points before are left out.
            const std::int64_t before = closed ? -1 : paths.before[run];
            const std::int64_t first = before >= 0 ? paths.path[paths.forward[before]].met_point : runs.first[run];
            for (std::int64_t i = first; i < runs.first[run + 1]; ++i) curves.point.push_back(runs.point[i]);
            add_path(paths.forward[run], false);
            const std::int64_t met = closed ? -1 : paths.path[paths.forward[run]].met;
            run = met >= 0 && paths.before[met] == run ? met : -1;
        }
    };
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        if (!is_first(paths, r)) continue;
        add_path(paths.backward[r], true);
        add_from(r);
        curves.end(false);
    }
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        if (done[r] != 0 || paths.passed_by[r] != 0) continue;
        add_from(r);
        curves.end(true);
    }
    for (const Path& path : paths.path) {
        if (paths.passed_by[path.start] != 0) continue;
        if (path.end == PathEnd::broken || (path.sense > 0.0 && path.met >= 0 && paths.before[path.met] != path.start))
            ++report.broken;
    }
}

// Connects the runs by paths, and adds the resulting curves.
void follow(const base::Work& work, const Level& level, const SurfaceMesh& mesh, const Curves& runs,
            const TraceSettings& settings, Curves& curves, TraceReport& report) {
    report.starts += runs.count();
    Paths paths(mesh, runs, settings);
    base::Array<std::int64_t> all(work.memory), first(work.memory);
    for (std::int64_t r = 0; r < runs.count(); ++r) all.push_back(r);
    follow_from(work, level, all, 1.0, paths, report);
    // If several paths meet a run, the path that meets its earliest point is used.
    for (const Path& path : paths.path) {
        if (path.met < 0) continue;
        std::int64_t& before = paths.before[path.met];
        if (before < 0 || path.met_point < paths.path[paths.forward[before]].met_point) before = path.start;
    }
    // Two paths may meet the same run. If no path leads to the run A at which one of them starts, the other path has
    // passed A at a kink. A is then left out. If a curve is lost by this, no curve is found near its changes of sign.
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        const std::int64_t met = runs.closed[r] != 0 ? -1 : paths.path[paths.forward[r]].met;
        if (met < 0 || paths.before[met] == r) continue;
        std::int64_t late = r;
        if (paths.before[r] >= 0 && paths.before[paths.before[met]] < 0) late = std::exchange(paths.before[met], r);
        if (paths.before[late] < 0) paths.passed_by[late] = 1;
    }
    for (std::int64_t r = 0; r < runs.count(); ++r)
        if (is_first(paths, r)) first.push_back(r);
    follow_from(work, level, first, -1.0, paths, report);
    add_curves(paths, curves, report);
}

// ---- Loops between vertices

// Returns whether holds(other) is true for all neighbours of a triangle's corner. It walks around the corner along the
// edges that begin there. At a border of the mesh, it continues in the other sense.
template <class Holds>
bool all_neighbours(const SurfaceMesh& mesh, std::int64_t triangle, std::int32_t vertex, const Holds& holds) {
    for (const std::int64_t over : {0, 2}) {
        std::int64_t t = triangle;
        do {
            const std::int32_t* const v = mesh.corner.data() + 3 * t;
            const std::int64_t k = v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
            HRBFNPR_ASSERT(v[k] == vertex);
            if (!holds(v[(k + 1) % 3]) || !holds(v[(k + 2) % 3])) return false;
            t = mesh.neighbour[3 * t + (k + over) % 3];
        } while (t >= 0 && t != triangle);
        if (t >= 0) break;
    }
    return true;
}

// Returns whether the extremum of g may lie near a corner of a triangle: g has one sign at all corners, and the least
// |g| at a corner is less than the difference between the greatest and the least |g|. If g is quadratic, its extremum
// is then less than half an edge away from the corner with the least |g|, and |g| there is lower by a quarter of the
// difference. The function runs for every triangle, so it has no branches.
bool is_low(double a, double b, double c) noexcept {
    const double least = std::min(std::abs(a), std::min(std::abs(b), std::abs(c)));
    const double most = std::max(std::abs(a), std::max(std::abs(b), std::abs(c)));
    const unsigned parted = unsigned(std::min(a, std::min(b, c)) < 0.0) & unsigned(std::max(a, std::max(b, c)) > 0.0);
    return (unsigned(least < most - least) & ~parted) != 0;
}

// Returns the indices of vertices in ascending order. At these vertices |g| is low (see is_low()) and not greater than
// at any neighbour, and all neighbours have the same sign of g.
base::Array<std::int32_t> find_low(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                   const base::Array<double>& level) {
    constexpr std::int64_t triangles_a_task = 8192;
    base::List<base::Array<std::int32_t>> found(runtime.memory); // the vertices found by each task
    for (std::int64_t t = 0; t < mesh.triangles(); t += triangles_a_task) found.add(runtime.memory);
    runtime.parallel.for_chunks(mesh.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) {
            const std::int32_t* const v = mesh.corner.data() + 3 * t;
            if (!is_low(level[v[0]], level[v[1]], level[v[2]])) continue;
            const std::int32_t lowest = *std::min_element(
                v, v + 3, [&](std::int32_t a, std::int32_t b) { return std::abs(level[a]) < std::abs(level[b]); });
            const double here = level[lowest];
            const bool is_least = all_neighbours(mesh, t, lowest, [&](std::int32_t other) {
                return (level[other] < 0.0) == (here < 0.0) && std::abs(level[other]) >= std::abs(here);
            });
            if (is_least) found[begin / triangles_a_task].push_back(lowest);
        }
    });
    base::Array<std::int32_t> all(runtime.memory);
    for (const base::Array<std::int32_t>& some : found)
        for (const std::int32_t v : some) all.push_back(v);
    std::sort(all.begin(), all.end());
    all.resize(std::unique(all.begin(), all.end()) - all.begin());
    return all;
}

// Evaluates f and g at points. If the step along grad f to the surface is longer than `near`, it makes the step and
// evaluates again.
void evaluate_on_surface(const base::Work& work, const Level& level, double near, base::Array<CurvePoint>& points,
                         std::int64_t& evaluations) {
    evaluate(work, level, points);
    base::Array<CurvePoint> off(work.memory);
    base::Array<std::int64_t> which(work.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        CurvePoint p = points[i];
        step_to_surface(p);
        if (glm::distance(p.position, points[i].position) <= near) continue;
        off.push_back(p);
        which.push_back(i);
    }
    evaluate(work, level, off);
    evaluations += points.size() + off.size();
    for (std::int64_t k = 0; k < which.size(); ++k) points[which[k]] = off[k];
}

// Finds loops of g = 0 that lie between the vertices of the mesh. Such a loop surrounds an extremum of g, near a vertex
// where |g| is least. The extremum is searched for by Newton's method. If g changes its sign on the way, the places on
// both sides are returned. Adds to `evaluations`.
base::Array<Bracket> find_small_loops(const base::Work& work, const Level& level, const SurfaceMesh& mesh,
                                      const base::Array<double>& at_vertices, std::int64_t& evaluations) {
    // A search evaluates three points: its place, and a neighbour in each of two tangent directions.
    HRBFNPR_ASSERT(at_vertices.size() == mesh.vertices());
    const double side = mesh.side;
    const double probe = curve_tuning.probe * side;
    struct Search {
        std::int32_t vertex;
        glm::dvec3 place, u, v; // u and v: tangents at the vertex
    };
    base::Array<Search> active(work.memory);
    for (const std::int32_t vertex : find_low(work, mesh, at_vertices)) {
        const glm::dvec3 n = glm::normalize(mesh.gradient[vertex]);
        const glm::dvec3 u = geometry::any_perpendicular(n);
        active.push_back({vertex, mesh.position[vertex], u, glm::cross(n, u)});
    }
    base::Array<Bracket> found(work.memory);
    // Makes a Newton step towards a zero of grad g in the tangent plane, by finite differences between three points.
    // Returns whether the search continues.
    const auto go_on = [&](Search& search, const CurvePoint* three) {
        const glm::dvec3 vertex = mesh.position[search.vertex];
        const double known = at_vertices[search.vertex];
        const bool negative = known < 0.0;
        for (int k = 0; k < 3; ++k) {
            if ((three[k].level < 0.0) == negative) continue;
            found.push_back(negative ? Bracket{vertex, three[k].position} : Bracket{three[k].position, vertex});
            return false;
        }
        const auto slope = [&](const CurvePoint& p) { // the gradient of g on the surface, in the basis u, v
            const glm::dvec3 n = p.gradient / glm::dot(p.gradient, p.gradient);
            const glm::dvec3 g = p.level_gradient - glm::dot(p.level_gradient, n) * p.gradient;
            return glm::dvec2(glm::dot(g, search.u), glm::dot(g, search.v));
        };
        const glm::dvec2 g = slope(three[0]);
        const glm::dvec2 u = (slope(three[1]) - g) / probe;
        const glm::dvec2 v = (slope(three[2]) - g) / probe;
        const double mixed = 0.5 * (u.y + v.x);
        const double determinant = u.x * v.y - mixed * mixed;
        glm::dvec2 step((-g.x * v.y + g.y * mixed) / determinant, (-g.y * u.x + g.x * mixed) / determinant);
        const double length = glm::length(step);
        const double longest = curve_tuning.longest_search * side;
        if (!(length > curve_tuning.close * side)) return false;
        const double extremum = (three[0].level + 0.5 * glm::dot(g, step)) * (negative ? -1.0 : 1.0);
        if (length <= longest && extremum > curve_tuning.hopeless * std::abs(known)) return false;
        if (length > longest) step *= longest / length;
        search.place = three[0].position + step.x * search.u + step.y * search.v;
        return glm::distance(search.place, vertex) <= curve_tuning.farthest_extremum * side;
    };
    base::Array<CurvePoint> points(work.memory);
    for (int step = 0; step < curve_tuning.extremum_steps && !active.empty(); ++step) {
        points.resize(3 * active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const auto& [vertex, place, u, v] = active[i];
            points[3 * i].position = place;
            points[3 * i + 1].position = place + probe * u;
            points[3 * i + 2].position = place + probe * v;
        }
        evaluate_on_surface(work, level, curve_tuning.close * side, points, evaluations);
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            Search search = active[i];
            if (go_on(search, points.data() + 3 * i)) active[left++] = search;
        }
        active.resize(left);
    }
    return found;
}

// ---- Starts

// The curves that are already found, and the arguments of trace().
struct TraceState {
    const base::Work& work;
    const Level& level;
    const SurfaceMesh& mesh;
    const TraceSettings& settings;
    TraceReport& report;
    Curves curves;

    [[nodiscard]] NearCurves near_curves() const {
        return {curves, settings.longest * mesh.side, curve_tuning.covered * mesh.side};
    }
    void add(const Curves& runs) { follow(work, level, mesh, runs, settings, curves, report); }
};

// Returns the crossings without a curve near them.
base::Array<EdgeCrossing> crossings_without_curve(const TraceState& state, const base::Array<EdgeCrossing>& crossings) {
    const NearCurves near = state.near_curves();
    base::Array<std::uint8_t> is_covered(state.work.memory, crossings.size());
    state.work.for_chunks(crossings.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        // Consecutive crossings lie along a curve, so each search begins near the last result.
        std::int64_t guess = 0;
        for (std::int64_t i = begin; i < end; ++i)
            is_covered[i] =
                near.passes(crossings[i].place, crossings[i].way, curve_tuning.covered * state.mesh.side, guess) ? 1
                                                                                                                 : 0;
    });
    base::Array<EdgeCrossing> left(state.work.memory);
    for (std::int64_t i = 0; i < crossings.size(); ++i)
        if (is_covered[i] == 0) left.push_back(crossings[i]);
    return left;
}

// Returns for each point whether it is on a known curve. Near samples, the distance between a cubic and its curve may
// be some percent of the cubic's length. So the place on the cubic that is nearest to the point is first moved onto the
// curve. The point is on the curve if it lies on the tangent at the moved place.
base::Array<std::uint8_t> on_curves(TraceState& state, const base::Array<CurvePoint>& points) {
    const double side = state.mesh.side;
    const NearCurves near = state.near_curves();
    base::Array<std::uint8_t> on(points.memory(), points.size());
    base::Array<CurvePoint> feet(points.memory());
    base::Array<std::int64_t> which(points.memory());
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const NearCurves::Foot foot = near.nearest(points[i].position, points[i].direction());
        on[i] = foot.distance <= curve_tuning.found_already * side ? 1 : 0;
        if (on[i] != 0 || foot.distance > curve_tuning.covered * side) continue;
        feet.push_back({foot.place});
        which.push_back(i);
    }
    base::Array<std::uint8_t> found(points.memory());
    const NewtonSettings newton{state.settings.tolerance * side, curve_tuning.covered * side};
    state.report.evaluations += bring_to_curve(state.work, state.level, newton, feet, found);
    for (std::int64_t i = 0; i < which.size(); ++i) {
        const glm::dvec3 way = points[which[i]].position - feet[i].position;
        const glm::dvec3 along = glm::normalize(feet[i].direction());
        const double off = glm::length(way - glm::dot(way, along) * along);
        on[which[i]] = found[i] != 0 && off <= curve_tuning.found_already * side ? 1 : 0;
    }
    return on;
}

// Moves points onto curves. Follows a curve from each moved point that is not on a known curve. If several points are
// moved to the same place, the curve is followed only once. Returns the indices of the points that did not reach a
// curve.
base::Array<std::int64_t> add_curves_from(TraceState& state, base::Array<CurvePoint> points) {
    base::Memory& memory = state.work.memory;
    const double side = state.mesh.side;
    base::Array<std::uint8_t> found(memory);
    const NewtonSettings newton{state.settings.tolerance * side, curve_tuning.start_reach * side};
    state.report.evaluations += bring_to_curve(state.work, state.level, newton, points, found);
    const base::Array<std::uint8_t> known = on_curves(state, points);
    base::Array<CurvePoint> fresh(memory);
    base::Array<std::int64_t> lost(memory);
    geometry::VecArray places(memory); // the positions of `fresh`
    for (std::int64_t i = 0; i < points.size(); ++i) {
        if (found[i] == 0) lost.push_back(i);
        if (found[i] == 0 || known[i] != 0) continue;
        fresh.push_back(points[i]);
        places.push_back(points[i].position);
    }
    const double same = curve_tuning.close * side;
    const geometry::PointGrid grid(places, same);
    Curves runs(memory); // runs of one point each
    for (std::int64_t i = 0; i < fresh.size(); ++i) {
        bool first = true;
        grid.around(places[i], [&](std::int64_t at) {
            const std::int64_t other = grid.index(at);
            first = first && !(other < i && glm::distance(places[other], places[i]) <= same &&
                               glm::dot(fresh[other].direction(), fresh[i].direction()) > 0.0);
        });
        if (!first) continue;
        runs.point.push_back(fresh[i]);
        runs.end(false);
    }
    state.add(runs);
    return lost;
}

// Follows curves from zeros of g, which bisection finds between two places.
base::Array<Bracket> add_curves_from(TraceState& state, const base::Array<Bracket>& places) {
    base::Array<CurvePoint> points(state.work.memory);
    state.report.evaluations += bisect(state.work, state.level, places, curve_tuning.halvings, points);
    base::Array<Bracket> lost(state.work.memory);
    for (const std::int64_t i : add_curves_from(state, std::move(points))) lost.push_back(places[i]);
    return lost;
}

// Follows curves from the crossings that have no curve near them. Newton's method moves the crossings onto curves;
// where it fails, bisection is used.
base::Array<Bracket> add_curves_from(TraceState& state, const base::Array<EdgeCrossing>& crossings) {
    const base::Array<EdgeCrossing> left = crossings_without_curve(state, crossings);
    base::Array<CurvePoint> points(state.work.memory, left.size());
    for (std::int64_t i = 0; i < left.size(); ++i) points[i].position = left[i].place;
    base::Array<Bracket> edges(state.work.memory);
    for (const std::int64_t i : add_curves_from(state, std::move(points))) edges.push_back(left[i].edge);
    return add_curves_from(state, edges);
}

// The part of a surface around changes of sign. A mesh of this domain has no cells far from them.
class NearChanges final : public implicit::Domain {
public:
    NearChanges(base::Memory& memory, const base::Array<Bracket>& changes) : middle_(memory), half_(memory) {
        double longest = 0.0;
        for (const Bracket& change : changes) {
            middle_.push_back(0.5 * (change.negative + change.positive));
            half_.push_back(0.5 * glm::abs(change.positive - change.negative));
            longest = std::max(longest, glm::distance(change.negative, change.positive));
        }
        grid_.emplace(middle_, std::max(0.5 * longest, std::numeric_limits<double>::min()));
    }

    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& /*gradient*/) const override {
        return has_no_surface_in(place, 0.0) ? 1.0 : -1.0;
    }
    [[nodiscard]] bool has_no_surface_in(const glm::dvec3& centre, double half) const noexcept override {
        bool found = false;
        grid_->around({centre - half, centre + half}, [&](std::int64_t at) {
            const std::int64_t i = grid_->index(at);
            found = found || glm::all(glm::lessThanEqual(glm::abs(centre - middle_[i]), half_[i] + half));
        });
        return !found;
    }

private:
    geometry::VecArray middle_, half_;        // the box around each change: its middle, and half its size
    std::optional<geometry::PointGrid> grid_; // the middles
};

// Meshes the surface again, with smaller cells, around changes of sign without a curve. Smaller cells also separate
// parts that larger cells connect by mistake, for example where |grad f| nearly vanishes. The mesh need not be exact,
// because crossings are moved onto curves. Returns the number of changes of sign that remain.
std::int64_t trace_on_finer_mesh(TraceState& state, const base::Array<Bracket>& lost) {
    const base::Work work = state.work.without_progress();
    const SurfaceMesh& mesh = state.mesh;
    base::Array<geometry::Bounds> boxes(work.memory); // boxes around groups of places that are near each other
    geometry::VecArray seeds(work.memory);
    for (const Bracket& edge : lost) {
        seeds.push_back(edge.negative);
        seeds.push_back(edge.positive);
        const geometry::Bounds own{glm::min(edge.negative, edge.positive) - mesh.side,
                                   glm::max(edge.negative, edge.positive) + mesh.side};
        geometry::Bounds* const box = std::find_if(boxes.begin(), boxes.end(), [&](const geometry::Bounds& b) {
            return glm::all(glm::lessThan(own.min, b.max)) && glm::all(glm::lessThan(b.min, own.max));
        });
        if (box == boxes.end())
            boxes.push_back(own);
        else
            *box = {glm::min(box->min, own.min), glm::max(box->max, own.max)};
    }
    const NearChanges near(work.memory, lost);
    base::List<base::Array<EdgeCrossing>> found(work.memory); // the crossings in each box
    for (std::int64_t b = 0; b < boxes.size(); ++b) found.add(work.memory);
    const auto cross_in_box = [&](const base::Work& with, std::int64_t b) {
        const geometry::Bounds& box = boxes[b];
        MeshSettings settings;
        settings.region = {glm::max(box.min, mesh.region.min), glm::min(box.max, mesh.region.max)};
        settings.side =
            std::max(mesh.side / curve_tuning.closer, glm::length(settings.region.size()) / curve_tuning.most_cells);
        settings.tolerance = curve_tuning.close * settings.side / state.level.surface().diagonal();
        settings.domain = &near;
        settings.block_side = curve_tuning.cells_of_block;
        const SurfaceMesh part = triangulate(with, state.level.surface(), seeds, settings);
        base::Array<double> at_vertices(with.memory);
        state.level.at_vertices(with, part, at_vertices);
        for (const EdgeCrossing& crossing : find_edge_crossings(with, part, at_vertices).point)
            found[b].push_back(crossing);
    };
    // The meshes of several boxes are small, so each is made by one thread.
    const base::Runtime one_thread(work, base::Parallel());
    if (boxes.size() == 1)
        cross_in_box(work, 0);
    else
        state.level.surface().threads(work).for_each(boxes.size(), [&](std::int64_t b) {
            cross_in_box({one_thread, work}, b);
        });
    base::Array<EdgeCrossing> crossings(work.memory);
    for (const base::Array<EdgeCrossing>& some : found)
        for (const EdgeCrossing& crossing : some) crossings.push_back(crossing);
    return add_curves_from(state, crossings).size();
}

} // namespace

Curves trace(const base::Work& work, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
             TraceReport& report, const Curves* near) {
    report = TraceReport{};
    base::Array<double> at_vertices(work.memory);
    level.at_vertices(work, mesh, at_vertices);
    const Chains<EdgeCrossing> crossings = find_edge_crossings(work, mesh, at_vertices);
    TraceState state{work, level, mesh, settings, report, Curves(work.memory)};
    const Curves starts =
        near != nullptr ? thinned(work, mesh, *near, settings) : starts_of(work, mesh, crossings, settings);
    state.add(runs_from(work, level, mesh, starts, settings, report));
    const std::int64_t first = report.starts;
    base::Array<Bracket> lost = add_curves_from(state, crossings.point);
    const std::int64_t before = report.starts;
    const base::Array<Bracket> loops = find_small_loops(work, level, mesh, at_vertices, report.evaluations);
    for (const Bracket& edge : add_curves_from(state, loops)) lost.push_back(edge);
    report.loops = report.starts - before;
    report.missed = lost.size() > curve_tuning.most_lost ? lost.size() : trace_on_finer_mesh(state, lost);
    report.added = report.starts - first;
    return mesh.domain != nullptr ? clip(work, level, *mesh.domain, state.curves) : std::move(state.curves);
}

Curves moved_contours(base::Memory& memory, const View& view, const Curves& contours, double farthest) {
    Curves result(memory);
    result.point.reserve(contours.point.size());
    for (std::int64_t c = 0; c < contours.count(); ++c) {
        for (std::int64_t i = contours.first[c]; i < contours.first[c + 1]; ++i) {
            CurvePoint p = contours.point[i];
            p.value = 0.0;
            p.level = glm::dot(p.gradient, view.sight(p.position));
            const glm::dvec3 way = p.newton_step();
            if (!(glm::length(way) <= farthest)) continue;
            p.position += way;
            result.point.push_back(p);
        }
        result.end(contours.closed[c] != 0);
    }
    return result;
}

} // namespace hrbfnpr::curves
