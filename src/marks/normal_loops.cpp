// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "marks/normal_loops.cpp"
#include "base/simd.h"

#include "marks/normal_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::marks::HWY_NAMESPACE::normal_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, NormalSums::size>;
using V = hn::Vec<D>;

HWY_INLINE std::int64_t lanes() { return static_cast<std::int64_t>(hn::Lanes(D())); }

// Each product and each sum is rounded separately, because a fused multiply-add gives different bits and does not exist
// on all targets.
HWY_INLINE V dot(V ax, V ay, V az, V bx, V by, V bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

// Adds the normals to the marks `first` to first + lanes() - 1.
HWY_INLINE void add_to_lanes(const PointsWithNormals& points, const std::int32_t* at, std::int64_t count,
                             const NormalLimits& limits, std::int64_t first, NormalSums& sums) {
    const D d;
    const V x = hn::LoadU(d, sums.x + first);
    const V y = hn::LoadU(d, sums.y + first);
    const V z = hn::LoadU(d, sums.z + first);
    const V nx = hn::LoadU(d, sums.nx + first);
    const V ny = hn::LoadU(d, sums.ny + first);
    const V nz = hn::LoadU(d, sums.nz + first);
    const V sheet = hn::LoadU(d, sums.sheet + first);
    V sum_x = hn::LoadU(d, sums.sum_x + first);
    V sum_y = hn::LoadU(d, sums.sum_y + first);
    V sum_z = hn::LoadU(d, sums.sum_z + first);
    const V radius = hn::Set(d, limits.squared_radius);
    const V steepest = hn::Set(d, limits.squared_steepest);
    const V smooth = hn::Set(d, limits.smooth_cosine);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t i = at[k];
        const V way_x = hn::Sub(hn::Set(d, points.x[i]), x);
        const V way_y = hn::Sub(hn::Set(d, points.y[i]), y);
        const V way_z = hn::Sub(hn::Set(d, points.z[i]), z);
        const V square = dot(way_x, way_y, way_z, way_x, way_y, way_z);
        const V other_x = hn::Set(d, points.nx[i]);
        const V other_y = hn::Set(d, points.ny[i]);
        const V other_z = hn::Set(d, points.nz[i]);
        const V agree = dot(nx, ny, nz, other_x, other_y, other_z);
        const V height = dot(way_x, way_y, way_z, nx, ny, nz);
        auto is_near = hn::And(hn::Gt(radius, square), hn::Gt(agree, hn::Zero(d)));
        is_near = hn::AndNot(hn::Gt(hn::Mul(height, height), hn::Mul(steepest, square)), is_near);
        if (points.sheet != nullptr) {
            const auto same = hn::Eq(sheet, hn::Set(d, points.sheet[i]));
            is_near = hn::AndNot(hn::AndNot(same, hn::Gt(smooth, agree)), is_near);
        }
        const V rest = hn::Sub(hn::Set(d, 1.0), hn::Div(square, radius));
        const V weight = hn::IfThenElseZero(is_near, hn::Mul(hn::Mul(rest, rest), agree));
        sum_x = hn::Add(sum_x, hn::Mul(weight, other_x));
        sum_y = hn::Add(sum_y, hn::Mul(weight, other_y));
        sum_z = hn::Add(sum_z, hn::Mul(weight, other_z));
    }
    hn::StoreU(sum_x, d, sums.sum_x + first);
    hn::StoreU(sum_y, d, sums.sum_y + first);
    hn::StoreU(sum_z, d, sums.sum_z + first);
}

void add_normals(const PointsWithNormals& points, const std::int32_t* at, std::int64_t count,
                 const NormalLimits& limits, NormalSums& sums) {
    for (std::int64_t first = 0; first < NormalSums::size; first += lanes())
        add_to_lanes(points, at, count, limits, first, sums);
}

} // namespace

NormalLoops pick() noexcept { return {add_normals}; }

} // namespace hrbfnpr::marks::HWY_NAMESPACE::normal_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::marks, NormalLoops, normal_loops, normal_loops::pick)
