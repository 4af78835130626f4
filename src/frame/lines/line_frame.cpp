// SPDX-License-Identifier: MIT
// A frame of lines, step by step:
//
// 1. camera_off_planes makes a camera that sees no face exactly edge-on. All lines are seen through it.
// 2. trace_lines traces curves for this camera. For each item with lines, its contours (trace_contours, which begins
//    with those of the last frame where the camera moved little), its creases that are contours (add_contour_creases)
//    and its border (add_border) become subjects even if they are not drawn, since they hide other lines. Where items
//    cross, their intersections are found, or those of the last frame are used (trace_intersections). Then the subjects
//    of each style of lines are found or made (add_style), and the style gets a layer.
// 3. find_invisibility and find_hidden_by count the sheets in front of the lines.
// 4. number_lines gives lines the numbers that they had in the last frame. Points of each line vote for the line of the
//    last frame that has the nearest point with the same direction (count_votes). Pairs of lines with the most votes
//    are matched first.
// 5. add_strokes makes the strokes, and thin_lines_beside_others thins some of them.
#include "frame/lines/line_frame.h"

#include "base/assert.h"
#include "base/clock.h"
#include "features/contours.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"
#include "frame/scene/tuning.h"
#include "geometry/point_grid.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string_view>
#include <tuple>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// The shares of the frame's time at which its steps end.
constexpr double traced_end = 0.32;
constexpr double found_end = 0.8;
constexpr double hidden_end = 0.9;

bool is_shadow(LineKind kind) noexcept { return kind == LineKind::shadow || kind == LineKind::terminator; }

bool draws_lines(const Item& item) noexcept { return item.lines != nullptr && !item.style.lines.empty(); }

void add_counts(const visibility::Invisibility& found, const TracedLines& traced,
                drawing::LineCounts& counts) noexcept {
    counts.curves = found.report.lines;
    counts.cusps = found.report.cusps;
    counts.crossings = found.crossings.size();
    counts.broken = traced.broken;
    counts.refined = found.report.refined;
    counts.settled = found.report.settled;
    counts.contradictions = found.report.contradictions;
    counts.tangles = found.report.crossings.tangles;
}

// An item with lines, and the indices of its subjects. `contours` is the index of the first contour. `folds` is the
// index of the creases that are contours. The border has the indices from `border` to `end`.
struct LineSource {
    const Item& item;
    curves::View view;
    std::int32_t number; // the source's index among the occluders
    bool mirrored;
    std::int32_t contours, border, end;
    std::int32_t folds = -1; // -1 if no crease of the item is a contour
    const curves::CreaseParts* creases = nullptr;
    bool draws_intersections = false; // whether a style of the item draws intersections
    bool has_intersections = false;   // whether the item has intersections that are drawn as its lines

    [[nodiscard]] const curves::LineSet& lines() const noexcept { return *item.lines; }
    [[nodiscard]] bool is_open() const noexcept { return lines().border().curves.count() > 0; }
};

// ---- The camera

// Returns the camera for all lines of a scene. If a face is seen exactly edge-on, it is not clear on which side of its
// edges it lies. So if an item has creases, the eye is moved a little to one side. An orthographic camera becomes a
// perspective one at a large finite distance, so that faces parallel to its axis turn away a little.
Camera camera_off_planes(const Scene& scene, std::span<const Item> items) {
    geometry::Bounds box; // in eye space
    bool sharp = false;
    for (const Item& item : items) {
        if (item.lines == nullptr) continue;
        sharp = sharp || item.lines->creases().count() > 0;
        const glm::dmat4 to_eye = scene.camera.view * item.transform;
        const geometry::Bounds& region = item.lines->mesh().region;
        for (int i = 0; i < 8; ++i) {
            const glm::bvec3 high((i & 1) != 0, (i & 2) != 0, (i & 4) != 0);
            box.extend(glm::dvec3(to_eye * glm::dvec4(glm::mix(region.min, region.max, high), 1.0)));
        }
    }
    Camera camera = scene.camera;
    const double radius = sharp ? 0.5 * glm::length(box.size()) : 0.0;
    const double middle = 0.5 * (box.min.z + box.max.z);
    if (!(radius > 0.0) || !std::isfinite(radius) || !std::isfinite(middle)) return camera;
    // x and y shift in proportion to z - middle. For an orthographic camera, w changes with z, which puts the eye at a
    // finite distance.
    glm::dmat4 moved(1.0);
    const double shift = scene_tuning.off_planes;
    const glm::dvec2 to_side =
        line_tuning.sideways_share * shift *
        glm::dvec2(std::cos(scene_tuning.off_planes_angle), std::sin(scene_tuning.off_planes_angle));
    for (int axis = 0; axis < 2; ++axis) {
        moved[2][axis] = to_side[axis];
        moved[3][axis] = -to_side[axis] * middle;
    }
    if (make_optics(camera).centre.w == 0.0) {
        moved[2][3] = -shift / radius;
        moved[3][3] = 1.0 + shift / radius * middle;
    }
    camera.projection = camera.projection * moved;
    return camera;
}

