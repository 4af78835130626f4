// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/hermite_thirds.cpp"
#include "base/simd.h"

#include "base/simd_math-inl.h"
#include "implicit/hermite_thirds.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_thirds {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::inverse_root;
using base::HWY_NAMESPACE::smallest_r2;
using base::HWY_NAMESPACE::V;

struct RadialV {
    V a, b, c, e;
};

// phi = R^3.
struct Triharmonic {
    explicit Triharmonic(double) {}

    HWY_INLINE RadialV at(V r2) const {
        const D d;
        const V inverse = inverse_root(hn::Max(r2, hn::Set(d, smallest_r2)));
        const V inverse2 = hn::Mul(inverse, inverse);
        const V b = hn::Mul(hn::Set(d, 3.0), inverse);
        const V bc = hn::Mul(b, inverse2);
        return {hn::Mul(b, r2), b, hn::Neg(bc), hn::Mul(hn::Mul(hn::Set(d, 3.0), bc), inverse2)};
    }
};

struct Gaussian {
    explicit Gaussian(double radius) : falloff(1.0 / (radius * radius)) {}
    double falloff;

    HWY_INLINE RadialV at(V r2) const {
        const D d;
        const V f = hn::Set(d, falloff);
        const V exponent = hn::Mul(hn::Mul(f, hn::Set(d, -0.5)), r2);
        const V a = hn::Neg(hn::Mul(f, hn::Exp(d, hn::Max(exponent, hn::Set(d, -700.0)))));
        const V b = hn::Neg(hn::Mul(f, a));
        const V c = hn::Neg(hn::Mul(f, b));
        return {a, b, c, hn::Neg(hn::Mul(f, c))};
    }
};

// With K = 60 / radius^3, s = R / radius, t = max(1 - s, 0):
//   a = -K radius t^3 / 3, b = K t^2 / R, c = -K t (1 + s) / R^3, e = K (3 - s^2) / R^5 if t > 0, else 0.
struct WendlandC2 {
    explicit WendlandC2(double kernel_radius) : radius(kernel_radius), inverse_radius(1.0 / kernel_radius) {}
    double radius, inverse_radius;

    HWY_INLINE RadialV at(V r2) const {
        const D d;
        const V one = hn::Set(d, 1.0);
        const V zero = hn::Zero(d);
        const V k = hn::Set(d, 60.0 * inverse_radius * inverse_radius * inverse_radius);
        const V inverse = inverse_root(hn::Max(r2, hn::Set(d, smallest_r2)));
        const V inverse2 = hn::Mul(inverse, inverse);
        const V s = hn::Mul(hn::Mul(r2, inverse), hn::Set(d, inverse_radius));
        const V t = hn::Max(zero, hn::Sub(one, s));
        const V kt = hn::Mul(k, t);
        const V ktt = hn::Mul(kt, t);
        const V cubed = hn::Mul(inverse, inverse2);
        const V e = hn::Mul(hn::Mul(k, hn::NegMulAdd(s, s, hn::Set(d, 3.0))), hn::Mul(cubed, inverse2));
        return {hn::Mul(hn::Mul(ktt, t), hn::Set(d, -radius / 3.0)), hn::Mul(ktt, inverse),
                hn::Neg(hn::Mul(hn::MulAdd(kt, s, kt), cubed)), hn::IfThenElse(hn::Gt(t, zero), e, zero)};
    }
};

struct Sum {
    V iso, xx, yy, zz, xy, xz, yz; // as in hermite_hessians.cpp; off-diagonal sums are twice the Hessian's element
    V vx, vy, vz;                  // the sum of v in sym(delta, v)
    V third[10];                   // the sum of sym(w, d, d)
};

HWY_INLINE Sum zero_sum() {
    const V zero = hn::Zero(D());
    Sum sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, {}};
    for (V& component : sum.third) component = zero;
    return sum;
}

HWY_INLINE void add_hessian(V dx, V dy, V dz, V ux, V uy, V uz, Sum& sum) {
    sum.xx = hn::MulAdd(dx, ux, sum.xx);
    sum.yy = hn::MulAdd(dy, uy, sum.yy);
    sum.zz = hn::MulAdd(dz, uz, sum.zz);
    sum.xy = hn::MulAdd(dy, ux, hn::MulAdd(dx, uy, sum.xy));
    sum.xz = hn::MulAdd(dz, ux, hn::MulAdd(dx, uz, sum.xz));
    sum.yz = hn::MulAdd(dz, uy, hn::MulAdd(dy, uz, sum.yz));
}

HWY_INLINE void add_third(V dx, V dy, V dz, V wx, V wy, V wz, V (&t)[10]) {
    const V two = hn::Set(D(), 2.0);
    const V three = hn::Set(D(), 3.0);
    const V xx = hn::Mul(dx, dx), yy = hn::Mul(dy, dy), zz = hn::Mul(dz, dz);
    const V xy = hn::Mul(dx, dy), xz = hn::Mul(dx, dz), yz = hn::Mul(dy, dz);
    const V wx2 = hn::Mul(two, wx), wy2 = hn::Mul(two, wy), wz2 = hn::Mul(two, wz);
    t[0] = hn::MulAdd(hn::Mul(three, wx), xx, t[0]);
    t[1] = hn::MulAdd(wx2, xy, hn::MulAdd(wy, xx, t[1]));
    t[2] = hn::MulAdd(wx2, xz, hn::MulAdd(wz, xx, t[2]));
    t[3] = hn::MulAdd(wy2, xy, hn::MulAdd(wx, yy, t[3]));
    t[4] = hn::MulAdd(wx, yz, hn::MulAdd(wy, xz, hn::MulAdd(wz, xy, t[4])));
    t[5] = hn::MulAdd(wz2, xz, hn::MulAdd(wx, zz, t[5]));
    t[6] = hn::MulAdd(hn::Mul(three, wy), yy, t[6]);
    t[7] = hn::MulAdd(wy2, yz, hn::MulAdd(wz, yy, t[7]));
    t[8] = hn::MulAdd(wz2, yz, hn::MulAdd(wy, zz, t[8]));
    t[9] = hn::MulAdd(hn::Mul(three, wz), zz, t[9]);
}

