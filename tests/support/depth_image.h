// SPDX-License-Identifier: MIT
// An image by a depth camera of a ball in front of a wall, with the exact values.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace hrbfnpr::test {

struct SeenDepths {
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    std::vector<double> points;  // packed, row by row
    std::vector<double> truth;   // exact z
    std::vector<double> normals; // normals that face the camera
};

// The errors of the camera: 1 / z has a normal error and is rounded to steps.
struct DepthSensor {
    double noise = 0.0;
    double step = 0.0;
    double side = 1.0; // the side that the camera looks to: the sign of z
};

// A ball in front of a slanting wall, z = 3 + 0.3 x - 0.2 y. One corner of the image is missing.
inline SeenDepths seen_depths(std::int32_t columns, std::int32_t rows, const DepthSensor& sensor = {}) {
    SeenDepths image{columns, rows, {}, {}, {}};
    std::mt19937_64 random(1);
    std::normal_distribution<double> error;
    const double focal_length = 0.8 * columns;
    const std::array<double, 3> centre{0.1, 0.0, 2.0};
    constexpr double radius = 0.5;
    for (std::int32_t row = 0; row < rows; ++row)
        for (std::int32_t column = 0; column < columns; ++column) {
            const double u = (column - 0.5 * columns) / focal_length;
            const double v = (row - 0.5 * rows) / focal_length;
            double z = 3.0 / (1.0 - 0.3 * u + 0.2 * v);
            std::array<double, 3> n{0.3, -0.2, -1.0};
            const double a = u * u + v * v + 1.0;
            const double b = u * centre[0] + v * centre[1] + centre[2];
            const double c = centre[0] * centre[0] + centre[1] * centre[1] + centre[2] * centre[2] - radius * radius;
            if (b * b > a * c) {
                z = (b - std::sqrt(b * b - a * c)) / a;
                n = {u * z - centre[0], v * z - centre[1], z - centre[2]};
            }
            double seen = 1.0 / z + sensor.noise * error(random);
            if (sensor.step > 0.0) seen = sensor.step * std::round(seen / sensor.step);
            const double length = std::hypot(n[0], n[1], n[2]);
            const bool hidden = column < columns / 8 && row < rows / 8;
            for (const double direction : {u, v, 1.0})
                image.points.push_back(hidden ? std::numeric_limits<double>::quiet_NaN()
                                              : sensor.side * direction / seen);
            image.truth.push_back(sensor.side * z);
            for (const double each : n) image.normals.push_back(sensor.side * each / length);
        }
    return image;
}

} // namespace hrbfnpr::test
