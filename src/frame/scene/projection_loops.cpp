// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/scene/projection_loops.cpp"
#include "base/simd.h"

#include "base/assert.h"
#include "frame/scene/projection_loops.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE::projection_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, marks::MarkBlock::size>; // A vector is not larger than a block of marks.
using W = hn::Vec<F>;
using M = hn::Mask<F>;

// Products and sums are rounded separately, because fused operations exist only on some processors and give different
// bits.
HWY_INLINE W dot3(const float* row, W x, W y, W z) {
    const F d;
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
                   hn::Mul(hn::Set(d, row[2]), z));
}
HWY_INLINE W affine(const float* row, W x, W y, W z) { return hn::Add(dot3(row, x, y, z), hn::Set(F(), row[3])); }
HWY_INLINE W squared(W x, W y, W z) { return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)); }

// Returns x to the power `exponent`. Most exponents use the function for one number, so that all instruction sets give
// the same bits.
HWY_INLINE W power(W x, float exponent) {
    const F d;
    if (exponent == 1.0F) return x;
    if (exponent == 1.5F) return hn::Mul(x, hn::Sqrt(x));
    if (exponent == 2.0F) return hn::Mul(x, x);
    if (exponent == 3.0F) return hn::Mul(hn::Mul(x, x), x);
    HWY_ALIGN float lane[marks::MarkBlock::size];
    hn::Store(x, d, lane);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) lane[i] = std::pow(lane[i], exponent);
    return hn::Load(d, lane);
}

HWY_INLINE W clamped(W x) {
    const F d;
    return hn::Min(hn::Max(x, hn::Zero(d)), hn::Set(d, 1.0F));
}

// Returns the product of the unit vector towards a lamp and a vector of normals.
HWY_INLINE W facing(const Lamp& lamp, const W (&at)[3], const W (&normal)[3]) {
    const F d;
    if (lamp.place[3] == 0.0F) return dot3(lamp.place, normal[0], normal[1], normal[2]);
    const W x = hn::Sub(hn::Set(d, lamp.place[0]), at[0]);
    const W y = hn::Sub(hn::Set(d, lamp.place[1]), at[1]);
    const W z = hn::Sub(hn::Set(d, lamp.place[2]), at[2]);
    const W cosine = hn::Add(hn::Add(hn::Mul(x, normal[0]), hn::Mul(y, normal[1])), hn::Mul(z, normal[2]));
    // A mark at the place of the light itself is dark.
    return hn::Div(cosine, hn::Sqrt(hn::Max(squared(x, y, z), hn::Set(d, 1e-30F))));
}

// Returns tau of a sum of light.
HWY_INLINE W tone_of(const Lighting& s, W sum) {
    const F d;
    W tau = clamped(hn::Mul(hn::Sub(sum, hn::Set(d, s.black)), hn::Set(d, s.per_range)));
    tau = power(tau, s.gamma);
    if (s.steps == 0) return tau;
    const W step = hn::Floor(hn::Mul(tau, hn::Set(d, static_cast<float>(s.steps))));
    const auto last = static_cast<float>(s.steps - 1);
    return hn::Mul(hn::Min(step, hn::Set(d, last)), hn::Set(d, 1.0F / last));
}

// Returns the light that is left if the share `seen` of its source is seen.
HWY_INLINE W left_of(W light, W seen, float strength) {
    const F d;
    const W one = hn::Set(d, 1.0F);
    return hn::Mul(light, hn::Sub(one, hn::Mul(hn::Set(d, strength), hn::Sub(one, seen))));
}

// The places and normals of a vector of marks, in the space of the lamps.
struct LitVector {
    W at[3], normal[3];
    W length; // the lengths of the normals; 1 if `rigid`
    bool rigid;

    HWY_INLINE W of_unit(W cosine) const { return rigid ? cosine : hn::Div(cosine, length); }
};

