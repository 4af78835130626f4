// Solves the Hermite system by the fitting method and polishes the solution.
#pragma once

#include "fit/system.h"

namespace hrbfnpr::fit {

struct Solution {
    explicit Solution(base::Memory& memory) noexcept : x(memory) {}

    base::Array<double> x;  // unknowns(): w, then c
    double residual = 0.0;  // relative, 2-norm, of the whole system
    double condition = 0.0; // 1-norm estimate, of the factored matrix
    std::int32_t iterations = 0;
    bool fallback = false;
    double seconds_assemble = 0.0;
    double seconds_solve = 0.0;
};

// rhs: unknowns() long.  Throws Error{invalid_argument, singular_system, out_of_memory, cancelled}.
[[nodiscard]] Solution solve(const base::Runtime& runtime, const HermiteSystem& system, const double* rhs,
                             std::int32_t iteration_limit, const base::Progress& progress);

} // namespace hrbfnpr::fit
