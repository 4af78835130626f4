// SPDX-License-Identifier: MIT
// LU factorisation with row pivoting of the whole, indefinite system. It is used if the matrix is not definite on the
// null space of its side constraints.
#pragma once

#include "base/work.h"
#include "fit/system.h"

namespace hrbfnpr::fit {

class DenseLu {
public:
    // Assembles the matrix and factors it.  Throws Error{singular_system, out_of_memory, cancelled}.
    DenseLu(const base::Work& work, const HermiteSystem& system);

    // condition() and solve() use `progress` only to check for cancellation.
    [[nodiscard]] double condition(const base::Progress& progress) const;
    // Replaces x by the matrix's inverse times x. x has unknowns() elements.
    void solve(double* x, const base::Progress& progress) const;

private:
    void assemble(const HermiteSystem& system, const base::Progress& progress);
    void factor(const base::Progress& progress);
    void factor_panel(std::int64_t begin, std::int64_t end, const base::Progress& progress);
    void update(std::int64_t begin, std::int64_t end, const base::Progress& progress);
    [[nodiscard]] double* column(std::int64_t j) noexcept { return matrix_.data() + j * size_; }

    const base::Runtime& runtime_;
    std::int64_t size_;
    base::Array<double> matrix_;      // in column-major order
    base::Array<std::int64_t> pivot_; // row k was exchanged with row pivot_[k]
    double norm_ = 0.0;
};

} // namespace hrbfnpr::fit