curves::View view_of(const Camera& camera, const Item& item) {
    const Optics optics = make_optics(camera);
    const glm::dmat4 to_eye = camera.view * item.transform;
    return {curves::eye_for(*item.lines, glm::inverse(to_eye) * optics.centre), optics.window * to_eye};
}

// ---- Subjects

visibility::Subject& add_subject(const LineSource& source, const curves::Curves& curves, TracedLines& out) {
    visibility::Subject subject;
    subject.curves = &curves;
    subject.view = source.view;
    subject.side = source.lines().mesh().side;
    subject.to_world = source.item.transform;
    subject.item = source.number;
    subject.mirrored = source.mirrored;
    out.subjects.push_back(subject);
    return out.subjects.back();
}

// Moves the contours of a part out of the list of all contours of the last frame. Returns null without such contours.
// `next` is the index at which the search begins, because the parts of a frame mostly have the order of the last one.
std::unique_ptr<Contours> take_last(const curves::SmoothPart& part, std::int64_t item, ContourList& all_last,
                                    std::int64_t& next) {
    for (std::int64_t k = 0; k < all_last.size(); ++k) {
        const std::int64_t at = (next + k) % all_last.size();
        std::unique_ptr<Contours>& known = all_last[at];
        if (known == nullptr || known->item != item || known->part != part.part || known->set != part.lines.identity())
            continue;
        next = at + 1;
        return std::move(known);
    }
    return nullptr;
}

// Returns the contours of a part in this view. `last` are its contours in the last frame, or null. If the eye has not
// moved since then, they are used again.
std::unique_ptr<Contours> find_contours(const base::Work& work, const curves::SmoothPart& part, std::int64_t item,
                                        const curves::ContourLevel& level, std::unique_ptr<Contours> last) {
    const curves::View& view = level.view();
    if (last != nullptr && last->eye == view.eye) return last;
    const curves::SurfaceMesh& mesh = part.mesh();
    auto contours = std::make_unique<Contours>(work.memory);
    contours->set = part.lines.identity();
    contours->item = item;
    contours->part = part.part;
    contours->eye = view.eye;
    const auto trace = [&](const curves::Curves* near) {
        curves::TraceReport report;
        curves::TraceSettings settings;
        if (near != nullptr) settings.tolerance = line_tuning.moved_tolerance;
        contours->traced = curves::trace(work, level, mesh, settings, report, near);
        contours->from_last = near != nullptr;
        contours->broken = report.broken + report.missed;
    };
    // Tracing begins with the contours of the last frame, if nearly all of their points have moved only a little.
    if (last != nullptr) {
        const curves::Curves moved =
            curves::moved_contours(work.memory, view, last->traced, line_tuning.farthest_move * mesh.side);
        const double least = (1.0 - line_tuning.most_left_out) * static_cast<double>(last->traced.point.size());
        if (!moved.point.empty() && static_cast<double>(moved.point.size()) >= least) trace(&moved);
    }
    if (!contours->from_last || contours->broken > 0) trace(nullptr);
    std::int64_t evaluations = 0;
    contours->with_cusps = curves::with_cusps(work, level, view, contours->traced, evaluations);
    return contours;
}

