// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/hermite_hessians.cpp"
#include "base/simd.h"

#include "implicit/hermite_hessians.h"
#include "implicit/hermite_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_hessians {
namespace {

// A kernel below writes the term of a source as H = factor (iso I + (e w^T + w e^T) / 2), where e is along d and w is a
// vector that depends on the kernel. This takes 6 products; d d^T, beta d^T and d beta^T would take 12. The sums here
// are without `factor`.
struct Sum {
    V iso;        // added to the diagonal
    V xx, yy, zz; // sums of e_i w_i
    V xy, xz, yz; // sums of e_i w_j + e_j w_i

    static HWY_INLINE Sum zero() {
        const V zero = hn::Zero(D());
        return {zero, zero, zero, zero, zero, zero, zero};
    }
};

struct Weights {
    V alpha, x, y, z;            // alpha and beta
    V twice_x, twice_y, twice_z; // 2 beta

    static HWY_INLINE Weights of(const Sources& s, std::int64_t j) {
        const D d;
        const V x = hn::Set(d, s.beta_x[j]);
        const V y = hn::Set(d, s.beta_y[j]);
        const V z = hn::Set(d, s.beta_z[j]);
        return {hn::Set(d, s.alpha[j]), x, y, z, hn::Add(x, x), hn::Add(y, y), hn::Add(z, z)};
    }
};

HWY_INLINE V along(V x, V y, V z, const Weights& w) { return hn::MulAdd(z, w.z, hn::MulAdd(y, w.y, hn::Mul(x, w.x))); }

HWY_INLINE void add_product(V ex, V ey, V ez, V wx, V wy, V wz, Sum& sum) {
    sum.xx = hn::MulAdd(ex, wx, sum.xx);
    sum.yy = hn::MulAdd(ey, wy, sum.yy);
    sum.zz = hn::MulAdd(ez, wz, sum.zz);
    sum.xy = hn::MulAdd(ey, wx, hn::MulAdd(ex, wy, sum.xy));
    sum.xz = hn::MulAdd(ez, wx, hn::MulAdd(ex, wz, sum.xz));
    sum.yz = hn::MulAdd(ez, wy, hn::MulAdd(ey, wz, sum.yz));
}

// a = 3 r, b = 3 / r, c = -3 / r^3: with the unit vector u = d / r and p = beta . u,
//   H / 3 = (alpha r - p) I + (alpha r + p) u u^T - (beta u^T + u beta^T).
struct Triharmonic : InverseRoot {
    explicit Triharmonic(double) {}
    [[nodiscard]] double factor() const { return 3.0; }

    HWY_INLINE void add(V r2, V inverse, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const V ux = hn::Mul(dx, inverse);
        const V uy = hn::Mul(dy, inverse);
        const V uz = hn::Mul(dz, inverse);
        const V r = hn::Mul(r2, inverse);
        const V p = along(ux, uy, uz, w);
        sum.iso = hn::Add(sum.iso, hn::MulSub(w.alpha, r, p));
        const V outer = hn::MulAdd(w.alpha, r, p);
        add_product(ux, uy, uz, hn::MulSub(outer, ux, w.twice_x), hn::MulSub(outer, uy, w.twice_y),
                    hn::MulSub(outer, uz, w.twice_z), sum);
    }
};

// a = -f phi, b = f^2 phi, c = -f^3 phi with f = 1 / radius^2: with m = alpha / f + beta . d,
//   H / f^2 = -phi m I + phi (f m d d^T - (beta d^T + d beta^T)).
struct Gaussian : Exponential {
    explicit Gaussian(double radius) : Exponential(radius), radius2(radius * radius) {}
    double radius2;
    [[nodiscard]] double factor() const { return falloff * falloff; }

    HWY_INLINE void add(V, V phi, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const D d;
        const V f = hn::Set(d, falloff);
        const V m = hn::MulAdd(w.alpha, hn::Set(d, radius2), along(dx, dy, dz, w));
        sum.iso = hn::NegMulAdd(phi, m, sum.iso);
        const V outer = hn::Mul(f, m);
        add_product(dx, dy, dz, hn::Mul(phi, hn::MulSub(outer, dx, w.twice_x)),
                    hn::Mul(phi, hn::MulSub(outer, dy, w.twice_y)), hn::Mul(phi, hn::MulSub(outer, dz, w.twice_z)),
                    sum);
    }
};

// With g = 60 / R^3, s = r / R and t = max(1 - s, 0): a = -R g t^3 / 3, b = g t^2 / r, c = -g t (1 + s) / r^3.
// With u = d / r and p = beta . u:
//   H / g = -(R / 3 t^3 alpha + t^2 p) I + t ((alpha t r + (1 + s) p) u u^T - t (beta u^T + u beta^T)).
struct WendlandC2 : InverseRoot {
    explicit WendlandC2(double kernel_radius) : radius(kernel_radius), inverse_radius(1.0 / kernel_radius) {}
    double radius, inverse_radius;
    [[nodiscard]] double factor() const { return 60.0 * inverse_radius * inverse_radius * inverse_radius; }

