// SPDX-License-Identifier: MIT
#include "fit/system.h"

#include "kernel/polynomial.h"
#include "kernel/radial.h"

#include <Eigen/Core>

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

// Samples per block of rows. A block of A for this many samples takes 32 KiB.
constexpr std::int64_t product_samples = 16;

} // namespace

std::int64_t HermiteSystem::terms() const noexcept { return kernel::polynomial_size(options_.degree); }

void HermiteSystem::block(std::int64_t i0, std::int64_t i1, std::int64_t j0, std::int64_t j1, double* out,
                          std::int64_t column_stride) const noexcept {
    kernel::with_kernel(options_.kernel, options_.radius, [&](const auto& kernel) {
        for (std::int64_t j = j0; j < j1; ++j) {
            for (std::int64_t i = i0; i < i1; ++i) {
                const glm::dvec3 d = positions_[i] - positions_[j];
                const double r2 = glm::dot(d, d);
                const kernel::Radial k = kernel.template at<1>(r2, std::sqrt(r2));
                double* column = out + 4 * (i - i0) + 4 * (j - j0) * column_stride;
                column[0] = k.phi;
                for (glm::length_t r = 0; r < 3; ++r) column[1 + r] = k.a * d[r];
                for (glm::length_t c = 0; c < 3; ++c) {
                    column += column_stride;
                    column[0] = -k.a * d[c];
                    for (glm::length_t r = 0; r < 3; ++r) column[1 + r] = -(k.b * d[r] * d[c]);
                    column[1 + c] -= k.a;
                    if (i == j) column[1 + c] += options_.gradient_diagonal;
                }
                if (i == j) column[-3 * column_stride] += options_.value_diagonal;
            }
        }
    });
}

void HermiteSystem::multiply(const base::Parallel& parallel, const double* x, std::int64_t columns, double* y,
                             const base::Progress& progress) const {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
    using Strided = Eigen::OuterStride<>;
    parallel.for_chunks(samples(), product_samples, progress, [&](std::int64_t i0, std::int64_t i1) {
        alignas(64) double tile[16 * product_samples * product_samples];
        const std::int64_t height = 4 * (i1 - i0);
        Eigen::Map<Matrix, 0, Strided> sum(y + 4 * i0, height, columns, Strided(rows()));
        sum.setZero();
        for (std::int64_t j0 = 0; j0 < samples(); j0 += product_samples) {
            const std::int64_t j1 = std::min(samples(), j0 + product_samples);
            const std::int64_t width = 4 * (j1 - j0);
            block(i0, i1, j0, j1, tile, height);
            const Eigen::Map<const Matrix, Eigen::Aligned64> a(tile, height, width);
            const Eigen::Map<const Matrix, 0, Strided> part(x + 4 * j0, width, columns, Strided(rows()));
            if (columns == 1)
                sum.col(0).noalias() += a * part.col(0);
            else
                sum.noalias() += a * part;
        }
    });
}

void HermiteSystem::constraints(double* p) const noexcept {
    kernel::PolynomialBasis basis;
    for (std::int64_t i = 0; i < samples(); ++i) {
        kernel::polynomial_basis(options_.degree, positions_[i], basis);
        for (std::int64_t k = 0; k < terms(); ++k) {
            double* at = p + k * rows() + 4 * i;
            const auto term = static_cast<std::size_t>(k);
            at[0] = basis.value[term];
            for (glm::length_t c = 0; c < 3; ++c) at[1 + c] = basis.gradient[term][c];
        }
    }
}

} // namespace hrbfnpr::fit
