// SPDX-License-Identifier: MIT
#include "frame/scene/still.h"

#include "frame/scene/even_places.h"
#include "frame/scene/ink.h"

#include <cmath>
#include <string_view>

namespace hrbfnpr::frame {
namespace {

// Returns whether a part of the surface may face the eye, or, if `back`, may face away.
[[nodiscard]] bool may_face(const ClusterView& at, bool back) noexcept {
    return back ? at.nu_max > 0.0F : at.nu_min < 0.0F;
}

} // namespace

base::Array<double> still_key(base::Memory& memory, const Still& still) {
    base::Array<double> key(memory);
    const auto add = [&](auto number) { key.push_back(static_cast<double>(number)); };
    for (const glm::dmat4& matrix : {still.camera.view, still.camera.projection, still.transform})
        for (int i = 0; i < 16; ++i) add(matrix[i / 4][i % 4]);
    for (int i = 0; i < 4; ++i) add(still.camera.viewport[i]);
    add(still.camera.depth);
    add(still.both_sides);
    const Style& style = still.style;
    for (int i = 0; i < 3; ++i) add(style.light[i]);
    add(style.tone);
    add(style.tone_rule);
    add(style.tone_curve);
    add(style.light_space);
    add(style.visibility);
    add(style.hidden_lines);
    add(style.tone_exponent);
    add(style.tone_fade);
    add(style.fill_light);
    add(style.light_intensity);
    add(style.light_shadow);
    add(style.light_softness);
    for (const LightStyle& light : style.lights) {
        add(light.kind);
        add(light.space);
        for (int i = 0; i < 3; ++i) add(light.place[i]);
        add(light.intensity);
        add(light.shadow);
        add(light.softness);
    }
    add(style.lights.size());
    add(style.ambient_sky);
    add(style.ambient_ground);
    for (int i = 0; i < 3; ++i) add(style.ambient_up[i]);
    add(style.occlusion);
    add(style.occlusion_exponent);
    add(style.occlusion_lights);
    add(static_cast<double>(style.evenness));
    add(style.rim_light);
    add(style.rim_exponent);
    add(style.tone_black);
    add(style.tone_white);
    add(style.tone_gamma);
    add(style.tone_steps);
    add(style.curvature_contrast);
    add(style.zoom_reference);
    add(style.zoom_exponent);
    for (const LayerStyle& layer : style.layers) {
        add(layer.kind);
        add(layer.shown);
        add(layer.contours);
        add(layer.shape);
        add(layer.share);
        add(layer.radius);
        add(layer.radius_zoom);
        add(layer.hatch_tone_begin);
        add(layer.hatch_fade);
        add(layer.tone_field != nullptr);
        for (const char letter : std::string_view(layer.name != nullptr ? layer.name : "")) add(letter);
        add(layer.name != nullptr); // Ends the name.
    }
    return key;
}

StillView::StillView(base::Memory& memory, const Still& still, const geometry::Bounds& bounds, double unit)
    : origin(bounds.centre() / unit) {
    marks::PointSet empty(memory);
    empty.bounds = bounds;
    empty.origin = bounds.centre();
    empty.unit = unit;
    Item shown;
    shown.set = &empty;
    shown.style = still.style;
    shown.both_sides = still.both_sides;
    shown.transform = still.transform;
    const SingleView single = see(shown, still.camera);
    lens = single.lens;
    item = single.item;
    frustum = frustum_of(lens);
    sight = sight_of(item, lens, frustum);
}

marks::Extent StillView::extent(const glm::dvec3& place, const glm::dvec3& normal, double reach,
                                bool for_tone) const noexcept {
    marks::Extent extent;
    const glm::vec3 centre(place - origin);
    const glm::vec3 axis(normal);
    extent.radius = static_cast<float>(reach);
    extent.centre = {centre.x, centre.y, centre.z};
    const float angle = for_tone ? scene_tuning.still_tone_cone : scene_tuning.still_surface_cone;
    extent.cone = {{axis.x, axis.y, axis.z}, std::cos(angle), std::sin(angle)};
    return extent;
}

ClusterView StillView::view(const glm::dvec3& place, const glm::dvec3& normal, double reach,
                            bool for_tone) const noexcept {
    return view_cluster(extent(place, normal, reach, for_tone), sight, lens, frustum);
}

// Splats that face away hide other ink only if hidden ink is drawn faintly. Otherwise the surface before them hides
// all.
bool StillNeed::needs_other_side() const noexcept {
    return view_.item.both_sides || (layer_.may_be_splats && view_.item.style.hidden_lines == HiddenLines::attenuate);
}

bool StillNeed::may_show(const glm::dvec3& place, const glm::dvec3& normal, double reach) const noexcept {
    const ClusterView at = view_.view(place, normal, reach, false);
    if (at.beyond > scene_tuning.still_margin * view_.lens.diagonal) return false;
    return may_face(at, false) || needs_other_side();
}

double StillNeed::share(const glm::dvec3& place, const glm::dvec3& normal, double spacing) const noexcept {
    const marks::Extent extent = view_.extent(place, normal, spacing, true);
    const ClusterView at = view_cluster(extent, view_.sight, view_.lens, view_.frustum);
    if (at.beyond > scene_tuning.still_margin * view_.lens.diagonal) return 0.0;
    if (!may_face(at, false) && !needs_other_side()) return 0.0;
    const float splats = layer_.may_be_splats ? share_of_splats(at, static_cast<float>(spacing)) : 0.0F;
    const bool has_ink = layer_.style->shown && (may_face(at, false) || view_.item.both_sides);
    const float ink = has_ink ? share_of_ink(extent, at, static_cast<float>(spacing)) : 0.0F;
    return static_cast<double>(std::clamp(std::max(splats, ink), 0.0F, 1.0F));
}

// The first marks of an order are splats, until they have the distance that splats need.
float StillNeed::share_of_splats(const ClusterView& at, float spacing) const noexcept {
    if (layer_.kind != marks::Kind::stipples || view_.item.style.hidden_lines == HiddenLines::show) return 1.0F;
    const bool is_near_contour = at.nu_min < scene_tuning.still_rim_nu && at.nu_max > -scene_tuning.still_rim_nu;
    const float least = is_near_contour ? scene_tuning.contour_splat_spacing : scene_tuning.splat_spacing;
    const float pixels = spacing * view_.sight.scale * at.pixels_per_unit / least;
    return pixels * pixels;
}

// Returns an upper bound for the share of the marks that the tone shows.
float StillNeed::share_of_ink(const marks::Extent& extent, const ClusterView& at, float spacing) const noexcept {
    const Style& style = view_.item.style;
    if (style.tone == Tone::callback || style.tone_rule == ToneRule::published) return 1.0F;
    const bool shows_back = view_.item.both_sides && may_face(at, true);
    // Occlusion, shadows and curvature are not known before there are marks.
    constexpr SeenShares nothing{0.0F, {}, -1.0F};
    // Neither are the values of a field.
    const bool is_bounded = style.tone == Tone::light && !shows_back && layer_.style->tone_field == nullptr;
    const float darkness = 1.0F - (is_bounded ? least_tau(extent, view_.sight, nothing) : 0.0F);
    if (layer_.kind != marks::Kind::stipples)
        return layer_.style->shape == Shape::hatch && darkness < layer_.style->hatch_least() ? 0.0F : 1.0F;
    float shown = darkness;
    if (style.tone_curve == ToneCurve::coverage) {
        if (!layer_.makes_tone_alone) return 1.0F;
        DiscSizes discs;
        discs.style = &style;
        discs.layer = layer_.style;
        if (style.zoom_reference > 0.0)
            discs.zoom_at_one =
                static_cast<float>(static_cast<double>(view_.lens.eye_per_world) / style.zoom_reference);
        const float pixels = spacing * view_.sight.scale * at.pixels_per_unit;
        const float full = layer_.style->share * disc_ink(discs.front_ink(at.pixels_per_unit)) / (pixels * pixels);
        const float darkest = ink_for(scene_tuning.darkest, Overlap::blue_noise, 0.0F);
        const bool turns = at.nu_min < 0.0F && at.nu_max > 0.0F;
        const float least = turns ? 0.0F : std::min(std::abs(at.nu_min), std::abs(at.nu_max));
        const float most = std::max(-at.nu_min, view_.item.both_sides ? at.nu_max : 0.0F);
        const bool in_picture = style.evenness == Evenness::picture;
        const float facing = in_picture ? most_shown(std::min(least, 1.0F), std::clamp(most, least, 1.0F)) : most;
        shown = ink_for(darkness, Overlap::blue_noise, 0.0F) * facing / std::max(full, darkest);
    }
    // Marks that fade in are small, so more of them are shown.
    return scene_tuning.still_surplus * layer_.style->share * shown / (1.0F - 0.5F * style.tone_fade);
}

} // namespace hrbfnpr::frame
