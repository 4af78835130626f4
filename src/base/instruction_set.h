// SPDX-License-Identifier: MIT
// The SIMD instructions that the hot loops use. They are chosen once for each context.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// The values equal the constants HRBFNPR_INSTRUCTION_SET_*. `automatic` is only a request, and never a result.
enum class InstructionSet : std::uint32_t { automatic = 0, baseline = 1, avx2 = 2, avx512 = 3, neon = 4 };

// Returns the best instruction set that both the processor and the build support, but no higher than `highest`.
[[nodiscard]] InstructionSet choose_instruction_set(InstructionSet highest) noexcept;

// Returns the instruction sets that the build supports, as JSON strings separated by commas.
[[nodiscard]] const char* compiled_instruction_sets() noexcept;

[[nodiscard]] const char* name(InstructionSet set) noexcept;

} // namespace hrbfnpr::base
