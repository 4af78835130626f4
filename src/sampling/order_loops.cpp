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

// How a mark changes candidates.
class Felt {
public:
    Felt(const OrderMark& mark, float inverse_squared_reach) : mark_(mark), inverse_(inverse_squared_reach) {}

    // Those of `mask` from `at` on.
    HWY_INLINE void change(const OrderBlock& block, std::int64_t at, hn::Mask<F> mask, W& energy, W& clearance) const {
        const F d;
        const auto load = [&](OrderBlock::Column c) { return hn::MaskedLoad(mask, d, block.column(c) + at); };
        const W x = hn::Sub(load(OrderBlock::x), hn::Set(d, mark_.position[0]));
        const W y = hn::Sub(load(OrderBlock::y), hn::Set(d, mark_.position[1]));
        const W z = hn::Sub(load(OrderBlock::z), hn::Set(d, mark_.position[2]));
        const W squared = dot(x, y, z, x, y, z);
        const auto bits = hn::BitCast(U(), load(OrderBlock::normal));
        const W turn = dot(coordinate<0>(bits), coordinate<10>(bits), coordinate<20>(bits), hn::Set(d, mark_.normal[0]),
                           hn::Set(d, mark_.normal[1]), hn::Set(d, mark_.normal[2]));
        const auto same_side = hn::Ge(turn, hn::Set(d, opposite * unpacked_length * unpacked_length));
        const W rest = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0F), hn::Mul(squared, hn::Set(d, inverse_))));
        const W rest2 = hn::Mul(rest, rest);
        energy = hn::IfThenElse(same_side, hn::Add(energy, hn::Mul(rest2, rest2)), energy);
        clearance = hn::IfThenElse(same_side, hn::Min(clearance, squared), clearance);
        hn::BlendedStore(energy, mask, d, block.column(OrderBlock::energy) + at);
        hn::BlendedStore(clearance, mask, d, block.column(OrderBlock::clearance) + at);
    }

private:
    const OrderMark& mark_;
    float inverse_;
};

// The lowest of each lane, and where it was first.
class Search {
public:
    explicit Search(float enough)
        : enough_(hn::Set(F(), enough)), infinite_(hn::Set(F(), __builtin_inff())), least_(infinite_),
          least_of_all_(infinite_), at_(hn::Zero(I())) {}

    HWY_INLINE void look(W energy, W clearance, std::int64_t at, hn::Mask<F> mask) {
        const W here = hn::IfThenElse(mask, energy, infinite_);
        least_of_all_ = hn::Min(least_of_all_, here);
        const auto lower = hn::And(hn::Ge(clearance, enough_), hn::Lt(here, least_));
        least_ = hn::IfThenElse(lower, here, least_);
        at_ = hn::IfThenElse(hn::RebindMask(I(), lower), hn::Iota(I(), static_cast<std::int32_t>(at)), at_);
    }

    HWY_INLINE OrderLowest found() const {
        const F d;
        const float of_all = hn::GetLane(hn::MinOfLanes(d, least_of_all_));
        const W least = hn::MinOfLanes(d, least_);
        const float energy = hn::GetLane(least);
        if (!(energy < __builtin_inff())) return {-1, energy, of_all};
        const auto best = hn::RebindMask(I(), hn::Eq(least_, least));
        const auto first = hn::MinOfLanes(I(), hn::IfThenElse(best, at_, hn::Set(I(), 0x7fffffff)));
        return {hn::GetLane(first), energy, of_all};
    }

private:
    W enough_, infinite_, least_, least_of_all_;
    hn::Vec<I> at_;
};

// Calls look(at, mask, energy, clearance) for all candidates.
template <class Look>
HWY_INLINE void for_candidates(const OrderBlock& block, Look&& look) {
    const F d;
    for (std::int64_t at = 0; at < block.count; at += lanes()) {
        const auto mask = lanes_left(block.count - at);
        look(at, mask, hn::MaskedLoad(mask, d, block.column(OrderBlock::energy) + at),
             hn::MaskedLoad(mask, d, block.column(OrderBlock::clearance) + at));
    }
}

void feel(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach) {
    const Felt felt(mark, inverse_squared_reach);
    for_candidates(block, [&](std::int64_t at, hn::Mask<F> mask, W energy, W clearance)
                              HWY_ATTR { felt.change(block, at, mask, energy, clearance); });
}

OrderLowest lowest(const OrderBlock& block, float enough) {
    Search search(enough);
    for_candidates(block, [&](std::int64_t at, hn::Mask<F> mask, W energy, W clearance)
                              HWY_ATTR { search.look(energy, clearance, at, mask); });
    return search.found();
}

OrderLowest feel_and_find(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach, float enough) {
    const Felt felt(mark, inverse_squared_reach);
    Search search(enough);
    for_candidates(block, [&](std::int64_t at, hn::Mask<F> mask, W energy, W clearance) HWY_ATTR {
        felt.change(block, at, mask, energy, clearance);
        search.look(energy, clearance, at, mask);
    });
    return search.found();
}

std::int64_t keep(const OrderBlock& block, float enough) {
    const F d;
    // The last column moves last: it says which stay.
    const auto stays = [&](std::int64_t at) HWY_ATTR {
        const W clearance = hn::MaskedLoad(lanes_left(block.count - at), d, block.column(OrderBlock::clearance) + at);
        return hn::And(lanes_left(block.count - at), hn::Ge(clearance, hn::Set(d, enough)));
    };
    std::int64_t kept = 0;
    for (std::int64_t at = 0; at < block.count; at += lanes())
        kept += static_cast<std::int64_t>(hn::CountTrue(d, stays(at)));
    if (kept == block.count && block.stride == kept) return kept;
    float* to = block.data;
    for (std::int64_t c = 0; c < OrderBlock::columns; ++c)
        for (std::int64_t at = 0; at < block.count; at += lanes()) {
            const auto mask = stays(at);
            const W column = hn::MaskedLoad(lanes_left(block.count - at), d, block.column(c) + at);
            to += hn::CompressBlendedStore(column, mask, d, to);
        }
    return kept;
}

std::int64_t smallest(const float* numbers, std::int64_t count) {
    const F d;
    Search search(0.0F);
    for (std::int64_t at = 0; at < count; at += lanes()) {
        const auto mask = lanes_left(count - at);
        search.look(hn::MaskedLoad(mask, d, numbers + at), hn::Zero(d), at, mask);
    }
    return search.found().at;
}

} // namespace

OrderLoops pick_loops() noexcept { return {feel, lowest, feel_and_find, keep, smallest}; }

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

float repacked_normal(const float (&unpacked)[3]) noexcept {
    std::uint32_t bits = 0;
    for (unsigned c = 0; c < 3; ++c) bits |= static_cast<std::uint32_t>(unpacked[c] + 511.5F) << (10U * c);
    return __builtin_bit_cast(float, bits);
}

} // namespace hrbfnpr::sampling
#endif
