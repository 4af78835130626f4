// SPDX-License-Identifier: MIT
#include "fields.h"
#include "support/runtime.h"

#include "base/status.h"
#include "implicit/custom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace custom_test {

namespace implicit = hrbfnpr::implicit;
using test::Fields;
using test::hessian_index;
using test::Points;
using test::scatter;

namespace {

// f = sin x cos 2y + x z^2 + exp(y z / 3), with its derivatives.
struct Wave {
    static double value(double x, double y, double z) {
        return std::sin(x) * std::cos(2 * y) + x * z * z + std::exp(y * z / 3);
    }
    static std::array<double, 3> gradient(double x, double y, double z) {
        const double e = std::exp(y * z / 3) / 3;
        return {std::cos(x) * std::cos(2 * y) + z * z, -2 * std::sin(x) * std::sin(2 * y) + z * e, 2 * x * z + y * e};
    }
    static std::array<double, 6> hessian(double x, double y, double z) {
        const double e = std::exp(y * z / 3);
        return {-std::sin(x) * std::cos(2 * y),
                -2 * std::cos(x) * std::sin(2 * y),
                2 * z,
                -4 * std::sin(x) * std::cos(2 * y) + z * z * e / 9,
                e / 3 + y * z * e / 9,
                2 * x + y * y * e / 9};
    }
};

struct Calls {
    std::int64_t count = 0;
    std::int64_t points = 0;
    std::int64_t largest = 0;
    std::int64_t gradients = 0;
    std::int64_t hessians = 0;
    int released = 0;
    std::int32_t result = 0;
    bool value_missing = false;
};

std::int32_t wave(void* user, std::int64_t count, const double* p, double* value, double* gradient, double* hessian) {
    auto& calls = *static_cast<Calls*>(user);
    ++calls.count;
    calls.points += count;
    calls.largest = std::max(calls.largest, count);
    calls.gradients += gradient != nullptr;
    calls.hessians += hessian != nullptr;
    calls.value_missing = calls.value_missing || value == nullptr;
    for (std::int64_t i = 0; i < count; ++i, p += 3) {
        value[i] = Wave::value(p[0], p[1], p[2]);
        if (gradient != nullptr) {
            const auto g = Wave::gradient(p[0], p[1], p[2]);
            std::copy(g.begin(), g.end(), gradient + 3 * i);
        }
        if (hessian != nullptr) {
            const auto h = Wave::hessian(p[0], p[1], p[2]);
            std::copy(h.begin(), h.end(), hessian + 6 * i);
        }
    }
    return calls.result;
}

implicit::CustomFunction make(Calls& calls, bool gradient, bool hessian) {
    implicit::CustomFunction custom;
    custom.function = wave;
    custom.user = &calls;
    custom.release = [](void* user) { ++static_cast<Calls*>(user)->released; };
    custom.has_gradient = gradient;
    custom.has_hessian = hessian;
    custom.bounds.min = glm::dvec3(-1.0);
    custom.bounds.max = glm::dvec3(1.0);
    return custom;
}

Points queries(int count) {
    Points points;
    for (int i = 0; i < count; ++i) points.add({scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)});
    return points;
}

void expect_wave(const Points& points, const Fields& fields, double gradient_tolerance, double hessian_tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 p = points[i];
        EXPECT_EQ(fields.value[i], Wave::value(p.x, p.y, p.z));
        const auto g = Wave::gradient(p.x, p.y, p.z);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(fields.gradient[c][i], g[c], gradient_tolerance) << c;
        const auto h = Wave::hessian(p.x, p.y, p.z);
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(fields.hessian[c][i], h[c], hessian_tolerance) << c;
    }
}

TEST(Custom, PassesOnProvidedDerivatives) {
    Calls calls;
    const implicit::Custom custom(make(calls, true, true));
    const Points points = queries(600);
    Fields fields(points.size());
    custom.evaluate(points.batch(), fields.all());
    expect_wave(points, fields, 0.0, 0.0);
    EXPECT_EQ(calls.count, 3); // 256 + 256 + 88
    EXPECT_EQ(calls.points, 600);
    EXPECT_LE(calls.largest, implicit::batch_size);
    EXPECT_FALSE(calls.value_missing);
}

TEST(Custom, DifferencesAMissingHessian) {
    Calls calls;
    const implicit::Custom custom(make(calls, true, false));
    const Points points = queries(300);
    Fields fields(points.size());
    custom.evaluate(points.batch(), fields.all());
    expect_wave(points, fields, 0.0, 1e-4); // h = 3.5e-3
    EXPECT_EQ(calls.hessians, 0);
}

