// SPDX-License-Identifier: MIT
#include "implicit/hrbf.h"

#include "implicit/hermite_hessians.h"
#include "implicit/hermite_sums.h"
#include "implicit/hrbf_block.h"
#include "kernel/polynomial.h"
#include "kernel/radial.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

struct Centre {
    double x, y, z;
    double alpha;
    double beta_x, beta_y, beta_z;
};

// Adds one centre's term of equation 1 and its derivatives up to `order`:
//   f    += alpha phi - a q                           with d = point - centre, q = beta . d
//   grad += (alpha a - b q) d - a beta
//   H    += (alpha a - b q) I + (alpha b - c q) d d^T - b (beta d^T + d beta^T)
// Every point goes through the same operations, whatever points are beside it in the block.
template <int order, class Kernel>
void add_centre(const Kernel& kernel, const Centre& centre, std::int64_t count, Block& block) noexcept {
    for (std::int64_t i = 0; i < count; ++i) {
        const double dx = block.x[i] - centre.x;
        const double dy = block.y[i] - centre.y;
        const double dz = block.z[i] - centre.z;
        const double r2 = dx * dx + dy * dy + dz * dz;
        const kernel::Radial k = kernel.template at<order>(r2, std::sqrt(r2));
        const double q = centre.beta_x * dx + centre.beta_y * dy + centre.beta_z * dz;
        block.value[i] += centre.alpha * k.phi - k.a * q;
        if constexpr (order >= 1) {
            const double along = centre.alpha * k.a - k.b * q;
            block.gradient[0][i] += along * dx - k.a * centre.beta_x;
            block.gradient[1][i] += along * dy - k.a * centre.beta_y;
            block.gradient[2][i] += along * dz - k.a * centre.beta_z;
        }
        if constexpr (order >= 2) {
            const double along = centre.alpha * k.a - k.b * q;
            const double outer = centre.alpha * k.b - k.c * q;
            const double bx = k.b * centre.beta_x;
            const double by = k.b * centre.beta_y;
            const double bz = k.b * centre.beta_z;
            block.hessian[0][i] += along + outer * (dx * dx) - 2.0 * (bx * dx);
            block.hessian[1][i] += outer * (dx * dy) - (bx * dy + by * dx);
            block.hessian[2][i] += outer * (dx * dz) - (bx * dz + bz * dx);
            block.hessian[3][i] += along + outer * (dy * dy) - 2.0 * (by * dy);
            block.hessian[4][i] += outer * (dy * dz) - (by * dz + bz * dy);
            block.hessian[5][i] += along + outer * (dz * dz) - 2.0 * (bz * dz);
        }
    }
}

template <int order, class Kernel>
void evaluate_blocks(const HrbfData& data, const Kernel& kernel, const PointBatch& points,
                     const FieldBatch& fields) noexcept {
    Block block;
    for (std::int64_t begin = 0; begin < points.count; begin += block_size) {
        const std::int64_t count = std::min(block_size, points.count - begin);
        start(data, slice(points, begin, begin + count), block);
        for (std::int64_t j = 0; j < data.count(); ++j) {
            const Centre centre{data.centre_position.x[j],
                                data.centre_position.y[j],
                                data.centre_position.z[j],
                                data.alpha[j],
                                data.beta.x[j],
                                data.beta.y[j],
                                data.beta.z[j]};
            add_centre<order>(kernel, centre, count, block);
        }
        finish(data, block, count, fields.from(begin));
    }
}

} // namespace

void start(const HrbfData& data, const PointBatch& points, Block& block) noexcept {
    for (std::int64_t i = 0; i < points.count; ++i) {
        block.x[i] = normalised(points.x[i], data.centre.x, data.scale);
        block.y[i] = normalised(points.y[i], data.centre.y, data.scale);
        block.z[i] = normalised(points.z[i], data.centre.z, data.scale);
        const kernel::PolynomialField p =
            kernel::polynomial(data.polynomial_degree, data.polynomial.data(), {block.x[i], block.y[i], block.z[i]});
        block.value[i] = p.value;
        block.gradient[0][i] = p.gradient.x;
        block.gradient[1][i] = p.gradient.y;
        block.gradient[2][i] = p.gradient.z;
        for (std::size_t c = 0; c < 6; ++c) block.hessian[c][i] = p.hessian[c];
    }
}

void finish(const HrbfData& data, const Block& block, std::int64_t count, const FieldBatch& fields) noexcept {
    if (fields.value != nullptr)
        for (std::int64_t i = 0; i < count; ++i) fields.value[i] = data.scale * block.value[i];
    if (fields.wants_gradient())
        for (std::size_t c = 0; c < 3; ++c) std::copy_n(block.gradient[c], count, fields.gradient[c]);
    if (fields.wants_hessian())
        for (std::size_t c = 0; c < 6; ++c)
            for (std::int64_t i = 0; i < count; ++i) fields.hessian[c][i] = block.hessian[c][i] / data.scale;
}

std::int64_t HrbfData::bytes() const noexcept {
    return sample_position.bytes() + sample_normal.bytes() + centre_position.bytes() + beta.bytes() + alpha.bytes() +
           polynomial.bytes();
}

void evaluate(const HrbfData& data, const PointBatch& points, const FieldBatch& fields) noexcept {
    kernel::with_kernel(data.kernel, data.kernel_radius, [&](const auto& kernel) {
        if (fields.wants_hessian())
            evaluate_blocks<2>(data, kernel, points, fields);
        else if (fields.wants_gradient())
            evaluate_blocks<1>(data, kernel, points, fields);
        else
            evaluate_blocks<0>(data, kernel, points, fields);
    });
}

// The bits of value and gradient do not depend on whether a Hessian is wanted.
void evaluate(base::InstructionSet set, const HrbfData& data, const PointBatch& points,
              const FieldBatch& fields) noexcept {
    const Sources sources = sources_of(data);
    Block block;
    double(&g)[3][block_size] = block.gradient;
    double(&h)[6][block_size] = block.hessian;
    for (std::int64_t begin = 0; begin < points.count; begin += block_size) {
        const std::int64_t count = std::min(block_size, points.count - begin);
        start(data, slice(points, begin, begin + count), block);
        if (fields.value != nullptr || fields.wants_gradient())
            hermite_sums(set, data.kernel)(data.kernel_radius, sources,
                                           {block.x, block.y, block.z, block.value, g[0], g[1], g[2], count});
        if (fields.wants_hessian())
            hermite_hessians(set, data.kernel)(
                data.kernel_radius, sources, {block.x, block.y, block.z, {h[0], h[1], h[2], h[3], h[4], h[5]}, count});
        finish(data, block, count, fields.from(begin));
    }
}

void Hrbf::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    implicit::evaluate(set_, data_, points, fields);
}

} // namespace hrbfnpr::implicit
