// SPDX-License-Identifier: MIT
#include "surface/surrounded.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hrbfnpr::surface {
namespace {

// With more neighbours, samples on the other side of a hole of three spacings would count, too.
constexpr std::size_t neighbours_around = 12;
constexpr double same_way = 0.25; // Neighbours face the same way if the cosine between the normals is above this.
constexpr double widest_gap = 2.0 / 3.0 * std::numbers::pi;

} // namespace

bool is_surrounded(const geometry::VecArray& position, const geometry::VecArray& normal,
                   std::span<const std::int64_t> neighbours, std::int64_t i) noexcept {
    const glm::dvec3 u = geometry::any_perpendicular(normal[i]);
    const glm::dvec3 v = glm::cross(normal[i], u);
    std::array<double, neighbours_around> turn{};
    std::size_t count = 0;
    for (const std::int64_t j : neighbours.first(std::min(neighbours_around, neighbours.size()))) {
        if (glm::dot(normal[i], normal[j]) < same_way) continue;
        const glm::dvec3 way = position[j] - position[i];
        turn[count++] = std::atan2(glm::dot(way, v), glm::dot(way, u));
    }
    if (count < 3) return false;
    std::sort(turn.begin(), turn.begin() + count);
    double widest = turn[0] + 2.0 * std::numbers::pi - turn[count - 1];
    for (std::size_t k = 1; k < count; ++k) widest = std::max(widest, turn[k] - turn[k - 1]);
    return widest < widest_gap;
}

} // namespace hrbfnpr::surface
