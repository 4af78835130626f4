// SPDX-License-Identifier: MIT
// The polynomial term of [NPAR 4.1]: the monomials of total degree -1 (none) to 3, in the order
// 1; x y z; xx xy xz yy yz zz; xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
#pragma once

#include "geometry/vec.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::kernel {

inline constexpr std::int32_t polynomial_degree_max = 3;
inline constexpr int polynomial_size_max = 20;

// Returns the number of monomials, M = C(degree + 3, 3): 0, 1, 4, 10, 20.
[[nodiscard]] constexpr int polynomial_size(std::int32_t degree) noexcept {
    return degree < 0 ? 0 : (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

// Values and gradients at p of the first polynomial_size(degree) monomials.
struct PolynomialBasis {
    std::array<double, polynomial_size_max> value;
    std::array<glm::dvec3, polynomial_size_max> gradient;
};
void polynomial_basis(std::int32_t degree, const glm::dvec3& p, PolynomialBasis& basis) noexcept;

struct PolynomialField {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
    std::array<double, 6> hessian{}; // in the order xx xy xz yy yz zz
};

// Evaluates a polynomial at p. It has polynomial_size(degree) coefficients.
[[nodiscard]] PolynomialField polynomial(std::int32_t degree, const double* coefficients, const glm::dvec3& p) noexcept;

// Returns the third derivatives of a polynomial, which are the same everywhere, in the order xxx xxy xxz xyy xyz xzz
// yyy yyz yzz zzz.
[[nodiscard]] std::array<double, 10> polynomial_thirds(std::int32_t degree, const double* coefficients) noexcept;

} // namespace hrbfnpr::kernel
