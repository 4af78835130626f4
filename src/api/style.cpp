#include "api/style.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/preset_layers.h"

#include <cstdio>

using namespace hrbfnpr;

static_assert(static_cast<int>(frame::HiddenLines::attenuate) == HRBFNPR_HIDDEN_LINES_ATTENUATE);
static_assert(static_cast<int>(frame::HiddenLines::hide) == HRBFNPR_HIDDEN_LINES_HIDE);
static_assert(static_cast<int>(frame::HiddenLines::show) == HRBFNPR_HIDDEN_LINES_SHOW);
static_assert(static_cast<int>(frame::Visibility::sheets) == HRBFNPR_VISIBILITY_SHEETS);
static_assert(static_cast<int>(frame::Visibility::painted) == HRBFNPR_VISIBILITY_PAINTED);
static_assert(static_cast<int>(frame::ToneCurve::coverage) == HRBFNPR_TONE_CURVE_COVERAGE);
static_assert(static_cast<int>(frame::ToneCurve::linear) == HRBFNPR_TONE_CURVE_LINEAR);
static_assert(static_cast<int>(frame::SilhouetteLaw::width) == HRBFNPR_SILHOUETTE_LAW_WIDTH);
static_assert(static_cast<int>(frame::SilhouetteLaw::angle) == HRBFNPR_SILHOUETTE_LAW_ANGLE);
static_assert(static_cast<int>(frame::Tone::none) == HRBFNPR_TONE_NONE);
static_assert(static_cast<int>(frame::Tone::light) == HRBFNPR_TONE_LIGHT);
static_assert(static_cast<int>(frame::Tone::callback) == HRBFNPR_TONE_CALLBACK);
static_assert(static_cast<int>(frame::ToneRule::share) == HRBFNPR_TONE_RULE_SHARE);
static_assert(static_cast<int>(frame::ToneRule::paper) == HRBFNPR_TONE_RULE_PAPER);
static_assert(static_cast<int>(frame::LightSpace::world) == HRBFNPR_LIGHT_WORLD);
static_assert(static_cast<int>(frame::LightSpace::camera) == HRBFNPR_LIGHT_CAMERA);
static_assert(frame::preset_count == HRBFNPR_STYLE_COUNT);

