// SPDX-License-Identifier: MIT
// For each item with lines: its contours (trace_contours, from the last frame's where the camera moved little), creases
// that are contours (add_folds) and its border (add_border) become subjects whatever is drawn, as they hide others.
// Then for each style of lines its subjects are found or made (add_style), and get a layer. All of this is seen through
// a camera that sees no face exactly edge-on (camera_off_planes).
#include "base/assert.h"
#include "curves/curve_changes.h"
#include "curves/trace.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// An item that has lines, and its subjects: from `contours` on its contours and, at `folds`, creases that are such,
// then from `border` to `end` its border.
struct Source {
    const Item& item;
    curves::View view;
    std::int32_t number; // among the occluders
    bool mirrored;
    std::int32_t contours, border, end;
    std::int32_t folds = -1; // -1: the item has no such creases
    const curves::CreaseParts* creases = nullptr;

    [[nodiscard]] const curves::LineSet& lines() const noexcept { return *item.lines; }
    [[nodiscard]] bool is_open() const noexcept { return lines().border().curves.count() > 0; }
};

// ---- The camera

// The camera for all lines of a scene. A face that is seen exactly edge-on does not tell on which side of its edges it
// lies, so where an item has creases the eye moves a little to one side, and an orthographic camera becomes one at a
// large finite distance: faces parallel to its axis turn away a little.
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
    // x and y by (z - middle) to one side; w grows with it, so that an orthographic camera is a finite one.
    glm::dmat4 moved(1.0);
    const double shift = line_tuning.off_planes;
    const glm::dvec2 to_side =
        line_tuning.aside * shift * glm::dvec2(std::cos(line_tuning.aside_angle), std::sin(line_tuning.aside_angle));
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
    glm::dvec4 eye = glm::inverse(to_eye) * optics.centre;
    if (eye.w != 0.0) {
        const glm::dvec3 place = glm::dvec3(eye) / eye.w;
        const geometry::Bounds& region = item.lines->mesh().region;
        const glm::dvec3 size = glm::abs(place); // whose squares may be no numbers
        const double largest = std::max({size.x, size.y, size.z});
        const bool is_far = !(largest <= line_tuning.parallel_from * glm::distance(region.min, region.max));
        eye = is_far ? glm::dvec4(glm::normalize(0.5 * (region.min + region.max) / largest - place / largest), 0.0)
                     : glm::dvec4(place, 1.0);
    }
    return {eye, optics.window * to_eye};
}

// ---- Subjects

