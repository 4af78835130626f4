// SPDX-License-Identifier: MIT
// Interleaved vectors for the functions of cube_loops.h, and the addresses of the results.
#pragma once

#include "base/memory.h"
#include "implicit/cube_loops.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::implicit {

class CubeVectors {
public:
    // A vector has at most `columns` numbers.
    explicit CubeVectors(base::Memory& memory, int columns) : in_(memory, std::int64_t{columns} * cube_batch) {}

    void add(const double* in, int columns, double* out) noexcept {
        for (int k = 0; k < columns; ++k) in_[std::int64_t{k} * cube_batch + count_] = in[k];
        out_[static_cast<std::size_t>(count_++)] = out;
    }
    [[nodiscard]] bool full() const noexcept { return count_ == cube_batch; }
    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const double* in() const noexcept { return in_.data(); }
    // Returns addresses for the results of cube_batch vectors. If there are fewer vectors, the addresses from count()
    // on are `unused`.
    [[nodiscard]] double* const* out(double* unused) noexcept {
        std::fill(out_.begin() + count_, out_.end(), unused);
        return out_.data();
    }
    void clear() noexcept { count_ = 0; }

private:
    base::Array<double> in_;
    std::array<double*, cube_batch> out_{};
    int count_ = 0;
};

} // namespace hrbfnpr::implicit
