// SPDX-License-Identifier: MIT
// The steps of tracing:
//
//   beads_of           the mesh's changes of sign, as places and directions
//   runs_from          (chain_runs.h) runs of points on curves, from beads or from the curves of the view before
//   follow             predictor and corrector from the ends of runs until each comes to where a run begins
//   uncovered          beads that no curve passes by; curves start from these by Newton's steps, else by halving
//   find_small_loops   curves between the mesh's vertices, around extrema of g
//   look_closer        a finer mesh where changes of sign are left that no curve was found for
//   clip               (curve_changes.h) the parts of curves where the surface is
#include "curves/trace.h"

#include "curves/chain_runs.h"
#include "curves/curve_changes.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

// ---- Following

enum class PathEnd : std::uint8_t { none, at_run, border, broken };

// A curve that is being followed.
struct Path {
    std::int64_t start; // its run
    double sense;       // 1, or -1 backwards
    CurvePoint last;
    glm::dvec3 tangent;   // unit, in its sense
    glm::dvec3 bend{0.0}; // change of the tangent along the last step, by length
    double step;
    CurvePoint trial;
    glm::dvec3 predicted{0.0};
    int iteration = 0;
    std::int32_t steps = 0, evaluations = 0;
    std::int64_t passed = -1;   // the point that it passed last; -1: none yet
    std::int64_t met = -1;      // the run that it came to
    std::int64_t met_point = 0; // where: the first point of that run, or a later one if the ends overlapped
    PathEnd end = PathEnd::none;
};

// A point that a path went through, and the one before it; -1: it is the first.
struct Passed {
    CurvePoint point;
    std::int64_t before;
};

// The paths between runs, and the data that they share.
struct Paths {
    Paths(const SurfaceMesh& meshed, const Curves& known, const TraceSettings& by)
        : mesh(meshed), runs(known), settings(by), path(runs.point.memory()), passed(runs.point.memory()),
          run_of(curve_of_points(runs)), grid(positions_of(runs.point), 0.75 * settings.longest * mesh.side) {}

    const SurfaceMesh& mesh;
    const Curves& runs;
    const TraceSettings& settings;
    base::Array<Path> path;
    base::Array<Passed> passed;
    base::Array<std::int32_t> run_of; // the run of each point of the runs
    geometry::PointGrid grid;         // the points of the runs by their positions
};

// The most that a path may turn in a step of a length in sides.
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

// Finds the first point of a run on the way, and sets `met` to it. The cubic through both ends of the step says how far
// beside the curve a point lies.
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

// Goes on from a point of the curve.
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

// Looks at the trial that was evaluated.
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
    // Shorter steps lead up to the region's wall.
    if (path.step <= curve_tuning.at_wall * paths.mesh.side)
        path.end = PathEnd::border;
    else
        shorten(paths, path, 0.5);
}