HWY_INLINE LitVector in_light(const Lighting& s, const W (&position)[3], const W (&own_normal)[3]) {
    const F d;
    LitVector v{{position[0], position[1], position[2]},
                {own_normal[0], own_normal[1], own_normal[2]},
                hn::Set(d, 1.0F),
                s.rigid};
    if (s.rigid) return v;
    for (int k = 0; k < 3; ++k) {
        v.at[k] = dot3(s.place[k], position[0], position[1], position[2]);
        v.normal[k] = dot3(s.normal[k], own_normal[0], own_normal[1], own_normal[2]);
    }
    v.length = hn::Sqrt(squared(v.normal[0], v.normal[1], v.normal[2]));
    return v;
}

// Returns tau of a vector of marks, whose shares begin at `at`.
HWY_INLINE W lit(const Lighting& s, const LitVector& v, W nu, const LightShares& shares, std::int64_t at) {
    const F d;
    W sum = hn::Set(d, s.ambient);
    if (s.from_sky != 0.0F)
        sum =
            hn::Add(sum, hn::Mul(hn::Set(d, s.from_sky), v.of_unit(dot3(s.up, v.normal[0], v.normal[1], v.normal[2]))));
    W lamps = hn::Zero(d);
    for (std::int32_t i = 0; i < s.count; ++i) {
        const Lamp& lamp = s.lamps[i];
        const W cosine = v.of_unit(facing(lamp, v.at, v.normal));
        W light = hn::Mul(hn::Set(d, lamp.intensity), power(clamped(cosine), s.exponent));
        if (shares.visible[i] != nullptr) light = left_of(light, hn::LoadU(d, shares.visible[i] + at), lamp.shadow);
        lamps = hn::Add(lamps, light);
        if (lamp.fill == 0.0F) continue;
        const W away = clamped(hn::Neg(cosine));
        lamps = hn::Add(lamps, hn::Mul(hn::Mul(hn::Set(d, lamp.fill), away), away));
    }
    if (shares.open != nullptr) {
        const W open = power(hn::LoadU(d, shares.open + at), s.occlusion_exponent);
        sum = left_of(sum, open, s.occlusion);
        lamps = left_of(lamps, open, s.occlusion_lights);
    }
    sum = hn::Add(sum, lamps);
    if (s.rim > 0.0F) {
        const W side = clamped(hn::Sub(hn::Set(d, 1.0F), hn::Abs(nu)));
        sum = hn::Add(sum, hn::Mul(hn::Set(d, s.rim), power(side, s.rim_exponent)));
    }
    if (shares.bend != nullptr)
        sum = hn::Add(sum, hn::Mul(hn::Set(d, s.curvature_contrast), hn::LoadU(d, shares.bend + at)));
    return tone_of(s, sum);
}

void light(const Lighting& lighting, const MarkRange& range, const float* nu, const LightShares& shares, float* tau) {
    HRBFNPR_ASSERT(range.count >= 0 && range.count <= ProjectedMarks::most);
    const F d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < range.count; at += lanes) {
        const marks::MarkBlock& m = range.blocks[at / marks::MarkBlock::size];
        const std::int64_t i = at % marks::MarkBlock::size;
        const W position[3] = {hn::LoadU(d, m.x + i), hn::LoadU(d, m.y + i), hn::LoadU(d, m.z + i)};
        const W normal[3] = {hn::LoadU(d, m.nx + i), hn::LoadU(d, m.ny + i), hn::LoadU(d, m.nz + i)};
        const LitVector v = in_light(lighting, position, normal);
        hn::StoreU(lit(lighting, v, hn::LoadU(d, nu + at), shares, at), d, tau + at);
    }
}

void light_rows(const Lighting& lighting, const MarkRows& m, const float* nu, const LightShares& shares, float* tau) {
    const F d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < m.count; at += lanes) {
        const W position[3] = {hn::LoadU(d, m.x + at), hn::LoadU(d, m.y + at), hn::LoadU(d, m.z + at)};
        const W normal[3] = {hn::LoadU(d, m.nx + at), hn::LoadU(d, m.ny + at), hn::LoadU(d, m.nz + at)};
        const LitVector v = in_light(lighting, position, normal);
        hn::StoreU(lit(lighting, v, hn::LoadU(d, nu + at), shares, at), d, tau + at);
    }
}

