// SPDX-License-Identifier: MIT
#include "fit/noise.h"

#include "base/random.h"
#include "base/status.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace noise_test {

namespace {

using namespace hrbfnpr;
using namespace fit_test;

// A standard normal number, by Box and Muller.
double gaussian(std::int64_t i, std::uint32_t lane) {
    const auto u = base::uniform4(7, static_cast<std::uint64_t>(i), base::Purpose::rank, lane);
    return std::sqrt(-2.0 * std::log(1.0 - u[0])) * std::cos(6.283185307179586 * u[1]);
}

Cloud noisy(const Cloud& cloud, double position, double normal) {
    Cloud result;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const glm::dvec3 off(gaussian(i, 1), gaussian(i, 2), gaussian(i, 3));
        result.add(cloud.point(i) + position * gaussian(i, 0) * cloud.normal(i),
                   glm::normalize(cloud.normal(i) + normal * off));
    }
    return result;
}

fit::Noise measured(const Cloud& cloud) {
    const base::Runtime runtime;
    return fit::measure_noise(runtime, fit::read_samples(runtime, view(cloud.points), view(cloud.normals)));
}

// The result uses memory of the runtime, so the runtime must outlive it.
fit::FitResult fitted(const base::Runtime& runtime, const Cloud& cloud, bool automatic) {
    fit::FitInput call = input(cloud);
    if (automatic) call.regularization_mode = fit::RegularizationMode::automatic;
    return fit::fit(runtime, call);
}

// The root mean square distance of points of the true surface from the fit.
double error(const fit::FitResult& result, const Cloud& truth) {
    double sum = 0.0;
    for (std::int64_t i = 0; i < truth.count(); ++i) {
        const Sampled f = at(result.data, truth.point(i));
        sum += f.value * f.value / glm::dot(f.gradient, f.gradient);
    }
    return std::sqrt(sum / static_cast<double>(truth.count()));
}

TEST(Noise, IsNotDetectedInCleanSamples) {
    EXPECT_EQ(measured(sphere(40)).position, 0.0);
    EXPECT_EQ(measured(sphere(2000)).position, 0.0);
    EXPECT_EQ(measured(bumpy(1000)).position, 0.0);
    EXPECT_EQ(measured(bumpy(4000)).position, 0.0);
    EXPECT_EQ(measured(bumpy(1000).moved(1e-5, {100, 0, 0})).position, 0.0);
    EXPECT_EQ(measured(sphere(20)).position, 0.0); // too few samples to measure noise
    Cloud flat;
    for (int i = 0; i < 400; ++i) flat.add({i % 20, i / 20, 0.0}, {0, 0, 1});
    EXPECT_EQ(measured(flat).position, 0.0);
}

TEST(Noise, IsMeasured) {
    for (const double normal : {0.0, 0.05})
        for (const double position : {0.003, 0.01}) {
            EXPECT_NEAR(measured(noisy(sphere(2000), position, normal)).position / position, 1.0, 0.25) << position;
            EXPECT_NEAR(measured(noisy(bumpy(2000), position, normal)).position / position, 1.0, 0.25) << position;
        }
    const Cloud scaled = noisy(sphere(2000), 0.01, 0.0).moved(1e-4, {5, 6, 7});
    EXPECT_NEAR(measured(scaled).position, 1e-6, 0.25e-6);
}

// The noise is larger than the spacing: samples are near each other if their noise is similar.
TEST(Noise, IsDetectedEvenIfLargerThanTheSpacing) { EXPECT_GT(measured(noisy(sphere(3000), 0.1, 0.0)).position, 0.03); }

TEST(AutomaticRegularization, ReducesTheErrorOfNoisySamples) {
    const base::Runtime runtime;
    for (const double normal : {0.0, 0.1}) {
        const Cloud truth = bumpy(1500);
        const Cloud cloud = noisy(truth, 0.01, normal);
        const fit::FitResult smooth = fitted(runtime, cloud, true);
        const fit::FitResult exact = fitted(runtime, cloud, false);
        EXPECT_NEAR(error(exact, truth), 0.01, 0.002);
        EXPECT_LT(error(smooth, truth), 0.5 * error(exact, truth)) << normal;
        EXPECT_GT(smooth.report.regularization, 1e-6);
        EXPECT_NEAR(smooth.report.noise_estimate, 0.01, 0.003);
        EXPECT_EQ(smooth.data.count(), 1500);
        EXPECT_EQ(smooth.report.choice_rounds, 0);
        EXPECT_TRUE(std::isnan(exact.report.noise_estimate)) << "nobody asked";
    }
}

TEST(AutomaticRegularization, DoesNotDependOnTheUnit) {
    const base::Runtime runtime;
    const Cloud cloud = noisy(bumpy(700), 0.01, 0.05);
    const double expected = fitted(runtime, cloud, true).report.regularization;
    EXPECT_NEAR(fitted(runtime, cloud.moved(1e-3, {10, 0, 0}), true).report.regularization / expected, 1.0, 1e-3);
}

TEST(AutomaticRegularization, IsZeroForCleanSamples) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(700);
    const fit::FitResult automatic = fitted(runtime, cloud, true);
    const fit::FitResult exact = fitted(runtime, cloud, false);
    EXPECT_EQ(automatic.report.regularization, 0.0);
    ASSERT_EQ(automatic.data.count(), exact.data.count());
    for (std::int64_t i = 0; i < exact.data.count(); ++i) ASSERT_EQ(automatic.data.alpha[i], exact.data.alpha[i]);
}

} // namespace

} // namespace noise_test
