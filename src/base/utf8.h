// SPDX-License-Identifier: MIT
// Checks text that comes from outside the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hrbfnpr::base {

// Returns whether the bytes are valid UTF-8, with each character in its shortest form and without NUL.
[[nodiscard]] constexpr bool is_utf8(std::string_view text) noexcept {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<std::uint8_t>(text[i++]);
        if (lead == 0) return false;
        if (lead < 0x80) continue;
        const std::size_t more = lead >= 0xC2 && lead < 0xE0   ? 1U
                                 : lead >= 0xE0 && lead < 0xF0 ? 2U
                                 : lead >= 0xF0 && lead < 0xF5 ? 3U
                                                               : 0U;
        if (more == 0 || text.size() - i < more) return false;
        std::uint32_t code = lead & (0x3FU >> more);
        for (std::size_t k = 0; k < more; ++k) {
            const auto byte = static_cast<std::uint8_t>(text[i++]);
            if ((byte & 0xC0U) != 0x80) return false;
            code = code << 6U | (byte & 0x3FU);
        }
        if ((more == 2 && code < 0x800) || (more == 3 && code < 0x10000) || code > 0x10FFFF ||
            (code >= 0xD800 && code < 0xE000))
            return false;
    }
    return true;
}

} // namespace hrbfnpr::base
