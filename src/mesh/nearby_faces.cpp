// SPDX-License-Identifier: MIT
#include "mesh/nearby_faces.h"

namespace hrbfnpr::mesh {

FaceTree::Nearest NearbyFaces::nearest(const glm::dvec3& p, double limit) const noexcept {
    const FaceTree::Alone found = nearby_.nearest_alone(p, limit);
    if (found.face < 0) return all_.nearest(p, limit);
    // A face outside the cube may be nearer only if the cube does not contain all places at this distance.
    if (found.alone && std::sqrt(found.squared) <= room_at(p)) return found;
    constexpr double beyond = 1.0 + 1e-9; // more than the relative error of squared distances
    return all_.nearest(p, std::min(limit, beyond * found.squared));
}

} // namespace hrbfnpr::mesh
