// SPDX-License-Identifier: MIT
// Invariants that hold unless the library itself is wrong: debug and sanitizer builds check them, release builds do
// not. A caller's possible mistake is no invariant: it is always checked, and fails with a message.
#pragma once

#if defined(NDEBUG) && !defined(HRBFNPR_ASSERTS)
#define HRBFNPR_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#else
#include <cstdio>
#include <cstdlib>
#define HRBFNPR_ASSERT(condition)                                                                                      \
    ((condition)                                                                                                       \
         ? static_cast<void>(0)                                                                                        \
         : (static_cast<void>(std::fprintf(stderr, "%s:%d: invariant broken: %s\n", __FILE__, __LINE__, #condition)),  \
            std::abort()))
#endif
