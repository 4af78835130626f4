// SPDX-License-Identifier: MIT
// An unsteady hand that draws one line of hatching: how far the line strays, and how far it runs past the tone that it
// ends at.
#pragma once

#include "frame/scene/style.h"

#include <cstdint>

namespace hrbfnpr::frame {

// Smooth noise along a stroke, counted in its marks: it stays where it is on the surface from frame to frame.  Nearer,
// swings of half the length take over, so that they keep their length in the picture.
class HatchHand {
public:
    HatchHand() noexcept = default;
    // marks: of a closed stroke, after which it begins again; 0 of an open one.  step: from mark to mark, pixels.
    HatchHand(const LayerStyle& style, std::int64_t stroke, std::int64_t marks, float step) noexcept;

    [[nodiscard]] bool wobbles() const noexcept { return wobble_ > 0.0F; }
    [[nodiscard]] bool overshoots() const noexcept { return overshoot_ > 0.0F; }

    // Pixels to one side, at a place along the stroke.
    [[nodiscard]] float aside(double mark) const noexcept;
    // Pixels that a line goes on beyond its end there.
    [[nodiscard]] float beyond(double mark) const noexcept;

private:
    [[nodiscard]] double noise(double mark, double level, std::size_t which) const noexcept;
    [[nodiscard]] double octave(double mark, int level, std::size_t which) const noexcept;
    [[nodiscard]] double random(std::int64_t knot, int level, std::size_t which) const noexcept;

    float wobble_ = 0.0F, overshoot_ = 0.0F;      // pixels
    double wobble_level_ = 0.0, end_level_ = 0.0; // a swing has two to the power of it marks
    std::uint64_t seed_ = 0, stroke_ = 0;
    std::int64_t around_ = 0; // marks of a closed stroke
};

} // namespace hrbfnpr::frame
