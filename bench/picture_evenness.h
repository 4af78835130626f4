// SPDX-License-Identifier: MIT
// How even stipples are in the picture: the distances of marks to their nearest neighbours, by the angle of the
// surface.
#pragma once

#include "evenness.h"
#include "orbit.h"
#include "painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench {

// Distances to the nearest neighbour, in units of the distance of the densest packing with the wanted ink.
struct Nearest {
    std::vector<double> distance;

    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const double d : distance) sum += d;
        return sum / static_cast<double>(distance.size());
    }
    // The standard deviation, as a share of the mean.
    [[nodiscard]] double variation() const {
        const double m = mean();
        double squares = 0.0;
        for (const double d : distance) squares += (d - m) * (d - m);
        return std::sqrt(squares / static_cast<double>(distance.size())) / m;
    }
    // The distance that 95 % of the marks keep.
    [[nodiscard]] double fifth_percentile() {
        std::sort(distance.begin(), distance.end());
        return distance[distance.size() / 20];
    }
};

// Returns the ink per area with which evenly spread discs have a coverage (docs/how-marks-work.md).
[[nodiscard]] inline double ink_of_coverage(double coverage) {
    return coverage <= 0.375 ? coverage : coverage + 0.08 * (coverage - 0.375);
}

inline constexpr std::array<double, 6> facing_bands = {0.1, 0.3, 0.5, 0.7, 0.9, 1.0};

// Adds the distances of the marks that are drawn with at least half of their area. `ink` is the wanted ink per area.
// Marks whose normals differ by more than 60 degrees are no neighbours.
inline void add_nearest(const hrbfnpr_point_set* set, const hrbfnpr_camera& camera, const std::vector<Disc>& discs,
                        double radius, double ink, std::array<Nearest, 5>& bands) {
    std::int64_t count = 0;
    const float* const position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* const normal = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    const glm::dvec3 origin = glm::make_vec3(info_of(set).origin);
    const Lens lens(camera);
    std::vector<Mark> marks;
    std::vector<double> facing;
    for (const Disc& disc : discs) {
        if (disc.is_paper != 0 || static_cast<double>(disc.radius * disc.radius) < 0.5 * radius * radius) continue;
        const std::size_t mark = disc.id - 1;
        const glm::dvec3 place = origin + glm::dvec3(glm::make_vec3(position + 3 * mark));
        const glm::dvec3 n(glm::make_vec3(normal + 3 * mark));
        marks.push_back({{double{disc.window[0]}, double{disc.window[1]}, 0.0}, {n.x, n.y, n.z}});
        facing.push_back(-lens.facing(place, n));
    }
    const double disc_ink = 3.14159265358979323846 * (radius * radius + 1.0 / 12.0);
    const double packed = std::sqrt(2.0 / std::sqrt(3.0) / (ink / disc_ink));
    const Grid grid(marks, marks.size(), 3.0 * packed);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const auto band = static_cast<std::size_t>(
            std::upper_bound(facing_bands.begin(), facing_bands.end(), facing[i]) - facing_bands.begin());
        if (band == 0 || band == facing_bands.size() ||
            !lens.holds({marks[i].position[0], marks[i].position[1]}, packed))
            continue;
        double nearest = 9.0 * packed * packed;
        grid.around(marks[i].position, [&](std::size_t j) {
            const double x = marks[j].position[0] - marks[i].position[0];
            const double y = marks[j].position[1] - marks[i].position[1];
            if (j != i && same_patch(marks[i], marks[j])) nearest = std::min(nearest, x * x + y * y);
        });
        bands[band - 1].distance.push_back(std::sqrt(nearest) / packed);
    }
}

} // namespace bench
