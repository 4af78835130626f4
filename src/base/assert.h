// SPDX-License-Identifier: MIT
// Checks of conditions that are true unless the library has a bug. Debug and sanitizer builds check them; release
// builds do not. Mistakes that a caller can make are not checked in this way: they are always checked, and fail with a
// message.
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
