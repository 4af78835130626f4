// SPDX-License-Identifier: MIT
#include "stipples/void_centre.h"

#include "base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::stipples {
namespace {

constexpr int most_vertices = 6;
constexpr std::size_t none = static_cast<std::size_t>(-1);

double squared(const glm::dvec2& v) noexcept { return glm::dot(v, v); }

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) noexcept {
    const glm::dvec2 u = b - a;
    const glm::dvec2 v = c - a;
    return u.x * v.y - u.y * v.x;
}

// The unit direction from p along which the distances to the nearest points a and b, or to a alone, grow and stay
// equal.
glm::dvec2 uphill(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2* b) noexcept {
    if (b == nullptr) {
        const double length = glm::length(p - a);
        return length > 0.0 ? (p - a) / length : glm::dvec2(1.0, 0.0);
    }
    const glm::dvec2 across = glm::normalize(glm::dvec2(a.y - b->y, b->x - a.x));
    return glm::dot(across, p - 0.5 * (a + *b)) < 0.0 ? -across : across;
}

} // namespace

glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept {
    HRBFNPR_ASSERT(wanted > 0.0 && farthest >= 0.0);
    if (around.empty()) return glm::dvec2(0.0);
    glm::dvec2 at{0.0};
    const auto nearest = std::min_element(
        around.begin(), around.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return squared(a) < squared(b); });
    std::array<std::size_t, 2> edge{static_cast<std::size_t>(nearest - around.begin()), none};
    for (int vertex = 0; vertex < most_vertices; ++vertex) {
        const glm::dvec2 a = around[edge[0]];
        const glm::dvec2 direction = uphill(at, a, edge[1] == none ? nullptr : &around[edge[1]]);
        // How far to where the nearest point is `wanted` away: |at + t d - a| = wanted.
        const double along = glm::dot(at - a, direction);
        const double own = squared(at - a);
        const double missing = wanted * wanted - own;
        const double enough = missing > 0.0 ? std::sqrt(along * along + missing) - along : 0.0;
        // The next point that comes to be as near: |at + t d - q| = |at + t d - a|.
        double distance = 2.0 * farthest;
        std::size_t third = none;
        for (std::size_t i = 0; i < around.size(); ++i) {
            if (i == edge[0] || i == edge[1]) continue;
            const double approach = 2.0 * glm::dot(direction, around[i] - a);
            if (!(approach > 1e-12 * wanted)) continue;
            const double there = std::max(0.0, (squared(at - around[i]) - own) / approach);
            if (there < distance) {
                distance = there;
                third = i;
            }
        }
        at += std::min(enough, distance) * direction;
        if (enough <= distance || third == none) break;
        if (edge[1] == none) {
            edge[1] = third;
            continue;
        }
        // At equal distances from three points: a maximum if they surround it, else on along the edge that it is
        // beyond.
        const glm::dvec2 b = around[edge[1]];
        const glm::dvec2 c = around[third];
        const double all = turn(a, b, c);
        if (turn(b, c, at) * all < 0.0)
            edge = {edge[1], third};
        else if (turn(c, a, at) * all < 0.0)
            edge[1] = third;
        else
            break;
    }
    return squared(at) <= farthest * farthest ? at : glm::dvec2(0.0);
}

} // namespace hrbfnpr::stipples
