// SPDX-License-Identifier: MIT
// A replacement for std::bit_cast, which Emscripten's library does not have yet.
#pragma once

namespace hrbfnpr::base {

template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& value) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    return __builtin_bit_cast(To, value);
}

} // namespace hrbfnpr::base
