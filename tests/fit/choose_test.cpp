// SPDX-License-Identifier: MIT
#include "fit/choose.h"

#include "base/random.h"
#include "base/status.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace choose_test {

namespace {

using namespace hrbfnpr;
using namespace fit_test;

fit::FitInput choosing(const Cloud& cloud, double tolerance, std::int64_t maximum_centres = 0) {
    fit::FitInput call = input(cloud);
    call.tolerance = tolerance;
    call.maximum_centres = maximum_centres;
    return call;
}

double distance(const fit::FitResult& result, const glm::dvec3& p) {
    const Sampled f = at(result.data, p);
    return std::abs(f.value) / glm::length(f.gradient);
}

// Checks that each centre is a sample with its normal, and that all centres differ.
void expect_subset(const fit::FitResult& result, const Cloud& cloud) {
    std::set<std::array<double, 6>> samples;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const glm::dvec3 p = cloud.point(i);
        const glm::dvec3 n = glm::normalize(cloud.normal(i));
        samples.insert({p.x, p.y, p.z, n.x, n.y, n.z});
    }
    for (std::int64_t i = 0; i < result.data.count(); ++i) {
        const double* p = result.data.sample_position.data() + 3 * i;
        const double* n = result.data.sample_normal.data() + 3 * i;
        const auto found = samples.lower_bound({p[0], p[1], p[2], -2.0, -2.0, -2.0});
        ASSERT_TRUE(found != samples.end() && (*found)[0] == p[0] && (*found)[1] == p[1] && (*found)[2] == p[2]) << i;
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR((*found)[3 + c], n[c], 1e-12);
        samples.erase(found);
    }
}

TEST(ChooseCentres, FewSamplesBringADenseTorusWithinTheTolerance) {
    const base::Runtime runtime;
    const Cloud cloud = torus(20000);
    const fit::FitResult result = fit::fit(runtime, choosing(cloud, 1e-4));
    EXPECT_LT(result.data.count(), 2000);
    EXPECT_GE(result.report.choice_rounds, 2);
    EXPECT_EQ(result.report.samples, 20000);
    EXPECT_EQ(result.report.input_share_within, 1.0);
    expect_subset(result, cloud);
    double largest = 0.0;
    double sum = 0.0;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const double off = distance(result, cloud.point(i));
        largest = std::max(largest, off);
        sum += off * off;
        EXPECT_GT(glm::dot(at(result.data, cloud.point(i)).gradient, cloud.normal(i)), 0.9);
    }
    EXPECT_LE(largest, 1e-4);
    EXPECT_NEAR(result.report.input_distance_max, largest, 1e-9);
    EXPECT_NEAR(result.report.input_distance_rms, std::sqrt(sum / 20000.0), 1e-9);
    EXPECT_GT(result.report.seconds_choose, 0.0);
}

TEST(ChooseCentres, ALooserToleranceNeedsFewerCentres) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(8000);
    std::int64_t before = 8000;
    for (const double tolerance : {3e-4, 1e-3, 3e-3}) {
        const fit::FitResult result = fit::fit(runtime, choosing(cloud, tolerance));
        EXPECT_LT(result.data.count(), before) << tolerance;
        EXPECT_LE(result.report.input_distance_max, tolerance);
        before = result.data.count();
    }
}

TEST(ChooseCentres, BothSheetsOfAThinWallAreRepresented) {
    Cloud wall;
    for (int i = 0; i < 6000; ++i) {
        const double u = (i / 2 + 0.5) / 3000.0;
        const double v = std::fmod(0.6180339887498949 * (i / 2), 1.0);
        const double up = i % 2 == 0 ? 1.0 : -1.0;
        const double height = 0.1 * std::sin(3.0 * u);
        wall.add({u, v, height + 0.005 * up}, up * glm::normalize(glm::dvec3(-0.3 * std::cos(3.0 * u), 0.0, 1.0)));
    }
    const base::Runtime runtime;
    const fit::FitResult result = fit::fit(runtime, choosing(wall, 5e-4));
    EXPECT_EQ(result.report.input_share_within, 1.0);
    EXPECT_LT(result.data.count(), 3000);
    for (std::int64_t i = 0; i < wall.count(); ++i)
        ASSERT_GT(glm::dot(at(result.data, wall.point(i)).gradient, wall.normal(i)), 0.0) << i;
}