    HWY_INLINE void add(V r2, V inverse, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const D d;
        const V one = hn::Set(d, 1.0);
        const V ux = hn::Mul(dx, inverse);
        const V uy = hn::Mul(dy, inverse);
        const V uz = hn::Mul(dz, inverse);
        const V r = hn::Mul(r2, inverse);
        const V s = hn::Mul(r, hn::Set(d, inverse_radius));
        const V t = hn::Max(hn::Zero(d), hn::Sub(one, s));
        const V at = hn::Mul(w.alpha, t);
        const V p = along(ux, uy, uz, w);
        sum.iso = hn::NegMulAdd(hn::Mul(t, t), hn::MulAdd(at, hn::Set(d, radius / 3.0), p), sum.iso);
        const V outer = hn::MulAdd(at, r, hn::MulAdd(s, p, p));
        const V wx = hn::MulSub(outer, ux, hn::Mul(t, w.twice_x));
        const V wy = hn::MulSub(outer, uy, hn::Mul(t, w.twice_y));
        const V wz = hn::MulSub(outer, uz, hn::Mul(t, w.twice_z));
        add_product(ux, uy, uz, hn::Mul(t, wx), hn::Mul(t, wy), hn::Mul(t, wz), sum);
    }
};

// Adds `sum` in the lanes of the mask. The other lanes of memory are neither read nor written.
HWY_INLINE void add_to(double* at, V sum, hn::Mask<D> mask) {
    hn::BlendedStore(hn::Add(hn::MaskedLoad(mask, D(), at), sum), mask, D(), at);
}

// Evaluates `n` vectors of targets, beginning with target `at`. The last vector may be only partly filled.
template <int n, class Kernel>
HWY_INLINE void add_vectors(const Kernel& kernel, const Sources& s, const HessianTargets& t, std::int64_t at) {
    const D d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    V x[unroll], y[unroll], z[unroll];
    hn::Mask<D> mask[unroll];
    Sum sum[unroll];
    for (int u = 0; u < n; ++u) {
        const std::int64_t begin = at + u * lanes;
        mask[u] = hn::FirstN(d, static_cast<size_t>(t.count - begin < lanes ? t.count - begin : lanes));
        x[u] = hn::MaskedLoad(mask[u], d, t.x + begin);
        y[u] = hn::MaskedLoad(mask[u], d, t.y + begin);
        z[u] = hn::MaskedLoad(mask[u], d, t.z + begin);
    }
    sum_up<n, Weights>(kernel, s, x, y, z, sum);
    const V factor = hn::Set(d, kernel.factor());
    const V half = hn::Set(d, 0.5 * kernel.factor());
    for (int u = 0; u < n; ++u) {
        const std::int64_t begin = at + u * lanes;
        add_to(t.hessian[0] + begin, hn::Mul(factor, hn::Add(sum[u].iso, sum[u].xx)), mask[u]);
        add_to(t.hessian[1] + begin, hn::Mul(half, sum[u].xy), mask[u]);
        add_to(t.hessian[2] + begin, hn::Mul(half, sum[u].xz), mask[u]);
        add_to(t.hessian[3] + begin, hn::Mul(factor, hn::Add(sum[u].iso, sum[u].yy)), mask[u]);
        add_to(t.hessian[4] + begin, hn::Mul(half, sum[u].yz), mask[u]);
        add_to(t.hessian[5] + begin, hn::Mul(factor, hn::Add(sum[u].iso, sum[u].zz)), mask[u]);
    }
}

template <class Kernel>
void add_hessians(double radius, const Sources& sources, const HessianTargets& targets) {
    const Kernel kernel(radius);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(D()));
    std::int64_t at = 0;
    for (; at + unroll * lanes <= targets.count; at += unroll * lanes)
        add_vectors<unroll>(kernel, sources, targets, at);
    for (; at < targets.count; at += lanes) add_vectors<1>(kernel, sources, targets, at);
}

} // namespace

AddHermiteHessians pick(kernel::Kind kind) noexcept {
    switch (kind) {
    case kernel::Kind::gaussian: return add_hessians<Gaussian>;
    case kernel::Kind::wendland_c2: return add_hessians<WendlandC2>;
    case kernel::Kind::triharmonic: break;
    }
    return add_hessians<Triharmonic>;
}

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_hessians
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::implicit {

AddHermiteHessians hermite_hessians(base::InstructionSet set, kernel::Kind kind) noexcept {
    return HRBFNPR_PICK(set, hermite_hessians::pick)(kind);
}

} // namespace hrbfnpr::implicit
#endif