// Follows one path from each of these runs, all in step: from its last point, or backwards from its first.
void follow_from(const base::Runtime& runtime, const Level& level, const base::Array<std::int64_t>& from, double sense,
                 Paths& paths, TraceReport& report, const base::Progress& progress) {
    const Curves& runs = paths.runs;
    base::Array<std::int64_t> active(runtime.memory);
    for (const std::int64_t r : from) {
        if (runs.closed[r] != 0) continue;
        const CurvePoint& last = runs.point[sense > 0.0 ? runs.first[r + 1] - 1 : runs.first[r]];
        Path path{r, sense, last, unit_along(last, sense), glm::dvec3(0.0), curve_tuning.first_step * paths.mesh.side,
                  {}};
        if (sense > 0.0) path.steps = static_cast<std::int32_t>(runs.size_of(r) - 1); // it came along its run
        predict(path);
        active.push_back(paths.path.size());
        paths.path.push_back(path);
    }
    base::Array<CurvePoint> trial(runtime.memory);
    while (!active.empty()) {
        trial.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) trial[i].position = paths.path[active[i]].trial.position;
        evaluate(runtime, level, trial, progress);
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

// How paths put runs together to curves.
struct Joints {
    Joints(base::Memory& memory, std::int64_t runs)
        : forward(memory, runs), backward(memory, runs), before(memory, runs), passed_by(memory, runs) {
        for (base::Array<std::int64_t>* const all : {&forward, &backward, &before})
            std::fill(all->begin(), all->end(), -1);
    }
    // Whether no path leads to the run.
    [[nodiscard]] bool is_first(const Curves& runs, std::int64_t r) const noexcept {
        return runs.closed[r] == 0 && before[r] < 0 && passed_by[r] == 0;
    }

    // Each run's two paths, and the run whose path leads to it; -1: none.
    base::Array<std::int64_t> forward, backward, before;
    base::Array<std::uint8_t> passed_by; // 1: another path goes past this run, which then is left out
};

Joints join(const Paths& paths) {
    const Curves& runs = paths.runs;
    Joints joints(runs.point.memory(), runs.count());
    const auto path_from = [&](std::int64_t r) -> const Path& { return paths.path[joints.forward[r]]; };
    for (std::int64_t p = 0; p < paths.path.size(); ++p) {
        const Path& path = paths.path[p];
        (path.sense < 0.0 ? joints.backward : joints.forward)[path.start] = p;
        if (path.sense < 0.0 || path.met < 0) continue;
        std::int64_t& before = joints.before[path.met];
        if (before < 0 || path.met_point < path_from(before).met_point) before = path.start;
    }
    // Where two paths come to one run, and none to the run of one of them, the other has passed that by at a kink:
    // there is nothing left for it to do. Changes of sign that no curve passes by tell of curves that are lost so.
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        if (runs.closed[r] != 0) continue;
        const std::int64_t met = path_from(r).met;
        if (met < 0 || joints.before[met] == r) continue;
        std::int64_t late = r;
        if (joints.before[r] >= 0 && joints.before[joints.before[met]] < 0) late = std::exchange(joints.before[met], r);
        if (joints.before[late] < 0) joints.passed_by[late] = 1;
    }
    return joints;
}

// Adds the curves that the runs and the paths between them make.
void add_curves(const Paths& paths, const Joints& joints, Curves& curves, TraceReport& report) {
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
            // A path may have come to a later point of the run than its first.
            const std::int64_t before = closed ? -1 : joints.before[run];
            const std::int64_t first = before >= 0 ? paths.path[joints.forward[before]].met_point : runs.first[run];
            for (std::int64_t i = first; i < runs.first[run + 1]; ++i) curves.point.push_back(runs.point[i]);
            add_path(joints.forward[run], false);
            const std::int64_t met = closed ? -1 : paths.path[joints.forward[run]].met;
            run = met >= 0 && joints.before[met] == run ? met : -1;
        }
    };
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        if (!joints.is_first(runs, r)) continue;
        add_path(joints.backward[r], true);
        add_from(r);
        curves.end_curve(false);
    }
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        if (done[r] != 0 || joints.passed_by[r] != 0) continue;
        add_from(r);
        curves.end_curve(true);
    }
    for (const Path& path : paths.path) {
        if (joints.passed_by[path.start] != 0) continue;
        if (path.end == PathEnd::broken || (path.sense > 0.0 && path.met >= 0 && joints.before[path.met] != path.start))
            ++report.broken;
    }
}

// Adds the curves that go through the runs.
void follow(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& runs,
            const TraceSettings& settings, Curves& curves, TraceReport& report, const base::Progress& progress) {
    report.starts += runs.count();
    Paths paths(mesh, runs, settings);
    base::Array<std::int64_t> all(runtime.memory), first(runtime.memory);
    for (std::int64_t r = 0; r < runs.count(); ++r) all.push_back(r);
    follow_from(runtime, level, all, 1.0, paths, report, progress);
    const Joints forward = join(paths);
    for (std::int64_t r = 0; r < runs.count(); ++r)
        if (forward.is_first(runs, r)) first.push_back(r);
    follow_from(runtime, level, first, -1.0, paths, report, progress);
    add_curves(paths, join(paths), curves, report);
}

