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

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::finish_inverse_root;
using base::HWY_NAMESPACE::rough_inverse_root;
using base::HWY_NAMESPACE::smallest_r2;
using base::HWY_NAMESPACE::V;

// The number of target vectors that a source is applied to at a time; it is limited by the number of registers.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON
constexpr int unroll = 2;
#else
constexpr int unroll = 1;
#endif

// The number of sources whose radial functions are computed before their terms are summed. For a single source, the
// operations form a chain of 70 cycles. The scheduler of Zen 3 holds 64 waiting operations, which is little more than
// one chain, so few chains overlap. With one source at a time, a SIMD vector takes 24 cycles; with 16 sources at a
// time, it takes 18 cycles.
#if HWY_TARGET == HWY_AVX2
constexpr std::int64_t ahead = 16;
#else
constexpr std::int64_t ahead = 1;
#endif

// The radial function 1 / r, from which some kernels are computed.
struct InverseRoot {
    static HWY_INLINE V at_least(V r2) { return hn::Max(r2, hn::Set(D(), smallest_r2)); }
    HWY_INLINE V begin(V r2) const { return rough_inverse_root(at_least(r2)); }
    HWY_INLINE V finish(V r2, V begun) const { return finish_inverse_root(at_least(r2), begun); }
};

// The radial function exp(-r^2 / (2 radius^2)), from which the Gaussian kernel is computed.
struct Exponential {
    explicit Exponential(double radius) : falloff(1.0 / (radius * radius)) {}
    double falloff;

    HWY_INLINE V begin(V r2) const { return hn::Mul(hn::Set(D(), -0.5 * falloff), r2); }
    HWY_INLINE V finish(V, V begun) const { return hn::Exp(D(), hn::Max(begun, hn::Set(D(), -700.0))); }
};

// The coordinates of `n` vectors of targets.
template <int n>
struct TargetVectors {
    const V* x;
    const V* y;
    const V* z;

    struct Offset {
        V x, y, z, r2;
    };
    HWY_INLINE Offset from(const Sources& s, std::int64_t j, int u) const {
        const D d;
        const V dx = hn::Sub(x[u], hn::Set(d, s.x[j]));
        const V dy = hn::Sub(y[u], hn::Set(d, s.y[j]));
        const V dz = hn::Sub(z[u], hn::Set(d, s.z[j]));
        return {dx, dy, dz, hn::MulAdd(dz, dz, hn::MulAdd(dy, dy, hn::Mul(dx, dx)))};
    }
};

// Computes the radial functions of the sources [first, first + count), and then adds their terms.
template <int n, class Weights, class Kernel, class Sum>
HWY_INLINE void sum_some(const Kernel& kernel, const Sources& s, std::int64_t first, std::int64_t count,
                         const TargetVectors<n>& to, Sum* sum) {
    V r2[static_cast<size_t>(ahead)][static_cast<size_t>(n)];
    V radial[static_cast<size_t>(ahead)][static_cast<size_t>(n)];
    for (std::int64_t k = 0; k < count; ++k)
        for (int u = 0; u < n; ++u) {
            r2[k][u] = to.from(s, first + k, u).r2;
            radial[k][u] = kernel.begin(r2[k][u]);
        }
    for (std::int64_t k = 0; k < count; ++k)
        for (int u = 0; u < n; ++u) radial[k][u] = kernel.finish(r2[k][u], radial[k][u]);
    for (std::int64_t k = 0; k < count; ++k) {
        const Weights w = Weights::of(s, first + k);
        for (int u = 0; u < n; ++u) {
            const auto d = to.from(s, first + k, u);
            kernel.add(r2[k][u], radial[k][u], d.x, d.y, d.z, w, sum[u]);
        }
    }
}

// Sums all sources at the targets. kernel.begin() and finish() compute the radial function of a pair, and kernel.add()
// adds the pair's term from its squared distance, that function and its differences along the axes. Sum::zero() starts
// a sum, and Weights::of() loads the weights of a source.
template <int n, class Weights, class Kernel, class Sum>
HWY_INLINE void sum_up(const Kernel& kernel, const Sources& s, const V* x, const V* y, const V* z, Sum* sum) {
    const TargetVectors<n> to{x, y, z};
    for (int u = 0; u < n; ++u) sum[u] = Sum::zero();
    if constexpr (ahead > 1) {
        for (std::int64_t first = 0; first < s.count; first += ahead)
            sum_some<n, Weights>(kernel, s, first, s.count - first < ahead ? s.count - first : ahead, to, sum);
    } else {
        for (std::int64_t j = 0; j < s.count; ++j) {
            const Weights w = Weights::of(s, j);
            for (int u = 0; u < n; ++u) {
                const auto d = to.from(s, j, u);
                kernel.add(d.r2, kernel.finish(d.r2, kernel.begin(d.r2)), d.x, d.y, d.z, w, sum[u]);
            }
        }
    }
}

} // namespace hrbfnpr::implicit::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
