// SPDX-License-Identifier: MIT
// Planes through what a depth camera saw around a pixel.
//
// A plane n . p = c, seen in the direction (u, v, 1), has 1 / z = n . (u, v, 1) / c: the inverse depth is linear in the
// picture.  So are its errors alike everywhere: cameras that triangulate measure a shift of patterns, which is 1 / z.
#pragma once

#include "base/memory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hrbfnpr::orient {

// Row by row; NaN where nothing was seen.
struct InverseDepth {
    explicit InverseDepth(base::Memory& memory) noexcept : value(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return std::int64_t{columns} * rows; }
    [[nodiscard]] double at(std::int32_t column, std::int32_t row) const noexcept {
        return value[std::int64_t{row} * columns + column];
    }

    base::Array<double> value;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
};

// value + slope . (pixels to the right, pixels down)
struct DepthPlane {
    double value = 0.0;
    double across = 0.0;
    double down = 0.0;
};

struct SmallPlane {
    DepthPlane plane;
    double error = 0.0; // standard deviation of what is seen off it
};

// Through the 5 x 5 pixels around one, if all of them were seen.
[[nodiscard]] std::optional<SmallPlane> small_plane(const InverseDepth& depth, std::int32_t column,
                                                    std::int32_t row) noexcept;

// Pixels of a disc around one, and how much each counts.
struct Tap {
    std::int32_t across = 0;
    std::int32_t down = 0;
    double weight = 0.0;
};

class Discs {
public:
    static constexpr std::int32_t least = 2;
    static constexpr std::int32_t most = 48;

    explicit Discs(base::Memory& memory);

    // Of a radius in pixels, from least to most.
    [[nodiscard]] std::span<const Tap> of(std::int32_t radius) const noexcept {
        const auto k = static_cast<std::size_t>(radius - least);
        return {taps_.data() + start_[k], static_cast<std::size_t>(start_[k + 1] - start_[k])};
    }

private:
    base::Array<Tap> taps_; // of all discs
    std::array<std::int64_t, most - least + 2> start_{};
};

// Through the pixels of a disc around one, from the first plane on, but for those that are 6.5 errors and more off it:
// what lies beyond an edge is.  None if there are few.
[[nodiscard]] std::optional<DepthPlane> plane_around(const InverseDepth& depth, std::int32_t column, std::int32_t row,
                                                     std::span<const Tap> disc, const SmallPlane& first) noexcept;

} // namespace hrbfnpr::orient
