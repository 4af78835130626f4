// SPDX-License-Identifier: MIT
#include "implicit/far_field.h"

#include "base/status.h"
#include "fields.h"
#include "implicit/hermite_sums.h"
#include "support/runtime.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace far_field_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::geometry::VecArray;
using test::scatter;

namespace {

// Points of Fibonacci's spiral on a sphere, about 1 apart.
VecArray sphere(base::Memory& memory, int count) {
    VecArray points(memory);
    const double radius = std::sqrt(count / 12.566370614359172);
    for (int i = 0; i < count; ++i) {
        const auto [x, y, z] = hrbfnpr::test::spiral_point(i, count);
        points.push_back(radius * glm::dvec3(x, y, z));
    }
    return points;
}

// A tenth of the points is in a wide box, and the others are in a box a hundredth as wide.
VecArray uneven(base::Memory& memory, int count) {
    VecArray points(memory);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 p(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2));
        points.push_back(i % 10 == 0 ? 16.0 * p : glm::dvec3(5.0) + 0.16 * p);
    }
    return points;
}

struct Weights {
    Weights(base::Memory& memory, std::int64_t count) : alpha(memory, count), beta(memory, count) {
        for (std::int64_t i = 0; i < count; ++i) {
            const int from = 9000 + 4 * static_cast<int>(i);
            alpha[i] = scatter(from);
            beta.set(i, {scatter(from + 1), scatter(from + 2), scatter(from + 3)});
        }
    }
    base::Array<double> alpha;
    VecArray beta;
};

struct Sums {
    Sums(base::Memory& memory, std::int64_t count) : value(memory, count), gradient(memory, count) {}
    base::Array<double> value;
    VecArray gradient;
};

Sums directly(const base::Runtime& runtime, const VecArray& p, const Weights& w) {
    Sums sums(runtime.memory, p.size());
    implicit::hermite_sums(runtime.instruction_set, hrbfnpr::kernel::Kind::triharmonic)(
        0.0,
        {p.x.data(), p.y.data(), p.z.data(), w.alpha.data(), w.beta.x.data(), w.beta.y.data(), w.beta.z.data(),
         p.size()},
        {p.x.data(), p.y.data(), p.z.data(), sums.value.data(), sums.gradient.x.data(), sums.gradient.y.data(),
         sums.gradient.z.data(), p.size()});
    return sums;
}

Sums quickly(const base::Runtime& runtime, const VecArray& points, const Weights& w,
             const implicit::SourceTreeOptions& options) {
    implicit::FarField field(runtime, points, options);
    Sums sums(runtime.memory, points.size());
    field.sum(w.alpha.data(), w.beta, sums.value.data(), sums.gradient, {});
    return sums;
}

// The relative error in the 2-norm: that of the values or that of the gradients, whichever is larger.
double error(const Sums& found, const Sums& expected) {
    glm::dvec2 off(0.0);
    glm::dvec2 all(0.0);
    const auto squared = [](double value, const glm::dvec3& gradient) {
        return glm::dvec2(value * value, glm::dot(gradient, gradient));
    };
    for (std::int64_t i = 0; i < expected.value.size(); ++i) {
        off += squared(found.value[i] - expected.value[i], found.gradient[i] - expected.gradient[i]);
        all += squared(expected.value[i], expected.gradient[i]);
    }
    const glm::dvec2 relative = glm::sqrt(off / all);
    return std::max(relative.x, relative.y);
}

void expect_error_to_fall(const VecArray& points, const implicit::SourceTreeOptions& coarse, double first) {
    const base::Runtime runtime;
    const Weights weights(runtime.memory, points.size());
    const Sums expected = directly(runtime, points, weights);
    double before = 5.0 * first;
    for (implicit::SourceTreeOptions options = coarse; options.finer <= coarse.finer + 2; ++options.finer) {
        const double now = error(quickly(runtime, points, weights, options), expected);
        EXPECT_LT(now, 0.2 * before) << options.finer;
        EXPECT_GT(now, 1e-15) << options.finer;
        before = now;
    }
}

TEST(FarField, ErrorFallsByEachStepOnASurface) {
    base::Memory memory;
    expect_error_to_fall(sphere(memory, 1500), {4.0, 0, 30, 1.0}, 1e-4);
}

TEST(FarField, ErrorFallsByEachStepOnAnUnevenCloud) {
    base::Memory memory;
    expect_error_to_fall(uneven(memory, 3000), {4.0, -1, 60, 1.0}, 1e-2);
}

TEST(FarField, IsAccurateAtTheTrueSpacing) {
    const base::Runtime runtime;
    const VecArray points = sphere(runtime.memory, 1500);
    const Weights weights(runtime.memory, points.size());
    EXPECT_LT(error(quickly(runtime, points, weights, {1.0, 1, 40, 1.0}), directly(runtime, points, weights)), 1e-6);
}

// On a plane, hundreds of pairs of neighbouring cubes have the same offset.
TEST(FarField, IsAccurateWithManyPairsOfOneOffset) {
    const base::Runtime runtime;
    VecArray points(runtime.memory);
    for (int i = 0; i < 4096; ++i) points.push_back({i % 64 + 0.5, i / 64 + 0.5, 0.01 * scatter(i)});
    const Weights weights(runtime.memory, points.size());
    EXPECT_LT(error(quickly(runtime, points, weights, {1.0, 0, 8, 1.0}), directly(runtime, points, weights)), 1e-5);
}

TEST(FarField, ClustersAreDividedAsDeeplyAsTheyNeed) {
    const base::Runtime runtime;
    const VecArray points = uneven(runtime.memory, 1500);
    const Weights weights(runtime.memory, points.size());
    const Sums expected = directly(runtime, points, weights);
    for (const std::int64_t leaf_size : {10, 40, 640})
        EXPECT_LT(error(quickly(runtime, points, weights, {4.0, 0, leaf_size, 1.0}), expected), 1e-4) << leaf_size;
    const implicit::FarField shallow(runtime, points, {4.0, 0, 1499, 1.0});
    const implicit::FarField deep(runtime, points, {4.0, 0, 10, 1.0});
    EXPECT_GT(deep.bytes(), 2 * shallow.bytes());
}

TEST(FarField, IsExactWhereEverythingIsNear) {
    const base::Runtime runtime;
    for (const int count : {0, 1, 2, 300}) {
        const VecArray points = sphere(runtime.memory, count);
        const Weights weights(runtime.memory, count);
        const Sums found = quickly(runtime, points, weights, {1.0, 0, 300, 1.0});
        if (count > 1) {
            EXPECT_LT(error(found, directly(runtime, points, weights)), 1e-13) << count;
        }
    }
    const VecArray points = sphere(runtime.memory, 300); // one level of cubes, which all touch each other
    const Weights weights(runtime.memory, 300);
    EXPECT_LT(error(quickly(runtime, points, weights, {1.0, 0, 150, 1.0}), directly(runtime, points, weights)), 1e-13);
}

TEST(FarField, RepeatedCallsGiveTheSameSums) {
    const base::Runtime runtime;
    const VecArray points = sphere(runtime.memory, 600);
    implicit::FarField field(runtime, points, {4.0, 0, 30, 1.0});
    const Weights weights(runtime.memory, points.size());
    Sums first(runtime.memory, points.size());
    Sums second(runtime.memory, points.size());
    field.sum(weights.alpha.data(), weights.beta, first.value.data(), first.gradient, {});
    field.sum(weights.alpha.data(), weights.beta, second.value.data(), second.gradient, {});
    EXPECT_EQ(error(second, first), 0.0);
}

} // namespace

} // namespace far_field_test
