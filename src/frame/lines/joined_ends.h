// SPDX-License-Identifier: MIT
// Which ends of lines that end at others go on there: a contour that comes out of a crease too weak to be drawn, and
// turns back as the crease hidden behind it, begins like one at a cusp.
#pragma once

#include "base/memory.h"
#include "frame/lines/hugging_parts.h"

#include <span>

namespace hrbfnpr::frame {

class JoinedEnds {
public:
    JoinedEnds(base::Memory& memory, const LineInput& input, const HuggingParts& hugging);

    // Of an open line of a subject that is `joined`, at its begin or its end: whether it is hidden there, or another
    // one is seen there as well.
    [[nodiscard]] bool goes_on(std::int32_t line, bool at_end) const noexcept {
        return goes_on_[2 * std::int64_t{line} + (at_end ? 1 : 0)] != 0;
    }

private:
    struct End {
        glm::dvec2 place; // pixels
        std::int64_t number;
        bool contour, seen;
    };
    void add(const LineInput& input, const HuggingParts& hugging, std::int32_t line, std::int64_t first,
             std::int64_t last);
    [[nodiscard]] bool meets_another(std::int64_t end) const noexcept;

    double together_;                   // pixels
    base::Array<End> ends_;             // by x
    base::Array<std::uint8_t> goes_on_; // two of each line
};

} // namespace hrbfnpr::frame
