// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/presets.py; do not edit.
#pragma once
// clang-format off

#include "api/layer_fields.h"
#include "api/presets.h"
#include "api/style_fields.h"

#include <iterator>

namespace hrbfnpr::api::preset_table {

// Defaults with some fields set.
template <class Struct, class Change>
[[nodiscard]] constexpr Struct changed(Struct to, Change change) {
    change(to);
    return to;
}

template <std::size_t count>
[[nodiscard]] constexpr hrbfnpr_array packed(const double (&numbers)[count]) noexcept {
    return {numbers, count, sizeof(double), HRBFNPR_SCALAR_FLOAT64, 1};
}

// ---- stipple

inline constexpr hrbfnpr_layer_desc stipple_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; })};
inline constexpr hrbfnpr_layer_style stipple_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.radius = 1.1F; to.contours = 0;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.contours = 0; })};

// ---- hatch

inline constexpr hrbfnpr_layer_desc hatch_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; })};
inline constexpr hrbfnpr_layer_style hatch_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.shown = 0; }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.12F; to.hatch_tone_end = 0.95F; to.hatch_coverage_end = 0.42F; to.hatch_spacing = 1.9F;
        to.hatch_pen = 0.8F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_fade = 0.1F;
    })};
inline constexpr hrbfnpr_line_style hatch_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- cross-hatch

inline constexpr hrbfnpr_layer_desc cross_hatch_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.name = "hatch-1";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 35.0; to.name = "hatch-2";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = -30.0; to.name = "hatch-3";
    })};
inline constexpr hrbfnpr_layer_style cross_hatch_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.shown = 0; }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-1"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.12F; to.hatch_tone_end = 0.45F; to.hatch_coverage_end = 0.24F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-2"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.38F; to.hatch_tone_end = 0.66F; to.hatch_coverage_end = 0.24F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-3"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.6F; to.hatch_tone_end = 0.9F; to.hatch_coverage_end = 0.3F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.12F; to.hatch_tone_end = 0.9F; to.hatch_coverage_end = 0.3F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    })};
inline constexpr hrbfnpr_line_style cross_hatch_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- combing

inline constexpr hrbfnpr_layer_desc combing_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.name = "hatch-1"; to.guide = HRBFNPR_HATCH_GUIDE_COMBING;
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 40.0; to.name = "hatch-2";
        to.guide = HRBFNPR_HATCH_GUIDE_COMBING;
    })};
inline constexpr hrbfnpr_layer_style combing_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.shown = 0; }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-1"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.1F; to.hatch_tone_end = 0.6F; to.hatch_coverage_end = 0.32F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-2"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.5F; to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.34F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0; to.hatch_tone_begin = 0.1F;
        to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.34F; to.hatch_spacing = 2.6F; to.hatch_pen = 0.6F;
        to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F; to.hatch_coverage_begin = 0.09F;
        to.hatch_fade = 0.09F;
    })};
inline constexpr hrbfnpr_line_style combing_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- silhouette

inline constexpr hrbfnpr_layer_desc silhouette_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; })};
inline constexpr hrbfnpr_layer_style silhouette_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style silhouette_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.8F; to.hidden = HRBFNPR_HIDDEN_PARTS_ATTENUATED;
        to.outline_factor = 1.5F; to.far_factor = 0.45F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.8F; to.hidden = HRBFNPR_HIDDEN_PARTS_ATTENUATED;
        to.outline_factor = 1.0F; to.far_factor = 0.45F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.5F; to.hidden = HRBFNPR_HIDDEN_PARTS_NONE;
        to.outline_factor = 1.0F; to.far_factor = 0.45F; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.8F; to.hidden = HRBFNPR_HIDDEN_PARTS_ATTENUATED;
        to.outline_factor = 1.0F; to.far_factor = 0.45F;
    })};

// ---- contour-and-stipple

inline constexpr hrbfnpr_layer_desc contour_and_stipple_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; })};
inline constexpr hrbfnpr_layer_style contour_and_stipple_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shown = 0; })};
inline constexpr hrbfnpr_line_style contour_and_stipple_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- xray

