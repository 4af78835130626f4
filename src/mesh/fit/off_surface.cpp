// SPDX-License-Identifier: MIT
#include "mesh/fit/off_surface.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// The places of one look at the surface: each moves the surface around it, so that more at once are in vain.
constexpr std::int64_t most_at_once = 200;
constexpr double far_apart = 0.7; // of the distance from the mesh

} // namespace

std::int64_t OffSurface::add_from(const geometry::VecArray& place, const base::Array<double>& distance,
                                  double tolerance, std::int64_t most, const OuterFaces& faces) {
    base::Array<std::int64_t> order(distance.memory());
    for (std::int64_t i = 0; i < place.size(); ++i)
        if (distance[i] > 2.0 * tolerance) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        return distance[a] > distance[b] || (distance[a] == distance[b] && a < b);
    });
    std::int64_t added = 0;
    for (const std::int64_t i : order) {
        if (added >= std::min(most, most_at_once)) break;
        const glm::dvec3 p = place[i];
        bool covered = false;
        for (std::int64_t j = 0; j < count() && !covered; ++j)
            covered = glm::distance(position[j], p) < far_apart * distance[i];
        if (covered) continue;
        const Where side = where(faces.all(), p);
        if (side == Where::unsure) continue;
        const FaceTree::Nearest nearest = faces.tree().nearest(p);
        const double sign = side == Where::inside ? -1.0 : 1.0;
        const double length = std::sqrt(nearest.squared);
        position.push_back(p);
        normal.push_back(sign / length * (p - nearest.place));
        value.push_back(sign * length);
        ++added;
    }
    return added;
}

} // namespace hrbfnpr::mesh
