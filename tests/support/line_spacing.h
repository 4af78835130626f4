// SPDX-License-Identifier: MIT
// Measures the spacing of the lines in a layer of strokes.
#pragma once

#include "support/point_sets.h"

#include "geometry/point_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::test {

// Sideways distances from marks to the next parallel line on either side, in `unit`. `alone` is the share of sides
// without a line within 2.5 units.
struct Spacing {
    double mean = 0.0, variation = 0.0, alone = 0.0;
};

// Only marks with a true count(i) are measured. beside: how far along a line its neighbour may be looked for. apart:
// marks of the same line count as neighbours from this number of marks apart, for example where the line winds around;
// 0: never.
struct SpacingSettings {
    double unit = 1.0;
    double beside = 0.0;
    std::int64_t apart = 0;
};

template <class Count>
Spacing spacing_of(const Layer& marks, const SpacingSettings& settings, Count&& count_mark) {
    geometry::VecArray points(runtime().memory);
    std::vector<std::int64_t> mark;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        if (!count_mark(i)) continue;
        points.push_back(vec(marks.position, i));
        mark.push_back(i);
    }
    const geometry::PointTree tree(points, {});
    double sum = 0.0, squares = 0.0, count = 0.0, none = 0.0;
    for (std::int64_t at = 0; at < tree.size(); at += 3) {
        const std::int64_t i = mark[static_cast<std::size_t>(tree.index(at))];
        const glm::dvec3 n = vec(marks.normal, i);
        const glm::dvec3 d = vec(marks.direction, i);
        std::array<double, 2> nearest{1e300, 1e300};
        tree.within(tree.points()[at], 2.5 * settings.unit, [&](std::int64_t other_at, double squared) {
            const std::int64_t j = mark[static_cast<std::size_t>(tree.index(other_at))];
            const bool same = marks.stroke[2 * i] == marks.stroke[2 * j];
            if (same && (settings.apart == 0 || std::abs(i - j) < settings.apart)) return;
            const glm::dvec3 offset = tree.points()[other_at] - tree.points()[at];
            if (glm::dot(n, vec(marks.normal, j)) < 0.0 || std::abs(glm::dot(offset, d)) > settings.beside) return;
            if (std::abs(glm::dot(d, vec(marks.direction, j))) < 0.7071) return;
            double& side = nearest[glm::dot(glm::cross(n, d), offset) > 0.0 ? 1 : 0];
            side = std::min(side, std::sqrt(squared));
        });
        for (const double distance : nearest) {
            if (distance > 1e200) {
                none += 1.0;
                continue;
            }
            sum += distance / settings.unit;
            squares += distance * distance / (settings.unit * settings.unit);
            count += 1.0;
        }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean) / mean, none / (none + count)};
}

} // namespace hrbfnpr::test