// Traces the contours of an item. On a sheet, contours end at the creases of the sheet.
void trace_contours(const base::Work& work, const LineSource& source, ContourList& last, TracedLines& out) {
    const curves::LineSet& lines = source.lines();
    const std::int64_t first = out.contours.size();
    const std::int64_t item = out.items[source.number];
    HRBFNPR_ASSERT(out.levels.size() == first);
    std::int64_t next = 0;
    const auto prepare = [&](std::int64_t p) {
        const curves::SmoothPart part{lines, p};
        out.levels.add(std::make_unique<curves::ContourLevel>(part.surface(), source.view));
        out.contours.add(take_last(part, item, last, next));
    };
    curves::trace_parts(work, lines, prepare, [&](const base::Work& with, std::int64_t p) {
        std::unique_ptr<Contours>& contours = out.contours[first + p];
        contours = find_contours(with, {lines, p}, item, *out.levels[first + p], std::move(contours));
    });
    for (std::int64_t p = 0; p < curves::smooth_parts_of(lines); ++p) {
        const Contours& contours = *out.contours[first + p];
        out.broken += contours.broken;
        visibility::Subject& subject = add_subject(source, contours.with_cusps, out);
        subject.level = out.levels[first + p].get();
        subject.joined = !lines.parts().empty();
    }
}

// Adds the creases that are contours: one of the two sheets faces the eye, and the other faces away.
void add_contour_creases(const base::Runtime& runtime, LineSource& source, TracedLines& out) {
    const curves::LineSet& lines = source.lines();
    if (lines.creases().count() == 0) return;
    source.creases = out.creases
                         .add(std::make_unique<curves::CreaseParts>(
                             curves::parts_in_view(runtime, *lines.surface().sheets(), lines.creases(), source.view)))
                         .get();
    if (source.creases->folds.curves.count() == 0) return;
    source.folds = static_cast<std::int32_t>(out.subjects.size());
    visibility::Subject& subject = add_subject(source, source.creases->folds.curves, out);
    subject.joined = true;
    subject.clearance = visibility::visibility_tuning.crease_clearance;
}

// Adds lines on the surface, divided where they turn away from the eye. `sheets` is Subject::sheets.
void add_lines(const base::Runtime& runtime, const LineSource& source, const curves::SurfaceLines& lines,
               const LineStyle* style, std::uint32_t layer, std::int32_t sheets, TracedLines& out) {
    HRBFNPR_ASSERT(style != nullptr || sheets > 0);
    if (lines.curves.count() == 0) return;
    for (const bool outside : {true, false}) {
        // Lines on the inside are hidden by their surface, unless the surface is open.
        if (!outside && sheets == 0 && style->hidden == HiddenParts::none && !source.is_open()) continue;
        const curves::SurfaceLines& parts = *out.lines.add(
            std::make_unique<curves::SurfaceLines>(curves::facing_parts(runtime.memory, lines, source.view, outside)));
        const auto number = static_cast<std::int32_t>(out.subjects.size());
        visibility::Subject& subject = add_subject(source, parts.curves, out);
        subject.sheet_change = sheets;
        if (style == nullptr) continue;
        if (curves::is_given(style->kind)) subject.clearance = line_tuning.caller_line_clearance;
        subject.joined =
            is_shadow(style->kind) || (style->kind == LineKind::section && source.lines().creases().count() > 0);
        out.styles.push_back({style, number, layer, parts.strength.data()});
    }
}

// Adds the border of an item. It is needed even if it is not drawn, because a surface hides other things only up to its
// border.
void add_border(const base::Runtime& runtime, LineSource& source, TracedLines& out) {
    const curves::LineSet& lines = source.lines();
    source.border = static_cast<std::int32_t>(out.subjects.size());
    add_lines(runtime, source, curves::with_turns(runtime, lines.border(), lines.surface(), source.view), nullptr, 0, 1,
              out);
    source.end = static_cast<std::int32_t>(out.subjects.size());
    for (std::int32_t s = source.border; s < source.end; ++s) out.subjects[s].level = lines.border_level();
}

