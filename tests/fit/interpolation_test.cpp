// SPDX-License-Identifier: MIT
#include "shapes.h"

#include "base/status.h"
#include "kernel/polynomial.h"

#include <gtest/gtest.h>

namespace interpolation_test {

namespace fit = hrbfnpr::fit;
using hrbfnpr::base::Runtime;
using hrbfnpr::kernel::Kind;
using namespace fit_test;

namespace {

const Kind kinds[] = {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2};

void expect_interpolation(const Cloud& cloud, const fit::FitResult& result, const std::string& what) {
    const double unit = result.data.scale; // "after normalisation"
    double value_max = 0.0;
    double gradient_max = 0.0;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const Sampled s = at(result.data, cloud.point(i));
        value_max = std::max(value_max, std::abs(s.value));
        gradient_max = std::max(gradient_max, glm::distance(s.gradient, cloud.normal(i)));
    }
    EXPECT_LE(value_max, 1e-8 * unit) << what;
    EXPECT_LE(gradient_max, 1e-8) << what;
    // The report holds sums in vectors, or the residual of the system, which are the same up to rounding.
    EXPECT_NEAR(result.report.value_residual_max, value_max, 1e-12 * unit) << what;
    EXPECT_NEAR(result.report.gradient_residual_max, gradient_max, 1e-12) << what;
    EXPECT_LE(result.report.value_residual_rms, 1.0001 * value_max + 1e-12 * unit) << what;
    EXPECT_LE(result.report.gradient_residual_rms, gradient_max + 1e-12) << what;
    EXPECT_LE(result.report.solver_residual, 1e-9) << what;
}

TEST(Interpolation, HoldsForAllKernelsDegreesAndCounts) {
    const Runtime runtime;
    for (const Kind kind : kinds) {
        for (std::int32_t degree = -1; degree <= 3; ++degree) {
            for (const int count : {1, 2, 6, 50, 120}) {
                const std::string what = std::string(hrbfnpr::kernel::name(kind)) + " degree " +
                                         std::to_string(degree) + " N " + std::to_string(count);
                const Cloud cloud = bumpy(count);
                const bool many_enough = 4 * count >= hrbfnpr::kernel::polynomial_size(degree);
                const bool singular = kind == Kind::triharmonic && degree < 1 && count == 1;
                try {
                    const fit::FitResult result = fit::fit(runtime, input(cloud, kind, degree));
                    EXPECT_TRUE(many_enough && !singular) << what;
                    expect_interpolation(cloud, result, what);
                    // The system is definite wherever theory says so.
                    if (kind != Kind::triharmonic || degree >= 1) {
                        EXPECT_FALSE(result.report.fallback) << what;
                    }
                    if (kind == Kind::triharmonic && degree < 0) {
                        EXPECT_TRUE(result.report.fallback) << what;
                    }
                } catch (const hrbfnpr::Error& error) {
                    EXPECT_TRUE(!many_enough || singular) << what << ": " << error.what();
                    EXPECT_EQ(error.status(),
                              singular ? hrbfnpr::Status::singular_system : hrbfnpr::Status::invalid_argument)
                        << what;
                }
            }
        }
    }
}

TEST(Interpolation, HoldsForAThousandSamples) {
#if defined(NDEBUG)
    const int count = 1024;
#else
    const int count = 300; // without optimisation the solver is 50 times slower
#endif
    const Runtime runtime;
    const Cloud cloud = torus(count);
    for (const fit::SolverKind solver : {fit::SolverKind::direct, fit::SolverKind::automatic}) {
        fit::FitInput many = input(cloud);
        many.solver = solver;
        const fit::FitResult result = fit::fit(runtime, many);
        expect_interpolation(cloud, result, "torus");
        EXPECT_EQ(result.report.samples, count);
        EXPECT_EQ(result.report.merged_samples, 0);
        EXPECT_EQ(result.report.rescaled_normals, 0);
        EXPECT_FALSE(result.report.fallback);
        if (result.report.solver == fit::SolverKind::direct) {
            EXPECT_GT(result.report.condition_estimate, 1e3);
            EXPECT_LT(result.report.condition_estimate, 1e9);
        }
        EXPECT_GE(result.report.seconds_total, result.report.seconds_solve);
    }
}

TEST(Interpolation, OneSampleIsThePlaneThroughIt) {
    const Runtime runtime;
    Cloud cloud;
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, -2, 3));
    cloud.add({5, 6, 7}, n);
    for (const Kind kind : kinds) {
        const fit::FitResult result = fit::fit(runtime, input(cloud, kind, 1));
        for (const glm::dvec3& p : {glm::dvec3(5, 6, 7), glm::dvec3(0, 0, 0), glm::dvec3(-8, 40, 3)}) {
            const Sampled s = at(result.data, p);
            EXPECT_NEAR(s.value, glm::dot(n, p - cloud.point(0)), 1e-12);
            EXPECT_NEAR(glm::distance(s.gradient, n), 0.0, 1e-13);
        }
        EXPECT_EQ(result.data.spacing, 0.0);
    }
}

