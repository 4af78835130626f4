// SPDX-License-Identifier: MIT
#include "frame/lines/traced_lines.h"

#include "frame/lines/off_planes.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

namespace hrbfnpr::frame {
namespace {

// In sides of the mesh: lines of the caller's may lie somewhat inside the surface.
constexpr double clear_of_own = 1.0;
// In diagonals: shorter ones are noise.
constexpr double shortest_feature = 0.01;

// From farther away lines of sight are parallel to all digits that contours are found to.
constexpr double parallel_from = 1e9; // diagonals

// w = 0: the direction in which it looks.
glm::dvec4 finite_eye(const glm::dvec4& eye, const geometry::Bounds& region) noexcept {
    const glm::dvec3 place = glm::dvec3(eye) / eye.w;
    const glm::dvec3 middle = 0.5 * (region.min + region.max);
    const double largest =
        std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}); // whose squares may not be
    if (largest <= parallel_from * glm::distance(region.min, region.max)) return {place, 1.0};
    return {glm::normalize(middle / largest - place / largest), 0.0};
}

curves::View view_of(const Camera& camera, const Item& item) {
    const Optics optics = make_optics(camera);
    const glm::dmat4 to_eye = camera.view * item.transform;
    const glm::dvec4 eye = glm::inverse(to_eye) * optics.centre;
    return {eye.w != 0.0 ? finite_eye(eye, item.lines->mesh().region) : eye, optics.window * to_eye};
}

bool is_mirrored(const Scene& scene, const Item& item) {
    return glm::determinant(glm::dmat3(scene.camera.view * item.transform)) < 0.0;
}

// To the eye, as features want it.
glm::dvec4 towards_eye(const curves::View& view) noexcept {
    return view.eye.w == 0.0 ? glm::dvec4(-glm::dvec3(view.eye), 0.0) : view.eye;
}

// The light of a style, in the item's own space.
glm::dvec4 towards_light(const Scene& scene, const Item& item) {
    const glm::dmat3 to_space = item.style.light_space == LightSpace::camera
                                    ? glm::dmat3(scene.camera.view * item.transform)
                                    : glm::dmat3(item.transform);
    // Normals go by the inverse transpose, so that n . l is that of the space.
    return {glm::normalize(glm::inverse(to_space) * item.style.light), 0.0};
}

} // namespace

TracedLines::TracedLines(const base::Runtime& runtime, const Scene& scene, std::span<const Item> items,
                         LastContours& last, const base::Progress& progress, drawing::Drawing& drawing)
    : runtime_(runtime), last_(last), progress_(progress), sources_(runtime.memory), levels_(runtime.memory),
      lines_(runtime.memory), subjects_(runtime.memory), occluders_(runtime.memory), items_(runtime.memory),
      styles_(runtime.memory), creases_(runtime.memory), strengths_(runtime.memory), contours_of_(runtime.memory),
      folds_of_(runtime.memory), borders_of_(runtime.memory) {
    const Camera camera = camera_off_planes(scene, items);
    for (const Item& item : items) {
        if (item.lines == nullptr) continue;
        progress_.update(static_cast<double>(&item - items.data()) / static_cast<double>(items.size()));
        const Source source{&item, view_of(camera, item), static_cast<std::int32_t>(occluders_.size()),
                            is_mirrored(scene, item)};
        occluders_.push_back({&item.lines->sheets(), &item.lines->surface(), item.transform, source.view.eye});
        items_.push_back(static_cast<std::int32_t>(&item - items.data()));
        sources_.push_back(source);
        trace_contours(source);
        add_creases(source);
        add_border(source);
    }
    for (const Source& source : sources_) {
        light_ = towards_light(scene, *source.item);
        const std::int64_t first = styles_.size();
        for (const LineStyle& style : source.item->style.lines) {
            if (style.kind == LineKind::crease && source.item->lines->creases().count() == 0) continue;
            drawing::Layer layer;
            layer.item = static_cast<std::int32_t>(source.item - items.data());
            layer.layer = -1;
            layer.mark_class =
                style.kind == LineKind::contour ? drawing::MarkClass::silhouette : drawing::MarkClass::front;
            layer.as_strokes = true;
            layer.ink = glm::vec4(style.ink[0], style.ink[1], style.ink[2], style.ink[3]);
            layer.line_kind = static_cast<std::uint32_t>(style.kind);
            if (style.name != nullptr)
                std::string_view(style.name).copy(layer.line_name.data(), layer.line_name.size() - 1);
            add_style(source, style, static_cast<std::uint32_t>(drawing.layers.size()));
            drawing.layers.push_back(layer);
        }
        for (std::int64_t i = first; i < styles_.size(); ++i) styles_[i].halo = source.item->style.halo_width;
    }
}

