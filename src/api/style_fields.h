// SPDX-License-Identifier: MIT
// The field tables of styles. Each row checks a field, copies it to the settings of the frame, and contains its
// default.
#pragma once

#include "api/fields.h"
#include "frame/scene/style.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

static_assert(static_cast<int>(frame::HiddenLines::attenuate) == HRBFNPR_HIDDEN_LINES_ATTENUATE);
static_assert(static_cast<int>(frame::HiddenLines::hide) == HRBFNPR_HIDDEN_LINES_HIDE);
static_assert(static_cast<int>(frame::HiddenLines::show) == HRBFNPR_HIDDEN_LINES_SHOW);
static_assert(static_cast<int>(frame::Visibility::depth_layers) == HRBFNPR_VISIBILITY_DEPTH_LAYERS);
static_assert(static_cast<int>(frame::Visibility::published) == HRBFNPR_VISIBILITY_PUBLISHED);
static_assert(static_cast<int>(frame::ToneCurve::coverage) == HRBFNPR_TONE_CURVE_COVERAGE);
static_assert(static_cast<int>(frame::ToneCurve::linear) == HRBFNPR_TONE_CURVE_LINEAR);
static_assert(static_cast<int>(frame::Tone::none) == HRBFNPR_TONE_NONE);
static_assert(static_cast<int>(frame::Tone::light) == HRBFNPR_TONE_LIGHT);
static_assert(static_cast<int>(frame::Tone::callback) == HRBFNPR_TONE_CALLBACK);
static_assert(static_cast<int>(frame::ToneRule::share) == HRBFNPR_TONE_RULE_SHARE);
static_assert(static_cast<int>(frame::ToneRule::published) == HRBFNPR_TONE_RULE_PUBLISHED);
static_assert(static_cast<int>(frame::LightSpace::world) == HRBFNPR_LIGHT_WORLD);
static_assert(static_cast<int>(frame::LightSpace::camera) == HRBFNPR_LIGHT_CAMERA);
static_assert(static_cast<int>(frame::LightSpace::item) == HRBFNPR_LIGHT_ITEM);
static_assert(static_cast<int>(frame::LightKind::directional) == HRBFNPR_LIGHT_KIND_DIRECTIONAL);
static_assert(static_cast<int>(frame::LightKind::place) == HRBFNPR_LIGHT_KIND_PLACE);
static_assert(static_cast<int>(frame::Shape::dots) == HRBFNPR_SHAPE_DOTS);
static_assert(static_cast<int>(frame::Shape::strokes) == HRBFNPR_SHAPE_STROKES);
static_assert(static_cast<int>(frame::Shape::hatch) == HRBFNPR_SHAPE_HATCH);
static_assert(static_cast<int>(frame::FieldRule::replace) == HRBFNPR_FIELD_RULE_REPLACE);
static_assert(static_cast<int>(frame::FieldRule::scale) == HRBFNPR_FIELD_RULE_SCALE);
static_assert(static_cast<int>(frame::PaletteRule::nearest) == HRBFNPR_PALETTE_NEAREST);
static_assert(static_cast<int>(frame::PaletteRule::mixed) == HRBFNPR_PALETTE_MIXED);

namespace style_rule {

inline constexpr double largest_radius = 16384.0; // in pixels
inline constexpr rule::Between pixels{0.0, largest_radius};
inline constexpr rule::PositiveUpTo radius{largest_radius};
inline constexpr rule::Between share{0.0, 1.0};
inline constexpr rule::PositiveUpTo some{1.0};
inline constexpr rule::Between factor{0.0, 16.0};   // The range of factors for the width of a line or pen.
inline constexpr rule::Between strength{0.0, 16.0}; // The range of lights.
inline constexpr auto ink = rule::IndexedNumbers{share};

} // namespace style_rule

