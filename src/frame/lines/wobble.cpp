// SPDX-License-Identifier: MIT
#include "frame/lines/wobble.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr double knots_a_swing = 3.0;
constexpr double fewest_knots = 4.0; // of a closed line
constexpr double steps_a_knot = 4.0;
constexpr double shortest_step = 0.5;  // pixels
constexpr double farthest_knot = 1e15; // knots: a line that passes beside the eye is as long as numbers go

} // namespace

Wobble::Wobble(const LineStyle& style, std::int64_t line, double whole, bool closed) noexcept
    : aside_(static_cast<double>(style.wobble) * static_cast<double>(style.width)),
      width_(static_cast<double>(style.wobble_width)),
      between_(static_cast<double>(style.wobble_length) * static_cast<double>(style.width) / knots_a_swing),
      seed_(style.wobble_seed | std::uint64_t{static_cast<std::uint32_t>(style.kind)} << 32U),
      line_(static_cast<std::uint64_t>(line)) {
    if (!closed || !(whole > 0.0)) return;
    const double knots = std::max(fewest_knots, std::round(whole / between_));
    between_ = whole / knots;
    knots_ = static_cast<std::int64_t>(knots);
}

double Wobble::step() const noexcept { return std::max(shortest_step, between_ / steps_a_knot); }

// In [-1, 1].
double Wobble::random(std::int64_t knot, std::size_t which) const noexcept {
    if (knots_ > 0) knot = (knot % knots_ + knots_) % knots_;
    const std::uint64_t index = line_ << 32U | static_cast<std::uint32_t>(knot);
    return 2.0 * base::uniform4(seed_, index, base::Purpose::wobble)[which] - 1.0;
}

double Wobble::noise(double at, std::size_t which) const noexcept {
    const double place = std::clamp(at / between_, -farthest_knot, farthest_knot);
    const double knot = std::floor(place);
    const double u = place - knot;
    const double v = 1.0 - u;
    const auto first = static_cast<std::int64_t>(knot);
    const double weights[4] = {v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u};
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += weights[k] * random(first - 1 + k, which);
    return sum / 6.0;
}

} // namespace hrbfnpr::frame
