// SPDX-License-Identifier: MIT
// Which vector instructions the hot loops are run with: chosen once for each context.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// Same numbers as HRBFNPR_INSTRUCTION_SET_...; `automatic` is a request, never an answer.
enum class InstructionSet : std::uint32_t { automatic = 0, baseline = 1, avx2 = 2, avx512 = 3, neon = 4 };

// The best that processor and build have, no higher than `highest`.
[[nodiscard]] InstructionSet choose_instruction_set(InstructionSet highest) noexcept;

// Those that the build has loops for, as a list of JSON strings.
[[nodiscard]] const char* compiled_instruction_sets() noexcept;

[[nodiscard]] const char* name(InstructionSet set) noexcept;

} // namespace hrbfnpr::base
