// SPDX-License-Identifier: MIT
// The loop over pairs of a source and a target, for all kernels; compiled once for each instruction set.
#if defined(HRBFNPR_HERMITE_PAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HRBFNPR_HERMITE_PAIRS_INL
#undef HRBFNPR_HERMITE_PAIRS_INL
#else
#define HRBFNPR_HERMITE_PAIRS_INL
#endif

#include "base/simd_math-inl.h"
#include "implicit/hermite_sums.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::inverse_root;
using base::HWY_NAMESPACE::smallest_r2;
using base::HWY_NAMESPACE::V;

// Vectors of targets that one source is applied to at a time, as registers allow.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON
constexpr int unroll = 2;
#else
constexpr int unroll = 1;
#endif

// All sources at the targets of `n` vectors: what kernel.add() makes of each pair, by its distance squared and along
// the axes.  Sum::zero() begins, Weights::of() takes what a source weighs.
template <int n, class Weights, class Kernel, class Sum>
HWY_INLINE void sum_up(const Kernel& kernel, const Sources& s, const V* x, const V* y, const V* z, Sum* sum) {
    const D d;
    for (int u = 0; u < n; ++u) sum[u] = Sum::zero();
    for (std::int64_t j = 0; j < s.count; ++j) {
        const Weights w = Weights::of(s, j);
        const V sx = hn::Set(d, s.x[j]);
        const V sy = hn::Set(d, s.y[j]);
        const V sz = hn::Set(d, s.z[j]);
        for (int u = 0; u < n; ++u) {
            const V dx = hn::Sub(x[u], sx);
            const V dy = hn::Sub(y[u], sy);
            const V dz = hn::Sub(z[u], sz);
            const V r2 = hn::MulAdd(dz, dz, hn::MulAdd(dy, dy, hn::Mul(dx, dx)));
            kernel.add(r2, dx, dy, dz, w, sum[u]);
        }
    }
}

} // namespace hrbfnpr::implicit::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
