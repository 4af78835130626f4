// SPDX-License-Identifier: MIT
// An orthonormal basis of the polynomials at the samples. It makes vectors orthogonal to the polynomials, and finds the
// polynomial that explains a residual best.
#pragma once

#include "base/work.h"
#include "fit/system.h"

#include <Eigen/Core>

#include <array>

namespace hrbfnpr::fit {

// Vectors have 4 numbers per sample, in the order of HermiteSystem.
class PolynomialSpace {
public:
    static constexpr int terms_max = 20;

    // Computes P = Q R by Cholesky's factor of P^T P, taken twice (CholeskyQR2: Fukaya and others 2014), after scaling
    // P's columns. Throws Error{invalid_argument} if the samples do not determine the polynomial.
    PolynomialSpace(const base::Work& work, const HermiteSystem& system);

    [[nodiscard]] std::int64_t terms() const noexcept { return terms_; }

    // x -= Q Q^T x
    void make_orthogonal(double* x) const;
    // Finds the polynomial nearest to x, adds its coefficients to c, and subtracts it from x.
    void subtract_best_polynomial(double* x, double* c) const;
    // Returns the value and gradient of the polynomial P c at one sample.
    [[nodiscard]] std::array<double, 4> at(std::int64_t sample, const double* c) const noexcept;

private:
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, terms_max, terms_max>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, terms_max, 1>;

    void orthonormalise();
    [[nodiscard]] Vector components(const double* x) const;
    void subtract(const Vector& components, double* x) const;

    const base::Runtime& runtime_;
    std::int64_t rows_;
    std::int64_t terms_;
    base::Array<double> q_; // rows_ x terms_, column-major
    Small r_;
};

} // namespace hrbfnpr::fit
