// SPDX-License-Identifier: MIT
#include "picture/view_verify.h"

#include "api/line_set.h"
#include "picture/tuning_views.h"
#include "visibility/sight.h"

#include <utility>

namespace hrbfnpr::picture {
namespace {

constexpr const ViewProofTuning& tuned_proof = view_proof_tuning;
using visibility::Seen;
using visibility::Sighting;
using visibility::SightPlace;

// Consecutive pieces of a curve that are all hidden, or all visible, between two lengths along it.
struct CurveRun {
    std::size_t curve;
    std::size_t begin, end; // the run has the pieces from `begin` up to but not including `end`
    double from, to;        // in mm
    bool hidden;
};

// A place on a run, at a length along its curve.
struct RunPlace {
    std::size_t run;
    double at;
};

// Looks at the places of curves from the eye of a view.
struct ViewSight {
    const Vector<ViewCurve>& curves;
    const Vector<Vector<double>>& along; // for each curve: the lengths up to its points
    const SheetView& view;
    const CutPlane* plane; // may be null
    const Solid& solid;
    double scale;
    hrbfnpr_operation* operation;
    Pool& pool;
};

Vector<CurveRun> runs_of_curves(const Vector<ViewCurve>& curves, const Vector<Vector<double>>& along, Pool& pool) {
    Vector<CurveRun> runs(&pool);
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const Flags& hidden = curves[c].hidden;
        if (curves[c].places.empty()) continue;
        for (std::size_t begin = 0; begin < hidden.size();) {
            std::size_t end = begin;
            while (end < hidden.size() && hidden[end] == hidden[begin]) ++end;
            runs.push_back({c, begin, end, along[c][begin], along[c][end], hidden[begin] != 0});
            begin = end;
        }
    }
    return runs;
}

base::Array<Sighting> look(const ViewSight& sight, const Vector<CurveRun>& runs, const Vector<RunPlace>& places) {
    Vector<visibility::Occluder> occluders(&sight.pool);
    bool is_open = false;
    sight.solid.for_surfaces([&](const Solid& surface) {
        const hrbfnpr_line_set& lines = *surface.lines.get();
        visibility::Occluder& occluder = occluders.emplace_back();
        occluder.sheet_counter = &lines.lines.sheets();
        occluder.surface = &lines.lines.surface();
        occluder.eye = glm::dvec4(-sight.view.eye, 0.0);
        is_open = is_open || surface.is_open;
    });
    Vector<SightPlace> rays(&sight.pool);
    for (const RunPlace& place : places) {
        const std::size_t number = runs[place.run].curve;
        const ViewCurve& curve = sight.curves[number];
        SightPlace& ray = rays.emplace_back();
        ray.place = interpolated<glm::dvec3>(sight.along[number], curve.places, place.at);
        ray.item = occluders.size() == 1 ? 0 : visibility::any_item;
        ray.margin = tuned_proof.margin / sight.scale;
        ray.lift = std::max(curve.lift, ray.margin);
        if (sight.plane == nullptr) continue;
        ray.reach = std::max(0.0, sight.plane->place - glm::dot(ray.place, sight.plane->normal));
        ray.is_cut = !is_open;
    }
    const base::Work work(sight.solid.lines.get()->runtime(),
                          sight.operation != nullptr ? base::Progress(&sight.operation->operation) : base::Progress());
    base::Array<Sighting> seen = visibility::look_at(work.without_progress(), occluders, rays);
    for (std::size_t i = 0; i < places.size(); ++i) {
        Sighting& sighting = seen[static_cast<std::int64_t>(i)];
        if (runs[places[i].run].hidden && sighting.grazes && sighting.seen == Seen::visible)
            sighting.seen = Seen::undecided;
    }
    return seen;
}

// Adds places along a run, away from its ends. A short run has one place, in its middle.
void add_places(const CurveRun& run, std::size_t number, Vector<RunPlace>& places, Pool& pool) {
    const double from = run.from + tuned_proof.from_end;
    const double to = run.to - tuned_proof.from_end;
    if (!(to > from)) {
        places.push_back({number, 0.5 * (run.from + run.to)});
        return;
    }
    const std::size_t count = std::max<std::size_t>(3, count_on(to - from, tuned_proof.step));
    for (const double at : evenly(from, to, count, pool)) places.push_back({number, at});
}

// A length along a curve from which on the curve is seen otherwise.
struct CurveTurn {
    std::size_t run;
    double at;
    bool hidden; // the state from there on
};

// Finds the turns of runs, each between two places that differ. Halving the way between them makes them exact.
Vector<CurveTurn> find_turns(const ViewSight& sight, const Vector<CurveRun>& runs, const Vector<RunPlace>& places,
                             const base::Array<Sighting>& seen) {
    Vector<CurveTurn> turns(&sight.pool);
    Vector<std::pair<double, double>> between(&sight.pool);
    std::size_t last = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Seen now = seen[static_cast<std::int64_t>(i)].seen;
        if (now == Seen::undecided) continue;
        if (last < places.size() && places[last].run == places[i].run &&
            seen[static_cast<std::int64_t>(last)].seen != now) {
            turns.push_back({places[i].run, places[i].at, now == Seen::hidden});
            between.emplace_back(places[last].at, places[i].at);
        }
        last = i;
    }
    Vector<RunPlace> middles(&sight.pool);
    for (int k = 0; k < tuned_proof.halvings && !turns.empty(); ++k) {
        middles.clear();
        for (std::size_t i = 0; i < turns.size(); ++i)
            middles.push_back({turns[i].run, 0.5 * (between[i].first + between[i].second)});
        const base::Array<Sighting> found = look(sight, runs, middles);
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const bool is_before =
                found[static_cast<std::int64_t>(i)].seen == (turns[i].hidden ? Seen::visible : Seen::hidden);
            (is_before ? between[i].first : between[i].second) = middles[i].at;
        }
    }
    for (std::size_t i = 0; i < turns.size(); ++i) turns[i].at = 0.5 * (between[i].first + between[i].second);
    return turns;
}

