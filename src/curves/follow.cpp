// SPDX-License-Identifier: MIT
#include "curves/follow.h"

#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

enum class End : std::uint8_t { none, at_run, border, broken };

// One that is being followed.
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
    std::int64_t met = -1;      // the run that it came to
    std::int64_t met_point = 0; // ... and where: at its first point, or behind it if the ends overlapped
    End end = End::none;
};

// A point that a path went through.
struct Passed {
    std::int64_t path;
    CurvePoint point;
};

constexpr int most_iterations = 5;
// Where a corrector's step is below this share of the curve's, the one that follows is nothing: below 1e-6 sides, since
// rays to points that are farther off the surface cross it beside them.
constexpr double converged = 1e-3;
// A point is met within this share of the step beside the cubic of a step.  One that lies farther beside it, but runs
// along with it, asks for shorter steps, until they are as short as `sure` in sides: curves bend within a long step
// where samples lie, and its cubic does not know.
constexpr double beside = 0.05;
constexpr double maybe_beside = 0.3;
constexpr double sure = 0.02;
constexpr std::int32_t fewest_steps_of_loop = 3;

glm::dvec3 unit_direction(const CurvePoint& p, double sense) noexcept { return sense * glm::normalize(p.direction()); }

class Follower {
public:
    Follower(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& runs,
             const TraceSettings& settings)
        : runtime_(runtime), level_(level), mesh_(mesh), runs_(runs), settings_(settings), paths_(runtime.memory),
          passed_(runtime.memory), targets_(open_points()), grid_(places(), (settings.longest * 0.75) * mesh.side) {}

    // Follows one path from each of these runs: from its last point, or backwards from its first.
    void run(const base::Array<std::int64_t>& from, double sense, TraceReport& report, const base::Progress& progress);
    [[nodiscard]] const base::Array<Path>& paths() const noexcept { return paths_; }
    [[nodiscard]] const base::Array<Passed>& passed() const noexcept { return passed_; }

private:
    [[nodiscard]] const CurvePoint& start(std::int64_t run) const noexcept { return runs_.point[runs_.first[run]]; }
    // A point of a run that paths may come to.
    struct Target {
        std::int64_t run, point;
    };
    [[nodiscard]] base::Array<Target> open_points() const {
        base::Array<Target> targets(runtime_.memory);
        for (std::int64_t r = 0; r < runs_.count(); ++r)
            for (std::int64_t i = runs_.first[r]; i < runs_.first[r + 1] && runs_.closed[r] == 0; ++i)
                targets.push_back({r, i});
        return targets;
    }
    [[nodiscard]] geometry::VecArray places() const {
        geometry::VecArray at(runtime_.memory, targets_.size());
        for (std::int64_t i = 0; i < targets_.size(); ++i) at.set(i, runs_.point[targets_[i].point].position);
        return at;
    }
    [[nodiscard]] Path begun(std::int64_t run, double sense) const noexcept;
    void predict(Path& path) const noexcept;
    void shorten(Path& path, double share) const noexcept;
    [[nodiscard]] double turn_limit(const Path& path) const noexcept {
        return path.step < kink_length * mesh_.side ? sharpest_kink : settings_.turn;
    }
    void take(std::int64_t number);
    void accept(std::int64_t number, const glm::dvec3& tangent);
    [[nodiscard]] bool leaves(Path& path) const noexcept;
    [[nodiscard]] bool meets_run(Path& path, const glm::dvec3& tangent, double within) const;

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const Curves& runs_;
    const TraceSettings& settings_;
    base::Array<Path> paths_;
    base::Array<Passed> passed_;
    base::Array<Target> targets_;
    geometry::PointGrid grid_;
};

void Follower::predict(Path& path) const noexcept {
    const double h = path.step;
    path.predicted = path.last.position + h * path.tangent + 0.5 * h * h * path.bend;
    path.trial.position = path.predicted;
    path.iteration = 0;
}

void Follower::shorten(Path& path, double share) const noexcept {
    path.step *= share;
    if (path.step < settings_.shortest * mesh_.side || path.evaluations > settings_.evaluation_limit)
        path.end = End::broken;
    else
        predict(path);
}

