// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stipples/order_loops.cpp"
#include "base/simd.h"

#include "stipples/order_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::stipples::HWY_NAMESPACE::order_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, OrderGroup::size>;
using U = hn::Rebind<std::uint32_t, F>;
using I = hn::Rebind<std::int32_t, F>;
using W = hn::Vec<F>;

HWY_INLINE std::int64_t lanes() { return static_cast<std::int64_t>(hn::Lanes(F())); }

// Each product and each sum is rounded separately, because a fused multiply-add gives different bits and does not exist
// on all targets.
HWY_INLINE W dot(W ax, W ay, W az, W bx, W by, W bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

template <int shift>
HWY_INLINE W coordinate(hn::Vec<U> bits) {
    const auto ten = hn::And(hn::ShiftRight<shift>(bits), hn::Set(U(), 1023U));
    return hn::Sub(hn::ConvertTo(F(), hn::BitCast(I(), ten)), hn::Set(F(), 511.5F));
}

// A mark, repeated in all lanes. Normals need not have unit length.
struct MarkInLanes {
    HWY_INLINE explicit MarkInLanes(const OrderMark& mark)
        : x(hn::Set(F(), mark.position[0])), y(hn::Set(F(), mark.position[1])), z(hn::Set(F(), mark.position[2])),
          normal_x(coordinate<0>(bits_of(mark))), normal_y(coordinate<10>(bits_of(mark))),
          normal_z(coordinate<20>(bits_of(mark))) {}
    static HWY_INLINE hn::Vec<U> bits_of(const OrderMark& mark) {
        return hn::Set(U(), __builtin_bit_cast(std::uint32_t, mark.normal));
    }

    W x, y, z, normal_x, normal_y, normal_z;
};

// A vector of a group's candidates.
struct Lanes {
    HWY_INLINE Lanes(OrderGroup& of, std::int64_t first)
        : group(of), at(first), x(load(OrderGroup::x)), y(load(OrderGroup::y)), z(load(OrderGroup::z)),
          normal(hn::BitCast(U(), load(OrderGroup::normal))), energy(load(OrderGroup::energy)),
          clearance(load(OrderGroup::clearance)) {}

    template <bool on_surface>
    HWY_INLINE void add_energy(const MarkInLanes& mark, W inverse_squared_reach) {
        const F d;
        const W way_x = hn::Sub(x, mark.x);
        const W way_y = hn::Sub(y, mark.y);
        const W way_z = hn::Sub(z, mark.z);
        W squared = dot(way_x, way_y, way_z, way_x, way_y, way_z);
        const W own_x = coordinate<0>(normal);
        const W own_y = coordinate<10>(normal);
        const W own_z = coordinate<20>(normal);
        const W turn = dot(own_x, own_y, own_z, mark.normal_x, mark.normal_y, mark.normal_z);
        if (on_surface) { // Across a crease, the distance is the length of the way through both tangent planes.
            const W here = dot(way_x, way_y, way_z, own_x, own_y, own_z);
            const W there = dot(way_x, way_y, way_z, mark.normal_x, mark.normal_y, mark.normal_z);
            const W both = hn::Mul(hn::Set(d, -2.0F), hn::Mul(here, there));
            const W one = hn::Set(d, unpacked_length * unpacked_length);
            const W detour = hn::Div(both, hn::Max(hn::Add(one, turn), hn::Mul(one, hn::Set(d, 0.1F))));
            squared = hn::Add(squared, hn::Max(hn::Zero(d), detour));
        }
        const auto same_side = hn::Ge(turn, hn::Set(d, least_side_cosine * unpacked_length * unpacked_length));
        const W rest = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(squared, inverse_squared_reach)));
        const W rest2 = hn::Mul(rest, rest);
        energy = hn::IfThenElse(same_side, hn::Add(energy, hn::Mul(rest2, rest2)), energy);
        clearance = hn::IfThenElse(same_side, hn::Min(clearance, squared), clearance);
    }
    HWY_INLINE void store() const {
        hn::Store(energy, F(), group.number[OrderGroup::energy] + at);
        hn::Store(clearance, F(), group.number[OrderGroup::clearance] + at);
    }
    HWY_INLINE W load(OrderGroup::Column column) const { return hn::Load(F(), group.number[column] + at); }

    OrderGroup& group;
    std::int64_t at;
    W x, y, z;
    hn::Vec<U> normal;
    W energy, clearance;
};

// On some targets of Highway, the minimum of lanes that are all infinite is the largest finite number. This corrects
// it.
HWY_INLINE float infinite_beyond_most(float x) { return x < 3.4028234e38F ? x : __builtin_inff(); }

// Keeps the lowest energy of each lane, and the first index with this energy.
class LowestSearch {
public:
    explicit LowestSearch(float least_clearance)
        : enough_(hn::Set(F(), least_clearance)), infinite_(hn::Set(F(), __builtin_inff())), least_(infinite_),
          least_of_all_(infinite_), at_(hn::Zero(I())) {}

    HWY_INLINE void consider(W energy, W clearance, std::int64_t at) {
        least_of_all_ = hn::Min(least_of_all_, energy);
        const auto lower = hn::And(hn::Ge(clearance, enough_), hn::Lt(energy, least_));
        least_ = hn::IfThenElse(lower, energy, least_);
        at_ = hn::IfThenElse(hn::RebindMask(I(), lower), hn::Iota(I(), static_cast<std::int32_t>(at)), at_);
    }

