// SPDX-License-Identifier: MIT
#include "fit/iterative.h"

#include "base/clock.h"
#include "base/long_array.h"
#include "fit/conjugate_gradients.h"
#include "geometry/farthest_order.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr int starts = 8;
// Iterations stop when their updated residual is below this share of the tolerance. The rest of the tolerance allows
// for the difference from the true residual.
constexpr double headroom = 0.8;

// With more than `few_samples` samples, the residual that the iterations update is compared with the true residual at
// only `some_samples` samples.
constexpr std::int64_t few_samples = 2048;
constexpr std::int64_t some_samples = 512;

// The system with its samples sorted in the order of a k-d tree. Samples that are near in space are then near in
// memory.
class OrderedSystem {
public:
    OrderedSystem(const base::Work& work, const HermiteSystem& system)
        : tree_(system.positions(), work), system_(tree_.points(), system.options()), rank_(work.memory, tree_.size()) {
        const geometry::FarthestOrder order = geometry::farthest_order(tree_.points(), 0, work);
        for (std::int64_t k = 0; k < order.order.size(); ++k) rank_[order.order[k]] = k;
    }

    [[nodiscard]] const geometry::PointTree& tree() const noexcept { return tree_; }
    [[nodiscard]] const HermiteSystem& system() const noexcept { return system_; }
    [[nodiscard]] const base::Array<std::int64_t>& rank() const noexcept { return rank_; }

