// SPDX-License-Identifier: MIT
// Invariants that hold unless the library itself is wrong: checked in debug and sanitizer builds, not compiled in
// release. What a caller can get wrong is no invariant: it is checked always, and fails with a message.
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
