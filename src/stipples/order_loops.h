// SPDX-License-Identifier: MIT
// The inner loops of the progressive order, on every instruction set: candidates feel marks, and the one at the lowest
// energy is found.
#pragma once

#include "base/assert.h"
#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::stipples {

// The candidates of a cell, sixteen at a time: each number of all of them in a line of the cache. Whole lines are read
// and written: part of one that was just written would have to wait for it.
struct alignas(64) OrderGroup {
    static constexpr std::int64_t size = 16;
    // x, y, z; the normal's bits (packed_normal); the energy, a sum of (1 - s / reach^2)^4 over the marks on the same
    // side at squared distance s; and the squared distance to the nearest of them. A free place has an infinite energy
    // and a clearance of -1.
    enum Column : std::int64_t { x, y, z, normal, energy, clearance, columns };

    float number[columns][size];
};

struct OrderBlock {
    OrderGroup* group;
    std::int64_t groups;

    [[nodiscard]] std::int64_t places() const noexcept { return OrderGroup::size * groups; }
    [[nodiscard]] float& at(std::int64_t column, std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(column >= 0 && column < OrderGroup::columns && i >= 0 && i < places());
        return group[i / OrderGroup::size].number[column][i % OrderGroup::size];
    }
};

[[nodiscard]] inline std::int64_t groups_for(std::int64_t candidates) noexcept {
    return (candidates + OrderGroup::size - 1) / OrderGroup::size;
}

struct OrderMark {
    float position[3];
    float normal; // packed
};

// Normals that turn by more than this cosine belong to opposite sides: over a crease marks still see each other,
// through a thin sheet they do not.
inline constexpr float opposite = -0.3F;

// Ten bits a coordinate: enough to tell sides apart, and for a tangent plane.
[[nodiscard]] float packed_normal(const float (&normal)[3]) noexcept;
// An unpacked normal has about this length.
inline constexpr float unpacked_length = 511.5F;
inline void unpack_normal(float packed, float (&normal)[3]) noexcept {
    const auto bits = __builtin_bit_cast(std::uint32_t, packed);
    for (unsigned c = 0; c < 3; ++c) normal[c] = static_cast<float>(bits >> (10U * c) & 1023U) - unpacked_length;
}

// A summary of a cell's energies; infinite where no candidate is open.
struct OrderLowest {
    std::int64_t at; // the first with the lowest energy, of those with clearance >= enough; -1: none is open
    float energy;    // its energy
    float of_all;    // the lowest energy, whatever the clearance
};

struct OrderLoops {
    using Feel = void (*)(const OrderBlock& block, const OrderMark* marks, std::int64_t count,
                          float inverse_squared_reach);
    using FeelAndFind = OrderLowest (*)(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach,
                                        float enough);

    // Candidates take note of marks, one after the other. The second function is for a surface that has creases: over a
    // crease, whose sheets have the normals m and n, the way o between two points is shorter than the one through both
    // tangent planes, the square of which is o . o - 2 (o . m) (o . n) / (1 + m . n).
    Feel feel[2];
    OrderLowest (*lowest)(const OrderBlock& block, float enough);
    // Both, of one mark.
    FeelAndFind feel_and_find[2];
    // The first of the smallest; -1 where all are infinite.
    std::int64_t (*smallest)(const float* numbers, std::int64_t count);
};

void copy_place(const OrderBlock& from, std::int64_t i, const OrderBlock& to, std::int64_t k) noexcept;
// No mark is felt: the first `count` places have no energy and all the clearance. The others are free, and hold numbers
// from which no NaN comes.
void forget_marks(const OrderBlock& block, std::int64_t count) noexcept;

[[nodiscard]] OrderLoops order_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::stipples
