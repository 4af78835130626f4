// SPDX-License-Identifier: MIT
#include "api/style.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/lists.h"
#include "api/style_fields.h"
#include "api/views.h"

#include <cstdio>

using namespace hrbfnpr;

namespace hrbfnpr::api {
namespace {

using GivenLayer = hrbfnpr_layer_style;
using Style = hrbfnpr_style;
using LineStyle = hrbfnpr_line_style;

constexpr std::int64_t most_layer_styles = 65536;

[[nodiscard]] bool is_zero(const double (&v)[3]) noexcept { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }

void check_between_fields(const Style& style, const char* owner) {
    if (style.tone == HRBFNPR_TONE_LIGHT && style.light_count == 0 && is_zero(style.light))
        fail(Status::invalid_argument, "%s.light is zero; give it a direction, or set tone to HRBFNPR_TONE_NONE",
             owner);
    if (is_zero(style.ambient_up))
        fail(Status::invalid_argument, "%s.ambient_up is zero; give it the direction to the sky", owner);
    if (!(style.tone_black < style.tone_white))
        fail(Status::invalid_argument, "%s.tone_black is %g and tone_white is %g; tone_white must be greater", owner,
             static_cast<double>(style.tone_black), static_cast<double>(style.tone_white));
    if (style.tone_steps == 1)
        fail(Status::invalid_argument, "%s.tone_steps is 1; it must be 0 for continuous tones, or 2 to 6", owner);
    Checks(owner).not_null("tone_function", style.tone != HRBFNPR_TONE_CALLBACK || style.tone_function != nullptr);
    const bool off = style.depth_min == 0.0 && style.depth_max == 0.0;
    if (!off && !(style.depth_min > 0.0 && style.depth_min < style.depth_max))
        fail(Status::invalid_argument,
             "%s.depth_min is %g and depth_max is %g; they must be 0 < depth_min < depth_max, or both 0 for no effect",
             owner, style.depth_min, style.depth_max);
}

void check_hatch(const GivenLayer& layer, const char* owner) {
    if (!(layer.hatch_tone_begin < layer.hatch_tone_end))
        fail(Status::invalid_argument,
             "%s.hatch_tone_begin is %g and hatch_tone_end is %g; hatch_tone_end must be greater", owner,
             static_cast<double>(layer.hatch_tone_begin), static_cast<double>(layer.hatch_tone_end));
}

void add_layers(const Style& style, const char* owner, base::Array<frame::LayerStyle>& layers) {
    char name[80];
    std::snprintf(name, sizeof name, "%.60s.layers", owner);
    const List<GivenLayer> list(style.layers, style.layer_count, style.layer_stride, most_layer_styles, name);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const GivenLayer given = list[i];
        layer_style_fields().check(list.name(i).text, given);
        check_hatch(given, list.name(i).text);
        if (given.ink_field != nullptr && style.palette_count == 0)
            fail(Status::invalid_argument, "%s.ink_field is given, but %s.palette has no inks; give it 1 to %d",
                 list.name(i).text, owner, static_cast<int>(frame::most_inks));
        frame::LayerStyle layer;
        layer_style_fields().copy(given, layer);
        layers.push_back(layer);
    }
}

void add_lights(const Style& style, const char* owner, base::Array<frame::LightStyle>& lights) {
    char name[80];
    std::snprintf(name, sizeof name, "%.60s.lights", owner);
    const List<hrbfnpr_light> list(style.lights, style.light_count, style.light_stride, frame::most_lights, name);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const hrbfnpr_light given = list[i];
        light_fields().check(list.name(i).text, given);
        if (given.kind == HRBFNPR_LIGHT_KIND_DIRECTIONAL && is_zero(given.place))
            fail(Status::invalid_argument, "%s.place is zero; give it the direction to the light", list.name(i).text);
        frame::LightStyle light;
        light_fields().copy(given, light);
        lights.push_back(light);
    }
}

void add_palette(const Style& style, const char* owner, base::Array<glm::vec4>& palette) {
    if (style.palette_count < 0 || style.palette_count > frame::most_inks)
        fail(Status::invalid_argument, "%s.palette_count is %lld; it must be from 0 to %d", owner,
             static_cast<long long>(style.palette_count), static_cast<int>(frame::most_inks));
    Checks(owner).not_null("palette", style.palette_count == 0 || style.palette != nullptr);
    for (std::int64_t i = 0; i < 4 * style.palette_count; ++i)
        if (!(style.palette[i] >= 0.0F && style.palette[i] <= 1.0F))
            fail(Status::invalid_argument, "%s.palette[%lld] is %g; it must be from 0 to 1", owner,
                 static_cast<long long>(i), static_cast<double>(style.palette[i]));
    for (const float* ink = style.palette; ink != style.palette + 4 * style.palette_count; ink += 4)
        palette.push_back({ink[0], ink[1], ink[2], ink[3]});
}

