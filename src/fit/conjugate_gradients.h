// Preconditioned conjugate gradients on the null space of a Hermite system's side constraints.
#pragma once

#include "fit/polynomial_space.h"
#include "fit/preconditioner.h"
#include "fit/product.h"

namespace hrbfnpr::fit {

struct CgOutcome {
    bool converged = false;
    std::int32_t iterations = 0;
    double residual = 0.0;  // relative, of the recursion
    double condition = 0.0; // of the preconditioned matrix, from the recursion's coefficients (Lanczos)
};

class ConjugateGradients {
public:
    ConjugateGradients(const base::Runtime& runtime, HermiteProduct& product, Preconditioner& preconditioner,
                       const PolynomialSpace& polynomials, std::int64_t size);

    // Improves w, orthogonal to the polynomials, until |r| <= tolerance * scale, where r, orthogonal to them too, is
    // the residual of w on entry.  Each iteration's |r| / scale is added to history.
    CgOutcome run(double* w, double* r, double scale, double tolerance, std::int32_t limit,
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