[[nodiscard]] constexpr auto layer_style_fields() noexcept {
    using namespace style_rule;
    using Given = hrbfnpr_layer_style;
    using To = frame::LayerStyle;
    return FieldTable{
        field("kind", &Given::kind, &To::kind, rule::OneOf{marks::kind_count - 1, "HRBFNPR_LAYER_KIND_*"}),
        field("name", &Given::name, &To::name, rule::Any{}),
        field("shown", &Given::shown, &To::shown, share),
        field("contours", &Given::contours, &To::contours, share),
        field("directions", &Given::directions, &To::directions, rule::Flags{3}),
        field("shape", &Given::shape, &To::shape, rule::OneOf{HRBFNPR_SHAPE_HATCH, "HRBFNPR_SHAPE_*"}),
        field("share", &Given::share, &To::share, share),
        field("radius", &Given::radius, &To::radius, radius),
        field("radius_zoom", &Given::radius_zoom, &To::radius_zoom, share),
        reserved("reserved", &Given::reserved),
        field("ink", &Given::ink, &To::ink, ink),
        field("hatch_tone_begin", &Given::hatch_tone_begin, &To::hatch_tone_begin, share),
        field("hatch_tone_end", &Given::hatch_tone_end, &To::hatch_tone_end, some),
        field("hatch_coverage_begin", &Given::hatch_coverage_begin, &To::hatch_coverage_begin, some),
        field("hatch_coverage_end", &Given::hatch_coverage_end, &To::hatch_coverage_end, some),
        field("hatch_spacing", &Given::hatch_spacing, &To::hatch_spacing, radius),
        field("hatch_pen", &Given::hatch_pen, &To::hatch_pen, radius),
        field("hatch_white", &Given::hatch_white, &To::hatch_white, pixels),
        field("hatch_taper", &Given::hatch_taper, &To::hatch_taper, pixels),
        field("hatch_shortest", &Given::hatch_shortest, &To::hatch_shortest, pixels),
        reserved("reserved2", &Given::reserved2),
        field("hatch_wobble", &Given::hatch_wobble, &To::hatch_wobble, factor),
        field("hatch_overshoot", &Given::hatch_overshoot, &To::hatch_overshoot, pixels),
        field("hatch_seed", &Given::hatch_seed, &To::hatch_seed, rule::Any{}),
        reserved("reserved3", &Given::reserved3),
        field("density_field", &Given::density_field, &To::density_field, rule::Any{}),
        field("tone_field", &Given::tone_field, &To::tone_field, rule::Any{}),
        field("width_field", &Given::width_field, &To::width_field, rule::Any{}),
        field("ink_field", &Given::ink_field, &To::ink_field, rule::Any{}),
        field("mask_field", &Given::mask_field, &To::mask_field, rule::Any{}),
        field("tone_field_rule", &Given::tone_field_rule, &To::tone_field_rule,
              rule::OneOf{HRBFNPR_FIELD_RULE_SCALE, "HRBFNPR_FIELD_RULE_*"}),
        field("palette_rule", &Given::palette_rule, &To::palette_rule,
              rule::OneOf{HRBFNPR_PALETTE_MIXED, "HRBFNPR_PALETTE_*"}),
        field("hatch_fade", &Given::hatch_fade, &To::hatch_fade, share),
        reserved("reserved4", &Given::reserved4)};
}
static_assert(layer_style_fields().covers<hrbfnpr_layer_style>());

