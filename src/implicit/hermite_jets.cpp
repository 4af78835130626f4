// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/hermite_jets.cpp"
#include "base/simd.h"

#include "base/simd_math-inl.h"
#include "implicit/hermite_jets.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_jets {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::inverse_root;
using base::HWY_NAMESPACE::smallest_r2;
using base::HWY_NAMESPACE::V;

// The same sums as in hermite_sums.cpp and hermite_hessians.cpp: with u = d / r, p = beta . u, s = beta . d,
//   value:         r (r^2 alpha - 3 s)
//   gradient / 3:  (alpha r - p) d - r beta
//   Hessian / 3:   (alpha r - p) I + (alpha r + p) u u^T - (beta u^T + u beta^T)
struct Sum {
    V value, x, y, z;
    V iso, xx, yy, zz, xy, xz, yz;

    static HWY_INLINE Sum zero() {
        const V zero = hn::Zero(D());
        return {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    }
    HWY_INLINE void add(V dx, V dy, V dz, V alpha, V bx, V by, V bz) {
        const D d;
        const V r2 = hn::MulAdd(dz, dz, hn::MulAdd(dy, dy, hn::Mul(dx, dx)));
        const V inverse = inverse_root(hn::Max(r2, hn::Set(d, smallest_r2)));
        const V r = hn::Mul(r2, inverse);
        const V s = hn::MulAdd(dz, bz, hn::MulAdd(dy, by, hn::Mul(dx, bx)));
        value = hn::MulAdd(r, hn::MulSub(r2, alpha, hn::Mul(s, hn::Set(d, 3.0))), value);
        const V p = hn::Mul(s, inverse);
        const V along = hn::MulSub(r, alpha, p);
        x = hn::NegMulAdd(r, bx, hn::MulAdd(along, dx, x));
        y = hn::NegMulAdd(r, by, hn::MulAdd(along, dy, y));
        z = hn::NegMulAdd(r, bz, hn::MulAdd(along, dz, z));
        iso = hn::Add(iso, along);
        const V outer = hn::MulAdd(r, alpha, p);
        const V ux = hn::Mul(dx, inverse);
        const V uy = hn::Mul(dy, inverse);
        const V uz = hn::Mul(dz, inverse);
        const V wx = hn::MulSub(outer, ux, hn::Add(bx, bx));
        const V wy = hn::MulSub(outer, uy, hn::Add(by, by));
        const V wz = hn::MulSub(outer, uz, hn::Add(bz, bz));
        xx = hn::MulAdd(ux, wx, xx);
        yy = hn::MulAdd(uy, wy, yy);
        zz = hn::MulAdd(uz, wz, zz);
        xy = hn::MulAdd(uy, wx, hn::MulAdd(ux, wy, xy));
        xz = hn::MulAdd(uz, wx, hn::MulAdd(ux, wz, xz));
        yz = hn::MulAdd(uz, wy, hn::MulAdd(uy, wz, yz));
    }
};

HWY_INLINE void add_to(double& at, double factor, V sum) { at += factor * hn::GetLane(hn::SumOfLanes(D(), sum)); }

// Adds a range of sources. Lanes beyond the end of the range have weight 0.
HWY_INLINE void add_range(const Sources& s, const SourceRange& range, V px, V py, V pz, Sum& sum) {
    const D d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    std::int64_t j = range.begin;
    for (; j + lanes <= range.end; j += lanes)
        sum.add(hn::Sub(px, hn::LoadU(d, s.x + j)), hn::Sub(py, hn::LoadU(d, s.y + j)),
                hn::Sub(pz, hn::LoadU(d, s.z + j)), hn::LoadU(d, s.alpha + j), hn::LoadU(d, s.beta_x + j),
                hn::LoadU(d, s.beta_y + j), hn::LoadU(d, s.beta_z + j));
    if (j >= range.end) return;
    const auto mask = hn::FirstN(d, static_cast<size_t>(range.end - j));
    sum.add(hn::Sub(px, hn::MaskedLoad(mask, d, s.x + j)), hn::Sub(py, hn::MaskedLoad(mask, d, s.y + j)),
            hn::Sub(pz, hn::MaskedLoad(mask, d, s.z + j)), hn::MaskedLoad(mask, d, s.alpha + j),
            hn::MaskedLoad(mask, d, s.beta_x + j), hn::MaskedLoad(mask, d, s.beta_y + j),
            hn::MaskedLoad(mask, d, s.beta_z + j));
}

void add_jets(const Sources& sources, const SourceRange* ranges, std::int64_t count, const JetTargets& t) {
    const D d;
    for (std::int64_t i = 0; i < t.count; ++i) {
        const V x = hn::Set(d, t.x[i]);
        const V y = hn::Set(d, t.y[i]);
        const V z = hn::Set(d, t.z[i]);
        Sum sum = Sum::zero();
        for (std::int64_t k = 0; k < count; ++k) add_range(sources, ranges[k], x, y, z, sum);
        add_to(t.value[i], 1.0, sum.value);
        add_to(t.gradient[0][i], 3.0, sum.x);
        add_to(t.gradient[1][i], 3.0, sum.y);
        add_to(t.gradient[2][i], 3.0, sum.z);
        add_to(t.hessian[0][i], 3.0, hn::Add(sum.iso, sum.xx));
        add_to(t.hessian[1][i], 1.5, sum.xy);
        add_to(t.hessian[2][i], 1.5, sum.xz);
        add_to(t.hessian[3][i], 3.0, hn::Add(sum.iso, sum.yy));
        add_to(t.hessian[4][i], 1.5, sum.yz);
        add_to(t.hessian[5][i], 3.0, hn::Add(sum.iso, sum.zz));
    }
}

} // namespace

AddTriharmonicJets pick() noexcept { return add_jets; }

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::hermite_jets
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::implicit, AddTriharmonicJets, triharmonic_jets_of, hermite_jets::pick)
