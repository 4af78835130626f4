// SPDX-License-Identifier: MIT
#if !defined(HRBFNPR_LOOPS_OF_OTHER_SETS)
#define HRBFNPR_LOOPS_OF_OTHER_SETS
// As hwy/foreach_target.h does: include this file for each instruction set except the build's baseline. Each time only
// the loops are read, with another HWY_TARGET. Then go on with the loops for the baseline.
#include <hwy/detect_targets.h>
#undef HWY_ONCE
#define HWY_ONCE 0
#if (HWY_TARGETS & HWY_AVX2) && HWY_STATIC_TARGET != HWY_AVX2
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX2
#include "hrbfnpr.cpp"
#define HWY_TARGET_TOGGLE
#endif
#if (HWY_TARGETS & HWY_AVX3) && HWY_STATIC_TARGET != HWY_AVX3
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX3
#include "hrbfnpr.cpp"
#if defined(HWY_TARGET_TOGGLE)
#undef HWY_TARGET_TOGGLE
#else
#define HWY_TARGET_TOGGLE
#endif
#endif
#undef HWY_TARGET
#define HWY_TARGET HWY_STATIC_TARGET
#undef HWY_ONCE
#define HWY_ONCE 1
#endif
