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
constexpr LayerStyle as_lines(LayerStyle style) {
    style.shape = Shape::strokes;
    return style;
}
constexpr LayerStyle sharing(LayerStyle style, float share) {
    style.share = share;
    return style;
}

// sRGB.
inline constexpr float graphite[] = {0.20F, 0.20F, 0.22F};
inline constexpr float chalk[] = {0.91F, 0.95F, 1.0F};
inline constexpr glm::vec4 warm_paper{0.98F, 0.96F, 0.915F, 1.0F};
inline constexpr glm::vec4 blue_paper{0.09F, 0.25F, 0.47F, 1.0F};
// From the upper left, at 45 degrees, as scientific drawings have it.
inline constexpr glm::dvec3 upper_left{-0.5, 0.5, 0.7071067811865476};

// Contours come from every layer that there is: the more marks, the crisper they are.
constexpr float plain_radius = 1.1F;

// Without contours the stipples themselves must reach the rim.
constexpr LayerStyle stipple_layers[] = {
    without_contours(shown(Kind::stipples, plain_radius)), without_contours(hidden(Kind::principal)),
    without_contours(hidden(Kind::combing)), without_contours(hidden(Kind::field)), without_contours(shown(Kind::any))};
constexpr LayerStyle contour_layers[] = {hidden(Kind::any)};
constexpr LayerStyle contour_and_stipple_layers[] = {shown(Kind::stipples), hidden(Kind::principal),
                                                     hidden(Kind::combing), hidden(Kind::field)};

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
    style.hatch_white = 0.68F;
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
// Lines of nearly one width: the darker the tone, the more of them there are.
constexpr LayerStyle by_number(LayerStyle style, float pen, float spacing) {
    style.hatch_pen = pen;
    style.hatch_spacing = spacing;
    style.hatch_taper = 8.0F;
    style.hatch_shortest = 8.0F;
    return style;
}
constexpr LayerStyle covering(LayerStyle style, float begin) {
    style.hatch_coverage_begin = begin;
    return style;
}
// The sets of crossed lines begin where the one before is full, at angles of 30 to 65 degrees to each other.
constexpr LayerStyle crossed(const char* name, float begin, float end, float coverage) {
    return covering(by_number(lines_by_tone(name, begin, end, coverage), 0.6F, 2.6F), 0.09F);
}

// Lines of hatching, and strokes of marks where a point set has these, as published.
constexpr LayerStyle hatch_layers[] = {hidden(Kind::stipples), along(shown(Kind::principal, plain_radius), 2),
                                       hidden(Kind::combing), along(shown(Kind::field, plain_radius), 1),
                                       by_number(lines_by_tone(nullptr, 0.12F, 0.95F, 0.42F), 0.8F, 1.9F)};
constexpr LayerStyle cross_hatch_layers[] = {hidden(Kind::stipples),
                                             shown(Kind::principal, plain_radius),
                                             hidden(Kind::combing),
                                             shown(Kind::field, plain_radius),
                                             crossed("hatch-1", 0.12F, 0.45F, 0.24F),
                                             crossed("hatch-2", 0.38F, 0.66F, 0.24F),
                                             crossed("hatch-3", 0.60F, 0.90F, 0.30F),
                                             crossed(nullptr, 0.12F, 0.90F, 0.30F)};
constexpr LayerStyle combing_layers[] = {hidden(Kind::stipples),
                                         hidden(Kind::principal),
                                         sharing(as_lines(shown(Kind::combing, 0.55F)), 0.7F),
                                         hidden(Kind::field),
                                         crossed("hatch-1", 0.10F, 0.60F, 0.32F),
                                         crossed("hatch-2", 0.50F, 0.92F, 0.34F),
                                         crossed(nullptr, 0.10F, 0.92F, 0.34F)};
// Stipples in the lights and between lines, lines in the darks.  Strokes stay in the darker parts.
constexpr LayerStyle full_layers[] = {sharing(shown(Kind::stipples, 0.7F), 0.45F),
                                      sharing(shown(Kind::principal), 0.6F),
                                      hidden(Kind::combing),
                                      sharing(shown(Kind::field), 0.6F),
                                      crossed("hatch-1", 0.40F, 0.75F, 0.34F),
                                      crossed("hatch-2", 0.62F, 0.95F, 0.34F),
                                      crossed(nullptr, 0.40F, 0.95F, 0.34F)};

// Stipples are not seen: they tell where the surface is.  Illustrators leave highlights empty, and cross their lines
// at 30 to 60 degrees.
constexpr LayerStyle engraving_layers[] = {lines_by_tone(nullptr, 0.15F, 0.95F, 0.74F), hidden(Kind::any)};
constexpr LayerStyle etching_layers[] = {lines_by_tone("hatch-1", 0.15F, 0.55F, 0.36F),
                                         lines_by_tone("hatch-2", 0.40F, 0.75F, 0.36F),
                                         lines_by_tone("hatch-3", 0.66F, 0.92F, 0.36F), hidden(Kind::any)};
constexpr LayerStyle woodcut_layers[] = {bold(lines_by_tone(nullptr, 0.22F, 0.75F, 1.0F)), hidden(Kind::any)};

// Fine even dots and clean lights, as in plates of zoology and botany.
constexpr LayerStyle scientific_layers[] = {sharing(shown(Kind::stipples, 0.6F), 0.85F), hidden(Kind::any)};

