// SPDX-License-Identifier: MIT
// The layers of marks that the named styles draw.
#pragma once

#include <hrbfnpr.h>

#include <cstdint>

namespace hrbfnpr::api {

// Constants; NULL and 0 for a number that is no preset's.
struct PresetLayers {
    const hrbfnpr_layer_desc* first = nullptr;
    std::int64_t count = 0;
};
[[nodiscard]] PresetLayers preset_layers(std::uint32_t preset) noexcept;

} // namespace hrbfnpr::api
