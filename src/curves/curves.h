// SPDX-License-Identifier: MIT
// Curves on a surface as polylines that a cubic goes through.
#pragma once

#include "base/memory.h"
#include "curves/curve_points.h"

#include <cstdint>

namespace hrbfnpr::curves {

struct Curves {
    explicit Curves(base::Memory& memory) noexcept : first(memory), closed(memory), point(memory) {}

    base::Array<std::int64_t> first;  // of each curve's points, and the end of the last: one more than curves
    base::Array<std::uint8_t> closed; // 1: the first point follows the last, and stands there once
    base::Array<CurvePoint> point;    // in the order of CurvePoint::direction()

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return first.bytes() + closed.bytes() + point.bytes(); }
};

} // namespace hrbfnpr::curves
