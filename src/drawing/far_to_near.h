// SPDX-License-Identifier: MIT
// Far-to-near order: a stable radix sort.
#pragma once

#include "base/bits.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <cstdint>

namespace hrbfnpr::drawing {

// A 64-bit key: in the upper half the depth, ascending from far to near; in the lower half the number of the thing.
[[nodiscard]] inline std::uint64_t far_first_key(float depth, std::uint32_t what) noexcept {
    const auto bits = base::bit_cast<std::uint32_t>(depth);
    // The usual map of floats to integers of the same order, then turned round.
    const std::uint32_t ascending = (bits >> 31U) != 0 ? ~bits : bits | 0x80000000U;
    return std::uint64_t{~ascending} << 32U | what;
}

// Sorts by the upper halves; equal ones stay in their order.  The same for any thread count.
class FarToNear {
public:
    explicit FarToNear(base::Memory& memory) noexcept : other_(memory), histogram_(memory) {}
    void sort(const base::Parallel& parallel, base::Array<std::uint64_t>& keys);
    [[nodiscard]] std::int64_t bytes() const noexcept { return other_.bytes() + histogram_.bytes(); }

private:
    bool pass(const base::Parallel& parallel, const base::Array<std::uint64_t>& from, base::Array<std::uint64_t>& to,
              unsigned shift);

    base::Array<std::uint64_t> other_;
    base::Array<std::int64_t> histogram_; // chunk by chunk, for each digit
};

} // namespace hrbfnpr::drawing