// ---- Loops between vertices

// Calls holds(vertex) for the neighbours of a triangle's corner, until it is false: around the corner over the edges
// that begin there, and at a border also the other way.
template <class Holds>
bool all_neighbours(const SurfaceMesh& mesh, std::int64_t triangle, std::int32_t vertex, Holds&& holds) {
    for (const std::int64_t over : {0, 2}) {
        std::int64_t t = triangle;
        do {
            const std::int32_t* const v = mesh.corner.data() + 3 * t;
            const std::int64_t k = std::find(v, v + 3, vertex) - v;
            HRBFNPR_ASSERT(k < 3);
            if (!holds(v[(k + 1) % 3]) || !holds(v[(k + 2) % 3])) return false;
            t = mesh.neighbour[3 * t + (k + over) % 3];
        } while (t >= 0 && t != triangle);
        if (t >= 0) break;
    }
    return true;
}

// Whether g has one sign in a triangle, and |g| is low at a corner beside another: lower than the difference. The
// extremum of a quadratic is nearer than half an edge, and lower by a quarter of that difference. It has no branches
// because it is called for every triangle.
bool is_low(double a, double b, double c) noexcept {
    const double lower = std::min(std::abs(a), std::min(std::abs(b), std::abs(c)));
    const double upper = std::max(std::abs(a), std::max(std::abs(b), std::abs(c)));
    const unsigned parted = unsigned(std::min(a, std::min(b, c)) < 0.0) & unsigned(std::max(a, std::max(b, c)) > 0.0);
    return (unsigned(lower < upper - lower) & ~parted) != 0;
}

// Vertices where |g| is low, is nowhere less among the neighbours, and g has the sign of all these; ascending.
base::Array<std::int32_t> find_low(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                   const base::Array<double>& level) {
    base::Array<std::int32_t> found(runtime.memory, mesh.triangles()); // 1 + such a vertex of each triangle
    runtime.parallel.for_chunks(mesh.triangles(), 8192, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) {
            const std::int32_t* const v = mesh.corner.data() + 3 * t;
            if (!is_low(level[v[0]], level[v[1]], level[v[2]])) continue;
            const std::int32_t least = *std::min_element(
                v, v + 3, [&](std::int32_t a, std::int32_t b) { return std::abs(level[a]) < std::abs(level[b]); });
            const double here = level[least];
            const bool is_least = all_neighbours(mesh, t, least, [&](std::int32_t other) {
                return (level[other] < 0.0) == (here < 0.0) && std::abs(level[other]) >= std::abs(here);
            });
            if (is_least) found[t] = 1 + least;
        }
    });
    base::Array<std::int32_t> all(runtime.memory);
    for (const std::int32_t v : found)
        if (v > 0) all.push_back(v - 1);
    std::sort(all.begin(), all.end());
    all.resize(std::unique(all.begin(), all.end()) - all.begin());
    return all;
}

// Evaluates f and g at the points, and again after a step along grad f where that is longer than `near`.
void evaluate_on_surface(const base::Runtime& runtime, const Level& level, double near, base::Array<CurvePoint>& points,
                         std::int64_t& evaluations, const base::Progress& progress) {
    evaluate(runtime, level, points, progress);
    base::Array<CurvePoint> off(runtime.memory);
    base::Array<std::int64_t> which(runtime.memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        CurvePoint p = points[i];
        step_to_surface(p);
        if (glm::distance(p.position, points[i].position) <= near) continue;
        off.push_back(p);
        which.push_back(i);
    }
    evaluate(runtime, level, off, progress);
    evaluations += points.size() + off.size();
    for (std::int64_t k = 0; k < which.size(); ++k) points[which[k]] = off[k];
}

