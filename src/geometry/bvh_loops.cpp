// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/bvh_loops.cpp"
#include "base/simd.h"

#include "base/assert.h"
#include "geometry/bvh_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::geometry::HWY_NAMESPACE::bvh_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, bvh_width>;
using W = hn::Vec<F>;
using M = hn::Mask<F>;

HWY_INLINE unsigned bits_of(M mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(F(), mask, bits);
    return bits[0];
}

// Returns the bits of mask_at(0), mask_at(lanes) and so on.
template <class MaskAt>
HWY_INLINE unsigned bits_of_all(const MaskAt& mask_at) {
    const int lanes = static_cast<int>(hn::Lanes(F()));
    unsigned bits = 0;
    for (int at = 0; at < bvh_width; at += lanes) bits |= bits_of(mask_at(at)) << static_cast<unsigned>(at);
    return bits;
}

HWY_INLINE unsigned first_bit(unsigned bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

// Returns the index of the lowest number among those whose bits are set.
HWY_INLINE unsigned lowest(const float* number, unsigned bits) {
    unsigned best = first_bit(bits);
    for (bits &= bits - 1; bits != 0; bits &= bits - 1)
        if (number[first_bit(bits)] < number[best]) best = first_bit(bits);
    return best;
}

// Nodes and leaves that wait for their turn, the nearest on top.
class Stack {
public:
    // Adds the children whose bits are set.
    HWY_INLINE void push(const BvhNode& node, unsigned bits, const float* from) {
        const int first = depth_;
        for (; bits != 0; bits &= bits - 1) {
            const unsigned i = first_bit(bits);
            int at = depth_++;
            for (; at > first && waiting_[at - 1].from < from[i]; --at) waiting_[at] = waiting_[at - 1];
            waiting_[at] = {from[i], node.child[i]};
        }
        HRBFNPR_ASSERT(depth_ <= most);
    }
    HWY_INLINE void push(std::uint32_t child) { waiting_[depth_++] = {0.0F, child}; }
    HWY_INLINE bool pop(float limit, std::uint32_t& child) {
        while (depth_ > 0) {
            const Waiting& top = waiting_[--depth_];
            child = top.child;
            if (top.from <= limit) return true;
        }
        return false;
    }
    // Begins to load the node or leaf on top.
    HWY_INLINE void prefetch(const BvhView& bvh) const {
        if (depth_ == 0) return;
        const std::uint32_t child = waiting_[depth_ - 1].child;
        const float* const from =
            (child & bvh_leaf) != 0 ? bvh.leaf[child & ~bvh_leaf].corner[0] : bvh.node[child].side[0];
        for (int line = 0; line < 4; ++line) __builtin_prefetch(from + 16 * line);
    }

private:
    static constexpr int most = (bvh_width - 1) * bvh_levels + 1;
    struct Waiting {
        float from; // where the ray enters the box, or the squared distance to the box
        std::uint32_t child;
    };
    Waiting waiting_[most];
    int depth_ = 0;
};

// meets(node, limit, from) returns the bits of the children to visit, and their order. matters(leaf, limit) returns the
// bits of the triangles to visit.
template <class Meets, class Matters>
HWY_INLINE void walk(const BvhView& bvh, float limit, BvhVisit visit, void* user, const Meets& meets,
                     const Matters& matters) {
    Stack stack;
    stack.push(bvh.root);
    std::uint32_t child = 0;
    while (stack.pop(limit, child)) {
        stack.prefetch(bvh);
        if ((child & bvh_leaf) == 0) {
            const BvhNode& node = bvh.node[child];
            HWY_ALIGN float from[bvh_width];
            stack.push(node, meets(node, limit, from), from);
            continue;
        }
        const BvhLeaf& leaf = bvh.leaf[child & ~bvh_leaf];
        const unsigned all = (1U << static_cast<unsigned>(leaf.count)) - 1U;
        HWY_ALIGN float from[bvh_width];
        for (unsigned bits = matters(leaf, limit, from) & all; bits != 0;) {
            const unsigned i = lowest(from, bits);
            if (from[i] > limit) break;
            bits ^= 1U << i;
            limit = visit(user, leaf.first + static_cast<std::int64_t>(i));
            if (limit < 0.0F) return;
        }
    }
}

// ---- Rays

// A ray, repeated in all lanes.
struct RayInLanes {
    HWY_INLINE explicit RayInLanes(const BvhRay& ray) {
        const F d;
        for (int k = 0; k < 3; ++k) {
            near_row[k] = ray.inverse[k] < 0.0F ? k + 3 : k;
            far_row[k] = ray.inverse[k] < 0.0F ? k : k + 3;
            axis[k] = ray.axis[k];
        }
        x = hn::Set(d, ray.origin[0]);
        y = hn::Set(d, ray.origin[1]);
        z = hn::Set(d, ray.origin[2]);
        per_x = hn::Set(d, ray.inverse[0]);
        per_y = hn::Set(d, ray.inverse[1]);
        per_z = hn::Set(d, ray.inverse[2]);
        along[0] = ray.origin[ray.axis[0]];
        along[1] = ray.origin[ray.axis[1]];
        along[2] = ray.origin[ray.axis[2]];
        slope[0] = ray.slope[0];
        slope[1] = ray.slope[1];
    }

    // Returns the bits of the children that the ray meets before `limit`, and where it enters them.
    HWY_INLINE unsigned meets(const BvhNode& node, float limit, float* from) const {
        const F d;
        return bits_of_all([&](int at) HWY_ATTR {
            const auto side = [&](int row, W origin, W inverse) HWY_ATTR {
                return hn::Mul(hn::Sub(hn::Load(d, node.side[row] + at), origin), inverse);
            };
            const W enter = hn::Max(hn::Max(side(near_row[0], x, per_x), side(near_row[1], y, per_y)),
                                    hn::Max(side(near_row[2], z, per_z), hn::Zero(d)));
            const W leave = hn::Min(hn::Min(side(far_row[0], x, per_x), side(far_row[1], y, per_y)),
                                    hn::Min(side(far_row[2], z, per_z), hn::Set(d, limit)));
            hn::Store(enter, d, from + at);
            return hn::Le(enter, leave);
        });
    }

    // Returns the bits of the triangles that the ray may meet. The test is that of Woop, Benthin, Wald, "Watertight
    // ray/triangle intersection" (2013), with bounds of the rounding errors. Sheared coordinates are off by at most
    // 2^-20, so a cross product of two of them is off by at most 2^-20 times the sum of the four, and by the rounding
    // errors of its own products.
    HWY_INLINE unsigned may_meet(const BvhLeaf& leaf, float* from) const {
        const F d;
        const W ox = hn::Set(d, along[0]);
        const W oy = hn::Set(d, along[1]);
        const W oz = hn::Set(d, along[2]);
        const W sx = hn::Set(d, slope[0]);
        const W sy = hn::Set(d, slope[1]);
        return bits_of_all([&](int at) HWY_ATTR {
            W px[3];
            W py[3];
            W sum = hn::Zero(d);
            for (int k = 0; k < 3; ++k) {
                const W z_off = hn::Sub(hn::Load(d, leaf.corner[3 * k + axis[2]] + at), oz);
                px[k] = hn::Sub(hn::Sub(hn::Load(d, leaf.corner[3 * k + axis[0]] + at), ox), hn::Mul(sx, z_off));
                py[k] = hn::Sub(hn::Sub(hn::Load(d, leaf.corner[3 * k + axis[1]] + at), oy), hn::Mul(sy, z_off));
                sum = hn::Add(sum, hn::Add(hn::Abs(px[k]), hn::Abs(py[k])));
            }
            hn::Store(hn::Zero(d), d, from + at);
            const auto cross = [&](int a, int b)
                                   HWY_ATTR { return hn::Sub(hn::Mul(px[a], py[b]), hn::Mul(py[a], px[b])); };
            const W u = cross(2, 1);
            const W v = cross(0, 2);
            const W w = cross(1, 0);
            const W error = hn::Add(hn::Mul(sum, hn::Set(d, 0x1p-19F)), hn::Set(d, 1e-11F));
            const M all_positive = hn::Ge(hn::Min(hn::Min(u, v), w), hn::Neg(error));
            const M all_negative = hn::Le(hn::Max(hn::Max(u, v), w), error);
            return hn::Or(all_positive, all_negative);
        });
    }

    W x, y, z;
    W per_x, per_y, per_z;
    int near_row[3], far_row[3], axis[3];
    float along[3], slope[2];
};

void along(const BvhView& bvh, const BvhRay& ray, BvhVisit visit, void* user) {
    const RayInLanes lanes(ray);
    walk(
        bvh, ray.limit, visit, user,
        [&](const BvhNode& node, float limit, float* from) HWY_ATTR { return lanes.meets(node, limit, from); },
        [&](const BvhLeaf& leaf, float, float* from) HWY_ATTR { return lanes.may_meet(leaf, from); });
}

// ---- The nearest place

// Vectors in all lanes.
struct Vec3 {
    W x, y, z;
};

HWY_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE W dot(const Vec3& a, const Vec3& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// Returns the squared distance of the origin to the segment from `a` to a + along.
HWY_INLINE W squared_to_segment(const Vec3& a, const Vec3& along) {
    const F d;
    const W t = hn::Div(hn::Neg(dot(a, along)), hn::Max(dot(along, along), hn::Set(d, 1e-30F)));
    const W in = hn::Min(hn::Max(t, hn::Zero(d)), hn::Set(d, 1.0F));
    const Vec3 off = {hn::Add(a.x, hn::Mul(in, along.x)), hn::Add(a.y, hn::Mul(in, along.y)),
                      hn::Add(a.z, hn::Mul(in, along.z))};
    return dot(off, off);
}

// Returns the squared distance of the origin to triangles, rounded down, or 0 for a triangle that is so narrow that its
// normal is uncertain. Corners are at most `reach` away, and each coordinate is off by `error`.
HWY_INLINE W squared_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c, W reach, W error) {
    const F d;
    const Vec3 ab = b - a;
    const Vec3 bc = c - b;
    const Vec3 ca = a - c;
    const Vec3 normal = cross(ab, bc);
    const W size = dot(normal, normal);
    const W height = dot(normal, a);
    const W edges = hn::Min(hn::Min(squared_to_segment(a, ab), squared_to_segment(b, bc)), squared_to_segment(c, ca));
    const W side = hn::Max(hn::Max(dot(normal, cross(ab, a)), dot(normal, cross(bc, b))), dot(normal, cross(ca, c)));
    // A normal is off by at most 3 * 2^-24 over the sine of the angle.
    const W least = hn::Mul(hn::Set(d, 0x1p-16F), hn::Mul(dot(ab, ab), dot(bc, bc)));
    const M certain = hn::And(hn::Ge(size, least), hn::Ge(size, hn::Set(d, 1e-30F)));
    const W plane = hn::Div(hn::Mul(height, height), hn::Max(size, hn::Set(d, 1e-30F)));
    const W squared = hn::IfThenElse(hn::Le(side, hn::Zero(d)), hn::Min(plane, edges), edges);
    const W slack = hn::Add(hn::Mul(reach, hn::Set(d, 0x1p-13F)), hn::Mul(error, hn::Set(d, 2.0F)));
    const W distance = hn::Max(hn::Sub(hn::Sqrt(squared), slack), hn::Zero(d));
    return hn::IfThenElseZero(certain, hn::Mul(distance, distance));
}

// A place, repeated in all lanes.
struct PlaceInLanes {
    HWY_INLINE explicit PlaceInLanes(const BvhPlace& from) {
        const F d;
        for (int k = 0; k < 3; ++k) place[k] = hn::Set(d, from.place[k]);
        error = hn::Set(d, from.error);
    }
    // Returns the squared distance to a box, rounded down.
    HWY_INLINE W squared_to(const W* low, const W* high) const {
        const F d;
        W sum = hn::Zero(d);
        for (int k = 0; k < 3; ++k) {
            const W off = hn::Max(hn::Sub(low[k], place[k]), hn::Sub(place[k], high[k]));
            const W outside = hn::Max(hn::Sub(off, error), hn::Zero(d));
            sum = hn::Add(sum, hn::Mul(outside, outside));
        }
        return sum;
    }
    HWY_INLINE unsigned meets(const BvhNode& node, float limit, float* squared) const {
        const F d;
        return bits_of_all([&](int at) HWY_ATTR {
            const W low[3] = {hn::Load(d, node.side[0] + at), hn::Load(d, node.side[1] + at),
                              hn::Load(d, node.side[2] + at)};
            const W high[3] = {hn::Load(d, node.side[3] + at), hn::Load(d, node.side[4] + at),
                               hn::Load(d, node.side[5] + at)};
            const W sum = squared_to(low, high);
            hn::Store(sum, d, squared + at);
            return hn::Le(sum, hn::Set(d, limit));
        });
    }
    HWY_INLINE unsigned may_be_near(const BvhLeaf& leaf, float limit, float* squared) const {
        const F d;
        return bits_of_all([&](int at) HWY_ATTR {
            const auto corner = [&](int k) HWY_ATTR {
                return Vec3{hn::Sub(hn::Load(d, leaf.corner[k] + at), place[0]),
                            hn::Sub(hn::Load(d, leaf.corner[k + 1] + at), place[1]),
                            hn::Sub(hn::Load(d, leaf.corner[k + 2] + at), place[2])};
            };
            const Vec3 a = corner(0);
            const Vec3 b = corner(3);
            const Vec3 c = corner(6);
            W reach = hn::Zero(d);
            W sum = hn::Zero(d);
            const auto add_axis = [&](W at_a, W at_b, W at_c) HWY_ATTR {
                const W low = hn::Min(hn::Min(at_a, at_b), at_c);
                const W high = hn::Max(hn::Max(at_a, at_b), at_c);
                const W outside = hn::Max(hn::Sub(hn::Max(low, hn::Neg(high)), error), hn::Zero(d));
                sum = hn::Add(sum, hn::Mul(outside, outside));
                reach = hn::Add(reach, hn::Max(hn::Neg(low), high));
            };
            add_axis(a.x, b.x, c.x);
            add_axis(a.y, b.y, c.y);
            add_axis(a.z, b.z, c.z);
            if (hn::AllTrue(d, hn::Gt(sum, hn::Set(d, limit)))) {
                hn::Store(sum, d, squared + at);
                return hn::Le(sum, hn::Set(d, limit));
            }
            sum = hn::Max(sum, squared_to_triangle(a, b, c, reach, error));
            hn::Store(sum, d, squared + at);
            return hn::Le(sum, hn::Set(d, limit));
        });
    }

    W place[3], error;
};

void around(const BvhView& bvh, const BvhPlace& place, BvhVisit visit, void* user) {
    const PlaceInLanes lanes(place);
    walk(
        bvh, place.limit, visit, user,
        [&](const BvhNode& node, float limit, float* squared) HWY_ATTR { return lanes.meets(node, limit, squared); },
        [&](const BvhLeaf& leaf, float limit, float* squared)
            HWY_ATTR { return lanes.may_be_near(leaf, limit, squared); });
}

} // namespace

BvhLoops loops() { return {along, around}; }

} // namespace hrbfnpr::geometry::HWY_NAMESPACE::bvh_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::geometry, BvhLoops, bvh_loops, bvh_loops::loops)
