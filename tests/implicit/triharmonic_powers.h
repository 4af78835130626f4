// SPDX-License-Identifier: MIT
// Triharmonic polynomials, and the test that a basis reproduces them.
#pragma once

#include "geometry/vec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace test_triharmonic {

// |p|^2k Re (a . p)^l with a . a = 0. The (k + 1)-th power of the Laplacian of this function vanishes.
inline double power(const glm::dvec3& p, int l, int k, double angle) {
    const std::complex<double> q(p.x, p.y * std::cos(angle) + p.z * std::sin(angle));
    return std::pow(glm::dot(p, p), k) * std::pow(q, l).real();
}

// Expects that a basis reproduces the triharmonic polynomials up to its degree, and no others. `largest_error(f)`
// returns its largest error for the function f in the cube.
template <class LargestError>
void expect_reproduced(int degree, LargestError&& largest_error) {
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l + 2 * k <= degree; ++l)
            for (const double angle : {0.0, 0.7, 2.0}) {
                const double error = largest_error([&](const glm::dvec3& p) { return power(p, l, k, angle); });
                EXPECT_LT(error, 1e-12 * std::pow(3.0, 0.5 * l + k)) << degree << " " << l << " " << k;
            }
    const auto too_high = [&](const glm::dvec3& p) { return power(p, degree + 1, 0, 0.7); };
    EXPECT_GT(largest_error(too_high), 1e-3) << degree;
}

} // namespace test_triharmonic
