// SPDX-License-Identifier: MIT
// Triharmonic polynomials up to a total degree on the cube [-1, 1]^3, and nodes in the cube. There are as many nodes as
// basis polynomials, so the values at the nodes determine a polynomial. Polynomials are stored as sums of Chebyshev
// products T_a(x) T_b(y) T_c(z) with a + b + c <= degree.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/triharmonic_basis.h"

#include <cstdint>

namespace hrbfnpr::implicit {

class CubeBasis {
public:
    static constexpr int degree_max = 20;

    // The points are taken from a Chebyshev grid by elimination with pivoting, greedily so that their determinant is
    // large (discrete Leja points: Bos, De Marchi, Sommariva, Vianello, SIAM J. Numer. Anal. 48, 2010).
    CubeBasis(const base::Work& work, int degree);

    [[nodiscard]] static constexpr int terms(int degree) noexcept {
        return (degree + 1) * (degree + 2) * (degree + 3) / 6;
    }
    // Rounds a length up to whole SIMD vectors. Rows of matrices and lengths of vectors are padded in this way.
    [[nodiscard]] static constexpr int padded(int terms) noexcept { return (terms + 7) / 8 * 8; }

    [[nodiscard]] int degree() const noexcept { return degree_; }
    // The number of nodes, the number of Chebyshev products, and the padded lengths of vectors for both.
    [[nodiscard]] int size() const noexcept { return triharmonic_size(degree_); }
    [[nodiscard]] int terms() const noexcept { return terms(degree_); }
    [[nodiscard]] int stride() const noexcept { return padded(size()); }
    [[nodiscard]] int term_stride() const noexcept { return padded(terms()); }

    // The nodes. Padding points are at the origin.
    [[nodiscard]] const geometry::VecArray& nodes() const noexcept { return nodes_; }
    // The matrix that maps values at the nodes to coefficients. It is column-major with term_stride() numbers per
    // column.
    [[nodiscard]] const base::Array<double>& to_coefficients() const noexcept { return to_coefficients_; }
    // The transpose of to_coefficients(), with stride() numbers per column.
    [[nodiscard]] const base::Array<double>& to_coefficients_transposed() const noexcept { return transposed_; }

    // Writes all terms T_a(x) T_b(y) T_c(z) at a point, in the order of a, then b, then c.
    static void evaluate(int degree, const glm::dvec3& p, double* terms) noexcept;
    // Returns the matrix that maps values at the nodes of this basis to values at `count` points. It is column-major
    // with padded(count) numbers per column.
    [[nodiscard]] base::Array<double> interpolation(const base::Work& work, const geometry::VecArray& points,
                                                    int count) const;

private:
    void invert(const base::Work& work, const double* factor, std::int64_t factor_stride);
    void transpose(const base::Progress& progress);

    int degree_;
    geometry::VecArray nodes_;
    base::Array<double> to_coefficients_;
    base::Array<double> transposed_;
};

} // namespace hrbfnpr::implicit