// Loops of g = 0 that pass between the vertices of the mesh: each goes round an extremum of g beside a vertex where |g|
// is least. Searches for these extrema by Newton's steps, and returns a place on either side of each loop where g has
// changed its sign on the way. Adds to `evaluations`.
base::Array<Straddle> find_small_loops(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                                       const base::Array<double>& at_vertices, std::int64_t& evaluations,
                                       const base::Progress& progress) {
    // The three points of a search are its place and one beside it in each tangent direction.
    HRBFNPR_ASSERT(at_vertices.size() == mesh.vertices());
    const double side = mesh.side;
    const double probe = curve_tuning.probe * side;
    struct Search {
        std::int32_t vertex;
        glm::dvec3 place, u, v; // u and v are tangent at the vertex
    };
    base::Array<Search> active(runtime.memory);
    for (const std::int32_t vertex : find_low(runtime, mesh, at_vertices)) {
        const glm::dvec3 n = glm::normalize(mesh.gradient[vertex]);
        const glm::dvec3 u = geometry::any_perpendicular(n);
        active.push_back({vertex, mesh.position[vertex], u, glm::cross(n, u)});
    }
    base::Array<Straddle> found(runtime.memory);
    // Makes Newton's step to where the part of grad g in the tangent plane is 0, by its differences between the three
    // points. Whether the search goes on.
    const auto go_on = [&](Search& search, const CurvePoint* three) {
        const glm::dvec3 vertex = mesh.position[search.vertex];
        const double known = at_vertices[search.vertex];
        const bool negative = known < 0.0;
        for (int k = 0; k < 3; ++k) {
            if ((three[k].level < 0.0) == negative) continue;
            found.push_back(negative ? Straddle{vertex, three[k].position} : Straddle{three[k].position, vertex});
            return false;
        }
        const auto slope = [&](const CurvePoint& p) { // the gradient of g along the surface, in the basis u, v
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
        if (!(length > curve_tuning.near_surface * side)) return false;
        const double extremum = (three[0].level + 0.5 * glm::dot(g, step)) * (negative ? -1.0 : 1.0);
        if (length <= longest && extremum > curve_tuning.hopeless * std::abs(known)) return false;
        if (length > longest) step *= longest / length;
        search.place = three[0].position + step.x * search.u + step.y * search.v;
        return glm::distance(search.place, vertex) <= curve_tuning.farthest_extremum * side;
    };
    base::Array<CurvePoint> points(runtime.memory);
    for (int step = 0; step < curve_tuning.extremum_steps && !active.empty(); ++step) {
        points.resize(3 * active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const auto& [vertex, place, u, v] = active[i];
            points[3 * i].position = place;
            points[3 * i + 1].position = place + probe * u;
            points[3 * i + 2].position = place + probe * v;
        }
        evaluate_on_surface(runtime, level, curve_tuning.near_surface * side, points, evaluations, progress);
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

// One bead for each crossing, in their order.
base::Array<Bead> beads_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const MeshChains& chains) {
    base::Array<Bead> beads(runtime.memory, chains.crossing.size());
    runtime.parallel.for_chunks(chains.chains(), 16, [&](std::int64_t from, std::int64_t to) {
        for (std::int64_t c = from; c < to; ++c) {
            const std::int64_t begin = chains.first[c];
            const std::int64_t count = chains.first[c + 1] - begin;
            const auto place = [&](std::int64_t i) {
                const std::int64_t at =
                    chains.closed[c] != 0 ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1);
                return chains.crossing[begin + at].place(mesh);
            };
            for (std::int64_t i = 0; i < count; ++i) {
                const Crossing& crossing = chains.crossing[begin + i];
                beads[begin + i] = {place(i),
                                    place(i + 1) - place(i - 1),
                                    {mesh.position[crossing.negative], mesh.position[crossing.positive]}};
            }
        }
    });
    return beads;
}

// The curves that are known already, and the arguments of trace().
struct Tracing {
    const base::Runtime& runtime;
    const Level& level;
    const SurfaceMesh& mesh;
    const TraceSettings& settings;
    TraceReport& report;
    const base::Progress& progress;
    Curves curves;

    [[nodiscard]] NearCurves near_curves() const {
        return {curves, settings.longest * mesh.side, curve_tuning.covered * mesh.side};
    }
    void add(const Curves& runs) { follow(runtime, level, mesh, runs, settings, curves, report, progress); }
};

// Beads that no curve passes by.
base::Array<Bead> uncovered(const Tracing& tracing, const base::Array<Bead>& beads) {
    const NearCurves near = tracing.near_curves();
    base::Array<std::uint8_t> is_covered(tracing.runtime.memory, beads.size());
    tracing.runtime.parallel.for_chunks(beads.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            is_covered[i] =
                near.passing(beads[i].place, beads[i].way, curve_tuning.covered * tracing.mesh.side) >= 0 ? 1 : 0;
    });
    base::Array<Bead> left(tracing.runtime.memory);
    for (std::int64_t i = 0; i < beads.size(); ++i)
        if (is_covered[i] == 0) left.push_back(beads[i]);
    return left;
}

