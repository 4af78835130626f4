// SPDX-License-Identifier: MIT
// Solves the Hermite system, by the solver that the options or the number of samples ask for.
#pragma once

#include "base/work.h"
#include "fit/solver_kind.h"
#include "fit/system.h"

namespace hrbfnpr::fit {

struct SolveOptions {
    SolverKind solver = SolverKind::automatic;
    std::int32_t refinement_steps = 2;
    double tolerance = 0.0;   // relative residual (2-norm) at which the iterative solver stops; 0 = automatic
    double acceptable = 1e-6; // a residual that is accepted if rounding or an approximate product stops the iterations
    double product_tolerance = 0.0; // the tolerance of a fast product; 0: the same as `tolerance`
    std::int32_t iterations = 200;
    // If not null, rows() numbers at which the iterations start: weights that satisfy the side constraints. The
    // iterations start at 0 if these weights are worse.
    const double* start = nullptr;
    std::int32_t neighbours = 0; // the number of neighbours that the preconditioner uses for each sample; 0: automatic
};

// Iterations that end with a larger relative residual show that samples contradict each other, for example at slivers
// of a mesh in single precision. A finer product or more neighbours do not help then.
inline constexpr double hopeless_residual = 100.0;

struct Solution {
    explicit Solution(base::Memory& memory) noexcept : x(memory), misfit(memory), history(memory) {}

    base::Array<double> x; // unknowns() numbers: w, then c
    // The right-hand side minus the function's values and gradients, 4 per sample. It may be empty.
    base::Array<double> misfit;
    SolverKind solver = SolverKind::direct;
    SolverReason reason = SolverReason::requested;
    double residual = 0.0; // relative residual of the whole system, 2-norm
    // The condition number of the factored matrix (1-norm estimate), or of the preconditioned matrix (2-norm).
    double condition = 0.0;
    std::int32_t iterations = 0; // the number of refinement steps, or of CG iterations
    bool fallback = false;
    double value_diagonal = 0.0; // the regularization that was added although 0 was requested, because 0 did not work
    bool converged = false;      // true if the iterative solver reached its tolerance
    base::Array<double> history; // the relative residual after each iteration of CG
    double seconds_assemble = 0.0;
    double seconds_precondition = 0.0;
    double seconds_solve = 0.0;
};

// `rhs` has unknowns() elements; its last terms() elements are 0. Throws Error{invalid_argument, singular_system,
// not_converged, out_of_memory, cancelled}.
[[nodiscard]] Solution solve(const base::Work& work, const HermiteSystem& system, const double* rhs,
                             SolveOptions options);

} // namespace hrbfnpr::fit
