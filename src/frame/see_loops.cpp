#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/see_loops.cpp"
#include "base/simd.h"

#include "frame/see_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using W = hn::Vec<F>;

// Products and sums are rounded one by one: a fused step would give other bits where there is one.
HWY_INLINE W dot3(const float* row, W x, W y, W z) {
    const F d;
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
                   hn::Mul(hn::Set(d, row[2]), z));
}
HWY_INLINE W affine(const float* row, W x, W y, W z) { return hn::Add(dot3(row, x, y, z), hn::Set(F(), row[3])); }
HWY_INLINE W squared(W x, W y, W z) { return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)); }

struct Sight {
    W x, y, z;
};

HWY_INLINE Sight sight(const Seer& s, W x, W y, W z) {
    const F d;
    const W cx = hn::Set(d, s.centre[0]);
    const W cy = hn::Set(d, s.centre[1]);
    const W cz = hn::Set(d, s.centre[2]);
    if (s.parallel) return {cx, cy, cz};
    return {hn::Sub(x, cx), hn::Sub(y, cy), hn::Sub(z, cz)};
}

HWY_INLINE void place(const Seer& s, W px, W py, W pz, std::int64_t at, Seen& seen) {
    const F d;
    const W inverse = hn::Div(hn::Set(d, 1.0F), affine(s.clip[3], px, py, pz));
    hn::StoreU(hn::Mul(affine(s.clip[0], px, py, pz), inverse), d, seen.x + at);
    hn::StoreU(hn::Mul(affine(s.clip[1], px, py, pz), inverse), d, seen.y + at);
    hn::StoreU(hn::Mul(affine(s.clip[2], px, py, pz), inverse), d, seen.window + at);
    hn::StoreU(hn::Mul(hn::Set(d, s.pixels), inverse), d, seen.ppe + at);
}

HWY_INLINE W light(const Seer& s, W nx, W ny, W nz) {
    if (s.rigid) return dot3(s.light, nx, ny, nz);
    const W lx = dot3(s.normal_light[0], nx, ny, nz);
    const W ly = dot3(s.normal_light[1], nx, ny, nz);
    const W lz = dot3(s.normal_light[2], nx, ny, nz);
    return hn::Div(dot3(s.light, lx, ly, lz), hn::Sqrt(squared(lx, ly, lz)));
}

void see(const Seer& s, const MarkBlock& m, Seen& seen) {
    const F d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < m.count; at += lanes) {
        const auto left = static_cast<size_t>(m.count - at < lanes ? m.count - at : lanes);
        const auto mask = hn::FirstN(d, left);
        const auto load = [&](const float* from) { return hn::MaskedLoad(mask, d, from + at); };
        const W px = load(m.x);
        const W py = load(m.y);
        const W pz = load(m.z);
        place(s, px, py, pz, at, seen);
        const W ex = affine(s.eye[0], px, py, pz);
        const W ey = affine(s.eye[1], px, py, pz);
        const W ez = affine(s.eye[2], px, py, pz);
        const Sight v = sight(s, ex, ey, ez);
        const W length = hn::Sqrt(squared(v.x, v.y, v.z));
        const W inverse = hn::Div(hn::Set(d, 1.0F), length);
        const W nx = load(m.nx);
        const W ny = load(m.ny);
        const W nz = load(m.nz);
        W tx = dot3(s.normal[0], nx, ny, nz);
        W ty = dot3(s.normal[1], nx, ny, nz);
        W tz = dot3(s.normal[2], nx, ny, nz);
        if (!s.rigid) {
            const W unit = hn::Div(hn::Set(d, 1.0F), hn::Sqrt(squared(tx, ty, tz)));
            tx = hn::Mul(tx, unit);
            ty = hn::Mul(ty, unit);
            tz = hn::Mul(tz, unit);
        }
        const W facing = hn::Add(hn::Add(hn::Mul(tx, v.x), hn::Mul(ty, v.y)), hn::Mul(tz, v.z));
        hn::StoreU(hn::Mul(facing, inverse), d, seen.nu + at);
        hn::StoreU(tx, d, seen.side_x + at);
        hn::StoreU(ty, d, seen.side_y + at);
        hn::StoreU(hn::Mul(hn::Neg(v.z), inverse), d, seen.along + at);
        hn::StoreU(hn::Neg(ez), d, seen.depth + at);
        hn::StoreU(s.parallel ? hn::Neg(ez) : length, d, seen.distance + at);
        hn::StoreU(light(s, nx, ny, nz), d, seen.lit + at);
    }
}

} // namespace

SeeLoops pick_see_loops() noexcept { return {see}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::frame {

SeeLoops see_loops(base::InstructionSet set) noexcept { return HRBFNPR_PICK(set, pick_see_loops)(); }

} // namespace hrbfnpr::frame
#endif
