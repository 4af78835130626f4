// SPDX-License-Identifier: MIT
#include "frame/hatch/hand.h"

#include "base/assert.h"
#include "base/random.h"
#include "frame/hatch/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

double noise_level(float length, float step) noexcept {
    constexpr double least = -8.0;
    const double marks = static_cast<double>(length) / static_cast<double>(step);
    return marks > 0.0 ? std::clamp(std::log2(marks), least, 24.0) : least;
}

StrokeNoise::Interval StrokeNoise::interval_at(double mark, int level, For purpose) const noexcept {
    Interval found;
    found.level = level;
    found.between = std::ldexp(1.0, level) / hatch_tuning.knots_of_swing;
    std::int64_t knots = 0;
    if (around_ > 0) {
        const auto marks = static_cast<double>(around_);
        const double count = std::max(hatch_tuning.fewest_knots, std::round(marks / found.between));
        found.between = marks / count;
        knots = static_cast<std::int64_t>(count);
    }
    found.first = std::floor(mark / found.between);
    const std::uint64_t seed = seed_ | static_cast<std::uint64_t>(level + 64) << 32U;
    for (std::size_t k = 0; k < found.number.size(); ++k) {
        std::int64_t knot = static_cast<std::int64_t>(found.first) - 1 + static_cast<std::int64_t>(k);
        if (knots > 0) knot = (knot % knots + knots) % knots;
        const std::uint64_t index = stroke_ << 32U | static_cast<std::uint32_t>(knot);
        const auto numbers = base::uniform4(seed, index, base::Purpose::hatch_hand);
        found.number[k] = 2.0 * numbers[static_cast<std::size_t>(purpose)] - 1.0;
    }
    return found;
}

double StrokeNoise::octave(double mark, int level, For purpose) noexcept {
    Interval& own = last_[static_cast<std::size_t>(purpose)][static_cast<std::size_t>(level & 1)];
    double u = own.between > 0.0 && own.level == level ? mark / own.between - own.first : -1.0;
    if (!(u >= 0.0 && u < 1.0)) {
        own = interval_at(mark, level, purpose);
        u = mark / own.between - own.first;
    }
    const double v = 1.0 - u;
    const double weights[4] = {v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u};
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * own.number[k];
    return sum / 6.0;
}

double StrokeNoise::at(double mark, double wanted, For purpose) noexcept {
    const double level = std::floor(wanted);
    const double share = wanted - level;
    return (1.0 - share) * octave(mark, static_cast<int>(level), purpose) +
           share * octave(mark, static_cast<int>(level) + 1, purpose);
}

HatchHand::HatchHand(const LayerStyle& style, float step) noexcept
    : wobble(style.hatch_wobble * style.hatch_pen), overshoot(style.hatch_overshoot),
      wobble_level(noise_level(hatch_tuning.wobble_swing * style.hatch_pen, step)),
      end_level(noise_level(hatch_tuning.end_swing * style.hatch_overshoot, step)) {}

HatchLights::HatchLights(const LayerStyle& style) noexcept
    : begin_(style.hatch_tone_begin), below_(style.hatch_lights()), above_(0.0F) {
    const float rise = style.hatch_coverage_end - style.hatch_coverage_begin;
    const float span = style.hatch_tone_end - style.hatch_tone_begin;
    if (!(below_ > 0.0F && rise > 0.0F)) return;
    // Above hatch_tone_begin, the coverage rises with this power of the darkness (loops.cpp).
    constexpr float exponent = 1.1F;
    above_ = span * std::pow(std::min(style.hatch_coverage_begin / rise, 1.0F), 1.0F / exponent);
}

// In units of the coverage at hatch_tone_begin, the largest change is as large as the coverage up to 1, and falls to 0
// at 2. On either side of 1, the coverage counts as linear.
float HatchLights::changed(float darkness, float share) const noexcept {
    HRBFNPR_ASSERT(hold(darkness));
    const float coverage = 1.0F + (darkness - begin_) / (darkness < begin_ ? below_ : above_);
    const float wanted = coverage + share * std::min(coverage, 2.0F - coverage);
    return begin_ + (wanted - 1.0F) * (wanted < 1.0F ? below_ : above_);
}

float HatchLights::darkest(float darkness) const noexcept {
    return hold(darkness) ? changed(darkness, hatch_tuning.break_range) : darkness;
}

void vary_lights(const HatchLights& lights, StrokeNoise& noise, std::int64_t first, int coarsest,
                 std::span<const float> level, std::span<float> darkness) noexcept {
    HRBFNPR_ASSERT(level.size() == darkness.size());
    for (std::size_t i = 0; i < darkness.size(); ++i) {
        if (!lights.hold(darkness[i])) continue;
        const double mark = static_cast<double>(first + static_cast<std::int64_t>(i));
        const double own = noise.octave(mark, coarsest - static_cast<int>(level[i]), StrokeNoise::For::lights);
        darkness[i] = lights.changed(darkness[i], hatch_tuning.break_range * static_cast<float>(own));
    }
}

} // namespace hrbfnpr::frame
