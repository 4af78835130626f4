// SPDX-License-Identifier: MIT
#include "fit/solve.h"

#include "fit/direct.h"
#include "fit/iterative.h"
#include "fit/local_factors.h"

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

// Fewer samples than this are solved directly, which is exact and no slower.
constexpr std::int64_t crossover = 192;
// More samples than this are solved directly only on request, since this takes 64 N^2 bytes and N^3 flops.
constexpr std::int64_t most_direct = 6000;

// Up to this number of samples, each sample's residual must be below 1e-8, not only their mean. This costs two
// iterations.
constexpr std::int64_t small = 2048;

// Up to this number of samples, the direct solver takes only tenths of a second. If rounding stops the iterations above
// `exact_enough`, the direct solver is then used. With more samples it takes up to a minute, so any acceptable residual
// of the iterations is accepted.
constexpr std::int64_t quickly_direct = 512;
constexpr double exact_enough = 1e-8;

constexpr std::int32_t second_neighbours = 48;

// The regularization of values that solve_regularized() adds. Smaller: the iterations break down. Much larger: the
// preconditioner does not match the system. Set on the 435 545 vertices of the Stanford dragon.
constexpr double regularization_of_values = 1.0;
constexpr double regularization_of_gradients = 1e-6;
constexpr double regularized_tolerance = 3e-4;

// Returns the number of neighbours k to try first. The set-up time of the preconditioner is proportional to k^3 for
// each sample. More neighbours need fewer iterations, whose time grows with the number of samples.
[[nodiscard]] std::int32_t first_neighbours(std::int64_t samples, kernel::Kind kernel) noexcept {
    // With the Gaussian, near samples do not screen far ones, so more neighbours are needed.
    if (kernel == kernel::Kind::gaussian) return 40;
    return samples < 3000 ? 16 : samples < 12000 ? 24 : samples < 40000 ? 28 : 32;
}

// Tells whether the system is definite on vectors orthogonal to the linear polynomials, as the preconditioner needs.
[[nodiscard]] bool definite(const HermiteSystem::Options& options) noexcept {
    return options.degree + 1 >= kernel::order(options.kernel);
}

// Returns whether rounding stopped the iterations near the goal, and the result is accurate enough.
[[nodiscard]] bool is_limited_by_rounding(const HermiteSystem& system, const SolveOptions& options,
                                          const Solution& solution) noexcept {
    if (solution.converged || solution.iterations >= options.iterations) return false;
    const bool direct_is_better = options.solver == SolverKind::automatic && system.samples() <= quickly_direct &&
                                  solution.residual > exact_enough;
    return !direct_is_better && solution.residual <= options.acceptable;
}

// Solves again with a little regularization. This bounds the weights of samples that contradict each other. The
// tolerance is one that products with these weights can reach.
void solve_regularized(const base::Work& work, const HermiteSystem& system, const double* rhs, SolveOptions options,
                       std::int32_t neighbours, Solution& solution) {
    HermiteSystem::Options regularized = system.options();
    // A regularization chosen by the caller is kept.
    if (regularized.value_diagonal > 0.0 || options.acceptable <= options.tolerance) return;
    regularized.value_diagonal = solution.value_diagonal = regularization_of_values;
    regularized.gradient_diagonal = regularization_of_gradients;
    // With a less accurate product the system would not be positive definite.
    options.product_tolerance = options.tolerance;
    options.tolerance = std::max(options.tolerance, regularized_tolerance);
    work.runtime().log(
        base::LogLevel::warning,
        "fit: some samples contradict each other; fitting with slight regularization and solver_tolerance %.0e",
        options.tolerance);
    solution.iterations = 0;
    solution.history.clear();
    solve_iteratively(work, HermiteSystem(system.positions(), regularized), rhs, options, neighbours, solution);
}

// Iterates, and starts again with more neighbours if necessary.
void iterate(const base::Work& work, const HermiteSystem& system, const double* rhs, const SolveOptions& options,
             Solution& solution) {
    const std::int32_t first =
        options.neighbours > 0 ? options.neighbours : first_neighbours(system.samples(), system.options().kernel);
    solution.solver = SolverKind::iterative;
    solve_iteratively(work, system, rhs, options, first, solution);
    if (is_limited_by_rounding(system, options, solution)) {
        work.runtime().log(
            base::LogLevel::warning,
            "fit: rounding stops the iterations at a relative residual of %.1e, above the solver_tolerance, %.1e",
            solution.residual, options.tolerance);
        solution.converged = true;
    }
    if (!solution.converged && solution.residual > hopeless_residual && system.samples() > most_direct)
        return solve_regularized(work, system, rhs, options, first, solution);
    if (solution.converged || options.neighbours > 0) return;
    work.runtime().log(base::LogLevel::info,
                       "fit: residual %.1e after %d iterations; trying again with %d neighbours instead of %d",
                       solution.residual, static_cast<int>(solution.iterations), static_cast<int>(second_neighbours),
                       static_cast<int>(first));
    solution.iterations = 0;
    solution.history.clear();
    solve_iteratively(work, system, rhs, options, second_neighbours, solution);
}

[[noreturn]] void fail_to_converge(const HermiteSystem& system, const Solution& solution, const SolveOptions& options) {
    const bool gaussian = system.options().kernel == kernel::Kind::gaussian;
    fail(Status::not_converged,
         "the iterative solver reached a residual of %.1e in %d iterations, not %.1e; use %sregularization > 0, a "
         "tolerance (fewer centres), a larger solver_tolerance or iteration_limit, or the direct solver",
         solution.residual, static_cast<int>(solution.iterations), options.tolerance,
         gaussian ? "a smaller kernel_radius, " : "");
}

[[nodiscard]] SolverReason try_iterations(const base::Work& work, const HermiteSystem& system, const double* rhs,
                                          const SolveOptions& options, Solution& solution) {
    try {
        iterate(work, system, rhs, options, solution);
    } catch (const Error& error) {
        if (error.status() != Status::singular_system) throw;
        return SolverReason::not_definite;
    }
    return solution.converged ? SolverReason::large : SolverReason::not_converged;
}

} // namespace

Solution solve(const base::Work& work, const HermiteSystem& system, const double* rhs, SolveOptions options) {
    Solution solution(work.memory);
    if (options.tolerance == 0.0) options.tolerance = system.samples() <= small ? 1e-10 : 1e-8;
    const bool possible = definite(system.options());
    if (options.solver == SolverKind::iterative) {
        if (!possible)
            fail(Status::invalid_argument, "solver is ITERATIVE, which needs polynomial_degree >= 1 with the "
                                           "triharmonic kernel; use that, or another solver");
        iterate(work, system, rhs, options, solution);
        if (!solution.converged) fail_to_converge(system, solution, options);
        return solution;
    }
    if (options.solver == SolverKind::automatic) {
        solution.reason = possible ? SolverReason::small : SolverReason::not_definite;
        if (possible && system.samples() >= crossover) {
            solution.reason = try_iterations(work.part(0.0, 0.9), system, rhs, options, solution);
            if (solution.reason == SolverReason::large) return solution;
            if (system.samples() > most_direct) fail_to_converge(system, solution, options);
            work.runtime().log(base::LogLevel::warning,
                               "fit: the iterative solver did not converge (residual %.1e); using the direct solver",
                               solution.residual);
        }
    }
    solution.misfit.clear(); // Discards the misfit of the iterative attempt.
    solution.history.clear();
    solve_directly(work, system, rhs, options, solution);
    return solution;
}

} // namespace hrbfnpr::fit
