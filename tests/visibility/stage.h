// SPDX-License-Identifier: MIT
// Surfaces in a world, the visibility of their contours, and the same by plain dense counting.
#pragma once

#include "base/random.h"
#include "curves/curve_changes.h"
#include "curves/curves.h"
#include "curves/dense_count.h"
#include "curves/trace.h"
#include "support/runtime.h"
#include "support/views.h"
#include "surface/region.h"
#include "visibility/invisibility.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

namespace hrbfnpr::visibility::test_stage {

using test::cube_directions;
using test::Eye;

inline glm::dmat4 moved(const glm::dvec3& by, double scale = 1.0) {
    glm::dmat4 m(scale);
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

struct Actor {
    const implicit::Implicit& surface;
    glm::dmat4 to_world;
    curves::SurfaceMesh mesh;
    curves::SheetCounter sheets;

    Actor(const base::Runtime& runtime, const implicit::Implicit& implicit, const geometry::VecArray& seeds,
          double side, const glm::dmat4& place)
        : surface(implicit), to_world(place), mesh(meshed(runtime, implicit, seeds, side)), sheets(runtime, mesh) {}

private:
    static curves::SurfaceMesh meshed(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                      const geometry::VecArray& seeds, double side) {
        curves::MeshSettings settings;
        settings.region = surface::search_region(implicit);
        settings.side = side;
        return curves::triangulate(runtime, implicit, seeds, settings);
    }
};

using Stage = std::vector<std::unique_ptr<Actor>>;

inline void add(const base::Runtime& runtime, Stage& stage, const implicit::Implicit& surface, const glm::dvec3& seed,
                double side, const glm::dmat4& to_world = glm::dmat4(1.0)) {
    geometry::VecArray seeds(runtime.memory);
    seeds.push_back(seed);
    stage.push_back(std::make_unique<Actor>(runtime, surface, seeds, side, to_world));
}

// A place on a line in the image.
struct Place {
    std::int64_t line, piece;
    double share, at;
};

// The image of a stage from one eye.
class Picture {
public:
    Picture(const base::Runtime& runtime, const Stage& stage, const Eye& eye) : runtime_(runtime), eye_(eye) {
        for (const std::unique_ptr<Actor>& actor : stage) trace(*actor);
    }
    // Adds lines other than contours.
    void add(const Subject& subject) { subjects.push_back(subject); }
    void find(const InvisibilitySettings& settings = {}, const base::Progress& progress = {}) {
        if (!found) given_ = subjects;
        found.emplace(find_invisibility({runtime_, progress}, given_, occluders, settings));
        subjects.assign(found->subjects.begin(), found->subjects.end()); // includes the curves of the lines
        lengths.emplace(runtime_.memory, found->lines);
    }

    // Returns the sum of changes around a closed line that is largest in amount, of all closed lines of any size.
    [[nodiscard]] std::int32_t worst_sum() const {
        const Events events = collect_events(runtime_.memory, subjects, found->lines, found->crossings,
                                             found->piercings.span(), *lengths);
        std::int32_t worst = 0;
        for (std::int64_t l = 0; l < found->lines.lines.size(); ++l) {
            std::int32_t sum = 0;
            for (const Event& e : events.of(l)) sum += e.change;
            if (found->lines.lines[l].closed) worst = std::max(worst, std::abs(sum));
        }
        return worst;
    }
    [[nodiscard]] Place random_place(std::int64_t number) const {
        const auto u = base::uniform4(5, static_cast<std::uint64_t>(number), base::Purpose::probe, 0);
        const auto piece = static_cast<std::int64_t>(u[0] * static_cast<double>(found->lines.pieces.size()));
        const std::int64_t l = found->lines.pieces[piece].line;
        return {l, piece, u[1], lengths->at(found->lines.lines[l], piece, u[1])};
    }
    // Returns the sheets of the part that has this place, unless the part's end is within `beside` pixels.
    [[nodiscard]] std::optional<std::int32_t> sheets_at(const Place& place) const {
        const double whole = lengths->total(found->lines.lines[place.line]);
        for (const Interval& part : found->intervals) {
            if (part.line != place.line) continue;
            if (part.end_at - part.begin_at >= whole && found->lines.lines[place.line].closed) return part.invisibility;
            for (const double at : {place.at, place.at + whole})
                if (at > part.begin_at + beside && at < part.end_at - beside) return part.invisibility;
        }
        return std::nullopt;
    }
    // Tells whether a cusp of the place's line is within 0.25 pixels.
    [[nodiscard]] bool near_cusp(const Place& place) const {
        const Events events = collect_events(runtime_.memory, subjects, found->lines, found->crossings,
                                             found->piercings.span(), *lengths);
        bool near = false;
        for (const Event& e : events.of(place.line))
            near = near || (e.near_piece < 0 && std::abs(e.at - place.at) < 0.25);
        return near;
    }
    // Returns the point on the curve itself, in the subject's coordinates.
    [[nodiscard]] glm::dvec3 point_at(const Place& place) const {
        const Piece& piece = found->lines.pieces[place.piece];
        const Subject& subject = subjects[static_cast<std::size_t>(piece.subject)];
        base::Array<curves::CurvePoint> p(runtime_.memory, 1);
        p[0].position = cubic(subjects, piece).at(place.share);
        for (int step = 0; step < 3 && subject.level != nullptr; ++step) {
            curves::evaluate(runtime_, *subject.level, p);
            p[0].position += p[0].newton_step();
        }
        return p[0].position;
    }
    // Counts the roots of all surfaces along the line of sight, except those nearer to the place than 5e-3 sides.
    [[nodiscard]] std::int32_t dense_count(const Place& place, int samples) const {
        const Subject& subject = subjects[static_cast<std::size_t>(found->lines.pieces[place.piece].subject)];
        const glm::dvec3 in_world(subject.to_world * glm::dvec4(point_at(place), 1.0));
        std::int32_t sheets = 0;
        for (std::size_t o = 0; o < occluders.size(); ++o) {
            const Occluder& occluder = occluders[o];
            glm::dvec3 to(glm::inverse(occluder.to_world) * glm::dvec4(in_world, 1.0));
            glm::dvec3 from =
                occluder.eye.w != 0.0 ? glm::dvec3(occluder.eye) : to - 20.0 * glm::normalize(glm::dvec3(occluder.eye));
            if (static_cast<std::size_t>(subject.item) == o) to -= 5e-3 * subject.side * glm::normalize(to - from);
            if (curves::test_dense::clip(surface::search_region(*occluder.surface), from, to))
                sheets += curves::test_dense::roots({*occluder.surface, from, to}, samples);
        }
        return sheets;
    }

    std::vector<Subject> subjects;
    std::vector<Occluder> occluders;
    std::optional<Invisibility> found;
    std::optional<LineLengths> lengths;
    double beside = 0.05;

private:
    void trace(const Actor& actor) {
        const curves::View view = eye_.view(actor.to_world);
        levels_.push_back(std::make_unique<curves::ContourLevel>(actor.surface, view));
        curves::TraceReport report;
        const curves::Curves traced = curves::trace(runtime_, *levels_.back(), actor.mesh, {}, report);
        curves_.push_back(std::make_unique<curves::Curves>(
            curves::with_cusps(runtime_, *levels_.back(), view, traced, report.evaluations)));
        Subject subject;
        subject.curves = curves_.back().get();
        subject.level = levels_.back().get();
        subject.view = view;
        subject.side = actor.mesh.side;
        subject.to_world = actor.to_world;
        subject.item = static_cast<std::int32_t>(occluders.size());
        subject.mirrored = glm::determinant(glm::dmat3(actor.to_world)) < 0.0;
        subjects.push_back(subject);
        occluders.push_back({&actor.sheets, &actor.surface, actor.to_world, view.eye});
    }

    const base::Runtime& runtime_;
    Eye eye_;
    std::vector<Subject> given_;
    std::vector<std::unique_ptr<curves::ContourLevel>> levels_;
    std::vector<std::unique_ptr<curves::Curves>> curves_;
};

// Expects that all changes add up without rays that settle them, and that the counts equal the dense ones at this
// number of random places. Returns the number of places compared.
inline int expect_right(const Picture& picture, int places, int samples = 400) {
    EXPECT_EQ(picture.found->report.contradictions, 0);
    EXPECT_EQ(picture.found->report.settled, 0);
    EXPECT_EQ(picture.worst_sum(), 0);
    int compared = 0;
    int wrong = 0;
    for (int i = 0; i < places && !picture.found->lines.pieces.empty(); ++i) {
        const Place place = picture.random_place(i);
        const std::optional<std::int32_t> sheets = picture.sheets_at(place);
        if (!sheets) continue;
        ++compared;
        if (*sheets != picture.dense_count(place, samples)) ++wrong;
    }
    EXPECT_EQ(wrong, 0);
    return compared;
}

inline testing::Message named(const Eye& eye) {
    return testing::Message() << (eye.perspective ? "perspective " : "orthographic ") << eye.back.x << ' ' << eye.back.y
                              << ' ' << eye.back.z;
}

} // namespace hrbfnpr::visibility::test_stage
