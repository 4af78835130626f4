// SPDX-License-Identifier: MIT
// Measures the memory of the process.
#pragma once

#include <cstdint>

namespace soak {

struct Memory {
    std::int64_t used = 0;     // bytes given out by malloc; 0 if unknown, for example under a sanitizer
    std::int64_t resident = 0; // bytes of the process in memory; 0 if the system does not tell
};

// Call this while no other thread works. Memory that malloc keeps for later is returned first.
Memory measure_memory();

} // namespace soak