// Adds the creases that are not contours. If no style of the item draws contours, adds all creases.
void add_other_creases(const base::Runtime& runtime, const LineSource& source, const LineStyle& style,
                       std::uint32_t layer, TracedLines& out) {
    HRBFNPR_ASSERT(source.creases != nullptr);
    const curves::CreaseParts& parts = *source.creases;
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    for (const bool outside : {true, false}) {
        if (!outside && style.hidden == HiddenParts::none && !source.is_open()) continue;
        const curves::SurfaceLines& lines = *out.lines.add(std::make_unique<curves::SurfaceLines>(
            curves::bent_parts(runtime.memory, outside ? parts.outside : parts.inside,
                               outside ? parts.of_outside : parts.of_inside, style.creases, by.lower, by.upper)));
        if (lines.curves.count() == 0) continue;
        visibility::Subject& subject = add_subject(source, lines.curves, out);
        subject.sheet_change = 0;
        subject.joined = true;
        subject.clearance = visibility::visibility_tuning.crease_clearance;
        out.styles.push_back(
            {&style, static_cast<std::int32_t>(out.subjects.size() - 1), layer, lines.strength.data()});
    }
    const std::span<const LineStyle> all = source.item.style.lines;
    const bool outlined =
        std::any_of(all.begin(), all.end(), [](const LineStyle& other) { return other.kind == LineKind::contour; });
    if (outlined || source.folds < 0) return;
    base::Array<float>& strength = out.numbers.add(runtime.memory);
    for (const float angle : parts.folds.strength) strength.push_back(curves::angle_on(style.creases, angle));
    out.styles.push_back({&style, source.folds, layer, strength.data()});
    out.styles.back().cut = true;
}

// Adds feature lines, interpolated on the mesh, which is exact enough for drawing. `towards` is the eye or, for
// isophotes, the light.
void add_features(const base::Work& work, const LineSource& source, const LineStyle& style, std::uint32_t layer,
                  const glm::dvec4& towards, TracedLines& out) {
    curves::FeatureRequest request;
    request.kind = curves::feature_of(style.kind);
    request.towards = towards;
    request.levels = style.levels;
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    request.lower = by.lower;
    request.upper = by.upper;
    request.shortest = line_tuning.shortest_feature;
    request.rounds = style.kind == LineKind::apparent_ridge ? line_tuning.ridge_rounds : 0;
    const curves::FeatureLines lines = find_feature_lines(work.without_progress(), source.lines().features(), request);
    add_lines(work, source, curves::as_lines(work.memory, lines), &style, layer, 0, out);
}

// ---- Intersections of items

// Returns whether two maps have the same images of a box, up to rounding.
bool is_same_map(const glm::dmat4& a, const glm::dmat4& b, const geometry::Bounds& box) noexcept {
    const double reach = glm::length(glm::max(glm::abs(box.min), glm::abs(box.max)));
    for (int c = 0; c < 4; ++c)
        if (!(glm::length(a[c] - b[c]) * (c < 3 ? reach : 1.0) <= line_tuning.same_pose * box.diagonal())) return false;
    return true;
}

// Returns the intersections of two items. Those of the last frame are used again if the items have not moved relative
// to each other. An item's number is its index among the occluders.
std::unique_ptr<ItemIntersections> find_item_intersections(const base::Work& work, const LineSource& source,
                                                           const LineSource& other, const TracedLines& out,
                                                           IntersectionList& last) {
    const glm::dmat4 to_other = glm::inverse(other.item.transform) * source.item.transform;
    if (!curves::may_intersect(source.lines(), other.lines(), to_other)) return nullptr;
    auto fresh = std::make_unique<ItemIntersections>(work.memory);
    fresh->set = source.lines().identity();
    fresh->other_set = other.lines().identity();
    fresh->item = out.items[source.number];
    fresh->other = out.items[other.number];
    fresh->to_other = to_other;
    for (std::unique_ptr<ItemIntersections>& known : last)
        if (known != nullptr && known->item == fresh->item && known->other == fresh->other &&
            known->set == fresh->set && known->other_set == fresh->other_set &&
            is_same_map(known->to_other, to_other, source.lines().mesh().region))
            return std::move(known);
    fresh->found = curves::find_intersections(work.without_progress(), source.lines(), other.lines(), to_other);
    return fresh;
}

// Returns the length of a mesh side in world units.
double world_side(const LineSource& source) noexcept {
    return source.lines().mesh().side * std::cbrt(std::abs(glm::determinant(glm::dmat3(source.item.transform))));
}