TEST(ChooseCentres, MaximumCentresWithoutAToleranceIsReached) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(5000);
    double before = 2.0;
    for (const std::int64_t most : {1, 20, 100, 400}) {
        const fit::FitResult result = fit::fit(runtime, choosing(cloud, 0.0, most));
        ASSERT_EQ(result.data.count(), most);
        expect_subset(result, cloud);
        EXPECT_TRUE(std::isnan(result.report.input_share_within)) << "without a tolerance";
        EXPECT_LT(result.report.input_distance_rms, before) << most;
        before = result.report.input_distance_rms;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(ChooseCentres, AddsTheWorstSamplesRatherThanTheFarthest) {
    // The surface is a bump on a plane: samples of the plane need no centre.
    Cloud cloud;
    for (int i = 0; i < 6400; ++i) {
        const glm::dvec2 p(0.025 * (i % 80) - 1.0, 0.025 * (i / 80) - 1.0);
        const double height = 0.1 * std::exp(-60.0 * glm::dot(p, p));
        cloud.add({p.x, p.y, height}, glm::normalize(glm::dvec3(120.0 * height * p, 1.0)));
    }
    const base::Runtime runtime;
    const fit::FitResult result = fit::fit(runtime, choosing(cloud, 0.0, 400));
    std::int64_t on_bump = 0;
    for (std::int64_t i = 0; i < result.data.count(); ++i) {
        const double* p = result.data.sample_position.data() + 3 * i;
        on_bump += p[0] * p[0] + p[1] * p[1] < 0.16 ? 1 : 0;
    }
    EXPECT_GT(on_bump, 2 * 400 * 0.1257); // twice its share of the area
}

TEST(ChooseCentres, ReportsTheErrorReachedWithTooFewCentres) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(5000);
    const fit::FitResult result = fit::fit(runtime, choosing(cloud, 1e-5, 300));
    EXPECT_EQ(result.data.count(), 300);
    EXPECT_GT(result.report.input_distance_max, 1e-5);
    std::int64_t within = 0;
    for (std::int64_t i = 0; i < cloud.count(); ++i) within += distance(result, cloud.point(i)) <= 1e-5 ? 1 : 0;
    EXPECT_NEAR(result.report.input_share_within, static_cast<double>(within) / 5000.0, 1e-3);
}

TEST(ChooseCentres, UsesAllSamplesIfTheyAreFewOrNoLimitIsSet) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(300);
    for (const fit::FitInput& call : {choosing(cloud, 0.0), choosing(cloud, 0.0, 300), choosing(cloud, 0.0, 301)}) {
        const fit::FitResult result = fit::fit(runtime, call);
        EXPECT_EQ(result.data.count(), 300);
        EXPECT_EQ(result.report.choice_rounds, 0);
        EXPECT_LT(result.report.input_distance_max, 1e-6);
    }
    EXPECT_EQ(fit::fit(runtime, choosing(sphere(1), 1e-3, 1)).data.count(), 1);
}

double gaussian(std::int64_t i, std::uint32_t lane) {
    const auto u = base::uniform4(3, static_cast<std::uint64_t>(i), base::Purpose::rank, lane);
    return std::sqrt(-2.0 * std::log(1.0 - u[0])) * std::cos(6.283185307179586 * u[1]);
}

// A simulated scan with noise of 0.005 and normals that are 6 degrees off; every 250th normal is completely wrong.
Cloud scan(const Cloud& truth) {
    Cloud cloud;
    for (std::int64_t i = 0; i < truth.count(); ++i) {
        const glm::dvec3 off(gaussian(i, 1), gaussian(i, 2), gaussian(i, 3));
        cloud.add(truth.point(i) + 0.005 * gaussian(i, 0) * truth.normal(i),
                  glm::normalize(truth.normal(i) + (i % 250 == 9 ? 20.0 : 0.1) * off));
    }
    return cloud;
}

TEST(ChooseCentres, DoesNotChaseNoise) {
    const Cloud truth = bumpy(20000);
    const Cloud cloud = scan(truth);
    const base::Runtime runtime;
    fit::FitInput call = choosing(cloud, 0.015, 6000);
    call.regularization_mode = fit::RegularizationMode::automatic;
    const fit::FitResult result = fit::fit(runtime, call);
    EXPECT_LT(result.data.count(), 2000);
    EXPECT_GT(result.report.input_share_within, 0.98);
    EXPECT_NEAR(result.report.noise_estimate, 0.005, 0.0015);
    double sum = 0.0;
    for (std::int64_t i = 0; i < truth.count(); ++i) {
        const double off = distance(result, truth.point(i));
        sum += off * off;
        ASSERT_GT(glm::dot(at(result.data, truth.point(i)).gradient, truth.normal(i)), 0.0) << i;
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(truth.count())), 0.004);
}

} // namespace

} // namespace choose_test