namespace hrbfnpr::api {
namespace {

constexpr std::uint32_t group_bits = (1U << HRBFNPR_GROUP_COUNT) - 1;
constexpr double largest_radius = 16384.0; // pixels

void set_color(float* to, const glm::vec4& from) noexcept {
    for (int i = 0; i < 4; ++i) to[i] = from[i];
}

glm::vec4 checked_color(const Checks& checks, const char* field, const float* color) {
    for (int i = 0; i < 4; ++i) {
        char name[40];
        std::snprintf(name, sizeof name, "%s[%d]", field, i);
        checks.between(name, static_cast<double>(color[i]), 0.0, 1.0);
    }
    return {color[0], color[1], color[2], color[3]};
}

void set_group(hrbfnpr_group_style& to, const frame::GroupStyle& from) noexcept {
    to.shown = from.shown ? 1 : 0;
    to.sets = from.sets;
    to.share = from.share;
    to.radius = from.radius;
    to.radius_zoom = from.radius_zoom;
    set_color(to.ink, from.ink);
}

hrbfnpr_style from_style(const frame::Style& from) noexcept {
    hrbfnpr_style to{};
    to.hidden_lines = static_cast<std::uint32_t>(from.hidden_lines);
    to.silhouette_threshold = from.silhouette_threshold;
    to.attenuation_front = from.attenuation_front;
    to.attenuation_back = from.attenuation_back;
    to.cover_radius = from.cover_radius;
    to.halo_width = from.halo_width;
    to.cover_layers = from.cover_layers;
    to.visibility = static_cast<std::uint32_t>(from.visibility);
    to.tone = static_cast<std::uint32_t>(from.tone);
    to.tone_rule = static_cast<std::uint32_t>(from.tone_rule);
    to.light_space = static_cast<std::uint32_t>(from.light_space);
    to.silhouette_groups = from.silhouette_groups;
    to.tone_curve = static_cast<std::uint32_t>(from.tone_curve);
    to.silhouette_law = static_cast<std::uint32_t>(from.silhouette_law);
    to.tone_fade = from.tone_fade;
    to.silhouette_width = from.silhouette_width;
    for (int axis = 0; axis < 3; ++axis) to.light[axis] = from.light[axis];
    to.tone_exponent = from.tone_exponent;
    to.depth_min = from.depth_min;
    to.depth_max = from.depth_max;
    to.zoom_reference = from.zoom_reference;
    to.zoom_exponent = from.zoom_exponent;
    set_color(to.paper, from.paper);
    set_color(to.silhouette_ink, from.silhouette_ink);
    to.silhouette_radius = from.silhouette_radius;
    to.silhouette_radius_zoom = from.silhouette_radius_zoom;
    for (std::size_t i = 0; i < from.group.size(); ++i) set_group(to.group[i], from.group[i]);
    return to;
}

void check_hidden_lines(const Checks& checks, const hrbfnpr_style& style) {
    checks.one_of("hidden_lines", style.hidden_lines, HRBFNPR_HIDDEN_LINES_SHOW + 1, "HRBFNPR_HIDDEN_LINES_...");
    checks.inside("silhouette_threshold", style.silhouette_threshold, 0.0, 1.0);
    checks.at_least("attenuation_front", style.attenuation_front, 0.0);
    checks.at_least("attenuation_back", style.attenuation_back, 0.0);
    checks.between("cover_radius", static_cast<double>(style.cover_radius), 0.0, largest_radius);
    checks.between("halo_width", static_cast<double>(style.halo_width), 0.0, largest_radius);
    checks.between("cover_layers", static_cast<double>(style.cover_layers), 0.0, 1e6);
    checks.one_of("visibility", style.visibility, HRBFNPR_VISIBILITY_PAINTED + 1, "HRBFNPR_VISIBILITY_...");
    checks.one_of("silhouette_law", style.silhouette_law, HRBFNPR_SILHOUETTE_LAW_ANGLE + 1,
                  "HRBFNPR_SILHOUETTE_LAW_...");
    checks.between("silhouette_width", static_cast<double>(style.silhouette_width), 0.0, largest_radius);
}

void check_tone(const Checks& checks, const hrbfnpr_style& style, const char* owner) {
    checks.one_of("tone", style.tone, HRBFNPR_TONE_CALLBACK + 1, "HRBFNPR_TONE_...");
    checks.one_of("tone_rule", style.tone_rule, HRBFNPR_TONE_RULE_PAPER + 1, "HRBFNPR_TONE_RULE_...");
    checks.one_of("light_space", style.light_space, HRBFNPR_LIGHT_CAMERA + 1, "HRBFNPR_LIGHT_...");
    for (const double component : style.light) checks.finite("light", component);
    if (style.tone == HRBFNPR_TONE_LIGHT && style.light[0] == 0.0 && style.light[1] == 0.0 && style.light[2] == 0.0)
        fail(Status::invalid_argument, "%s.light is zero; give it a direction, or set tone to HRBFNPR_TONE_NONE",
             owner);
    checks.one_of("tone_curve", style.tone_curve, HRBFNPR_TONE_CURVE_LINEAR + 1, "HRBFNPR_TONE_CURVE_...");
    checks.between("tone_fade", static_cast<double>(style.tone_fade), 0.0, 1.0);
    checks.positive("tone_exponent", style.tone_exponent);
    checks.given("tone_function", style.tone != HRBFNPR_TONE_CALLBACK || style.tone_function != nullptr);
}

void check_distances(const Checks& checks, const hrbfnpr_style& style, const char* owner) {
    checks.at_least("depth_min", style.depth_min, 0.0);
    checks.at_least("depth_max", style.depth_max, 0.0);
    const bool off = style.depth_min == 0.0 && style.depth_max == 0.0;
    if (!off && !(style.depth_min > 0.0 && style.depth_min < style.depth_max))
        fail(Status::invalid_argument,
             "%s.depth_min is %g and depth_max is %g; it must be 0 < depth_min < depth_max, or both 0 for no effect",
             owner, style.depth_min, style.depth_max);
    checks.at_least("zoom_reference", style.zoom_reference, 0.0);
    checks.at_least("zoom_exponent", style.zoom_exponent, 0.0);
}

frame::GroupStyle checked_group(const hrbfnpr_group_style& group, const char* owner, std::size_t number) {
    char name[64];
    std::snprintf(name, sizeof name, "%s.group[%d]", owner, static_cast<int>(number));
    const Checks checks(name);
    checks.between("shown", group.shown, 0, 1);
    checks.flags("sets", group.sets, 3);
    checks.between("share", static_cast<double>(group.share), 0.0, 1.0);
    checks.positive("radius", static_cast<double>(group.radius));
    checks.between("radius", static_cast<double>(group.radius), 0.0, largest_radius);
    checks.between("radius_zoom", static_cast<double>(group.radius_zoom), 0.0, 1.0);
    return {group.shown != 0, group.sets,        group.share,
            group.radius,     group.radius_zoom, checked_color(checks, "ink", group.ink)};
}

} // namespace

template <>
hrbfnpr_style defaults() noexcept {
    return from_style(frame::Style{});
}

frame::Style checked_style(const hrbfnpr_style& style, const char* owner) {
    const Checks checks(owner);
    check_hidden_lines(checks, style);
    check_tone(checks, style, owner);
    check_distances(checks, style, owner);
    checks.flags("silhouette_groups", style.silhouette_groups, group_bits);
    checks.positive("silhouette_radius", static_cast<double>(style.silhouette_radius));
    checks.between("silhouette_radius", static_cast<double>(style.silhouette_radius), 0.0, largest_radius);
    checks.between("silhouette_radius_zoom", static_cast<double>(style.silhouette_radius_zoom), 0.0, 1.0);
    frame::Style to;
    to.hidden_lines = static_cast<frame::HiddenLines>(style.hidden_lines);
    to.silhouette_threshold = style.silhouette_threshold;
    to.attenuation_front = style.attenuation_front;
    to.attenuation_back = style.attenuation_back;
    to.cover_radius = style.cover_radius;
    to.halo_width = style.halo_width;
    to.cover_layers = style.cover_layers;
    to.visibility = static_cast<frame::Visibility>(style.visibility);
    to.tone = static_cast<frame::Tone>(style.tone);
    to.tone_rule = static_cast<frame::ToneRule>(style.tone_rule);
    to.light_space = static_cast<frame::LightSpace>(style.light_space);
    to.silhouette_groups = style.silhouette_groups;
    to.tone_curve = static_cast<frame::ToneCurve>(style.tone_curve);
    to.silhouette_law = static_cast<frame::SilhouetteLaw>(style.silhouette_law);
    to.tone_fade = style.tone_fade;
    to.silhouette_width = style.silhouette_width;
    to.light = {style.light[0], style.light[1], style.light[2]};
    to.tone_exponent = style.tone_exponent;
    to.tone_function = style.tone_function;
    to.tone_user = style.tone_user;
    to.depth_min = style.depth_min;
    to.depth_max = style.depth_max;
    to.zoom_reference = style.zoom_reference;
    to.zoom_exponent = style.zoom_exponent;
    to.paper = checked_color(checks, "paper", style.paper);
    to.silhouette_ink = checked_color(checks, "silhouette_ink", style.silhouette_ink);
    to.silhouette_radius = style.silhouette_radius;
    to.silhouette_radius_zoom = style.silhouette_radius_zoom;
    for (std::size_t i = 0; i < to.group.size(); ++i) to.group[i] = checked_group(style.group[i], owner, i);
    return to;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size) {
    return api::init_struct(style, struct_size);
}

hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size, uint32_t preset,
                                         uint32_t* generate_groups, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::require_pointer(style, "style");
        api::check_struct_size<hrbfnpr_style>(struct_size, "style");
        if (preset >= HRBFNPR_STYLE_COUNT)
            fail(Status::invalid_argument, "preset is %u; it must be one of HRBFNPR_STYLE_... (0 to %d)", preset,
                 HRBFNPR_STYLE_COUNT - 1);
        const frame::Preset named = frame::preset(preset);
        style->struct_size = struct_size;
        api::write_struct(style, api::from_style(named.style));
        if (generate_groups != nullptr) *generate_groups = named.needed_groups;
    });
}

const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count) {
    const api::PresetLayers layers = api::preset_layers(preset);
    if (count != nullptr) *count = layers.count;
    return layers.first;
}

const char* hrbfnpr_style_preset_name(uint32_t preset) {
    return preset < frame::preset_count ? frame::preset_name(preset) : nullptr;
}

} // extern "C"
