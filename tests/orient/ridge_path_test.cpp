// SPDX-License-Identifier: MIT
// Tests normals of noisy points over a rising ridge.
#include "orient/noisy_clouds.h"
#include "orient/normals_of_cloud.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace ridge_path_test {

namespace {

using namespace hrbfnpr;
using namespace orient_test;

// A wall 1.5 spacings thick. The deviation of its noise is a fifth of that.
Samples noisy_wall() { return noisy(sheets(14, 1.5), 0.3); }

struct NoisyCloud {
    NoisyCloud(const base::Runtime& runtime, const Samples& samples)
        : cloud(orient::read_cloud(runtime, view(samples.points))), near(runtime, *cloud.tree, 32) {}

    // Returns the share of normals that are right, or the share with all signs flipped if that is larger.
    [[nodiscard]] double right(const Samples& samples, const geometry::VecArray& normal) const {
        double share = 0.0;
        for (std::int64_t i = 0; i < samples.count(); ++i)
            share += glm::dot(at(samples.normals, i), normal[cloud.place[i]]) > 0.0 ? 1.0 : 0.0;
        share /= static_cast<double>(samples.count());
        return std::max(share, 1.0 - share);
    }

    orient::Cloud cloud;
    orient::NeighbourLists near;
};

constexpr double high = 3162.0;
constexpr orient::StartOptions effort{3, false, true};

TEST(RidgePath, SeparatesSheetsThatAHighRidgeMerges) {
    const base::Runtime runtime;
    const Samples wall = noisy_wall();
    const NoisyCloud noisy(runtime, wall);
    const orient::LeastEnergy merged = orient::least_energy(runtime, noisy.cloud, noisy.near, high, nullptr, effort);
    EXPECT_LT(noisy.right(wall, merged.normal), 0.7);
    const orient::RidgeFit found = orient::follow_ridges(runtime, noisy.cloud, noisy.near, high, nullptr, effort);
    EXPECT_GE(noisy.right(wall, found.fitted.normal), 0.97);
}

TEST(RidgePath, IsSteadyOnlyOnRoundShapes) {
    const base::Runtime runtime;
    const NoisyCloud ball(runtime, noisy(test::sphere(300), 0.02));
    const NoisyCloud wall(runtime, noisy_wall());
    const auto steadiness = [&](const NoisyCloud& noisy) {
        return orient::follow_ridges(runtime, noisy.cloud, noisy.near, high, nullptr, effort).steadiness;
    };
    EXPECT_EQ(steadiness(ball), 1.0);
    EXPECT_LT(steadiness(wall), 0.97);
}

TEST(RidgePath, SmoothsDirectionsOnlyWithinOneSide) {
    const base::Runtime runtime;
    const Samples wall = sheets(14, 1.5);
    const NoisyCloud clean(runtime, wall);
    geometry::VecArray normal(runtime.memory, clean.cloud.size());
    for (std::int64_t i = 0; i < wall.count(); ++i) {
        const auto k = static_cast<double>(i);
        const glm::dvec3 askew(0.3 * std::sin(7.0 * k), 0.3 * std::cos(5.0 * k), 0.0);
        normal.set(clean.cloud.place[i], glm::normalize(at(wall.normals, i) + askew));
    }
    const auto angle = [&] {
        geometry::VecArray of_points(runtime.memory, wall.count());
        for (std::int64_t i = 0; i < wall.count(); ++i) of_points.set(i, normal[clean.cloud.place[i]]);
        return score(wall, of_points).angle;
    };
    const double before = angle();
    normal = orient::smooth_directions(runtime, *clean.cloud.tree, clean.near, normal, 1.5);
    EXPECT_LT(angle(), 0.6 * before);
    EXPECT_EQ(clean.right(wall, normal), 1.0);
}

TEST(RidgePath, HasLowConfidenceOnNoisyWalls) {
    const base::Runtime runtime;
    const auto confidence = [&](double deviation) {
        return orient::orient(runtime, input(noisy(sheets(14, 1.5), deviation))).report.confidence;
    };
    EXPECT_GT(confidence(0.0), 0.9);
    EXPECT_LT(confidence(0.3), 0.5);
    EXPECT_LT(confidence(0.5), 0.5);
    EXPECT_LT(confidence(0.9), 0.01);
}

} // namespace

} // namespace ridge_path_test
