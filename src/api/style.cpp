// SPDX-License-Identifier: MIT
#include "api/style.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/lists.h"
#include "api/views.h"
#include "frame/scene/presets.h"

#include <array>
#include <cstdio>

using namespace hrbfnpr;

static_assert(static_cast<int>(frame::HiddenLines::attenuate) == HRBFNPR_HIDDEN_LINES_ATTENUATE);
static_assert(static_cast<int>(frame::HiddenLines::hide) == HRBFNPR_HIDDEN_LINES_HIDE);
static_assert(static_cast<int>(frame::HiddenLines::show) == HRBFNPR_HIDDEN_LINES_SHOW);
static_assert(static_cast<int>(frame::Visibility::depth_layers) == HRBFNPR_VISIBILITY_DEPTH_LAYERS);
static_assert(static_cast<int>(frame::Visibility::published) == HRBFNPR_VISIBILITY_PUBLISHED);
static_assert(static_cast<int>(frame::ToneCurve::coverage) == HRBFNPR_TONE_CURVE_COVERAGE);
static_assert(static_cast<int>(frame::ToneCurve::linear) == HRBFNPR_TONE_CURVE_LINEAR);
static_assert(static_cast<int>(frame::SilhouetteLaw::width) == HRBFNPR_SILHOUETTE_LAW_WIDTH);
static_assert(static_cast<int>(frame::SilhouetteLaw::angle) == HRBFNPR_SILHOUETTE_LAW_ANGLE);
static_assert(static_cast<int>(frame::Tone::none) == HRBFNPR_TONE_NONE);
static_assert(static_cast<int>(frame::Tone::light) == HRBFNPR_TONE_LIGHT);
static_assert(static_cast<int>(frame::Tone::callback) == HRBFNPR_TONE_CALLBACK);
static_assert(static_cast<int>(frame::ToneRule::share) == HRBFNPR_TONE_RULE_SHARE);
static_assert(static_cast<int>(frame::ToneRule::published) == HRBFNPR_TONE_RULE_PUBLISHED);
static_assert(static_cast<int>(frame::LightSpace::world) == HRBFNPR_LIGHT_WORLD);
static_assert(static_cast<int>(frame::LightSpace::camera) == HRBFNPR_LIGHT_CAMERA);
static_assert(static_cast<int>(frame::Shape::dots) == HRBFNPR_SHAPE_DOTS);
static_assert(static_cast<int>(frame::Shape::strokes) == HRBFNPR_SHAPE_STROKES);
static_assert(static_cast<int>(frame::Shape::hatch) == HRBFNPR_SHAPE_HATCH);
static_assert(frame::preset_count == HRBFNPR_PRESET_ARCHAEOLOGICAL + 1);

