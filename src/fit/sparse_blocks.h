// SPDX-License-Identifier: MIT
// Products with the preconditioner's sparse factor L, whose blocks are 4 x 4.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::fit {

// Column block i has set_size blocks. Their rows are set[i * set_size + k], and their numbers begin at factor[(i *
// set_size + k) * 16], row-major. The column block is empty if set[i * set_size] < 0. The blocks of row block j have
// the indices use[use_begin[j]] to use[use_begin[j + 1] - 1].
struct SparseFactor {
    std::int64_t set_size;
    const std::int32_t* set;
    const float* factor;
    const std::int64_t* use_begin;
    const std::int64_t* use;
};

struct SparseBlocks {
    // These functions compute t = L^T r and z = L t for the blocks [begin, end) of the result.
    void (*multiply_transposed)(const SparseFactor& factor, std::int64_t begin, std::int64_t end, const double* r,
                                double* t);
    void (*multiply)(const SparseFactor& factor, std::int64_t begin, std::int64_t end, const double* t, double* z);
};

[[nodiscard]] SparseBlocks sparse_blocks(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::fit
