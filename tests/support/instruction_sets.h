// SPDX-License-Identifier: MIT
// The instruction sets that this machine can run.
#pragma once

#include "base/instruction_set.h"

#include <vector>

namespace hrbfnpr::test {

inline std::vector<base::InstructionSet> instruction_sets() {
    std::vector<base::InstructionSet> sets{base::InstructionSet::baseline};
    for (const auto set : {base::InstructionSet::avx2, base::InstructionSet::avx512, base::InstructionSet::neon})
        if (base::choose_instruction_set(set) == set) sets.push_back(set);
    return sets;
}

} // namespace hrbfnpr::test
