// SPDX-License-Identifier: MIT
#include "fit/hermite_energy.h"

#include "fit/conjugate_gradients.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t energies_a_task = 1024; // samples per task
constexpr std::int32_t most_iterations = 60;

[[nodiscard]] HermiteSystem::Options options_of(double ridge) noexcept {
    return {kernel::Kind::triharmonic, 0.0, 1, ridge, 0.0};
}

} // namespace

struct HermiteEnergy::Solver {
    Solver(const base::Work& work, const HermiteSystem& system, Preconditioner& preconditioner)
        : size(system.rows()), polynomials(work, system), product(work, system.positions(), system.options(), 1e-3),
          cg(work, product, preconditioner, polynomials, size), w(work.memory, size), r(work.memory, size),
          history(work.memory) {}

    std::int64_t size;
    PolynomialSpace polynomials;
    HermiteProduct product;
    ConjugateGradients cg;
    base::Array<double> w;
    base::Array<double> r;
    base::Array<double> history;
};

HermiteEnergy::HermiteEnergy(const base::Work& work, const geometry::PointTree& tree,
                             const base::Array<std::int64_t>& rank, const Options& options)
    : runtime_(work), system_(tree.points(), options_of(options.ridge)),
      preconditioner_(work, system_, tree, rank, options.neighbours), r_(work.memory, system_.rows()),
      z_(work.memory, system_.rows()) {}

HermiteEnergy::~HermiteEnergy() = default;

void HermiteEnergy::load(const geometry::VecArray& normal) noexcept {
    for (std::int64_t i = 0; i < size(); ++i) {
        r_[4 * i] = 0.0;
        r_[4 * i + 1] = normal.x[i];
        r_[4 * i + 2] = normal.y[i];
        r_[4 * i + 3] = normal.z[i];
    }
}

double HermiteEnergy::unload(const geometry::VecArray& normal, const double* z,
                             geometry::VecArray& beta) const noexcept {
    double energy = 0.0;
    for (std::int64_t i = 0; i < size(); ++i) {
        beta.set(i, {z[4 * i + 1], z[4 * i + 2], z[4 * i + 3]});
        energy += glm::dot(beta[i], normal[i]);
    }
    return energy;
}

double HermiteEnergy::approximate_energy(const geometry::VecArray& normal, geometry::VecArray& beta,
                                         const base::Progress& progress) {
    load(normal);
    preconditioner_.apply(r_.data(), z_.data(), progress);
    return unload(normal, z_.data(), beta);
}

double HermiteEnergy::accurate_energy(const geometry::VecArray& normal, geometry::VecArray& beta, double tolerance,
                                      const base::Progress& progress) {
    if (solver_ == nullptr)
        solver_ = std::make_unique<Solver>(base::Work(runtime_, progress), system_, preconditioner_);
    Solver& solver = *solver_;
    load(normal);
    std::copy_n(r_.data(), solver.size, solver.r.data());
    std::fill(solver.w.begin(), solver.w.end(), 0.0);
    solver.history.clear();
    std::array<double, PolynomialSpace::terms_max> c{};
    solver.polynomials.subtract_best_polynomial(solver.r.data(), c.data());
    const double scale = std::sqrt(static_cast<double>(size()));
    // There are many of these solves, so their iterations do not report progress.
    solver.cg.run({solver.w.data(), solver.r.data(), c.data()}, scale, tolerance, most_iterations, solver.history,
                  progress.part(0.0, 0.0));
    return unload(normal, solver.w.data(), beta);
}

HermiteEnergy::Terms HermiteEnergy::terms(const geometry::VecArray& normal, const base::Progress& progress) const {
    const Preconditioner::Blocks blocks = preconditioner_.blocks();
    Terms terms{blocks, base::Array<float>(runtime_.memory),
                base::Array<double>(runtime_.memory, blocks.coarse_count * blocks.coarse_columns)};
    terms.add.resize_for_overwrite(size() * blocks.set_size * 4);
    runtime_.parallel.for_chunks(size(), energies_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t e = begin * blocks.set_size; e < end * blocks.set_size; ++e) {
            const bool has_term = blocks.set[e - e % blocks.set_size] >= 0;
            const glm::dvec3 n = has_term ? normal[blocks.set[e]] : glm::dvec3(0.0);
            const float* f = blocks.factor + 16 * e;
            for (std::int64_t c = 0; c < 4; ++c) {
                const glm::dvec3 row{f[4 + c], f[8 + c], f[12 + c]};
                terms.add[4 * e + c] = static_cast<float>(glm::dot(n, row));
            }
        }
    });
    const std::int64_t rows = 4 * blocks.coarse_count;
    for (std::int64_t k = 0; k < blocks.coarse_count; ++k) {
        const glm::dvec3 n = normal[blocks.coarse[k]];
        for (std::int64_t c = 0; c < blocks.coarse_columns; ++c) {
            const double* f = blocks.coarse_factor + c * rows + 4 * k;
            terms.coarse_add[k * blocks.coarse_columns + c] = n.x * f[1] + n.y * f[2] + n.z * f[3];
        }
    }
    return terms;
}

base::Array<double> HermiteEnergy::stiffness(const base::Progress& progress) const {
    const Preconditioner::Blocks blocks = preconditioner_.blocks();
    base::Array<double> result(runtime_.memory, size());
    const auto square = [](const auto* f, std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t i = begin; i < end; ++i) sum += static_cast<double>(f[i]) * static_cast<double>(f[i]);
        return sum;
    };
    for (const std::int64_t e : progress.over(size() * blocks.set_size)) {
        if (blocks.set[e - e % blocks.set_size] >= 0) result[blocks.set[e]] += square(blocks.factor + 16 * e, 4, 16);
    }
    for (std::int64_t k = 0; k < blocks.coarse_count; ++k)
        for (std::int64_t c = 0; c < blocks.coarse_columns; ++c)
            result[blocks.coarse[k]] += square(blocks.coarse_factor + c * 4 * blocks.coarse_count + 4 * k, 1, 4);
    return result;
}

} // namespace hrbfnpr::fit
