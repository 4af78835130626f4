// SPDX-License-Identifier: MIT
// Principal curvatures and directions, computed from gradient and Hessian. [NPAR 5.3; Kindlmann 2003]
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <array>
#include <cmath>

namespace hrbfnpr::surface {

// The eigenvalues of the symmetric 2 x 2 matrix [a b; b c], with high >= low, and the unit eigenvector (cosine, sine)
// of `high`.
struct Eigen2 {
    double high;
    double low;
    double cosine;
    double sine;
};

// The difference of the eigenvalues is accurate even if they are almost equal, because it is not computed as the
// difference of two large squares.
[[nodiscard]] inline Eigen2 symmetric_eigen2(double a, double b, double c) noexcept {
    const double mean = 0.5 * (a + c);
    const double half_difference = 0.5 * std::hypot(a - c, 2.0 * b);
    const double angle = 0.5 * std::atan2(2.0 * b, a - c);
    return {mean + half_difference, mean - half_difference, std::cos(angle), std::sin(angle)};
}

// hrbfnpr_model_curvature documents signs, order and confidence.
struct Curvature {
    double k1 = 0.0;
    double k2 = 0.0;
    double confidence = 0.0;
    glm::dvec3 d1{0.0};
    glm::dvec3 d2{0.0};
};

// `hessian` is in the order xx xy xz yy yz zz. A surface counts as flat if its curvature is small compared with 1 /
// `diagonal`.
[[nodiscard]] Curvature principal_curvature(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                                            double diagonal) noexcept;

// Computes the curvatures at all points on all threads. Resizes `result`.
void principal_curvatures(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
                          base::Array<Curvature>& result);

} // namespace hrbfnpr::surface
