// SPDX-License-Identifier: MIT
// The triharmonic polynomials up to a degree: all polynomials u with Laplace^3 u = 0. They approximate |x - s|^3 and
// its derivatives away from s about as well as all polynomials of the degree, with half as many terms (measured: 1.3
// times the error, degrees 8 to 14).
//
// By Almansi's theorem they are h T_k(2 |x|^2 / 3 - 1) with k = 0, 1, 2 and solid harmonics h.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::implicit {

// Returns the number of triharmonic polynomials: (degree + 1)^2 + (degree - 1)^2 + (degree - 3)^2, where squares of
// negative numbers are omitted.
[[nodiscard]] constexpr int triharmonic_size(int degree) noexcept {
    int size = 0;
    for (int rest = degree, k = 0; k < 3 && rest >= 0; ++k, rest -= 2) size += (rest + 1) * (rest + 1);
    return size;
}

// Returns the values at the first `count` points: a column of `stride` numbers for each polynomial. Columns are sorted
// by degree.
[[nodiscard]] base::Array<double> triharmonic_values(const geometry::VecArray& points, std::int64_t count, int degree,
                                                     std::int64_t stride, const base::Progress& progress = {});

// Returns the coefficients of the CubeBasis terms, with the columns in the same order.
[[nodiscard]] base::Array<double> triharmonic_coefficients(base::Memory& memory, int degree, std::int64_t stride,
                                                           const base::Progress& progress = {});

} // namespace hrbfnpr::implicit