template <class Kernel>
HWY_INLINE void add_source(const Kernel& kernel, double smoothing, const Sources& s, std::int64_t j, V x, V y, V z,
                           Sum& sum) {
    const D d;
    const V dx = hn::Sub(x, hn::Set(d, s.x[j])), dy = hn::Sub(y, hn::Set(d, s.y[j])),
            dz = hn::Sub(z, hn::Set(d, s.z[j]));
    const V alpha = hn::Set(d, s.alpha[j]);
    const V bx = hn::Set(d, s.beta_x[j]), by = hn::Set(d, s.beta_y[j]), bz = hn::Set(d, s.beta_z[j]);
    const V r2 = hn::MulAdd(dz, dz, hn::MulAdd(dy, dy, hn::MulAdd(dx, dx, hn::Set(d, smoothing))));
    const RadialV k = kernel.at(r2);
    const V q = hn::MulAdd(dz, bz, hn::MulAdd(dy, by, hn::Mul(dx, bx)));
    const V outer = hn::NegMulAdd(k.c, q, hn::Mul(k.b, alpha));
    const V kbx = hn::Mul(k.b, bx), kby = hn::Mul(k.b, by), kbz = hn::Mul(k.b, bz);
    const V vx = hn::MulSub(outer, dx, kbx), vy = hn::MulSub(outer, dy, kby), vz = hn::MulSub(outer, dz, kbz);
    sum.iso = hn::Add(sum.iso, hn::NegMulAdd(k.b, q, hn::Mul(k.a, alpha)));
    add_hessian(dx, dy, dz, hn::Sub(vx, kbx), hn::Sub(vy, kby), hn::Sub(vz, kbz), sum);
    sum.vx = hn::Add(sum.vx, vx);
    sum.vy = hn::Add(sum.vy, vy);
    sum.vz = hn::Add(sum.vz, vz);
    const V along = hn::Mul(hn::NegMulAdd(k.e, q, hn::Mul(k.c, alpha)), hn::Set(d, 1.0 / 3.0));
    add_third(dx, dy, dz, hn::MulSub(along, dx, hn::Mul(k.c, bx)), hn::MulSub(along, dy, hn::Mul(k.c, by)),
              hn::MulSub(along, dz, hn::Mul(k.c, bz)), sum.third);
}

// Adds `sum` in the lanes of the mask. The other lanes of memory are neither read nor written.
HWY_INLINE void add_to(double* at, V sum, hn::Mask<D> mask) {
    hn::BlendedStore(hn::Add(hn::MaskedLoad(mask, D(), at), sum), mask, D(), at);
}

HWY_INLINE void store(const Sum& s, const ThirdTargets& t, std::int64_t at, hn::Mask<D> mask) {
    const V half = hn::Set(D(), 0.5);
    const V three = hn::Set(D(), 3.0);
    const V hessian[6] = {hn::Add(s.iso, s.xx), hn::Mul(half, s.xy), hn::Mul(half, s.xz),
                          hn::Add(s.iso, s.yy), hn::Mul(half, s.yz), hn::Add(s.iso, s.zz)};
    for (int c = 0; c < 6; ++c) add_to(t.hessian[c] + at, hessian[c], mask);
    const V zero = hn::Zero(D());
    const V trace[10] = {hn::Mul(three, s.vx), s.vy, s.vz, s.vx, zero, s.vx, hn::Mul(three, s.vy), s.vz, s.vy,
                         hn::Mul(three, s.vz)};
    for (int c = 0; c < 10; ++c) add_to(t.third[c] + at, hn::Add(s.third[c], trace[c]), mask);
}

template <class Kernel>
void add_thirds(double radius, double smoothing, const Sources& sources, const ThirdTargets& t) {
    const D d;
    const Kernel kernel(radius);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < t.count; at += lanes) {
        const auto mask = hn::FirstN(d, static_cast<size_t>(t.count - at < lanes ? t.count - at : lanes));
        const V x = hn::MaskedLoad(mask, d, t.x + at);
        const V y = hn::MaskedLoad(mask, d, t.y + at);
        const V z = hn::MaskedLoad(mask, d, t.z + at);
        Sum sum = zero_sum();
        for (std::int64_t j = 0; j < sources.count; ++j) add_source(kernel, smoothing, sources, j, x, y, z, sum);
        store(sum, t, at, mask);
    }
}

} // namespace

AddHermiteThirds pick(kernel::Kind kind) noexcept {
    switch (kind) {
    case kernel::Kind::gaussian: return add_thirds<Gaussian>;
    case kernel::Kind::wendland_c2: return add_thirds<WendlandC2>;
    case kernel::Kind::triharmonic: break;
    }
    return add_thirds<Triharmonic>;
}

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_thirds
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::implicit {

AddHermiteThirds hermite_thirds(base::InstructionSet set, kernel::Kind kind) noexcept {
    return HRBFNPR_PICK(set, hermite_thirds::pick)(kind);
}

} // namespace hrbfnpr::implicit
#endif