// Which points lie on a curve that is known.  Where samples lie a cubic may be off its curve by some percent of its
// length: then its foot is brought onto the curve, and the point must lie along that from there.
base::Array<std::uint8_t> on_curves(Tracing& tracing, const base::Array<CurvePoint>& points) {
    const double side = tracing.mesh.side;
    const NearCurves near = tracing.near_curves();
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
    const NewtonSettings newton{tracing.settings.tolerance * side, curve_tuning.covered * side};
    tracing.report.evaluations += bring_to_curve(tracing.runtime, tracing.level, newton, feet, found, tracing.progress);
    for (std::int64_t i = 0; i < which.size(); ++i) {
        const glm::dvec3 way = points[which[i]].position - feet[i].position;
        const glm::dvec3 along = glm::normalize(feet[i].direction());
        const double off = glm::length(way - glm::dot(way, along) * along);
        on[which[i]] = found[i] != 0 && off <= curve_tuning.found_already * side ? 1 : 0;
    }
    return on;
}

// Follows curves from those of the points that can be brought onto one, once for each place and not where a curve
// passes already. Returns which of the points could not be brought onto a curve.
base::Array<std::int64_t> start_from(Tracing& tracing, base::Array<CurvePoint> points) {
    base::Memory& memory = tracing.runtime.memory;
    const double side = tracing.mesh.side;
    base::Array<std::uint8_t> found(memory);
    const NewtonSettings newton{tracing.settings.tolerance * side, curve_tuning.bead_reach * side};
    tracing.report.evaluations +=
        bring_to_curve(tracing.runtime, tracing.level, newton, points, found, tracing.progress);
    const base::Array<std::uint8_t> known = on_curves(tracing, points);
    base::Array<CurvePoint> fresh(memory);
    base::Array<std::int64_t> lost(memory);
    geometry::VecArray places(memory); // the positions of the fresh points
    for (std::int64_t i = 0; i < points.size(); ++i) {
        if (found[i] == 0) lost.push_back(i);
        if (found[i] == 0 || known[i] != 0) continue;
        fresh.push_back(points[i]);
        places.push_back(points[i].position);
    }
    const double same = curve_tuning.same_start * side;
    const geometry::PointGrid grid(places, same);
    Curves runs = no_curves(memory); // one point each
    for (std::int64_t i = 0; i < fresh.size(); ++i) {
        bool first = true;
        grid.around(places[i], [&](std::int64_t at) {
            const std::int64_t other = grid.index(at);
            first = first && !(other < i && glm::distance(places[other], places[i]) <= same &&
                               glm::dot(fresh[other].direction(), fresh[i].direction()) > 0.0);
        });
        if (!first) continue;
        runs.point.push_back(fresh[i]);
        runs.end_curve(false);
    }
    tracing.add(runs);
    return lost;
}

// The same from zeros of g that halving finds.
base::Array<Straddle> start_from(Tracing& tracing, const base::Array<Straddle>& places) {
    base::Array<CurvePoint> points(tracing.runtime.memory);
    tracing.report.evaluations +=
        halve(tracing.runtime, tracing.level, places, curve_tuning.halvings, points, tracing.progress);
    base::Array<Straddle> lost(tracing.runtime.memory);
    for (const std::int64_t i : start_from(tracing, std::move(points))) lost.push_back(places[i]);
    return lost;
}

