// SPDX-License-Identifier: MIT
// Solves the Hermite system by preconditioned conjugate gradients, in O(N) memory.
#pragma once

#include "base/work.h"
#include "fit/solve.h"

namespace hrbfnpr::fit {

// Sets solution.converged to false if the tolerance is not reached. Throws Error{invalid_argument (samples that do not
// determine the polynomial), singular_system, out_of_memory, cancelled}.
void solve_iteratively(const base::Work& work, const HermiteSystem& system, const double* rhs,
                       const SolveOptions& options, std::int32_t neighbours, Solution& solution);

} // namespace hrbfnpr::fit
