// SPDX-License-Identifier: MIT
#include "base/status.h"
#include "shapes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

namespace robustness_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::kernel::Kind;
using namespace fit_test;
using hrbfnpr::test::Allocator;
using hrbfnpr::test::with_allocator;

namespace {

TEST(Robustness, AMatrixThatDoesNotFitIsNamedWithItsBytes) {
    Allocator allocator;
    allocator.largest = 1000000;
    const base::Runtime runtime = with_allocator(allocator);
    const Cloud cloud = sphere(200);
    fit::FitInput dense = input(cloud);
    dense.solver = fit::SolverKind::direct;
    try {
        static_cast<void>(fit::fit(runtime, dense));
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), Status::out_of_memory);
        // 796 rows in 7 tiles of 128
        EXPECT_NE(std::string(error.what()).find("200 samples, 3670016 bytes"), std::string::npos) << error.what();
    }
}

TEST(Robustness, ASingularSystemNamesARemedy) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(60);
    fit::FitInput flat = input(cloud, Kind::gaussian, 1);
    flat.kernel_radius = 1e6; // makes all rows alike
    try {
        static_cast<void>(fit::fit(runtime, flat));
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), Status::singular_system);
        EXPECT_NE(std::string(error.what()).find("smaller kernel_radius"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("regularization"), std::string::npos) << error.what();
    }
    flat.regularization = 1e-3; // makes the system solvable again
    EXPECT_NO_THROW(static_cast<void>(fit::fit(runtime, flat)));
}

TEST(Robustness, AFitThatDoesNotInterpolateIsRefused) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(80);
    int good = 0;
    int refused = 0;
    for (double radius = 0.4; radius < 6.0; radius *= 1.15) { // up to far beyond double precision
        fit::FitInput wide = input(cloud, Kind::gaussian, 1);
        wide.kernel_radius = radius;
        wide.refinement_steps = 0;
        try {
            const fit::FitResult result = fit::fit(runtime, wide);
            EXPECT_LE(result.report.solver_residual, 1e-6) << radius;
            EXPECT_LE(result.report.gradient_residual_max, 1e-5) << radius;
            ++good;
        } catch (const hrbfnpr::Error& error) {
            EXPECT_EQ(error.status(), Status::singular_system) << radius;
            ++refused;
        }
    }
    EXPECT_GT(good, 3);
    EXPECT_GT(refused, 3);
}

TEST(Robustness, RefinementLowersTheResidual) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(120);
    fit::FitInput refined = input(cloud, Kind::gaussian, 1);
    refined.kernel_radius = 0.54; // condition 1e15
    refined.refinement_steps = 0;
    const fit::FitReport once = fit::fit(runtime, refined).report;
    refined.refinement_steps = 5;
    const fit::FitReport better = fit::fit(runtime, refined).report;
    EXPECT_EQ(once.iterations, 0);
    EXPECT_GE(better.iterations, 1);
    EXPECT_LE(better.iterations, 5);
    EXPECT_LT(better.solver_residual, 0.5 * once.solver_residual);
}

TEST(Robustness, SamplesMayLieVeryCloseTogether) {
    const base::Runtime runtime;
    for (const Kind kind : {Kind::triharmonic, Kind::wendland_c2}) {
        for (const double gap : {1e-3, 1e-5, 1e-7}) {
            Cloud cloud = sphere(50);
            const glm::dvec3 near = glm::normalize(cloud.point(7) + glm::dvec3(gap, 0, 0));
            cloud.add(near, near);
            const fit::FitResult result = fit::fit(runtime, input(cloud, kind, 1));
            EXPECT_LE(result.report.gradient_residual_max, 1e-8) << gap;
            const Cloud truth = sphere(200);
            for (std::int64_t i = 0; i < truth.count(); ++i)
                EXPECT_LT(std::abs(distance(result.data, truth.point(i))), 2e-3) << gap;
        }
    }
}

} // namespace

} // namespace robustness_test
