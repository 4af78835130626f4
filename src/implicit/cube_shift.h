// SPDX-License-Identifier: MIT
// Converts a polynomial in Chebyshev products on the cube [-1, 1]^3 (see cube_basis.h) to the Chebyshev products of one
// octant. It does so along one axis after the other, because T_a((x + 1) / 2) and T_a((x - 1) / 2) are sums of T_0(x)
// ... T_a(x).
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

    // Converts from the degree `from` to the degree `to`, which is at most `from`. Terms of higher degrees are left
    // out.
    CubeShift(int from, int to) noexcept;

    // Adds the converted terms to the octant's terms.
    void add(const double* terms, int octant, double* to, Work& work) const noexcept;

private:
    int from_;
    int to_;
    // Row a of upper_ has the coefficients of T_a((x + 1) / 2). In lower_, for T_a((x - 1) / 2), every other sign is
    // the opposite.
    std::array<std::array<double, side>, side> upper_;
    std::array<std::array<double, side>, side> lower_;
};

} // namespace hrbfnpr::implicit