TEST(Custom, DifferencesGradientAndHessianOfABareValue) {
    Calls calls;
    const implicit::Custom custom(make(calls, false, false));
    const Points points = queries(300);
    Fields fields(points.size());
    custom.evaluate(points.batch(), fields.all());
    expect_wave(points, fields, 2e-7, 1e-4);
    EXPECT_EQ(calls.gradients, 0);
    EXPECT_EQ(calls.hessians, 0);
}

TEST(Custom, DifferencesAMissingGradientIfTheHessianIsGiven) {
    Calls calls;
    const implicit::Custom custom(make(calls, false, true));
    const Points points = queries(20);
    Fields fields(points.size());
    custom.evaluate(points.batch(), fields.all());
    expect_wave(points, fields, 2e-7, 0.0);
}

TEST(Custom, UsesTheGivenDifferenceStep) {
    Calls calls;
    implicit::CustomFunction coarse = make(calls, false, false);
    coarse.difference_step = 0.1;
    const implicit::Custom custom(coarse);
    Points points;
    points.add({0.4, 0.3, 0.2});
    Fields fields(1);
    custom.evaluate(points.batch(), fields.all());
    const double expected = (Wave::value(0.5, 0.3, 0.2) - Wave::value(0.3, 0.3, 0.2)) / 0.2;
    EXPECT_NEAR(fields.gradient[0][0], expected, 1e-13);
    const double second =
        (Wave::value(0.4, 0.4, 0.2) - 2 * Wave::value(0.4, 0.3, 0.2) + Wave::value(0.4, 0.2, 0.2)) / 0.01;
    EXPECT_NEAR(fields.hessian[hessian_index[1][1]][0], second, 1e-11);
}

TEST(Custom, RequestsOnlyNeededFields) {
    Calls calls;
    const implicit::Custom custom(make(calls, true, true));
    const Points points = queries(5);
    Fields fields(points.size());
    custom.evaluate(points.batch(), fields.batch(true, false, false));
    EXPECT_EQ(calls.gradients, 0);
    EXPECT_EQ(calls.hessians, 0);
    EXPECT_EQ(fields.gradient[0][0], -7.0);
    custom.evaluate(points.batch(), fields.batch(false, false, true));
    EXPECT_EQ(calls.gradients, 0);
    EXPECT_EQ(calls.hessians, 1);
    custom.evaluate({}, {});
    EXPECT_EQ(calls.count, 2);
}

TEST(Custom, AFailureNamesTheNumberReturned) {
    Calls calls;
    calls.result = 42;
    const implicit::Custom custom(make(calls, false, false));
    const Points points = queries(3);
    Fields fields(points.size());
    try {
        custom.evaluate(points.batch(), fields.all());
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), hrbfnpr::Status::callback);
        EXPECT_NE(std::string(error.what()).find("42"), std::string::npos) << error.what();
    }
}

TEST(Custom, PassesOnNonFiniteValues) {
    Calls calls;
    implicit::CustomFunction custom = make(calls, false, false);
    custom.function = [](void*, std::int64_t count, const double*, double* value, double*, double*) {
        std::fill_n(value, count, std::numeric_limits<double>::quiet_NaN());
        return std::int32_t{0};
    };
    const implicit::Custom field(custom);
    const Points points = queries(2);
    Fields fields(points.size());
    field.evaluate(points.batch(), fields.all());
    EXPECT_TRUE(std::isnan(fields.value[1]));
    EXPECT_TRUE(std::isnan(fields.gradient[2][1]));
}

TEST(Custom, ReleasesItsUserOnce) {
    Calls calls;
    { const implicit::Custom custom(make(calls, true, false)); }
    EXPECT_EQ(calls.released, 1);
    implicit::CustomFunction silent = make(calls, true, false);
    silent.release = nullptr;
    { const implicit::Custom custom(silent); }
    EXPECT_EQ(calls.released, 1);
}

TEST(Custom, RunsOnTheCallersThreadUnlessItIsThreadSafe) {
    Calls calls;
    implicit::CustomFunction function = make(calls, true, false);
    const implicit::Custom serial(function);
    EXPECT_FALSE(serial.concurrent());
    const hrbfnpr::base::Runtime four = hrbfnpr::test::with_threads(4);
    EXPECT_EQ(serial.threads(four).threads(), 1);
    function.thread_safe = true;
    const implicit::Custom parallel(function);
    EXPECT_EQ(parallel.threads(four).threads(), 4);
    EXPECT_EQ(parallel.bounds().max.x, 1.0);
}

} // namespace

} // namespace custom_test
