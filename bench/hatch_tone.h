// SPDX-License-Identifier: MIT
// The tone of hatching against the tone that its style asks for: one, two and three sets of lines, at three zooms, on a
// plane with a ramp of tones and on a lit sphere.  Both are averaged over Gaussian windows; sigma is twice the closest
// spacing of lines, or one separation of the finest lines if that is larger.  A set is asked to cover the share c of
// the paper, which falls to 0 over hatch_fade below hatch_tone_begin; crossing sets are together asked to cover 1 -
// prod(1 - c).
#pragma once

#include "analytic.h"
#include "hatch_pictures.h"
#include "tone_windows.h"

#include <cstdio>

namespace bench {

inline constexpr int tone_size = 800;

// Returns the darkness of the plane, which increases from one corner of [-1, 1]^2 to the other.
[[nodiscard]] inline double ramp_darkness(double x, double y) {
    return std::clamp(0.5 + 0.5 * (x + 0.3 * y) / 1.3, 0.0, 1.0);
}
inline std::int32_t ramp_tones(void*, std::int64_t count, const float* positions, const float*, float* tau) {
    for (std::int64_t i = 0; i < count; ++i)
        tau[i] = static_cast<float>(
            1.0 - ramp_darkness(static_cast<double>(positions[3 * i]), static_cast<double>(positions[3 * i + 1])));
    return 0;
}

// Returns the share of the paper that a set of lines should cover.
[[nodiscard]] inline double asked_of(const hrbfnpr_layer_style& layer, double darkness) {
    constexpr double exponent = 1.1;
    const auto begin = static_cast<double>(layer.hatch_tone_begin);
    const auto low = static_cast<double>(layer.hatch_coverage_begin);
    if (darkness < begin) {
        const double fade = std::min(static_cast<double>(layer.hatch_fade), begin);
        const double left = fade > 0.0 ? std::max(1.0 - (begin - darkness) / fade, 0.0) : 0.0;
        return static_cast<double>(layer.share) * low * left;
    }
    const double at = std::min((darkness - begin) / (static_cast<double>(layer.hatch_tone_end) - begin), 1.0);
    return static_cast<double>(layer.share) *
           (low + (static_cast<double>(layer.hatch_coverage_end) - low) * std::pow(at, exponent));
}
// `layers`: the number of sets that exist; further sets of the style draw nothing.
[[nodiscard]] inline double asked_of(const Style& style, int layers, double darkness) {
    double white = 1.0;
    for (const hrbfnpr_layer_style& layer : style.layer)
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH && layers-- > 0) white *= 1.0 - asked_of(layer, darkness);
    return 1.0 - white;
}

// A surface seen from above along -z, in parallel projection.
struct ToneSurface {
    const char* name;
    hrbfnpr_implicit_fn function;
    Vec3 half;
    double view;                                      // height of the picture at zoom 1
    std::vector<glm::dvec2> places;                   // the middles of the pictures at zooms above 1
    bool (*shows)(double x, double y);                // whether a pixel there counts
    double (*darkness)(const Style&, double, double); // the darkness of the surface there
};

[[nodiscard]] inline double lit_darkness(const Style& style, double x, double y) {
    const glm::dvec3 n(x, y, std::sqrt(std::max(1.0 - x * x - y * y, 0.0)));
    const double lit = std::clamp(glm::dot(n, glm::normalize(glm::make_vec3(style.light))), 0.0, 1.0);
    return 1.0 - std::pow(lit, static_cast<double>(style.tone_exponent));
}

[[nodiscard]] inline std::vector<ToneSurface> tone_surfaces() {
    const std::vector<glm::dvec2> along_the_ramp{{-0.65, -0.2}, {0.0, 0.0}, {0.65, 0.2}};
    const std::vector<glm::dvec2> away_from_the_light{{-0.4, 0.4}, {0.0, 0.0}, {0.3, -0.4}};
    return {{"plane",
             plane,
             {1.2, 1.2, 0.4},
             2.0,
             along_the_ramp,
             [](double x, double y) { return std::abs(x) < 1.0 && std::abs(y) < 1.0; },
             [](const Style&, double x, double y) { return ramp_darkness(x, y); }},
            // n . v is 0.3 at the rim.
            {"sphere",
             sphere,
             {1.2, 1.2, 1.2},
             2.2,
             away_from_the_light,
             [](double x, double y) { return x * x + y * y < 0.91; },
             lit_darkness}};
}