// Projects the vector of marks at `at`. load(0) to load(5) give x, y and z of the position and of the normal.
template <class Load>
HWY_INLINE void project_vector(const ViewTransform& s, std::int64_t at, const ProjectedRows& projected,
                               const Load& load) {
    const F d;
    const W one = hn::Set(d, 1.0F);
    const W px = load(0);
    const W py = load(1);
    const W pz = load(2);
    const W per_w = hn::Div(one, affine(s.clip[3], px, py, pz));
    hn::StoreU(hn::Mul(affine(s.clip[0], px, py, pz), per_w), d, projected.x + at);
    hn::StoreU(hn::Mul(affine(s.clip[1], px, py, pz), per_w), d, projected.y + at);
    hn::StoreU(hn::Mul(affine(s.clip[2], px, py, pz), per_w), d, projected.window + at);
    hn::StoreU(hn::Mul(hn::Set(d, s.pixels), per_w), d, projected.pixels_per_unit + at);
    const W depth = hn::Neg(affine(s.eye[2], px, py, pz));
    W vx = hn::Set(d, s.centre[0]);
    W vy = hn::Set(d, s.centre[1]);
    W vz = hn::Set(d, s.centre[2]);
    if (!s.parallel) {
        vx = hn::Sub(affine(s.eye[0], px, py, pz), vx);
        vy = hn::Sub(affine(s.eye[1], px, py, pz), vy);
        vz = hn::Sub(affine(s.eye[2], px, py, pz), vz);
    }
    const W length = hn::Sqrt(squared(vx, vy, vz));
    const W inverse = hn::Div(one, length);
    const W nx = load(3);
    const W ny = load(4);
    const W nz = load(5);
    W tx = dot3(s.normal[0], nx, ny, nz);
    W ty = dot3(s.normal[1], nx, ny, nz);
    W tz = dot3(s.normal[2], nx, ny, nz);
    if (!s.rigid) {
        const W unit = hn::Div(one, hn::Sqrt(squared(tx, ty, tz)));
        tx = hn::Mul(tx, unit);
        ty = hn::Mul(ty, unit);
        tz = hn::Mul(tz, unit);
    }
    const W facing = hn::Add(hn::Add(hn::Mul(tx, vx), hn::Mul(ty, vy)), hn::Mul(tz, vz));
    hn::StoreU(hn::Mul(facing, inverse), d, projected.nu + at);
    hn::StoreU(tx, d, projected.side_x + at);
    hn::StoreU(ty, d, projected.side_y + at);
    if (projected.along != nullptr) hn::StoreU(hn::Mul(hn::Neg(vz), inverse), d, projected.along + at);
    hn::StoreU(depth, d, projected.depth + at);
    hn::StoreU(s.parallel ? depth : length, d, projected.distance + at);
}

void project(const ViewTransform& s, const MarkRange& range, ProjectedMarks& projected) {
    HRBFNPR_ASSERT(range.count >= 0 && range.count <= ProjectedMarks::most);
    const F d;
    const ProjectedRows to = {
        projected.x,  projected.y,      projected.window, projected.depth,    projected.pixels_per_unit,
        projected.nu, projected.side_x, projected.side_y, projected.distance, projected.along};
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < range.count; at += lanes) {
        const marks::MarkBlock& m = range.blocks[at / marks::MarkBlock::size];
        const float* const rows[6] = {m.x, m.y, m.z, m.nx, m.ny, m.nz};
        const std::int64_t in_block = at % marks::MarkBlock::size;
        project_vector(s, at, to, [&](int k) HWY_ATTR { return hn::LoadU(d, rows[k] + in_block); });
    }
}