// Finds the intersections of all pairs of items of which one draws intersections. The item with the finer mesh draws
// them, because it shows smaller loops. Adds those that exist.
void trace_intersections(const base::Work& work, base::List<LineSource>& sources, IntersectionList& last,
                         TracedLines& out) {
    for (LineSource& a : sources)
        for (LineSource& b : sources) {
            if (a.number >= b.number || (!a.draws_intersections && !b.draws_intersections)) continue;
            const bool first = a.draws_intersections && (!b.draws_intersections || world_side(a) <= world_side(b));
            LineSource& source = first ? a : b;
            std::unique_ptr<ItemIntersections> found = find_item_intersections(work, source, first ? b : a, out, last);
            if (found == nullptr) continue;
            source.has_intersections = source.has_intersections || found->found.curves.count() > 0;
            out.broken += found->found.broken;
            out.intersections.add(std::move(found));
        }
}

// Adds the intersections of an item with others, divided where one of both surfaces turns away from the eye.
void add_intersections(const base::Work& work, const base::List<LineSource>& sources, const LineSource& source,
                       const LineStyle& style, std::uint32_t layer, TracedLines& out) {
    const double lower = curves::thresholds_of(style.kind, {style.lower, style.upper}).lower;
    for (const std::unique_ptr<ItemIntersections>& its : out.intersections) {
        if (its->item != out.items[source.number]) continue;
        const LineSource& other = *std::find_if(
            sources.begin(), sources.end(), [&](const LineSource& one) { return out.items[one.number] == its->other; });
        curves::Curves wanted(work.memory);
        for (std::int64_t c = 0; c < its->found.curves.count(); ++c) {
            if (!(static_cast<double>(its->found.angle[c]) >= lower)) continue;
            for (std::int64_t i = its->found.curves.first[c]; i < its->found.curves.first[c + 1]; ++i)
                wanted.point.push_back(its->found.curves.point[i]);
            wanted.end(its->found.curves.closed[c] != 0);
        }
        const curves::IntersectionLevel level(source.lines().surface(), other.lines().surface(), its->to_other);
        const base::Work threads =
            source.lines().surface().threads(other.lines().surface().threads(work.without_progress()));
        const curves::FacingParts of_first = curves::facing_parts(threads, level, source.view, false, wanted);
        for (const bool outside : {true, false}) {
            // A closed surface hides the lines on its inside.
            if (!outside && !source.is_open() && style.hidden == HiddenParts::none) continue;
            curves::FacingParts of_other =
                curves::facing_parts(threads, level, source.view, true, outside ? of_first.outside : of_first.inside);
            for (const bool other_outside : {true, false}) {
                if (!other_outside && !other.is_open() && style.hidden == HiddenParts::none) continue;
                curves::Curves& parts = other_outside ? of_other.outside : of_other.inside;
                if (parts.count() == 0) continue;
                const auto number = static_cast<std::int32_t>(out.subjects.size());
                visibility::Subject& subject =
                    add_subject(source, *out.parts.add(std::make_unique<curves::Curves>(std::move(parts))), out);
                subject.sheet_change = 0;
                subject.other_item = other.number;
                subject.joined = true;
                subject.clearance = visibility::visibility_tuning.crease_clearance;
                out.styles.push_back({&style, number, layer});
            }
        }
    }
}

void add_style(const base::Work& work, const Scene& scene, const LineSource& source, const LineStyle& style,
               std::uint32_t layer, TracedLines& out) {
    const Item& item = source.item;
    switch (style.kind) {
    case LineKind::contour:
        for (std::int32_t s = source.contours; s < source.border; ++s) out.styles.push_back({&style, s, layer});
        break;
    case LineKind::crease: add_other_creases(work, source, style, layer, out); break;
    case LineKind::border:
        for (std::int32_t s = source.border; s < source.end; ++s) out.styles.push_back({&style, s, layer});
        break;
    case LineKind::suggestive_contour:
    case LineKind::apparent_ridge: {
        const glm::dvec4& eye = source.view.eye;
        const glm::dvec4 towards = eye.w == 0.0 ? glm::dvec4(-glm::dvec3(eye), 0.0) : eye;
        add_features(work, source, style, layer, towards, out);
        break;
    }
    case LineKind::isophote: {
        // The inverse transpose transforms normals, so that n . l is the same as in the space of the light.
        const LightStyle key = item.style.key_light();
        const glm::dmat3 to_space = key.space == LightSpace::camera  ? glm::dmat3(scene.camera.view * item.transform)
                                    : key.space == LightSpace::world ? glm::dmat3(item.transform)
                                                                     : glm::dmat3(1.0);
        const glm::dvec4 light(glm::normalize(glm::inverse(to_space) * key.place), 0.0);
        add_features(work, source, style, layer, light, out);
        break;
    }
    case LineKind::shadow:
    case LineKind::terminator:
        if (item.shading == nullptr) break;
        for (const curves::FoundLines& found : item.shading->lines)
            if (found.kind == style.kind) add_lines(work, source, found.lines, &style, layer, 0, out);
        break;
    default:
        for (const curves::FoundLines& found : source.lines().found())
            if (found.kind == style.kind && found.is_on(style.creases) &&
                (style.name == nullptr || std::strcmp(style.name, found.name.data()) == 0))
                add_lines(work, source, found.lines, &style, layer, 0, out);
    }
}

