// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/hatch/loops.cpp"
#include "base/simd.h"

#include "frame/hatch/loops.h"
#include "frame/hatch/tuning.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE::hatch_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, HatchRows::slack>; // Vectors are short enough to end within the rows.
using I = hn::RebindToSigned<F>;
using W = hn::Vec<F>;
using M = hn::Mask<F>;

// Products and sums are rounded separately, because fused operations exist only on some processors and give different
// bits.
HWY_INLINE W set(float x) { return hn::Set(F(), x); }
HWY_INLINE W dot3(const float* row, W x, W y, W z) {
    return hn::Add(hn::Add(hn::Mul(set(row[0]), x), hn::Mul(set(row[1]), y)), hn::Mul(set(row[2]), z));
}
HWY_INLINE W squared(W x, W y) { return hn::Add(hn::Mul(x, x), hn::Mul(y, y)); }
HWY_INLINE W squared(W x, W y, W z) { return hn::Add(squared(x, y), hn::Mul(z, z)); }
HWY_INLINE W clamped(W x, float low, float high) { return hn::Min(hn::Max(x, set(low)), set(high)); }

// Calls step(i) for the first mark i of each vector.
template <class Step>
HWY_INLINE void for_vectors(std::int64_t count, Step&& step) {
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(F()));
    for (std::int64_t at = 0; at < count; at += lanes) step(at);
}

// The logarithm to the base 2 of a positive number.
HWY_INLINE W log2(W x) {
    const F d;
    const I i;
    const auto bits = hn::BitCast(i, x);
    // m is between the square roots of 1/2 and 2.
    const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(i, 0x3F3504F3)));
    const W m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
    const W t = hn::Div(hn::Sub(m, set(1.0F)), hn::Add(m, set(1.0F)));
    const W s = hn::Mul(t, t);
    // 2 atanh(t) / ln 2 as a polynomial. Its operations depend little on each other, which is fast.
    const auto line = [&](float at_0, float rise) HWY_ATTR { return hn::Add(set(at_0), hn::Mul(set(rise), s)); };
    const W square = hn::Mul(s, s);
    const W high = hn::Add(line(0.57707802F, 0.41219858F), hn::Mul(set(0.32059890F), square));
    const W sum = hn::Add(line(2.88539008F, 0.96179669F), hn::Mul(high, square));
    return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(sum, t));
}

HWY_INLINE bool may_draw(const HatchBounds& b, const float* n, const float* t) {
    const auto dot = [](const float(&a)[3], const float* v) { return a[0] * v[0] + a[1] * v[1] + a[2] * v[2]; };
    return !(dot(b.sight, n) > b.away || dot(b.light, t) > b.lightest);
}

std::uint32_t may_draw(const HatchBounds& bounds, const float* normals, const float* tone_normals, std::int64_t count) {
    const F d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    const HatchBounds b = bounds;
    std::uint32_t all = 0;
    std::int64_t at = 0;
    for (; at + lanes <= count; at += lanes) {
        W x, y, z;
        hn::LoadInterleaved3(d, normals + 3 * at, x, y, z);
        const M away = hn::Gt(dot3(b.sight, x, y, z), set(b.away));
        hn::LoadInterleaved3(d, tone_normals + 3 * at, x, y, z);
        const M light = hn::Gt(dot3(b.light, x, y, z), set(b.lightest));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Not(hn::Or(away, light)), bits);
        all |= static_cast<std::uint32_t>(bits[0] | bits[1] << 8) << at;
    }
    for (; at < count; ++at)
        if (may_draw(b, normals + 3 * at, tone_normals + 3 * at)) all |= 1U << at;
    return all;
}

