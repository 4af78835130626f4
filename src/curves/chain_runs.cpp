// SPDX-License-Identifier: MIT
// 1. starts_of, thinned: places near curves, as far apart as a step.
// 2. runs_from: they are brought onto curves by Newton's steps, and left out where they met or passed each other.
// 3. halve_pieces: points in gaps, until each gap is linked by a cubic, or parted.
// 4. Chains are cut where they are parted, and where two run along one curve.
#include "curves/chain_runs.h"

#include "curves/chains.h"
#include "curves/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

struct RunTuning {
    // Newton may move a start by this many sides of the mesh. Larger: starts land on curves farther away.
    double reach = 1.0;
    // Points that are nearer to each other than this are one, in longest steps, but where the curve turns. Larger:
    // fewer points.
    double least_run = 0.1;
    // Runs that are nearer to each other than this are one curve, in sides. Larger: close curves are lost.
    double on_curve = 0.02;
    // Starts are this far apart, in longest steps. Larger: fewer starts, and more gaps to fill.
    double chosen_apart = 0.65;
    // Points across a wider gap than this are not on one curve, in longest steps. Larger: more gaps are tried.
    double widest = 3.0;
    // Points of the view before are kept where the curve turns by this much, in turns. Larger: fewer points.
    double kept_turn = 0.8;
    // A piece's chord may be off its ends' directions by this much, in turns; an arc's is by half. Larger: cubics may
    // leave the curve.
    double off_chord = 0.75;
    // A gap is halved this many times, down to a kink.
    int rounds = 10;
};
constexpr RunTuning run_tuning;

glm::dvec3 unit_direction(const CurvePoint& p) noexcept { return glm::normalize(p.direction()); }

// Whether the curve is known to lead from a point of a chain to the next.
enum class Link : std::uint8_t { unknown, linked, parted };

struct RunPoint {
    CurvePoint at;
    Link link = Link::unknown;
};

// Whether the cubic between two points is the curve.
bool is_linked(const CurvePoint& a, const CurvePoint& b, double side, const TraceSettings& settings) noexcept {
    const glm::dvec3 way = b.position - a.position;
    const double length = glm::length(way);
    if (!(length <= settings.longest * side)) return false;
    const double limit = length < curve_tuning.kink_length * side ? curve_tuning.sharpest_kink : settings.turn;
    const glm::dvec3 begin = unit_direction(a);
    const glm::dvec3 end = unit_direction(b);
    return glm::distance(begin, end) <= limit && glm::distance(begin, way / length) <= run_tuning.off_chord * limit &&
           glm::distance(end, way / length) <= run_tuning.off_chord * limit;
}

// Newton's steps go along the curve, too: points may have come together, or passed each other. Where the curve turns
// it is not known whether they have.
bool in_order(const CurvePoint& before, const CurvePoint& p, double side, const TraceSettings& settings) noexcept {
    const glm::dvec3 way = p.position - before.position;
    const glm::dvec3 a = unit_direction(before);
    const glm::dvec3 b = unit_direction(p);
    return glm::distance(a, b) > settings.turn || (glm::length(way) > run_tuning.least_run * settings.longest * side &&
                                                   glm::dot(a, way) > 0.0 && glm::dot(b, way) > 0.0);
}

bool is_between(const CurvePoint& m, const CurvePoint& a, const CurvePoint& b) noexcept {
    const glm::dvec3 way = b.position - a.position;
    return glm::dot(m.position - a.position, way) > 0.0 && glm::dot(b.position - m.position, way) > 0.0 &&
           glm::dot(m.direction(), way) > 0.0;
}

// The starts that could be brought onto curves, in the order of their chains.
Chains<RunPoint> begin_runs(const base::Runtime& runtime, const Curves& starts, const base::Array<CurvePoint>& points,
                            const base::Array<std::uint8_t>& found, double side, const TraceSettings& settings) {
    HRBFNPR_ASSERT(found.size() == points.size() && points.size() == starts.point.size());
    Chains<RunPoint> chains(runtime.memory);
    for (std::int64_t c = 0; c < starts.count(); ++c) {
        const std::int64_t first = chains.point.size();
        for (std::int64_t i = starts.first[c]; i < starts.first[c + 1]; ++i)
            if (found[i] != 0 &&
                (chains.point.size() == first || in_order(chains.point.back().at, points[i], side, settings)))
                chains.point.push_back({points[i]});
        chains.end(starts.closed[c] != 0);
    }
    return chains;
}

// Leaves out points that a longer run passes by, as where the mesh crosses a curve to and fro.
Curves without_doubles(const base::Runtime& runtime, const Curves& runs, double distance, double longest) {
    const NearCurves near(runs, longest, distance);
    base::Array<std::uint8_t> doubled(runtime.memory, runs.point.size());
    const auto is_longer = [&](std::int64_t s, std::int64_t r) {
        return runs.size_of(s) > runs.size_of(r) || (runs.size_of(s) == runs.size_of(r) && s < r);
    };
    runtime.parallel.for_chunks(runs.count(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t r = begin; r < end; ++r)
            for (std::int64_t i = runs.first[r]; i < runs.first[r + 1]; ++i) {
                const std::int64_t s = near.passing(runs.point[i].position, runs.point[i].direction(), distance, r);
                doubled[i] = s >= 0 && is_longer(s, r) ? 1 : 0;
            }
    });
    Curves kept(runtime.memory);
    kept.first.push_back(0);
    const auto end_run = [&](bool closed) {
        if (kept.point.size() == kept.first.back()) return;
        kept.first.push_back(kept.point.size());
        kept.closed.push_back(closed ? 1 : 0);
    };
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        bool whole = true;
        for (std::int64_t i = runs.first[r]; i < runs.first[r + 1]; ++i) {
            whole = whole && doubled[i] == 0;
            if (doubled[i] == 0)
                kept.point.push_back(runs.point[i]);
            else
                end_run(false);
        }
        end_run(whole && runs.closed[r] != 0);
    }
    return kept;
}

} // namespace

