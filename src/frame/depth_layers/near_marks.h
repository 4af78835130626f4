// SPDX-License-Identifier: MIT
// Finds near marks in the picture. All instruction sets give the same marks in the same order.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::frame {

// Marks in cells of the picture, with an element for each mark. A vector may read up to 16 elements beyond the last.
struct MarksInCells {
    const float* x;
    const float* y;
    const float* place;
};

struct MarkInterval {
    std::uint32_t begin, end;
};

struct NearMarks {
    // Writes the indices of the marks in some intervals that are nearer to (x, y) than `reach` and whose place is at
    // most `place`. Returns their number. `found` has room for all marks of the intervals and 16 more.
    std::int64_t (*find)(const MarksInCells& marks, const MarkInterval* intervals, std::int64_t count, float x, float y,
                         float reach, float place, std::uint32_t* found);
};

[[nodiscard]] NearMarks near_marks(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
