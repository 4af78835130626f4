// The inner loops of the progressive order, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::sampling {

// The candidates of a cell, column by column in one piece of memory, so that few pages are touched.
struct OrderBlock {
    float* data;
    std::int64_t stride; // from column to column
    std::int64_t count;

    static constexpr std::int64_t columns = 6;
    // x, y, z; the normal's bits (packed_normal); the energy, a sum of (1 - s / reach^2)^4 over the marks on the same
    // side at squared distance s; and the squared distance to the nearest of them.
    enum Column : std::int64_t { x, y, z, normal, energy, clearance };

    [[nodiscard]] float* column(std::int64_t c) const noexcept { return data + c * stride; }
};

struct OrderMark {
    float position[3];
    float normal[3];
};

// Normals that turn by more than this cosine belong to opposite sides: over a crease marks still see each other,
// through a thin sheet they do not.
inline constexpr float opposite = -0.3F;

// Ten bits a coordinate: enough to tell sides apart, and for a tangent plane.
[[nodiscard]] float packed_normal(const float (&normal)[3]) noexcept;
// Of about this length, not of unit length.
inline constexpr float unpacked_length = 511.5F;
void unpack_normal(float packed, float (&normal)[3]) noexcept;
[[nodiscard]] float repacked_normal(const float (&unpacked)[3]) noexcept;

// What the energies of a cell come to; infinite where there is no such candidate.
struct OrderLowest {
    std::int64_t at; // the first with the lowest energy, of those with clearance >= enough; -1: none
    float energy;    // its energy
    float of_all;    // the lowest energy, whatever the clearance
};

struct OrderLoops {
    // Candidates take note of a mark.
    void (*feel)(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach);
    OrderLowest (*lowest)(const OrderBlock& block, float enough);
    // Both, one after the other.
    OrderLowest (*feel_and_find)(const OrderBlock& block, const OrderMark& mark, float inverse_squared_reach,
                                 float enough);
    // Those with clearance >= enough move to the front, columns as far apart as they are many; returns that number.
    std::int64_t (*keep)(const OrderBlock& block, float enough);
    // The first of the smallest; -1: all are infinite.
    std::int64_t (*smallest)(const float* numbers, std::int64_t count);
};

[[nodiscard]] OrderLoops order_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::sampling
