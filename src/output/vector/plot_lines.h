// SPDX-License-Identifier: MIT
// Lines of a group that waits to be sorted.
#pragma once

#include "base/memory.h"
#include "output/vector/page.h"

namespace hrbfnpr::output {

struct PlotLine {
    std::int64_t first = 0, count = 0; // of its points
    double width = 0.0;                // the pen's, mm
    double opacity = 1.0;
    drawing::Cap begin = drawing::Cap::round, end = drawing::Cap::round;
    bool closed = false;
    bool goes_on = false; // a line of another opacity begins where it ends
};

struct PlotLines {
    explicit PlotLines(base::Memory& memory) noexcept : points(memory), lines(memory) {}

    void clear() noexcept {
        points.clear();
        lines.clear();
    }
    [[nodiscard]] std::span<const PagePoint> points_of(const PlotLine& line) const noexcept {
        return points.span().subspan(static_cast<std::size_t>(line.first), static_cast<std::size_t>(line.count));
    }

    base::Array<PagePoint> points;
    base::Array<PlotLine> lines;
};

[[nodiscard]] inline glm::dvec2 place_of(const PagePoint& p) noexcept { return {p.x, p.y}; }

[[nodiscard]] inline double length_of(std::span<const PagePoint> points) noexcept {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(place_of(points[i - 1]), place_of(points[i]));
    return sum;
}

} // namespace hrbfnpr::output
