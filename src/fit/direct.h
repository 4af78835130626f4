// SPDX-License-Identifier: MIT
// Solves the Hermite system by a dense factorisation, and refines the solution.
#pragma once

#include "base/work.h"
#include "fit/solve.h"

namespace hrbfnpr::fit {

// Throws Error{invalid_argument, singular_system, out_of_memory, cancelled}.
void solve_directly(const base::Work& work, const HermiteSystem& system, const double* rhs, const SolveOptions& options,
                    Solution& solution);

} // namespace hrbfnpr::fit