    void gather(const double* x, double* ordered) const noexcept {
        for (std::int64_t at = 0; at < tree_.size(); ++at) std::copy_n(x + 4 * tree_.index(at), 4, ordered + 4 * at);
    }
    void scatter(const double* ordered, double* x) const noexcept {
        for (std::int64_t at = 0; at < tree_.size(); ++at) std::copy_n(ordered + 4 * at, 4, x + 4 * tree_.index(at));
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
    Iteration(const base::Work& work, const OrderedSystem& ordered, Preconditioner& preconditioner, double tolerance)
        : size_(ordered.system().rows()), polynomials_(work, ordered.system()),
          product_(work, ordered.tree().points(), ordered.system().options(), tolerance),
          cg_(work, product_, preconditioner, polynomials_, size_), w_(work.memory), w_before_(work.memory),
          r_(work.memory), h_(work.memory) {
        for (base::Array<double>* of : {&w_, &r_, &h_}) base::resize_long(*of, size_, work);
        if (product_.approximate()) base::resize_long(w_before_, size_, work);
    }

    void run(const OrderedSystem& ordered, const double* rhs, const SolveOptions& options, Solution& solution,
             const base::Progress& progress) {
        progress.check();
        ordered.gather(rhs, h_.data());
        std::copy_n(h_.data(), size_, r_.data());
        progress.check();
        polynomials_.subtract_best_polynomial(r_.data(), c_.data());
        progress.check();
        scale_ = std::max(norm(rhs, size_), 1e-300);
        if (options.start != nullptr) start_at(ordered, options.start, progress);
        solution.residual = norm(r_.data(), size_) / scale_;
        run_until_confirmed(options, solution, progress);
        // The last residual is that of an approximate product. Callers that judge the solution need the true residual.
        if (!solution.converged && solution.residual <= hopeless_residual) confirm(options, solution, progress);
        solution.x.resize(size_ + polynomials_.terms());
        std::copy_n(c_.data(), polynomials_.terms(), solution.x.data() + size_);
        ordered.scatter(w_.data(), solution.x.data());
        product_.add_diagonal(w_.data(), r_.data());
        solution.misfit.resize(size_);
        ordered.scatter(r_.data(), solution.misfit.data());
    }

private:
    // Starts at the given weights, or at 0 if the given weights are worse than 0.
    void start_at(const OrderedSystem& ordered, const double* weights, const base::Progress& progress) {
        const double residual_of_zero = norm(r_.data(), size_);
        ordered.gather(weights, w_.data());
        polynomials_.make_orthogonal(w_.data()); // Removes the polynomial part that rounding has left.
        find_residual(progress);
        if (norm(r_.data(), size_) < residual_of_zero) return;
        std::fill(w_.begin(), w_.end(), 0.0);
        std::copy_n(h_.data(), size_, r_.data());
        c_.fill(0.0);
        polynomials_.subtract_best_polynomial(r_.data(), c_.data());
    }

    // Returns false if the iterations end before the residual reaches `goal`.
    bool iterate(double goal, const SolveOptions& options, Solution& solution, const base::Progress& progress) {
        const CgOutcome outcome = cg_.run({w_.data(), r_.data(), c_.data()}, scale_, goal,
                                          options.iterations - solution.iterations, solution.history, progress);
        if (solution.iterations == 0) solution.condition = outcome.condition;
        solution.iterations += outcome.iterations;
        solution.residual = outcome.residual;
        return outcome.converged;
    }

    // Iterates. If the updated residual differs too much from the true residual, by rounding or by the error of an
    // approximate product, the iterations start again from the true residual. An approximate product is refined before
    // each new start.
    void run_until_confirmed(const SolveOptions& options, Solution& solution, const base::Progress& progress) {
        for (int start = 0; start < starts && solution.iterations < options.iterations; ++start) {
            const double before = solution.residual;
            if (product_.approximate()) std::copy_n(w_.data(), size_, w_before_.data());
            const bool reached = iterate(headroom * options.tolerance, options, solution, progress);
            if (product_.approximate() && solution.residual > hopeless_residual) return;
            if (confirm(options, solution, progress)) return;
            const bool refined = product_.refine(progress);
            find_residual(progress);
            if (product_.approximate() && !(solution.residual < before)) restore_last_start(progress);
            solution.residual = norm(r_.data(), size_) / scale_;
            const bool gained = reached && solution.residual < 0.5 * before;
            if (!gained && !refined) return;
        }
    }

    // Checks the updated residual against the true residual. With few samples it computes the whole true residual,
    // which replaces the updated one.
    bool confirm(const SolveOptions& options, Solution& solution, const base::Progress& progress) {
        const bool few = size_ <= 4 * few_samples;
        if (few) find_residual(progress);
        solution.residual = norm(r_.data(), size_) / scale_ + (few ? 0.0 : estimate_residual_drift(progress));
        solution.converged = solution.residual <= options.tolerance;
        return solution.converged;
    }

    // Restores the state before the last iterations, because a product that is not definite leads away from the
    // solution.
    void restore_last_start(const base::Progress& progress) {
        std::swap(w_, w_before_);
        find_residual(progress);
    }

    // Computes r = h - A w - P c with the c that makes r smallest.
    void find_residual(const base::Progress& progress) {
        product_.multiply(w_.data(), r_.data(), progress);
        progress.check();
        for (std::int64_t i = 0; i < size_; ++i) r_[i] = h_[i] - r_[i];
        c_.fill(0.0);
        polynomials_.subtract_best_polynomial(r_.data(), c_.data());
        polynomials_.subtract_best_polynomial(r_.data(),
                                              c_.data()); // Removes the polynomial part that rounding has left in r.
    }

    // Estimates from some samples how far r is from the true residual (relative, 2-norm).
    [[nodiscard]] double estimate_residual_drift(const base::Progress& progress) {
        const std::int64_t stride = std::max<std::int64_t>(1, size_ / 4 / some_samples);
        const base::Array<double> product = product_.multiply_some(w_.data(), stride, progress);
        double sum = 0.0;
        for (std::int64_t k = 0; k < product.size() / 4; ++k) {
            const std::int64_t at = 4 * k * stride;
            const std::array<double, 4> p = polynomials_.at(k * stride, c_.data());
            for (std::int64_t i = 0; i < 4; ++i) {
                const double off = h_[at + i] - product[4 * k + i] - p[static_cast<std::size_t>(i)] - r_[at + i];
                sum += off * off;
            }
        }
        return std::sqrt(sum * static_cast<double>(size_) / static_cast<double>(product.size())) / scale_;
    }

    std::int64_t size_;
    PolynomialSpace polynomials_;
    HermiteProduct product_;
    ConjugateGradients cg_;
    base::Array<double> w_;
    base::Array<double> w_before_;
    base::Array<double> r_;
    base::Array<double> h_;
    std::array<double, PolynomialSpace::terms_max> c_{};
    double scale_ = 1.0;
};

} // namespace

void solve_iteratively(const base::Work& work, const HermiteSystem& system, const double* rhs,
                       const SolveOptions& options, std::int32_t neighbours, Solution& solution) {
    base::Stopwatch watch;
    const OrderedSystem ordered(work.part(0.0, 0.05), system);
    solution.seconds_assemble += watch.seconds();
    watch.restart();
    Preconditioner preconditioner(work.part(0.05, 0.25), ordered.system(), ordered.tree(), ordered.rank(), neighbours);
    solution.seconds_precondition += watch.seconds();
    watch.restart();
    const double accuracy = options.product_tolerance > 0.0 ? options.product_tolerance : options.tolerance;
    Iteration iteration(work, ordered, preconditioner, accuracy);
    iteration.run(ordered, rhs, options, solution, work.part(0.25, 1.0));
    solution.seconds_solve += watch.seconds();
}

} // namespace hrbfnpr::fit
