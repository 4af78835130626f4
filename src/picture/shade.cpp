// SPDX-License-Identifier: MIT
#include "picture/shade.h"

#include "picture/make.h"
#include "picture/report.h"
#include "picture/tuning_plan.h"

#include <algorithm>

namespace hrbfnpr::picture {

namespace {

// Calls visit(shadow, space) for each light of a style. Returns whether a call returned true.
template <class Visit>
bool any_light(const Style& style, Visit&& visit) noexcept {
    if (style.lights.empty()) return visit(style.base.light_shadow, style.base.light_space);
    return std::any_of(style.lights.begin(), style.lights.end(),
                       [&](const hrbfnpr_light& light) { return visit(light.shadow, light.space); });
}

bool is_shadow_line(const hrbfnpr_line_style& line) noexcept {
    return line.kind == HRBFNPR_LINE_KIND_SHADOW || line.kind == HRBFNPR_LINE_KIND_TERMINATOR;
}

bool draws_shadow_lines(const hrbfnpr_item& item) noexcept {
    const hrbfnpr_style& style = *item.style;
    return item.line_set != nullptr && std::any_of(style.lines, style.lines + style.line_count, is_shadow_line);
}

} // namespace

bool needs_occlusion(const hrbfnpr_style& style) noexcept {
    const bool has_ambient_light = style.ambient_sky > 0.0F || style.ambient_ground > 0.0F;
    return style.occlusion_lights > 0.0F || (style.occlusion > 0.0F && has_ambient_light);
}

bool needs_cast_shadows(const Style& style) noexcept {
    return any_light(style, [](float shadow, std::uint32_t) { return shadow > 0.0F; });
}

bool draws_shadow_lines(const Style& style) noexcept {
    return std::any_of(style.lines.begin(), style.lines.end(), is_shadow_line);
}

bool needs_shading(const Style& style) noexcept {
    const hrbfnpr_style& base = style.base;
    if (base.visibility == HRBFNPR_VISIBILITY_PUBLISHED) return false;
    const bool has_shadows = needs_cast_shadows(style);
    if (has_shadows && draws_shadow_lines(style)) return true;
    return base.tone == HRBFNPR_TONE_LIGHT && (needs_occlusion(base) || base.curvature_contrast > 0.0F || has_shadows);
}

bool shadows_follow_camera(const Style& style) noexcept {
    return any_light(style,
                     [](float shadow, std::uint32_t space) { return shadow > 0.0F && space == HRBFNPR_LIGHT_CAMERA; });
}

Occluders make_occluders(const Call& call, std::span<const hrbfnpr_item> items) {
    if (std::none_of(items.begin(), items.end(), [](const hrbfnpr_item& item) { return item.line_set != nullptr; }))
        return {};
    return make<Occluders>([&](hrbfnpr_occluders** made, hrbfnpr_error* error) {
        return hrbfnpr_occluders_create(&call.context, items.data(), static_cast<std::int64_t>(items.size()),
                                        sizeof(hrbfnpr_item), nullptr, made, error);
    });
}

Vector<Shading> make_shadings(const Call& call, const Occluders& occluders, std::span<const hrbfnpr_item> items,
                              const hrbfnpr_camera& camera, const Vector<Shading>& previous) {
    Vector<Shading> shadings(&call.pool);
    Stage stage(call.report, HRBFNPR_STAGE_SHADE);
    for (std::size_t i = 0; i < items.size(); ++i) {
        auto desc = defaults<hrbfnpr_shading_desc>(hrbfnpr_shading_desc_init);
        desc.sky_rays = plan_tuning.sky_rays;
        if (!needs_occlusion(*items[i].style)) desc.occlusion_reach = 0.0;
        if (items[i].line_set == nullptr) desc.curvature_scale = 0.0;
        call.options.changes.apply("shading", desc);
        if (draws_shadow_lines(items[i])) desc.flags |= HRBFNPR_SHADING_WITH_LINES;
        if (!previous.empty()) desc.previous = previous[i].get();
        shadings.push_back(make<Shading>([&](hrbfnpr_shading** made, hrbfnpr_error* error) {
            return hrbfnpr_shading_create(&call.context, occluders.get(), &items[i], &camera, &desc, stage.operation(),
                                          made, error);
        }));
    }
    return shadings;
}

} // namespace hrbfnpr::picture
