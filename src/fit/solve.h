// SPDX-License-Identifier: MIT
// Solves the Hermite system by the fitting method.
#pragma once

#include "fit/solver_kind.h"
#include "fit/system.h"

namespace hrbfnpr::fit {

struct SolveOptions {
    SolverKind solver = SolverKind::automatic;
    std::int32_t refinement_steps = 2;
    double tolerance = 0.0;         // of the iterative solver: relative residual, 2-norm; 0 = automatic
    double acceptable = 1e-6;       // ... where rounding, or an approximate product, lets it come no further
    double product_tolerance = 0.0; // that a fast product is made for; 0: as tolerance
    std::int32_t iterations = 200;
    std::int32_t neighbours = 0; // of its preconditioner; 0 = automatic
};

// Iterations that end with a relative residual above it have met samples that contradict each other, as slivers of a
// mesh do in single precision: a finer product or more neighbours don't help.
inline constexpr double hopeless_residual = 100.0;

struct Solution {
    explicit Solution(base::Memory& memory) noexcept : x(memory), misfit(memory), history(memory) {}

    base::Array<double> x;      // unknowns(): w, then c
    base::Array<double> misfit; // the conditions less what the function takes there, 4 a sample; may be empty
    SolverKind solver = SolverKind::direct;
    SolverReason reason = SolverReason::requested;
    double residual = 0.0;       // relative, 2-norm, of the whole system
    double condition = 0.0;      // 1-norm estimate, of the factored matrix; of the preconditioned one, 2-norm
    std::int32_t iterations = 0; // of refinement, or of CG
    bool fallback = false;
    double value_diagonal = 0.0; // where 0 was asked for, and would not do
    bool converged = false;      // the iterative solver reached its tolerance
    base::Array<double> history; // relative residual after each iteration of CG
    double seconds_assemble = 0.0;
    double seconds_precondition = 0.0;
    double seconds_solve = 0.0;
};

// rhs: unknowns() long, zeros in its last terms().
// Throws Error{invalid_argument, singular_system, not_converged, out_of_memory, cancelled}.
[[nodiscard]] Solution solve(const base::Work& work, const HermiteSystem& system, const double* rhs,
                             SolveOptions options);

} // namespace hrbfnpr::fit
