// SPDX-License-Identifier: MIT
// Dabs of a brush. Each is a ball in which a value is pulled towards the value of the dab, one dab after the other:
//
//   v += w (value - v), where w = strength (1 - d^2 / radius^2)^2 at the distance d from the middle of the ball
//
// A dab has no effect where the surface faces away from its normal. This is affine in v: the dabs together give the
// value b / (1 - a) with the weight 1 - a, where a is the product of all 1 - w.
#pragma once

#include "base/memory.h"
#include "paint/kind.h"
#include "paint/sample.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::paint {

struct Dab {
    glm::dvec3 position;
    glm::dvec3 normal;
    double radius;
    double strength;
    glm::dvec3 value; // the value of a scalar dab is x
};

class Dabs {
public:
    // Dabs act in the order of the list. Their radii must be above 0, and all numbers finite. Directions have no sign:
    // a dab's direction that is opposite to those before is turned.
    Dabs(base::Memory& memory, FieldKind kind, std::span<const Dab> dabs);

    [[nodiscard]] Sample at(const Place& place) const noexcept;

private:
    struct CellDab {
        std::uint64_t cell;
        std::uint32_t dab;
    };
    // Returns the dabs that may reach a place, in their order.
    [[nodiscard]] std::span<const CellDab> near(const glm::dvec3& place) const noexcept;
    void list_dab(std::uint32_t number);

    FieldKind kind_;
    base::Array<Dab> dabs_;
    base::Array<CellDab> cells_; // sorted by cell, then by dab
    double cell_side_ = 1.0;
};

} // namespace hrbfnpr::paint
