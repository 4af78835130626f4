// SPDX-License-Identifier: MIT
// A named style in the form that a frame gets: read from the library and converted as at the boundary.
#pragma once

#include "api/style.h"
#include "frame/scene/style.h"
#include "support/preset_names.h"

#include <stdexcept>

namespace hrbfnpr::testing {

class NamedStyle {
public:
    explicit NamedStyle(std::uint32_t preset) : name(hrbfnpr_preset_name(preset)) {
        if (hrbfnpr_style_init_preset(&given, sizeof given, preset, nullptr) != HRBFNPR_STATUS_OK)
            throw std::invalid_argument("there is no such preset");
        style = api::checked_style(given, "style", lists_);
        style.layers = lists_.layers.span();
        style.lines = lists_.lines.span();
        style.lights = lists_.lights.span();
    }
    NamedStyle(const NamedStyle&) = delete; // the style refers to the lists
    NamedStyle& operator=(const NamedStyle&) = delete;

    const char* name;
    hrbfnpr_style given{};
    frame::Style style;

private:
    base::Memory memory_;
    api::StyleLists lists_{memory_};
};

inline constexpr auto preset_count = static_cast<std::uint32_t>(std::size(preset_names));

} // namespace hrbfnpr::testing