inline constexpr hrbfnpr_layer_desc xray_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; })};
inline constexpr hrbfnpr_layer_style xray_layers[] = {
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style xray_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.0F; to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
        to.outline_factor = 1.5F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
        to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
        to.outline_factor = 1.0F;
    })};

// ---- full

inline constexpr hrbfnpr_layer_desc full_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.name = "hatch-1";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 40.0; to.name = "hatch-2";
    })};
inline constexpr hrbfnpr_layer_style full_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.radius = 0.7F; to.share = 0.45F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-1"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.4F; to.hatch_tone_end = 0.75F; to.hatch_coverage_end = 0.34F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-2"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.62F; to.hatch_tone_end = 0.95F; to.hatch_coverage_end = 0.34F; to.hatch_spacing = 2.6F;
        to.hatch_pen = 0.6F; to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F;
        to.hatch_coverage_begin = 0.09F; to.hatch_fade = 0.09F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0; to.hatch_tone_begin = 0.4F;
        to.hatch_tone_end = 0.95F; to.hatch_coverage_end = 0.34F; to.hatch_spacing = 2.6F; to.hatch_pen = 0.6F;
        to.hatch_white = 0.68F; to.hatch_taper = 8.0F; to.hatch_shortest = 8.0F; to.hatch_coverage_begin = 0.09F;
        to.hatch_fade = 0.09F;
    })};
inline constexpr hrbfnpr_line_style full_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- engraving

inline constexpr hrbfnpr_layer_desc engraving_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; })};
inline constexpr hrbfnpr_layer_style engraving_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.15F; to.hatch_tone_end = 0.95F; to.hatch_coverage_end = 0.74F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.45F; to.hatch_white = 0.68F; to.hatch_taper = 12.0F; to.hatch_shortest = 7.0F;
        to.hatch_fade = 0.12F;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style engraving_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- etching

inline constexpr hrbfnpr_layer_desc etching_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.name = "hatch-1";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 50.0; to.name = "hatch-2";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = -40.0; to.name = "hatch-3";
    })};
inline constexpr hrbfnpr_layer_style etching_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-1"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.15F; to.hatch_tone_end = 0.55F; to.hatch_coverage_end = 0.36F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.45F; to.hatch_white = 0.68F; to.hatch_taper = 12.0F; to.hatch_shortest = 7.0F;
        to.hatch_fade = 0.12F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-2"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.4F; to.hatch_tone_end = 0.75F; to.hatch_coverage_end = 0.36F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.45F; to.hatch_white = 0.68F; to.hatch_taper = 12.0F; to.hatch_shortest = 7.0F;
        to.hatch_fade = 0.08F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-3"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.66F; to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.36F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.45F; to.hatch_white = 0.68F; to.hatch_taper = 12.0F; to.hatch_shortest = 7.0F;
        to.hatch_fade = 0.08F;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style etching_lines[] = {
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.4F; to.outline_factor = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.4F; to.outline_factor = 1.0F;
    })};

// ---- woodcut

inline constexpr hrbfnpr_layer_desc woodcut_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; })};
inline constexpr hrbfnpr_layer_style woodcut_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.22F; to.hatch_tone_end = 0.75F; to.hatch_coverage_end = 1.0F; to.hatch_spacing = 5.0F;
        to.hatch_pen = 0.9F; to.hatch_white = 0.0F; to.hatch_taper = 20.0F; to.hatch_shortest = 12.0F;
        to.hatch_fade = 0.18F;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style woodcut_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 4.6F; to.outline_factor = 1.5F; to.far_factor = 0.45F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 3.0F; to.outline_factor = 1.0F; to.far_factor = 0.45F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 2.2F; to.outline_factor = 1.0F; to.far_factor = 0.45F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.taper = 24.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 3.0F; to.outline_factor = 1.0F; to.far_factor = 0.45F;
    })};

// ---- scientific-stipple

inline constexpr hrbfnpr_layer_desc scientific_stipple_marks[] = {
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.tone_begin = 0.08F; to.tone_end = 1.0F;
    })};
