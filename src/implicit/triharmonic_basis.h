// SPDX-License-Identifier: MIT
// The triharmonic polynomials up to a degree: all u with Laplace^3 u = 0. Away from s they approximate |x - s|^3 and
// its derivatives about as well as all polynomials do, of which there are twice as many (measured: 1.3 times the error,
// degrees 8 to 14).
//
// By Almansi's theorem they are h T_k(2 |x|^2 / 3 - 1), k = 0, 1, 2, with solid harmonics h.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::implicit {

// Returns the number of triharmonic polynomials: (degree + 1)^2 + (degree - 1)^2 + (degree - 3)^2, without terms for
// degrees below 0.
[[nodiscard]] constexpr int triharmonic_size(int degree) noexcept {
    int size = 0;
    for (int rest = degree, k = 0; k < 3 && rest >= 0; ++k, rest -= 2) size += (rest + 1) * (rest + 1);
    return size;
}

// Returns the values at the first `count` points: a column of `stride` numbers for each polynomial, in ascending order
// of degrees.
[[nodiscard]] base::Array<double> triharmonic_values(const geometry::VecArray& points, std::int64_t count, int degree,
                                                     std::int64_t stride, const base::Progress& progress = {});

// Returns coefficients of the terms of CubeBasis, in columns of the same order.
[[nodiscard]] base::Array<double> triharmonic_coefficients(base::Memory& memory, int degree, std::int64_t stride,
                                                           const base::Progress& progress = {});

} // namespace hrbfnpr::implicit
