// SPDX-License-Identifier: MIT
// All ways to take maxima and minima of a few functions, each once.
#pragma once

#include "base/memory.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::mesh {

// Those of 1 to `most` functions: 1, 2, 8, 52 and 472 of them (series-parallel networks: MacMahon 1890).  As programs
// of implicit::PiecesData: numbers of functions, larger, smaller.
class ReadOnceTrees {
public:
    static constexpr std::int32_t most = 5;

    explicit ReadOnceTrees(base::Memory& memory);

    [[nodiscard]] std::int64_t count(std::int32_t functions) const noexcept {
        return first_[functions + 1] - first_[functions];
    }
    [[nodiscard]] std::span<const std::int32_t> program(std::int32_t functions, std::int64_t tree) const noexcept;

private:
    base::Array<std::int64_t> first_; // tree of each number of functions
    base::Array<std::int64_t> begin_; // of each tree in code_, and the end
    base::Array<std::int32_t> code_;
};

} // namespace hrbfnpr::mesh