void project_rows(const ViewTransform& view_transform, const MarkRows& m, const ProjectedRows& to) {
    const F d;
    const ViewTransform s = view_transform; // a copy that no store can change
    const ProjectedRows projected = to;
    const float* const rows[6] = {m.x, m.y, m.z, m.nx, m.ny, m.nz};
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    for (std::int64_t at = 0; at < m.count; at += lanes)
        project_vector(s, at, projected, [&](int k) HWY_ATTR { return hn::LoadU(d, rows[k] + at); });
}

// Returns the share of a mark's area that is drawn. `place` is 1 - rank. As `shown` rises above `place`, the area grows
// from 0.
HWY_INLINE W grown(W place, W shown, float fade) {
    const F d;
    const W rest = hn::Sub(shown, place);
    const M is_shown = hn::And(hn::Ge(rest, hn::Zero(d)), hn::Gt(shown, hn::Zero(d)));
    if (!(fade > 0.0F)) return hn::IfThenElseZero(is_shown, hn::Set(d, 1.0F));
    return hn::IfThenElseZero(is_shown, hn::Min(hn::Set(d, 1.0F), hn::Div(rest, hn::Mul(hn::Set(d, fade), shown))));
}

HWY_INLINE M inside(const Selection& j, const ProjectedMarks& projected, std::int64_t at) {
    const F d;
    const auto between = [&](const float* from, float low, float high) HWY_ATTR {
        const W value = hn::LoadU(d, from + at);
        return hn::And(hn::Ge(value, hn::Set(d, low)), hn::Le(value, hn::Set(d, high)));
    };
    // Each comparison is false for NaN, so NaN counts as outside.
    return hn::And(hn::And(hn::And(between(projected.x, j.left, j.right), between(projected.y, j.top, j.bottom)),
                           hn::And(between(projected.window, 0.0F, 1.0F), between(projected.nu, -1.001F, 1.001F))),
                   hn::Gt(hn::LoadU(d, projected.pixels_per_unit + at), hn::Zero(d)));
}

// Returns the value at `share` of a table whose elements belong to the shares k / needed_steps.
HWY_INLINE W at_step(const float* table, W share) {
    const F d;
    const hn::RebindToSigned<F> integer;
    const W at = hn::Mul(share, hn::Set(d, static_cast<float>(needed_steps)));
    const auto cell =
        hn::Max(hn::Min(hn::ConvertTo(integer, at), hn::Set(integer, needed_steps - 1)), hn::Zero(integer));
    const W below = hn::GatherIndex(d, table, cell);
    const W above = hn::GatherIndex(d, table + 1, cell);
    return hn::Add(below, hn::Mul(hn::Sub(above, below), hn::Sub(at, hn::ConvertTo(d, cell))));
}

// Returns the share of the marks that is shown for a tone.
HWY_INLINE W shown_for(const Selection& j, W tau, W nu) {
    const F d;
    const W one = hn::Set(d, 1.0F);
    W shown = hn::Sub(one, tau);
    if (j.coverage) {
        const W needed = at_step(j.needed, shown);
        shown = hn::Min(one, hn::Mul(hn::Mul(needed, hn::Abs(nu)), hn::Set(d, j.per_ink)));
    }
    return hn::Mul(shown, hn::Set(d, j.share * j.fade_factor));
}

HWY_INLINE std::int32_t count(M mask) { return static_cast<std::int32_t>(hn::CountTrue(F(), mask)); }