[[nodiscard]] constexpr auto style_fields() noexcept {
    using namespace style_rule;
    using Given = hrbfnpr_style;
    using To = frame::Style;
    return FieldTable{
        field("tone", &Given::tone, &To::tone, rule::OneOf{HRBFNPR_TONE_CALLBACK, "HRBFNPR_TONE_*"}),
        field("paper", &Given::paper, &To::paper, ink),
        field("layers", &Given::layers, rule::Any{}),
        field("layer_count", &Given::layer_count, rule::Any{}),
        field("layer_stride", &Given::layer_stride, rule::Any{}),
        field("tone_rule", &Given::tone_rule, &To::tone_rule,
              rule::OneOf{HRBFNPR_TONE_RULE_PUBLISHED, "HRBFNPR_TONE_RULE_*"}),
        field("tone_curve", &Given::tone_curve, &To::tone_curve,
              rule::OneOf{HRBFNPR_TONE_CURVE_LINEAR, "HRBFNPR_TONE_CURVE_*"}),
        field("light", &Given::light, &To::light, rule::AllNumbers{rule::Finite{}}),
        field("tone_exponent", &Given::tone_exponent, &To::tone_exponent, rule::Positive{}),
        field("tone_function", &Given::tone_function, &To::tone_function, rule::Any{}),
        field("tone_user", &Given::tone_user, &To::tone_user, rule::Any{}),
        field("light_space", &Given::light_space, &To::light_space, rule::OneOf{HRBFNPR_LIGHT_ITEM, "HRBFNPR_LIGHT_*"}),
        field("tone_fade", &Given::tone_fade, &To::tone_fade, share),
        field("silhouette_threshold", &Given::silhouette_threshold, &To::silhouette_threshold,
              rule::StrictlyBetween{0.0, 1.0}),
        field("silhouette_radius", &Given::silhouette_radius, &To::silhouette_radius, radius),
        field("silhouette_radius_zoom", &Given::silhouette_radius_zoom, &To::silhouette_radius_zoom, share),
        field("silhouette_ink", &Given::silhouette_ink, &To::silhouette_ink, ink),
        field("visibility", &Given::visibility, &To::visibility,
              rule::OneOf{HRBFNPR_VISIBILITY_PUBLISHED, "HRBFNPR_VISIBILITY_*"}),
        field("hidden_lines", &Given::hidden_lines, &To::hidden_lines,
              rule::OneOf{HRBFNPR_HIDDEN_LINES_SHOW, "HRBFNPR_HIDDEN_LINES_*"}),
        field("attenuation_front", &Given::attenuation_front, &To::attenuation_front, rule::not_negative),
        field("attenuation_back", &Given::attenuation_back, &To::attenuation_back, rule::not_negative),
        field("splat_radius", &Given::splat_radius, &To::splat_radius, pixels),
        field("splat_overlap", &Given::splat_overlap, &To::splat_overlap, rule::Between{0.0, 1e6}),
        field("halo_width", &Given::halo_width, &To::halo_width, pixels),
        field("verify_lines", &Given::verify_lines, &To::verify_lines, rule::ZeroOrOne{}),
        field("depth_min", &Given::depth_min, &To::depth_min, rule::not_negative),
        field("depth_max", &Given::depth_max, &To::depth_max, rule::not_negative),
        field("zoom_reference", &Given::zoom_reference, &To::zoom_reference, rule::not_negative),
        field("zoom_exponent", &Given::zoom_exponent, &To::zoom_exponent, rule::not_negative),
        field("lines", &Given::lines, rule::Any{}),
        field("line_count", &Given::line_count, rule::Any{}),
        field("line_stride", &Given::line_stride, rule::Any{}),
        field("fill_light", &Given::fill_light, &To::fill_light, share),
        reserved("reserved2", &Given::reserved2),
        field("light_intensity", &Given::light_intensity, &To::light_intensity, strength),
        field("light_shadow", &Given::light_shadow, &To::light_shadow, share),
        field("light_softness", &Given::light_softness, &To::light_softness, rule::Between{0.0, 0.5}),
        field("evenness", &Given::evenness, &To::evenness, rule::OneOf{HRBFNPR_EVENNESS_SURFACE, "HRBFNPR_EVENNESS_*"}),
        field("lights", &Given::lights, rule::Any{}),
        field("light_count", &Given::light_count, rule::Any{}),
        field("light_stride", &Given::light_stride, rule::Any{}),
        field("ambient_up", &Given::ambient_up, &To::ambient_up, rule::AllNumbers{rule::Finite{}}),
        field("ambient_sky", &Given::ambient_sky, &To::ambient_sky, strength),
        field("ambient_ground", &Given::ambient_ground, &To::ambient_ground, strength),
        field("occlusion", &Given::occlusion, &To::occlusion, share),
        field("occlusion_exponent", &Given::occlusion_exponent, &To::occlusion_exponent, rule::PositiveUpTo{16.0}),
        field("rim_light", &Given::rim_light, &To::rim_light, strength),
        field("rim_exponent", &Given::rim_exponent, &To::rim_exponent, rule::PositiveUpTo{64.0}),
        field("tone_black", &Given::tone_black, &To::tone_black, rule::Between{-16.0, 16.0}),
        field("tone_white", &Given::tone_white, &To::tone_white, rule::Between{-16.0, 16.0}),
        field("tone_gamma", &Given::tone_gamma, &To::tone_gamma, rule::PositiveUpTo{16.0}),
        field("tone_steps", &Given::tone_steps, &To::tone_steps, rule::Between{0.0, 6.0}),
        field("curvature_contrast", &Given::curvature_contrast, &To::curvature_contrast, strength),
        field("occlusion_lights", &Given::occlusion_lights, &To::occlusion_lights, share),
        field("palette", &Given::palette, rule::Any{}),
        field("palette_count", &Given::palette_count, rule::Any{})};
}
static_assert(style_fields().covers<hrbfnpr_style>());

