// SPDX-License-Identifier: MIT
// The point of a segment that is nearest to a given point.
#pragma once

#include "geometry/vec.h"

#include <cmath>

namespace hrbfnpr::geometry {

// Returns the position of the nearest point along the segment, from 0 to 1. It is 0 if both ends coincide.
template <class V>
[[nodiscard]] typename V::value_type nearest_parameter(const V& place, const V& from, const V& to) noexcept {
    using T = typename V::value_type;
    const V way = to - from;
    const T square = glm::dot(way, way);
    return square > T(0) ? glm::clamp(glm::dot(place - from, way) / square, T(0), T(1)) : T(0);
}

template <class V>
[[nodiscard]] typename V::value_type squared_distance_to_segment(const V& place, const V& from, const V& to) noexcept {
    // Computing the difference first keeps numbers small.
    const V off = (place - from) - nearest_parameter(place, from, to) * (to - from);
    return glm::dot(off, off);
}

template <class V>
[[nodiscard]] typename V::value_type distance_to_segment(const V& place, const V& from, const V& to) noexcept {
    return std::sqrt(squared_distance_to_segment(place, from, to));
}

} // namespace hrbfnpr::geometry