// The same from beads that no curve passes by: by Newton's steps, and by halving where these fail.
base::Array<Straddle> start_from(Tracing& tracing, const base::Array<Bead>& beads) {
    const base::Array<Bead> left = uncovered(tracing, beads);
    base::Array<CurvePoint> points(tracing.runtime.memory, left.size());
    for (std::int64_t i = 0; i < left.size(); ++i) points[i].position = left[i].place;
    base::Array<Straddle> edges(tracing.runtime.memory);
    for (const std::int64_t i : start_from(tracing, std::move(points))) edges.push_back(left[i].edge);
    return start_from(tracing, edges);
}

// Changes of sign that no curve was found for are looked at on a mesh of smaller cells, which need not join parts that
// the surface does not join, as where |grad f| nearly vanishes. Returns the number of those that are left.
std::int64_t look_closer(Tracing& tracing, const base::Array<Straddle>& lost) {
    const base::Runtime& runtime = tracing.runtime;
    const SurfaceMesh& mesh = tracing.mesh;
    base::Array<geometry::Bounds> boxes(runtime.memory); // around places that are near each other
    geometry::VecArray seeds(runtime.memory);
    for (const Straddle& edge : lost) {
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
    base::Array<Bead> beads(runtime.memory);
    for (const geometry::Bounds& box : boxes) {
        MeshSettings settings;
        settings.region = {glm::max(box.min, mesh.region.min), glm::min(box.max, mesh.region.max)};
        settings.side =
            std::max(mesh.side / curve_tuning.closer, glm::length(settings.region.size()) / curve_tuning.most_cells);
        const SurfaceMesh part = triangulate(runtime, tracing.level.surface(), seeds, settings, {});
        base::Array<double> at_vertices(runtime.memory);
        tracing.level.at_vertices(runtime, part, at_vertices, tracing.progress);
        for (const Bead& bead : beads_of(runtime, part, find_chains(runtime, part, at_vertices))) beads.push_back(bead);
    }
    return start_from(tracing, beads).size();
}

} // namespace

Curves trace(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const TraceSettings& settings,
             TraceReport& report, const base::Progress& progress, const Curves* near) {
    report = TraceReport{};
    base::Array<double> at_vertices(runtime.memory);
    level.at_vertices(runtime, mesh, at_vertices, progress);
    const MeshChains chains = find_chains(runtime, mesh, at_vertices);
    const base::Array<Bead> beads = beads_of(runtime, mesh, chains);
    Tracing tracing{runtime, level, mesh, settings, report, progress, no_curves(runtime.memory)};
    const Curves starts =
        near != nullptr ? thinned(runtime, mesh, *near, settings) : starts_of(runtime, mesh, chains, beads, settings);
    tracing.add(runs_from(runtime, level, mesh, starts, settings, report, progress));
    const std::int64_t first = report.starts;
    base::Array<Straddle> lost = start_from(tracing, beads);
    const std::int64_t before = report.starts;
    const base::Array<Straddle> loops =
        find_small_loops(runtime, level, mesh, at_vertices, report.evaluations, progress);
    for (const Straddle& edge : start_from(tracing, loops)) lost.push_back(edge);
    report.loops = report.starts - before;
    report.missed = lost.size() > curve_tuning.most_lost ? lost.size() : look_closer(tracing, lost);
    report.added = report.starts - first;
    return mesh.domain != nullptr ? clip(runtime, level, *mesh.domain, tracing.curves, progress)
                                  : std::move(tracing.curves);
}

Curves moved_contours(base::Memory& memory, const View& view, const Curves& contours, double farthest) {
    Curves result = no_curves(memory);
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
        result.end_curve(contours.closed[c] != 0);
    }
    return result;
}

} // namespace hrbfnpr::curves
