// SPDX-License-Identifier: MIT
// Limits of settings and of changes by name: what is beyond them is no such text, but a mistake or an attack.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

struct SettingsTuning {
    // The longest file of settings, bytes.  A dab of paint takes some 250.  Larger: more is read before it is refused.
    std::size_t most_bytes = std::size_t{16} << 20U;
    // How deep lists and objects may lie in each other; settings have 4.  Larger: more stack for what is refused.
    std::size_t most_depth = 32;
    // The most changes in a list, and the longest path and value of one, bytes.  Larger: a wrong count is noticed
    // later.
    std::int64_t most_changes = 100'000;
    std::size_t longest_path = 128;
    std::size_t longest_value = 4096;
};

inline constexpr SettingsTuning settings_tuning;

} // namespace hrbfnpr::picture
