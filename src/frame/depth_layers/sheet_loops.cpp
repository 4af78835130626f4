#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/depth_layers/sheet_loops.cpp"
#include "base/simd.h"

#include "frame/depth_layers/sheet_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>; // discs are a few pixels wide
using W = hn::Vec<F>;

HWY_INLINE std::int32_t clamped(float at, std::int32_t limit) {
    const float top = static_cast<float>(limit);
    return static_cast<std::int32_t>(at < 0.0F ? 0.0F : at > top ? top : at);
}

// A cover, or its halo, in pixels of the planes.
struct SheetDisc {
    float x, y, radius;
    float depth, slope_x, slope_y, ppe;
};

HWY_INLINE SheetDisc disc_of(const CoverList& list, const Cover& c) {
    return {c.x - list.left, c.y - list.top, c.radius, c.depth, c.slope_x, c.slope_y, c.ppe};
}

// Calls put(offset, depth, inside) for vectors of pixels that may lie within the disc.
template <bool round, class Put>
HWY_INLINE void for_pixels(const SheetPlanes& p, const SheetDisc& disc, Put&& put) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const std::int32_t left = clamped(disc.x - disc.radius, p.width);
    const std::int32_t right = clamped(disc.x + disc.radius + 1.0F, p.width);
    const std::int32_t top = clamped(disc.y - disc.radius, p.height);
    const std::int32_t bottom = clamped(disc.y + disc.radius + 1.0F, p.height);
    // Within the disc: (1 + u^2) x^2 + 2 u v x y + (1 + v^2) y^2 <= radius^2, (u, v) its slope in pixels.
    const float u = round ? 0.0F : disc.slope_x * disc.ppe;
    const float v = round ? 0.0F : disc.slope_y * disc.ppe;
    const W square = hn::Set(d, 1.0F + u * u);
    const W step = hn::Iota(d, static_cast<float>(left) + 0.5F - disc.x);
    const W slope_x = hn::Set(d, disc.slope_x);
    for (std::int32_t y = top; y < bottom; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - disc.y;
        const W mixed = hn::Set(d, 2.0F * u * v * dy);
        const W rest = hn::Set(d, disc.radius * disc.radius - (1.0F + v * v) * dy * dy);
        const W depth = hn::Set(d, disc.depth + dy * disc.slope_y);
        W dx = step;
        for (std::int32_t x = left; x < right; x += lanes, dx = hn::Add(dx, hn::Set(d, static_cast<float>(lanes)))) {
            const W squared = hn::Mul(hn::Add(hn::Mul(square, dx), mixed), dx);
            put(y * p.stride + x, hn::Add(depth, hn::Mul(dx, slope_x)), hn::Le(squared, rest));
        }
    }
}

// The nearer of two stays; of equals the first, and a tile's covers are always in the same order.
template <class Mask>
HWY_INLINE void keep_nearer(float* depths, float* clears, W depth, W clear, Mask inside) {
    const F d;
    const W old = hn::LoadU(d, depths);
    const W old_clear = hn::LoadU(d, clears);
    const auto take = hn::And(inside, hn::Lt(depth, old));
    hn::StoreU(hn::IfThenElse(take, depth, old), d, depths);
    hn::StoreU(hn::IfThenElse(take, clear, old_clear), d, clears);
}

void lay(const SheetPlanes& p, const CoverList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Cover& c = list.covers[list.numbers[i]];
        const W clear = hn::Set(F(), c.clear);
        const auto sheet = c.faces_back ? SheetPlanes::back : SheetPlanes::front;
        float* const depths = p.depth[sheet];
        float* const clears = p.clear[sheet];
        for_pixels<false>(p, disc_of(list, c), [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
            keep_nearer(depths + at, clears + at, depth, clear, inside);
        });
    }
}

HWY_INLINE void lay_next(const SheetPlanes& p, const SheetDisc& disc, const Cover& c) {
    const F d;
    const W clear = hn::Set(d, c.clear);
    const auto own = c.faces_back ? SheetPlanes::back : SheetPlanes::front;
    const auto sheet = c.faces_back ? SheetPlanes::next_back : SheetPlanes::next_front;
    const W gap = hn::Set(d, sheet_gap * disc.radius / disc.ppe);
    const W between = hn::Set(d, side_gap / disc.ppe);
    for_pixels<false>(p, disc, [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
        auto behind = hn::Gt(depth, hn::Add(hn::LoadU(d, p.depth[own] + at), gap));
        if (!c.faces_back) {
            // Between two sheets that face the eye there is one that does not: the gap may be small.
            const W back = hn::LoadU(d, p.depth[SheetPlanes::back] + at);
            const auto parted = hn::And(hn::Gt(depth, hn::Add(back, between)),
                                        hn::Gt(back, hn::LoadU(d, p.depth[SheetPlanes::front] + at)));
            behind = hn::Or(behind, parted);
        }
        keep_nearer(p.depth[sheet] + at, p.clear[sheet] + at, depth, clear, hn::And(inside, behind));
    });
}

void lay_all_next(const SheetPlanes& p, const CoverList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Cover& c = list.covers[list.numbers[i]];
        const float reach = steepest * c.radius / c.ppe;
        if (c.depth + reach < list.nearest || c.depth - reach > list.farthest) continue;
        lay_next(p, disc_of(list, c), c);
    }
}

void lay_halos(const SheetPlanes& p, const CoverList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Cover& c = list.covers[list.numbers[i]];
        if (!(c.halo > 0.0F)) continue;
        const SheetDisc disc = {c.halo_x - list.left, c.halo_y - list.top, c.halo, c.halo_depth,
                                c.halo_slope_x,       c.halo_slope_y,      c.ppe};
        const W clear = hn::Set(F(), c.halo_clear);
        for_pixels<true>(p, disc, [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
            keep_nearer(p.halo + at, p.halo_clear + at, depth, clear, inside);
        });
    }
}

} // namespace

SheetLoops pick_sheet_loops() noexcept { return {lay, lay_all_next, lay_halos}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::frame {

SheetLoops sheet_loops(base::InstructionSet set) noexcept { return HRBFNPR_PICK(set, pick_sheet_loops)(); }

} // namespace hrbfnpr::frame
#endif
