// SPDX-License-Identifier: MIT
#include "fit/cholesky.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t side = TiledCholesky::side;
constexpr std::int64_t side_limit = std::int64_t{1} << 24; // the largest number of tiles along a side

using Tile = Eigen::Map<Eigen::Matrix<double, side, side>, Eigen::Aligned64>;
using ConstTile = Eigen::Map<const Eigen::Matrix<double, side, side>, Eigen::Aligned64>;
using Part = Eigen::Map<Eigen::Matrix<double, side, 1>>; // a part of the caller's vector, which need not be aligned

[[nodiscard]] std::int64_t tiles_for(std::int64_t size) noexcept { return (size + side - 1) / side; }

[[nodiscard]] bool factor_tile(double* data) noexcept {
    using Dynamic = Eigen::MatrixXd;
    Eigen::Map<Dynamic, Eigen::Aligned64> map(data, side, side);
    Eigen::Ref<Dynamic> tile(map);
    const Eigen::LLT<Eigen::Ref<Dynamic>> factor(tile); // Eigen factors the tile in place.
    if (factor.info() != Eigen::Success) return false;
    return map.diagonal().allFinite(); // LLT does not report NaN
}

} // namespace

TiledCholesky::TiledCholesky(base::Memory& memory, std::int64_t size)
    : size_(size), tiles_(tiles_for(size)), tiles_data_(memory) {
    // The memory is not cleared: clearing on one thread would take as long as assembling the matrix on all threads.
    tiles_data_.reserve(tile_count() * side * side);
}

std::int64_t TiledCholesky::bytes(std::int64_t size) noexcept {
    const std::int64_t tiles = tiles_for(size);
    if (tiles > side_limit) return -1;
    return tiles * (tiles + 1) / 2 * side * side * std::int64_t{sizeof(double)};
}

TiledCholesky::Position TiledCholesky::position(std::int64_t t) noexcept {
    auto i = static_cast<std::int64_t>((std::sqrt(8.0 * static_cast<double>(t) + 1.0) - 1.0) / 2.0);
    while (i * (i + 1) / 2 > t) --i;
    while ((i + 1) * (i + 2) / 2 <= t) ++i;
    return {i, t - i * (i + 1) / 2};
}

double TiledCholesky::norm(const base::Parallel& parallel, const base::Progress& progress) const {
    base::Array<double> sums(tiles_data_.memory(), padded());
    parallel.for_each(tiles_, progress, [&](std::int64_t j) {
        Eigen::Map<Eigen::Matrix<double, side, 1>> sum(sums.data() + j * side);
        for (std::int64_t k = 0; k < j; ++k) sum += ConstTile(tile(j, k)).cwiseAbs().rowwise().sum();
        for (std::int64_t i = j; i < tiles_; ++i) sum += ConstTile(tile(i, j)).cwiseAbs().colwise().sum().transpose();
    });
    return size_ > 0 ? *std::max_element(sums.begin(), sums.begin() + size_) : 0.0;
}

bool TiledCholesky::factor(const base::Parallel& parallel, const base::Progress& progress) {
    for (std::int64_t k = 0; k < tiles_; ++k) {
        // The remaining work is proportional to the cube of the remaining size.
        const double left = static_cast<double>(tiles_ - k) / static_cast<double>(tiles_);
        const double next = static_cast<double>(tiles_ - k - 1) / static_cast<double>(tiles_);
        const base::Progress panel = progress.part(1.0 - left * left * left, 1.0 - next * next * next);
        panel.update(0.0);
        if (!factor_tile(tile(k, k))) return false;
        parallel.for_each(tiles_ - k - 1, [&](std::int64_t i) {
            panel.check();
            ConstTile(tile(k, k))
                .transpose()
                .triangularView<Eigen::Upper>()
                .solveInPlace<Eigen::OnTheRight>(Tile(tile(k + 1 + i, k)));
        });
        update(parallel, k, panel);
    }
    progress.update(1.0);
    return true;
}

// Subtracts the panel's outer product from all tiles to its right.
void TiledCholesky::update(const base::Parallel& parallel, std::int64_t panel, const base::Progress& progress) {
    const std::int64_t left = tiles_ - panel - 1;
    const std::int64_t count = left * (left + 1) / 2;
    parallel.for_each(count, [&](std::int64_t t) {
        if (t % 16 == 0) // Checks for cancellation about every 5 ms.
            progress.update(static_cast<double>(t) / static_cast<double>(count));
        else
            progress.check();
        const Position at = position(t);
        const std::int64_t i = panel + 1 + at.i;
        const std::int64_t j = panel + 1 + at.j;
        Tile(tile(i, j)).noalias() -= ConstTile(tile(i, panel)) * ConstTile(tile(j, panel)).transpose();
    });
}

void TiledCholesky::solve(const base::Parallel& parallel, double* x, const base::Progress& progress) const {
    const auto part = [&](std::int64_t k) { return Part(x + k * side); };
    constexpr std::int64_t grain = 8; // tiles per task: enough work to be worth a thread
    for (std::int64_t k = 0; k < tiles_; ++k) {
        progress.check();
        ConstTile(tile(k, k)).triangularView<Eigen::Lower>().solveInPlace(part(k));
        parallel.for_chunks(tiles_ - k - 1, grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = k + 1 + begin; i < k + 1 + end; ++i)
                part(i).noalias() -= ConstTile(tile(i, k)) * part(k);
        });
    }
    for (std::int64_t k = tiles_ - 1; k >= 0; --k) {
        progress.check();
        ConstTile(tile(k, k)).transpose().triangularView<Eigen::Upper>().solveInPlace(part(k));
        parallel.for_chunks(k, grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t j = begin; j < end; ++j) part(j).noalias() -= ConstTile(tile(k, j)).transpose() * part(k);
        });
    }
}

} // namespace hrbfnpr::fit
