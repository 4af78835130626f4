// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "stipples/order_loops.cpp"
#include "base/simd.h"

#include "stipples/order_loops.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::stipples::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, OrderGroup::size>;
using U = hn::Rebind<std::uint32_t, F>;
using I = hn::Rebind<std::int32_t, F>;
using W = hn::Vec<F>;

HWY_INLINE std::int64_t lanes() { return static_cast<std::int64_t>(hn::Lanes(F())); }

HWY_INLINE hn::Mask<F> lanes_left(std::int64_t left) {
    return hn::FirstN(F(), static_cast<size_t>(left < lanes() ? left : lanes()));
}

// Products and sums are rounded one by one: a fused step would give other bits where there is one.
HWY_INLINE W dot(W ax, W ay, W az, W bx, W by, W bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

template <int shift>
HWY_INLINE W coordinate(hn::Vec<U> bits) {
    const auto ten = hn::And(hn::ShiftRight<shift>(bits), hn::Set(U(), 1023U));
    return hn::Sub(hn::ConvertTo(F(), hn::BitCast(I(), ten)), hn::Set(F(), 511.5F));
}

// Some candidates of a group side by side.
class Lanes {
public:
    HWY_INLINE Lanes(OrderGroup& group, std::int64_t at)
        : group_(group), at_(at), x_(load(OrderGroup::x)), y_(load(OrderGroup::y)), z_(load(OrderGroup::z)),
          normal_(hn::BitCast(U(), load(OrderGroup::normal))), energy_(load(OrderGroup::energy)),
          clearance_(load(OrderGroup::clearance)) {}

    template <bool on_surface>
    HWY_INLINE void feel(const OrderMark& mark, W inverse_squared_reach) {
        const F d;
        const W x = hn::Sub(x_, hn::Set(d, mark.position[0]));
        const W y = hn::Sub(y_, hn::Set(d, mark.position[1]));
        const W z = hn::Sub(z_, hn::Set(d, mark.position[2]));
        W squared = dot(x, y, z, x, y, z);
        const W turn = dot(coordinate<0>(normal_), coordinate<10>(normal_), coordinate<20>(normal_),
                           hn::Set(d, mark.normal[0]), hn::Set(d, mark.normal[1]), hn::Set(d, mark.normal[2]));
        if (on_surface) squared = hn::Add(squared, detour(mark, x, y, z, turn));
        const auto same_side = hn::Ge(turn, hn::Set(d, opposite * unpacked_length * unpacked_length));
        const W rest = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(squared, inverse_squared_reach)));
        const W rest2 = hn::Mul(rest, rest);
        energy_ = hn::IfThenElse(same_side, hn::Add(energy_, hn::Mul(rest2, rest2)), energy_);
        clearance_ = hn::IfThenElse(same_side, hn::Min(clearance_, squared), clearance_);
    }
    // Normals are not of unit length.
    HWY_INLINE W detour(const OrderMark& mark, W x, W y, W z, W turn) const {
        const F d;
        const W here = dot(x, y, z, coordinate<0>(normal_), coordinate<10>(normal_), coordinate<20>(normal_));
        const W there =
            dot(x, y, z, hn::Set(d, mark.normal[0]), hn::Set(d, mark.normal[1]), hn::Set(d, mark.normal[2]));
        const W both = hn::Mul(hn::Set(d, -2.0F), hn::Mul(here, there));
        const W one = hn::Set(d, unpacked_length * unpacked_length);
        return hn::Max(hn::Zero(d), hn::Div(both, hn::Max(hn::Add(one, turn), hn::Mul(one, hn::Set(d, 0.1F)))));
    }
    HWY_INLINE void store() const {
        hn::Store(energy_, F(), group_.number[OrderGroup::energy] + at_);
        hn::Store(clearance_, F(), group_.number[OrderGroup::clearance] + at_);
    }
    HWY_INLINE W energy() const { return energy_; }
    HWY_INLINE W clearance() const { return clearance_; }

private:
    HWY_INLINE W load(OrderGroup::Column column) const { return hn::Load(F(), group_.number[column] + at_); }

    OrderGroup& group_;
    std::int64_t at_;
    W x_, y_, z_;
    hn::Vec<U> normal_;
    W energy_, clearance_;
};

// Some targets of Highway take the largest finite number for the smallest of infinite ones.
HWY_INLINE float infinite_beyond_most(float x) { return x < 3.4028234e38F ? x : __builtin_inff(); }

// The lowest of each lane, and where it was first.
class Search {
public:
    explicit Search(float enough)
        : enough_(hn::Set(F(), enough)), infinite_(hn::Set(F(), __builtin_inff())), least_(infinite_),
          least_of_all_(infinite_), at_(hn::Zero(I())) {}

    HWY_INLINE void look(W energy, W clearance, std::int64_t at) {
        least_of_all_ = hn::Min(least_of_all_, energy);
        const auto lower = hn::And(hn::Ge(clearance, enough_), hn::Lt(energy, least_));
        least_ = hn::IfThenElse(lower, energy, least_);
        at_ = hn::IfThenElse(hn::RebindMask(I(), lower), hn::Iota(I(), static_cast<std::int32_t>(at)), at_);
    }

