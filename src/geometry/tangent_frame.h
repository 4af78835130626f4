// SPDX-License-Identifier: MIT
// Bases of the tangent plane from a unit normal alone.                [NPAR 5.2, 5.3]
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::geometry {

// n, u, r are orthonormal.
struct TangentFrame {
    glm::dvec3 u;
    glm::dvec3 r;
};

// Any unit vector perpendicular to n.
[[nodiscard]] glm::dvec3 any_perpendicular(const glm::dvec3& n) noexcept;

// The stippling basis: r' = R n for a fixed rotation R, u = n x r', r = n x u.
// Discontinuous only where n is along R's axis; any perpendicular there.
[[nodiscard]] TangentFrame stipple_frame(const glm::dvec3& n) noexcept;

// The combing basis of Stark 2009: n crossed with the coordinate axis along which its
// component is smallest in magnitude.  Smooth inside each of its regions of the sphere.
[[nodiscard]] TangentFrame combing_frame(const glm::dvec3& n) noexcept;
// 0 at the borders of that basis's regions, where the two smallest components of n are alike in magnitude; 1 away from
// them.
[[nodiscard]] double combing_trust(const glm::dvec3& n) noexcept;

} // namespace hrbfnpr::geometry