TEST(Interpolation, CoplanarSamplesOfOneNormalAreTheirPlane) {
    const Runtime runtime;
    Cloud cloud;
    for (int i = 0; i < 40; ++i) cloud.add({i % 8 + 0.1 * (i % 3), i / 8, 2.0}, {0, 0, 1});
    for (const Kind kind : kinds) {
        const fit::FitResult result = fit::fit(runtime, input(cloud, kind, 1));
        for (const glm::dvec3& p : {glm::dvec3(3.3, 2.7, 2.0), glm::dvec3(-5, 1, 0), glm::dvec3(3, 30, 7)}) {
            const Sampled s = at(result.data, p);
            EXPECT_NEAR(s.value, p.z - 2.0, 1e-10) << hrbfnpr::kernel::name(kind);
            EXPECT_NEAR(glm::distance(s.gradient, {0, 0, 1}), 0.0, 1e-10);
        }
    }
}

TEST(Interpolation, CoplanarSamplesOfManyNormalsAreInterpolated) {
    const Runtime runtime;
    Cloud cloud;
    for (int i = 0; i < 30; ++i)
        cloud.add({i % 6, i / 6, 0.0}, glm::normalize(glm::dvec3(std::sin(i), std::cos(2.0 * i), 2.0)));
    for (const Kind kind : kinds)
        expect_interpolation(cloud, fit::fit(runtime, input(cloud, kind, 1)), hrbfnpr::kernel::name(kind));
}

TEST(Interpolation, ReproducesPolynomialsOfItsDegree) {
    // f = (x^2 + y^2 + z^2 - 1) / 2 has the unit sphere and its normals.
    const Runtime runtime;
    for (const Kind kind : kinds) {
        const fit::FitResult result = fit::fit(runtime, input(sphere(40), kind, 2));
        for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), glm::dvec3(0.3, 2, -1), glm::dvec3(0.5, 0.5, 0.1)})
            EXPECT_NEAR(at(result.data, p).value, 0.5 * (glm::dot(p, p) - 1.0), 1e-9) << hrbfnpr::kernel::name(kind);
    }
}

double worst_distance(const fit::FitResult& result, const Cloud& truth) {
    double worst = 0.0;
    for (std::int64_t i = 0; i < truth.count(); ++i)
        worst = std::max(worst, std::abs(distance(result.data, truth.point(i))));
    return worst;
}