namespace hrbfnpr::api {
namespace {

using GivenLayer = hrbfnpr_layer_style;
using Style = hrbfnpr_style;

constexpr double largest_radius = 16384.0; // pixels
constexpr std::int64_t most_layer_styles = 65536;
constexpr rule::Between pixels{0.0, largest_radius};
constexpr rule::PositiveUpTo radius{largest_radius};
constexpr rule::Between share{0.0, 1.0};
constexpr rule::PositiveUpTo some{1.0};
constexpr rule::Between factor{0.0, 16.0}; // of a line's width or a pen
constexpr auto ink = rule::Each{share};

constexpr auto layer_style_fields() noexcept {
    using To = frame::LayerStyle;
    return FieldTable{
        field("kind", &GivenLayer::kind, &To::kind, rule::OneOf{marks::kind_count - 1, "HRBFNPR_LAYER_KIND_..."}),
        field("name", &GivenLayer::name, &To::name, rule::Any{}),
        field("shown", &GivenLayer::shown, &To::shown, share),
        field("contours", &GivenLayer::contours, &To::contours, share),
        field("directions", &GivenLayer::directions, &To::directions, rule::Flags{3}),
        field("shape", &GivenLayer::shape, &To::shape, rule::OneOf{HRBFNPR_SHAPE_HATCH, "HRBFNPR_SHAPE_..."}),
        field("share", &GivenLayer::share, &To::share, share),
        field("radius", &GivenLayer::radius, &To::radius, radius),
        field("radius_zoom", &GivenLayer::radius_zoom, &To::radius_zoom, share),
        reserved("reserved", &GivenLayer::reserved),
        field("ink", &GivenLayer::ink, &To::ink, ink),
        field("hatch_tone_begin", &GivenLayer::hatch_tone_begin, &To::hatch_tone_begin, share),
        field("hatch_tone_end", &GivenLayer::hatch_tone_end, &To::hatch_tone_end, some),
        field("hatch_coverage_begin", &GivenLayer::hatch_coverage_begin, &To::hatch_coverage_begin, some),
        field("hatch_coverage_end", &GivenLayer::hatch_coverage_end, &To::hatch_coverage_end, some),
        field("hatch_spacing", &GivenLayer::hatch_spacing, &To::hatch_spacing, radius),
        field("hatch_pen", &GivenLayer::hatch_pen, &To::hatch_pen, radius),
        field("hatch_white", &GivenLayer::hatch_white, &To::hatch_white, pixels),
        field("hatch_taper", &GivenLayer::hatch_taper, &To::hatch_taper, pixels),
        field("hatch_shortest", &GivenLayer::hatch_shortest, &To::hatch_shortest, pixels),
        reserved("reserved2", &GivenLayer::reserved2),
        field("hatch_wobble", &GivenLayer::hatch_wobble, &To::hatch_wobble, factor),
        field("hatch_overshoot", &GivenLayer::hatch_overshoot, &To::hatch_overshoot, pixels),
        field("hatch_seed", &GivenLayer::hatch_seed, &To::hatch_seed, rule::Any{}),
        reserved("reserved3", &GivenLayer::reserved3)};
}
static_assert(layer_style_fields().covers<GivenLayer>());

constexpr auto style_fields() noexcept {
    using To = frame::Style;
    return FieldTable{
        field("tone", &Style::tone, &To::tone, rule::OneOf{HRBFNPR_TONE_CALLBACK, "HRBFNPR_TONE_..."}),
        field("paper", &Style::paper, &To::paper, ink),
        field("layers", &Style::layers, rule::Any{}),
        field("layer_count", &Style::layer_count, rule::Any{}),
        field("layer_stride", &Style::layer_stride, rule::Any{}),
        field("tone_rule", &Style::tone_rule, &To::tone_rule,
              rule::OneOf{HRBFNPR_TONE_RULE_PUBLISHED, "HRBFNPR_TONE_RULE_..."}),
        field("tone_curve", &Style::tone_curve, &To::tone_curve,
              rule::OneOf{HRBFNPR_TONE_CURVE_LINEAR, "HRBFNPR_TONE_CURVE_..."}),
        field("light", &Style::light, &To::light, rule::All{rule::Finite{}}),
        field("tone_exponent", &Style::tone_exponent, &To::tone_exponent, rule::Positive{}),
        field("tone_function", &Style::tone_function, &To::tone_function, rule::Any{}),
        field("tone_user", &Style::tone_user, &To::tone_user, rule::Any{}),
        field("light_space", &Style::light_space, &To::light_space,
              rule::OneOf{HRBFNPR_LIGHT_CAMERA, "HRBFNPR_LIGHT_..."}),
        field("tone_fade", &Style::tone_fade, &To::tone_fade, share),
        field("silhouette_law", &Style::silhouette_law, &To::silhouette_law,
              rule::OneOf{HRBFNPR_SILHOUETTE_LAW_ANGLE, "HRBFNPR_SILHOUETTE_LAW_..."}),
        field("silhouette_width", &Style::silhouette_width, &To::silhouette_width, pixels),
        field("silhouette_threshold", &Style::silhouette_threshold, &To::silhouette_threshold, rule::Inside{0.0, 1.0}),
        field("silhouette_radius", &Style::silhouette_radius, &To::silhouette_radius, radius),
        field("silhouette_radius_zoom", &Style::silhouette_radius_zoom, &To::silhouette_radius_zoom, share),
        field("silhouette_ink", &Style::silhouette_ink, &To::silhouette_ink, ink),
        field("visibility", &Style::visibility, &To::visibility,
              rule::OneOf{HRBFNPR_VISIBILITY_PUBLISHED, "HRBFNPR_VISIBILITY_..."}),
        field("hidden_lines", &Style::hidden_lines, &To::hidden_lines,
              rule::OneOf{HRBFNPR_HIDDEN_LINES_SHOW, "HRBFNPR_HIDDEN_LINES_..."}),
        field("attenuation_front", &Style::attenuation_front, &To::attenuation_front, rule::not_negative),
        field("attenuation_back", &Style::attenuation_back, &To::attenuation_back, rule::not_negative),
        field("splat_radius", &Style::splat_radius, &To::splat_radius, pixels),
        field("splat_overlap", &Style::splat_overlap, &To::splat_overlap, rule::Between{0.0, 1e6}),
        field("halo_width", &Style::halo_width, &To::halo_width, pixels),
        reserved("reserved", &Style::reserved),
        field("depth_min", &Style::depth_min, &To::depth_min, rule::not_negative),
        field("depth_max", &Style::depth_max, &To::depth_max, rule::not_negative),
        field("zoom_reference", &Style::zoom_reference, &To::zoom_reference, rule::not_negative),
        field("zoom_exponent", &Style::zoom_exponent, &To::zoom_exponent, rule::not_negative),
        field("lines", &Style::lines, rule::Any{}),
        field("line_count", &Style::line_count, rule::Any{}),
        field("line_stride", &Style::line_stride, rule::Any{}),
        field("fill_light", &Style::fill_light, &To::fill_light, share),
        reserved("reserved2", &Style::reserved2)};
}
static_assert(style_fields().covers<Style>());

using LineStyle = hrbfnpr_line_style;

constexpr auto line_fields() noexcept {
    using To = frame::LineStyle;
    return FieldTable{
        field("kind", &LineStyle::kind, &To::kind, rule::OneOf{HRBFNPR_LINE_KIND_CREASE, "HRBFNPR_LINE_KIND_..."}),
        field("name", &LineStyle::name, &To::name, rule::Any{}),
        field("hidden", &LineStyle::hidden, &To::hidden,
              rule::OneOf{HRBFNPR_HIDDEN_PARTS_SHOWN, "HRBFNPR_HIDDEN_PARTS_..."}),
        field("cap", &LineStyle::cap, &To::cap, rule::OneOf{HRBFNPR_CAP_POINTED, "HRBFNPR_CAP_..."}),
        field("width", &LineStyle::width, &To::width, radius),
        field("taper", &LineStyle::taper, &To::taper, pixels),
        field("hidden_width", &LineStyle::hidden_width, &To::hidden_width, radius),
        field("hidden_opacity", &LineStyle::hidden_opacity, &To::hidden_opacity, share),
        field("dash", &LineStyle::dash, &To::dash, radius),
        field("gap", &LineStyle::gap, &To::gap, radius),
        field("shortest", &LineStyle::shortest, &To::shortest, pixels),
        field("fade", &LineStyle::fade, &To::fade, share),
        field("lower", &LineStyle::lower, &To::lower, rule::not_negative),
        field("upper", &LineStyle::upper, &To::upper, rule::not_negative),
        field("levels", &LineStyle::levels, rule::Any{}),
        field("ink", &LineStyle::ink, &To::ink, ink),
        field("outline_factor", &LineStyle::outline_factor, &To::outline_factor, factor),
        field("far_factor", &LineStyle::far_factor, &To::far_factor, factor),
        field("lit_factor", &LineStyle::lit_factor, &To::lit_factor, factor),
        field("curvature_factor", &LineStyle::curvature_factor, &To::curvature_factor, factor),
        field("curvature_radius", &LineStyle::curvature_radius, &To::curvature_radius, rule::Positive{}),
        field("wobble", &LineStyle::wobble, &To::wobble, factor),
        field("wobble_width", &LineStyle::wobble_width, &To::wobble_width, share),
        field("wobble_length", &LineStyle::wobble_length, &To::wobble_length, rule::Between{1.0, largest_radius}),
        field("wobble_seed", &LineStyle::wobble_seed, &To::wobble_seed, rule::Any{}),
        field("creases", &LineStyle::creases, &To::creases,
              rule::OneOf{HRBFNPR_CREASES_CONCAVE, "HRBFNPR_CREASES_..."})};
}
static_assert(line_fields().covers<LineStyle>());

void check_between_fields(const Style& style, const char* owner) {
    if (style.tone == HRBFNPR_TONE_LIGHT && style.light[0] == 0.0 && style.light[1] == 0.0 && style.light[2] == 0.0)
        fail(Status::invalid_argument, "%s.light is zero; give it a direction, or set tone to HRBFNPR_TONE_NONE",
             owner);
    Checks(owner).given("tone_function", style.tone != HRBFNPR_TONE_CALLBACK || style.tone_function != nullptr);
    const bool off = style.depth_min == 0.0 && style.depth_max == 0.0;
    if (!off && !(style.depth_min > 0.0 && style.depth_min < style.depth_max))
        fail(Status::invalid_argument,
             "%s.depth_min is %g and depth_max is %g; it must be 0 < depth_min < depth_max, or both 0 for no effect",
             owner, style.depth_min, style.depth_max);
}

void check_hatch(const GivenLayer& layer, const char* owner) {
    if (!(layer.hatch_tone_begin < layer.hatch_tone_end))
        fail(Status::invalid_argument, "%s.hatch_tone_begin is %g and hatch_tone_end is %g; the end must be greater",
             owner, static_cast<double>(layer.hatch_tone_begin), static_cast<double>(layer.hatch_tone_end));
}

void add_layers(const Style& style, const char* owner, base::Array<frame::LayerStyle>& layers) {
    char name[80];
    std::snprintf(name, sizeof name, "%.60s.layers", owner);
    const List<GivenLayer> list(style.layers, style.layer_count, style.layer_stride, most_layer_styles, name);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const GivenLayer given = list[i];
        layer_style_fields().check(list.name(i).text, given);
        check_hatch(given, list.name(i).text);
        frame::LayerStyle layer;
        layer_style_fields().copy(given, layer);
        layers.push_back(layer);
    }
}

// The caller's, which are packed and are read while the call lasts.
std::span<const double> levels_of(const LineStyle& style, const char* owner) {
    char name[112];
    std::snprintf(name, sizeof name, "%.95s.levels", owner);
    const base::InView view = in_view(style.levels, name, {1, 1U << HRBFNPR_SCALAR_FLOAT64});
    if (style.kind != HRBFNPR_LINE_KIND_ISOPHOTE) return {};
    if (view.count == 0) fail(Status::invalid_argument, "%s is empty; give some numbers from -1 to 1", name);
    if (view.count > 1 && view.stride != sizeof(double))
        fail(Status::invalid_argument, "%s must be packed: a stride of 8 bytes", name);
    if (reinterpret_cast<std::uintptr_t>(view.data) % alignof(double) != 0)
        fail(Status::invalid_argument, "%s must be aligned to 8 bytes", name);
    for (std::int64_t i = 0; i < view.count; ++i)
        if (const double level = view.get(i, 0); !(level >= -1.0 && level <= 1.0))
            fail(Status::invalid_argument, "%s[%lld] is %g; it must be from -1 to 1", name, static_cast<long long>(i),
                 level);
    return {reinterpret_cast<const double*>(view.data), static_cast<std::size_t>(view.count)};
}

void add_lines(const Style& style, const char* owner, base::Array<frame::LineStyle>& lines) {
    char name[80];
    std::snprintf(name, sizeof name, "%.60s.lines", owner);
    const List<LineStyle> list(style.lines, style.line_count, style.line_stride, most_layer_styles, name);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const LineStyle given = list[i];
        line_fields().check(list.name(i).text, given);
        if (given.kind == 0)
            fail(Status::invalid_argument, "%s.kind is 0; it must be one of HRBFNPR_LINE_KIND_...", list.name(i).text);
        if (given.lit_factor != 1.0F && style.light[0] == 0.0 && style.light[1] == 0.0 && style.light[2] == 0.0)
            fail(Status::invalid_argument, "%s.light is zero; give it a direction, or set %s.lit_factor to 1", owner,
                 list.name(i).text);
        frame::LineStyle line;
        line_fields().copy(given, line);
        line.levels = levels_of(given, list.name(i).text);
        lines.push_back(line);
    }
}

