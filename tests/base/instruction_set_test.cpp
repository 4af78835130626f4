// SPDX-License-Identifier: MIT
#include "base/instruction_set.h"

#include "base/runtime.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace hrbfnpr::base::instruction_set_test {
namespace {

constexpr InstructionSet all[] = {InstructionSet::automatic, InstructionSet::baseline, InstructionSet::avx2,
                                  InstructionSet::avx512, InstructionSet::neon};

bool processor_has(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (set == InstructionSet::avx512) return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
#elif defined(__aarch64__)
    if (set == InstructionSet::neon) return true;
#endif
    return set == InstructionSet::baseline;
}

TEST(InstructionSet, IsNeverHigherThanAskedFor) {
    for (const InstructionSet highest : all) {
        const InstructionSet chosen = choose_instruction_set(highest);
        EXPECT_NE(chosen, InstructionSet::automatic);
        if (highest != InstructionSet::automatic) {
            EXPECT_LE(chosen, highest) << name(highest);
        }
    }
}

TEST(InstructionSet, IsSupportedByTheProcessor) {
    for (const InstructionSet highest : all)
        EXPECT_TRUE(processor_has(choose_instruction_set(highest))) << name(highest);
}

TEST(InstructionSet, BaselineIsHonoured) {
    EXPECT_EQ(choose_instruction_set(InstructionSet::baseline), InstructionSet::baseline);
    const Runtime runtime(nullptr, nullptr, nullptr, Parallel(), InstructionSet::baseline, nullptr, nullptr);
    EXPECT_EQ(runtime.instruction_set, InstructionSet::baseline);
}

TEST(InstructionSet, AutomaticIsTheBestSupportedSet) {
    const InstructionSet best = choose_instruction_set(InstructionSet::automatic);
    const std::vector<InstructionSet> sets = test::instruction_sets();
    EXPECT_EQ(best, *std::max_element(sets.begin(), sets.end()));
    EXPECT_EQ(choose_instruction_set(best), best);
    EXPECT_EQ(Runtime().instruction_set, best);
}

} // namespace
} // namespace hrbfnpr::base::instruction_set_test
