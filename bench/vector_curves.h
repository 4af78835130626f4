// SPDX-License-Identifier: MIT
// Curves of an SVG against the lines that they replace: how many points they need, and how far off they are.
#pragma once

#include "drawn_stroke.h"
#include "timing.h"
#include "vector_page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bench {

// A path of an SVG that is one line.
struct CurveLine {
    PageLine fine;          // many points along it
    std::size_t points = 0; // the number of points that define it: ends and handles
    bool closed = false;
};

// Reads path data as our SVG has it: M, then c and l with relative coordinates, then perhaps z.
[[nodiscard]] inline CurveLine read_curve(std::string_view data) {
    constexpr int parts = 64; // per curve
    CurveLine line;
    PagePlace from{};
    char command = ' ';
    for (std::size_t at = 0; at < data.size();) {
        if (data[at] == 'M' || data[at] == 'c' || data[at] == 'l' || data[at] == 'z') command = data[at++];
        if (command == 'z') {
            line.closed = true;
            break;
        }
        const std::size_t count = command == 'c' ? 3 : 1;
        PagePlace to[3]{};
        for (std::size_t i = 0; i < count; ++i) {
            if (!next_number(data, at, to[i].x) || !next_number(data, at, to[i].y)) return line;
            if (command != 'M') to[i] = {from.x + to[i].x, from.y + to[i].y};
        }
        line.points += count;
        for (int k = 1; command == 'c' && k < parts; ++k) {
            const double t = static_cast<double>(k) / parts, s = 1.0 - t;
            const double b0 = s * s * s, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t, b3 = t * t * t;
            line.fine.push_back({b0 * from.x + b1 * to[0].x + b2 * to[1].x + b3 * to[2].x,
                                 b0 * from.y + b1 * to[0].y + b2 * to[1].y + b3 * to[2].y});
        }
        from = to[count - 1];
        line.fine.push_back(from);
    }
    return line;
}

[[nodiscard]] inline double distance_to(const PagePlace& p, const PagePlace& a, const PagePlace& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Returns the greatest distance of places on `line` from `other`.
[[nodiscard]] inline double farthest_from(const PageLine& line, const PageLine& other, int between) {
    double most = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k <= between; ++k) {
            const double t = static_cast<double>(k) / between;
            const PagePlace p{line[i - 1].x + t * (line[i].x - line[i - 1].x),
                              line[i - 1].y + t * (line[i].y - line[i - 1].y)};
            double least = 1e300;
            for (std::size_t j = 1; j < other.size(); ++j)
                least = std::min(least, distance_to(p, other[j - 1], other[j]));
            most = std::max(most, least);
        }
    return most;
}

// Finds the part of a stroke that a path replaces, from the path's two ends, which are exact.
class StrokeParts {
public:
    explicit StrokeParts(const std::vector<PageLine>& strokes) : strokes_(strokes) {
        for (std::size_t s = 0; s < strokes.size(); ++s)
            for (std::size_t i = 0; i < strokes[s].size(); ++i)
                places_.emplace(key(strokes[s][i]), std::pair<std::size_t, std::size_t>{s, i});
    }
    // Returns nothing if there is no such part.
    [[nodiscard]] PageLine part(const CurveLine& line) const {
        const auto [first, last] = places_.equal_range(key(line.fine.front()));
        for (auto from = first; from != last; ++from) {
            const auto [stroke, begin] = from->second;
            const PageLine& points = strokes_[stroke];
            if (line.closed) return points;
            for (std::size_t end = begin + 1; end < points.size(); ++end)
                if (key(points[end]) == key(line.fine.back()))
                    return {points.begin() + static_cast<std::ptrdiff_t>(begin),
                            points.begin() + static_cast<std::ptrdiff_t>(end) + 1};
        }
        return {};
    }

private:
    // In thousandths of a millimetre, the precision of files.
    [[nodiscard]] static std::uint64_t key(const PagePlace& p) {
        const auto whole = [](double mm) { return static_cast<std::uint64_t>(std::floor(1000.0 * mm + 0.5)); };
        return whole(p.x) << 32U ^ whole(p.y);
    }
    const std::vector<PageLine>& strokes_;
    std::unordered_multimap<std::uint64_t, std::pair<std::size_t, std::size_t>> places_;
};

struct CurveFigures {
    std::size_t control_points = 0, vertices = 0, straight = 0; // straight: vertices of the straight lines for plotters
    double error = 0.0;                                         // mm, the greater of both directions
    std::size_t unknown = 0;                                    // paths without a matching stroke
};

// Compares a drawing of lines, without their widths.
[[nodiscard]] inline CurveFigures compare_curves(hrbfnpr_context* context, Page page,
                                                 const std::vector<PageLine>& strokes) {
    auto pen = scenes::made(hrbfnpr_pen_init);
    pen.width = 5.0; // wider than any line, so that each is drawn once
    page.pens = &pen;
    page.pen_count = 1;
    page.flags = HRBFNPR_PAGE_WITHOUT_PAPER;
    page.format = HRBFNPR_PAGE_FORMAT_SVG;
    const std::string svg = page.text(context);
    CurveFigures figures;
    const StrokeParts parts(strokes);
    for (const std::string_view data : path_data(svg)) {
        const CurveLine curve = read_curve(data);
        const PageLine line = parts.part(curve);
        figures.unknown += line.empty() ? 1U : 0U;
        if (line.empty()) continue;
        figures.control_points += curve.points;
        figures.vertices += line.size();
        figures.error =
            std::max({figures.error, farthest_from(curve.fine, line, 1), farthest_from(line, curve.fine, 8)});
    }
    page.format = HRBFNPR_PAGE_FORMAT_HPGL;
    page.join = page.shortest = 1e-6;
    const hrbfnpr_page_info plotted = page.write(context);
    figures.straight = static_cast<std::size_t>(plotted.segments + plotted.paths);
    return figures;
}

} // namespace bench
