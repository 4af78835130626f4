// SPDX-License-Identifier: MIT
#include "surface/curvature.h"

#include "geometry/tangent_frame.h"
#include "support/analytic.h"

#include <gtest/gtest.h>

namespace hrbfnpr::surface::curvature_test {
namespace {

using namespace test;

Curvature of(const Analytic& surface, const glm::dvec3& p) {
    const Field field = surface.at(p);
    return principal_curvature(field.gradient, field.hessian, surface.diagonal());
}

void expect_frame(const Curvature& c, const glm::dvec3& n) {
    EXPECT_NEAR(glm::length(c.d1), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(c.d2), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(c.d1, c.d2), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(c.d1, n), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(c.d2, n), 0.0, 1e-12);
    EXPECT_GE(c.k1, c.k2);
}

TEST(Curvature, SphereHasEqualNegativeCurvatures) {
    const Sphere sphere(2.5);
    for (int i = 0; i < 200; ++i) {
        const auto [x, y, z] = spiral_point(i, 200);
        const glm::dvec3 n(x, y, z);
        const Curvature c = of(sphere, 2.5 * n);
        EXPECT_NEAR(c.k1, -0.4, 1e-10);
        EXPECT_NEAR(c.k2, -0.4, 1e-10);
        EXPECT_NEAR(c.confidence, 0.0, 1e-9);
        expect_frame(c, n);
        // At umbilics the directions are those of the combing field, which are smooth inside each of its regions.
        EXPECT_NEAR(std::abs(glm::dot(c.d1, geometry::combing_frame(n).r)), 1.0, 1e-9);
    }
}

TEST(Curvature, DoesNotDependOnTheScaleOfTheFunction) {
    const SquareSphere sphere(1.0); // |grad f| = 2 on the sphere, and the gradient has unit length only at |p| = 1/2
    const Curvature c = of(sphere, {0.48, 0.6, 0.64});
    EXPECT_NEAR(c.k1, -1.0, 1e-12);
    EXPECT_NEAR(c.k2, -1.0, 1e-12);
    const Curvature level_set = of(sphere, {0.0, 0.0, 3.0});
    EXPECT_NEAR(level_set.k1, -1.0 / 3.0, 1e-12);
}

TEST(Curvature, TorusHasItsMeridiansAndParallels) {
    constexpr double ring = 1.0;
    constexpr double tube = 0.35;
    const Torus torus(ring, tube);
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            const double around = 0.157 * i;
            const double v = 0.157 * j + 0.01;
            const glm::dvec3 out(std::cos(around), std::sin(around), 0.0);
            const glm::dvec3 n = std::cos(v) * out + glm::dvec3(0.0, 0.0, std::sin(v));
            const Curvature c = of(torus, ring * out + tube * n);
            const double along_parallel = -std::cos(v) / (ring + tube * std::cos(v));
            EXPECT_NEAR(c.k1, along_parallel, 1e-8);
            EXPECT_NEAR(c.k2, -1.0 / tube, 1e-8);
            expect_frame(c, n);
            EXPECT_NEAR(std::abs(glm::dot(c.d1, {-out.y, out.x, 0.0})), 1.0, 1e-8);
            EXPECT_GT(c.confidence, 0.4);
        }
    }
}

TEST(Curvature, CylinderIsFlatAlongItsAxis) {
    const Curvature c = of(Cylinder(0.5), {0.3, 0.4, 0.2});
    EXPECT_NEAR(c.k1, 0.0, 1e-12);
    EXPECT_NEAR(c.k2, -2.0, 1e-12);
    EXPECT_NEAR(std::abs(c.d1.z), 1.0, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(c.d2, {-0.8, 0.6, 0.0})), 1.0, 1e-12);
    EXPECT_NEAR(c.confidence, 1.0, 1e-3);
}

TEST(Curvature, PlaneHasZeroCurvatureAndConfidence) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
    const Curvature c = of(Plane(5.0 * n, 0.0, cube(1.0)), {0.0, 0.0, 0.0});
    EXPECT_EQ(c.k1, 0.0);
    EXPECT_EQ(c.k2, 0.0);
    EXPECT_EQ(c.confidence, 0.0);
    expect_frame(c, n);
}

// Saddles and bowls of any size: k1 >= k2, and the confidence follows its formula.
TEST(Curvature, ConfidenceIsTheDocumentedFormula) {
    for (const auto& [a, b] : {std::pair{3.0, -2.0}, {3.0, 2.9}, {-1.0, -1.5}, {1e-5, -1e-5}}) {
        // f = z - (a x^2 + b y^2) / 2: at the origin n = z, and the surface bends towards n with a and b.
        const Hessian hessian = {-a, 0.0, 0.0, -b, 0.0, 0.0};
        const double diagonal = 4.0;
        const Curvature c = principal_curvature({0.0, 0.0, 1.0}, hessian, diagonal);
        EXPECT_NEAR(c.k1, std::max(a, b), 1e-14);
        EXPECT_NEAR(c.k2, std::min(a, b), 1e-14);
        EXPECT_NEAR(c.confidence, (c.k1 - c.k2) / (std::abs(a) + std::abs(b) + 1e-3 / diagonal), 1e-14);
    }
}

