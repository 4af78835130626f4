// SPDX-License-Identifier: MIT
// An unsteady hand: smooth noise along a line.
#pragma once

#include "frame/scene/style.h"

#include <cstdint>

namespace hrbfnpr::frame {

// Noise of the length along one line: uniform cubic B-splines of random numbers a third of `wobble_length` apart, so
// that it is twice smooth and bounded by these.  Round a closed line it goes a whole number of times.
class Wobble {
public:
    // Of a line by its number among its kind; `whole`: its length, pixels.
    Wobble(const LineStyle& style, std::int64_t line, double whole, bool closed) noexcept;

    // Pixels to the left, at a place along the line.
    [[nodiscard]] double aside(double at) const noexcept { return aside_ * noise(at, 0); }
    // Of the width.
    [[nodiscard]] double factor(double at) const noexcept { return 1.0 + width_ * noise(at, 1); }
    // Between places that a chord of the line may have, pixels.
    [[nodiscard]] double step() const noexcept;

private:
    [[nodiscard]] double noise(double at, std::size_t which) const noexcept;
    [[nodiscard]] double random(std::int64_t knot, std::size_t which) const noexcept;

    double aside_, width_;
    double between_;            // knots, pixels
    std::int64_t knots_ = 0;    // of a closed line, then they come again; 0: it is open
    std::uint64_t seed_, line_; // of its random numbers
};

} // namespace hrbfnpr::frame
