// SPDX-License-Identifier: MIT
#include "implicit/cube_shift.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

constexpr std::size_t side = CubeShift::side;

[[nodiscard]] constexpr std::size_t place(std::size_t a, std::size_t b, std::size_t c) noexcept {
    return (a * side + b) * side + c;
}

} // namespace

// Uses T_(a+1)(y) = 2 y T_a(y) - T_(a-1)(y) with y = (x + 1) / 2, and 2 x T_k(x) = T_(k+1)(x) + T_(k-1)(x).
CubeShift::CubeShift(int from, int to) noexcept : from_(from), to_(to), upper_{}, lower_{} {
    upper_[0][0] = 1.0;
    upper_[1][0] = upper_[1][1] = 0.5;
    for (std::size_t a = 1; a + 1 < side; ++a)
        for (std::size_t k = 0; k <= a + 1; ++k) {
            const double below = k == 0 ? 0.0 : (k == 1 ? 2.0 : 1.0) * upper_[a][k - 1];
            const double above = k < a ? upper_[a][k + 1] : 0.0;
            upper_[a + 1][k] = 0.5 * (below + above) + upper_[a][k] - upper_[a - 1][k];
        }
    for (std::size_t a = 0; a < side; ++a)
        for (std::size_t k = 0; k <= a; ++k) lower_[a][k] = (a + k) % 2 == 0 ? upper_[a][k] : -upper_[a][k];
}

void CubeShift::add(const double* terms, int octant, double* to, Work& work) const noexcept {
    const auto& along_x = (octant & 1) != 0 ? upper_ : lower_;
    const auto& along_y = (octant & 2) != 0 ? upper_ : lower_;
    const auto& along_z = (octant & 4) != 0 ? upper_ : lower_;
    const auto from = static_cast<std::size_t>(from_);
    const auto degree = static_cast<std::size_t>(to_);
    double* const z_done = work.z.data();
    double* const y_done = work.y.data();
    for (std::size_t a = 0; a <= from; ++a)
        for (std::size_t b = 0; a + b <= from; ++b) {
            const std::size_t most = from - a - b;
            double* const row = z_done + place(a, b, 0);
            std::fill_n(row, most + 1, 0.0);
            for (std::size_t c = 0; c <= most; ++c, ++terms)
                for (std::size_t k = 0; k <= c; ++k) row[k] += along_z[c][k] * *terms;
        }
    for (std::size_t a = 0; a <= from; ++a) {
        for (std::size_t k = 0; a + k <= from; ++k) std::fill_n(y_done + place(a, k, 0), from - a - k + 1, 0.0);
        for (std::size_t b = 0; a + b <= from; ++b)
            for (std::size_t k = 0; k <= b; ++k)
                for (std::size_t c = 0; a + b + c <= from; ++c)
                    y_done[place(a, k, c)] += along_y[b][k] * z_done[place(a, b, c)];
    }
    for (std::size_t k = 0; k <= degree; ++k)
        for (std::size_t b = 0; k + b <= degree; ++b) {
            const std::size_t count = degree - k - b + 1;
            for (std::size_t a = k; a + b <= from; ++a) {
                const double* const row = y_done + place(a, b, 0);
                const std::size_t there = std::min(count, from - a - b + 1);
                for (std::size_t c = 0; c < there; ++c) to[c] += along_x[a][k] * row[c];
            }
            to += count;
        }
}

} // namespace hrbfnpr::implicit