// Kindlmann's T and F, as published, for a Hessian that is not aligned with any axis.
TEST(Curvature, AgreesWithTraceAndFrobeniusNormOfG) {
    const glm::dvec3 g(0.3, -1.2, 0.7);
    const Hessian h = {0.9, -0.4, 1.3, 0.2, 0.8, -1.1};
    const glm::dmat3 full(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]);
    const glm::dvec3 n = glm::normalize(g);
    const glm::dmat3 p = glm::dmat3(1.0) - glm::outerProduct(n, n);
    const glm::dmat3 G = -(p * full * p) / glm::length(g);
    double trace = 0.0;
    double frobenius2 = 0.0;
    for (int i = 0; i < 3; ++i) {
        trace += G[i][i];
        for (int j = 0; j < 3; ++j) frobenius2 += G[i][j] * G[i][j];
    }
    const double root = std::sqrt(2.0 * frobenius2 - trace * trace);
    const Curvature c = principal_curvature(g, h, 1.0);
    EXPECT_NEAR(c.k1, 0.5 * (trace + root), 1e-12);
    EXPECT_NEAR(c.k2, 0.5 * (trace - root), 1e-12);
    EXPECT_NEAR(glm::length(G * c.d1 - c.k1 * c.d1), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(G * c.d2 - c.k2 * c.d2), 0.0, 1e-12);
    expect_frame(c, n);
}

TEST(Curvature, DirectionsBlendSmoothlyIntoTheFallback) {
    // The surface becomes less and less umbilic. The direction, as a line, moves in small steps.
    glm::dvec3 before(0.0);
    for (int i = 0; i <= 400; ++i) {
        const double difference = 1e-4 * i;
        const double c = std::cos(0.5);
        const double s = std::sin(0.5);
        const glm::dvec3 d(c, s, 0.0);
        const Hessian h = identity(1.0) + outer(d, d, -difference);
        const Curvature k = principal_curvature({0.0, 0.0, 1.0}, h, 1.0);
        if (i > 0) {
            EXPECT_GT(std::abs(glm::dot(k.d1, before)), 0.999) << i;
        }
        before = k.d1;
        if (k.confidence > 0.02) {
            EXPECT_NEAR(std::abs(glm::dot(k.d1, d)), 1.0, 1e-12);
        }
    }
}

TEST(Curvature, MissingGradientsAndNaNGiveZeros) {
    const Hessian h = identity(1.0);
    const auto expect_zero = [](const Curvature& c) {
        EXPECT_EQ(c.k1, 0.0);
        EXPECT_EQ(c.k2, 0.0);
        EXPECT_EQ(c.confidence, 0.0);
        EXPECT_EQ(c.d1, glm::dvec3(0.0));
        EXPECT_EQ(c.d2, glm::dvec3(0.0));
    };
    expect_zero(principal_curvature(glm::dvec3(0.0), h, 1.0));
    expect_zero(principal_curvature({std::nan(""), 0.0, 1.0}, h, 1.0));
    Hessian broken = h;
    broken[4] = std::nan("");
    expect_zero(principal_curvature({0.0, 0.0, 1.0}, broken, 1.0));
    const Hessian steep = {1e200, 0.0, 0.0, -1e200, 0.0, 0.0}; // divided by the slope it exceeds the largest double
    expect_zero(principal_curvature({0.0, 0.0, 1e-150}, steep, 1.0));
}

TEST(Curvature, BatchesMatchSinglePoints) {
    const Torus torus;
    const base::Runtime runtime;
    geometry::VecArray points(runtime.memory);
    for (int i = 0; i < 600; ++i) {
        const auto [x, y, z] = spiral_point(i, 600);
        points.push_back(glm::dvec3(1.2 * x, 1.2 * y, 0.3 * z));
    }
    base::Array<Curvature> result(runtime.memory);
    principal_curvatures(runtime, torus, points, result);
    ASSERT_EQ(result.size(), 600);
    for (int i = 0; i < 600; ++i) {
        const Curvature c = of(torus, points[i]);
        EXPECT_EQ(c.k1, result[i].k1);
        EXPECT_EQ(c.d1, result[i].d1);
        EXPECT_EQ(c.confidence, result[i].confidence);
    }
    base::Operation operation;
    operation.begin();
    operation.cancel();
    EXPECT_THROW(principal_curvatures({runtime, base::Progress(&operation)}, torus, points, result), Error);
}

TEST(Eigen2, SolvesTheSymmetricProblem) {
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 m(std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0));
        const Eigen2 e = symmetric_eigen2(m.x, m.y, m.z);
        EXPECT_GE(e.high, e.low);
        EXPECT_NEAR(m.x * e.cosine + m.y * e.sine, e.high * e.cosine, 1e-14);
        EXPECT_NEAR(m.y * e.cosine + m.z * e.sine, e.high * e.sine, 1e-14);
        EXPECT_NEAR(e.high + e.low, m.x + m.z, 1e-14);
        EXPECT_NEAR(e.high * e.low, m.x * m.z - m.y * m.y, 1e-14);
    }
    const Eigen2 umbilic = symmetric_eigen2(2.0, 0.0, 2.0);
    EXPECT_EQ(umbilic.high, 2.0);
    EXPECT_EQ(umbilic.low, 2.0);
    const Eigen2 nearly = symmetric_eigen2(1.0, 1e-20, 1.0);
    EXPECT_EQ(nearly.high - nearly.low, 0.0) << "below rounding";
    EXPECT_NEAR(nearly.cosine, std::sqrt(0.5), 1e-15) << "and yet the direction is right";
}

} // namespace
} // namespace hrbfnpr::surface::curvature_test
