// SPDX-License-Identifier: MIT
#include "implicit/shape_source.h"

#include "implicit/hermite_thirds.h"
#include "implicit/hrbf_block.h"
#include "implicit/sheets.h"
#include "kernel/polynomial.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

constexpr auto shape_batch = static_cast<std::size_t>(batch_size);

// The index of hessian[j][k] in the order xx xy xz yy yz zz.
constexpr std::array<std::array<std::size_t, 3>, 3> second_index = {{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};

// The axes of each third derivative, in the order xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
constexpr std::array<std::array<std::size_t, 3>, 10> axes = {
    {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 1}, {0, 1, 2}, {0, 2, 2}, {1, 1, 1}, {1, 1, 2}, {1, 2, 2}, {2, 2, 2}}};

} // namespace

HrbfShape::HrbfShape(base::InstructionSet set, const HrbfData& data, double smoothing) noexcept
    : set_(set), data_(data), smoothing_(0.0) {
    if (data.kernel == kernel::Kind::gaussian) return;
    // A single sample has no spacing. The scale replaces it.
    const double unit = data.spacing > 0.0 ? data.spacing / data.scale : 1.0;
    smoothing_ = smoothing * unit * (smoothing * unit);
}

// f = scale g, so Hess f = Hess g / scale, and third derivatives are divided by scale^2.
void HrbfShape::evaluate(const PointBatch& points, const ThirdBatch& out) const {
    const AddHermiteThirds add = hermite_thirds(set_, data_.kernel);
    const std::array<double, 10> constant = kernel::polynomial_thirds(data_.polynomial_degree, data_.polynomial.data());
    const double scale2 = data_.scale * data_.scale;
    Block block;
    double third[10][block_size];
    for (std::int64_t begin = 0; begin < points.count; begin += block_size) {
        const std::int64_t count = std::min(block_size, points.count - begin);
        start(data_, slice(points, begin, begin + count), block);
        ThirdTargets targets{block.x, block.y, block.z, {}, {}, count};
        for (std::size_t c = 0; c < 6; ++c) targets.hessian[c] = block.hessian[c];
        for (std::size_t c = 0; c < 10; ++c) {
            std::fill_n(third[c], count, constant[c]);
            targets.third[c] = third[c];
        }
        add(data_.kernel_radius, smoothing_, sources_of(data_), targets);
        for (std::size_t c = 0; c < 6; ++c)
            std::transform(block.hessian[c], block.hessian[c] + count, out.hessian[c] + begin,
                           [&](double h) { return h / data_.scale; });
        for (std::size_t c = 0; c < 10; ++c)
            std::transform(third[c], third[c] + count, out.third[c] + begin, [&](double t) { return t / scale2; });
    }
}

// If the implicit function has creases, differences at a point are computed on the point's sheet, because differences
// across a crease are meaningless.
void DifferencedShape::evaluate(const PointBatch& points, const ThirdBatch& out) const {
    for (std::int64_t begin = 0; begin < points.count; begin += block_size) {
        ThirdBatch part = out;
        for (double*& column : part.hessian) column += begin;
        for (double*& column : part.third) column += begin;
        const PointBatch block = slice(points, begin, std::min(points.count, begin + block_size));
        if (implicit_.sheets() == nullptr)
            evaluate_block(implicit_, block, part);
        else
            evaluate_by_sheet(*implicit_.sheets(), block, part);
    }
}

// Evaluates sequences of consecutive points on the same sheet. Neighbouring points are mostly on the same sheet.
void DifferencedShape::evaluate_by_sheet(const Sheets& sheets, const PointBatch& points, const ThirdBatch& out) const {
    std::array<std::int32_t, static_cast<std::size_t>(block_size)> active;
    sheets.active(points, active.data());
    for (std::int64_t begin = 0, end = 0; begin < points.count; begin = end) {
        const std::int32_t sheet = active[static_cast<std::size_t>(begin)];
        while (end < points.count && active[static_cast<std::size_t>(end)] == sheet) ++end;
        ThirdBatch part = out;
        for (double*& column : part.hessian) column += begin;
        for (double*& column : part.third) column += begin;
        evaluate_block(OneSheet(implicit_, sheets, sheet), slice(points, begin, end), part);
    }
}

// T_ijk is the mean of three differences: along i of H_jk, along j of H_ik, and along k of H_ij. There are at most
// block_size points, because a caller's function runs on the same small stack.
void DifferencedShape::evaluate_block(const Implicit& implicit, const PointBatch& points, const ThirdBatch& out) const {
    constexpr auto most = static_cast<std::size_t>(block_size);
    std::array<std::array<double, most>, 6> hessian;
    std::array<std::array<double, most>, 3> at;
    FieldBatch moved;
    for (std::size_t c = 0; c < 6; ++c) moved.hessian[c] = hessian[c].data();
    FieldBatch here;
    here.hessian = out.hessian;
    implicit.evaluate(points, here);
    for (double* component : out.third) std::fill_n(component, points.count, 0.0);
    const std::array<const double*, 3> from = {points.x, points.y, points.z};
    for (std::size_t c = 0; c < 3; ++c) std::copy_n(from[c], points.count, at[c].begin());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i)
                at[axis][i] = from[axis][i] + sign * step_;
            implicit.evaluate({at[0].data(), at[1].data(), at[2].data(), points.count}, moved);
            const double weight = sign / (6.0 * step_);
            for (std::size_t c = 0; c < 10; ++c)
                for (std::size_t k = 0; k < 3; ++k) {
                    if (axes[c][k] != axis) continue;
                    const std::array<double, most>& h =
                        hessian[second_index[axes[c][(k + 1) % 3]][axes[c][(k + 2) % 3]]];
                    for (std::int64_t i = 0; i < points.count; ++i)
                        out.third[c][i] += weight * h[static_cast<std::size_t>(i)];
                }
        }
        std::copy_n(from[axis], points.count, at[axis].begin());
    }
}

void ScaledShape::evaluate(const PointBatch& points, const ThirdBatch& out) const {
    std::array<std::array<double, shape_batch>, 3> at;
    const std::array<const double*, 3> from = {points.x, points.y, points.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::transform(from[axis], from[axis] + points.count, at[axis].begin(), [&](double x) { return unit_ * x; });
    unscaled_.evaluate({at[0].data(), at[1].data(), at[2].data(), points.count}, out);
    for (double* h : out.hessian)
        for (std::int64_t i = 0; i < points.count; ++i) h[i] *= unit_;
    for (double* t : out.third)
        for (std::int64_t i = 0; i < points.count; ++i) t[i] *= unit_ * unit_;
}

} // namespace hrbfnpr::implicit