// Tells whether the style's first light has no direction.
[[nodiscard]] bool has_no_direction(const Style& style, const base::Array<frame::LightStyle>& lights) noexcept {
    return style.light_count > 0 ? lights[lights.size() - style.light_count].kind == frame::LightKind::place
                                 : is_zero(style.light);
}

// Returns a view of the caller's levels of isophotes; it is empty for other kinds of lines. The levels must be packed,
// and must stay valid until the call ends.
std::span<const double> levels_of(const LineStyle& style, const char* owner) {
    char name[112];
    std::snprintf(name, sizeof name, "%.95s.levels", owner);
    const base::InView view = in_view(style.levels, name, {1, 1U << HRBFNPR_SCALAR_FLOAT64});
    if (style.kind != HRBFNPR_LINE_KIND_ISOPHOTE) return {};
    if (view.count == 0) fail(Status::invalid_argument, "%s is empty; give at least one number from -1 to 1", name);
    if (view.count > 1 && view.stride != sizeof(double))
        fail(Status::invalid_argument, "%s.stride must be 8 bytes; pack the numbers", name);
    if (reinterpret_cast<std::uintptr_t>(view.data) % alignof(double) != 0)
        fail(Status::invalid_argument, "%s.data must be aligned to 8 bytes", name);
    for (std::int64_t i = 0; i < view.count; ++i)
        if (const double level = view.get(i, 0); !(level >= -1.0 && level <= 1.0))
            fail(Status::invalid_argument, "%s[%lld] is %g; it must be from -1 to 1", name, static_cast<long long>(i),
                 level);
    return {reinterpret_cast<const double*>(view.data), static_cast<std::size_t>(view.count)};
}

void add_lines(const Style& style, const char* owner, const base::Array<frame::LightStyle>& lights,
               base::Array<frame::LineStyle>& lines) {
    char name[80];
    std::snprintf(name, sizeof name, "%.60s.lines", owner);
    const List<LineStyle> list(style.lines, style.line_count, style.line_stride, most_layer_styles, name);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const LineStyle given = list[i];
        line_style_fields().check(list.name(i).text, given);
        if (given.kind == 0)
            fail(Status::invalid_argument, "%s.kind is 0; it must be one of HRBFNPR_LINE_KIND_*", list.name(i).text);
        if (given.kind == HRBFNPR_LINE_KIND_ISOPHOTE && style.light_count > 0 && has_no_direction(style, lights))
            fail(Status::invalid_argument,
                 "%s.lights[0].kind is HRBFNPR_LIGHT_KIND_PLACE; isophotes need a first light with a direction", owner);
        if (given.lit_factor != 1.0F && style.light_count == 0 && is_zero(style.light))
            fail(Status::invalid_argument, "%s.light is zero; give it a direction, or set %s.lit_factor to 1", owner,
                 list.name(i).text);
        frame::LineStyle line;
        line_style_fields().copy(given, line);
        line.levels = levels_of(given, list.name(i).text);
        lines.push_back(line);
    }
}

} // namespace

template <>
hrbfnpr_style defaults() noexcept {
    return default_style();
}

template <>
hrbfnpr_layer_style defaults() noexcept {
    return default_layer_style();
}

template <>
hrbfnpr_light defaults() noexcept {
    return default_light();
}

template <>
hrbfnpr_line_style defaults() noexcept {
    return default_line_style();
}

frame::Style checked_style(const hrbfnpr_style& style, const char* owner, StyleLists& lists) {
    style_fields().check(owner, style);
    check_between_fields(style, owner);
    add_layers(style, owner, lists.layers);
    add_lights(style, owner, lists.lights);
    add_lines(style, owner, lists.lights, lists.lines);
    add_palette(style, owner, lists.palette);
    frame::Style to;
    style_fields().copy(style, to);
    return to;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size) {
    return api::init_struct(style, struct_size);
}

hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size) {
    return api::init_struct(style, struct_size);
}

hrbfnpr_status hrbfnpr_light_init(hrbfnpr_light* light, uint32_t struct_size) {
    return api::init_struct(light, struct_size);
}

hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size) {
    return api::init_struct(style, struct_size);
}

} // extern "C"
