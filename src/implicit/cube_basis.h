// Polynomials of a total degree on the cube [-1, 1]^3: Chebyshev products T_a(x) T_b(y) T_c(z), a + b + c <= degree,
// and as many points in the cube at which values determine them.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"

#include <cstdint>

namespace hrbfnpr::implicit {

class CubeBasis {
public:
    static constexpr int degree_max = 20;

    // The points are taken from a Chebyshev grid by elimination with pivoting, greedily so that their determinant is
    // large (discrete Leja points: Bos, De Marchi, Sommariva, Vianello, SIAM J. Numer. Anal. 48, 2010).
    CubeBasis(const base::Runtime& runtime, int degree, const base::Progress& progress);

    [[nodiscard]] static constexpr int terms(int degree) noexcept {
        return (degree + 1) * (degree + 2) * (degree + 3) / 6;
    }
    // Rows of matrices and lengths of vectors are padded to whole vectors.
    [[nodiscard]] static constexpr int padded(int terms) noexcept { return (terms + 7) / 8 * 8; }

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] int size() const noexcept { return terms(degree_); }
    [[nodiscard]] int stride() const noexcept { return padded(size()); }

    // The points; what pads them is at the origin.
    [[nodiscard]] const geometry::VecArray& nodes() const noexcept { return nodes_; }
    // Values at the nodes to coefficients, column-major with columns of stride(); and its transpose.
    [[nodiscard]] const base::Array<double>& to_coefficients() const noexcept { return inverse_; }
    [[nodiscard]] const base::Array<double>& to_coefficients_transposed() const noexcept { return inverse_transposed_; }

    // All terms at a point, in the order of a, then b, then c.
    static void evaluate(int degree, const glm::dvec3& p, double* terms) noexcept;
    // The matrix that takes values at this basis' nodes to values at `count` points, column-major with columns of
    // padded(count).
    [[nodiscard]] base::Array<double> interpolation(const base::Runtime& runtime, const geometry::VecArray& points,
                                                    int count) const;

private:
    void invert(const base::Runtime& runtime, const double* factor, std::int64_t stride);

    int degree_;
    geometry::VecArray nodes_;
    base::Array<double> inverse_;
    base::Array<double> inverse_transposed_;
};

} // namespace hrbfnpr::implicit
