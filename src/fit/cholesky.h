// SPDX-License-Identifier: MIT
// A symmetric positive definite matrix, its lower triangle in square tiles that stand one after
// the other in memory, and its Cholesky factor in the same place.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"

#include <cstdint>

namespace hrbfnpr::fit {

class TiledCholesky {
public:
    // Numbers along a tile's side: its multiplications run in the second-level cache, and rows
    // of samples (4 numbers each) are never cut.
    static constexpr std::int64_t side = 128;

    // Not cleared: every tile must be written whole, rows and columns from `size` on, up to the
    // next multiple of `side`, as the identity's.  Throws Error{out_of_memory}.
    TiledCholesky(base::Memory& memory, std::int64_t size);

    // Bytes of the matrix, or -1 if they are beyond any memory.
    [[nodiscard]] static std::int64_t bytes(std::int64_t size) noexcept;

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::int64_t padded() const noexcept { return tiles_ * side; }
    [[nodiscard]] std::int64_t tiles() const noexcept { return tiles_; } // along a side

    // Tile of rows side * i... and columns side * j..., i >= j, column-major.
    [[nodiscard]] double* tile(std::int64_t i, std::int64_t j) noexcept { return tiles_data_.data() + offset(i, j); }
    [[nodiscard]] const double* tile(std::int64_t i, std::int64_t j) const noexcept {
        return tiles_data_.data() + offset(i, j);
    }

    // The tile with the running number t of (0,0), (1,0), (1,1), (2,0), ...
    struct Position {
        std::int64_t i, j;
    };
    [[nodiscard]] static Position position(std::int64_t t) noexcept;
    [[nodiscard]] std::int64_t tile_count() const noexcept { return tiles_ * (tiles_ + 1) / 2; }

    // 1-norm of the matrix, before factor().
    [[nodiscard]] double norm(const base::Parallel& parallel, const base::Progress& progress) const;
    // False if the matrix is not (numerically) positive definite.
    [[nodiscard]] bool factor(const base::Parallel& parallel, const base::Progress& progress);
    // x, padded() long with zeros from size() on, becomes the inverse times x.  After factor().
    void solve(const base::Parallel& parallel, double* x, const base::Progress& progress) const;

private:
    [[nodiscard]] static std::int64_t offset(std::int64_t i, std::int64_t j) noexcept {
        return (i * (i + 1) / 2 + j) * side * side;
    }
    void update(const base::Parallel& parallel, std::int64_t panel, const base::Progress& progress);

    std::int64_t size_;
    std::int64_t tiles_;
    base::Array<double> tiles_data_;
};

} // namespace hrbfnpr::fit
