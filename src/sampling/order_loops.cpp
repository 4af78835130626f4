#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sampling/order_loops.cpp"
#include "base/simd.h"

#include "sampling/order_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::sampling::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
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

void feel(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach) {
    const F d;
    const W inverse = hn::Set(d, inverse_squared_reach);
    const float least_turn = opposite * unpacked_length * unpacked_length;
    for (std::int64_t at = 0; at < block.count; at += lanes()) {
        const auto mask = lanes_left(block.count - at);
        const auto load = [&](OrderBlock::Column c) { return hn::MaskedLoad(mask, d, block.column(c) + at); };
        const W x = hn::Sub(load(OrderBlock::x), hn::Set(d, mark.position[0]));
        const W y = hn::Sub(load(OrderBlock::y), hn::Set(d, mark.position[1]));
        const W z = hn::Sub(load(OrderBlock::z), hn::Set(d, mark.position[2]));
        const W squared = dot(x, y, z, x, y, z);
        const auto bits = hn::BitCast(U(), load(OrderBlock::normal));
        const W turn = dot(coordinate<0>(bits), coordinate<10>(bits), coordinate<20>(bits), hn::Set(d, mark.normal[0]),
                           hn::Set(d, mark.normal[1]), hn::Set(d, mark.normal[2]));
        const auto same_side = hn::And(mask, hn::Ge(turn, hn::Set(d, least_turn)));
        const W rest = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(squared, inverse)));
        const W rest2 = hn::Mul(rest, rest);
        const W energy = hn::Add(load(OrderBlock::energy), hn::Mul(rest2, rest2));
        const W clearance = hn::Min(load(OrderBlock::clearance), squared);
        hn::BlendedStore(energy, same_side, d, block.column(OrderBlock::energy) + at);
        hn::BlendedStore(clearance, same_side, d, block.column(OrderBlock::clearance) + at);
    }
}

std::int64_t lowest(const OrderBlock& block, float enough) {
    const F d;
    float least = 3.0e38F;
    std::int64_t found = -1;
    for (std::int64_t at = 0; at < block.count; at += lanes()) {
        const auto mask = lanes_left(block.count - at);
        const W energy = hn::MaskedLoad(mask, d, block.column(OrderBlock::energy) + at);
        const auto open = hn::Ge(hn::MaskedLoad(mask, d, block.column(OrderBlock::clearance) + at), hn::Set(d, enough));
        const auto lower = hn::And(hn::And(mask, open), hn::Lt(energy, hn::Set(d, least)));
        if (hn::AllFalse(d, lower)) continue;
        least = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(lower, energy, hn::Set(d, least))));
        found = at + hn::FindFirstTrue(d, hn::And(lower, hn::Eq(energy, hn::Set(d, least))));
    }
    return found;
}

} // namespace

OrderLoops pick_loops() noexcept { return {feel, lowest}; }

} // namespace hrbfnpr::sampling::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hrbfnpr::sampling {

OrderLoops order_loops(base::InstructionSet set) noexcept { return HRBFNPR_PICK(set, pick_loops)(); }

float packed_normal(const float (&normal)[3]) noexcept {
    std::uint32_t bits = 0;
    for (unsigned c = 0; c < 3; ++c)
        bits |= static_cast<std::uint32_t>((normal[c] < -1.0F  ? 0.0F
                                            : normal[c] > 1.0F ? 2.0F
                                                               : normal[c] + 1.0F) *
                                           511.5F)
                << (10U * c);
    return __builtin_bit_cast(float, bits);
}

void unpack_normal(float packed, float (&normal)[3]) noexcept {
    const auto bits = __builtin_bit_cast(std::uint32_t, packed);
    for (unsigned c = 0; c < 3; ++c) normal[c] = static_cast<float>(bits >> (10U * c) & 1023U) - 511.5F;
}

} // namespace hrbfnpr::sampling
#endif
