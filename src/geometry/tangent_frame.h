// SPDX-License-Identifier: MIT
// Bases of the tangent plane that depend on the unit normal alone.                [NPAR 5.2, 5.3]
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::geometry {

// n, u and r are orthonormal.
struct TangentFrame {
    glm::dvec3 u;
    glm::dvec3 r;
};

[[nodiscard]] glm::dvec3 any_perpendicular(const glm::dvec3& n) noexcept;

// The stippling basis: r' = R n for a fixed rotation R, u = n x r', r = n x u. It is discontinuous only where n is
// along the axis of R; there u is any perpendicular.
[[nodiscard]] TangentFrame stipple_frame(const glm::dvec3& n) noexcept;

// The combing basis of Stark 2009: u is n crossed with the coordinate axis along which n has its smallest component in
// magnitude. It is smooth inside each of its regions of the sphere.
[[nodiscard]] TangentFrame combing_frame(const glm::dvec3& n) noexcept;
// Returns 0 at the borders of the combing regions, where the two smallest components of n are nearly equal in
// magnitude, and 1 away from them.
[[nodiscard]] double combing_confidence(const glm::dvec3& n) noexcept;

} // namespace hrbfnpr::geometry
