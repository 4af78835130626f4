// SPDX-License-Identifier: MIT
#include "paint/projection.h"

#include "base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::paint {

Projection::Projection(Pixels&& pixels, const Projector& projector)
    : pixels_(std::move(pixels)), projector_(projector) {
    HRBFNPR_ASSERT(pixels_.width > 0 && pixels_.height > 0 && projector.viewport.z > 0.0 && projector.viewport.w > 0.0);
}

Sample Projection::at(const Place& place) const noexcept {
    const glm::dvec4 window = projector_.to_window * glm::dvec4(place.position, 1.0);
    if (!(window.w > 0.0)) return {};
    const double x = (window.x / window.w - projector_.viewport.x) / projector_.viewport.z;
    const double y = (window.y / window.w - projector_.viewport.y) / projector_.viewport.w;
    if (!(x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0) || !is_seen(place)) return {};
    return between_pixels(x * static_cast<double>(pixels_.width), y * static_cast<double>(pixels_.height));
}

bool Projection::is_seen(const Place& place) const noexcept {
    const glm::dvec4& eye = projector_.eye;
    const glm::dvec3 to_eye = eye.w == 0.0 ? -glm::dvec3(eye) : glm::dvec3(eye) - place.position;
    if (!(glm::dot(to_eye, place.normal) > 0.0)) return false;
    if (projector_.occluders == nullptr) return true;
    const double end = eye.w == 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
    return !projector_.occluders->any_hit(place.position + projector_.offset * place.normal, to_eye, 0.0, end);
}

Sample Projection::between_pixels(double x, double y) const noexcept {
    // Places beyond the middles of the outermost pixels have the values of these.
    const double column = std::clamp(x - 0.5, 0.0, static_cast<double>(pixels_.width - 1));
    const double row = std::clamp(y - 0.5, 0.0, static_cast<double>(pixels_.height - 1));
    const auto left = static_cast<std::int64_t>(column), top = static_cast<std::int64_t>(row);
    const std::int64_t right = std::min(left + 1, pixels_.width - 1), bottom = std::min(top + 1, pixels_.height - 1);
    const double to_right = column - static_cast<double>(left), to_bottom = row - static_cast<double>(top);
    const std::array<const float*, 4> pixel = {pixels_.at(left, top), pixels_.at(right, top), pixels_.at(left, bottom),
                                               pixels_.at(right, bottom)};
    const std::array<double, 4> share = {(1.0 - to_right) * (1.0 - to_bottom), to_right * (1.0 - to_bottom),
                                         (1.0 - to_right) * to_bottom, to_right * to_bottom};
    Sample sample;
    const int components = pixels_.channels - 1;
    for (std::size_t i = 0; i < pixel.size(); ++i) {
        for (int c = 0; c < components; ++c) sample.value[c] += share[i] * static_cast<double>(pixel[i][c]);
        sample.weight += share[i] * static_cast<double>(pixel[i][components]);
    }
    if (!(sample.weight > 0.0)) return {};
    sample.value /= sample.weight;
    sample.weight = std::min(sample.weight, 1.0);
    return sample;
}

} // namespace hrbfnpr::paint