// Changes the state of the pieces of a run from the length `from` on. Adds a point there.
void turn_from(ViewCurve& curve, Vector<double>& along, double from, double to, bool hidden) {
    const auto after = std::upper_bound(along.begin(), along.end(), from);
    const auto i = static_cast<std::size_t>(after - along.begin());
    if (i > 0 && i < along.size() && along[i - 1] < from) {
        const auto place = static_cast<std::ptrdiff_t>(i);
        const glm::dvec2 point = interpolated<glm::dvec2>(along, curve.points, from);
        const glm::dvec3 at = interpolated<glm::dvec3>(along, curve.places, from);
        curve.points.insert(curve.points.begin() + place, point);
        curve.places.insert(curve.places.begin() + place, at);
        curve.hidden.insert(curve.hidden.begin() + place, curve.hidden[i - 1]);
        along.insert(along.begin() + place, from);
    }
    for (std::size_t k = 0; k + 1 < along.size(); ++k)
        if (along[k] >= from && along[k + 1] <= to) curve.hidden[k] = hidden ? 1 : 0;
}

} // namespace

LineProof verify_curves(Vector<ViewCurve>& curves, const SheetView& view, const CutPlane* plane, const Solid& solid,
                        double scale, hrbfnpr_operation* operation, Pool& pool) {
    HRBFNPR_ASSERT(scale > 0.0 && solid.lines);
    LineProof proof;
    Vector<Vector<double>> along(&pool);
    for (const ViewCurve& curve : curves) {
        HRBFNPR_ASSERT(curve.places.empty() || curve.places.size() == curve.points.size());
        along.push_back(lengths_along(curve.points, pool));
    }
    const ViewSight sight{curves, along, view, plane, solid, scale, operation, pool};
    for (int round = 0;; ++round) {
        const Vector<CurveRun> runs = runs_of_curves(curves, along, pool);
        Vector<RunPlace> places(&pool);
        for (std::size_t i = 0; i < runs.size(); ++i) add_places(runs[i], i, places, pool);
        const base::Array<Sighting> seen = look(sight, runs, places);
        Vector<Seen> first_seen(runs.size(), Seen::undecided, &pool);
        Flags wrong(runs.size(), 0, &pool);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Seen now = seen[static_cast<std::int64_t>(i)].seen;
            if (now == Seen::undecided) continue;
            Seen& first = first_seen[places[i].run];
            if (first == Seen::undecided) first = now;
            if ((now == Seen::hidden) != runs[places[i].run].hidden) wrong[places[i].run] = 1;
        }
        const auto all_wrong = std::count(wrong.begin(), wrong.end(), std::uint8_t{1});
        if (all_wrong == 0 || round == tuned_proof.rounds) {
            for (ViewCurve& curve : curves) curve.sure.assign(curve.places.empty() ? 0 : curve.hidden.size(), 0);
            for (std::size_t i = 0; i < runs.size(); ++i) {
                ++proof.pieces;
                const bool agrees = first_seen[i] != Seen::undecided && wrong[i] == 0;
                if (first_seen[i] == Seen::undecided) ++proof.undecided;
                if (agrees) ++proof.agreeing;
                Flags& sure = curves[runs[i].curve].sure;
                std::fill(sure.begin() + static_cast<std::ptrdiff_t>(runs[i].begin),
                          sure.begin() + static_cast<std::ptrdiff_t>(runs[i].end), std::uint8_t{agrees});
            }
            return proof;
        }
        proof.repaired += all_wrong;
        const Vector<CurveTurn> turns = find_turns(sight, runs, places, seen);
        std::size_t next = 0;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const CurveRun& run = runs[i];
            if (wrong[i] != 0)
                turn_from(curves[run.curve], along[run.curve], run.from, run.to, first_seen[i] == Seen::hidden);
            for (; next < turns.size() && turns[next].run == i; ++next)
                turn_from(curves[run.curve], along[run.curve], turns[next].at, run.to, turns[next].hidden);
        }
    }
}

} // namespace hrbfnpr::picture