// The spacing of lines in the picture. It is the height of the image of a parallelogram on the surface. The
// parallelogram has one side along the line and one side across it. If lines of sight are parallel, the spacing is
// separation |n . v| / sqrt(1 - (t . v)^2).
HWY_INLINE W spacing_at(const HatchSight& sight, const HatchRows& rows) {
    const F d;
    const ViewTransform& s = *sight.view_transform;
    const auto row = [&](HatchRow number, std::int64_t at) HWY_ATTR { return hn::LoadU(d, rows[number] + at); };
    const auto along = [&](HatchRow number) HWY_ATTR { return hn::Sub(row(number, 1), row(number, -1)); };
    const W ax = along(HatchRow::x);
    const W ay = along(HatchRow::y);
    const W az = along(HatchRow::z);
    const W nx = row(HatchRow::normal_x, 0);
    const W ny = row(HatchRow::normal_y, 0);
    const W nz = row(HatchRow::normal_z, 0);
    const W bx = hn::Sub(hn::Mul(ny, az), hn::Mul(ay, nz));
    const W by = hn::Sub(hn::Mul(nz, ax), hn::Mul(az, nx));
    const W bz = hn::Sub(hn::Mul(nx, ay), hn::Mul(ax, ny));
    const W left = row(HatchRow::left, 0);
    const W top = row(HatchRow::top, 0);
    const W scale = hn::Mul(row(HatchRow::pixels_per_unit, 0), set(1.0F / s.pixels));
    const auto image = [&](const float* clip, W place, W x, W y, W z) HWY_ATTR {
        return hn::Mul(hn::Sub(dot3(clip, x, y, z), hn::Mul(place, dot3(s.clip[3], x, y, z))), scale);
    };
    const W a_left = image(s.clip[0], left, ax, ay, az);
    const W a_top = image(s.clip[1], top, ax, ay, az);
    const W b_left = image(s.clip[0], left, bx, by, bz);
    const W b_top = image(s.clip[1], top, bx, by, bz);
    const W area = hn::Abs(hn::Sub(hn::Mul(a_left, b_top), hn::Mul(a_top, b_left)));
    const W base = hn::Sqrt(hn::Mul(squared(a_left, a_top), squared(bx, by, bz)));
    return hn::IfThenElseZero(hn::Gt(base, hn::Zero(d)), hn::Div(hn::Mul(set(sight.separation), area), base));
}

void project(const HatchSight& sight, const HatchRows& rows, std::int64_t count) {
    const F d;
    for_vectors(count, [&](std::int64_t at) HWY_ATTR {
        const HatchRows own = rows.from(at);
        const auto row = [&](HatchRow number) HWY_ATTR { return hn::LoadU(d, own[number]); };
        const W left = row(HatchRow::left);
        const W top = row(HatchRow::top);
        const W nu = row(HatchRow::nu);
        const W horizontal = hn::Min(hn::Sub(left, set(sight.left)), hn::Sub(set(sight.right), left));
        const W vertical = hn::Min(hn::Sub(top, set(sight.top)), hn::Sub(set(sight.bottom), top));
        const W margin = hn::Add(set(sight.beyond), hn::Min(horizontal, vertical));
        // For NaN all comparisons are false, so the result is hatch_nowhere.
        const auto between = [&](W value, float low, float high)
                                 HWY_ATTR { return hn::And(hn::Ge(value, set(low)), hn::Le(value, set(high))); };
        const M valid =
            hn::And(hn::And(hn::And(hn::Eq(left, left), hn::Eq(top, top)),
                            hn::And(between(row(HatchRow::window), 0.0F, 1.0F), between(nu, -1.001F, 1.001F))),
                    hn::And(hn::Gt(row(HatchRow::pixels_per_unit), hn::Zero(d)), hn::Gt(margin, set(-hatch_farthest))));
        hn::StoreU(hn::IfThenElse(valid, margin, set(hatch_nowhere)), d, own[HatchRow::picture_margin]);
        hn::StoreU(hn::Sub(set(hatch_tuning.last_nu), nu), d, own[HatchRow::rim_margin]);
    });
}

// The curve from darkness to coverage, both from 0 to 1. It is slightly below the diagonal, because ink spreads and
// dark tones merge. The formula, x times a polynomial of sqrt(x), differs from x^1.1 by at most 0.00014 and is much
// faster.
constexpr float coverage_coefficients[5] = {0.5399F, 1.1747F, -1.5068F, 1.1364F, -0.3442F};

// Returns the coverage in the lights as a share of that at hatch_tone_begin. It falls from 1 at hatch_tone_begin to 0
// where the last lines end.
HWY_INLINE W light_share(const HatchWidthLaw& law, W darkness) {
    const W above = hn::Sub(darkness, set(law.style->hatch_tone_begin));
    return clamped(hn::Add(set(1.0F), hn::Mul(above, set(law.per_fade))), 0.0F, 1.0F);
}

