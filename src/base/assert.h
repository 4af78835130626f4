// SPDX-License-Identifier: MIT
// Assertions: conditions that are true unless the library has a bug. Only debug and sanitizer builds test them.
// Assertions do not cover mistakes of a caller: every build tests for those and reports an error.
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
