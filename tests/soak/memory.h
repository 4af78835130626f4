// SPDX-License-Identifier: MIT
// What the process holds.
#pragma once

#include <cstdint>

namespace soak {

struct Memory {
    std::int64_t used = 0;     // bytes given out by malloc; 0 where it does not say, as under a sanitizer
    std::int64_t resident = 0; // bytes of the process in memory; 0 where the system does not say
};

// When no other thread is at work.  What malloc keeps for later is given back first.
Memory measure_memory();

} // namespace soak