constexpr LayerStyle with_ink(LayerStyle style, float red, float green, float blue) {
    style.ink[0] = red;
    style.ink[1] = green;
    style.ink[2] = blue;
    return style;
}
constexpr LayerStyle pencilled(const char* name, float begin, float end, float coverage, std::uint32_t seed) {
    LayerStyle style = covering(lines_by_tone(name, begin, end, coverage), 0.08F);
    style.hatch_pen = 0.7F;
    style.hatch_spacing = 2.8F;
    style.hatch_white = 0.6F;
    style.hatch_taper = 4.0F;
    style.hatch_shortest = 9.0F;
    style.hatch_wobble = 1.2F;
    style.hatch_overshoot = 16.0F;
    style.hatch_seed = seed;
    return with_ink(style, graphite[0], graphite[1], graphite[2]);
}
constexpr LayerStyle sketch_layers[] = {
    pencilled("hatch-1", 0.20F, 0.70F, 0.26F, 1), pencilled("hatch-2", 0.50F, 0.92F, 0.28F, 2),
    pencilled(nullptr, 0.20F, 0.92F, 0.28F, 3), with_ink(hidden(Kind::any), graphite[0], graphite[1], graphite[2])};

constexpr LayerStyle blueprint_layers[] = {with_ink(hidden(Kind::any), chalk[0], chalk[1], chalk[2])};

// Lines are short, and thin away from the shade.
constexpr LayerStyle archaeological_lines(LayerStyle style) {
    style.hatch_taper = 26.0F;
    style.hatch_shortest = 6.0F;
    style.hatch_spacing = 3.2F;
    return style;
}
constexpr LayerStyle archaeological_layers[] = {
    archaeological_lines(covering(lines_by_tone(nullptr, 0.28F, 0.92F, 0.45F), 0.08F)), hidden(Kind::any)};

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
// Where a surface has creases: finer than its contours.
constexpr LineStyle crease_line(LineStyle style, float width) {
    style.kind = LineKind::crease;
    style.width = width;
    style.outline_factor = 1.0F;
    return style;
}
constexpr LineStyle plain_lines[] = {contour_line(2.2F, HiddenParts::none),
                                     crease_line(contour_line(2.2F, HiddenParts::none), 1.4F)};
// Where there are lines alone, those that bound the drawing are heavier.
constexpr LineStyle silhouette_line = outlined(contour_line(2.2F, HiddenParts::attenuated), 1.5F);
constexpr LineStyle silhouette_lines[] = {silhouette_line, crease_line(silhouette_line, 1.4F)};
constexpr LineStyle woodcut_line = outlined(contour_line(3.6F, HiddenParts::none), 1.5F);
constexpr LineStyle woodcut_lines[] = {woodcut_line, crease_line(woodcut_line, 2.4F)};
constexpr LineStyle xray_line = outlined(contour_line(2.0F, HiddenParts::dashed), 1.5F);
constexpr LineStyle xray_lines[] = {xray_line, crease_line(xray_line, 1.4F)};

constexpr LineStyle scientific_line() {
    LineStyle style = outlined(contour_line(1.3F, HiddenParts::none), 1.6F);
    style.lit_factor = 0.55F;
    style.taper = 16.0F;
    return style;
}
constexpr LineStyle scientific_lines[] = {scientific_line(), crease_line(scientific_line(), 0.9F)};
// A pencil goes twice over each contour.
constexpr LineStyle pencil_line(float width, float wobble, std::uint32_t seed) {
    LineStyle style = contour_line(width, HiddenParts::none);
    style.cap = drawing::Cap::pointed;
    style.taper = 30.0F;
    style.lit_factor = 0.6F;
    style.wobble = wobble;
    style.wobble_width = 0.35F;
    style.wobble_length = 60.0F;
    style.wobble_seed = seed;
    for (int i = 0; i < 3; ++i) style.ink[i] = graphite[i];
    return style;
}
constexpr LineStyle sketch_lines[] = {pencil_line(1.7F, 0.9F, 1), pencil_line(1.1F, 3.2F, 2),
                                      crease_line(pencil_line(1.7F, 0.9F, 3), 1.2F)};
constexpr LineStyle blueprint_line(LineKind kind, float width, float outline, const char* name = nullptr) {
    LineStyle style = outlined(contour_line(width, HiddenParts::dashed), outline);
    style.kind = kind;
    style.name = name;
    style.hidden_width = 0.8F;
    style.taper = 0.0F;
    for (int i = 0; i < 3; ++i) style.ink[i] = chalk[i];
    return style;
}
constexpr LineStyle blueprint_lines[] = {
    blueprint_line(LineKind::contour, 1.5F, 1.6F), blueprint_line(LineKind::border, 1.5F, 1.6F),
    blueprint_line(LineKind::own, 1.1F, 1.0F, "crease"), blueprint_line(LineKind::crease, 1.1F, 1.0F)};
// The outline is heavy; ridges between scars are fine lines.
constexpr LineStyle ridge_line(float width) {
    LineStyle style = contour_line(width, HiddenParts::none);
    style.kind = LineKind::ridge;
    style.taper = 20.0F;
    style.shortest = 12.0F;
    return style;
}
constexpr LineStyle archaeological_contours[] = {outlined(contour_line(1.8F, HiddenParts::none), 1.8F),
                                                 ridge_line(1.2F),
                                                 crease_line(contour_line(1.8F, HiddenParts::none), 1.2F)};

// By the number of the preset; stippling alone has none.
constexpr std::span<const LineStyle> lines_of(std::uint32_t preset) {
    switch (preset) {
    case 0: return {};
    case 4: return silhouette_lines;
    case 6: return xray_lines;
    case 10: return woodcut_lines;
    case 11: return scientific_lines;
    case 12: return sketch_lines;
    case 13: return blueprint_lines;
    case 14: return archaeological_contours;
    default: return plain_lines;
    }
}

} // namespace hrbfnpr::frame::presets
