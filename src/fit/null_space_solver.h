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

    // Returns false if the matrix is not positive definite on the null space.
    [[nodiscard]] bool factor(const base::Progress& progress);

    // Call these functions after factor(). They use `progress` only to check for cancellation.
    [[nodiscard]] double condition(const base::Progress& progress) const;
    // Replaces x by the matrix's inverse times x. x has unknowns() elements.
    void solve(double* x, const base::Progress& progress) const;

private:
    void assemble(const HermiteSystem& system, const base::Progress& progress);
    void assemble_tile(const HermiteSystem& system, const double* x, std::int64_t i, std::int64_t j);
    void assemble_border(const HermiteSystem& system, const double* x);

    const base::Runtime& runtime_;
    NullSpace space_;
    TiledCholesky cholesky_;     // the part of B = Q^T A Q with free rows and columns
    base::Array<double> border_; // rows() x terms(); column k is column rows() - 1 - k of B
    double norm_ = 0.0;
};

} // namespace hrbfnpr::fit
