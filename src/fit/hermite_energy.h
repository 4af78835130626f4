// SPDX-License-Identifier: MIT
// The energy of a Hermite interpolant as a function of its normals: the positions stay, and are factored once.
//
// f with f(x_i) = 0 and grad f(x_i) = n_i has the energy n . beta, beta its gradient weights: a quadratic form in the
// normals.  Which normals are right is a question of its least value (Huang, Carr, Ju, "Variational implicit point set
// surfaces", 2019).  The sparse factor of the preconditioner makes a sparse sum of squares of it, as near as the
// preconditioned system is to the identity.
#pragma once

#include "fit/preconditioner.h"

#include <memory>

namespace hrbfnpr::fit {

class HermiteEnergy {
public:
    struct Options {
        double ridge = 0.0; // on values, in spacings cubed: noise's variance over that of f
        std::int32_t neighbours = 16;
    };

    // Of the tree's points, which should be about 1 apart, in the tree's order, as all vectors below.  rank: of each in
    // a farthest-first order.  Refers to both.  Throws Error{out_of_memory, cancelled, singular_system}.
    HermiteEnergy(const base::Work& work, const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
                  const Options& options);
    ~HermiteEnergy();
    HermiteEnergy(const HermiteEnergy&) = delete;
    HermiteEnergy& operator=(const HermiteEnergy&) = delete;

    [[nodiscard]] std::int64_t size() const noexcept { return system_.samples(); }

    // By the sparse factor; beta (half the derivative) is written.
    double sparse(const geometry::VecArray& normal, geometry::VecArray& beta, const base::Progress& progress = {});
    // By conjugate gradients, to this relative residual.
    double solved(const geometry::VecArray& normal, geometry::VecArray& beta, double tolerance,
                  const base::Progress& progress);

    // The sparse energy is the sum of squares of vectors; what each normal adds to each of these.
    struct Terms {
        Preconditioner::Blocks blocks;
        base::Array<float> add;         // 4 numbers for each element of blocks.set
        base::Array<double> coarse_add; // blocks.coarse_columns for each of the dense block's samples
    };
    [[nodiscard]] Terms terms(const geometry::VecArray& normal, const base::Progress& progress = {}) const;
    // Second derivatives by one normal, halved: trace of the 3 x 3 block, by the sparse factor.
    [[nodiscard]] base::Array<double> stiffness(const base::Progress& progress = {}) const;

private:
    struct Solver;

    void load(const geometry::VecArray& normal) noexcept;
    double unload(const geometry::VecArray& normal, const double* z, geometry::VecArray& beta) const noexcept;

    const base::Runtime& runtime_;
    HermiteSystem system_;
    Preconditioner preconditioner_;
    base::Array<double> r_;
    base::Array<double> z_;
    std::unique_ptr<Solver> solver_;
};

} // namespace hrbfnpr::fit
