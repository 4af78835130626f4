// SPDX-License-Identifier: MIT
#include "base/instruction_set.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <cpuid.h>
#endif

namespace hrbfnpr::base {
namespace {

#if defined(__x86_64__) && defined(__GNUC__)
// Returns whether the bits are set. The compiler's __builtin_cpu_supports is not used, because it needs a global
// variable and a constructor.
[[nodiscard]] constexpr bool has_bits(unsigned word, unsigned bits) noexcept { return (word & bits) == bits; }

// Returns a bit mask of the registers that the operating system saves for each thread.
[[nodiscard]] unsigned saved_registers() noexcept {
    unsigned a = 0;
    unsigned b = 0;
    unsigned c = 0;
    unsigned d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0 || !has_bits(c, bit_OSXSAVE)) return 0;
    unsigned low = 0;
    unsigned high = 0;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return low;
}

[[nodiscard]] InstructionSet best_instruction_set() noexcept {
    constexpr unsigned ymm = 0x6;  // mask for XMM and YMM registers
    constexpr unsigned zmm = 0xe6; // mask for XMM, YMM, ZMM and mask registers
    unsigned a = 0;
    unsigned b = 0;
    unsigned c = 0;
    unsigned d = 0;
    if (!has_bits(saved_registers(), ymm) || __get_cpuid(1, &a, &b, &c, &d) == 0 || !has_bits(c, bit_FMA | bit_F16C) ||
        __get_cpuid_count(7, 0, &a, &b, &c, &d) == 0 || !has_bits(b, bit_AVX2 | bit_BMI | bit_BMI2))
        return InstructionSet::baseline;
    const bool avx512 = has_bits(saved_registers(), zmm) &&
                        has_bits(b, bit_AVX512F | bit_AVX512DQ | bit_AVX512CD | bit_AVX512BW | bit_AVX512VL);
    return avx512 ? InstructionSet::avx512 : InstructionSet::avx2;
}
#endif

} // namespace

InstructionSet choose_instruction_set(InstructionSet highest) noexcept {
    if (highest == InstructionSet::baseline) return highest;
#if defined(__x86_64__) && defined(__GNUC__)
    const InstructionSet found = best_instruction_set();
    return highest == InstructionSet::avx2 && found == InstructionSet::avx512 ? highest : found;
#elif defined(__aarch64__)
    return InstructionSet::neon;
#else
    return InstructionSet::baseline;
#endif
}

const char* compiled_instruction_sets() noexcept {
#if defined(__x86_64__)
    return R"("baseline", "AVX2", "AVX-512")";
#elif defined(__aarch64__)
    return R"("NEON")";
#else
    return R"("baseline")";
#endif
}

const char* name(InstructionSet set) noexcept {
    switch (set) {
    case InstructionSet::automatic: return "automatic";
    case InstructionSet::avx2: return "AVX2";
    case InstructionSet::avx512: return "AVX-512";
    case InstructionSet::neon: return "NEON";
    case InstructionSet::baseline: break;
    }
    return "baseline";
}

} // namespace hrbfnpr::base
