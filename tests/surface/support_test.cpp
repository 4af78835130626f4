// SPDX-License-Identifier: MIT
#include "surface/support.h"

#include "support/half_samples.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrbfnpr::surface::support_test {
namespace {

using test::PartSamples;

constexpr int whole = 1000;
const double spacing = std::sqrt(4.0 * 3.141592653589793 / whole);

Support support_of(const base::Runtime& runtime, const PartSamples& samples) {
    return {runtime, PartSamples::unpacked(runtime.memory, samples.points),
            PartSamples::unpacked(runtime.memory, samples.normals), 0.0};
}

glm::dvec3 on_sphere(double z, double turn) {
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

// Returns how far beyond the last samples the support reaches the limit, in spacings.
double end_of(const Support& support, double limit, double turn) {
    double low = 0.5 * 3.141592653589793; // angle from the z axis; the samples end at a right angle
    double high = 3.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        const glm::dvec3 p = on_sphere(std::cos(middle), turn);
        (support.value(p, p) <= limit ? low : high) = middle;
    }
    return (low - 0.5 * 3.141592653589793) / spacing;
}

TEST(Support, IsLowAmongSamplesAndHighBeyond) {
    const base::Runtime runtime = test::with_threads(2);
    const Support support = support_of(runtime, test::sphere_cap(whole, 0.0));
    EXPECT_EQ(support.samples(), whole / 2);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = on_sphere(0.1 + 0.85 * i / 200.0, 1.7 * i);
        EXPECT_LT(support.value(p, 3.0 * p), 1.0) << i;       // gradients may have any length
        EXPECT_GT(support.value(p, -p), 5.0) << i;            // samples face the other way
        EXPECT_GT(support.value(2.0 * p, 2.0 * p), 5.0) << i; // away from the samples
    }
    for (int i = 0; i < 60; ++i) {
        const double tight = end_of(support, 1.5, 0.1 * i);
        const double wide = end_of(support, 3.0, 0.1 * i);
        EXPECT_TRUE(tight > 0.1 && tight < 1.1) << tight;
        EXPECT_TRUE(wide > tight + 0.1 && wide < 1.6) << wide;
    }
}

TEST(Support, SlopesMatchDifferences) {
    const base::Runtime runtime = test::with_threads(2);
    const Support support = support_of(runtime, test::sphere_cap(whole, 0.0));
    const double step = 1e-6;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = 1.01 * on_sphere(-0.1 + i / 100.0, 2.1 * i);
        const glm::dvec3 n = glm::normalize(p + 0.3 * glm::dvec3(std::sin(i), std::cos(i), 0.2));
        const Support::ValueAndDerivatives s = support.evaluate(p, n);
        EXPECT_EQ(s.value, support.value(p, n));
        EXPECT_NEAR(glm::dot(s.normal_gradient, n), 0.0, 1e-12);
        for (int c = 0; c < 3; ++c) {
            glm::dvec3 way(0.0);
            way[c] = step;
            EXPECT_NEAR((support.value(p + way, n) - support.value(p - way, n)) / (2.0 * step), s.place_gradient[c],
                        1e-4 * glm::length(s.place_gradient) + 1e-3);
            EXPECT_NEAR((support.value(p, n + way) - support.value(p, n - way)) / (2.0 * step), s.normal_gradient[c],
                        1e-5);
        }
    }
}

TEST(Support, DoesNotDependOnTheUnit) {
    const base::Runtime runtime = test::with_threads(2);
    const PartSamples samples = test::sphere_cap(300, -0.2);
    PartSamples large = samples;
    for (double& x : large.points) x *= 1024.0;
    const Support one = support_of(runtime, samples);
    const Support other = support_of(runtime, large);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 p = on_sphere(-0.9 + 1.8 * i / 50.0, 1.3 * i);
        EXPECT_DOUBLE_EQ(one.value(p, p), other.value(1024.0 * p, p));
    }
}

TEST(Support, AcceptsFewAndCoincidentSamples) {
    const base::Runtime runtime = test::with_threads(1);
    for (const int count : {1, 2, 5}) {
        PartSamples samples;
        for (int i = 0; i < count; ++i) samples.add({0.0, 0.0, 0.1 * (i / 2)}, {1.0, 0.0, 0.0});
        const Support support = support_of(runtime, samples);
        EXPECT_LT(support.value({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), 1.0) << count;
        EXPECT_GT(support.value({5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), 100.0) << count;
        EXPECT_FALSE(support.value({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}) < 100.0) << count; // no normal
    }
}

} // namespace
} // namespace hrbfnpr::surface::support_test
