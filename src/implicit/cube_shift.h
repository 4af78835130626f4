// SPDX-License-Identifier: MIT
// A polynomial in Chebyshev products on the cube [-1, 1]^3, as cube_basis.h has them, in those of one of its octants:
// along one axis after the other, as T_a((x + 1) / 2) and T_a((x - 1) / 2) are sums of T_0(x) ... T_a(x).
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

    // Terms of the octant's of a higher degree than `to`, which is at most `from`, are left out.
    CubeShift(int from, int to) noexcept;

    // Adds to the octant's terms.
    void add(const double* terms, int octant, double* to, Work& work) const noexcept;

private:
    int from_;
    int to_;
    // Of T_a((x + 1) / 2), in row a; for the lower half every other sign is the opposite.
    std::array<std::array<double, side>, side> upper_;
    std::array<std::array<double, side>, side> lower_;
};

} // namespace hrbfnpr::implicit