// Returns how much of each front mark is drawn. Counts the reasons why marks are not drawn.
HWY_INLINE W front_of(const Selection& j, W nu, W place, W tau, W density, W tau_depth, M front, W& limit,
                      Selected& selected) {
    const F d;
    const W zero = hn::Zero(d);
    const W scale = hn::Set(d, j.scale);
    W by_tone;
    W by_zoom;
    W area;
    if (j.is_published) {
        const W rank = hn::Sub(hn::Set(d, 1.0F), place);
        const W one = hn::Set(d, 1.0F);
        const W share = hn::Mul(hn::Set(d, j.share), density);
        by_tone = hn::IfThenElseZero(hn::And(hn::Ge(rank, tau), hn::Lt(rank, share)), one);
        by_zoom = hn::IfThenElseZero(hn::Lt(rank, scale), by_tone);
        area = hn::IfThenElseZero(hn::Lt(rank, tau_depth), by_zoom);
    } else {
        const W shown = hn::Mul(shown_for(j, tau, nu), density);
        by_tone = grown(place, shown, j.fade);
        by_zoom = j.scale < 1.0F ? grown(place, hn::Mul(shown, scale), j.fade) : by_tone;
        limit = hn::Mul(hn::Mul(shown, scale), tau_depth);
        area = grown(place, limit, j.flat_places != nullptr ? 0.0F : j.fade);
        if (j.vanishing_nu > 0.0F)
            area = hn::Mul(area, hn::Min(hn::Set(d, 1.0F), hn::Mul(hn::Abs(nu), hn::Set(d, 1.0F / j.vanishing_nu))));
    }
    const M tone = hn::And(front, hn::Eq(by_tone, zero));
    const M zoom = hn::AndNot(tone, hn::And(front, hn::Eq(by_zoom, zero)));
    selected.dropped_tone += count(tone);
    selected.dropped_zoom += count(zoom);
    selected.dropped_depth += count(hn::AndNot(hn::Or(tone, zoom), hn::And(front, hn::Eq(area, zero))));
    return hn::IfThenElseZero(front, area);
}

void select(const Selection& j, const MarkRange& range, const ProjectedMarks& projected, const float* taus,
            const float* densities, const float* tau_depths, Selected& selected) {
    HRBFNPR_ASSERT(range.count >= 0 && range.count <= ProjectedMarks::most && taus != nullptr);
    const F d;
    const W zero = hn::Zero(d);
    const W one = hn::Set(d, 1.0F);
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    selected.outside = selected.fronts = selected.backs = 0;
    selected.dropped_tone = selected.dropped_zoom = selected.dropped_depth = 0;
    for (std::int64_t at = 0; at < range.count; at += lanes) {
        const marks::MarkBlock& m = range.blocks[at / marks::MarkBlock::size];
        const std::int64_t in_block = at % marks::MarkBlock::size;
        const M all = hn::FirstN(d, static_cast<size_t>(range.count - at < lanes ? range.count - at : lanes));
        const M valid = j.all_inside ? all : hn::And(all, inside(j, projected, at));
        selected.outside += count(hn::AndNot(valid, all));
        const W nu = hn::LoadU(d, projected.nu + at);
        W place = hn::Sub(one, hn::LoadU(d, m.rank + in_block));
        // Lanes after the last mark hold arbitrary bits, which must not become an index into a table.
        if (j.flat_places != nullptr)
            place = hn::Mul(place, at_step(j.flat_places, hn::IfThenElseZero(valid, hn::Abs(nu))));
        const W density = densities == nullptr ? one : hn::LoadU(d, densities + at);
        const W tau_depth = tau_depths == nullptr ? one : hn::LoadU(d, tau_depths + at);
        const M faces = hn::And(valid, hn::Lt(nu, zero));
        const std::int32_t fronts = count(faces);
        selected.fronts += fronts;
        selected.backs += count(valid) - fronts;
        const W tau = hn::IfThenElseZero(all, hn::LoadU(d, taus + at));
        W limit = one;
        const W front = front_of(j, nu, place, tau, density, tau_depth, faces, limit, selected);
        if (j.flat_places != nullptr) {
            hn::StoreU(place, d, selected.flat + at);
            hn::StoreU(limit, d, selected.limit + at);
        }
        hn::StoreU(front, d, selected.front + at);
        const M drawn = hn::Gt(front, zero);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, drawn, bits);
        selected.drawn[at / lanes] = static_cast<std::uint16_t>(bits[0] | bits[1] << 8);
    }
    selected.lanes = static_cast<std::int32_t>(lanes);
}

} // namespace

ProjectionLoops pick() noexcept { return {project, project_rows, light, light_rows, select}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE::projection_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::frame, ProjectionLoops, projection_loops, projection_loops::pick)
