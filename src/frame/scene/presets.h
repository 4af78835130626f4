// SPDX-License-Identifier: MIT
// How the named styles draw layers: constants, so that the boundary can show them.
#pragma once

#include "frame/scene/style.h"

namespace hrbfnpr::frame::presets {

using marks::Kind;

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
constexpr float plain_radius = 1.1F;

// Without contours the stipples themselves must reach the rim.
constexpr LayerStyle stipple_layers[] = {
    without_contours(shown(Kind::stipples, plain_radius)), without_contours(hidden(Kind::principal)),
    without_contours(hidden(Kind::combing)), without_contours(hidden(Kind::field)), without_contours(shown(Kind::any))};
constexpr LayerStyle hatch_layers[] = {hidden(Kind::stipples), along(shown(Kind::principal, plain_radius), 2),
                                       hidden(Kind::combing), along(shown(Kind::field, plain_radius), 1)};
constexpr LayerStyle cross_hatch_layers[] = {hidden(Kind::stipples), shown(Kind::principal, plain_radius),
                                             hidden(Kind::combing), shown(Kind::field, plain_radius)};
constexpr LayerStyle combing_layers[] = {hidden(Kind::stipples), hidden(Kind::principal),
                                         shown(Kind::combing, plain_radius), hidden(Kind::field)};
constexpr LayerStyle contour_layers[] = {hidden(Kind::any)};
constexpr LayerStyle contour_and_stipple_layers[] = {shown(Kind::stipples), hidden(Kind::principal),
                                                     hidden(Kind::combing), hidden(Kind::field)};
// Strokes stay in the darker parts, stipples go on into the light.
constexpr LayerStyle full_layers[] = {shown(Kind::stipples), sharing(shown(Kind::principal), 0.6F),
                                      hidden(Kind::combing), sharing(shown(Kind::field), 0.6F)};

// For a picture of 800 pixels, as the other pens are.  From the fewest dark lines to the most, in pixels and shares.
constexpr LayerStyle lines_by_tone(const char* name, float begin, float end, float coverage) {
    LayerStyle style;
    style.kind = Kind::hatch;
    style.name = name;
    style.shape = Shape::hatch;
    style.contours = false;
    style.hatch_tone_begin = begin;
    style.hatch_tone_end = end;
    style.hatch_coverage_end = coverage;
    style.hatch_spacing = 2.8F;
    style.hatch_pen = 0.45F;
    style.hatch_white = 0.8F;
    style.hatch_taper = 12.0F;
    style.hatch_shortest = 7.0F;
    return style;
}
constexpr LayerStyle bold(LayerStyle style) {
    style.hatch_spacing = 5.0F;
    style.hatch_pen = 0.9F;
    style.hatch_white = 0.0F;
    style.hatch_taper = 20.0F;
    style.hatch_shortest = 12.0F;
    return style;
}
// Stipples are not seen: they tell where the surface is.  Illustrators leave highlights empty, and cross their lines
// at 30 to 60 degrees.
constexpr LayerStyle engraving_layers[] = {lines_by_tone(nullptr, 0.15F, 0.95F, 0.78F), hidden(Kind::any)};
constexpr LayerStyle etching_layers[] = {lines_by_tone("hatch-1", 0.15F, 0.55F, 0.36F),
                                         lines_by_tone("hatch-2", 0.40F, 0.75F, 0.36F),
                                         lines_by_tone("hatch-3", 0.66F, 0.92F, 0.36F), hidden(Kind::any)};
constexpr LayerStyle woodcut_layers[] = {bold(lines_by_tone(nullptr, 0.22F, 0.75F, 1.0F)), hidden(Kind::any)};

// Of items that have a line set: in the place of contours that marks draw.
constexpr LineStyle contour_line(float width, HiddenParts hidden) {
    LineStyle style;
    style.width = width;
    style.hidden = hidden;
    return style;
}
constexpr LineStyle outlined(LineStyle style, float factor) {
    style.outline_factor = factor;
    return style;
}
constexpr LineStyle plain_lines[] = {contour_line(2.2F, HiddenParts::none)};
// Where there are lines alone, those that bound the drawing are heavier.
constexpr LineStyle silhouette_lines[] = {outlined(contour_line(2.2F, HiddenParts::attenuated), 1.5F)};
constexpr LineStyle woodcut_lines[] = {outlined(contour_line(3.6F, HiddenParts::none), 1.5F)};
constexpr LineStyle xray_lines[] = {outlined(contour_line(2.0F, HiddenParts::dashed), 1.5F)};

// By the number of the preset; stippling alone has none.
constexpr std::span<const LineStyle> lines_of(std::uint32_t preset) {
    switch (preset) {
    case 0: return {};
    case 4: return silhouette_lines;
    case 6: return xray_lines;
    case 10: return woodcut_lines;
    default: return plain_lines;
    }
}

} // namespace hrbfnpr::frame::presets