visibility::Subject& add_subject(const Source& source, const curves::Curves& curves, TracedLines& out) {
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

// The contours of an item, or of a part of it, in this view. Seen from where the last frame saw them, they are the
// same.
std::unique_ptr<Contours> find_contours(const base::Runtime& runtime, const curves::LineSet& lines, std::int64_t item,
                                        std::int64_t part, const curves::ContourLevel& level, ContourList& all_last,
                                        const base::Progress& progress) {
    const curves::View& view = level.view();
    HRBFNPR_ASSERT(part >= 0 && (part == 0 || part < lines.parts().size()));
    std::unique_ptr<Contours> last;
    for (std::unique_ptr<Contours>& known : all_last)
        if (last == nullptr && known != nullptr && known->item == item && known->part == part &&
            known->set == lines.identity())
            last = std::move(known);
    if (last != nullptr && last->eye == view.eye) return last;
    const curves::SurfaceMesh& mesh = lines.parts().empty() ? lines.mesh() : lines.parts()[part]->mesh;
    auto contours = std::make_unique<Contours>(runtime.memory);
    contours->set = lines.identity();
    contours->item = item;
    contours->part = part;
    contours->eye = view.eye;
    const auto trace = [&](const curves::Curves* near) {
        curves::TraceReport report;
        curves::TraceSettings settings;
        if (near != nullptr) settings.tolerance = line_tuning.moved_tolerance;
        contours->traced = curves::trace(runtime, level, mesh, settings, report, progress, near);
        contours->from_last = near != nullptr;
        contours->broken = report.broken + report.missed;
    };
    // Tracing begins with the last contours if nearly all of their points go on.
    if (last != nullptr) {
        const curves::Curves moved =
            curves::moved_contours(runtime.memory, view, last->traced, line_tuning.farthest_move * mesh.side);
        const double least = (1.0 - line_tuning.most_left_out) * static_cast<double>(last->traced.point.size());
        if (!moved.point.empty() && static_cast<double>(moved.point.size()) >= least) trace(&moved);
    }
    if (!contours->from_last || contours->broken > 0) trace(nullptr);
    std::int64_t evaluations = 0;
    contours->with_cusps = curves::with_cusps(runtime, level, view, contours->traced, evaluations, progress);
    return contours;
}

// Contours of a sheet end at its creases.
void trace_contours(const base::Runtime& runtime, const Source& source, ContourList& last,
                    const base::Progress& progress, TracedLines& out) {
    const curves::LineSet& lines = source.lines();
    for (std::int64_t p = 0; p < std::max<std::int64_t>(1, lines.parts().size()); ++p) {
        const implicit::Implicit& surface = lines.parts().empty() ? lines.surface() : lines.parts()[p]->surface;
        const curves::ContourLevel& level =
            *out.levels.add(std::make_unique<curves::ContourLevel>(surface, source.view));
        const Contours& contours = *out.contours.add(
            find_contours(runtime, lines, out.items[source.number], p, level, last, progress.standing()));
        out.broken += contours.broken;
        visibility::Subject& subject = add_subject(source, contours.with_cusps, out);
        subject.level = &level;
        subject.joined = !lines.parts().empty();
    }
}

// The surface turns over at creases of which one sheet faces the eye.
void add_folds(const base::Runtime& runtime, Source& source, TracedLines& out) {
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
    subject.clear = visibility::visibility_tuning.clear_of_creases;
}

// Adds lines on the surface, cut where they turn away from the eye. `sheets` is Subject::sheets.
void add_lines(const base::Runtime& runtime, const Source& source, const curves::SurfaceLines& lines,
               const LineStyle* style, std::uint32_t layer, std::int32_t sheets, TracedLines& out) {
    HRBFNPR_ASSERT(style != nullptr || sheets > 0);
    if (lines.curves.count() == 0) return;
    for (const bool outside : {true, false}) {
        // Lines that show the inside are hidden by their own surface, unless that is open.
        if (!outside && sheets == 0 && style->hidden == HiddenParts::none && !source.is_open()) continue;
        const curves::SurfaceLines& parts = *out.lines.add(
            std::make_unique<curves::SurfaceLines>(curves::facing_parts(runtime.memory, lines, source.view, outside)));
        const auto number = static_cast<std::int32_t>(out.subjects.size());
        visibility::Subject& subject = add_subject(source, parts.curves, out);
        subject.sheets = sheets;
        if (style == nullptr) continue;
        if (style->kind == LineKind::own) subject.clear = line_tuning.clear_of_own;
        subject.joined = style->kind == LineKind::section && source.lines().creases().count() > 0;
        const curves::Thresholds by = curves::thresholds_of(style->kind, {style->lower, style->upper});
        out.styles.push_back(
            {style, number, layer, parts.strength.data(), static_cast<float>(by.lower), static_cast<float>(by.upper)});
    }
}

// A surface hides other things only up to its border, so the border is needed even where it is not drawn.
void add_border(const base::Runtime& runtime, Source& source, TracedLines& out) {
    const curves::LineSet& lines = source.lines();
    source.border = static_cast<std::int32_t>(out.subjects.size());
    add_lines(runtime, source, curves::with_turns(runtime, lines.border(), lines.surface(), source.view), nullptr, 0, 1,
              out);
    source.end = static_cast<std::int32_t>(out.subjects.size());
    for (std::int32_t s = source.border; s < source.end; ++s) out.subjects[s].level = lines.border_level();
}

// Adds creases that are no contours; these as well where the style draws no contours.
void add_bent(const base::Runtime& runtime, const Source& source, const LineStyle& style, std::uint32_t layer,
              TracedLines& out) {
    HRBFNPR_ASSERT(source.creases != nullptr);
    const curves::CreaseParts& parts = *source.creases;
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    const auto add = [&](std::int32_t subject, const base::Array<float>& strength, bool cut) {
        out.styles.push_back({&style, subject, layer, strength.data(), static_cast<float>(by.lower),
                              static_cast<float>(by.upper), 0.0F, cut});
    };
    for (const bool outside : {true, false}) {
        if (!outside && style.hidden == HiddenParts::none && !source.is_open()) continue;
        const curves::SurfaceLines& lines = *out.lines.add(std::make_unique<curves::SurfaceLines>(
            curves::bent_parts(runtime.memory, outside ? parts.outside : parts.inside,
                               outside ? parts.of_outside : parts.of_inside, style.creases, by.lower, by.upper)));
        if (lines.curves.count() == 0) continue;
        visibility::Subject& subject = add_subject(source, lines.curves, out);
        subject.sheets = 0;
        subject.joined = true;
        subject.clear = visibility::visibility_tuning.clear_of_creases;
        add(static_cast<std::int32_t>(out.subjects.size() - 1), lines.strength, false);
    }
    const std::span<const LineStyle> all = source.item.style.lines;
    const bool outlined =
        std::any_of(all.begin(), all.end(), [](const LineStyle& other) { return other.kind == LineKind::contour; });
    if (outlined || source.folds < 0) return;
    base::Array<float>& strength = out.numbers.add(runtime.memory);
    for (const float angle : parts.folds.strength) strength.push_back(curves::angle_on(style.creases, angle));
    add(source.folds, strength, true);
}

// Adds feature lines by interpolation on the mesh, which is enough to draw. towards: the eye, or the light of
// isophotes.
void add_features(const base::Runtime& runtime, const Source& source, const LineStyle& style, std::uint32_t layer,
                  const glm::dvec4& towards, const base::Progress& progress, TracedLines& out) {
    curves::FeatureRequest request;
    request.kind = curves::feature_of(style.kind);
    request.towards = towards;
    request.levels = style.levels;
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    request.lower = by.lower;
    request.upper = by.upper;
    request.shortest = line_tuning.shortest_feature;
    request.rounds = style.kind == LineKind::apparent_ridge ? line_tuning.ridge_rounds : 0;
    const curves::FeatureLines lines =
        find_feature_lines(runtime, source.lines().features(), request, progress.standing());
    add_lines(runtime, source, curves::as_lines(runtime.memory, lines), &style, layer, 0, out);
}

void add_style(const base::Runtime& runtime, const Scene& scene, const Source& source, const LineStyle& style,
               std::uint32_t layer, const base::Progress& progress, TracedLines& out) {
    const Item& item = source.item;
    switch (style.kind) {
    case LineKind::contour:
        for (std::int32_t s = source.contours; s < source.border; ++s) out.styles.push_back({&style, s, layer});
        break;
    case LineKind::crease: add_bent(runtime, source, style, layer, out); break;
    case LineKind::border:
        for (std::int32_t s = source.border; s < source.end; ++s) out.styles.push_back({&style, s, layer});
        break;
    case LineKind::suggestive_contour:
    case LineKind::apparent_ridge: {
        const glm::dvec4& eye = source.view.eye;
        const glm::dvec4 towards = eye.w == 0.0 ? glm::dvec4(-glm::dvec3(eye), 0.0) : eye;
        add_features(runtime, source, style, layer, towards, progress, out);
        break;
    }
    case LineKind::isophote: {
        // Normals go by the inverse transpose, so that n . l is that of the light's space.
        const glm::dmat3 to_space = item.style.light_space == LightSpace::camera
                                        ? glm::dmat3(scene.camera.view * item.transform)
                                        : glm::dmat3(item.transform);
        const glm::dvec4 light(glm::normalize(glm::inverse(to_space) * item.style.light), 0.0);
        add_features(runtime, source, style, layer, light, progress, out);
        break;
    }
    default:
        for (const curves::FoundLines& found : source.lines().found())
            if (found.kind == style.kind && (style.name == nullptr || std::strcmp(style.name, found.name.data()) == 0))
                add_lines(runtime, source, found.lines, &style, layer, 0, out);
    }
}

} // namespace