// Whether the step ends beyond the region: then it is cut there, and the path ends where little is left of it.
bool Follower::leaves(Path& path) const noexcept {
    const geometry::Bounds& region = mesh_.region;
    if (region.contains(path.trial.position)) return false;
    double share = 1.0;
    const glm::dvec3 way = path.trial.position - path.last.position;
    for (int c = 0; c < 3; ++c) {
        const double wall = way[c] > 0.0 ? region.max[c] : region.min[c];
        if (way[c] != 0.0) share = std::min(share, std::max(0.0, (wall - path.last.position[c]) / way[c]));
    }
    if (share * path.step <= 1e-3 * mesh_.side)
        path.end = End::border;
    else {
        path.step *= 0.999 * share;
        predict(path);
    }
    return true;
}

// The first point of a run on the way.  The cubic through both ends says how far beside the curve a point lies:
// `within` steps.
bool Follower::meets_run(Path& path, const glm::dvec3& tangent, double within) const {
    const glm::dvec3 a = path.last.position;
    const glm::dvec3 b = path.trial.position;
    const glm::dvec3 chord = b - a;
    const double length = glm::length(chord);
    double first = 2.0;
    grid_.around(0.5 * (a + b), [&](std::int64_t at) {
        const Target& target = targets_[grid_.index(at)];
        if (target.run == path.start && path.steps < fewest_steps_of_loop) return;
        const CurvePoint& p = runs_.point[target.point];
        const glm::dvec3 place = p.position;
        const double u = glm::dot(place - a, chord) / (length * length);
        if (!(u > 1e-9 && u <= 1.0 + beside && u < first)) return;
        const double v = 1.0 - u;
        const glm::dvec3 on_curve = v * v * (1.0 + 2.0 * u) * a + u * u * (3.0 - 2.0 * u) * b +
                                    u * v * length * (v * path.tangent - u * tangent);
        const glm::dvec3 off = place - on_curve;
        const double along = glm::dot(off, chord) / length;
        if (glm::dot(off, off) - along * along > within * within * length * length) return;
        if (glm::dot(unit_direction(p, path.sense), tangent) < 0.7) return;
        path.met = target.run;
        path.met_point = target.point;
        first = u;
    });
    return path.met >= 0;
}

void Follower::accept(std::int64_t number, const glm::dvec3& tangent) {
    Path& path = paths_[number];
    bool meets = meets_run(path, tangent, beside);
    if (!meets && meets_run(path, tangent, maybe_beside)) {
        if (path.step > sure * mesh_.side) {
            path.met = -1;
            return shorten(path, 0.5);
        }
        meets = true;
    }
    const double length = glm::distance(path.trial.position, path.last.position);
    const glm::dvec3 turned = tangent - path.tangent;
    path.bend = turned / length;
    path.last = path.trial;
    path.tangent = tangent;
    ++path.steps;
    if (meets) {
        path.end = End::at_run;
        return;
    }
    passed_.push_back({number, path.trial});
    const double turn = glm::length(turned);
    const double share = turn > 0.0 ? std::clamp(0.7 * settings_.turn / turn, 0.5, 2.0) : 2.0;
    path.step = std::min(path.step * share, settings_.longest * mesh_.side);
    predict(path);
}

// Looks at the trial that was evaluated.
void Follower::take(std::int64_t number) {
    Path& path = paths_[number];
    ++path.evaluations;
    const glm::dvec3 way = path.trial.newton_step();
    if (path.evaluations > settings_.evaluation_limit) {
        path.end = End::broken;
        return;
    }
    const double length = glm::length(way);
    const double off = glm::distance(path.trial.position + way, path.predicted);
    const double limit = turn_limit(path);
    if (!(off <= limit * path.step)) return shorten(path, 0.5);
    path.trial.position += way;
    if (length > converged * path.step) {
        if (++path.iteration >= most_iterations) shorten(path, 0.5);
        return;
    }
    const glm::dvec3 tangent = unit_direction(path.trial, path.sense);
    const double turn = glm::distance(tangent, path.tangent);
    if (!(turn <= limit)) return shorten(path, std::clamp(0.7 * limit / turn, 0.25, 0.7));
    if (!leaves(path)) accept(number, tangent);
}

