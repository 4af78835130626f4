// SPDX-License-Identifier: MIT
// Vectors of doubles, and what Highway lacks for them; compiled once for each instruction set.
#if defined(HRBFNPR_SIMD_MATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HRBFNPR_SIMD_MATH_INL
#undef HRBFNPR_SIMD_MATH_INL
#else
#define HRBFNPR_SIMD_MATH_INL
#endif

#include "base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::base::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// Squared distances are not taken as smaller: what is multiplied with the inverse root vanishes by itself.
// inverse_root() begins in floats, whose smallest is 1.2e-38.
constexpr double smallest_r2 = 1e-37;

// A step of third order: of y = (1 - e)^(1/2) / sqrt(x), e becomes 35/128 e^4.
HWY_INLINE V polish_inverse_root(V x, V y) {
    const D d;
    const V e = hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 1.0));
    V p = hn::MulAdd(e, hn::Set(d, 0.3125), hn::Set(d, 0.375));
    p = hn::MulAdd(e, p, hn::Set(d, 0.5));
    return hn::MulAdd(hn::Mul(y, e), p, y);
}

// 1 / sqrt(x), smallest_r2 <= x < 1e38, to two units in the last place: division and square root would take
// longer than all the rest of a pair.
HWY_INLINE V inverse_root(V x) {
#if HWY_TARGET == HWY_AVX3
    return polish_inverse_root(x, V{_mm512_rsqrt14_pd(x.raw)});
#elif HWY_TARGET == HWY_AVX2
    const V y{_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(x.raw)))}; // 12 bits
    return polish_inverse_root(x, polish_inverse_root(x, y));
#else
    return hn::Div(hn::Set(D(), 1.0), hn::Sqrt(x));
#endif
}

} // namespace hrbfnpr::base::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
