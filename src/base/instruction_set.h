// SPDX-License-Identifier: MIT
// The vector instructions that the hot loops use. They are chosen once for each context.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// Same numbers as HRBFNPR_INSTRUCTION_SET_*; `automatic` is a request, never an answer.
enum class InstructionSet : std::uint32_t { automatic = 0, baseline = 1, avx2 = 2, avx512 = 3, neon = 4 };

// Returns the best instruction set that both processor and build have, no higher than `highest`.
[[nodiscard]] InstructionSet choose_instruction_set(InstructionSet highest) noexcept;

// Lists the instruction sets that the build has loops for, as JSON strings separated by commas.
[[nodiscard]] const char* compiled_instruction_sets() noexcept;

[[nodiscard]] const char* name(InstructionSet set) noexcept;

} // namespace hrbfnpr::base
