// SPDX-License-Identifier: MIT
// The energy of a Hermite interpolant as a function of its normals. The positions are fixed, so their matrix is
// factored only once.
//
// The f with f(x_i) = 0 and grad f(x_i) = n_i has the energy n . beta, where beta are its gradient weights. It is a
// quadratic form in the normals, and the right normals give it a low value (Huang, Carr, Ju, "Variational implicit
// point set surfaces", 2019). The sparse factor of the preconditioner turns the energy into a sparse sum of squares,
// which is as accurate as the preconditioned system is near the identity.
#pragma once

#include "base/work.h"
#include "fit/preconditioner.h"

#include <memory>

namespace hrbfnpr::fit {

class HermiteEnergy {
public:
    struct Options {
        // The regularization of values, in cubed spacings: the variance of the noise divided by the variance of f.
        double ridge = 0.0;
        std::int32_t neighbours = 16;
    };

    // The samples are the tree's points, which should be about 1 apart. All vectors below are in the tree's order.
    // `rank` is the index of each point in a farthest-first order. The object keeps a reference to the points of the
    // tree. Throws Error{out_of_memory, cancelled, singular_system}.
    HermiteEnergy(const base::Work& work, const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
                  const Options& options);
    ~HermiteEnergy();
    HermiteEnergy(const HermiteEnergy&) = delete;
    HermiteEnergy& operator=(const HermiteEnergy&) = delete;

    [[nodiscard]] std::int64_t size() const noexcept { return system_.samples(); }

    // Returns the energy, computed with the sparse factor. Writes beta, which is half the derivative of the energy with
    // respect to the normals.
    double approximate_energy(const geometry::VecArray& normal, geometry::VecArray& beta,
                              const base::Progress& progress = {});
    // Returns the energy. Solves by conjugate gradients until the relative residual reaches `tolerance`.
    double accurate_energy(const geometry::VecArray& normal, geometry::VecArray& beta, double tolerance,
                           const base::Progress& progress);

    // The sparse energy is a sum of squared lengths of vectors. Each normal adds a part to some of these vectors; the
    // members hold these parts.
    struct Terms {
        Preconditioner::Blocks blocks;
        base::Array<float> add;         // 4 numbers for each element of blocks.set
        base::Array<double> coarse_add; // the dense block: blocks.coarse_columns numbers for each sample
    };
    [[nodiscard]] Terms terms(const geometry::VecArray& normal, const base::Progress& progress = {}) const;
    // Returns, for each normal, half the trace of the second derivatives of the energy, computed with the sparse
    // factor.
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