// As if it had come along its run.
Path Follower::begun(std::int64_t run, double sense) const noexcept {
    const std::int64_t size = runs_.size_of(run);
    const CurvePoint& last = sense > 0.0 ? runs_.point[runs_.first[run] + size - 1] : start(run);
    Path path{run, sense, last, unit_direction(last, sense), glm::dvec3(0.0), 0.25 * mesh_.side, {}};
    if (sense > 0.0) path.steps = static_cast<std::int32_t>(size - 1);
    return path;
}

void Follower::run(const base::Array<std::int64_t>& from, double sense, TraceReport& report,
                   const base::Progress& progress) {
    base::Array<std::int64_t> active(runtime_.memory);
    for (const std::int64_t r : from) {
        if (runs_.closed[r] != 0) continue;
        Path path = begun(r, sense);
        predict(path);
        active.push_back(paths_.size());
        paths_.push_back(path);
    }
    base::Array<CurvePoint> trial(runtime_.memory);
    while (!active.empty()) {
        trial.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) trial[i].position = paths_[active[i]].trial.position;
        evaluate(runtime_, level_, trial, progress);
        report.evaluations += trial.size();
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            paths_[active[i]].trial = trial[i];
            take(active[i]);
            if (paths_[active[i]].end == End::none) active[left++] = active[i];
        }
        active.resize(left);
    }
}

// Puts paths together to curves.
class Joiner {
public:
    Joiner(base::Memory& memory, const Curves& runs, const Follower& follower)
        : runs_(runs), follower_(follower), forward_(memory, runs.count()), backward_(memory, runs.count()),
          before_(memory, runs.count()), done_(memory, runs.count()), passed_by_(memory, runs.count()), begin_(memory),
          order_(memory) {
        std::fill(forward_.begin(), forward_.end(), -1);
        std::fill(backward_.begin(), backward_.end(), -1);
        std::fill(before_.begin(), before_.end(), -1);
        sort_points();
        const base::Array<Path>& paths = follower_.paths();
        for (std::int64_t p = 0; p < paths.size(); ++p) {
            if (paths[p].sense < 0.0) {
                backward_[paths[p].start] = p;
                continue;
            }
            forward_[paths[p].start] = p;
            const std::int64_t met = paths[p].met;
            if (met >= 0 && (before_[met] < 0 || paths[p].met_point < path_from(before_[met]).met_point))
                before_[met] = paths[p].start;
        }
        for (std::int64_t s = 0; s < runs.count(); ++s) find_passed_by(s);
    }

    // Open runs that no path leads to.
    [[nodiscard]] base::Array<std::int64_t> first_ones(base::Memory& memory) const {
        base::Array<std::int64_t> found(memory);
        for (std::int64_t s = 0; s < runs_.count(); ++s)
            if (is_first(s)) found.push_back(s);
        return found;
    }
    void join(Curves& curves, TraceReport& report);

private:
    [[nodiscard]] const Path& path_from(std::int64_t s) const noexcept { return follower_.paths()[forward_[s]]; }
    // The first point that counts.
    [[nodiscard]] std::int64_t begin_of(std::int64_t s) const noexcept {
        return runs_.closed[s] == 0 && before_[s] >= 0 ? path_from(before_[s]).met_point : runs_.first[s];
    }
    [[nodiscard]] bool is_first(std::int64_t s) const noexcept {
        return runs_.closed[s] == 0 && before_[s] < 0 && passed_by_[s] == 0;
    }
    void sort_points();
    void find_passed_by(std::int64_t s);
    [[nodiscard]] std::int64_t next(std::int64_t s) const noexcept {
        if (runs_.closed[s] != 0) return -1;
        const std::int64_t met = path_from(s).met;
        return met >= 0 && before_[met] == s ? met : -1;
    }
    void add_path(std::int64_t path, bool reversed, Curves& curves) const;
    void add_from(std::int64_t s, Curves& curves);
    void close(Curves& curves, bool closed) const {
        curves.first.push_back(curves.point.size());
        curves.closed.push_back(closed ? 1 : 0);
    }