HWY_INLINE W coverage(const HatchWidthLaw& law, W darkness) {
    const LayerStyle& style = *law.style;
    const W begin = set(style.hatch_tone_begin);
    const W at = clamped(hn::Mul(hn::Sub(darkness, begin), set(law.per_tone_span)), 0.0F, 1.0F);
    const auto line = [&](int from) HWY_ATTR {
        return hn::Add(set(coverage_coefficients[from]), hn::Mul(set(coverage_coefficients[from + 2]), at));
    };
    const W even = hn::Add(line(0), hn::Mul(set(coverage_coefficients[4]), hn::Mul(at, at)));
    const W risen = hn::Mul(at, hn::Add(even, hn::Mul(hn::Sqrt(at), line(1))));
    const W rise = set(style.hatch_coverage_end - style.hatch_coverage_begin);
    const W first = hn::Mul(light_share(law, darkness), set(style.hatch_coverage_begin));
    return hn::Mul(set(style.share), hn::Add(first, hn::Mul(rise, risen)));
}

void coverage(const HatchWidthLaw& law, const float* darkness, std::int64_t count, float* to) {
    const F d;
    for_vectors(count,
                [&](std::int64_t at) HWY_ATTR { hn::StoreU(coverage(law, hn::LoadU(d, darkness + at)), d, to + at); });
}

// The widths of lines at a place, in pixels. Lines of levels up to `full` have the width `width`. Lines of the next
// level have the width `fading`.
struct LevelWidths {
    W lambda; // the number of levels for which there is space
    W full, width, fading;
    W coarsest; // the margin of lines of level 0
    W margin;   // The fading level is drawn where this is positive. It has its full width where this is 1.
};

// Finds the widths of lines. `spacing` is the spacing of level 0 in the picture, in pixels; the lines of levels 0 to k
// together are 2^k times as close. `gap` is the factor by which the lines around the place are farther apart than
// `spacing`. The choice of levels does not depend on `gap`.
HWY_INLINE LevelWidths widths(const HatchWidthLaw& law, W darkness, W spacing, W gap) {
    const F d;
    const I i;
    const W one = set(1.0F);
    const W coverage = hatch_loops::coverage(law, darkness);
    const W light = light_share(law, darkness);
    const W room = hn::Mul(spacing, hn::Min(set(law.per_spacing), hn::Mul(coverage, set(law.per_pen))));
    LevelWidths w;
    // In the lights, lines of level 0 end where they would be thinner than half a pen.
    w.coarsest = hn::Sub(hn::Mul(set(2.0F), hn::Max(room, light)), one);
    w.lambda = hn::IfThenElseZero(hn::Gt(room, one), hn::Min(log2(room), set(law.levels)));
    const auto full = hn::ConvertTo(i, w.lambda);
    w.full = hn::ConvertTo(d, full);
    const W weight = hn::Sub(w.lambda, w.full); // how far the next level has faded in, from 0 to 1
    const W half = hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(i, 127), full))); // 2^-full
    const W period = hn::Mul(hn::Mul(gap, spacing), half);
    // The ink of a period is shared by one full line and a line of the next level, which counts as `weight` lines.
    // Lines closer together than requested are thinner than the pen.
    const W lines = hn::Add(one, weight);
    const W ink =
        hn::Min(hn::Mul(coverage, period), hn::Max(hn::Sub(period, hn::Mul(lines, set(law.style->hatch_white))),
                                                   hn::Mul(lines, set(law.style->hatch_pen))));
    const W next = hn::Div(hn::Mul(weight, ink), lines);
    const W margin = hn::Sub(hn::Mul(next, set(law.per_pen)), set(hatch_tuning.thinnest_fading));
    const W rise =
        hn::Max(hn::Mul(hn::Sub(weight, set(hatch_tuning.nearly_full)), set(1.0F / (1.0F - hatch_tuning.nearly_full))),
                hn::Zero(d));
    w.margin = hn::Add(margin, hn::Mul(rise, hn::Max(hn::Sub(one, margin), hn::Zero(d))));
    w.fading = hn::Mul(next, clamped(hn::Mul(w.margin, set(1.0F / hatch_tuning.fading_ramp)), 0.0F, 1.0F));
    w.width = hn::Sub(ink, w.fading);
    return w;
}

