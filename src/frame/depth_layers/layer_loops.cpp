// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/depth_layers/layer_loops.cpp"
#include "base/simd.h"

#include "base/assert.h"
#include "frame/depth_layers/layer_loops.h"
#include "frame/depth_layers/tuning.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE::layer_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>; // Vectors are at most 16 wide, because discs are only a few pixels wide.
using W = hn::Vec<F>;

HWY_INLINE std::int32_t clamped(float at, std::int32_t limit) {
    const float top = static_cast<float>(limit);
    return static_cast<std::int32_t>(at < 0.0F ? 0.0F : at > top ? top : at);
}

// A splat or its halo. Lengths are in pixels of the planes.
struct LayerDisc {
    float x, y, radius;
    float depth, slope_x, slope_y, pixels_per_unit;
};

HWY_INLINE LayerDisc disc_of(const SplatList& list, const Splat& c) {
    return {c.x - list.left, c.y - list.top, c.radius, c.depth, c.slope_x, c.slope_y, c.pixels_per_unit};
}

// Calls put(offset, depth, inside) for each vector of pixels that may overlap the disc.
template <bool round, class Put>
HWY_INLINE void for_pixels(const LayerPlanes& p, const LayerDisc& disc, Put&& put) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    HRBFNPR_ASSERT(p.width + lanes <= p.stride);
    const std::int32_t left = clamped(disc.x - disc.radius, p.width);
    const std::int32_t right = clamped(disc.x + disc.radius + 1.0F, p.width);
    const std::int32_t top = clamped(disc.y - disc.radius, p.height);
    const std::int32_t bottom = clamped(disc.y + disc.radius + 1.0F, p.height);
    // A pixel is inside the disc if (1 + u^2) x^2 + 2 u v x y + (1 + v^2) y^2 <= radius^2, where (u, v) is the slope in
    // pixels.
    const float u = round ? 0.0F : disc.slope_x * disc.pixels_per_unit;
    const float v = round ? 0.0F : disc.slope_y * disc.pixels_per_unit;
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

// Keeps the nearer of two layers. Of two equal layers it keeps the first, which is well defined, because the splats of
// a tile are always in the same order.
template <class Mask>
HWY_INLINE void keep_nearer(float* depths, float* transmittances, W depth, W transmittance, Mask inside) {
    const F d;
    const W old = hn::LoadU(d, depths);
    const W old_transmittance = hn::LoadU(d, transmittances);
    const auto take = hn::And(inside, hn::Lt(depth, old));
    hn::StoreU(hn::IfThenElse(take, depth, old), d, depths);
    hn::StoreU(hn::IfThenElse(take, transmittance, old_transmittance), d, transmittances);
}

void draw_nearest(const LayerPlanes& p, const SplatList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Splat& c = list.splats[list.numbers[i]];
        const W transmittance = hn::Set(F(), c.transmittance);
        const auto layer = c.faces_back ? LayerPlanes::back : LayerPlanes::front;
        float* const depths = p.depth[layer];
        float* const transmittances = p.transmittance[layer];
        for_pixels<false>(p, disc_of(list, c), [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
            keep_nearer(depths + at, transmittances + at, depth, transmittance, inside);
        });
    }
}

HWY_INLINE void draw_next(const LayerPlanes& p, const LayerDisc& disc, const Splat& c) {
    const F d;
    const W transmittance = hn::Set(d, c.transmittance);
    const auto own = c.faces_back ? LayerPlanes::back : LayerPlanes::front;
    const auto layer = c.faces_back ? LayerPlanes::next_back : LayerPlanes::next_front;
    const W gap = hn::Set(d, layer_tuning.layer_gap * disc.radius / disc.pixels_per_unit);
    const W between = hn::Set(d, layer_tuning.side_gap / disc.pixels_per_unit);
    for_pixels<false>(p, disc, [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
        auto is_next = hn::Gt(depth, hn::Add(hn::LoadU(d, p.depth[own] + at), gap));
        if (!c.faces_back) {
            // A layer that faces away lies between any two layers that face the eye, so the gap may be small.
            const W back = hn::LoadU(d, p.depth[LayerPlanes::back] + at);
            const auto parted = hn::And(hn::Gt(depth, hn::Add(back, between)),
                                        hn::Gt(back, hn::LoadU(d, p.depth[LayerPlanes::front] + at)));
            is_next = hn::Or(is_next, parted);
        }
        keep_nearer(p.depth[layer] + at, p.transmittance[layer] + at, depth, transmittance, hn::And(inside, is_next));
    });
}

void draw_all_next(const LayerPlanes& p, const SplatList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Splat& c = list.splats[list.numbers[i]];
        const float reach = drawing::steepest_slope * c.radius / c.pixels_per_unit;
        if (c.depth + reach < list.nearest || c.depth - reach > list.farthest) continue;
        draw_next(p, disc_of(list, c), c);
    }
}

void draw_halos(const LayerPlanes& p, const SplatList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const Splat& c = list.splats[list.numbers[i]];
        if (!(c.halo > 0.0F)) continue;
        const LayerDisc disc = {c.halo_x - list.left, c.halo_y - list.top, c.halo,           c.halo_depth,
                                c.halo_slope_x,       c.halo_slope_y,      c.pixels_per_unit};
        const W transmittance = hn::Set(F(), c.halo_transmittance);
        for_pixels<true>(p, disc, [&](std::int32_t at, W depth, auto inside) HWY_ATTR {
            keep_nearer(p.halo + at, p.halo_transmittance + at, depth, transmittance, inside);
        });
    }
}

} // namespace

LayerLoops pick() noexcept { return {draw_nearest, draw_all_next, draw_halos}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE::layer_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::frame, LayerLoops, layer_loops, layer_loops::pick)