inline constexpr hrbfnpr_layer_style scientific_stipple_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_STIPPLES; to.radius = 0.6F; to.share = 0.85F;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style scientific_stipple_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 1.3F; to.outline_factor = 1.6F; to.lit_factor = 0.55F;
        to.taper = 16.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 0.9F; to.outline_factor = 1.0F; to.lit_factor = 0.55F;
        to.taper = 16.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 0.7F; to.outline_factor = 1.0F; to.lit_factor = 0.55F;
        to.taper = 24.0F; to.hidden = HRBFNPR_HIDDEN_PARTS_NONE; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 0.9F; to.outline_factor = 1.0F; to.lit_factor = 0.55F;
        to.taper = 16.0F;
    })};

// ---- sketch

inline constexpr hrbfnpr_layer_desc sketch_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.name = "hatch-1";
    }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 40.0; to.name = "hatch-2";
    })};
inline constexpr hrbfnpr_layer_style sketch_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-1"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.2F; to.hatch_tone_end = 0.7F; to.hatch_coverage_end = 0.26F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.7F; to.hatch_white = 0.6F; to.hatch_taper = 4.0F; to.hatch_shortest = 9.0F;
        to.hatch_coverage_begin = 0.08F; to.hatch_wobble = 1.2F; to.hatch_overshoot = 16.0F; to.hatch_seed = 1;
        to.hatch_fade = 0.1F; to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.name = "hatch-2"; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.5F; to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.28F; to.hatch_spacing = 2.8F;
        to.hatch_pen = 0.7F; to.hatch_white = 0.6F; to.hatch_taper = 4.0F; to.hatch_shortest = 9.0F;
        to.hatch_coverage_begin = 0.08F; to.hatch_wobble = 1.2F; to.hatch_overshoot = 16.0F; to.hatch_seed = 2;
        to.hatch_fade = 0.1F; to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0; to.hatch_tone_begin = 0.2F;
        to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.28F; to.hatch_spacing = 2.8F; to.hatch_pen = 0.7F;
        to.hatch_white = 0.6F; to.hatch_taper = 4.0F; to.hatch_shortest = 9.0F; to.hatch_coverage_begin = 0.08F;
        to.hatch_wobble = 1.2F; to.hatch_overshoot = 16.0F; to.hatch_seed = 3; to.hatch_fade = 0.1F;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    })};
inline constexpr hrbfnpr_line_style sketch_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 2.2F; to.cap = HRBFNPR_CAP_POINTED; to.taper = 30.0F;
        to.lit_factor = 0.6F; to.far_factor = 0.45F; to.wobble = 0.7F; to.wobble_width = 0.35F;
        to.wobble_length = 46.0F; to.wobble_seed = 1;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 1.4F; to.cap = HRBFNPR_CAP_POINTED; to.taper = 30.0F;
        to.lit_factor = 0.6F; to.far_factor = 0.45F; to.wobble = 2.5F; to.wobble_width = 0.35F;
        to.wobble_length = 46.0F; to.wobble_seed = 2;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.6F; to.cap = HRBFNPR_CAP_POINTED; to.taper = 30.0F;
        to.lit_factor = 0.6F; to.far_factor = 0.45F; to.wobble = 0.7F; to.wobble_width = 0.35F;
        to.wobble_length = 46.0F; to.wobble_seed = 3;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_SOFT_EDGE; to.width = 1.1F; to.cap = HRBFNPR_CAP_POINTED; to.taper = 24.0F;
        to.lit_factor = 0.6F; to.far_factor = 0.45F; to.wobble = 0.7F; to.wobble_width = 0.35F;
        to.wobble_length = 46.0F; to.wobble_seed = 4;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F; to.lower = 15.0; to.upper = 60.0;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.6F; to.cap = HRBFNPR_CAP_POINTED; to.taper = 30.0F;
        to.lit_factor = 0.6F; to.far_factor = 0.45F; to.wobble = 0.7F; to.wobble_width = 0.35F;
        to.wobble_length = 46.0F; to.wobble_seed = 3;
        to.ink[0] = 0.2F; to.ink[1] = 0.2F; to.ink[2] = 0.22F; to.ink[3] = 1.0F;
    })};