// Traces all lines of the items. Adds a layer to the drawing for each style of lines. Contours and intersections of the
// last frame that are still valid are moved out of `last` and `last_intersections`.
TracedLines trace_lines(const base::Work& work, const Scene& scene, std::span<const Item> items, ContourList& last,
                        IntersectionList& last_intersections, drawing::Drawing& drawing) {
    TracedLines out(work.memory);
    base::List<LineSource> sources(work.memory);
    const Camera camera = camera_off_planes(scene, items);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        if (item.lines == nullptr) continue;
        work.update(static_cast<double>(i) / static_cast<double>(items.size()));
        const bool mirrored = glm::determinant(glm::dmat3(scene.camera.view * item.transform)) < 0.0;
        const auto first = static_cast<std::int32_t>(out.subjects.size());
        LineSource& source = sources.add(LineSource{
            item, view_of(camera, item), static_cast<std::int32_t>(out.items.size()), mirrored, first, first, first});
        out.occluders.push_back({&item.lines->sheets(), &item.lines->surface(), item.transform, source.view.eye});
        out.items.push_back(static_cast<std::int32_t>(i));
        trace_contours(work, source, last, out);
        add_contour_creases(work, source, out);
        add_border(work, source, out);
        source.draws_intersections =
            std::any_of(item.style.lines.begin(), item.style.lines.end(),
                        [](const LineStyle& style) { return style.kind == LineKind::intersection; });
    }
    trace_intersections(work, sources, last_intersections, out);
    for (const LineSource& source : sources) {
        const std::int64_t first = out.styles.size();
        for (const LineStyle& style : source.item.style.lines) {
            if (style.kind == LineKind::crease && source.lines().creases().count() == 0) continue;
            if (style.kind == LineKind::intersection && !source.has_intersections) continue;
            drawing::Layer layer;
            layer.item = out.items[source.number];
            layer.layer = -1;
            layer.mark_class =
                style.kind == LineKind::contour ? drawing::MarkClass::silhouette : drawing::MarkClass::front;
            layer.as_strokes = true;
            layer.ink = glm::vec4(style.ink[0], style.ink[1], style.ink[2], style.ink[3]);
            layer.line_kind = static_cast<std::uint32_t>(style.kind);
            if (style.name != nullptr)
                std::string_view(style.name).copy(layer.line_name.data(), layer.line_name.size() - 1);
            const auto number = static_cast<std::uint32_t>(drawing.layers.size());
            if (style.kind == LineKind::intersection)
                add_intersections(work, sources, source, style, number, out);
            else
                add_style(work, scene, source, style, number, out);
            drawing.layers.push_back(layer);
        }
        for (std::int64_t i = first; i < out.styles.size(); ++i) {
            DrawnSubject& as = out.styles[i];
            const curves::Thresholds by = curves::thresholds_of(as.style->kind, {as.style->lower, as.style->upper});
            as.lower = static_cast<float>(by.lower);
            as.upper = static_cast<float>(by.upper);
            as.halo = source.item.style.halo_width;
        }
    }
    return out;
}

// ---- Numbers

// How many points of a line in this frame are near a line of the last frame, approximately.
struct Vote {
    std::int64_t line;
    std::int64_t known;
    std::int64_t points;
};

const curves::CurvePoint& point_of(const base::Array<visibility::Subject>& subjects,
                                   const visibility::ImageLines& lines, std::int64_t piece) noexcept {
    const visibility::Piece& its = lines.pieces[piece];
    return subjects[its.subject].curves->point[its.a];
}

