// SPDX-License-Identifier: MIT
// The named styles, as constants of the public header's types.
#pragma once

#include "api/checks.h"

#include <hrbfnpr.h>

#include <span>

namespace hrbfnpr::api {

// A row of the table that bindings/generate makes from bindings/presets.py.
struct Preset {
    const char* name;
    hrbfnpr_style style; // the lists of the style are constants, too
    std::span<const hrbfnpr_layer_desc> marks;
};

// All presets, in the order of the HRBFNPR_PRESET_* constants.
[[nodiscard]] std::span<const Preset> presets() noexcept;

namespace rule {

// The value must be the number of a preset.
struct KnownPreset {
    void operator()(const Checks& checks, const char* field, std::int64_t value) const {
        checks.one_of(field, value, static_cast<std::uint32_t>(presets().size()), "HRBFNPR_PRESET_*");
    }
};

} // namespace rule
} // namespace hrbfnpr::api
