// SPDX-License-Identifier: MIT
#include "shapes.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <string>

namespace samples_test {

namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::base::Runtime;
using hrbfnpr::kernel::Kind;
using namespace fit_test;

namespace {

// Returns the message of the error that ends the fit. The test fails if no error is thrown.
std::string message(const fit::FitInput& bad, Status status) {
    const Runtime runtime;
    try {
        static_cast<void>(fit::fit(runtime, bad));
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), status) << error.what();
        EXPECT_EQ(runtime.memory.bytes_now(), 0);
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return "";
}

void expect_message(const fit::FitInput& bad, std::initializer_list<const char*> words,
                    Status status = Status::invalid_argument) {
    const std::string text = message(bad, status);
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

TEST(Samples, CoincidentSamplesAreMergedAndCounted) {
    const Runtime runtime;
    const Cloud cloud = sphere(50);
    Cloud doubled = cloud;
    doubled.add(cloud.point(7), cloud.normal(7));
    doubled.add(cloud.point(7) + glm::dvec3(1e-10, 0, 0), glm::normalize(cloud.normal(7) + glm::dvec3(0.005, 0, 0)));
    doubled.add(cloud.point(3), cloud.normal(3));
    const fit::FitResult result = fit::fit(runtime, input(doubled));
    EXPECT_EQ(result.report.samples, 53);
    EXPECT_EQ(result.report.merged_samples, 3);
    EXPECT_EQ(result.data.count(), 50);
    for (std::int64_t i = 0; i < 50; ++i) { // in the order of the first occurrences
        for (glm::length_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(result.data.sample_position[3 * i + c], cloud.point(i)[c], 1e-10);
            EXPECT_NEAR(result.data.sample_normal[3 * i + c], cloud.normal(i)[c], i == 7 ? 0.002 : 1e-15);
        }
    }
    const glm::dvec3 averaged(result.data.sample_normal[21], result.data.sample_normal[22],
                              result.data.sample_normal[23]);
    EXPECT_NEAR(glm::length(averaged), 1.0, 1e-15);
    EXPECT_GT(glm::distance(averaged, cloud.normal(7)), 1e-3);
}

TEST(Samples, NearlyCoincidentSamplesAreKept) {
    const Runtime runtime;
    Cloud cloud = sphere(50);
    cloud.add(glm::normalize(cloud.point(7) + glm::dvec3(1e-4, 0, 0)),
              glm::normalize(cloud.point(7) + glm::dvec3(1e-4, 0, 0)));
    const fit::FitResult result = fit::fit(runtime, input(cloud));
    EXPECT_EQ(result.report.merged_samples, 0);
    EXPECT_LE(result.report.gradient_residual_max, 1e-8);
}

TEST(Samples, ManyCopiesOfOneSampleCountAsOne) {
    const Runtime runtime;
    Cloud cloud;
    for (int i = 0; i < 3000; ++i) cloud.add({1, 2, 3}, {0, 1, 0});
    const fit::FitResult result = fit::fit(runtime, input(cloud));
    EXPECT_EQ(result.report.merged_samples, 2999);
    EXPECT_EQ(result.data.count(), 1);
    EXPECT_NEAR(at(result.data, {9, 5, 9}).value, 3.0, 1e-12);
}

TEST(Samples, NormalsAreNormalisedAndCounted) {
    const Runtime runtime;
    const Cloud cloud = sphere(20);
    Cloud stretched;
    const double lengths[] = {1.0, 1.0 + 5e-5, 2.0, 1e-200, 1e200, 0.5};
    for (std::int64_t i = 0; i < 20; ++i) stretched.add(cloud.point(i), lengths[i % 6] * cloud.normal(i));
    const fit::FitResult result = fit::fit(runtime, input(stretched));
    EXPECT_EQ(result.report.rescaled_normals, 12); // the 4 + 4 normals of lengths 1 and 1 + 5e-5 are not rescaled
    for (std::int64_t i = 0; i < 20; ++i)
        EXPECT_NEAR(glm::distance(at(result.data, cloud.point(i)).gradient, cloud.normal(i)), 0.0, 1e-10);
}

TEST(Samples, BadParametersAreNamed) {
    const Cloud cloud = sphere(10);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, -1.0, inf}) {
        fit::FitInput wrong = input(cloud);
        wrong.regularization = bad;
        expect_message(wrong, {"regularization"});
        wrong = input(cloud, Kind::gaussian, 1);
        wrong.kernel_radius = bad;
        expect_message(wrong, {"kernel_radius"});
    }
    fit::FitInput wrong = input(cloud, Kind::gaussian, 1);
    wrong.kernel_radius = 1e-200;
    expect_message(wrong, {"kernel_radius", "spacing"});
    expect_message(input(cloud, Kind::triharmonic, 4), {"polynomial_degree is 4"});
    expect_message(input(cloud, Kind::triharmonic, -2), {"polynomial_degree is -2"});
    wrong = input(cloud);
    wrong.refinement_steps = -1;
    expect_message(wrong, {"refinement_steps"});
    wrong = input(cloud);
    wrong.normals.count = 9;
    expect_message(wrong, {"points has 10", "normals has 9"});
    expect_message(input(Cloud()), {"points has 0"});
    wrong = input(cloud);
    wrong.tolerance = -1.0;
    expect_message(wrong, {"tolerance is -1"});
}