[[nodiscard]] constexpr auto line_style_fields() noexcept {
    using namespace style_rule;
    using Given = hrbfnpr_line_style;
    using To = frame::LineStyle;
    return FieldTable{
        field("kind", &Given::kind, &To::kind, rule::OneOf{HRBFNPR_LINE_KIND_TANGENT_EDGE, "HRBFNPR_LINE_KIND_*"}),
        field("name", &Given::name, &To::name, rule::Any{}),
        field("hidden", &Given::hidden, &To::hidden, rule::OneOf{HRBFNPR_HIDDEN_PARTS_SHOWN, "HRBFNPR_HIDDEN_PARTS_*"}),
        field("cap", &Given::cap, &To::cap, rule::OneOf{HRBFNPR_CAP_POINTED, "HRBFNPR_CAP_*"}),
        field("width", &Given::width, &To::width, radius),
        field("taper", &Given::taper, &To::taper, pixels),
        field("hidden_width", &Given::hidden_width, &To::hidden_width, radius),
        field("hidden_opacity", &Given::hidden_opacity, &To::hidden_opacity, share),
        field("dash", &Given::dash, &To::dash, radius),
        field("gap", &Given::gap, &To::gap, radius),
        field("shortest", &Given::shortest, &To::shortest, pixels),
        field("fade", &Given::fade, &To::fade, share),
        field("lower", &Given::lower, &To::lower, rule::not_negative),
        field("upper", &Given::upper, &To::upper, rule::not_negative),
        field("levels", &Given::levels, rule::Any{}),
        field("ink", &Given::ink, &To::ink, ink),
        field("outline_factor", &Given::outline_factor, &To::outline_factor, factor),
        field("far_factor", &Given::far_factor, &To::far_factor, factor),
        field("lit_factor", &Given::lit_factor, &To::lit_factor, factor),
        field("curvature_factor", &Given::curvature_factor, &To::curvature_factor, factor),
        field("curvature_radius", &Given::curvature_radius, &To::curvature_radius, rule::Positive{}),
        field("wobble", &Given::wobble, &To::wobble, factor),
        field("wobble_width", &Given::wobble_width, &To::wobble_width, share),
        field("wobble_length", &Given::wobble_length, &To::wobble_length, rule::Between{1.0, largest_radius}),
        field("wobble_seed", &Given::wobble_seed, &To::wobble_seed, rule::Any{}),
        field("creases", &Given::creases, &To::creases, rule::OneOf{HRBFNPR_CREASES_CONCAVE, "HRBFNPR_CREASES_*"})};
}
static_assert(line_style_fields().covers<hrbfnpr_line_style>());

[[nodiscard]] constexpr auto light_fields() noexcept {
    using Given = hrbfnpr_light;
    using To = frame::LightStyle;
    return FieldTable{
        field("kind", &Given::kind, &To::kind, rule::OneOf{HRBFNPR_LIGHT_KIND_PLACE, "HRBFNPR_LIGHT_KIND_*"}),
        field("space", &Given::space, &To::space, rule::OneOf{HRBFNPR_LIGHT_ITEM, "HRBFNPR_LIGHT_*"}),
        field("intensity", &Given::intensity, &To::intensity, style_rule::strength),
        field("shadow", &Given::shadow, &To::shadow, style_rule::share),
        field("softness", &Given::softness, &To::softness, rule::Between{0.0, 0.5}),
        field("place", &Given::place, &To::place, rule::AllNumbers{rule::Finite{}})};
}
static_assert(light_fields().covers<hrbfnpr_light>());

// ---- Defaults, as constants

template <class Given, class Settings, class Table>
[[nodiscard]] constexpr Given defaults_of(const Table& table) noexcept {
    Given given{};
    given.struct_size = sizeof given;
    table.set_defaults(Settings{}, given);
    return given;
}

[[nodiscard]] constexpr hrbfnpr_style default_style() noexcept {
    return defaults_of<hrbfnpr_style, frame::Style>(style_fields());
}
[[nodiscard]] constexpr hrbfnpr_layer_style default_layer_style() noexcept {
    return defaults_of<hrbfnpr_layer_style, frame::LayerStyle>(layer_style_fields());
}
[[nodiscard]] constexpr hrbfnpr_line_style default_line_style() noexcept {
    return defaults_of<hrbfnpr_line_style, frame::LineStyle>(line_style_fields());
}
[[nodiscard]] constexpr hrbfnpr_light default_light() noexcept {
    return defaults_of<hrbfnpr_light, frame::LightStyle>(light_fields());
}

} // namespace hrbfnpr::api
