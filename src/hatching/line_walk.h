// SPDX-License-Identifier: MIT
// Even places along the lines of a mesh.
#pragma once

#include "hatching/stripe_lines.h"

#include <algorithm>

namespace hrbfnpr::hatching {

// From one point of the lines to the next one.
struct LinePlace {
    std::int64_t from, to;
    double share; // of the way

    [[nodiscard]] glm::dvec3 of(const geometry::VecArray& values) const noexcept {
        return glm::mix(values[from], values[to], share);
    }
    [[nodiscard]] std::uint8_t level(const StripeLines& lines) const noexcept {
        return lines.level[share < 0.5 ? from : to];
    }
};

class LineWalk {
public:
    LineWalk(const StripeLines& lines, std::int64_t line) noexcept
        : lines_(lines), begin_(lines.first[line]), count_(lines.first[line + 1] - begin_),
          pieces_(lines.closed[line] != 0 ? count_ : count_ - 1) {
        for (std::int64_t i = 0; i < pieces_; ++i) length_ += way(i);
    }

    [[nodiscard]] double length() const noexcept { return length_; }

    // Visits steps + 1 places; the last one of a closed line is its first one.
    template <class Visit>
    void visit(std::int64_t steps, Visit&& visit) const {
        std::int64_t i = 0;
        double before = 0.0; // length up to point i
        double length = way(0);
        for (std::int64_t k = 0; k <= steps; ++k) {
            const double wanted = length_ * static_cast<double>(k) / static_cast<double>(steps);
            while (i + 1 < pieces_ && before + length < wanted) {
                before += length;
                length = way(++i);
            }
            const double share = length > 0.0 ? std::clamp((wanted - before) / length, 0.0, 1.0) : 0.0;
            visit(LinePlace{at(i), at(i + 1), share});
        }
    }

private:
    [[nodiscard]] std::int64_t at(std::int64_t i) const noexcept { return begin_ + i % count_; }
    [[nodiscard]] double way(std::int64_t i) const noexcept {
        return glm::distance(lines_.position[at(i)], lines_.position[at(i + 1)]);
    }

    const StripeLines& lines_;
    std::int64_t begin_, count_, pieces_;
    double length_ = 0.0;
};

} // namespace hrbfnpr::hatching