TEST(Samples, MaximumCentresAppliesAfterMerging) {
    const Runtime runtime;
    Cloud cloud = sphere(10);
    cloud.add(cloud.point(0), cloud.normal(0));
    fit::FitInput enough = input(cloud);
    enough.maximum_centres = 10;
    EXPECT_EQ(fit::fit(runtime, enough).data.count(), 10);
}

TEST(Samples, ATooHighPolynomialDegreeIsNamed) {
    expect_message(input(sphere(2), Kind::gaussian, 2), {"polynomial_degree is 2", "2 samples", "lower it"});
    // The samples are off the axes, so that terms vanish only up to rounding.
    const auto turned = [](const glm::dvec3& p) {
        const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 3));
        const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0, 0, 1)));
        return p.x * x + p.y * y + p.z * glm::cross(x, y);
    };
    Cloud flat; // the square of the distance from the plane and its gradient vanish at all samples
    for (int i = 0; i < 30; ++i) flat.add(turned({i % 6, i / 6, 0.0}), turned({0, 0, 1}));
    expect_message(input(flat, Kind::triharmonic, 2), {"polynomial_degree is 2", "30 samples"});
    Cloud axes; // the product of the three coordinates vanishes at all six samples
    for (glm::length_t a = 0; a < 3; ++a) {
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 p(0.0);
            p[a] = sign;
            axes.add(turned(p), turned(p));
        }
    }
    expect_message(input(axes, Kind::triharmonic, 3), {"polynomial_degree is 3"});
}

TEST(Samples, AreReadFromAnyStrideAndScalar) {
    const Runtime runtime;
    const Cloud cloud = bumpy(40);
    std::vector<float> mixed; // x y z, one unused number, nx ny nz
    for (std::int64_t i = 39; i >= 0; --i) {
        for (glm::length_t c = 0; c < 3; ++c) mixed.push_back(static_cast<float>(cloud.point(i)[c]));
        mixed.push_back(1e30F);
        for (glm::length_t c = 0; c < 3; ++c) mixed.push_back(static_cast<float>(cloud.normal(i)[c]));
    }
    fit::FitInput strided;
    const auto* last = reinterpret_cast<const std::byte*>(mixed.data() + 7 * 39);
    strided.points = {last, 40, -28, hrbfnpr::base::Scalar::float32, 3};
    strided.normals = {last + 16, 40, -28, hrbfnpr::base::Scalar::float32, 3};
    const fit::FitResult result = fit::fit(runtime, strided);
    EXPECT_EQ(result.report.rescaled_normals, 0);
    for (std::int64_t i = 0; i < 40; ++i)
        for (glm::length_t c = 0; c < 3; ++c)
            EXPECT_EQ(result.data.sample_position[3 * i + c],
                      static_cast<double>(static_cast<float>(cloud.point(i)[c])));
}

TEST(Samples, SpacingIsTheMeanDistanceToTheNearest) {
    const Runtime runtime;
    const Cloud cloud = bumpy(200).moved(3.0, {1, 2, 3});
    double sum = 0.0;
    for (std::int64_t i = 0; i < 200; ++i) {
        double best = HUGE_VAL;
        for (std::int64_t j = 0; j < 200; ++j)
            if (i != j) best = std::min(best, glm::distance(cloud.point(i), cloud.point(j)));
        sum += best;
    }
    const fit::FitResult result = fit::fit(runtime, input(cloud));
    EXPECT_NEAR(result.data.spacing, sum / 200, 1e-13);
    EXPECT_EQ(result.data.scale, result.data.spacing);
    for (glm::length_t c = 0; c < 3; ++c) EXPECT_LE(result.data.bounds.min[c], result.data.centre[c]);
}

} // namespace

} // namespace samples_test