bool is_before(const LineFamily& a, const LineFamily& b) noexcept {
    if (a.set != b.set) return std::less<>()(a.set, b.set);
    return std::tie(a.item, a.number) < std::tie(b.item, b.number);
}

// Returns for each subject the first line of the last frame that has the subject's family, or -1. The lines of a family
// follow each other.
base::Array<std::int64_t> first_known_lines(const KnownLines& last, const base::Array<LineFamily>& families) {
    base::Array<std::int64_t> starts(families.memory()); // the first line of each family, sorted by the families
    for (std::int64_t k = 0; k < last.line.size(); ++k)
        if (k == 0 || !(last.line[k].family == last.line[k - 1].family)) starts.push_back(k);
    const auto family = [&](std::int64_t k) -> const LineFamily& { return last.line[k].family; };
    std::sort(starts.begin(), starts.end(),
              [&](std::int64_t a, std::int64_t b) { return is_before(family(a), family(b)); });
    base::Array<std::int64_t> first(families.memory());
    for (const LineFamily& wanted : families) {
        const std::int64_t* const at =
            std::lower_bound(starts.begin(), starts.end(), wanted,
                             [&](std::int64_t k, const LineFamily& f) { return is_before(family(k), f); });
        first.push_back(at != starts.end() && family(*at) == wanted ? *at : -1);
    }
    return first;
}

base::Array<Vote> count_votes(const KnownLines& last, const base::Array<LineFamily>& families,
                              const base::Array<visibility::Subject>& subjects, const visibility::ImageLines& lines) {
    base::Memory& memory = families.memory();
    base::Array<Vote> votes(memory);
    base::Array<std::int64_t> of_line(memory, last.line.size());
    const base::Array<std::int64_t> first_known = first_known_lines(last, families);
    std::int64_t end = 0; // the end of the lines of this subject
    for (std::int64_t subject = 0; subject < subjects.size(); ++subject) {
        const std::int64_t begin = end;
        while (end < lines.lines.size() && lines.lines[end].subject == subject) ++end;
        if (first_known[subject] < 0 || begin == end) continue;
        geometry::VecArray place(memory);
        geometry::VecArray direction(memory);
        base::Array<std::int64_t> owner(memory);
        std::int64_t k = first_known[subject];
        for (; k < last.line.size() && last.line[k].family == families[subject]; ++k) {
            const KnownLines::KnownLine& known = last.line[k];
            for (std::int64_t i = known.first; i < known.first + known.count; ++i) {
                place.push_back(last.place[i]);
                direction.push_back(last.direction[i]);
                owner.push_back(k);
            }
        }
        const double radius = line_tuning.farthest_numbered_move * subjects[subject].side;
        const geometry::PointGrid grid(place, radius);
        for (std::int64_t l = begin; l < end; ++l) {
            const visibility::Line& line = lines.lines[l];
            const std::int64_t step = std::max<std::int64_t>(1, line.pieces / line_tuning.most_points);
            for (std::int64_t p = 0; p < line.pieces; p += step) {
                const curves::CurvePoint& point = point_of(subjects, lines, line.first_piece + p);
                double least = radius;
                std::int64_t nearest = -1;
                grid.around(point.position, [&](std::int64_t at) {
                    const std::int64_t i = grid.index(at);
                    const double distance = glm::distance(place[i], point.position);
                    if (distance > least || !(glm::dot(direction[i], point.direction()) > 0.0)) return;
                    least = distance;
                    nearest = i;
                });
                if (nearest >= 0) ++of_line[owner[nearest]];
            }
            for (std::int64_t other = first_known[subject]; other < k; ++other)
                if (const std::int64_t points = std::exchange(of_line[other], 0); points > 0)
                    votes.push_back({l, other, points * step});
        }
    }
    HRBFNPR_ASSERT(end == lines.lines.size()); // The lines of a subject follow each other, in the subjects' order.
    return votes;
}

