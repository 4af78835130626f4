#include "fit/iterative.h"

#include "base/clock.h"
#include "fit/conjugate_gradients.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr int starts = 4;
constexpr double drift = 1.2; // of the true residual above the tolerance that is let pass

// The relative residual that CG is first run to with the fast product, about that product's error.
constexpr double approximate_goal = 1e-6;
// Up to so many samples the true residual is found with all pairs.
constexpr std::int64_t most_pairwise = 140000;

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
    Iteration(const base::Runtime& runtime, const Arranged& arranged, Preconditioner& preconditioner,
              const base::Progress& progress)
        : runtime_(runtime), size_(arranged.system().rows()), polynomials_(runtime, arranged.system()),
          product_(runtime, arranged.tree().points(), arranged.system().options(), progress),
          cg_(runtime, product_, preconditioner, polynomials_, size_), w_(runtime.memory, size_),
          r_(runtime.memory, size_), h_(runtime.memory, size_) {}

    // With an approximate product CG is run twice: down to what the product is good for, and, from the true residual,
    // to the end.  One more time if the recursion's residual and the true one have drifted apart.
    void run(const Arranged& arranged, const double* rhs, const SolveOptions& options, Solution& solution,
             const base::Progress& progress) {
        arranged.gather(rhs, h_.data());
        std::copy_n(h_.data(), size_, r_.data());
        polynomials_.take_out(r_.data());
        const double scale = std::max(norm(rhs, size_), 1e-300);
        solution.x.resize(size_ + polynomials_.terms());
        double* const c = solution.x.data() + size_;
        solution.residual = norm(r_.data(), size_) / scale;
        for (int start = 0; start < starts && !solution.converged; ++start) {
            const double goal = product_.approximate() && start == 0 ? std::max(options.tolerance, approximate_goal)
                                                                     : options.tolerance;
            const CgOutcome outcome = cg_.run(w_.data(), r_.data(), scale, goal,
                                              options.iterations - solution.iterations, solution.history, progress);
            solution.iterations += outcome.iterations;
            if (start == 0) solution.condition = outcome.condition;
            const double before = solution.residual;
            find_residual(c, progress);
            solution.residual = norm(r_.data(), size_) / scale;
            solution.converged = solution.residual <= drift * options.tolerance;
            if (!outcome.converged || !(solution.residual < 0.5 * before)) break;
        }
        store(arranged, solution);
    }

private:
    // r = h - A w - P c with the c that makes it least.
    void find_residual(double* c, const base::Progress& progress) {
        const bool all_pairs = size_ <= 4 * most_pairwise;
        product_.multiply(w_.data(), r_.data(),
                          all_pairs ? HermiteProduct::Accuracy::full : HermiteProduct::Accuracy::enough, progress);
        for (std::int64_t i = 0; i < size_; ++i) r_[i] = h_[i] - r_[i];
        std::fill_n(c, polynomials_.terms(), 0.0);
        polynomials_.explain(r_.data(), c);
        polynomials_.take_out(r_.data());
    }

    void store(const Arranged& arranged, Solution& solution) {
        arranged.scatter(w_.data(), solution.x.data());
        product_.add_diagonal(w_.data(), r_.data());
        solution.misfit.resize(size_);
        arranged.scatter(r_.data(), solution.misfit.data());
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
    Iteration iteration(runtime, arranged, preconditioner, progress);
    iteration.run(arranged, rhs, options, solution, progress.part(0.25, 1.0));
    solution.seconds_solve += watch.seconds();
}

} // namespace hrbfnpr::fit