visibility::Subject& TracedLines::add_subject(const Source& source, const curves::Curves& curves) {
    visibility::Subject subject;
    subject.curves = &curves;
    subject.view = source.view;
    subject.side = source.item->lines->mesh().side;
    subject.to_world = source.item->transform;
    subject.item = source.number;
    subject.mirrored = source.mirrored;
    subjects_.push_back(subject);
    return subjects_[subjects_.size() - 1];
}

void TracedLines::trace_contours(const Source& source) {
    const curves::LineSet& lines = *source.item->lines;
    const auto first = static_cast<std::int32_t>(subjects_.size());
    if (lines.parts().empty()) trace_part(source, lines.surface(), 0);
    for (std::int64_t p = 0; p < lines.parts().size(); ++p) trace_part(source, lines.parts()[p]->surface, p);
    contours_of_.push_back({first, static_cast<std::int32_t>(subjects_.size())});
}

// Contours of a sheet end at its creases.
void TracedLines::trace_part(const Source& source, const implicit::Implicit& surface, std::int64_t part) {
    const curves::LineSet& lines = *source.item->lines;
    const curves::ContourLevel& level = *levels_.add(std::make_unique<curves::ContourLevel>(surface, source.view));
    const Contours& contours =
        last_.find(runtime_, lines, items_[source.number], part, level, source.view, progress_.standing());
    broken_ += contours.broken;
    visibility::Subject& subject = add_subject(source, contours.with_cusps);
    subject.level = &level;
    subject.joined = !lines.parts().empty();
}

// Whatever is drawn: the surface turns over at those of which one sheet faces the eye.
void TracedLines::add_creases(const Source& source) {
    const curves::LineSet& lines = *source.item->lines;
    auto& parts = creases_.add(std::make_unique<curves::CreaseParts>(runtime_.memory));
    folds_of_.push_back(-1);
    if (lines.creases().count() == 0) return;
    *parts = curves::parts_in_view(runtime_, *lines.surface().sheets(), lines.creases(), source.view);
    if (parts->folds.curves.count() == 0) return;
    folds_of_[source.number] = static_cast<std::int32_t>(subjects_.size());
    visibility::Subject& subject = add_subject(source, parts->folds.curves);
    subject.joined = true;
    subject.clear = visibility::clear_of_creases;
    contours_of_[source.number].end = static_cast<std::int32_t>(subjects_.size());
}

// Whatever is drawn: what lies behind it depends on where the surface ends.
void TracedLines::add_border(const Source& source) {
    const auto first = static_cast<std::int32_t>(subjects_.size());
    const curves::LineSet& lines = *source.item->lines;
    borders_of_.push_back(first);
    add_lines(source, curves::with_turns(runtime_, lines.border(), lines.surface(), source.view), nullptr, 0, 1);
    for (std::int64_t s = first; s < subjects_.size(); ++s) subjects_[s].level = lines.border_level();
}

void TracedLines::add_lines(const Source& source, const curves::SurfaceLines& lines, const LineStyle* style,
                            std::uint32_t layer, std::int32_t sheets) {
    if (lines.curves.count() == 0) return;
    for (const bool outside : {true, false}) {
        // What shows its inside is behind its own surface, unless that is open.
        if (!outside && sheets == 0 && style->hidden == HiddenParts::none &&
            source.item->lines->border().curves.count() == 0)
            continue;
        const curves::SurfaceLines& parts = *lines_.add(
            std::make_unique<curves::SurfaceLines>(curves::facing_parts(runtime_.memory, lines, source.view, outside)));
        visibility::Subject& subject = add_subject(source, parts.curves);
        subject.sheets = sheets;
        const auto number = static_cast<std::int32_t>(subjects_.size() - 1);
        if (style == nullptr) continue;
        if (style->kind == LineKind::own) subject.clear = clear_of_own;
        subject.joined = style->kind == LineKind::section && source.item->lines->creases().count() > 0;
        const curves::Thresholds by = curves::thresholds_of(style->kind, {style->lower, style->upper});
        styles_.push_back(
            {style, number, layer, parts.strength.data(), static_cast<float>(by.lower), static_cast<float>(by.upper)});
    }
}

