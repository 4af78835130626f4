// SPDX-License-Identifier: MIT
#include "features/contours.h"

#include <algorithm>

namespace hrbfnpr::curves {

glm::dvec4 eye_for(const LineSet& lines, const glm::dvec4& eye) noexcept {
    if (eye.w == 0.0) return eye;
    const glm::dvec3 place = glm::dvec3(eye) / eye.w;
    const geometry::Bounds& region = lines.mesh().region;
    const glm::dvec3 size = glm::abs(place); // The squares of these numbers may overflow.
    const double largest = std::max({size.x, size.y, size.z});
    const bool is_far = !(largest <= feature_tuning.parallel_distance * glm::distance(region.min, region.max));
    return is_far ? glm::dvec4(glm::normalize(0.5 * (region.min + region.max) / largest - place / largest), 0.0)
                  : glm::dvec4(place, 1.0);
}

} // namespace hrbfnpr::curves