// ---- blueprint

inline constexpr hrbfnpr_layer_desc blueprint_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; })};
inline constexpr hrbfnpr_layer_style blueprint_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    })};
inline constexpr hrbfnpr_line_style blueprint_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 1.5F; to.outline_factor = 1.6F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED; to.hidden_width = 0.8F; to.taper = 0.0F;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_BORDER; to.width = 1.5F; to.outline_factor = 1.6F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED; to.hidden_width = 0.8F; to.taper = 0.0F;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_OWN; to.name = "crease"; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED; to.hidden_width = 0.8F; to.taper = 0.0F;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED; to.hidden_width = 0.8F; to.taper = 0.0F;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.1F; to.outline_factor = 1.0F;
        to.hidden = HRBFNPR_HIDDEN_PARTS_DASHED; to.hidden_width = 0.8F; to.taper = 0.0F;
        to.ink[0] = 0.91F; to.ink[1] = 0.95F; to.ink[2] = 1.0F; to.ink[3] = 1.0F;
    })};

// ---- archaeological

inline constexpr hrbfnpr_layer_desc archaeological_marks[] = {
    changed(default_layer_desc(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_STIPPLES; }),
    changed(default_layer_desc(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.angle = 0.0; to.smoothing = 0.03; to.axis_weight = 0.02;
    })};
inline constexpr hrbfnpr_layer_style archaeological_layers[] = {
    changed(default_layer_style(), [](auto& to) {
        to.kind = HRBFNPR_LAYER_KIND_HATCH; to.shape = HRBFNPR_SHAPE_HATCH; to.contours = 0;
        to.hatch_tone_begin = 0.28F; to.hatch_tone_end = 0.92F; to.hatch_coverage_end = 0.45F; to.hatch_spacing = 3.2F;
        to.hatch_pen = 0.45F; to.hatch_white = 0.68F; to.hatch_taper = 26.0F; to.hatch_shortest = 6.0F;
        to.hatch_coverage_begin = 0.08F; to.hatch_fade = 0.1F;
    }),
    changed(default_layer_style(), [](auto& to) { to.kind = HRBFNPR_LAYER_KIND_ANY; to.shown = 0; })};
inline constexpr hrbfnpr_line_style archaeological_lines[] = {
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_CONTOUR; to.width = 1.8F; to.outline_factor = 1.8F;
    }),
    changed(default_line_style(), [](auto& to) {
        to.kind = HRBFNPR_LINE_KIND_RIDGE; to.width = 1.2F; to.taper = 20.0F; to.shortest = 12.0F;
    }),
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_CREASE; to.width = 1.2F; }),
    changed(default_line_style(), [](auto& to) { to.kind = HRBFNPR_LINE_KIND_INTERSECTION; to.width = 1.2F; })};

// ---- All named styles, in the order of their numbers

