// SPDX-License-Identifier: MIT
// Limits for settings and for named changes. Larger input is a mistake or an attack.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

struct SettingsTuning {
    // The largest size of a settings file, in bytes. A dab of paint takes about 250. Larger: more is read before a file
    // is refused.
    std::size_t most_bytes = std::size_t{16} << 20U;
    // The largest depth of nested lists and objects. Settings need 4. Larger: a refused file uses more stack.
    std::size_t most_depth = 32;
    // The largest number of changes in a list, and the largest number of bytes in a path and in a value. Larger: a
    // wrong count is noticed later.
    std::int64_t most_changes = 100'000;
    std::size_t longest_path = 128;
    std::size_t longest_value = 4096;
};

inline constexpr SettingsTuning settings_tuning;

} // namespace hrbfnpr::picture
