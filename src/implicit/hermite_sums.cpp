// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/hermite_sums.cpp"
#include "base/simd.h"

#include "implicit/hermite_pairs-inl.h"
#include "implicit/hermite_sums.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_sums {
namespace {

struct Sum {
    V value, x, y, z;

    static HWY_INLINE Sum zero() {
        const V zero = hn::Zero(D());
        return {zero, zero, zero, zero};
    }
};

struct Weights {
    V alpha, x, y, z;

    static HWY_INLINE Weights of(const Sources& s, std::int64_t j) {
        const D d;
        return {hn::Set(d, s.alpha[j]), hn::Set(d, s.beta_x[j]), hn::Set(d, s.beta_y[j]), hn::Set(d, s.beta_z[j])};
    }
};

// phi = r^3, a = 3 r, b = 3 / r.  The sum of the gradient is kept without its factor 3.
struct Triharmonic : InverseRoot {
    static constexpr double gradient_factor = 3.0;
    explicit Triharmonic(double) {}

    HWY_INLINE void add(V r2, V inverse, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const V r = hn::Mul(r2, inverse);
        const V s = hn::MulAdd(dz, w.z, hn::MulAdd(dy, w.y, hn::Mul(dx, w.x)));
        const V rest = hn::MulSub(r2, w.alpha, s); // r^2 alpha - s
        // Processors add and multiply side by side, so sums are not fused with products here.
        sum.value = hn::MulAdd(r, hn::Sub(rest, hn::Add(s, s)), sum.value);
        const V along = hn::Mul(rest, inverse);
        sum.x = hn::NegMulAdd(r, w.x, hn::MulAdd(along, dx, sum.x));
        sum.y = hn::NegMulAdd(r, w.y, hn::MulAdd(along, dy, sum.y));
        sum.z = hn::NegMulAdd(r, w.z, hn::MulAdd(along, dz, sum.z));
    }
};

// Adds the term of a source for any kernel, given the kernel's phi, a and b.
HWY_INLINE void add_radial(V phi, V a, V b, V dx, V dy, V dz, const Weights& w, Sum& sum) {
    const V s = hn::MulAdd(dz, w.z, hn::MulAdd(dy, w.y, hn::Mul(dx, w.x)));
    sum.value = hn::NegMulAdd(a, s, hn::MulAdd(phi, w.alpha, sum.value));
    const V along = hn::NegMulAdd(b, s, hn::Mul(a, w.alpha));
    sum.x = hn::NegMulAdd(a, w.x, hn::MulAdd(along, dx, sum.x));
    sum.y = hn::NegMulAdd(a, w.y, hn::MulAdd(along, dy, sum.y));
    sum.z = hn::NegMulAdd(a, w.z, hn::MulAdd(along, dz, sum.z));
}

struct Gaussian : Exponential {
    static constexpr double gradient_factor = 1.0;
    using Exponential::Exponential;

    HWY_INLINE void add(V, V phi, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const V f = hn::Set(D(), falloff);
        const V a = hn::Neg(hn::Mul(f, phi));
        add_radial(phi, a, hn::Neg(hn::Mul(f, a)), dx, dy, dz, w, sum);
    }
};

struct WendlandC2 : InverseRoot {
    static constexpr double gradient_factor = 1.0;
    explicit WendlandC2(double radius) : inverse_radius(1.0 / radius) {}
    double inverse_radius;

    HWY_INLINE void add(V r2, V inverse, V dx, V dy, V dz, const Weights& w, Sum& sum) const {
        const D d;
        const V s = hn::Mul(hn::Mul(r2, inverse), hn::Set(d, inverse_radius));
        const V t = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0), s));
        const V t2 = hn::Mul(t, t);
        const V phi = hn::Mul(hn::Mul(t2, t2), hn::MulAdd(s, hn::Set(d, 4.0), hn::Set(d, 1.0)));
        const double falloff = 20.0 * inverse_radius * inverse_radius;
        const V a = hn::Mul(hn::Set(d, -falloff), hn::Mul(t2, t));
        const V b = hn::Mul(hn::Set(d, 3.0 * falloff * inverse_radius), hn::Mul(t2, inverse));
        add_radial(phi, a, b, dx, dy, dz, w, sum);
    }
};

