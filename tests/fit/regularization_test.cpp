// SPDX-License-Identifier: MIT
#include "shapes.h"

#include "dense.h"
#include "kernel/polynomial.h"

#include <gtest/gtest.h>

namespace regularization_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
namespace kernel = hrbfnpr::kernel;
using kernel::Kind;
using namespace fit_test;

namespace {

// Solves the system of the definition, with a linear polynomial, in coordinates in which the diagonal is 1, and with
// eta added to the diagonal of A. Returns f and its gradient at `at`.
Sampled by_definition(const Cloud& cloud, Kind kind, double radius, double eta, const glm::dvec3& at) {
    hrbfnpr::geometry::Bounds bounds;
    for (std::int64_t i = 0; i < cloud.count(); ++i) bounds.extend(cloud.point(i));
    const double diagonal = bounds.diagonal();
    const auto x = [&](std::int64_t i) { return (cloud.point(i) - bounds.centre()) / diagonal; };
    const Eigen::Index n = cloud.count();
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(4 * n + 4, 4 * n + 4);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(4 * n + 4);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const glm::dvec3 g = x(i) - x(j);
            const Eigen::Vector3d d(g.x, g.y, g.z);
            const kernel::Radial r = kernel::radial(kind, radius / diagonal, d.norm());
            k(4 * i, 4 * j) = r.phi;
            k.block<3, 1>(4 * i + 1, 4 * j) = r.a * d;
            k.block<1, 3>(4 * i, 4 * j + 1) = -r.a * d.transpose();
            k.block<3, 3>(4 * i + 1, 4 * j + 1) = -(r.a * Eigen::Matrix3d::Identity() + r.b * d * d.transpose());
        }
        k(4 * i, 4 * n) = k(4 * n, 4 * i) = 1.0;
        for (int c = 0; c < 3; ++c) {
            k(4 * i, 4 * n + 1 + c) = k(4 * n + 1 + c, 4 * i) = x(i)[c];
            k(4 * i + 1 + c, 4 * n + 1 + c) = k(4 * n + 1 + c, 4 * i + 1 + c) = 1.0;
            rhs[4 * i + 1 + c] = cloud.normal(i)[c];
        }
    }
    k.diagonal().head(4 * n).array() += eta;
    const Eigen::VectorXd w = fit_test::solved(k, rhs);
    const glm::dvec3 y = (at - bounds.centre()) / diagonal;
    Sampled s;
    s.gradient = {w[4 * n + 1], w[4 * n + 2], w[4 * n + 3]};
    s.value = w[4 * n] + glm::dot(s.gradient, y);
    for (Eigen::Index j = 0; j < n; ++j) {
        const glm::dvec3 d = y - x(j);
        const glm::dvec3 beta(w[4 * j + 1], w[4 * j + 2], w[4 * j + 3]);
        const kernel::Radial r = kernel::radial(kind, radius / diagonal, glm::length(d));
        s.value += w[4 * j] * r.phi - r.a * glm::dot(beta, d);
        s.gradient += w[4 * j] * r.a * d - (r.a * beta + r.b * glm::dot(beta, d) * d);
    }
    s.value *= diagonal;
    return s;
}

TEST(Regularization, IsAddedInCoordinatesWithUnitDiagonal) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(40).moved(25.0, {3, 4, 5});
    for (const Kind kind : {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2}) {
        for (const double eta : {1e-4, 1e-2}) {
            fit::FitInput smoothed = input(cloud, kind, 1);
            smoothed.regularization = eta;
            const fit::FitResult result = fit::fit(runtime, smoothed);
            for (const glm::dvec3& p : {glm::dvec3(3, 4, 5), glm::dvec3(20, -10, 12), cloud.point(3)}) {
                const Sampled expected = by_definition(cloud, kind, result.report.kernel_radius, eta, p);
                const Sampled found = at(result.data, p);
                EXPECT_NEAR(found.value, expected.value, 1e-7) << kernel::name(kind) << eta;
                EXPECT_NEAR(glm::distance(found.gradient, expected.gradient), 0.0, 1e-8) << kernel::name(kind) << eta;
            }
        }
    }
}

Cloud noisy_sphere(double noise) {
    const Cloud cloud = sphere(150);
    Cloud result;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const double wobble = std::sin(91.7 * static_cast<double>(i * i % 97));
        result.add((1.0 + noise * wobble) * cloud.point(i), cloud.normal(i));
    }
    return result;
}

double deviation_from_sphere(const fit::FitResult& result) {
    const Cloud truth = sphere(500);
    double sum = 0.0;
    for (std::int64_t i = 0; i < truth.count(); ++i) sum += std::pow(distance(result.data, truth.point(i)), 2);
    return std::sqrt(sum / 500.0);
}

TEST(Regularization, SmoothsNoise) {
    const base::Runtime runtime;
    const Cloud cloud = noisy_sphere(0.02);
    for (const Kind kind : {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2}) {
        double residual = -1.0;
        double deviation = HUGE_VAL;
        for (const double eta : {0.0, 1e-5, 1e-4, 1e-3}) {
            fit::FitInput smoothed = input(cloud, kind, 1);
            smoothed.regularization = eta;
            const fit::FitResult result = fit::fit(runtime, smoothed);
            EXPECT_GT(result.report.value_residual_rms, residual) << kernel::name(kind) << eta;
            residual = result.report.value_residual_rms;
            const double now = deviation_from_sphere(result);
            EXPECT_LT(now, deviation) << kernel::name(kind) << eta;
            deviation = now;
            EXPECT_EQ(result.report.regularization, eta);
        }
    }
}

} // namespace

} // namespace regularization_test
