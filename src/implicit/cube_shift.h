// SPDX-License-Identifier: MIT
// Converts a polynomial in Chebyshev products on the cube [-1, 1]^3 (see cube_basis.h) to the Chebyshev products of one
// octant of the cube. It converts one axis after another: T_a((x + 1) / 2) and T_a((x - 1) / 2) are sums of the
// polynomials T_0(x) to T_a(x).
#pragma once

#include "implicit/cube_basis.h"

#include <array>

namespace hrbfnpr::implicit {

class CubeShift {
public:
    static constexpr std::size_t side = CubeBasis::degree_max + 1;
    struct Work {
        std::array<double, side * side * side> z, y;
    };

    // Converts from the degree `from` to the degree `to`, which is not higher. Terms above the degree `to` are omitted.
    CubeShift(int from, int to) noexcept;

    // Adds the converted terms to the terms of the octant.
    void add(const double* terms, int octant, double* to, Work& work) const noexcept;

private:
    int from_;
    int to_;
    // Row a of upper_ holds the coefficients of T_a((x + 1) / 2). Row a of lower_ holds those of T_a((x - 1) / 2),
    // which differ only in every other sign.
    std::array<std::array<double, side>, side> upper_;
    std::array<std::array<double, side>, side> lower_;
};

} // namespace hrbfnpr::implicit
