// SPDX-License-Identifier: MIT
// A style in the form that the frame uses. It has already been checked. Every field has the same meaning as in
// hrbfnpr_style. [NPAR 6]
#pragma once

#include "drawing/dot.h"
#include "features/line_set.h"
#include "geometry/vec.h"
#include "marks/point_set.h"

#include <cstdint>
#include <cstring>
#include <span>

namespace hrbfnpr::frame {

enum class HiddenLines : std::uint32_t { attenuate = 0, hide = 1, show = 2 };
enum class Visibility : std::uint32_t { depth_layers = 0, published = 1 };
enum class ToneCurve : std::uint32_t { coverage = 0, linear = 1 };
enum class Tone : std::uint32_t { none = 0, light = 1, callback = 2 };
enum class ToneRule : std::uint32_t { share = 0, published = 1 };
enum class LightSpace : std::uint32_t { world = 0, camera = 1, item = 2 };
enum class LightKind : std::uint32_t { directional = 0, place = 1 };
using ToneFn = std::int32_t (*)(void* user, std::int64_t count, const float* positions, const float* normals,
                                float* tau);

enum class Shape : std::uint32_t { dots = 0, strokes = 1, hatch = 2 };

enum class Evenness : std::uint32_t { picture = 0, surface = 1 };

enum class FieldRule : std::uint32_t { replace = 0, scale = 1 };
enum class PaletteRule : std::uint32_t { nearest = 0, mixed = 1 };

using curves::LineKind;

struct LayerStyle {
    marks::Kind kind = marks::Kind::any; // the kind of layers that this style applies to
    const char* name = nullptr;          // the name of layers that this style applies to; NULL: any name
    bool shown = true;
    bool contours = true;
    std::uint32_t directions = 3;
    Shape shape = Shape::dots;
    float share = 1.0F;
    float radius = 1.0F;
    float radius_zoom = 0.0F;
    float ink[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    float hatch_tone_begin = 0.15F;
    float hatch_tone_end = 0.95F;
    float hatch_coverage_begin = 0.1F;
    float hatch_coverage_end = 0.82F;
    float hatch_spacing = 4.6F;
    float hatch_pen = 0.6F;
    float hatch_white = 1.2F;
    float hatch_taper = 20.0F;
    float hatch_shortest = 10.0F;
    float hatch_wobble = 0.0F;
    float hatch_overshoot = 0.0F;
    std::uint32_t hatch_seed = 0;
    const char* density_field = nullptr; // names of fields of the set; NULL: none
    const char* tone_field = nullptr;
    const char* width_field = nullptr;
    const char* ink_field = nullptr;
    const char* mask_field = nullptr;
    FieldRule tone_field_rule = FieldRule::replace;
    PaletteRule palette_rule = PaletteRule::nearest;
    float hatch_fade = 0.0F;

    // Returns the range of darkness over which lines of hatching end.
    [[nodiscard]] float hatch_lights() const noexcept { return std::min(hatch_fade, hatch_tone_begin); }
    // Returns the darkness at which the last lines of hatching end.
    [[nodiscard]] float hatch_least() const noexcept { return hatch_tone_begin - hatch_lights(); }

    [[nodiscard]] bool is_for(const marks::Layer& layer) const noexcept {
        return (kind == marks::Kind::any || kind == layer.kind) &&
               (name == nullptr || std::strcmp(name, layer.name.data()) == 0);
    }
};

enum class HiddenParts : std::uint32_t { none = 0, attenuated = 1, dashed = 2, shown = 3 };

// The style of one kind of lines. Every field has the same meaning as in hrbfnpr_line_style.
struct LineStyle {
    LineKind kind = LineKind::contour;
    // The style applies to lines with this name, which were found once for the line set. NULL: any name.
    const char* name = nullptr;
    HiddenParts hidden = HiddenParts::none;
    drawing::Cap cap = drawing::Cap::round; // the shape of free ends
    float width = 2.0F;
    float taper = 12.0F;
    float hidden_width = 1.2F;
    float hidden_opacity = 0.35F;
    float dash = 5.0F;
    float gap = 3.0F;
    float shortest = 2.0F;
    float fade = 1.0F;
    double lower = 0.0, upper = 0.0;
    std::span<const double> levels; // the n . l of each isophote
    float ink[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    float outline_factor = 1.0F;
    float far_factor = 1.0F;
    float lit_factor = 1.0F;
    float curvature_factor = 1.0F;
    float curvature_radius = 0.1F;
    float wobble = 0.0F;
    float wobble_width = 0.0F;
    float wobble_length = 40.0F;
    std::uint32_t wobble_seed = 0;
    curves::CreaseSide creases = curves::CreaseSide::both;

    [[nodiscard]] bool wobbles() const noexcept { return wobble > 0.0F || wobble_width > 0.0F; }
};

// A light of a style. Every field has the same meaning as in hrbfnpr_light.
struct LightStyle {
    LightKind kind = LightKind::directional;
    LightSpace space = LightSpace::camera;
    glm::dvec3 place{-0.4, 0.6, 0.7};
    float intensity = 1.0F;
    float shadow = 0.0F;
    float softness = 0.0F;
};
inline constexpr std::int64_t most_lights = 8;
inline constexpr std::int64_t most_inks = 8;

struct Style {
    HiddenLines hidden_lines = HiddenLines::attenuate;
    double silhouette_threshold = 0.2;
    double attenuation_front = 1.0;
    double attenuation_back = 1.0;
    float splat_radius = 0.0F;
    float halo_width = 2.0F;
    float splat_overlap = 8.0F;
    Visibility visibility = Visibility::depth_layers;
    Tone tone = Tone::light;
    ToneRule tone_rule = ToneRule::share;
    LightSpace light_space = LightSpace::camera;
    ToneCurve tone_curve = ToneCurve::coverage;
    Evenness evenness = Evenness::picture;
    bool verify_lines = false; // whether rays are compared with the parts of lines, which are then repaired
    float tone_fade = 0.25F;
    glm::dvec3 light{-0.4, 0.6, 0.7};
    double tone_exponent = 1.0;
    float fill_light = 0.25F;
    float light_intensity = 1.0F;
    float light_shadow = 0.0F;
    float light_softness = 0.0F;
    std::span<const LightStyle> lights; // The caller owns the list. Empty: one light with the fields above.
    float ambient_sky = 0.0F;
    float ambient_ground = 0.0F;
    glm::dvec3 ambient_up{0.0, 1.0, 0.0};
    float occlusion = 1.0F;
    float occlusion_exponent = 1.5F;
    float occlusion_lights = 0.0F;
    float rim_light = 0.0F;
    float rim_exponent = 3.0F;
    float tone_black = 0.0F;
    float tone_white = 1.0F;
    float tone_gamma = 1.0F;
    std::uint32_t tone_steps = 0;
    float curvature_contrast = 0.0F;
    ToneFn tone_function = nullptr;
    void* tone_user = nullptr;
    double depth_min = 0.0;
    double depth_max = 0.0;
    double zoom_reference = 0.0;
    double zoom_exponent = 2.0;
    glm::vec4 paper{1.0F};
    glm::vec4 silhouette_ink{0.0F, 0.0F, 0.0F, 1.0F};
    float silhouette_radius = 1.0F;
    float silhouette_radius_zoom = 0.0F;
    std::span<const LayerStyle> layers; // The caller owns both lists.
    std::span<const LineStyle> lines;
    std::span<const glm::vec4> palette; // The caller owns the inks.

    // Returns the light that isophotes and widths of lines use.
    [[nodiscard]] LightStyle key_light() const noexcept {
        if (!lights.empty()) return lights.front();
        return {LightKind::directional, light_space, light, light_intensity, light_shadow, light_softness};
    }
    // Returns the first style that applies to the layer, or the default style.
    [[nodiscard]] const LayerStyle& of(const marks::Layer& layer) const noexcept {
        static constexpr LayerStyle default_layer{};
        for (const LayerStyle& style : layers)
            if (style.is_for(layer)) return style;
        return default_layer;
    }
};

} // namespace hrbfnpr::frame