constexpr LineStyle constant(const frame::LineStyle& from) {
    LineStyle to{};
    to.struct_size = sizeof to;
    to.kind = static_cast<std::uint32_t>(from.kind);
    to.name = from.name;
    to.hidden = static_cast<std::uint32_t>(from.hidden);
    to.cap = static_cast<std::uint32_t>(from.cap);
    to.width = from.width;
    to.taper = from.taper;
    to.hidden_width = from.hidden_width;
    to.hidden_opacity = from.hidden_opacity;
    to.dash = from.dash;
    to.gap = from.gap;
    to.shortest = from.shortest;
    to.fade = from.fade;
    for (std::size_t i = 0; i < 4; ++i) to.ink[i] = from.ink[i];
    to.outline_factor = from.outline_factor;
    to.far_factor = from.far_factor;
    to.lit_factor = from.lit_factor;
    to.curvature_factor = from.curvature_factor;
    to.curvature_radius = from.curvature_radius;
    to.wobble = from.wobble;
    to.wobble_width = from.wobble_width;
    to.wobble_length = from.wobble_length;
    to.wobble_seed = from.wobble_seed;
    return to;
}
template <std::size_t count>
constexpr std::array<LineStyle, count> constants(const frame::LineStyle (&from)[count]) {
    std::array<LineStyle, count> to{};
    for (std::size_t i = 0; i < count; ++i) to[i] = constant(from[i]);
    return to;
}
constexpr auto plain_lines = constants(frame::presets::plain_lines);
constexpr auto silhouette_lines = constants(frame::presets::silhouette_lines);
constexpr auto xray_lines = constants(frame::presets::xray_lines);
constexpr auto woodcut_lines = constants(frame::presets::woodcut_lines);
constexpr auto scientific_lines = constants(frame::presets::scientific_lines);
constexpr auto sketch_lines = constants(frame::presets::sketch_lines);
constexpr auto blueprint_lines = constants(frame::presets::blueprint_lines);
constexpr auto archaeological_contours = constants(frame::presets::archaeological_contours);

