// SPDX-License-Identifier: MIT
#include "fit/null_space_solver.h"

#include "fit/condition.h"

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t tile_side = TiledCholesky::side;
constexpr std::int64_t samples_per_tile = tile_side / 4;

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd>;

[[nodiscard]] TiledCholesky make_matrix(base::Memory& memory, const NullSpace& space) {
    const std::int64_t bytes = TiledCholesky::bytes(space.free());
    try {
        if (bytes < 0) fail(Status::out_of_memory, "more than memory can hold");
        return {memory, space.free()};
    } catch (const Error&) {
        fail(Status::out_of_memory,
             "points: the direct solver needs a dense system of %lld samples, %lld bytes, but the allocator has too "
             "little memory; use fewer samples",
             static_cast<long long>(space.rows() / 4), static_cast<long long>(bytes));
    }
}

} // namespace

NullSpaceSolver::NullSpaceSolver(const base::Work& work, const HermiteSystem& system)
    : runtime_(work), space_(work.memory, system), cholesky_(make_matrix(work.memory, space_)),
      border_(work.memory, space_.rows() * space_.terms()) {
    assemble(system, work);
}

// With Q = I - V T V^T and Y = A V T, the matrix B = Q^T A Q is A minus a product of low rank:
//   B = A - X V^T - V X^T,   X = Y - V (T^T V^T Y) / 2.
// So each tile of B is made on its own, and A is never stored.
void NullSpaceSolver::assemble(const HermiteSystem& system, const base::Progress& progress) {
    const std::int64_t rows = space_.rows();
    const std::int64_t terms = space_.terms();
    base::Array<double> x_data(runtime_.memory, rows * terms);
    if (terms > 0) {
        system.multiply(runtime_.parallel, space_.v().data(), terms, x_data.data(), progress);
        NullSpace::Columns x(x_data.data(), rows, terms);
        NullSpace::Small g(terms, terms);
        for (std::int64_t i = 0; i < rows; ++i) { // x = x T, in place
            const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, NullSpace::terms_max> row = x.row(i);
            x.row(i).noalias() = row * space_.t();
        }
        for (std::int64_t k = 0; k < terms; ++k)
            for (std::int64_t l = 0; l < terms; ++l) g(k, l) = space_.v().col(k).dot(x.col(l));
        g = (0.5 * (space_.t().transpose() * g)).eval();
        for (std::int64_t k = 0; k < terms; ++k)
            for (std::int64_t l = 0; l < terms; ++l) x.col(k) -= g(l, k) * space_.v().col(l);
    }
    progress.update(0.5);
    runtime_.parallel.for_each(cholesky_.tile_count(), progress, [&](std::int64_t t) {
        const TiledCholesky::Position at = TiledCholesky::position(t);
        assemble_tile(system, x_data.data(), at.i, at.j);
    });
    if (terms > 0) assemble_border(system, x_data.data());
    norm_ = cholesky_.norm(runtime_.parallel, progress);
    progress.update(1.0);
}

void NullSpaceSolver::assemble_tile(const HermiteSystem& system, const double* x_data, std::int64_t i, std::int64_t j) {
    double* tile = cholesky_.tile(i, j);
    const std::int64_t samples = system.samples();
    system.block(i * samples_per_tile, std::min(samples, (i + 1) * samples_per_tile), j * samples_per_tile,
                 std::min(samples, (j + 1) * samples_per_tile), tile, tile_side);
    const std::int64_t height = std::min(space_.rows() - i * tile_side, tile_side);
    const std::int64_t width = std::min(space_.rows() - j * tile_side, tile_side);
    if (space_.terms() > 0) {
        const ConstMatrix x(x_data, space_.rows(), space_.terms());
        const NullSpace::ConstColumns v = space_.v();
        Matrix map(tile, height, width, Eigen::OuterStride<>(tile_side));
        map.noalias() -= x.middleRows(i * tile_side, height) * v.middleRows(j * tile_side, width).transpose();
        map.noalias() -= v.middleRows(i * tile_side, height) * x.middleRows(j * tile_side, width).transpose();
    }
    // The fixed rows and columns are not part of the factored matrix. Rows and columns of the identity take their
    // places.
    const std::int64_t free_height = std::clamp<std::int64_t>(space_.free() - i * tile_side, 0, tile_side);
    const std::int64_t free_width = std::clamp<std::int64_t>(space_.free() - j * tile_side, 0, tile_side);
    Matrix whole(tile, tile_side, tile_side, Eigen::OuterStride<>(tile_side));
    whole.bottomRows(tile_side - free_height).setZero();
    whole.rightCols(tile_side - free_width).setZero();
    if (i == j) whole.diagonal().tail(tile_side - free_height).setOnes();
}

