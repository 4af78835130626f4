#include "base/instruction_set.h"

namespace hrbfnpr::base {
namespace {

#if defined(__x86_64__) && defined(__GNUC__)
// These look at the operating system's support too.
[[nodiscard]] bool has_avx2() noexcept {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}
[[nodiscard]] bool has_avx512() noexcept {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512cd");
}
#endif

} // namespace

InstructionSet choose_instruction_set(InstructionSet highest) noexcept {
    if (highest == InstructionSet::baseline) return highest;
#if defined(__x86_64__) && defined(__GNUC__)
    if (highest != InstructionSet::avx2 && has_avx512()) return InstructionSet::avx512;
    if (has_avx2()) return InstructionSet::avx2;
#elif defined(__aarch64__)
    return InstructionSet::neon;
#endif
    return InstructionSet::baseline;
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
