// SPDX-License-Identifier: MIT
// Clouds with known normals, and the share of the normals found that are right.
#pragma once

#include "orient/orient.h"
#include "support/samples.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace orient_test {

using hrbfnpr::test::Samples;

inline hrbfnpr::base::InView view(const std::vector<double>& packed) {
    return {reinterpret_cast<const std::byte*>(packed.data()), static_cast<std::int64_t>(packed.size() / 3), 24,
            hrbfnpr::base::Scalar::float64, 3};
}

inline glm::dvec3 at(const std::vector<double>& packed, std::int64_t i) {
    const auto k = static_cast<std::size_t>(3 * i);
    return {packed[k], packed[k + 1], packed[k + 2]};
}

struct Score {
    double right = 0.0; // share of the points
    double angle = 0.0; // mean angle between the lines, in degrees
};

inline Score score(const Samples& samples, const hrbfnpr::geometry::VecArray& normal) {
    Score result;
    for (std::int64_t i = 0; i < samples.count(); ++i) {
        const double cosine = glm::dot(at(samples.normals, i), glm::normalize(normal[i]));
        result.right += cosine > 0.0 ? 1.0 : 0.0;
        result.angle += std::acos(std::fmin(1.0, std::abs(cosine))) * 57.29577951308232;
    }
    result.right /= static_cast<double>(samples.count());
    result.angle /= static_cast<double>(samples.count());
    return result;
}

// Two wavy sheets of a grid, `gap` spacings apart and shifted by half a spacing. The outside is above one sheet and
// below the other.
inline Samples sheets(int side, double gap) {
    Samples samples;
    for (const double up : {1.0, -1.0})
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const double x = i + (up > 0.0 ? 0.5 : 0.0) + 0.17 * std::sin(12.9 * i + 4.1 * j);
                const double y = j + (up > 0.0 ? 0.5 : 0.0) + 0.17 * std::sin(7.3 * i + 9.7 * j);
                const double k = 6.0 / side;
                const double a = 2.0 * std::cos(k * x);
                const glm::dvec3 n = glm::normalize(glm::dvec3(-k * a, 0.0, 1.0)) * up;
                samples.add({x, y, 2.0 * std::sin(k * x) + 0.5 * up * gap}, {n.x, n.y, n.z});
            }
    return samples;
}

// One sheet: z = height(x, y) over a jittered grid.
inline Samples terrain(int side) {
    Samples samples;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double x = i + 0.2 * std::sin(12.9 * i + 4.1 * j);
            const double y = j + 0.2 * std::sin(7.3 * i + 9.7 * j);
            const double k = 10.0 / side;
            const glm::dvec3 n = glm::normalize(glm::dvec3(-k * std::cos(k * x), k * std::sin(k * y), 1.0));
            samples.add({x, y, std::sin(k * x) + std::cos(k * y)}, {n.x, n.y, n.z});
        }
    return samples;
}

// Adds noise that is nearly normally distributed, in the unit of the points.
inline Samples noisy(Samples samples, double deviation) {
    std::uint64_t state = 1;
    for (double& x : samples.points) {
        double sum = -6.0;
        for (int k = 0; k < 12; ++k) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            sum += static_cast<double>(state >> 11U) / 9007199254740992.0;
        }
        x += deviation * sum;
    }
    return samples;
}

inline hrbfnpr::orient::OrientInput input(const Samples& samples) {
    hrbfnpr::orient::OrientInput result;
    result.points = view(samples.points);
    result.mode = hrbfnpr::orient::NormalMode::none;
    return result;
}

} // namespace orient_test