    const Curves& runs_;
    const Follower& follower_;
    base::Array<std::int64_t> forward_, backward_, before_; // of each run: its paths, and the run that leads to it
    base::Array<std::uint8_t> done_;
    base::Array<std::uint8_t> passed_by_;     // 1: the start of a run on a path that goes on
    base::Array<std::int64_t> begin_, order_; // of each path's points
};

void Joiner::sort_points() {
    const base::Array<Passed>& passed = follower_.passed();
    begin_.resize(follower_.paths().size() + 1);
    for (const Passed& p : passed) ++begin_[p.path + 1];
    for (std::int64_t p = 0; p + 1 < begin_.size(); ++p) begin_[p + 1] += begin_[p];
    order_.resize(passed.size());
    base::Array<std::int64_t> at(order_.memory());
    for (const std::int64_t begin : begin_) at.push_back(begin);
    for (std::int64_t i = 0; i < passed.size(); ++i) order_[at[passed[i].path]++] = i;
}

// Where two paths come to one run, and none to the run of one of them, the other has passed that by at a kink:
// there is nothing left for it to do.  What it does not stand for, changes of sign that no curve passes will tell.
void Joiner::find_passed_by(std::int64_t s) {
    if (runs_.closed[s] != 0) return;
    const std::int64_t met = path_from(s).met;
    if (met < 0 || before_[met] == s) return;
    std::int64_t other = before_[met];
    if (before_[s] >= 0 && before_[other] < 0) {
        before_[met] = s;
        std::swap(s, other);
    }
    if (before_[s] < 0) passed_by_[s] = 1;
}

void Joiner::add_path(std::int64_t path, bool reversed, Curves& curves) const {
    if (path < 0) return;
    const std::int64_t begin = begin_[path];
    const std::int64_t count = begin_[path + 1] - begin;
    for (std::int64_t i = 0; i < count; ++i)
        curves.point.push_back(follower_.passed()[order_[begin + (reversed ? count - 1 - i : i)]].point);
}

void Joiner::add_from(std::int64_t s, Curves& curves) {
    for (std::int64_t at = s; at >= 0 && done_[at] == 0; at = next(at)) {
        done_[at] = 1;
        for (std::int64_t i = begin_of(at); i < runs_.first[at + 1]; ++i) curves.point.push_back(runs_.point[i]);
        add_path(forward_[at], false, curves);
    }
}

void Joiner::join(Curves& curves, TraceReport& report) {
    for (std::int64_t s = 0; s < runs_.count(); ++s) {
        if (!is_first(s)) continue;
        add_path(backward_[s], true, curves);
        add_from(s, curves);
        close(curves, false);
    }
    for (std::int64_t s = 0; s < runs_.count(); ++s) {
        if (done_[s] != 0 || passed_by_[s] != 0) continue;
        add_from(s, curves);
        close(curves, true);
    }
    for (const Path& path : follower_.paths()) {
        if (passed_by_[path.start] != 0) continue;
        if (path.end == End::broken || (path.sense > 0.0 && path.met >= 0 && before_[path.met] != path.start))
            ++report.broken;
    }
}

} // namespace

void follow(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& runs,
            const TraceSettings& settings, Curves& curves, TraceReport& report, const base::Progress& progress) {
    Follower follower(runtime, level, mesh, runs, settings);
    base::Array<std::int64_t> all(runtime.memory);
    for (std::int64_t r = 0; r < runs.count(); ++r) all.push_back(r);
    follower.run(all, 1.0, report, progress);
    follower.run(Joiner(runtime.memory, runs, follower).first_ones(runtime.memory), -1.0, report, progress);
    Joiner(runtime.memory, runs, follower).join(curves, report);
}

} // namespace hrbfnpr::curves
