// SPDX-License-Identifier: MIT
// Vectors of doubles, and functions on them that Highway lacks; compiled once for each instruction set.
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

// The smallest squared distance whose inverse root is computed. Smaller squared distances are raised to this, because
// the first estimate of the inverse root is a float, and the smallest normal float is 1.2e-38. This does not change
// results, because at so small a distance the inverse root is multiplied by 0.
constexpr double smallest_r2 = 1e-37;

// Refines y = (1 - e)^(1/2) / sqrt(x), where e is small, by the series of (1 - e)^(-1/2). The first omitted term is
// 35/128 e^4.
HWY_INLINE V polish_inverse_root(V x, V y) {
    const D d;
    const V e = hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 1.0));
    V p = hn::MulAdd(e, hn::Set(d, 0.3125), hn::Set(d, 0.375));
    p = hn::MulAdd(e, p, hn::Set(d, 0.5));
    return hn::MulAdd(hn::Mul(y, e), p, y);
}

// Refines an inverse root as polish_inverse_root() does, with one more term of the series. The first omitted term is
// 63/256 e^5.
HWY_INLINE V polish_rough_inverse_root(V x, V y) {
    const D d;
    const V e = hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 1.0));
    V p = hn::MulAdd(e, hn::Set(d, 0.2734375), hn::Set(d, 0.3125));
    p = hn::MulAdd(e, p, hn::Set(d, 0.375));
    p = hn::MulAdd(e, p, hn::Set(d, 0.5));
    return hn::MulAdd(hn::Mul(y, e), p, y);
}

// 1 / sqrt(x) for smallest_r2 <= x < 1e38 is computed in two steps. rough_inverse_root() returns the processor's
// estimate, if the processor has one. finish_inverse_root() refines it to two units in the last place.
//
// A division and a square root would take longer than all other work for a pair of a point and a centre.
HWY_INLINE V rough_inverse_root(V x) {
#if HWY_TARGET == HWY_AVX3
    return V{_mm512_rsqrt14_pd(x.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V{_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(x.raw)))};
#else
    return x;
#endif
}

HWY_INLINE V finish_inverse_root(V x, [[maybe_unused]] V rough) {
#if HWY_TARGET == HWY_AVX3
    return polish_inverse_root(x, rough);
#elif HWY_TARGET == HWY_AVX2
    return polish_rough_inverse_root(x, rough); // |e| is at most 1.5 / 2^11, so e^5 is about 2^-52
#else
    return hn::Div(hn::Set(D(), 1.0), hn::Sqrt(x));
#endif
}

HWY_INLINE V inverse_root(V x) { return finish_inverse_root(x, rough_inverse_root(x)); }

// sqrt(x) for the same x, to two units in the last place. The series is that of polish_inverse_root() or
// polish_rough_inverse_root(), times x.
HWY_INLINE V root(V x) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
    const D d;
    const V rough = rough_inverse_root(x);
    const V y = hn::Mul(x, rough);
    const V e = hn::NegMulAdd(y, rough, hn::Set(d, 1.0));
#if HWY_TARGET == HWY_AVX3
    V p = hn::MulAdd(e, hn::Set(d, 0.3125), hn::Set(d, 0.375));
#else
    V p = hn::MulAdd(e, hn::Set(d, 0.2734375), hn::Set(d, 0.3125));
    p = hn::MulAdd(e, p, hn::Set(d, 0.375));
#endif
    p = hn::MulAdd(e, p, hn::Set(d, 0.5));
    return hn::MulAdd(hn::Mul(y, e), p, y);
#else
    return hn::Sqrt(x);
#endif
}

} // namespace hrbfnpr::base::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