TracedLines trace_lines(const base::Runtime& runtime, const Scene& scene, std::span<const Item> items,
                        ContourList& last, const base::Progress& progress, drawing::Drawing& drawing) {
    TracedLines out(runtime.memory);
    base::List<Source> sources(runtime.memory);
    const Camera camera = camera_off_planes(scene, items);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        if (item.lines == nullptr) continue;
        progress.update(static_cast<double>(i) / static_cast<double>(items.size()));
        const bool mirrored = glm::determinant(glm::dmat3(scene.camera.view * item.transform)) < 0.0;
        const auto first = static_cast<std::int32_t>(out.subjects.size());
        Source& source = sources.add(Source{item, view_of(camera, item), static_cast<std::int32_t>(out.items.size()),
                                            mirrored, first, first, first});
        out.occluders.push_back({&item.lines->sheets(), &item.lines->surface(), item.transform, source.view.eye});
        out.items.push_back(static_cast<std::int32_t>(i));
        trace_contours(runtime, source, last, progress, out);
        add_folds(runtime, source, out);
        add_border(runtime, source, out);
    }
    for (const Source& source : sources) {
        const std::int64_t first = out.styles.size();
        for (const LineStyle& style : source.item.style.lines) {
            if (style.kind == LineKind::crease && source.lines().creases().count() == 0) continue;
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
            add_style(runtime, scene, source, style, static_cast<std::uint32_t>(drawing.layers.size()), progress, out);
            drawing.layers.push_back(layer);
        }
        for (std::int64_t i = first; i < out.styles.size(); ++i) out.styles[i].halo = source.item.style.halo_width;
    }
    return out;
}

} // namespace hrbfnpr::frame