std::span<const LineStyle> preset_line_styles(std::uint32_t preset) noexcept {
    switch (preset) {
    case HRBFNPR_PRESET_STIPPLE: return {};
    case HRBFNPR_PRESET_SILHOUETTE: return silhouette_lines;
    case HRBFNPR_PRESET_XRAY: return xray_lines;
    case HRBFNPR_PRESET_WOODCUT: return woodcut_lines;
    case HRBFNPR_PRESET_SCIENTIFIC_STIPPLE: return scientific_lines;
    case HRBFNPR_PRESET_SKETCH: return sketch_lines;
    case HRBFNPR_PRESET_BLUEPRINT: return blueprint_lines;
    case HRBFNPR_PRESET_ARCHAEOLOGICAL: return archaeological_contours;
    default: return plain_lines;
    }
}

constexpr GivenLayer constant(const frame::LayerStyle& from) {
    GivenLayer to{};
    to.struct_size = sizeof to;
    to.kind = static_cast<std::uint32_t>(from.kind);
    to.name = from.name;
    to.shown = from.shown ? 1 : 0;
    to.contours = from.contours ? 1 : 0;
    to.directions = from.directions;
    to.shape = static_cast<std::uint32_t>(from.shape);
    to.share = from.share;
    to.radius = from.radius;
    to.radius_zoom = from.radius_zoom;
    for (std::size_t i = 0; i < 4; ++i) to.ink[i] = from.ink[i];
    to.hatch_tone_begin = from.hatch_tone_begin;
    to.hatch_tone_end = from.hatch_tone_end;
    to.hatch_coverage_begin = from.hatch_coverage_begin;
    to.hatch_coverage_end = from.hatch_coverage_end;
    to.hatch_spacing = from.hatch_spacing;
    to.hatch_pen = from.hatch_pen;
    to.hatch_white = from.hatch_white;
    to.hatch_taper = from.hatch_taper;
    to.hatch_shortest = from.hatch_shortest;
    to.hatch_wobble = from.hatch_wobble;
    to.hatch_overshoot = from.hatch_overshoot;
    to.hatch_seed = from.hatch_seed;
    return to;
}
template <std::size_t count>
constexpr std::array<GivenLayer, count> constants(const frame::LayerStyle (&from)[count]) {
    std::array<GivenLayer, count> to{};
    for (std::size_t i = 0; i < count; ++i) to[i] = constant(from[i]);
    return to;
}
constexpr auto stipple = constants(frame::presets::stipple_layers);
constexpr auto hatch = constants(frame::presets::hatch_layers);
constexpr auto cross_hatch_styles = constants(frame::presets::cross_hatch_layers);
constexpr auto combing_styles = constants(frame::presets::combing_layers);
constexpr auto contours = constants(frame::presets::contour_layers);
constexpr auto contour_and_stipple = constants(frame::presets::contour_and_stipple_layers);
constexpr auto full = constants(frame::presets::full_layers);
constexpr auto engraving_styles = constants(frame::presets::engraving_layers);
constexpr auto etching_styles = constants(frame::presets::etching_layers);
constexpr auto woodcut = constants(frame::presets::woodcut_layers);
constexpr auto scientific_styles = constants(frame::presets::scientific_layers);
constexpr auto sketch = constants(frame::presets::sketch_layers);
constexpr auto blueprint = constants(frame::presets::blueprint_layers);
constexpr auto archaeological_styles = constants(frame::presets::archaeological_layers);