// Fills `reach` elements before the first mark and after the last one: from the other end of a closed stroke, or else
// with `otherwise`.
HWY_INLINE void pad_row(float* row, std::int64_t count, bool closed, std::int64_t reach, float otherwise) {
    for (std::int64_t k = 1; k <= reach; ++k) {
        row[-k] = closed && k <= count ? row[count - k] : otherwise;
        row[count + k - 1] = closed && k <= count ? row[k - 1] : otherwise;
    }
}

// Returns the largest of five elements: row[0], and two elements on either side of it.
HWY_INLINE W largest_near(const float* row) {
    const F d;
    const auto pair = [&](std::int64_t away)
                          HWY_ATTR { return hn::Max(hn::LoadU(d, row - away), hn::LoadU(d, row + away)); };
    return hn::Max(hn::LoadU(d, row), hn::Max(pair(1), pair(2)));
}

// Sets the margin of tone, and sets `least_margin` to the smallest of the margins of tone, rim and picture.
HWY_INLINE void set_least_margin(const HatchWidthLaw& law, const HatchRows& rows) {
    const F d;
    const W tone = hn::Sub(hn::LoadU(d, rows[HatchRow::darkness]), set(law.style->hatch_least()));
    hn::StoreU(tone, d, rows[HatchRow::tone_margin]);
    const W others = hn::Min(hn::LoadU(d, rows[HatchRow::rim_margin]), hn::LoadU(d, rows[HatchRow::picture_margin]));
    hn::StoreU(hn::Min(tone, others), d, rows[HatchRow::least_margin]);
}

// These two rows are free until smooth_along() has used them. They hold the margin of the level, and the width, of each
// mark.
constexpr HatchRow own_margin = HatchRow::greatest_nearby;
constexpr HatchRow own_width = HatchRow::distance_before;

// Sets own_margin and own_width for the marks in the mask `near`. All instruction sets give the same bits.
HWY_INLINE void set_width(const HatchSight& sight, const HatchWidthLaw& law, const HatchRows& rows, M near) {
    const F d;
    const auto row = [&](HatchRow number) HWY_ATTR { return hn::LoadU(d, rows[number]); };
    const W one = set(1.0F);
    const W darkness = row(HatchRow::darkness);
    const W level = row(HatchRow::level);
    const W picture = row(HatchRow::picture_margin);
    const W spacing = spacing_at(sight, rows);
    const LevelWidths w = widths(law, darkness, spacing, row(HatchRow::gap));
    const M full = hn::Le(level, w.full);
    const M fades = hn::Eq(level, hn::Add(w.full, one));
    const W rest = hn::Sub(hn::Sub(w.lambda, hn::Sub(level, one)), set(hatch_tuning.thinnest_fading));
    const W own = hn::IfThenElse(hn::Gt(level, hn::Zero(d)), one, w.coarsest);
    const W margin = hn::IfThenElse(full, own, hn::IfThenElse(fades, w.margin, rest));
    const W width = hn::IfThenElse(full, w.width, hn::IfThenElseZero(fades, w.fading));
    // For NaN the comparison is false, so NaN counts as turned away.
    const M turned = hn::Not(hn::Lt(row(HatchRow::nu), set(hatch_tuning.widest_nu)));
    const M valid =
        hn::And(hn::And(hn::Eq(darkness, darkness), hn::Eq(spacing, spacing)), hn::Lt(width, set(hatch_farthest)));
    hn::StoreU(hn::IfThenElse(hn::Or(turned, hn::Not(near)), one, clamped(margin, -1.0F, 1.0F)), d, rows[own_margin]);
    hn::StoreU(hn::IfThenElseZero(near, hn::IfThenZeroElse(turned, width)), d, rows[own_width]);
    hn::StoreU(hn::IfThenElse(hn::Or(hn::Or(turned, valid), hn::Not(near)), picture, set(hatch_nowhere)), d,
               rows[HatchRow::picture_margin]);
}

