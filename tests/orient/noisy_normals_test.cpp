// SPDX-License-Identifier: MIT
// Tests normals of noisy clouds: means where the surface is smooth, and walls with correct sides.
#include "orient/noisy_clouds.h"
#include "shapes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

namespace noisy_normals_test {

namespace {

using namespace hrbfnpr;
using namespace orient_test;

geometry::VecArray unpacked(const base::Runtime& runtime, const std::vector<double>& packed) {
    geometry::VecArray result(runtime.memory);
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(packed.size() / 3); ++i) result.push_back(at(packed, i));
    return result;
}

// A cloud and its present normals, in the tree's order.
struct Found {
    Found(const base::Runtime& runtime, const Samples& samples, const std::vector<double>& normals)
        : tree(unpacked(runtime, samples.points), base::Progress()), normal(runtime.memory, tree.size()) {
        for (std::int64_t k = 0; k < tree.size(); ++k) normal.set(k, at(normals, tree.index(k)));
    }
    void refine(const base::Runtime& runtime) { orient::refine_noisy(runtime, tree, normal); }
    [[nodiscard]] Score score_of(const base::Runtime& runtime, const Samples& samples) const {
        geometry::VecArray given(runtime.memory, tree.size());
        for (std::int64_t k = 0; k < tree.size(); ++k) given.set(tree.index(k), normal[k]);
        return score(samples, given);
    }

    geometry::PointTree tree;
    geometry::VecArray normal;
};

// Turns directions by about 20 degrees.
std::vector<double> shaken(const std::vector<double>& normals) {
    Samples some;
    some.points = normals;
    some.normals = normals;
    std::vector<double> result = noisy(some, 0.25).points;
    for (std::size_t i = 0; i < result.size(); i += 3) {
        const double length = std::hypot(result[i], result[i + 1], result[i + 2]);
        for (std::size_t c = 0; c < 3; ++c) result[i + c] /= length;
    }
    return result;
}

TEST(NoisyNormals, AreAveragedOnSmoothSurfaces) {
    const base::Runtime runtime = test::with_threads(2);
    const Samples ball = noisy(test::sphere(1000), 0.03);
    Found found(runtime, ball, shaken(ball.normals));
    const double before = found.score_of(runtime, ball).angle;
    found.refine(runtime);
    EXPECT_GT(before, 15.0);
    EXPECT_LT(found.score_of(runtime, ball).angle, 0.35 * before);
}

// A roof of many ridges, each slope eight spacings wide, that bend by 100 degrees. Its normals are right.
TEST(NoisyNormals, DoNotMixFacesThatAreApart) {
    const base::Runtime runtime = test::with_threads(2);
    constexpr int width = 8;
    const double slope = std::tan(50.0 / 57.29577951308232);
    Samples roof;
    for (int i = 0; i < 6 * width; ++i)
        for (int j = 0; j < 30; ++j) {
            const double along = i % (2 * width) + 0.5;
            const double up = along < width ? 1.0 : -1.0;
            const double length = std::hypot(slope, 1.0);
            roof.add({1.0 * i, 1.0 * j, slope * (up > 0.0 ? along : 2.0 * width - along)},
                     {-slope * up / length, 0.0, 1.0 / length});
        }
    Found found(runtime, roof, roof.normals);
    found.refine(runtime);
    EXPECT_LT(found.score_of(runtime, roof).angle, 1e-5);
}

TEST(NoisyNormals, FollowTheirNearestFace) {
    const base::Runtime runtime = test::with_threads(2);
    const Samples wall = noisy(sheets(24, 1.5), 0.2);
    std::vector<double> normals = shaken(wall.normals);
    for (std::size_t i = 0; i < normals.size(); i += 3 * 17)
        for (std::size_t c = 0; c < 3; ++c) normals[i + c] *= -1.0;
    Found found(runtime, wall, normals);
    EXPECT_LT(found.score_of(runtime, wall).right, 0.945);
    found.refine(runtime);
    EXPECT_GT(found.score_of(runtime, wall).right, 0.995);
}

} // namespace

} // namespace noisy_normals_test
