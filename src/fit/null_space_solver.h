// SPDX-License-Identifier: MIT
// Solves the Hermite system by Cholesky on the null space of its side constraints.
#pragma once

#include "base/work.h"
#include "fit/cholesky.h"
#include "fit/null_space.h"

namespace hrbfnpr::fit {

class NullSpaceSolver {
public:
    // Assembles Q^T A Q.  Throws Error{invalid_argument, out_of_memory, cancelled}.
    NullSpaceSolver(const base::Work& work, const HermiteSystem& system);

    // Returns false if the matrix is not positive definite there.
    [[nodiscard]] bool factor(const base::Progress& progress);

    // Call both after factor(). They use `progress` only to check for cancellation.
    [[nodiscard]] double condition(const base::Progress& progress) const;
    // Replaces x (unknowns() long) by the inverse times x.
    void solve(double* x, const base::Progress& progress) const;

private:
    void assemble(const HermiteSystem& system, const base::Progress& progress);
    void assemble_tile(const HermiteSystem& system, const double* x, std::int64_t i, std::int64_t j);
    void assemble_border(const HermiteSystem& system, const double* x);

    const base::Runtime& runtime_;
    NullSpace space_;
    TiledCholesky cholesky_;     // the free rows and columns of B = Q^T A Q
    base::Array<double> border_; // rows() x terms(); column k is column rows() - 1 - k of B
    double norm_ = 0.0;
};

} // namespace hrbfnpr::fit
