// SPDX-License-Identifier: MIT
// How many more stipples may be shown where they are spread evenly in the picture, because others will be left out.
// `facing` is |n . v|.
#pragma once

#include "frame/scene/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

// Returns how many times as many marks may be shown as the tone wants. Where the surface faces the eye, this is 1.
[[nodiscard]] inline float surplus(float facing) noexcept {
    return 1.0F + scene_tuning.even_surplus * std::min(1.0F, (1.0F - facing) / scene_tuning.even_turn);
}

// Returns the place of a mark among those that may be shown, as a share of its place in the order on the surface.
[[nodiscard]] inline float flat_place(float facing) noexcept { return std::sqrt(std::sqrt(facing)) / surplus(facing); }

// Returns the distance in the picture that a place in the order stands for, as a share of this distance where the
// surface faces the eye.
[[nodiscard]] inline float own_distance(float facing) noexcept {
    return facing > 0.0F ? std::sqrt(facing / flat_place(facing)) : 0.0F;
}

// Returns the largest facing / flat_place(facing) in a range. It is the largest share of the marks that may be shown,
// relative to the share where the surface faces the eye.
[[nodiscard]] inline float most_shown(float least, float most) noexcept {
    // facing^(3/4) (1 + ratio (1 - facing)) is largest here, and surplus() is smaller below 1 - even_turn.
    constexpr float ratio = scene_tuning.even_surplus / scene_tuning.even_turn;
    constexpr float peak = std::max(1.0F - scene_tuning.even_turn, 3.0F * (1.0F + ratio) / (7.0F * ratio));
    const float own = own_distance(std::clamp(peak, least, most));
    return own * own;
}

} // namespace hrbfnpr::frame
