// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "output/raster/stroke_loops.cpp"
#include "base/simd.h"

#include "output/raster/stroke_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::output::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>; // segments are short
using W = hn::Vec<F>;

// Half-open, pixels of the tile.
struct Box {
    std::int32_t left, top, right, bottom;
};

HWY_INLINE std::int32_t clamped(float at, std::int32_t limit) {
    const float most = static_cast<float>(limit);
    return static_cast<std::int32_t>(at < 0.0F ? 0.0F : at > most ? most : at);
}
HWY_INLINE float least(float a, float b) { return a < b ? a : b; }
HWY_INLINE float most(float a, float b) { return a > b ? a : b; }

// An end of a segment, in pixels of the tile.  A line below a pixel's width keeps its ink by getting paler.
struct End {
    float x, y, radius, opacity, window;
};
HWY_INLINE End end_of(const SegmentList& list, const drawing::StrokePoint& p) {
    const float radius = most(p.radius, drawing::smallest_radius);
    return {p.x - list.left, p.y - list.top, radius, p.opacity * p.radius / radius, p.window * list.toward};
}

HWY_INLINE Box box_of(const DiscTile& t, const End& a, const End& b) {
    const float rim = most(a.radius, b.radius) + drawing::soft_rim;
    return {clamped(least(a.x, b.x) - rim, t.width), clamped(least(a.y, b.y) - rim, t.height),
            clamped(most(a.x, b.x) + rim + 1.0F, t.width), clamped(most(a.y, b.y) + rim + 1.0F, t.height)};
}

// The nearest place on the segment decides on half width and opacity; the part of a pixel that is covered is taken
// as how far the rim lies beyond the pixel's centre.
HWY_INLINE void cover_segment(const DiscTile& t, const End& a, const End& b, const Box& box, float* cover) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const W zero = hn::Zero(d);
    const W one = hn::Set(d, 1.0F);
    const float ux = b.x - a.x;
    const float uy = b.y - a.y;
    const float square = ux * ux + uy * uy;
    const float scale = square > 1e-12F ? 1.0F / square : 0.0F;
    const W step = hn::Iota(d, 0.0F);
    const auto between = [&](float from, float to, W at)
                             HWY_ATTR { return hn::Add(hn::Set(d, from), hn::Mul(hn::Set(d, to - from), at)); };
    for (std::int32_t y = box.top; y < box.bottom; ++y) {
        const float py = static_cast<float>(y) + 0.5F - a.y;
        for (std::int32_t x = box.left; x < box.right; x += lanes) {
            const W px = hn::Add(hn::Set(d, static_cast<float>(x) + 0.5F - a.x), step);
            const W along = hn::Mul(hn::Add(hn::Mul(px, hn::Set(d, ux)), hn::Set(d, py * uy)), hn::Set(d, scale));
            const W at = hn::Min(hn::Max(along, zero), one);
            const W dx = hn::Sub(px, hn::Mul(at, hn::Set(d, ux)));
            const W dy = hn::Sub(hn::Set(d, py), hn::Mul(at, hn::Set(d, uy)));
            const W distance = hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
            const W rim = hn::Sub(hn::Add(between(a.radius, b.radius, at), hn::Set(d, drawing::soft_rim)), distance);
            W ink = hn::Mul(hn::Min(hn::Max(rim, zero), one), between(a.opacity, b.opacity, at));
            float* const to = cover + y * t.stride + x;
            if (t.host != nullptr)
                // What lies behind the host's picture is not covered.
                ink = hn::IfThenZeroElse(
                    hn::Lt(hn::LoadU(d, t.host + y * t.stride + x), between(a.window, b.window, at)), ink);
            hn::StoreU(hn::Max(hn::LoadU(d, to), ink), d, to);
        }
    }
}

HWY_INLINE void blend(const DiscTile& t, const Box& box, const float* color, float* cover) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const W alpha = hn::Set(d, color[3]);
    for (std::int32_t y = box.top; y < box.bottom; ++y) {
        for (std::int32_t x = box.left; x < box.right; x += lanes) {
            const std::int32_t at = y * t.stride + x;
            const W ink = hn::Mul(hn::LoadU(d, cover + at), alpha);
            const W left = hn::Sub(hn::Set(d, 1.0F), ink);
            hn::StoreU(hn::Zero(d), d, cover + at);
            hn::StoreU(hn::Mul(hn::LoadU(d, t.transmittance + at), left), d, t.transmittance + at);
            if (t.color[0] == nullptr) continue;
            for (int c = 0; c < 3; ++c)
                hn::StoreU(hn::Add(hn::Mul(hn::LoadU(d, t.color[c] + at), left), hn::Mul(hn::Set(d, color[c]), ink)), d,
                           t.color[c] + at);
        }
    }
}

void lay(const DiscTile& t, const SegmentList& list, float* cover) {
    Box all{t.width, t.height, 0, 0};
    for (std::int64_t i = 0; i < list.count; ++i) {
        const drawing::StrokePoint* const p = list.points + list.numbers[i];
        const End a = end_of(list, p[0]);
        const End b = end_of(list, p[1]);
        const Box box = box_of(t, a, b);
        cover_segment(t, a, b, box, cover);
        all.left = box.left < all.left ? box.left : all.left;
        all.top = box.top < all.top ? box.top : all.top;
        all.right = box.right > all.right ? box.right : all.right;
        all.bottom = box.bottom > all.bottom ? box.bottom : all.bottom;
    }
    blend(t, all, list.color, cover);
}

} // namespace

StrokeLoops pick_stroke_loops() noexcept { return {lay}; }

} // namespace hrbfnpr::output::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::output, StrokeLoops, stroke_loops, pick_stroke_loops)