HWY_INLINE void add_to(double* at, V sum) { hn::StoreU(hn::Add(hn::LoadU(D(), at), sum), D(), at); }

template <class Kernel>
HWY_INLINE void add_full(const Kernel& kernel, const Sources& s, const Targets& t, std::int64_t at) {
    const D d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    V x[unroll], y[unroll], z[unroll];
    Sum sum[unroll];
    for (int u = 0; u < unroll; ++u) {
        x[u] = hn::LoadU(d, t.x + at + u * lanes);
        y[u] = hn::LoadU(d, t.y + at + u * lanes);
        z[u] = hn::LoadU(d, t.z + at + u * lanes);
    }
    sum_up<unroll, Weights>(kernel, s, x, y, z, sum);
    const V factor = hn::Set(d, Kernel::gradient_factor);
    for (int u = 0; u < unroll; ++u) {
        add_to(t.value + at + u * lanes, sum[u].value);
        add_to(t.gradient_x + at + u * lanes, hn::Mul(factor, sum[u].x));
        add_to(t.gradient_y + at + u * lanes, hn::Mul(factor, sum[u].y));
        add_to(t.gradient_z + at + u * lanes, hn::Mul(factor, sum[u].z));
    }
}

// Adds `sum` in the lanes of the mask. The other lanes of memory are neither read nor written.
HWY_INLINE void add_some(double* at, V sum, hn::Mask<D> mask) {
    hn::BlendedStore(hn::Add(hn::MaskedLoad(mask, D(), at), sum), mask, D(), at);
}

template <class Kernel>
HWY_INLINE void add_part(const Kernel& kernel, const Sources& s, const Targets& t, std::int64_t at,
                         std::int64_t count) {
    const D d;
    const auto mask = hn::FirstN(d, static_cast<size_t>(count));
    const V x = hn::MaskedLoad(mask, d, t.x + at);
    const V y = hn::MaskedLoad(mask, d, t.y + at);
    const V z = hn::MaskedLoad(mask, d, t.z + at);
    Sum sum;
    sum_up<1, Weights>(kernel, s, &x, &y, &z, &sum);
    const V factor = hn::Set(d, Kernel::gradient_factor);
    add_some(t.value + at, sum.value, mask);
    add_some(t.gradient_x + at, hn::Mul(factor, sum.x), mask);
    add_some(t.gradient_y + at, hn::Mul(factor, sum.y), mask);
    add_some(t.gradient_z + at, hn::Mul(factor, sum.z), mask);
}

template <class Kernel>
void add_sums(double radius, const Sources& sources, const Targets& targets) {
    const Kernel kernel(radius);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(D()));
    std::int64_t at = 0;
    for (; at + unroll * lanes <= targets.count; at += unroll * lanes) add_full(kernel, sources, targets, at);
    for (; at < targets.count; at += lanes)
        add_part(kernel, sources, targets, at, targets.count - at < lanes ? targets.count - at : lanes);
}

} // namespace

AddHermiteSums pick_sums(kernel::Kind kind) noexcept {
    switch (kind) {
    case kernel::Kind::gaussian: return add_sums<Gaussian>;
    case kernel::Kind::wendland_c2: return add_sums<WendlandC2>;
    case kernel::Kind::triharmonic: break;
    }
    return add_sums<Triharmonic>;
}

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_sums
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::implicit {

AddHermiteSums hermite_sums(base::InstructionSet set, kernel::Kind kind) noexcept {
    return HRBFNPR_PICK(set, hermite_sums::pick_sums)(kind);
}

} // namespace hrbfnpr::implicit
#endif
