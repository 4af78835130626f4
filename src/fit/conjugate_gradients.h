// SPDX-License-Identifier: MIT
// Preconditioned conjugate gradients on the null space of a Hermite system's side constraints.
#pragma once

#include "fit/polynomial_space.h"
#include "fit/preconditioner.h"
#include "fit/product.h"

namespace hrbfnpr::fit {

struct CgOutcome {
    bool converged = false;
    std::int32_t iterations = 0;
    double residual = 0.0;  // the relative residual that the iterations update
    double condition = 0.0; // the condition number of the preconditioned matrix, estimated from Lanczos' coefficients
};

// The state that the iterations improve: w, c and r = h - A w - P c. Both w and r are orthogonal to the polynomials.
struct CgState {
    double* w;
    double* r;
    double* c;
};

class ConjugateGradients {
public:
    ConjugateGradients(const base::Runtime& runtime, HermiteProduct& product, Preconditioner& preconditioner,
                       const PolynomialSpace& polynomials, std::int64_t size);

    // Iterates until |r| <= tolerance * scale, or until `limit` iterations are done. Appends |r| / scale of each
    // iteration to `history`.
    CgOutcome run(const CgState& state, double scale, double tolerance, std::int32_t limit,
                  base::Array<double>& history, const base::Progress& progress);

private:
    [[nodiscard]] double dot(const double* a, const double* b);

    const base::Runtime& runtime_;
    HermiteProduct& product_;
    Preconditioner& preconditioner_;
    const PolynomialSpace& polynomials_;
    std::int64_t size_;
    base::Array<double> z_;
    base::Array<double> p_;
    base::Array<double> ap_;
    base::Array<double> sums_;
};

} // namespace hrbfnpr::fit