// Returns the numbers of the lines. A line that continues a line of the last frame keeps its number. Other lines get
// new numbers.
LineNumbers number_lines(base::Memory& memory, const base::Array<visibility::Subject>& subjects,
                         const base::Array<visibility::Occluder>& occluders, const visibility::ImageLines& lines,
                         KnownLines& last) {
    base::Array<LineFamily> families(memory);
    base::Array<std::int64_t> of_item(memory, occluders.size());
    for (const visibility::Subject& subject : subjects) {
        HRBFNPR_ASSERT(subject.item >= 0 && subject.item < of_item.size());
        families.push_back({occluders[subject.item].sheet_counter, subject.item, of_item[subject.item]++});
    }
    const auto position = [&](std::int64_t piece) { return point_of(subjects, lines, piece).position; };
    LineNumbers out(memory);
    out.number.resize(lines.lines.size());
    for (const visibility::Line& line : lines.lines) out.origin.push_back(line.first_piece);
    base::Array<Vote> votes = count_votes(last, families, subjects, lines);
    std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
        return std::tie(b.points, a.line, a.known) < std::tie(a.points, b.line, b.known);
    });
    base::Array<std::uint8_t> taken(memory, last.line.size());
    for (const Vote& vote : votes) {
        if (out.number[vote.line] != 0 || taken[vote.known] != 0) continue;
        const KnownLines::KnownLine& known = last.line[vote.known];
        out.number[vote.line] = known.number;
        taken[vote.known] = 1;
        std::int64_t& origin = out.origin[vote.line];
        const visibility::Line& line = lines.lines[vote.line];
        double least = glm::distance(position(origin), known.origin);
        for (std::int64_t p = line.first_piece + 1; p < line.first_piece + line.pieces; ++p)
            if (const double distance = glm::distance(position(p), known.origin); distance < least) {
                least = distance;
                origin = p;
            }
    }
    KnownLines next(memory);
    next.number = last.number;
    for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
        const visibility::Line& line = lines.lines[l];
        if (out.number[l] == 0) out.number[l] = ++next.number;
        const std::int64_t first = next.place.size();
        for (std::int64_t p = line.first_piece; p < line.first_piece + line.pieces; p += line_tuning.points_per_kept) {
            next.place.push_back(position(p));
            next.direction.push_back(point_of(subjects, lines, p).direction());
        }
        next.line.push_back(
            {families[line.subject], first, next.place.size() - first, out.number[l], position(out.origin[l])});
    }
    last = std::move(next);
    return out;
}

} // namespace

const LineStrokes& LineFrame::run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                                  drawing::Drawing& drawing) {
    strokes_.strokes.clear();
    strokes_.points.clear();
    if (std::none_of(items.begin(), items.end(), draws_lines)) return strokes_;
    const base::Stopwatch watch;
    const std::int64_t layers = drawing.layers.size();
    const auto trace = [&] {
        return trace_lines({runtime_, progress.part(0.0, traced_end)}, scene, items, contours_, intersections_,
                           drawing);
    };
    const auto count_sheets = [&](const TracedLines& lines) {
        return visibility::find_invisibility({runtime_, progress.part(traced_end, found_end).without_progress()},
                                             lines.subjects.span(), lines.occluders.span(), {});
    };
    TracedLines traced = trace();
    visibility::Invisibility found = count_sheets(traced);
    // Contours that were traced from those of the last frame may be too coarse, or doubled, even if none is broken.
    const auto is_from_last = [](const auto& contours) { return contours->from_last; };
    if (found.report.settled > 0 && std::any_of(traced.contours.begin(), traced.contours.end(), is_from_last)) {
        contours_.clear();
        intersections_ = std::move(traced.intersections);
        drawing.layers.resize(layers);
        traced = trace();
        found = count_sheets(traced);
    }
    visibility::find_hidden_by({runtime_, progress.part(found_end, hidden_end).without_progress()},
                               std::as_const(found.subjects).span(), traced.occluders.span(), found);
    add_counts(found, traced, drawing.line_counts);
    const visibility::LineLengths lengths(runtime_.memory, found.lines);
    const LineNumbers numbers = number_lines(runtime_.memory, found.subjects, traced.occluders, found.lines, known_);
    progress.update(hidden_end);
    const LineInput input{runtime_, scene, traced, found, lengths, numbers};
    add_strokes(input, drawing, progress.part(hidden_end, 1.0), strokes_);
    thin_lines_beside_others(input, drawing.layers.span(), strokes_);
    contours_ = std::move(traced.contours);
    intersections_ = std::move(traced.intersections);
    progress.update(1.0);
    drawing.line_counts.nanoseconds = watch.nanoseconds();
    return strokes_;
}

} // namespace hrbfnpr::frame
