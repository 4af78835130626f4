// SPDX-License-Identifier: MIT
// Hidden parts of contours that nobody would take for hidden.  A face that is seen edge-on is not quite flat where it
// is fitted: it turns to and fro along its edge, and a bulge a tenth of a pixel high hides some of it.
#pragma once

#include "base/memory.h"
#include "frame/lines/width_laws.h"

namespace hrbfnpr::frame {

class HuggingParts {
public:
    HuggingParts(base::Memory& memory, const LineInput& input);

    // Of the widest lines, pixels: what is small in a picture is small beside that.
    [[nodiscard]] double width() const noexcept { return width_; }
    // Whether an interval of lines is hidden, short, of a contour of a surface with creases, and all of it so near to a
    // contour that is seen that it belongs to that.
    [[nodiscard]] bool has(std::int64_t interval) const noexcept { return !hugs_.empty() && hugs_[interval] != 0; }

private:
    [[nodiscard]] bool is_contour(const visibility::Interval& interval) const noexcept;
    [[nodiscard]] bool may_hug(const visibility::Interval& interval) const noexcept;
    // Calls f for places along an interval.
    template <class F>
    void walk(const visibility::Interval& interval, F&& f) const;
    [[nodiscard]] bool is_beside(const glm::dvec2& place) const noexcept;

    const LineInput& input_;
    double width_ = 0.0;
    base::Array<glm::dvec2> seen_;   // places of contours, by x
    base::Array<std::uint8_t> hugs_; // of each interval; empty: none does
};

} // namespace hrbfnpr::frame
