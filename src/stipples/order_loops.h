// SPDX-License-Identifier: MIT
// The inner loops of the progressive order, for every instruction set. They add the energy of marks to candidates, and
// find the candidate of the lowest energy.
#pragma once

#include "base/assert.h"
#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::stipples {

// Sixteen candidates of a cell. Each column is one cache line. Whole lines are read and written, because reading a part
// of a line just after writing it would stall.
struct alignas(64) OrderGroup {
    static constexpr std::int64_t size = 16;
    // x, y, z; the normal's bits (packed_normal); the energy, a sum of (1 - s / reach^2)^4 over the marks on the same
    // side at squared distance s; the clearance, the squared distance to the nearest of these marks. A place without a
    // candidate has an infinite energy and a clearance of -1.
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
    float normal; // packed by packed_normal()
};

// Two normals whose cosine is below this are on opposite sides. Marks affect each other across a crease, but not
// through a thin sheet.
inline constexpr float least_side_cosine = -0.3F;

// Packs a normal into ten bits per coordinate. This is enough to distinguish sides and to define a tangent plane.
[[nodiscard]] float packed_normal(const float (&normal)[3]) noexcept;
// The approximate length of an unpacked normal.
inline constexpr float unpacked_length = 511.5F;
inline void unpack_normal(float packed, float (&normal)[3]) noexcept {
    const auto bits = __builtin_bit_cast(std::uint32_t, packed);
    for (unsigned c = 0; c < 3; ++c) normal[c] = static_cast<float>(bits >> (10U * c) & 1023U) - unpacked_length;
}

// The lowest energies in a block of candidates.
struct LowestEnergy {
    // The index of the candidate with the lowest energy among those with at least the required clearance. Of several
    // such candidates, the first is taken. -1: no candidate.
    std::int64_t at;
    float energy;           // the energy of the candidate `at`; infinite if `at` is -1
    float at_any_clearance; // the lowest energy of all candidates, whatever their clearance
};

struct OrderLoops {
    using AddEnergy = void (*)(const OrderBlock& block, const OrderMark* marks, std::int64_t count,
                               float inverse_squared_reach);
    using AddEnergyAndFind = LowestEnergy (*)(const OrderBlock& block, const OrderMark& mark,
                                              float inverse_squared_reach, float least_clearance);

    // Two functions that add marks to the energies and clearances of candidates. The second is for a surface with
    // creases. Across a crease between sheets with normals m and n, the straight way o between two points is shorter
    // than the way through both tangent planes, whose square is o . o - 2 (o . m) (o . n) / (1 + m . n).
    AddEnergy add_energy[2];
    LowestEnergy (*lowest)(const OrderBlock& block, float least_clearance);
    // Two functions that add one mark, and find the lowest candidate in the same pass. The second is for a surface with
    // creases.
    AddEnergyAndFind add_energy_and_find[2];
    // Returns the index of the first smallest number, or -1 if all are infinite.
    std::int64_t (*index_of_smallest)(const float* numbers, std::int64_t count);
};

void copy_place(const OrderBlock& from, std::int64_t i, const OrderBlock& to, std::int64_t k) noexcept;
// Resets the first `count` places to zero energy and infinite clearance. The other places become free, with numbers
// that do not lead to NaN.
void forget_marks(const OrderBlock& block, std::int64_t count) noexcept;

[[nodiscard]] OrderLoops order_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::stipples
