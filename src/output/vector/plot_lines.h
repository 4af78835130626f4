// SPDX-License-Identifier: MIT
// Lines of a group that waits to be sorted, and the steps of sorting: ends that meet are joined, lines wider than their
// pen are filled by several passes, and a tour goes through all.
#pragma once

#include "output/vector/page.h"

namespace hrbfnpr::output {

struct PlotLine {
    std::int64_t first = 0, count = 0; // the range of its points in PlotLines::points
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
        HRBFNPR_ASSERT(line.first >= 0 && line.first + line.count <= points.size());
        return points.span().subspan(static_cast<std::size_t>(line.first), static_cast<std::size_t>(line.count));
    }
    [[nodiscard]] PagePath path_of(const PlotLine& line) const noexcept {
        return {points_of(line), line.begin, line.end, line.closed, line.opacity};
    }
    // Adds a line like another one through these points.
    void add(PlotLine line, std::span<const PagePoint> its) {
        line.first = points.size();
        line.count = static_cast<std::int64_t>(its.size());
        for (const PagePoint& p : its) points.push_back(p);
        lines.push_back(line);
    }

    base::Array<PagePoint> points;
    base::Array<PlotLine> lines;
};

// Replaces the lines by joined ones, in the order of the first of each, and returns the number of joins. An end takes
// the other end that it goes on into best: near, and without a turn. Ends of neighbouring rows of hatching point alike,
// so that they are never joined into a zigzag.
// distance: the most between ends, mm; 0: the thinner line's width. any_opacity: else lines of different opacities stay
// apart.
std::int64_t join_lines(PlotLines& lines, double distance, bool any_opacity, const base::Progress& progress);

// Whether there is room for another pass.
[[nodiscard]] bool is_wider_than(double pen, std::span<const PagePoint> points) noexcept;
// Replaces lines that are wider than their pen by lines that are as wide as it, and returns how many they were. The pen
// goes along the line at even distances, and along its sides; each pass is only where the line is wide enough. Passes
// whose ends are near to each other become one line, drawn to and fro.
std::int64_t fill_lines(PlotLines& lines, double tolerance, const base::Progress& progress);

// A line that is drawn one way or the other, a closed one that begins at any of its points, or a dot: one point.
struct Stop {
    std::span<const PagePoint> points;
    bool closed = false; // the last point stands where the first one does
};
struct Leg {
    std::int32_t stop = 0;
    std::int32_t start = 0; // the point that a closed one begins at
    bool reversed = false;
};
// The order in which a pen goes through all stops from a place, so that it travels little between them; it ends
// anywhere.
[[nodiscard]] base::Array<Leg> find_tour(base::Memory& memory, std::span<const Stop> stops, const glm::dvec2& from,
                                         const base::Progress& progress);

} // namespace hrbfnpr::output
