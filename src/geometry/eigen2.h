// The symmetric 2 x 2 eigenproblem [a b; b c].
#pragma once

#include <cmath>

namespace hrbfnpr::geometry {

// high >= low; (cosine, sine) is the unit eigenvector of `high`.
struct Eigen2 {
    double high;
    double low;
    double cosine;
    double sine;
};

// The difference of the eigenvalues is exact to rounding even where they nearly agree:
// it is never the difference of two large squares.
[[nodiscard]] inline Eigen2 symmetric_eigen2(double a, double b, double c) noexcept {
    const double mean = 0.5 * (a + c);
    const double half_difference = 0.5 * std::hypot(a - c, 2.0 * b);
    const double angle = 0.5 * std::atan2(2.0 * b, a - c);
    return {mean + half_difference, mean - half_difference, std::cos(angle), std::sin(angle)};
}

} // namespace hrbfnpr::geometry
