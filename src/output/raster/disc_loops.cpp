// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "output/raster/disc_loops.cpp"
#include "base/simd.h"

#include "output/raster/disc_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::output::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 8>; // most discs are a few pixels wide
using W = hn::Vec<F>;

HWY_INLINE std::int32_t clamped(float at, std::int32_t limit) {
    const float top = static_cast<float>(limit);
    return static_cast<std::int32_t>(at < 0.0F ? 0.0F : at > top ? top : at);
}

// A disc in pixels of the tile.
struct InkDisc {
    float x, y, radius, alpha, depth;
};

// The part of a pixel that the disc covers, taken as how far the rim lies beyond the pixel's centre.
HWY_INLINE W coverage(W squared, W outer) {
    const F d;
    return hn::Min(hn::Max(hn::Sub(outer, hn::Sqrt(squared)), hn::Zero(d)), hn::Set(d, 1.0F));
}

template <class Blend>
HWY_INLINE void for_pixels(const DiscTile& t, const InkDisc& disc, Blend&& blend) {
    const F d;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    const float radius = disc.radius > drawing::smallest_radius ? disc.radius : drawing::smallest_radius;
    const float dimmed = disc.radius / radius;
    const float rim = radius + drawing::soft_rim;
    const W alpha = hn::Set(d, disc.alpha * dimmed * dimmed);
    const W outer = hn::Set(d, rim);
    const std::int32_t left = clamped(disc.x - rim, t.width);
    const std::int32_t right = clamped(disc.x + rim + 1.0F, t.width);
    const std::int32_t top = clamped(disc.y - rim, t.height);
    const std::int32_t bottom = clamped(disc.y + rim + 1.0F, t.height);
    const W step = hn::Iota(d, 0.0F);
    for (std::int32_t y = top; y < bottom; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - disc.y;
        const W squared_y = hn::Set(d, dy * dy);
        for (std::int32_t x = left; x < right; x += lanes) {
            const W dx = hn::Add(hn::Set(d, static_cast<float>(x) + 0.5F - disc.x), step);
            const W squared = hn::Add(hn::Mul(dx, dx), squared_y);
            blend(y * t.stride + x, hn::Mul(alpha, coverage(squared, outer)));
        }
    }
}

// What lies behind the host's picture is not covered.
HWY_INLINE W before_host(const DiscTile& t, const InkDisc& disc, std::int32_t at, W cover) {
    const F d;
    if (t.host == nullptr) return cover;
    return hn::IfThenZeroElse(hn::Lt(hn::LoadU(d, t.host + at), hn::Set(d, disc.depth)), cover);
}

HWY_INLINE void draw_one(const DiscTile& t, const InkDisc& disc) {
    const F d;
    for_pixels(t, disc, [&](std::int32_t at, W cover) HWY_ATTR {
        const W left = hn::Sub(hn::Set(d, 1.0F), before_host(t, disc, at, cover));
        hn::StoreU(hn::Mul(hn::LoadU(d, t.transmittance + at), left), d, t.transmittance + at);
    });
}

HWY_INLINE void draw_colored(const DiscTile& t, const InkDisc& disc, const float* color) {
    const F d;
    for_pixels(t, disc, [&](std::int32_t at, W all) HWY_ATTR {
        const W cover = before_host(t, disc, at, all);
        const W left = hn::Sub(hn::Set(d, 1.0F), cover);
        hn::StoreU(hn::Mul(hn::LoadU(d, t.transmittance + at), left), d, t.transmittance + at);
        for (int c = 0; c < 3; ++c) {
            const W own = hn::Mul(hn::Set(d, color[c]), cover);
            hn::StoreU(hn::Add(hn::Mul(hn::LoadU(d, t.color[c] + at), left), own), d, t.color[c] + at);
        }
    });
}

void draw(const DiscTile& t, const InkList& list) {
    for (std::int64_t i = 0; i < list.count; ++i) {
        const drawing::Dot& ink = list.inks[list.numbers[i]];
        if (!(ink.opacity > 0.0F)) continue;
        InkDisc disc = {ink.x - list.left, ink.y - list.top, ink.radius, ink.opacity * list.one_alpha,
                        ink.window * list.toward};
        if (t.color[0] == nullptr) {
            draw_one(t, disc);
            continue;
        }
        const float* const color = list.colors + 4 * std::int64_t{ink.layer};
        disc.alpha = ink.opacity * color[3];
        draw_colored(t, disc, color);
    }
}

void store(const RowColors& colors, const float* transmittance, std::int64_t count, std::uint32_t* pixels) {
    const hn::ScalableTag<float> d;
    const hn::RebindToSigned<decltype(d)> integer;
    const hn::RebindToUnsigned<decltype(d)> word;
    const auto one = hn::Set(d, 1.0F);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < count; at += lanes) {
        const auto left = hn::LoadU(d, transmittance + at);
        const auto inked = hn::Sub(one, left);
        auto scale = hn::Set(d, 255.0F);
        const auto channel = [&](int c) HWY_ATTR {
            return hn::Add(hn::Mul(hn::Set(d, colors.paper[c]), left), hn::Mul(hn::Set(d, colors.ink[c]), inked));
        };
        const auto alpha = channel(3);
        if (colors.straight)
            // Nothing has no colour: straight pixels of alpha 0 are all zero.
            scale = hn::IfThenElseZero(hn::Gt(alpha, hn::Zero(d)), hn::Div(scale, alpha));
        auto bits = hn::Zero(word);
        const auto add = [&](hn::Vec<decltype(d)> value, int c) HWY_ATTR {
            const auto rounded = hn::Add(hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 255.0F)), hn::Set(d, 0.5F));
            bits = hn::Or(bits, hn::ShiftLeftSame(hn::BitCast(word, hn::ConvertTo(integer, rounded)), 8 * c));
        };
        for (int c = 0; c < 3; ++c) add(hn::Mul(channel(c), scale), c);
        add(hn::Mul(alpha, hn::Set(d, 255.0F)), 3);
        hn::StoreU(bits, word, pixels + at);
    }
}

} // namespace

DiscLoops pick_disc_loops() noexcept { return {draw, store}; }

} // namespace hrbfnpr::output::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::output, DiscLoops, disc_loops, pick_disc_loops)
