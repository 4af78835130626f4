// SPDX-License-Identifier: MIT
#include "frame/scene/style.h"

#include "frame/scene/presets.h"

#include <cstring>

namespace hrbfnpr::frame {
namespace {

constexpr std::array<const char*, preset_count> names{
    "stipple", "hatch",     "cross-hatch",   "combing", "silhouette", "contour-and-stipple",
    "xray",    "full",      "engraving",     "etching", "woodcut",    "scientific-stipple",
    "sketch",  "blueprint", "archaeological"};

constexpr LayerStyle default_layer{};

} // namespace

bool LayerStyle::is_for(const marks::Layer& layer) const noexcept {
    return (kind == marks::Kind::any || kind == layer.kind) &&
           (name == nullptr || std::strcmp(name, layer.name.data()) == 0);
}

const LayerStyle& Style::of(const marks::Layer& layer) const noexcept {
    for (const LayerStyle& style : layers)
        if (style.is_for(layer)) return style;
    return default_layer;
}

const char* preset_name(std::uint32_t number) noexcept { return number < preset_count ? names[number] : nullptr; }

Preset preset(std::uint32_t number) noexcept {
    Preset preset{preset_name(number), Style{}};
    Style& style = preset.style;
    style.silhouette_radius = 1.2F;
    style.lines = presets::lines_of(number);
    switch (number) {
    case 0: // stipple
        style.layers = presets::stipple_layers;
        style.silhouette_threshold = 0.05;
        break;
    case 1: // hatch
        style.layers = presets::hatch_layers;
        break;
    case 2: // cross-hatch
        style.layers = presets::cross_hatch_layers;
        break;
    case 3: // combing
        style.layers = presets::combing_layers;
        break;
    case 4: // silhouette
        style.layers = presets::contour_layers;
        // A depth layer or two of surface leave hidden contours visible, but pale.
        style.attenuation_front = 0.2;
        style.attenuation_back = 0.1;
        break;
    case 5: // contour-and-stipple
        style.layers = presets::contour_and_stipple_layers;
        break;
    case 6: // xray
        style.layers = presets::contour_layers;
        style.hidden_lines = HiddenLines::show;
        break;
    case 7: // full
        style.layers = presets::full_layers;
        style.halo_width = 4.0F;
        break;
    case 8: // engraving
        style.layers = presets::engraving_layers;
        style.hidden_lines = HiddenLines::hide;
        break;
    case 9: // etching
        style.layers = presets::etching_layers;
        style.hidden_lines = HiddenLines::hide;
        break;
    case 10: // woodcut
        style.layers = presets::woodcut_layers;
        style.hidden_lines = HiddenLines::hide;
        break;
    case 11: // scientific-stipple
        style.layers = presets::scientific_layers;
        style.light = presets::upper_left;
        style.tone_exponent = 0.8;
        style.silhouette_radius = 0.8F;
        break;
    case 12: // sketch
        style.layers = presets::sketch_layers;
        style.hidden_lines = HiddenLines::hide;
        style.paper = presets::warm_paper;
        style.silhouette_ink = {presets::graphite[0], presets::graphite[1], presets::graphite[2], 1.0F};
        style.halo_width = 0.0F;
        break;
    case 13: // blueprint
        style.layers = presets::blueprint_layers;
        style.paper = presets::blue_paper;
        style.silhouette_ink = {presets::chalk[0], presets::chalk[1], presets::chalk[2], 1.0F};
        style.attenuation_front = 0.2;
        style.attenuation_back = 0.1;
        break;
    default: // archaeological
        style.layers = presets::archaeological_layers;
        style.light = presets::upper_left;
        style.hidden_lines = HiddenLines::hide;
        break;
    }
    return preset;
}

} // namespace hrbfnpr::frame
