// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/mirrored_sums.cpp"
#include "base/simd.h"

#include "base/simd_math-inl.h"
#include "implicit/mirrored_sums.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::mirrored_sums {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::root;
using base::HWY_NAMESPACE::V;

HWY_INLINE V broadcast(const double* at) { return hn::Set(D(), *at); }

// The squared distance r^2, and the factor of r in the sum.
struct Term {
    V square, factor;

    HWY_INLINE Term plus(V dx, V dy) const { return {hn::Add(square, dx), hn::Add(factor, dy)}; }
    HWY_INLINE Term minus(V dx, V dy) const { return {hn::Sub(square, dx), hn::Sub(factor, dy)}; }
    HWY_INLINE V times_distance(V sum) const { return hn::MulAdd(root(square), factor, sum); }
};

// The mirror images of a node share the products of its coordinates, which only change their signs.
HWY_INLINE void add_vector(const MirroredNodes& nodes, const MirroredSources& s, std::int64_t at, double* values) {
    const D d;
    const V x = hn::LoadU(d, nodes.x + at);
    const V y = hn::LoadU(d, nodes.y + at);
    const V z = hn::LoadU(d, nodes.z + at);
    const V squared = hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x)));
    V sum[8];
    for (int sign = 0; sign < 8; ++sign) sum[sign] = hn::LoadU(d, values + sign * nodes.groups + at);
    for (std::int64_t j = 0; j < s.count; ++j) {
        const Term middle{hn::Add(squared, broadcast(s.square + j)),
                          hn::MulAdd(squared, broadcast(s.alpha + j), broadcast(s.constant + j))};
        const V x_across = hn::Mul(x, broadcast(s.across[0] + j));
        const V y_across = hn::Mul(y, broadcast(s.across[1] + j));
        const V z_across = hn::Mul(z, broadcast(s.across[2] + j));
        const V x_along = hn::Mul(x, broadcast(s.along[0] + j));
        const V y_along = hn::Mul(y, broadcast(s.along[1] + j));
        const V z_along = hn::Mul(z, broadcast(s.along[2] + j));
        const Term right = middle.plus(x_across, x_along);
        const Term left = middle.minus(x_across, x_along);
        const Term row[4] = {right.plus(y_across, y_along), left.plus(y_across, y_along),
                             right.minus(y_across, y_along), left.minus(y_across, y_along)};
        for (int k = 0; k < 4; ++k) {
            sum[k] = row[k].plus(z_across, z_along).times_distance(sum[k]);
            sum[k + 4] = row[k].minus(z_across, z_along).times_distance(sum[k + 4]);
        }
    }
    for (int sign = 0; sign < 8; ++sign) hn::StoreU(sum[sign], d, values + sign * nodes.groups + at);
}

void add(const MirroredNodes& nodes, const MirroredSources& sources, double* values) {
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(D()));
    for (std::int64_t at = 0; at < nodes.groups; at += lanes) add_vector(nodes, sources, at, values);
}

} // namespace

AddMirroredSums pick() noexcept { return add; }

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::mirrored_sums
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::implicit, AddMirroredSums, mirrored_sums, mirrored_sums::pick)