void TracedLines::add_style(const Source& source, const LineStyle& style, std::uint32_t layer) {
    switch (style.kind) {
    case LineKind::contour:
        for (std::int32_t s = contours_of_[source.number].begin; s < contours_of_[source.number].end; ++s)
            styles_.push_back({&style, s, layer});
        break;
    case LineKind::crease: add_bent(source, style, layer); break;
    case LineKind::border:
        for (std::int32_t s = borders_of_[source.number]; s < subjects_.size(); ++s)
            if (subjects_[s].item == source.number && subjects_[s].sheets == 1) styles_.push_back({&style, s, layer});
        break;
    case LineKind::suggestive_contour:
    case LineKind::apparent_ridge:
    case LineKind::isophote: add_features(source, style, layer); break;
    default: add_found(source, style, layer);
    }
}

void TracedLines::add_found(const Source& source, const LineStyle& style, std::uint32_t layer) {
    for (const curves::FoundLines& found : source.item->lines->found())
        if (found.kind == style.kind && (style.name == nullptr || std::strcmp(style.name, found.name.data()) == 0))
            add_lines(source, found.lines, &style, layer, 0);
}

// Creases that are no contours; these as well where the style draws no contours.
void TracedLines::add_bent(const Source& source, const LineStyle& style, std::uint32_t layer) {
    const curves::CreaseParts& parts = *creases_[source.number];
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    for (const curves::SurfaceLines* some : {&parts.outside, &parts.inside}) {
        if (some == &parts.inside && style.hidden == HiddenParts::none &&
            source.item->lines->border().curves.count() == 0)
            continue;
        const curves::SurfaceLines& lines = *lines_.add(std::make_unique<curves::SurfaceLines>(
            curves::bent_parts(runtime_.memory, *some, some == &parts.inside ? parts.of_inside : parts.of_outside,
                               style.creases, by.lower, by.upper)));
        if (lines.curves.count() == 0) continue;
        visibility::Subject& subject = add_subject(source, lines.curves);
        subject.sheets = 0;
        subject.joined = true;
        subject.clear = visibility::clear_of_creases;
        styles_.push_back({&style, static_cast<std::int32_t>(subjects_.size() - 1), layer, lines.strength.data(),
                           static_cast<float>(by.lower), static_cast<float>(by.upper)});
    }
    const std::span<const LineStyle> all = source.item->style.lines;
    const bool outlined =
        std::any_of(all.begin(), all.end(), [](const LineStyle& other) { return other.kind == LineKind::contour; });
    if (outlined || folds_of_[source.number] < 0) return;
    base::Array<float>& strength = strengths_.add(runtime_.memory);
    for (const float angle : parts.folds.strength) strength.push_back(curves::angle_on(style.creases, angle));
    styles_.push_back({&style, folds_of_[source.number], layer, strength.data(), static_cast<float>(by.lower),
                       static_cast<float>(by.upper)});
    styles_[styles_.size() - 1].cut = true;
}

// By interpolation on the mesh: enough to draw.
void TracedLines::add_features(const Source& source, const LineStyle& style, std::uint32_t layer) {
    curves::FeatureRequest request;
    request.kind = curves::feature_of(style.kind);
    request.towards = style.kind == LineKind::isophote ? light_ : towards_eye(source.view);
    request.levels = style.levels;
    const curves::Thresholds by = curves::thresholds_of(style.kind, {style.lower, style.upper});
    request.lower = by.lower;
    request.upper = by.upper;
    request.shortest = shortest_feature;
    request.rounds = style.kind == LineKind::apparent_ridge ? 2 : 0;
    const curves::FeatureLines lines =
        find_feature_lines(runtime_, source.item->lines->features(), request, progress_.standing());
    add_lines(source, curves::as_lines(runtime_.memory, lines), &style, layer, 0);
}

} // namespace hrbfnpr::frame
