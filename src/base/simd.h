// SPDX-License-Identifier: MIT
// Loops that Highway compiles once for each instruction set. The version to run is chosen at run time.
//
// A file with such loops defines HWY_TARGET_INCLUDE as its own file name, includes this header, puts its loops into
// HWY_NAMESPACE::NAME between HWY_BEFORE_NAMESPACE() and HWY_AFTER_NAMESPACE(), and ends with HRBFNPR_CHOOSE. NAME is
// the name of the file: amalgamate.py puts all such files into one. The file must not use the standard library, GLM or
// Eigen: if an inline function is compiled for several instruction sets, the linker keeps only one copy, which the
// processor may not be able to run.

#if !defined(HWY_DISABLED_TARGETS)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#endif

// On arm64 NEON is both the least and the only instruction set that is used. GCC 12 crashes on Highway's SVE.
#if defined(__aarch64__) && !defined(HWY_COMPILE_ONLY_STATIC)
#define HWY_COMPILE_ONLY_STATIC
#define TOOLCHAIN_MISS_SYS_AUXV_H
#endif

#include "base/instruction_set.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#if HWY_TARGET == HWY_WASM && !HWY_HAVE_FLOAT64
#include "base/simd_wasm_doubles-inl.h"
#endif

#if HWY_ONCE && !defined(HRBFNPR_PICK)
#if HWY_TARGETS & HWY_AVX3
#define HRBFNPR_PICK_AVX512(set, name) (set) == ::hrbfnpr::base::InstructionSet::avx512 ? N_AVX3::name:
#else
#define HRBFNPR_PICK_AVX512(set, name)
#endif
#if HWY_TARGETS & HWY_AVX2
#define HRBFNPR_PICK_AVX2(set, name) (set) == ::hrbfnpr::base::InstructionSet::avx2 ? N_AVX2::name:
#else
#define HRBFNPR_PICK_AVX2(set, name)
#endif
// The function `name` from the namespace of the instruction set `set` or, if the build has no code for this set, from
// that of the build's baseline.
#define HRBFNPR_PICK(set, name)                                                                                        \
    (static_cast<void>(set),                                                                                           \
     HRBFNPR_PICK_AVX512(set, name) HRBFNPR_PICK_AVX2(set, name) HWY_CONCAT(N_, HWY_STATIC_NAME)::name)
#if HWY_STATIC_TARGET == HWY_SCALAR
#define HWY_STATIC_NAME SCALAR
#elif HWY_STATIC_TARGET == HWY_EMU128
#define HWY_STATIC_NAME EMU128
#elif HWY_STATIC_TARGET == HWY_AVX2
#define HWY_STATIC_NAME AVX2
#elif HWY_STATIC_TARGET == HWY_AVX3
#define HWY_STATIC_NAME AVX3
#elif HWY_STATIC_TARGET == HWY_NEON
#define HWY_STATIC_NAME NEON
#elif defined(HWY_NEON_WITHOUT_AES) && HWY_STATIC_TARGET == HWY_NEON_WITHOUT_AES
#define HWY_STATIC_NAME NEON_WITHOUT_AES
#elif HWY_STATIC_TARGET == HWY_WASM
#define HWY_STATIC_NAME WASM
#endif
#endif

// Use HRBFNPR_CHOOSE once in a file. It defines the function `name` in the namespace `space`. The function takes an
// instruction set and returns the result of that set's `pick`.
#undef HRBFNPR_CHOOSE
#if HWY_ONCE
#define HRBFNPR_CHOOSE(space, type, name, pick)                                                                        \
    namespace space {                                                                                                  \
    type name(::hrbfnpr::base::InstructionSet set) noexcept { return HRBFNPR_PICK(set, pick)(); }                      \
    }
#else
#define HRBFNPR_CHOOSE(space, type, name, pick)
#endif
