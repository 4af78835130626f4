// SPDX-License-Identifier: MIT
// The lines of a group that is to be sorted, and the steps of sorting: ends that meet are joined, lines wider than
// their pen are filled by several passes, and all lines are ordered in a tour.
#pragma once

#include "output/vector/page.h"

namespace hrbfnpr::output {

struct PlotLine {
    std::int64_t first = 0, count = 0; // the range of its points in PlotLines::points
    double width = 0.0;                // the width of the pen, mm
    double opacity = 1.0;
    drawing::Cap begin = drawing::Cap::round, end = drawing::Cap::round;
    bool closed = false;
    bool goes_on = false; // a line of another opacity continues at its end
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
    // Adds a line through the points `its`. The other attributes are copied from `line`.
    void add(PlotLine line, std::span<const PagePoint> its) {
        line.first = points.size();
        line.count = static_cast<std::int64_t>(its.size());
        for (const PagePoint& p : its) points.push_back(p);
        lines.push_back(line);
    }

    base::Array<PagePoint> points;
    base::Array<PlotLine> lines;
};

// Joins lines at their ends, and returns the number of joins. Joined lines are ordered by their first lines. An end is
// joined to the near end that continues it with the least turn. Lines of hatching in adjacent rows point the same way,
// so they are never joined into a zigzag. `distance` is the greatest distance between joined ends in mm; 0 means the
// thinner line's width. If `any_opacity` is false, lines of different opacities are not joined.
std::int64_t join_lines(PlotLines& lines, double distance, bool any_opacity, const base::Progress& progress);

// Returns whether the line needs more than one pass of the pen.
[[nodiscard]] bool is_wider_than(double pen, std::span<const PagePoint> points) noexcept;
// Replaces lines that are wider than their pen by lines of the pen's width. Returns the number of replaced lines. The
// passes are evenly spaced, and the outermost two follow the sides of the line. Each pass exists only where the line is
// wide enough. Passes whose ends are close are joined into one line, drawn back and forth.
std::int64_t fill_lines(PlotLines& lines, double tolerance, const base::Progress& progress);

// A stop of a tour: an open line that may be drawn either way, a closed line that may start at any point, or a dot (one
// point).
struct Stop {
    std::span<const PagePoint> points;
    bool closed = false; // the last point repeats the first
};
struct Leg {
    std::int32_t stop = 0;
    std::int32_t start = 0; // the index of the point at which a closed line starts
    bool reversed = false;
};
// Finds a short tour of the pen through all stops. The tour starts at `from`, and may end anywhere.
[[nodiscard]] base::Array<Leg> find_tour(base::Memory& memory, std::span<const Stop> stops, const glm::dvec2& from,
                                         const base::Progress& progress);

} // namespace hrbfnpr::output
