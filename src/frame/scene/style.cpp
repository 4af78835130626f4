#include "frame/scene/style.h"

#include <cstring>

namespace hrbfnpr::frame {
namespace {

using marks::Kind;

constexpr std::array<const char*, preset_count> names{
    "stipple", "hatch", "cross-hatch", "combing", "silhouette", "contour-and-stipple", "xray", "full"};

constexpr std::array stipples{Kind::stipples};
constexpr std::array with_principal{Kind::stipples, Kind::principal};
constexpr std::array with_combing{Kind::stipples, Kind::combing};

constexpr LayerStyle shown(Kind kind, float radius = 1.0F) {
    LayerStyle style;
    style.kind = kind;
    style.radius = radius;
    return style;
}
constexpr LayerStyle hidden(Kind kind) {
    LayerStyle style;
    style.kind = kind;
    style.shown = false;
    return style;
}
constexpr LayerStyle without_contours(LayerStyle style) {
    style.contours = false;
    return style;
}
constexpr LayerStyle along(LayerStyle style, std::uint32_t directions) {
    style.directions = directions;
    return style;
}
constexpr LayerStyle sharing(LayerStyle style, float share) {
    style.share = share;
    return style;
}

// Contours come from every layer that there is: the more marks, the crisper they are.
constexpr float contour_radius = 1.2F;
constexpr float plain_radius = 1.1F;

// Without contours the stipples themselves must reach the rim.
constexpr std::array stipple_layers{
    without_contours(shown(Kind::stipples, plain_radius)), without_contours(hidden(Kind::principal)),
    without_contours(hidden(Kind::combing)), without_contours(hidden(Kind::field)),
    without_contours(shown(Kind::any))};
constexpr std::array hatch_layers{hidden(Kind::stipples), along(shown(Kind::principal, plain_radius), 2),
                                  hidden(Kind::combing), along(shown(Kind::field, plain_radius), 1)};
constexpr std::array cross_hatch_layers{hidden(Kind::stipples), shown(Kind::principal, plain_radius),
                                        hidden(Kind::combing), shown(Kind::field, plain_radius)};
constexpr std::array combing_layers{hidden(Kind::stipples), hidden(Kind::principal),
                                    shown(Kind::combing, plain_radius), hidden(Kind::field)};
constexpr std::array contour_layers{hidden(Kind::any)};
constexpr std::array contour_and_stipple_layers{shown(Kind::stipples), hidden(Kind::principal), hidden(Kind::combing),
                                                hidden(Kind::field)};
// Strokes stay in the darker parts, stipples go on into the light.
constexpr std::array full_layers{shown(Kind::stipples), sharing(shown(Kind::principal), 0.6F), hidden(Kind::combing),
                                 sharing(shown(Kind::field), 0.6F)};

constexpr LayerStyle default_layer{};

} // namespace

bool LayerStyle::is_for(const marks::Layer& layer) const noexcept {
    return (kind == Kind::any || kind == layer.kind) && (name == nullptr || std::strcmp(name, layer.name.data()) == 0);
}

const LayerStyle& Style::of(const marks::Layer& layer) const noexcept {
    for (const LayerStyle& style : layers)
        if (style.is_for(layer)) return style;
    return default_layer;
}

const char* preset_name(std::uint32_t number) noexcept { return number < preset_count ? names[number] : nullptr; }

Preset preset(std::uint32_t number) noexcept {
    Preset preset{preset_name(number), stipples, Style{}};
    Style& style = preset.style;
    style.silhouette_radius = contour_radius;
    switch (number) {
    case 0: // stipple
        style.layers = stipple_layers;
        style.silhouette_threshold = 0.05;
        break;
    case 1: // hatch
        preset.drawn = with_principal;
        style.layers = hatch_layers;
        break;
    case 2: // cross-hatch
        preset.drawn = with_principal;
        style.layers = cross_hatch_layers;
        break;
    case 3: // combing
        preset.drawn = with_combing;
        style.layers = combing_layers;
        break;
    case 4: // silhouette
        style.layers = contour_layers;
        // A depth layer or two of surface leave hidden contours visible, but pale.
        style.attenuation_front = 0.2;
        style.attenuation_back = 0.1;
        break;
    case 5: // contour-and-stipple
        style.layers = contour_and_stipple_layers;
        break;
    case 6: // xray
        style.layers = contour_layers;
        style.hidden_lines = HiddenLines::show;
        break;
    default: // full
        preset.drawn = with_principal;
        style.layers = full_layers;
        style.halo_width = 4.0F;
        break;
    }
    return preset;
}

} // namespace hrbfnpr::frame
