// SPDX-License-Identifier: MIT
// The Hermite interpolation system of [NPAR 4.1]:
//
//   [ A    P ] [ w ]   [ h ]      w = (alpha_1, beta_1, alpha_2, ...), h = (0, n_1, 0, n_2, ...)
//   [ P^T  0 ] [ c ] = [ 0 ]      c: the polynomial's coefficients
//
// The pair block of samples i, j with d = x_i - x_j is [[phi, -a d^T], [a d, -(a I + b d d^T)]];
// A is symmetric, and positive definite on the null space of P^T.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "kernel/kernel.h"

#include <cstdint>

namespace hrbfnpr::fit {

class HermiteSystem {
public:
    struct Options {
        kernel::Kind kernel;
        double radius; // in the unit of the positions
        std::int32_t degree;
        double value_diagonal;    // regularization, added to the diagonal for alpha
        double gradient_diagonal; // regularization, added to the diagonal for beta
    };

    // The object refers to `positions` (normalised) as long as it lives.
    HermiteSystem(const geometry::VecArray& positions, const Options& options) noexcept
        : positions_(positions), options_(options) {}

    [[nodiscard]] std::int64_t samples() const noexcept { return positions_.size(); }
    [[nodiscard]] std::int64_t rows() const noexcept { return 4 * positions_.size(); } // rows of A
    [[nodiscard]] std::int64_t terms() const noexcept;                                 // the number of columns of P
    [[nodiscard]] std::int64_t unknowns() const noexcept { return rows() + terms(); }
    [[nodiscard]] const Options& options() const noexcept { return options_; }
    [[nodiscard]] const geometry::VecArray& positions() const noexcept { return positions_; }

    // Writes the block of A with the rows of samples [i0, i1) and the columns of samples [j0, j1), column-major.
    void block(std::int64_t i0, std::int64_t i1, std::int64_t j0, std::int64_t j1, double* out,
               std::int64_t column_stride) const noexcept;

    // Computes y = A x without storing A. x and y have `columns` columns, packed, column-major.
    void multiply(const base::Parallel& parallel, const double* x, std::int64_t columns, double* y,
                  const base::Progress& progress) const;

    // Writes P, packed, column-major.
    void constraints(double* p) const noexcept;

private:
    const geometry::VecArray& positions_;
    Options options_;
};

} // namespace hrbfnpr::fit
