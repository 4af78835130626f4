// SPDX-License-Identifier: MIT
#include "fit/conjugate_gradients.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// Vectors are processed in chunks of this many numbers, so sums do not depend on the number of threads.
constexpr std::int64_t grain = 16384;

// Collects the coefficients of the CG iterations. They form Lanczos' tridiagonal matrix (Golub, Van Loan, section
// 10.2.5).
class Lanczos {
public:
    explicit Lanczos(base::Memory& memory) noexcept : diagonal_(memory), off_diagonal_(memory) {}

    // Adds the coefficients of one iteration. alpha is the length of the step. The direction of the step is the
    // preconditioned residual plus beta times the previous direction.
    void add(double alpha, double beta) {
        if (!diagonal_.empty()) off_diagonal_.push_back(std::sqrt(beta) / alpha_);
        diagonal_.push_back(1.0 / alpha + (diagonal_.empty() ? 0.0 : beta / alpha_));
        alpha_ = alpha;
    }

    [[nodiscard]] double condition() const {
        const auto size = static_cast<Eigen::Index>(diagonal_.size());
        if (size == 0) return 1.0;
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal_.data(), size),
                                      Eigen::Map<const Eigen::VectorXd>(off_diagonal_.data(), size - 1),
                                      Eigen::EigenvaluesOnly);
        return solver.eigenvalues()[size - 1] / solver.eigenvalues()[0];
    }

private:
    base::Array<double> diagonal_;
    base::Array<double> off_diagonal_;
    double alpha_ = 0.0;
};

} // namespace

ConjugateGradients::ConjugateGradients(const base::Runtime& runtime, HermiteProduct& product,
                                       Preconditioner& preconditioner, const PolynomialSpace& polynomials,
                                       std::int64_t size)
    : runtime_(runtime), product_(product), preconditioner_(preconditioner), polynomials_(polynomials), size_(size),
      z_(runtime.memory, size), p_(runtime.memory, size), ap_(runtime.memory, size),
      sums_(runtime.memory, (size + grain - 1) / grain) {}

double ConjugateGradients::dot(const double* a, const double* b) {
    using Map = Eigen::Map<const Eigen::VectorXd>;
    runtime_.parallel.for_chunks(size_, grain, [&](std::int64_t begin, std::int64_t end) {
        sums_[begin / grain] = Map(a + begin, end - begin).dot(Map(b + begin, end - begin));
    });
    double sum = 0.0;
    for (const double part : sums_) sum += part;
    return sum;
}

CgOutcome ConjugateGradients::run(const CgState& state, double scale, double tolerance, std::int32_t limit,
                                  base::Array<double>& history, const base::Progress& progress) {
    using Map = Eigen::Map<Eigen::VectorXd>;
    double* const w = state.w;
    double* const r = state.r;
    CgOutcome outcome;
    Lanczos lanczos(runtime_.memory);
    const double start = std::sqrt(dot(r, r)) / scale;
    outcome.residual = start;
    double rho = 0.0;
    while (!(outcome.residual <= tolerance) && outcome.iterations < limit) {
        preconditioner_.apply(r, z_.data(), progress);
        // The factor is stored in floats, so its products have a small polynomial part, which is removed.
        polynomials_.make_orthogonal(z_.data());
        progress.check();
        const double rho_next = dot(r, z_.data());
        const double beta = outcome.iterations > 0 ? rho_next / rho : 0.0;
        rho = rho_next;
        runtime_.parallel.for_chunks(size_, grain, [&](std::int64_t begin, std::int64_t end) {
            Map(p_.data() + begin, end - begin) =
                Map(z_.data() + begin, end - begin) + beta * Map(p_.data() + begin, end - begin);
        });
        product_.multiply(p_.data(), ap_.data(), progress);
        progress.check();
        std::array<double, PolynomialSpace::terms_max> q{};
        polynomials_.subtract_best_polynomial(ap_.data(), q.data());
        progress.check();
        const double curvature = dot(p_.data(), ap_.data());
        // The matrix is not definite: the iterations end, and the caller uses another solver.
        if (!(curvature > 0.0) || !std::isfinite(rho)) break;
        const double alpha = rho / curvature;
        runtime_.parallel.for_chunks(size_, grain, [&](std::int64_t begin, std::int64_t end) {
            Map(w + begin, end - begin) += alpha * Map(p_.data() + begin, end - begin);
            Map(r + begin, end - begin) -= alpha * Map(ap_.data() + begin, end - begin);
        });
        for (std::int64_t k = 0; k < polynomials_.terms(); ++k) state.c[k] -= alpha * q[static_cast<std::size_t>(k)];
        ++outcome.iterations;
        outcome.residual = std::sqrt(dot(r, r)) / scale;
        history.push_back(outcome.residual);
        lanczos.add(alpha, beta);
        progress.update(std::log(start / outcome.residual) / std::log(start / tolerance));
    }
    outcome.converged = outcome.residual <= tolerance;
    outcome.condition = lanczos.condition();
    return outcome;
}

} // namespace hrbfnpr::fit