void NullSpaceSolver::assemble_border(const HermiteSystem& system, const double* x_data) {
    const std::int64_t rows = space_.rows();
    const std::int64_t terms = space_.terms();
    const std::int64_t first = space_.free() / 4; // the first sample that has fixed rows
    base::Array<double> columns(runtime_.memory, rows * (rows - 4 * first));
    runtime_.parallel.for_chunks(system.samples(), samples_per_tile, [&](std::int64_t begin, std::int64_t end) {
        system.block(begin, end, first, system.samples(), columns.data() + 4 * begin, rows);
    });
    const ConstMatrix x(x_data, rows, terms);
    const NullSpace::ConstColumns v = space_.v();
    NullSpace::Columns border(border_.data(), rows, terms);
    for (std::int64_t k = 0; k < terms; ++k) {
        const std::int64_t at = rows - 1 - k;
        border.col(k) = Eigen::Map<const Eigen::VectorXd>(columns.data() + (at - 4 * first) * rows, rows);
        for (std::int64_t l = 0; l < terms; ++l) {
            border.col(k) -= v(at, l) * x.col(l);
            border.col(k) -= x(at, l) * v.col(l);
        }
    }
}

bool NullSpaceSolver::factor(const base::Progress& progress) { return cholesky_.factor(runtime_.parallel, progress); }

// In Q's coordinates w = Q (z, u), with h = Q^T r for the first rows r of the right-hand side, and s for its last:
//   R^T u = s,   B_zz z = h_z - B_zu u,   R c = h_u - B_uz z - B_uu u.
void NullSpaceSolver::solve(double* x, const base::Progress& progress) const {
    const std::int64_t rows = space_.rows();
    const std::int64_t free = space_.free();
    const std::int64_t terms = space_.terms();
    const ConstMatrix border(border_.data(), rows, terms);
    Eigen::Map<Eigen::VectorXd> c(x + rows, terms);
    NullSpace::Vector u = c;
    space_.r().transpose().triangularView<Eigen::Lower>().solveInPlace(u);

    space_.apply_transposed(x);
    base::Array<double> w_data(runtime_.memory, std::max(rows, cholesky_.padded()));
    Eigen::Map<Eigen::VectorXd> w(w_data.data(), rows);
    w.head(free) = Eigen::Map<const Eigen::VectorXd>(x, free);
    for (std::int64_t k = 0; k < terms; ++k) w.head(free) -= u[k] * border.col(k).head(free);
    cholesky_.solve(runtime_.parallel, w_data.data(), progress);
    for (std::int64_t k = 0; k < terms; ++k) w[rows - 1 - k] = u[k];

    NullSpace::Vector rest(terms);
    for (std::int64_t k = 0; k < terms; ++k) rest[k] = x[rows - 1 - k] - border.col(k).dot(w);
    space_.r().triangularView<Eigen::Upper>().solveInPlace(rest);
    c = rest;
    space_.apply(w_data.data());
    std::copy_n(w_data.data(), rows, x);
}

double NullSpaceSolver::condition(const base::Progress& progress) const {
    base::Array<double> x(runtime_.memory, cholesky_.padded());
    return norm_ * inverse_norm(cholesky_.size(), x.data(),
                                [&](double* v) { cholesky_.solve(runtime_.parallel, v, progress); });
}

} // namespace hrbfnpr::fit