std::span<const GivenLayer> preset_layer_styles(std::uint32_t preset) noexcept {
    switch (preset) {
    case HRBFNPR_PRESET_STIPPLE: return stipple;
    case HRBFNPR_PRESET_HATCH: return hatch;
    case HRBFNPR_PRESET_CROSS_HATCH: return cross_hatch_styles;
    case HRBFNPR_PRESET_COMBING: return combing_styles;
    case HRBFNPR_PRESET_CONTOUR_AND_STIPPLE: return contour_and_stipple;
    case HRBFNPR_PRESET_FULL: return full;
    case HRBFNPR_PRESET_ENGRAVING: return engraving_styles;
    case HRBFNPR_PRESET_ETCHING: return etching_styles;
    case HRBFNPR_PRESET_WOODCUT: return woodcut;
    case HRBFNPR_PRESET_SCIENTIFIC_STIPPLE: return scientific_styles;
    case HRBFNPR_PRESET_SKETCH: return sketch;
    case HRBFNPR_PRESET_BLUEPRINT: return blueprint;
    case HRBFNPR_PRESET_ARCHAEOLOGICAL: return archaeological_styles;
    default: return contours;
    }
}

Style from_style(const frame::Style& from) noexcept {
    Style to{};
    style_fields().set_defaults(from, to);
    return to;
}

} // namespace