Curves starts_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const MeshChains& chains,
                 const base::Array<Bead>& beads, const TraceSettings& settings) {
    HRBFNPR_ASSERT(beads.size() == chains.crossing.size());
    Curves starts(runtime.memory);
    starts.first.push_back(0);
    const double apart = run_tuning.chosen_apart * settings.longest * mesh.side;
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        double way = apart;
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            if (i > chains.first[c]) way += glm::distance(beads[i].place, beads[i - 1].place);
            if (way < apart) continue;
            CurvePoint p;
            p.position = beads[i].place;
            starts.point.push_back(p);
            way = 0.0;
        }
        starts.first.push_back(starts.point.size());
        starts.closed.push_back(chains.closed[c]);
    }
    return starts;
}

Curves thinned(const base::Runtime& runtime, const SurfaceMesh& mesh, const Curves& starts,
               const TraceSettings& settings) {
    const double apart = run_tuning.chosen_apart * settings.longest * mesh.side;
    Curves kept(runtime.memory);
    kept.first.push_back(0);
    for (std::int64_t c = 0; c < starts.count(); ++c) {
        std::int64_t last = starts.first[c];
        for (std::int64_t i = last; i < starts.first[c + 1]; ++i) {
            const bool needed = i == last || i + 1 == starts.first[c + 1] ||
                                glm::distance(starts.point[i + 1].position, starts.point[last].position) > apart ||
                                glm::distance(unit_direction(starts.point[i + 1]), unit_direction(starts.point[last])) >
                                    run_tuning.kept_turn * settings.turn;
            if (!needed) continue;
            kept.point.push_back(starts.point[i]);
            last = i;
        }
        kept.first.push_back(kept.point.size());
        kept.closed.push_back(starts.closed[c]);
    }
    return kept;
}

Curves runs_from(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& starts,
                 const TraceSettings& settings, TraceReport& report, const base::Progress& progress) {
    const double side = mesh.side;
    HRBFNPR_ASSERT(side > 0.0 && settings.longest > 0.0);
    const auto bring_points = [&](base::Array<CurvePoint>& points, double farthest) {
        base::Array<std::uint8_t> found(runtime.memory);
        report.evaluations +=
            bring_to_curve(runtime, level, {settings.tolerance * side, farthest}, points, found, progress);
        return found;
    };
    base::Array<CurvePoint> points(runtime.memory, starts.point.size());
    std::copy(starts.point.begin(), starts.point.end(), points.begin());
    const base::Array<std::uint8_t> brought = bring_points(points, run_tuning.reach * side);
    Chains<RunPoint> chains = begin_runs(runtime, starts, points, brought, side, settings);
    // A chain of two points has no gap from the second one back to the first.
    const auto is_gap_between = [&](std::int64_t c, std::int64_t i, std::int64_t j) {
        return j > i || (j >= 0 && chains.size_of(c) > 2);
    };
    const auto wanted = [&](std::int64_t c, std::int64_t i, std::int64_t j, RunPoint& p) {
        RunPoint& a = chains.point[i];
        const RunPoint& b = chains.point[j];
        if (!is_gap_between(c, i, j) || a.link != Link::unknown) return false;
        if (is_linked(a.at, b.at, side, settings)) {
            a.link = Link::linked;
            return false;
        }
        const double width = glm::distance(a.at.position, b.at.position) / side;
        if (!(width <= run_tuning.widest * settings.longest && width >= curve_tuning.kink_length)) {
            a.link = Link::parted;
            return false;
        }
        p.at.position = CubicPiece(a.at, b.at).at(0.5);
        return true;
    };
    const auto bring = [&](base::Array<RunPoint>& added, const base::Array<std::int64_t>& of,
                           const base::Array<std::int64_t>& after) {
        base::Array<CurvePoint> middle(runtime.memory);
        for (const RunPoint& p : added) middle.push_back(p.at);
        base::Array<std::uint8_t> found = bring_points(middle, 0.5 * settings.longest * side);
        for (std::int64_t k = 0; k < added.size(); ++k) {
            added[k].at = middle[k];
            RunPoint& a = chains.point[after[k]];
            const RunPoint& b = chains.point[chains.next(of[k], after[k])];
            if (found[k] != 0 && !is_between(middle[k], a.at, b.at)) found[k] = 0;
            if (found[k] == 0) a.link = Link::parted;
        }
        return found;
    };
    for (int round = 0; round < run_tuning.rounds && halve_pieces(chains, wanted, bring); ++round) progress.check();
    Curves runs(runtime.memory);
    runs.first.push_back(0);
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        const std::int64_t first = chains.first[c];
        const std::int64_t count = chains.size_of(c);
        const auto joined = [&](std::int64_t k) {
            const RunPoint& a = chains.point[first + k];
            const std::int64_t j = chains.next(c, first + k);
            return is_gap_between(c, first + k, j) &&
                   (a.link == Link::linked ||
                    (a.link == Link::unknown && is_linked(a.at, chains.point[j].at, side, settings)));
        };
        for_joined(count, chains.closed[c] != 0, joined, [&](std::int64_t begin, std::int64_t end, bool whole) {
            for (std::int64_t k = begin; k < end; ++k) runs.point.push_back(chains.point[first + k % count].at);
            if (begin == end) return;
            runs.first.push_back(runs.point.size());
            runs.closed.push_back(whole ? 1 : 0);
        });
    }
    return without_doubles(runtime, runs, run_tuning.on_curve * side, settings.longest * side);
}

} // namespace hrbfnpr::curves