    HWY_INLINE OrderLowest found() const {
        const F d;
        const W least = hn::MinOfLanes(d, least_);
        const float energy = infinite_beyond_most(hn::GetLane(least));
        const float of_all = infinite_beyond_most(hn::GetLane(hn::MinOfLanes(d, least_of_all_)));
        if (!(energy < __builtin_inff())) return {-1, energy, of_all};
        const auto best = hn::RebindMask(I(), hn::Eq(least_, least));
        const auto first = hn::MinOfLanes(I(), hn::IfThenElse(best, at_, hn::Set(I(), 0x7fffffff)));
        return {hn::GetLane(first), energy, of_all};
    }

private:
    W enough_, infinite_, least_, least_of_all_;
    hn::Vec<I> at_;
};

// Calls visit(group, at, number): lanes from `at` on, the first of which has that number in the block.
template <class Visit>
HWY_INLINE void for_lanes(const OrderBlock& block, Visit&& visit) {
    for (std::int64_t g = 0; g < block.groups; ++g)
        for (std::int64_t at = 0; at < OrderGroup::size; at += lanes())
            visit(block.group[g], at, g * OrderGroup::size + at);
}

template <bool on_surface>
void feel(const OrderBlock& block, const OrderMark* marks, std::int64_t count, float inverse_squared_reach) {
    const W inverse = hn::Set(F(), inverse_squared_reach);
    for_lanes(block, [&](OrderGroup& group, std::int64_t at, std::int64_t) HWY_ATTR {
        Lanes lanes(group, at);
        for (std::int64_t i = 0; i < count; ++i) lanes.template feel<on_surface>(marks[i], inverse);
        lanes.store();
    });
}

OrderLowest lowest(const OrderBlock& block, float enough) {
    const F d;
    Search search(enough);
    for_lanes(block, [&](const OrderGroup& group, std::int64_t at, std::int64_t number) HWY_ATTR {
        search.look(hn::Load(d, group.number[OrderGroup::energy] + at),
                    hn::Load(d, group.number[OrderGroup::clearance] + at), number);
    });
    return search.found();
}

template <bool on_surface>
OrderLowest feel_and_find(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach, float enough) {
    const W inverse = hn::Set(F(), inverse_squared_reach);
    Search search(enough);
    for_lanes(block, [&](OrderGroup& group, std::int64_t at, std::int64_t number) HWY_ATTR {
        Lanes lanes(group, at);
        lanes.template feel<on_surface>(mark, inverse);
        lanes.store();
        search.look(lanes.energy(), lanes.clearance(), number);
    });
    return search.found();
}

// The first `left` of a vector's numbers, infinity behind them.  Without masked loads a vector is read whole, and
// numbers behind may be another thread's, which is writing them: so the last ones are copied there.
HWY_INLINE W first_of(const float* numbers, std::int64_t left) {
    const F d;
    const W none = hn::Set(d, __builtin_inff());
    const auto mask = lanes_left(left);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    return hn::IfThenElse(mask, hn::MaskedLoad(mask, d, numbers), none);
#else
    if (left >= lanes()) return hn::LoadU(d, numbers);
    HWY_ALIGN float some[HWY_LANES(float)] = {};
    std::copy_n(numbers, left, some);
    return hn::IfThenElse(mask, hn::Load(d, some), none);
#endif
}

std::int64_t smallest(const float* numbers, std::int64_t count) {
    Search search(0.0F);
    for (std::int64_t at = 0; at < count; at += lanes())
        search.look(first_of(numbers + at, count - at), hn::Zero(F()), at);
    return search.found().at;
}

} // namespace

OrderLoops pick_loops() noexcept {
    return {feel<false>, lowest, feel_and_find<false>, smallest, feel<true>, feel_and_find<true>};
}

} // namespace hrbfnpr::stipples::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::stipples, OrderLoops, order_loops, pick_loops)

#if HWY_ONCE
namespace hrbfnpr::stipples {
namespace {

constexpr OrderGroup::Column all_columns[] = {OrderGroup::x,      OrderGroup::y,      OrderGroup::z,
                                              OrderGroup::normal, OrderGroup::energy, OrderGroup::clearance};

void free_place(const OrderBlock& block, std::int64_t i) noexcept {
    block.at(OrderGroup::energy, i) = __builtin_inff();
    block.at(OrderGroup::clearance, i) = -1.0F;
}

} // namespace

std::int64_t keep(const OrderBlock& block, float enough) noexcept {
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < block.groups * OrderGroup::size; ++i) {
        if (!(block.at(OrderGroup::clearance, i) >= enough)) continue;
        for (const OrderGroup::Column c : all_columns) std::swap(block.at(c, kept), block.at(c, i));
        ++kept;
    }
    for (std::int64_t i = kept; i < block.groups * OrderGroup::size; ++i) free_place(block, i);
    return kept;
}

void copy_place(const OrderBlock& from, std::int64_t i, const OrderBlock& to, std::int64_t k) noexcept {
    for (const OrderGroup::Column c : all_columns) to.at(c, k) = from.at(c, i);
}

void clear_rest(const OrderBlock& block, std::int64_t from) noexcept {
    for (; from % OrderGroup::size != 0; ++from)
        for (const OrderGroup::Column c : all_columns) block.at(c, from) = 0.0F;
}

void forget_marks(const OrderBlock& block, std::int64_t count) noexcept {
    for (std::int64_t i = 0; i < block.groups * OrderGroup::size; ++i) {
        block.at(OrderGroup::energy, i) = 0.0F;
        block.at(OrderGroup::clearance, i) = __builtin_inff();
        if (i >= count) free_place(block, i);
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
