// SPDX-License-Identifier: MIT
// A symmetric positive definite matrix and its Cholesky factor, which replaces it in memory. The square tiles of the
// lower triangle are stored one after the other.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"

#include <cstdint>

namespace hrbfnpr::fit {

class TiledCholesky {
public:
    // The number of rows of a tile. Products of two tiles run in the second-level cache, and the 4 rows of a sample are
    // never split between tiles.
    static constexpr std::int64_t side = 128;

    // The memory is not cleared: the caller must write all elements of every tile. Rows and columns from `size` on, up
    // to the next multiple of `side`, must be those of the identity matrix. Throws Error{out_of_memory}.
    TiledCholesky(base::Memory& memory, std::int64_t size);

    // Returns the bytes of the matrix, or -1 if no memory could hold it.
    [[nodiscard]] static std::int64_t bytes(std::int64_t size) noexcept;

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::int64_t padded() const noexcept { return tiles_ * side; }
    [[nodiscard]] std::int64_t tiles() const noexcept { return tiles_; } // the number of tiles along a side

    // Returns tile (i, j), i >= j, in column-major order. Its first row is side * i and its first column side * j.
    [[nodiscard]] double* tile(std::int64_t i, std::int64_t j) noexcept { return tiles_data_.data() + offset(i, j); }
    [[nodiscard]] const double* tile(std::int64_t i, std::int64_t j) const noexcept {
        return tiles_data_.data() + offset(i, j);
    }

    // The row and column of tile t. Tiles are numbered row by row: (0,0) is 0, (1,0) is 1, (1,1) is 2.
    struct Position {
        std::int64_t i, j;
    };
    [[nodiscard]] static Position position(std::int64_t t) noexcept;
    [[nodiscard]] std::int64_t tile_count() const noexcept { return tiles_ * (tiles_ + 1) / 2; }

    // Returns the 1-norm of the matrix. Call it before factor().
    [[nodiscard]] double norm(const base::Parallel& parallel, const base::Progress& progress) const;
    // Returns false if the matrix is not positive definite up to rounding.
    [[nodiscard]] bool factor(const base::Parallel& parallel, const base::Progress& progress);
    // Replaces x by the matrix's inverse times x. x has padded() elements, with zeros from size() on. Call it after
    // factor().
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
