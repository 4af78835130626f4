// SPDX-License-Identifier: MIT
#include "fit/lu.h"

#include "fit/condition.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t panel_columns = 64;
constexpr std::int64_t samples_per_task = 16;

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Vector = Eigen::Map<Eigen::VectorXd>;

} // namespace

DenseLu::DenseLu(const base::Work& work, const HermiteSystem& system)
    : runtime_(work), size_(system.unknowns()), matrix_(work.memory), pivot_(work.memory) {
    matrix_.resize(size_ * size_);
    pivot_.resize(size_);
    assemble(system, work.part(0.0, 0.1));
    factor(work.part(0.1, 1.0));
}

void DenseLu::assemble(const HermiteSystem& system, const base::Progress& progress) {
    runtime_.parallel.for_chunks(system.samples(), samples_per_task, progress,
                                 [&](std::int64_t begin, std::int64_t end) {
                                     system.block(0, system.samples(), begin, end, column(4 * begin), size_);
                                 });
    const std::int64_t rows = system.rows();
    base::Array<double> p(runtime_.memory, rows * system.terms());
    system.constraints(p.data());
    for (std::int64_t k = 0; k < system.terms(); ++k) {
        for (std::int64_t i = 0; i < rows; ++i) {
            column(rows + k)[i] = p[k * rows + i];
            column(i)[rows + k] = p[k * rows + i];
        }
    }
    for (std::int64_t j = 0; j < size_; ++j) norm_ = std::max(norm_, Vector(column(j), size_).lpNorm<1>());
}

void DenseLu::factor(const base::Progress& progress) {
    for (std::int64_t begin = 0; begin < size_; begin += panel_columns) {
        const double left = static_cast<double>(size_ - begin) / static_cast<double>(size_);
        progress.update(1.0 - left * left * left);
        const std::int64_t end = std::min(size_, begin + panel_columns);
        factor_panel(begin, end, progress);
        update(begin, end, progress);
    }
}

// Factors the columns [begin, end) below row `begin`.
void DenseLu::factor_panel(std::int64_t begin, std::int64_t end, const base::Progress& progress) {
    for (std::int64_t k = begin; k < end; ++k) {
        progress.check();
        double* pivots = column(k);
        std::int64_t best = k;
        for (std::int64_t i = k + 1; i < size_; ++i)
            if (std::abs(pivots[i]) > std::abs(pivots[best])) best = i;
        if (!(std::abs(pivots[best]) > 0.0))
            fail(Status::singular_system, "the system is singular; use regularization > 0, a smaller kernel_radius, or "
                                          "polynomial_degree >= 1 with the triharmonic kernel");
        pivot_[k] = best;
        for (std::int64_t j = begin; j < end; ++j) std::swap(column(j)[k], column(j)[best]);
        const std::int64_t below = size_ - k - 1;
        Vector l(pivots + k + 1, below);
        l /= pivots[k];
        for (std::int64_t j = k + 1; j < end; ++j) Vector(column(j) + k + 1, below) -= column(j)[k] * l;
    }
}

// Exchanges the panel's rows in all other columns, and updates the columns to its right.
void DenseLu::update(std::int64_t begin, std::int64_t end, const base::Progress& progress) {
    const std::int64_t width = end - begin;
    const std::int64_t below = size_ - end;
    const Eigen::OuterStride<> stride(size_);
    runtime_.parallel.for_chunks(size_ - width, panel_columns, progress, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t other = first; other < last; ++other) {
            double* data = column(other < begin ? other : other + width);
            for (std::int64_t k = begin; k < end; ++k) std::swap(data[k], data[pivot_[k]]);
        }
        const std::int64_t from = std::max(first, begin);
        if (from >= last) return;
        Matrix top(column(from + width) + begin, width, last - from, stride);
        Matrix(column(begin) + begin, width, width, stride).triangularView<Eigen::UnitLower>().solveInPlace(top);
        Matrix(column(from + width) + end, below, last - from, stride).noalias() -=
            Matrix(column(begin) + end, below, width, stride) * top;
    });
}

void DenseLu::solve(double* x, const base::Progress& progress) const {
    progress.check();
    for (std::int64_t k = 0; k < size_; ++k) std::swap(x[k], x[pivot_[k]]);
    const Eigen::Map<const Eigen::MatrixXd> lu(matrix_.data(), size_, size_);
    Vector map(x, size_);
    lu.triangularView<Eigen::UnitLower>().solveInPlace(map);
    lu.triangularView<Eigen::Upper>().solveInPlace(map);
}

double DenseLu::condition(const base::Progress& progress) const {
    base::Array<double> x(runtime_.memory, size_);
    return norm_ * inverse_norm(size_, x.data(), [&](double* v) { solve(v, progress); });
}

} // namespace hrbfnpr::fit