TEST(Interpolation, ConvergesToTheSurface) {
    const Runtime runtime;
    for (const Kind kind : kinds) {
        const auto error = [&](const Cloud& cloud, const Cloud& truth) {
            return worst_distance(fit::fit(runtime, input(cloud, kind, 1)), truth);
        };
        const double sphere_coarse = error(sphere(40), sphere(1500));
        const double sphere_fine = error(sphere(160), sphere(1500));
        EXPECT_LT(sphere_fine, 2e-3) << hrbfnpr::kernel::name(kind);
        EXPECT_LT(sphere_fine, 0.25 * sphere_coarse) << hrbfnpr::kernel::name(kind);
        const double torus_coarse = error(torus(60), torus(1500));
        const double torus_fine = error(torus(240), torus(1500));
        EXPECT_LT(torus_fine, 2e-3) << hrbfnpr::kernel::name(kind);
        EXPECT_LT(torus_fine, 0.25 * torus_coarse) << hrbfnpr::kernel::name(kind);
    }
}

TEST(Interpolation, IsNegativeInsideAndPositiveOutside) {
    const Runtime runtime;
    for (const Kind kind : {Kind::triharmonic, Kind::wendland_c2}) {
        const fit::FitResult result = fit::fit(runtime, input(sphere(200), kind, 1));
        for (const double r : {0.0, 0.3, 0.7, 0.95}) EXPECT_LT(at(result.data, {r, 0, 0}).value, 0.0) << r;
        for (const double r : {1.05, 1.5, 2.0, 5.0}) EXPECT_GT(at(result.data, {0, r, 0}).value, 0.0) << r;
    }
}

// f of the moved samples at the moved point is `scale` times f.
void expect_moved_along(Kind kind, double scale, const glm::dvec3& shift, double tolerance) {
    const Runtime runtime;
    const Cloud cloud = bumpy(80);
    const Cloud moved = cloud.moved(scale, shift);
    const fit::FitResult original = fit::fit(runtime, input(cloud, kind, 1));
    const fit::FitResult result = fit::fit(runtime, input(moved, kind, 1));
    EXPECT_NEAR(result.data.spacing, scale * original.data.spacing, tolerance * scale);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 p = 0.02 * i * cloud.point(i);
        const Sampled before = at(original.data, p);
        const Sampled after = at(result.data, scale * p + shift);
        EXPECT_NEAR(after.value / scale, before.value, tolerance) << hrbfnpr::kernel::name(kind) << " " << scale;
        EXPECT_NEAR(glm::distance(after.gradient, before.gradient), 0.0, tolerance);
    }
}

TEST(Interpolation, FollowsTheUnitOfLength) {
    for (const Kind kind : kinds)
        for (const double scale : {1e-6, 1e6, 1e-60, 1e60}) expect_moved_along(kind, scale, glm::dvec3(0.0), 1e-8);
}

TEST(Interpolation, FollowsATranslation) {
    // 1e4 diagonals: coordinates lose 5 of their 16 digits.
    for (const Kind kind : kinds) expect_moved_along(kind, 1.0, glm::dvec3(-2.7e4, 2.1e4, 1.1e4), 1e-6);
}

TEST(Interpolation, AKernelRadiusIsInTheUnitOfThePoints) {
    const Runtime runtime;
    const Cloud cloud = sphere(60);
    for (const Kind kind : {Kind::gaussian, Kind::wendland_c2}) {
        fit::FitInput chosen = input(cloud, kind, 1);
        const fit::FitResult automatic = fit::fit(runtime, chosen);
        EXPECT_GT(automatic.report.kernel_radius, 0.5 * automatic.data.spacing);
        chosen.kernel_radius = automatic.report.kernel_radius;
        const fit::FitResult given = fit::fit(runtime, chosen);
        EXPECT_DOUBLE_EQ(given.report.kernel_radius, automatic.report.kernel_radius);
        EXPECT_NEAR(at(given.data, {0.5, 0.6, 0.7}).value, at(automatic.data, {0.5, 0.6, 0.7}).value, 1e-10);
        chosen.kernel_radius *= 0.5;
        EXPECT_NE(at(fit::fit(runtime, chosen).data, {0.5, 0.6, 0.7}).value, at(automatic.data, {0.5, 0.6, 0.7}).value);
    }
}

} // namespace

} // namespace interpolation_test
