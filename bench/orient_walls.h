// SPDX-License-Identifier: MIT
// The thickness of the wall that a sample is on: noise merges both sides of a thin wall into a single band.
#pragma once

#include "near_points.h"
#include "orient_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bench {

// Returns for each clean sample how far along its normal, either way, the nearest sample lies that faces the other way
// and is at most 1.5 spacings aside; infinite if none is within `most`.
inline std::vector<double> wall_thickness(const Samples& clean, double most) {
    constexpr double aside = 1.5;
    constexpr double faces_away = -0.3; // cosine
    constexpr std::size_t ring = 6;
    const auto count = static_cast<std::size_t>(clean.count());
    const double extent = diagonal_of(clean);
    const NearPoints near(clean.points, std::max(0.5 * most, extent / 40.0));
    std::vector<double> thickness(count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < count; ++i) {
        const double* const place = clean.points.data() + 3 * i;
        const double* const normal = clean.normals.data() + 3 * i;
        std::vector<double> distances;
        for (double reach = most; distances.size() <= ring && reach < 2.0 * extent; reach *= 2.0) {
            distances.clear();
            near.visit(place, reach, [&](std::size_t, double distance) {
                distances.push_back(distance);
                return true;
            });
        }
        std::sort(distances.begin(), distances.end());
        double spacing = 0.0; // nearest distances without the sample itself
        for (std::size_t k = 1; k <= ring && k < distances.size(); ++k) spacing += distances[k] / ring;
        near.visit(place, most + aside * spacing, [&](std::size_t other, double distance) {
            double height = 0.0;
            double cosine = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                height += (clean.points[3 * other + c] - place[c]) * normal[c];
                cosine += clean.normals[3 * other + c] * normal[c];
            }
            const double sideways = std::sqrt(std::max(0.0, distance * distance - height * height));
            if (cosine < faces_away && sideways < aside * spacing && std::abs(height) < most)
                thickness[i] = std::min(thickness[i], std::abs(height));
            return true;
        });
    }
    return thickness;
}

} // namespace bench
