// SPDX-License-Identifier: MIT
// The distances between the strokes of a set.
#pragma once

#include "calls.h"
#include "evenness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace bench {

struct Spacing {
    double mean, variation, alone; // in separations; alone: the share of sides without a stroke within 2.5
};

struct SpacingSettings {
    double separation;
    double beside; // neighbours are searched up to this far along the stroke, in separations
    // Marks of one stroke count as neighbours if they are at least this many marks apart, for example where the stroke
    // winds round; 0: never.
    std::size_t apart;
};

// Measures the only layer of a set: from each seventh mark sideways to the next stroke that is parallel (within 45
// degrees), in separations.
[[nodiscard]] inline Spacing run_spacing(const hrbfnpr_point_set* set, const SpacingSettings& settings) {
    const double separation = settings.separation;
    std::int64_t count = 0;
    const float* position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* normal = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    const float* direction = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION, count);
    const std::uint32_t* stroke = attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE, count);
    const auto vec = [](const float* a, std::size_t i) { return Vec3{a[3 * i], a[3 * i + 1], a[3 * i + 2]}; };
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        marks.push_back({vec(position, i), vec(normal, i)});
    const double farthest = 2.5 * separation;
    const bench::Grid grid(marks, marks.size(), farthest);
    std::vector<double> gaps;
    double alone = 0.0;
    for (std::size_t i = 0; i < marks.size(); i += 7) {
        const Vec3 d = vec(direction, i);
        const Vec3 side = bench::cross(marks[i].normal, d);
        double nearest[2] = {farthest, farthest};
        grid.around(marks[i].position, [&](std::size_t other) {
            const std::size_t apart = other > i ? other - i : i - other;
            if (stroke[2 * other] == stroke[2 * i] && (settings.apart == 0 || apart < settings.apart)) return;
            if (bench::dot(marks[i].normal, marks[other].normal) < 0.0) return;
            if (std::abs(bench::dot(d, vec(direction, other))) < 0.7071) return;
            const Vec3 between = marks[other].position - marks[i].position;
            const double across = bench::dot(between, side);
            if (std::abs(bench::dot(between, d)) > settings.beside * separation) return;
            double& gap = nearest[across > 0.0 ? 1 : 0];
            gap = std::min(gap, std::abs(across));
        });
        for (const double gap : nearest)
            if (gap < farthest)
                gaps.push_back(gap / separation);
            else
                alone += 1.0;
    }
    const auto n = static_cast<double>(gaps.size());
    const double mean = std::accumulate(gaps.begin(), gaps.end(), 0.0) / n;
    double squares = 0.0;
    for (const double gap : gaps) squares += (gap - mean) * (gap - mean);
    return {mean, std::sqrt(squares / n) / mean, alone / (alone + n)};
}

} // namespace bench