[[nodiscard]] inline hrbfnpr_camera camera_above(const glm::dvec2& place, double view) {
    scenes::Check check;
    auto camera = scenes::made(hrbfnpr_camera_init);
    const Vec3 eye{place.x, place.y, 5.0};
    const Vec3 target{place.x, place.y, 0.0};
    const Vec3 up{0.0, 1.0, 0.0};
    check(hrbfnpr_camera_look_at(&camera, eye.data(), target.data(), up.data(), check.error()));
    check(hrbfnpr_camera_orthographic(&camera, view, tone_size, tone_size, 1.0, 10.0, check.error()));
    return camera;
}

[[nodiscard]] inline ToneImage asked_image(const ToneSurface& surface, const Style& style, int layers,
                                           const glm::dvec2& place, double view) {
    ToneImage asked{tone_size, tone_size, {}, {}};
    for (int row = 0; row < tone_size; ++row)
        for (int column = 0; column < tone_size; ++column) {
            const double x = place.x + ((column + 0.5) / tone_size - 0.5) * view;
            const double y = place.y - ((row + 0.5) / tone_size - 0.5) * view;
            asked.counts.push_back(surface.shows(x, y));
            asked.share.push_back(asked.counts.back()
                                      ? static_cast<float>(asked_of(style, layers, surface.darkness(style, x, y)))
                                      : 0.0F);
        }
    return asked;
}

[[nodiscard]] inline Style tone_style(const ToneSurface& surface, std::uint32_t preset) {
    Style style = hatch_style(preset, tone_size);
    style.line_count = 0; // no contours
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.light_space = HRBFNPR_LIGHT_WORLD;
    for (hrbfnpr_layer_style& layer : style.layer)
        for (int c = 0; c < 4; ++c) layer.ink[c] = c == 3 ? 1.0F : 0.0F;
    if (surface.function == plane) {
        style.tone = HRBFNPR_TONE_CALLBACK;
        style.tone_function = ramp_tones;
    }
    return style;
}

// The worst figures of all rows.
struct ToneFigures {
    double psnr = 1e9, bias = 0.0;
};

// Measures one surface with `layers` sets of lines.
inline void run_tone(hrbfnpr_context* context, const ToneSurface& surface, int layers, ToneFigures& worst) {
    const std::uint32_t preset = layers == 1 ? HRBFNPR_PRESET_ENGRAVING : HRBFNPR_PRESET_ETCHING;
    const scenes::Model model = custom(context, surface.function, surface.half);
    const scenes::PointSet set = hatch_set(context, model.get(), preset, layers);
    const Style style = tone_style(surface, preset);
    const double separation = layer_info(set.get(), 1).step;
    StrokePainter painter(context, set.get(), style);
    for (const double zoom : {0.5, 1.0, 3.0}) {
        const double view = surface.view / zoom;
        const double spacing = static_cast<double>(style.layer[0].hatch_spacing);
        const double sigma = std::max(2.0 * spacing, separation * tone_size / view);
        ToneSums sums;
        const auto places = zoom > 1.0 ? surface.places : std::vector<glm::dvec2>{{0.0, 0.0}};
        for (const glm::dvec2& place : places) {
            painter.draw(camera_above(place, view));
            const ToneImage drawn{tone_size, tone_size, painter.coverage(tone_size, tone_size), {}};
            sums.add(compare_tones(drawn, asked_image(surface, style, layers, place, view), sigma));
        }
        std::printf("%-8s %6d %6.1f %8.1f %9.0f %9.2f %+9.4f\n", surface.name, layers, zoom, sigma, sums.number,
                    sums.psnr(), sums.bias());
        std::fflush(stdout);
        worst.psnr = std::min(worst.psnr, sums.psnr());
        if (std::abs(sums.bias()) > std::abs(worst.bias)) worst.bias = sums.bias();
    }
}

[[nodiscard]] inline ToneFigures hatch_tones(hrbfnpr_context* context) {
    std::printf("\nthe paper covered by lines beside what their style asks for; %d pixels\n", tone_size);
    std::printf("%-8s %6s %6s %8s %9s %9s %9s\n", "surface", "sets", "zoom", "sigma px", "pixels", "psnr dB", "bias");
    ToneFigures worst;
    for (const ToneSurface& surface : tone_surfaces())
        for (const int layers : {1, 2, 3}) run_tone(context, surface, layers, worst);
    return worst;
}

} // namespace bench
