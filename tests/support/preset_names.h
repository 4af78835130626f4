// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/presets.py; do not edit.
// The named styles that the library must have.
#pragma once
// clang-format off

#include <hrbfnpr.h>

#include <cstdint>

namespace hrbfnpr::testing {

struct PresetName {
    std::uint32_t preset;
    const char* name;
};
inline constexpr PresetName preset_names[] = {
    {HRBFNPR_PRESET_STIPPLE, "stipple"},
    {HRBFNPR_PRESET_HATCH, "hatch"},
    {HRBFNPR_PRESET_CROSS_HATCH, "cross-hatch"},
    {HRBFNPR_PRESET_COMBING, "combing"},
    {HRBFNPR_PRESET_SILHOUETTE, "silhouette"},
    {HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, "contour-and-stipple"},
    {HRBFNPR_PRESET_XRAY, "xray"},
    {HRBFNPR_PRESET_FULL, "full"},
    {HRBFNPR_PRESET_ENGRAVING, "engraving"},
    {HRBFNPR_PRESET_ETCHING, "etching"},
    {HRBFNPR_PRESET_WOODCUT, "woodcut"},
    {HRBFNPR_PRESET_SCIENTIFIC_STIPPLE, "scientific-stipple"},
    {HRBFNPR_PRESET_SKETCH, "sketch"},
    {HRBFNPR_PRESET_BLUEPRINT, "blueprint"},
    {HRBFNPR_PRESET_ARCHAEOLOGICAL, "archaeological"},
};

} // namespace hrbfnpr::testing
