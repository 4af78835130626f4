// SPDX-License-Identifier: MIT
#include "api/preset_layers.h"

#include "api/descriptor.h"
#include "generate/settings.h"

#include <array>

namespace hrbfnpr::api {
namespace {

// The defaults of hrbfnpr_layer_desc_init.
constexpr hrbfnpr_layer_desc of_kind(std::uint32_t kind) noexcept {
    hrbfnpr_layer_desc desc{};
    desc.struct_size = sizeof desc;
    desc.kind = kind;
    desc.budget = generate::default_budget;
    desc.density_strength = 0.5;
    desc.symmetry = HRBFNPR_SYMMETRY_CROSS;
    desc.levels = -1;
    desc.smoothing = 0.04;
    desc.axis[1] = 1.0;
    desc.axis_weight = 0.06;
    desc.tone_smoothing = -1.0;
    desc.guide_direction[2] = 1.0;
    desc.guide_weight = 1.0;
    return desc;
}

// Stipples give the contours of all of them.
constexpr std::array<hrbfnpr_layer_desc, 1> stipples = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES)};
// Lights are left empty.
constexpr std::array<hrbfnpr_layer_desc, 1> scientific = {[] {
    hrbfnpr_layer_desc desc = of_kind(HRBFNPR_LAYER_KIND_STIPPLES);
    desc.tone_begin = 0.08F;
    desc.tone_end = 1.0F;
    return desc;
}()};

constexpr hrbfnpr_layer_desc hatched(const char* name, double angle) noexcept {
    hrbfnpr_layer_desc desc = of_kind(HRBFNPR_LAYER_KIND_HATCH);
    desc.name = name;
    desc.angle = angle;
    return desc;
}
constexpr hrbfnpr_layer_desc combed(const char* name, double angle) noexcept {
    hrbfnpr_layer_desc desc = hatched(name, angle);
    desc.guide = HRBFNPR_HATCH_GUIDE_COMBING;
    return desc;
}
constexpr hrbfnpr_layer_desc by_curvature(hrbfnpr_layer_desc desc) noexcept {
    desc.axis_weight = 0.02;
    desc.smoothing = 0.03;
    return desc;
}
constexpr std::array<hrbfnpr_layer_desc, 4> cross_hatch = {
    of_kind(HRBFNPR_LAYER_KIND_STIPPLES), hatched("hatch-1", 0.0), hatched("hatch-2", 35.0), hatched("hatch-3", -30.0)};
constexpr std::array<hrbfnpr_layer_desc, 3> two_sets = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES), hatched("hatch-1", 0.0),
                                                        hatched("hatch-2", 40.0)};
constexpr std::array<hrbfnpr_layer_desc, 3> combing = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES), combed("hatch-1", 0.0),
                                                       combed("hatch-2", 40.0)};
constexpr std::array<hrbfnpr_layer_desc, 2> archaeological = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES),
                                                              by_curvature(hatched(nullptr, 0.0))};
constexpr std::array<hrbfnpr_layer_desc, 2> engraving = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES), hatched(nullptr, 0.0)};
constexpr std::array<hrbfnpr_layer_desc, 4> etching = {of_kind(HRBFNPR_LAYER_KIND_STIPPLES), hatched("hatch-1", 0.0),
                                                       hatched("hatch-2", 50.0), hatched("hatch-3", -40.0)};

} // namespace

PresetLayers preset_layers(std::uint32_t preset) noexcept {
    switch (preset) {
    case HRBFNPR_PRESET_STIPPLE:
    case HRBFNPR_PRESET_SILHOUETTE:
    case HRBFNPR_PRESET_CONTOUR_AND_STIPPLE:
    case HRBFNPR_PRESET_XRAY:
    case HRBFNPR_PRESET_BLUEPRINT: return {stipples.data(), 1};
    case HRBFNPR_PRESET_CROSS_HATCH: return {cross_hatch.data(), 4};
    case HRBFNPR_PRESET_FULL:
    case HRBFNPR_PRESET_SKETCH: return {two_sets.data(), 3};
    case HRBFNPR_PRESET_COMBING: return {combing.data(), 3};
    case HRBFNPR_PRESET_HATCH:
    case HRBFNPR_PRESET_ENGRAVING:
    case HRBFNPR_PRESET_WOODCUT: return {engraving.data(), 2};
    case HRBFNPR_PRESET_ETCHING: return {etching.data(), 4};
    case HRBFNPR_PRESET_SCIENTIFIC_STIPPLE: return {scientific.data(), 1};
    case HRBFNPR_PRESET_ARCHAEOLOGICAL: return {archaeological.data(), 2};
    default: return {};
    }
}

} // namespace hrbfnpr::api

extern "C" {

const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count) {
    const hrbfnpr::api::PresetLayers layers = hrbfnpr::api::preset_layers(preset);
    if (count != nullptr) *count = layers.count;
    return layers.first;
}

} // extern "C"
