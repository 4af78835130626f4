// SPDX-License-Identifier: MIT
#include "frame/hatch/hand.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr double knots_a_swing = 3.0;
constexpr double fewest_knots = 4.0; // of a closed stroke
// Powers of two that a swing may be long, in marks.
constexpr double least_level = -8.0;
constexpr double most_level = 24.0;
// How long one swing of the noise is: of `wobble_swing` in pens, of `end_swing` in the longest length by which a line
// runs past its end.
constexpr float wobble_swing = 60.0F;
constexpr float end_swing = 4.0F;

[[nodiscard]] double level_of(float swing, float step) noexcept {
    const double marks = static_cast<double>(swing) / static_cast<double>(step);
    return marks > 0.0 ? std::clamp(std::log2(marks), least_level, most_level) : least_level;
}

} // namespace

HatchHand::HatchHand(const LayerStyle& style, std::int64_t stroke, std::int64_t marks, float step) noexcept
    : wobble_(style.hatch_wobble * style.hatch_pen), overshoot_(style.hatch_overshoot),
      wobble_level_(level_of(wobble_swing * style.hatch_pen, step)), end_level_(level_of(end_swing * overshoot_, step)),
      seed_(style.hatch_seed), stroke_(static_cast<std::uint64_t>(stroke)), around_(marks) {}

float HatchHand::aside(double mark) const noexcept {
    return wobble_ * static_cast<float>(noise(mark, wobble_level_, 0));
}

float HatchHand::beyond(double mark) const noexcept {
    return overshoot_ * static_cast<float>(std::clamp(0.5 + noise(mark, end_level_, 1), 0.0, 1.0));
}

// In [-1, 1].
double HatchHand::noise(double mark, double wanted, std::size_t which) const noexcept {
    const double level = std::floor(wanted);
    const double share = wanted - level;
    const auto number = static_cast<int>(level);
    return (1.0 - share) * octave(mark, number, which) + share * octave(mark, number + 1, which);
}

// A uniform cubic B-spline of random numbers.  Round a closed stroke it goes a whole number of times.
double HatchHand::octave(double mark, int level, std::size_t which) const noexcept {
    double between = std::ldexp(1.0, level) / knots_a_swing;
    std::int64_t knots = 0;
    if (around_ > 0) {
        const double count = std::max(fewest_knots, std::round(static_cast<double>(around_) / between));
        between = static_cast<double>(around_) / count;
        knots = static_cast<std::int64_t>(count);
    }
    const double place = mark / between;
    const double first = std::floor(place);
    const double u = place - first;
    const double v = 1.0 - u;
    const double weights[4] = {v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u};
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        std::int64_t knot = static_cast<std::int64_t>(first) - 1 + k;
        if (knots > 0) knot = (knot % knots + knots) % knots;
        sum += weights[k] * random(knot, level, which);
    }
    return sum / 6.0;
}

double HatchHand::random(std::int64_t knot, int level, std::size_t which) const noexcept {
    const std::uint64_t index = stroke_ << 32U | static_cast<std::uint32_t>(knot);
    const std::uint64_t seed = seed_ | static_cast<std::uint64_t>(level + 64) << 32U;
    return 2.0 * base::uniform4(seed, index, base::Purpose::hatch_hand)[which] - 1.0;
}

} // namespace hrbfnpr::frame
