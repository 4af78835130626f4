// SPDX-License-Identifier: MIT
// Where two places that move in the image meet.
#pragma once

#include "curves/view.h"

#include <utility>

namespace hrbfnpr::visibility {

[[nodiscard]] inline double cross2(const glm::dvec2& a, const glm::dvec2& b) noexcept { return a.x * b.y - a.y * b.x; }

// A place of a curve in the image, and how it moves as the curve goes on.
struct Moving {
    glm::dvec3 point;
    glm::dvec2 place, velocity; // pixels
};

[[nodiscard]] inline Moving moving(const curves::View& view, const glm::dvec3& point,
                                   const glm::dvec3& derivative) noexcept {
    const glm::dvec4 q = view.to_window * glm::dvec4(point, 1.0);
    const glm::dvec4 d = view.to_window * glm::dvec4(derivative, 0.0);
    const glm::dvec2 place(q.x / q.w, q.y / q.w);
    return {point, place, {(d.x - place.x * d.w) / q.w, (d.y - place.y * d.w) / q.w}};
}

// How far either has to go for the two to meet, as both go straight on.  Not finite where they run alike.
[[nodiscard]] inline std::pair<double, double> meeting(const Moving& p, const Moving& q) noexcept {
    const double area = cross2(p.velocity, q.velocity);
    const glm::dvec2 way = q.place - p.place;
    return {cross2(way, q.velocity) / area, cross2(way, p.velocity) / area};
}

} // namespace hrbfnpr::visibility
