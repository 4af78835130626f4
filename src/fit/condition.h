// SPDX-License-Identifier: MIT
// Estimates the 1-norm of a symmetric matrix's inverse from a few solves.
// Hager 1984; Higham, "FORTRAN codes for estimating the one-norm", ACM TOMS 14, 1988.
#pragma once

#include <cmath>
#include <cstdint>

namespace hrbfnpr::fit {

namespace detail {

struct LargestElement {
    std::int64_t at = 0;
    double sum = 0.0; // the sum of the elements' magnitudes
};

[[nodiscard]] inline LargestElement largest_element(const double* x, std::int64_t size) noexcept {
    LargestElement result;
    for (std::int64_t i = 0; i < size; ++i) {
        if (std::abs(x[i]) > std::abs(x[result.at])) result.at = i;
        result.sum += std::abs(x[i]);
    }
    return result;
}

} // namespace detail

// solve(x) replaces x by the inverse times x. `x` has room for `size` numbers.
template <class Solve>
[[nodiscard]] double inverse_norm(std::int64_t size, double* x, Solve&& solve) {
    if (size == 0) return 0.0;
    const double n = static_cast<double>(size);
    for (std::int64_t i = 0; i < size; ++i) x[i] = 1.0 / n;
    double estimate = 0.0;
    std::int64_t column = -1;
    for (int iteration = 0; iteration < 5; ++iteration) {
        solve(x);
        const double norm = detail::largest_element(x, size).sum;
        if (!(norm > estimate)) break;
        estimate = norm;
        for (std::int64_t i = 0; i < size; ++i) x[i] = x[i] < 0.0 ? -1.0 : 1.0;
        solve(x);
        const std::int64_t best = detail::largest_element(x, size).at;
        if (column >= 0 && std::abs(x[best]) <= std::abs(x[column])) break;
        column = best;
        for (std::int64_t i = 0; i < size; ++i) x[i] = i == column ? 1.0 : 0.0;
    }
    // The iteration above underestimates some matrices. A vector of growing, alternating elements finds a better
    // estimate for these.
    for (std::int64_t i = 0; i < size; ++i)
        x[i] = (i % 2 == 0 ? 1.0 : -1.0) * (1.0 + static_cast<double>(i) / std::fmax(1.0, n - 1.0));
    solve(x);
    return std::fmax(estimate, 2.0 * detail::largest_element(x, size).sum / (3.0 * n));
}

} // namespace hrbfnpr::fit