inline constexpr Preset presets[] = {
    {"stipple",
     changed(default_style(), [](auto& to) {
         to.silhouette_threshold = 0.05; to.silhouette_radius = 1.2F;
         to.layers = stipple_layers; to.layer_count = std::ssize(stipple_layers);
     }),
     stipple_marks},
    {"hatch",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.layers = hatch_layers; to.layer_count = std::ssize(hatch_layers);
         to.lines = hatch_lines; to.line_count = std::ssize(hatch_lines);
     }),
     hatch_marks},
    {"cross-hatch",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.layers = cross_hatch_layers; to.layer_count = std::ssize(cross_hatch_layers);
         to.lines = cross_hatch_lines; to.line_count = std::ssize(cross_hatch_lines);
     }),
     cross_hatch_marks},
    {"combing",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.layers = combing_layers; to.layer_count = std::ssize(combing_layers);
         to.lines = combing_lines; to.line_count = std::ssize(combing_lines);
     }),
     combing_marks},
    {"silhouette",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.attenuation_front = 0.2; to.attenuation_back = 0.1;
         to.layers = silhouette_layers; to.layer_count = std::ssize(silhouette_layers);
         to.lines = silhouette_lines; to.line_count = std::ssize(silhouette_lines);
     }),
     silhouette_marks},
    {"contour-and-stipple",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F;
         to.layers = contour_and_stipple_layers; to.layer_count = std::ssize(contour_and_stipple_layers);
         to.lines = contour_and_stipple_lines; to.line_count = std::ssize(contour_and_stipple_lines);
     }),
     contour_and_stipple_marks},
    {"xray",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
         to.layers = xray_layers; to.layer_count = std::ssize(xray_layers);
         to.lines = xray_lines; to.line_count = std::ssize(xray_lines);
     }),
     xray_marks},
    {"full",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.halo_width = 4.0F; to.occlusion_lights = 0.8F;
         to.layers = full_layers; to.layer_count = std::ssize(full_layers);
         to.lines = full_lines; to.line_count = std::ssize(full_lines);
     }),
     full_marks},
    {"engraving",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE; to.occlusion_lights = 0.8F;
         to.layers = engraving_layers; to.layer_count = std::ssize(engraving_layers);
         to.lines = engraving_lines; to.line_count = std::ssize(engraving_lines);
     }),
     engraving_marks},
    {"etching",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE; to.occlusion_lights = 0.8F;
         to.layers = etching_layers; to.layer_count = std::ssize(etching_layers);
         to.lines = etching_lines; to.line_count = std::ssize(etching_lines);
     }),
     etching_marks},
    {"woodcut",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE; to.occlusion_lights = 0.8F;
         to.layers = woodcut_layers; to.layer_count = std::ssize(woodcut_layers);
         to.lines = woodcut_lines; to.line_count = std::ssize(woodcut_lines);
     }),
     woodcut_marks},
    {"scientific-stipple",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 0.8F; to.light[0] = -0.5; to.light[1] = 0.5; to.light[2] = 0.7071067811865476;
         to.tone_exponent = 0.8; to.occlusion_lights = 0.8F;
         to.layers = scientific_stipple_layers; to.layer_count = std::ssize(scientific_stipple_layers);
         to.lines = scientific_stipple_lines; to.line_count = std::ssize(scientific_stipple_lines);
     }),
     scientific_stipple_marks},
    {"sketch",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F;
         to.silhouette_ink[0] = 0.2F; to.silhouette_ink[1] = 0.2F; to.silhouette_ink[2] = 0.22F; to.silhouette_ink[3] = 1.0F;
         to.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
         to.paper[0] = 0.98F; to.paper[1] = 0.96F; to.paper[2] = 0.915F; to.paper[3] = 1.0F; to.halo_width = 0.0F;
         to.layers = sketch_layers; to.layer_count = std::ssize(sketch_layers);
         to.lines = sketch_lines; to.line_count = std::ssize(sketch_lines);
     }),
     sketch_marks},
    {"blueprint",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F;
         to.silhouette_ink[0] = 0.91F; to.silhouette_ink[1] = 0.95F; to.silhouette_ink[2] = 1.0F; to.silhouette_ink[3] = 1.0F;
         to.paper[0] = 0.09F; to.paper[1] = 0.25F; to.paper[2] = 0.47F; to.paper[3] = 1.0F; to.attenuation_front = 0.2;
         to.attenuation_back = 0.1; to.layers = blueprint_layers; to.layer_count = std::ssize(blueprint_layers);
         to.lines = blueprint_lines; to.line_count = std::ssize(blueprint_lines);
     }),
     blueprint_marks},
    {"archaeological",
     changed(default_style(), [](auto& to) {
         to.silhouette_radius = 1.2F; to.light[0] = -0.5; to.light[1] = 0.5; to.light[2] = 0.7071067811865476;
         to.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
         to.layers = archaeological_layers; to.layer_count = std::ssize(archaeological_layers);
         to.lines = archaeological_lines; to.line_count = std::ssize(archaeological_lines);
     }),
     archaeological_marks}};

} // namespace hrbfnpr::api::preset_table
