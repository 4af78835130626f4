#include "fit/iterative.h"

#include "base/clock.h"
#include "fit/conjugate_gradients.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// The recursion's residual and the true one drift apart where the system is ill-conditioned: CG is begun again from
// the true one so many times.
constexpr int restarts = 3;
constexpr double drift = 1.5; // of the true residual above the tolerance that is let pass

// The system in the k-d tree's order, in which neighbours in space are neighbours in memory.
class Arranged {
public:
    Arranged(const base::Runtime& runtime, const HermiteSystem& system, const base::Progress& progress)
        : tree_(system.positions(), progress), system_(tree_.points(), system.options()),
          rank_(runtime.memory, tree_.size()) {
        const geometry::FarthestOrder order = geometry::farthest_order(tree_.points(), 0, progress);
        for (std::int64_t k = 0; k < order.order.size(); ++k) rank_[order.order[k]] = k;
    }

    [[nodiscard]] const geometry::PointTree& tree() const noexcept { return tree_; }
    [[nodiscard]] const HermiteSystem& system() const noexcept { return system_; }
    [[nodiscard]] const base::Array<std::int64_t>& rank() const noexcept { return rank_; }

    void gather(const double* x, double* arranged) const noexcept {
        for (std::int64_t at = 0; at < tree_.size(); ++at) std::copy_n(x + 4 * tree_.index(at), 4, arranged + 4 * at);
    }
    void scatter(const double* arranged, double* x) const noexcept {
        for (std::int64_t at = 0; at < tree_.size(); ++at) std::copy_n(arranged + 4 * at, 4, x + 4 * tree_.index(at));
    }

private:
    geometry::PointTree tree_;
    HermiteSystem system_;
    base::Array<std::int64_t> rank_;
};

[[nodiscard]] double norm(const double* x, std::int64_t size) noexcept {
    double sum = 0.0;
    for (std::int64_t i = 0; i < size; ++i) sum += x[i] * x[i];
    return std::sqrt(sum);
}

class Iteration {
public:
    Iteration(const base::Runtime& runtime, const Arranged& arranged, Preconditioner& preconditioner)
        : runtime_(runtime), size_(arranged.system().rows()), polynomials_(runtime, arranged.system()),
          product_(runtime, arranged.tree().points(), arranged.system().options()),
          cg_(runtime, product_, preconditioner, polynomials_, size_), w_(runtime.memory, size_),
          r_(runtime.memory, size_), h_(runtime.memory, size_) {}

    void run(const Arranged& arranged, const double* rhs, const SolveOptions& options, Solution& solution,
             const base::Progress& progress) {
        arranged.gather(rhs, h_.data());
        std::copy_n(h_.data(), size_, r_.data());
        polynomials_.take_out(r_.data());
        const double scale = std::max(norm(rhs, size_), 1e-300);
        solution.x.resize(size_ + polynomials_.terms());
        double* const c = solution.x.data() + size_;
        for (int start = 0; start < restarts && !solution.converged; ++start) {
            const std::int32_t left = options.iterations - solution.iterations;
            const CgOutcome outcome =
                cg_.run(w_.data(), r_.data(), scale, options.tolerance, left, solution.history, progress);
            solution.iterations += outcome.iterations;
            if (start == 0) solution.condition = outcome.condition;
            const double before = solution.residual;
            find_residual(c, progress);
            solution.residual = norm(r_.data(), size_) / scale;
            solution.converged = solution.residual <= drift * options.tolerance;
            if (!outcome.converged || (start > 0 && !(solution.residual < 0.5 * before))) break;
        }
        arranged.scatter(w_.data(), solution.x.data());
    }

private:
    // r = h - A w - P c with the c that makes it least.
    void find_residual(double* c, const base::Progress& progress) {
        product_.multiply(w_.data(), r_.data(), progress);
        for (std::int64_t i = 0; i < size_; ++i) r_[i] = h_[i] - r_[i];
        std::fill_n(c, polynomials_.terms(), 0.0);
        polynomials_.explain(r_.data(), c);
        polynomials_.take_out(r_.data());
    }

    const base::Runtime& runtime_;
    std::int64_t size_;
    PolynomialSpace polynomials_;
    HermiteProduct product_;
    ConjugateGradients cg_;
    base::Array<double> w_;
    base::Array<double> r_;
    base::Array<double> h_;
};

} // namespace

void solve_iteratively(const base::Runtime& runtime, const HermiteSystem& system, const double* rhs,
                       const SolveOptions& options, std::int32_t neighbours, Solution& solution,
                       const base::Progress& progress) {
    base::Stopwatch watch;
    const Arranged arranged(runtime, system, progress.part(0.0, 0.05));
    solution.seconds_assemble += watch.seconds();
    watch.restart();
    Preconditioner preconditioner(runtime, arranged.system(), arranged.tree(), arranged.rank(), neighbours,
                                  progress.part(0.05, 0.25));
    solution.seconds_precondition += watch.seconds();
    watch.restart();
    Iteration iteration(runtime, arranged, preconditioner);
    iteration.run(arranged, rhs, options, solution, progress.part(0.25, 1.0));
    solution.seconds_solve += watch.seconds();
}

} // namespace hrbfnpr::fit