    HWY_INLINE LowestEnergy found() const {
        const F d;
        const W least = hn::MinOfLanes(d, least_);
        const float energy = infinite_beyond_most(hn::GetLane(least));
        const float at_any_clearance = infinite_beyond_most(hn::GetLane(hn::MinOfLanes(d, least_of_all_)));
        if (!(energy < __builtin_inff())) return {-1, energy, at_any_clearance};
        const auto best = hn::RebindMask(I(), hn::Eq(least_, least));
        const auto first = hn::MinOfLanes(I(), hn::IfThenElse(best, at_, hn::Set(I(), 0x7fffffff)));
        return {hn::GetLane(first), energy, at_any_clearance};
    }

private:
    W enough_, infinite_, least_, least_of_all_;
    hn::Vec<I> at_;
};

// Calls visit(group, at, number) for each vector of lanes. `at` is its place in the group, and `number` its place in
// the block.
template <class Visit>
HWY_INLINE void for_lanes(const OrderBlock& block, Visit&& visit) {
    for (std::int64_t g = 0; g < block.groups; ++g)
        for (std::int64_t at = 0; at < OrderGroup::size; at += lanes())
            visit(block.group[g], at, g * OrderGroup::size + at);
}

template <bool on_surface>
void add_energy(const OrderBlock& block, const OrderMark* marks, std::int64_t count, float inverse_squared_reach) {
    const W inverse = hn::Set(F(), inverse_squared_reach);
    for_lanes(block, [&](OrderGroup& group, std::int64_t at, std::int64_t) HWY_ATTR {
        Lanes lanes(group, at);
        for (std::int64_t i = 0; i < count; ++i) lanes.template add_energy<on_surface>(MarkInLanes(marks[i]), inverse);
        lanes.store();
    });
}

LowestEnergy lowest(const OrderBlock& block, float least_clearance) {
    const F d;
    LowestSearch search(least_clearance);
    for_lanes(block, [&](const OrderGroup& group, std::int64_t at, std::int64_t number) HWY_ATTR {
        search.consider(hn::Load(d, group.number[OrderGroup::energy] + at),
                        hn::Load(d, group.number[OrderGroup::clearance] + at), number);
    });
    return search.found();
}

template <bool on_surface>
LowestEnergy add_energy_and_find(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach,
                                 float least_clearance) {
    const W inverse = hn::Set(F(), inverse_squared_reach);
    const MarkInLanes in_lanes(mark);
    LowestSearch search(least_clearance);
    for_lanes(block, [&](OrderGroup& group, std::int64_t at, std::int64_t number) HWY_ATTR {
        Lanes lanes(group, at);
        lanes.template add_energy<on_surface>(in_lanes, inverse);
        lanes.store();
        search.consider(lanes.energy, lanes.clearance, number);
    });
    return search.found();
}

// Another thread may be writing to the numbers after the last one, so the last vector is copied before it is loaded.
std::int64_t index_of_smallest(const float* numbers, std::int64_t count) {
    LowestSearch search(0.0F);
    std::int64_t at = 0;
    for (; at + lanes() <= count; at += lanes()) search.consider(hn::LoadU(F(), numbers + at), hn::Zero(F()), at);
    if (at < count) {
        HWY_ALIGN float last[HWY_LANES(float)];
        for (std::int64_t i = 0; i < lanes(); ++i) last[i] = at + i < count ? numbers[at + i] : __builtin_inff();
        search.consider(hn::Load(F(), last), hn::Zero(F()), at);
    }
    return search.found().at;
}

} // namespace

OrderLoops pick() noexcept {
    return {{add_energy<false>, add_energy<true>},
            lowest,
            {add_energy_and_find<false>, add_energy_and_find<true>},
            index_of_smallest};
}

} // namespace hrbfnpr::stipples::HWY_NAMESPACE::order_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::stipples, OrderLoops, order_loops, order_loops::pick)

#if HWY_ONCE
namespace hrbfnpr::stipples {
namespace {

void free_place(const OrderBlock& block, std::int64_t i) noexcept {
    block.at(OrderGroup::energy, i) = __builtin_inff();
    block.at(OrderGroup::clearance, i) = -1.0F;
}

} // namespace

void copy_place(const OrderBlock& from, std::int64_t i, const OrderBlock& to, std::int64_t k) noexcept {
    for (std::int64_t c = 0; c < OrderGroup::columns; ++c) to.at(c, k) = from.at(c, i);
}

void forget_marks(const OrderBlock& block, std::int64_t count) noexcept {
    HRBFNPR_ASSERT(count >= 0 && count <= block.places());
    for (std::int64_t i = 0; i < count; ++i) {
        block.at(OrderGroup::energy, i) = 0.0F;
        block.at(OrderGroup::clearance, i) = __builtin_inff();
    }
    for (std::int64_t i = count; i < block.places(); ++i) {
        for (std::int64_t c = 0; c < OrderGroup::columns; ++c) block.at(c, i) = 0.0F;
        free_place(block, i);
    }
}

float packed_normal(const float (&normal)[3]) noexcept {
    std::uint32_t bits = 0;
    for (unsigned c = 0; c < 3; ++c) {
        const float n = normal[c];
        bits |= static_cast<std::uint32_t>((n < -1.0F ? 0.0F : n > 1.0F ? 2.0F : n + 1.0F) * 511.5F) << (10U * c);
    }
    return __builtin_bit_cast(float, bits);
}

} // namespace hrbfnpr::stipples
#endif
