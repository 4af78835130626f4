// SPDX-License-Identifier: MIT
// Vectors that stand side by side for cube_loops, and where the results go.
#pragma once

#include "base/memory.h"
#include "implicit/cube_loops.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::implicit {

class CubeVectors {
public:
    // Of up to `columns` numbers each.
    explicit CubeVectors(base::Memory& memory, int columns) : in_(memory, std::int64_t{columns} * cube_batch) {}

    void add(const double* in, int columns, double* out) noexcept {
        for (int k = 0; k < columns; ++k) in_[std::int64_t{k} * cube_batch + count_] = in[k];
        out_[static_cast<std::size_t>(count_++)] = out;
    }
    [[nodiscard]] bool full() const noexcept { return count_ == cube_batch; }
    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const double* in() const noexcept { return in_.data(); }
    // The places beyond count() are written where nobody looks.
    [[nodiscard]] double* const* out(double* nobody) noexcept {
        std::fill(out_.begin() + count_, out_.end(), nobody);
        return out_.data();
    }
    void clear() noexcept { count_ = 0; }

private:
    base::Array<double> in_;
    std::array<double*, cube_batch> out_{};
    int count_ = 0;
};

} // namespace hrbfnpr::implicit