// Smooths margins and widths along the line, because the level may change from one mark to the next. Each value becomes
// half of itself plus a quarter of each neighbour.
HWY_INLINE void smooth_along(const HatchRows& rows, std::int64_t count, bool closed) {
    const F d;
    for (const HatchRow own : {own_margin, own_width}) {
        rows[own][-1] = rows[own][closed ? count - 1 : 0];
        rows[own][count] = rows[own][closed ? 0 : count - 1];
    }
    const auto mean = [&](const float* row) HWY_ATTR {
        const W beside = hn::Add(hn::LoadU(d, row - 1), hn::LoadU(d, row + 1));
        const W own = hn::LoadU(d, row);
        return hn::Mul(hn::Add(beside, hn::Add(own, own)), set(0.25F));
    };
    for_vectors(count, [&](std::int64_t at) HWY_ATTR {
        hn::StoreU(mean(rows[own_margin] + at), d, rows[HatchRow::level_margin] + at);
        hn::StoreU(mean(rows[own_width] + at), d, rows[HatchRow::width] + at);
    });
}

void set_widths(const HatchSight& sight, const HatchWidthLaw& law, const HatchRows& rows, std::int64_t count,
                bool closed) {
    const F d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for_vectors(count, [&](std::int64_t at) HWY_ATTR { set_least_margin(law, rows.from(at)); });
    pad_row(rows[HatchRow::least_margin], count, closed, 2, -1.0F);
    for_vectors(count, [&](std::int64_t at) HWY_ATTR {
        const HatchRows own = rows.from(at);
        // The elements after the last mark are left over from an earlier stroke and must have no effect.
        const M marks = hn::FirstN(d, static_cast<size_t>(count - at < lanes ? count - at : lanes));
        const M near = hn::AndNot(hn::Lt(largest_near(own[HatchRow::least_margin]), hn::Zero(d)), marks);
        if (!hn::AllFalse(d, near)) {
            set_width(sight, law, own, near);
            return;
        }
        hn::StoreU(set(1.0F), d, own[own_margin]);
        hn::StoreU(hn::Zero(d), d, own[own_width]);
    });
    smooth_along(rows, count, closed);
}

void measure_distances(const HatchRows& rows, std::int64_t count, bool closed) {
    const F d;
    pad_row(rows[HatchRow::left], count, closed, 1, 0.0F);
    pad_row(rows[HatchRow::top], count, closed, 1, 0.0F);
    pad_row(rows[HatchRow::picture_margin], count, closed, 1, hatch_nowhere);
    for_vectors(count, [&](std::int64_t at) HWY_ATTR {
        const HatchRows own = rows.from(at);
        const auto row = [&](HatchRow number, std::int64_t aside = 0)
                             HWY_ATTR { return hn::LoadU(d, own[number] + aside); };
        const W picture = row(HatchRow::picture_margin);
        const M both =
            hn::And(hn::Gt(picture, set(hatch_nowhere)), hn::Gt(row(HatchRow::picture_margin, -1), set(hatch_nowhere)));
        const W x = hn::Sub(row(HatchRow::left), row(HatchRow::left, -1));
        const W y = hn::Sub(row(HatchRow::top), row(HatchRow::top, -1));
        hn::StoreU(hn::IfThenElseZero(both, hn::Sqrt(squared(x, y))), d, own[HatchRow::distance_before]);
        hn::StoreU(hn::Min(hn::Min(row(HatchRow::tone_margin), row(HatchRow::level_margin)),
                           hn::Min(row(HatchRow::rim_margin), picture)),
                   d, own[HatchRow::least_margin]);
    });
    pad_row(rows[HatchRow::least_margin], count, closed, 2, -1.0F);
    for_vectors(count, [&](std::int64_t at) HWY_ATTR {
        hn::StoreU(largest_near(rows[HatchRow::least_margin] + at), d, rows[HatchRow::greatest_nearby] + at);
    });
}

} // namespace

HatchLoops pick() noexcept { return {may_draw, coverage, project, set_widths, measure_distances}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE::hatch_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::frame, HatchLoops, hatch_loops, hatch_loops::pick)
