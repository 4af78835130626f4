// SPDX-License-Identifier: MIT
#include "fit/direct.h"

#include "base/clock.h"
#include "fit/lu.h"
#include "fit/null_space_solver.h"

#include <Eigen/Core>

#include <cmath>

namespace hrbfnpr::fit {
namespace {

// A solution with a larger relative residual is rejected. The residual after refinement is the error of value and
// gradient at the samples.
constexpr double residual_limit = 1e-6;

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

class Refinement {
public:
    Refinement(const base::Runtime& runtime, const HermiteSystem& system, const double* rhs)
        : runtime_(runtime), system_(system), rhs_(rhs, system.unknowns()),
          constraints_(runtime.memory, system.rows() * system.terms()), residual_(runtime.memory, system.unknowns()),
          trial_(runtime.memory, system.unknowns()), trial_residual_(runtime.memory, system.unknowns()) {
        system.constraints(constraints_.data());
    }

    // Solves the system, then improves the solution by solving for its residual, as long as the residual shrinks.
    template <class Solver>
    void run(const Solver& solver, std::int32_t limit, Solution& solution, const base::Progress& progress) {
        const std::int64_t size = system_.unknowns();
        solution.x.resize(size);
        Vector x(solution.x.data(), size);
        x = rhs_;
        solver.solve(solution.x.data(), progress);
        double norm = measure(x, residual_, progress);
        solution.iterations = 0;
        for (std::int32_t step = 0; step < limit && norm > 0.0; ++step) {
            progress.update(static_cast<double>(step + 1) / static_cast<double>(limit + 1));
            Vector trial(trial_.data(), size);
            trial = ConstVector(residual_.data(), size);
            solver.solve(trial_.data(), progress);
            trial += x;
            const double trial_norm = measure(trial, trial_residual_, progress);
            if (!(trial_norm < norm)) break;
            x = trial;
            std::swap(residual_, trial_residual_);
            norm = trial_norm;
            ++solution.iterations;
        }
        const double scale = rhs_.norm();
        solution.residual = scale > 0.0 ? norm / scale : norm;
    }

private:
    // Computes residual = rhs - K x with the exact matrix, not with its factors, and returns the residual's 2-norm.
    [[nodiscard]] double measure(const Eigen::Ref<const Eigen::VectorXd>& x, base::Array<double>& residual,
                                 const base::Progress& progress) const {
        const std::int64_t rows = system_.rows();
        const std::int64_t terms = system_.terms();
        system_.multiply(runtime_.parallel, x.data(), 1, residual.data(), progress);
        Vector r(residual.data(), system_.unknowns());
        r.tail(terms).setZero();
        for (std::int64_t k = 0; k < terms; ++k) {
            const ConstVector p(constraints_.data() + k * rows, rows);
            r.head(rows) += x[rows + k] * p;
            r[rows + k] = p.dot(x.head(rows));
        }
        r = rhs_ - r;
        return r.norm();
    }

    const base::Runtime& runtime_;
    const HermiteSystem& system_;
    ConstVector rhs_;
    base::Array<double> constraints_;
    base::Array<double> residual_;
    base::Array<double> trial_;
    base::Array<double> trial_residual_;
};

[[nodiscard]] bool solved(const Solution& solution) noexcept { return solution.residual <= residual_limit; }

// Returns false if the matrix is not definite, or too badly conditioned to solve without pivoting.
[[nodiscard]] bool solve_on_null_space(const base::Work& work, const HermiteSystem& system, Refinement& refinement,
                                       std::int32_t limit, Solution& solution) {
    base::Stopwatch watch;
    NullSpaceSolver solver(work.part(0.0, 0.15), system);
    solution.seconds_assemble = watch.seconds();
    watch.restart();
    const bool definite = solver.factor(work.part(0.15, 0.9));
    if (definite) {
        refinement.run(solver, limit, solution, work.part(0.9, 0.95));
        solution.condition = solver.condition(work);
    }
    solution.seconds_solve = watch.seconds();
    return definite && solved(solution);
}

void solve_by_lu(const base::Work& work, const HermiteSystem& system, Refinement& refinement, std::int32_t limit,
                 Solution& solution) {
    const base::Stopwatch watch;
    const DenseLu lu(work.part(0.0, 0.9), system);
    refinement.run(lu, limit, solution, work.part(0.9, 0.95));
    solution.condition = lu.condition(work);
    solution.fallback = true;
    solution.seconds_solve += watch.seconds();
    if (!solved(solution))
        fail(Status::singular_system,
             "the system is singular (condition %.1e, residual %.1e); use regularization > 0, a smaller kernel_radius, "
             "or polynomial_degree >= 1 with the triharmonic kernel",
             solution.condition, solution.residual);
}

} // namespace

void solve_directly(const base::Work& work, const HermiteSystem& system, const double* rhs, const SolveOptions& options,
                    Solution& solution) {
    solution.solver = SolverKind::direct;
    Refinement refinement(work, system, rhs);
    if (solve_on_null_space(work.part(0.0, 0.9), system, refinement, options.refinement_steps, solution)) return;
    work.runtime().log(base::LogLevel::warning, "fit: the system is not positive definite; trying LU with pivoting");
    solve_by_lu(work.part(0.9, 1.0), system, refinement, options.refinement_steps, solution);
}

} // namespace hrbfnpr::fit
