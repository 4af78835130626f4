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
    return 1.0F + std::min(1.0F, (1.0F - facing) / scene_tuning.even_turn);
}

// Returns the place of a mark among those that may be shown, as a share of its place in the order on the surface.
[[nodiscard]] inline float flat_place(float facing) noexcept { return std::sqrt(facing) / surplus(facing); }

// Returns the distance in the picture that a place in the order stands for, as a share of this distance where the
// surface faces the eye.
[[nodiscard]] inline float own_distance(float facing) noexcept {
    return std::sqrt(std::sqrt(facing) * surplus(facing));
}

// Returns the largest facing / flat_place(facing) in a range. It is the largest share of the marks that may be shown,
// relative to the share where the surface faces the eye.
[[nodiscard]] inline float most_shown(float least, float most) noexcept {
    return std::sqrt(std::clamp(1.0F - scene_tuning.even_turn, least, most)) *
           surplus(std::clamp(1.0F - scene_tuning.even_turn, least, most));
}

} // namespace hrbfnpr::frame