template <>
hrbfnpr_style defaults() noexcept {
    return from_style(frame::Style{});
}

template <>
hrbfnpr_layer_style defaults() noexcept {
    return constant(frame::LayerStyle{});
}

template <>
hrbfnpr_line_style defaults() noexcept {
    return constant(frame::LineStyle{});
}

frame::Style checked_style(const hrbfnpr_style& style, const char* owner, base::Array<frame::LayerStyle>& layers,
                           base::Array<frame::LineStyle>& lines) {
    style_fields().check(owner, style);
    check_between_fields(style, owner);
    add_layers(style, owner, layers);
    add_lines(style, owner, lines);
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

hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size) {
    return api::init_struct(style, struct_size);
}

hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size, uint32_t preset,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::require_pointer(style, "style");
        api::check_struct_size<hrbfnpr_style>(struct_size, "style");
        if (preset >= frame::preset_count)
            fail(Status::invalid_argument, "preset is %u; it must be one of HRBFNPR_PRESET_... (0 to %d)", preset,
                 static_cast<int>(frame::preset_count) - 1);
        style->struct_size = struct_size;
        hrbfnpr_style full = api::from_style(frame::preset(preset).style);
        const std::span<const hrbfnpr_layer_style> layers = api::preset_layer_styles(preset);
        full.layers = layers.data();
        full.layer_count = static_cast<int64_t>(layers.size());
        const std::span<const hrbfnpr_line_style> lines = api::preset_line_styles(preset);
        full.lines = lines.data();
        full.line_count = static_cast<int64_t>(lines.size());
        api::write_struct(style, full);
    });
}

const char* hrbfnpr_preset_name(uint32_t preset) {
    return preset < frame::preset_count ? frame::preset_name(preset) : nullptr;
}

} // extern "C"
