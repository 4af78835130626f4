// SPDX-License-Identifier: MIT
#include "features/feature_lines.h"

#include "feature_shapes.h"
#include "surface/curvature.h"
#include "surface/project.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves::shape_test {
namespace {

using namespace test_features;

const glm::dvec3 axes(1.0, 0.7, 0.45);

base::Runtime& runtime() {
    static base::Runtime instance;
    return instance;
}

// The field of an ellipsoid plus a cubic term: it is not a distance, and its third derivatives are not 0.
const AnyField& bent() {
    static const AnyField field(test::cube(1.0), [](const glm::dvec3& p) {
        const Field e = ellipsoid(p, axes);
        const double twist = 0.3 * p.x * p.y * p.z;
        const glm::dvec3 g = 0.3 * glm::dvec3(p.y * p.z, p.x * p.z, p.x * p.y);
        return Field{e.value + twist, e.gradient + g,
                     e.hessian + test::Hessian{0.0, 0.3 * p.z, 0.3 * p.y, 0.0, 0.3 * p.x, 0.0}};
    });
    return field;
}

struct On {
    glm::dvec3 position;
    ShapePoint shape;
};

On at(const implicit::Implicit& surface, const glm::dvec3& p) {
    surface::Projection projection(runtime().memory);
    projection.position.push_back(p);
    surface::ProjectionSettings settings;
    settings.tolerance = 1e-14;
    surface::project(runtime(), surface, settings, projection);
    base::Array<ShapePoint> shape(runtime().memory);
    measure_shape(runtime(), implicit::DifferencedShape(surface), projection.position, projection.gradient, shape);
    return {projection.position[0], shape[0]};
}

std::vector<glm::dvec3> places() {
    std::vector<glm::dvec3> result;
    for (int i = 0; i < 60; ++i) {
        const auto [x, y, z] = test::spiral_point(i, 60);
        result.push_back(axes * glm::dvec3(x, y, z));
    }
    return result;
}

TEST(Shape, HasTheCurvaturesOfTheSurface) {
    for (const glm::dvec3& p : places()) {
        const On here = at(bent(), p);
        const Field field = bent().at(here.position);
        const surface::Curvature expected = surface::principal_curvature(field.gradient, field.hessian, 1.0);
        EXPECT_NEAR(here.shape.k1, expected.k1, 1e-9);
        EXPECT_NEAR(here.shape.k2, expected.k2, 1e-9);
        if (expected.confidence > 0.1) {
            EXPECT_NEAR(std::abs(glm::dot(here.shape.d1, expected.d1)), 1.0, 1e-9);
        }
    }
}

// C holds the derivatives of the curvatures along the surface; the test compares it with their differences.
TEST(Shape, HasTheDerivativesOfTheCurvatures) {
    const double h = 1e-4;
    int checked = 0;
    for (const glm::dvec3& p : places()) {
        const On here = at(bent(), p);
        if (here.shape.k1 - here.shape.k2 < 0.3) continue;
        ++checked;
        const auto slope = [&](const glm::dvec3& direction) {
            const ShapePoint low = at(bent(), here.position - h * direction).shape;
            const ShapePoint high = at(bent(), here.position + h * direction).shape;
            return glm::dvec2(high.k1 - low.k1, high.k2 - low.k2) / (2.0 * h);
        };
        const glm::dvec2 first = slope(here.shape.d1);
        const glm::dvec2 other = slope(here.shape.d2());
        const double scale = 1.0 + std::abs(here.shape.k2 * here.shape.k2);
        EXPECT_NEAR(here.shape.c[0], first.x, 1e-6 * scale);
        EXPECT_NEAR(here.shape.c[1], other.x, 1e-6 * scale);
        EXPECT_NEAR(here.shape.c[2], first.y, 1e-6 * scale);
        EXPECT_NEAR(here.shape.c[3], other.y, 1e-6 * scale);
    }
    EXPECT_GT(checked, 40);
}

TEST(Shape, HasNoNormalWithoutAGradient) {
    const ShapePoint none = shape_point(glm::dvec3(0.0), {1, 0, 0, 1, 0, 1}, {});
    EXPECT_EQ(none.normal, glm::dvec3(0.0));
    const ShapePoint broken = shape_point({0, 0, 1}, {std::nan(""), 0, 0, 1, 0, 1}, {});
    EXPECT_EQ(broken.normal, glm::dvec3(0.0));
    EXPECT_LT(feature_value(FeatureKind::ridge, broken, {}, {}, 1.0).strength, 0.0);
}

glm::dvec3 to_eye(const glm::dvec4& eye, const glm::dvec3& p) { return glm::normalize(glm::dvec3(eye) - eye.w * p); }

// Radial curvature is minus the derivative of n . v along w. Differences of normals give it here.
double radial(const On& here, const glm::dvec4& eye) {
    const glm::dvec3 v = to_eye(eye, here.position);
    const glm::dvec3 w = v - glm::dot(v, here.shape.normal) * here.shape.normal;
    const double h = 1e-4;
    const glm::dvec3 low = at(bent(), here.position - h * w).shape.normal;
    const glm::dvec3 high = at(bent(), here.position + h * w).shape.normal;
    return glm::dot(high - low, w) / (2.0 * h);
}

class FeatureValues : public testing::TestWithParam<glm::dvec4> {};

TEST_P(FeatureValues, SuggestiveValueIsRadialCurvature) {
    const glm::dvec4 eye = GetParam();
    for (const glm::dvec3& p : places()) {
        const On here = at(bent(), p);
        const FeatureValue value = feature_value(FeatureKind::suggestive_contour, here.shape, here.position, eye, 1.0);
        EXPECT_NEAR(value.g, radial(here, eye), 1e-5);
    }
}

// The largest turn of the normal for a unit step in the image; it is found by trying all directions.
double view_curvature(const On& here, const glm::dvec4& eye) {
    const glm::dvec3 v = to_eye(eye, here.position);
    double largest = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double angle = k * 3.14159265358979 / 4000.0;
        const glm::dvec2 u(std::cos(angle), std::sin(angle));
        const glm::dvec3 on_surface = here.shape.in_space(u);
        const double seen = glm::length(on_surface - glm::dot(on_surface, v) * v);
        largest = std::max(largest, glm::length(here.shape.bend(u)) / seen);
    }
    return largest;
}

TEST_P(FeatureValues, ApparentRidgeValueIsTheSlopeOfViewDependentCurvature) {
    const glm::dvec4 eye = GetParam();
    int checked = 0;
    for (const glm::dvec3& p : places()) {
        const On here = at(bent(), p);
        const double facing = glm::dot(here.shape.normal, to_eye(eye, here.position));
        const FeatureValue value = feature_value(FeatureKind::apparent_ridge, here.shape, here.position, eye, 1.0);
        if (std::abs(facing) < 0.25) continue;
        ++checked;
        EXPECT_NEAR(value.strength, view_curvature(here, eye), 1e-4 * value.strength);
        const double h = 1e-3;
        const double low = view_curvature(at(bent(), here.position - h * value.along), eye);
        const double high = view_curvature(at(bent(), here.position + h * value.along), eye);
        const double slope = (high * high - low * low) / (2.0 * h);
        EXPECT_NEAR(value.g / std::abs(facing * facing * facing), slope, 1e-3 * (1.0 + std::abs(slope)));
    }
    EXPECT_GT(checked, 20);
}

// Where radial curvature is 0, the strength is the slope of the radial curvature.
TEST_P(FeatureValues, SuggestiveStrengthIsTheSlopeTowardsTheEye) {
    const glm::dvec4 eye = GetParam();
    const test::Torus torus;
    int checked = 0;
    for (int i = 0; i < 60; ++i) {
        const double around = 0.105 * i;
        const auto on = [&](double v) {
            const glm::dvec3 out(std::cos(around), std::sin(around), 0.0);
            return at(torus, (1.0 + 0.35 * std::cos(v)) * out + glm::dvec3(0.0, 0.0, 0.35 * std::sin(v)));
        };
        const auto value = [&](const On& here) {
            return feature_value(FeatureKind::suggestive_contour, here.shape, here.position, eye, 1.0);
        };
        for (int k = 0; k < 30; ++k) {
            double low = 0.21 * k;
            double high = low + 0.21;
            if ((value(on(low)).g < 0.0) == (value(on(high)).g < 0.0)) continue;
            for (int step = 0; step < 45; ++step) {
                const double middle = 0.5 * (low + high);
                ((value(on(middle)).g < 0.0) == (value(on(low)).g < 0.0) ? low : high) = middle;
            }
            const On here = on(low);
            const glm::dvec3 v = to_eye(eye, here.position);
            const double facing = glm::dot(v, here.shape.normal);
            const glm::dvec3 w = v - facing * here.shape.normal;
            const double sine = glm::length(w);
            if (sine < 0.1 || std::abs(facing) < 0.1) continue;
            ++checked;
            const double h = 1e-4;
            const auto curvature = [&](const On& there) {
                const glm::dvec3 view = to_eye(eye, there.position);
                const double cosine = glm::dot(view, there.shape.normal);
                return value(there).g / (1.0 - cosine * cosine);
            };
            const double slope = (curvature(at(torus, here.position + h * w / sine)) -
                                  curvature(at(torus, here.position - h * w / sine))) /
                                 (2.0 * h);
            EXPECT_NEAR(value(here).strength, slope * sine, 1e-4 * (1 + std::abs(slope)));
        }
    }
    EXPECT_GT(checked, 40);
}

INSTANTIATE_TEST_SUITE_P(Near, FeatureValues, testing::Values(glm::dvec4(1.5, 2.0, 1.0, 1.0)));
INSTANTIATE_TEST_SUITE_P(Far, FeatureValues, testing::Values(glm::dvec4(0.3, -0.9, 0.6, 0.0)));

} // namespace
} // namespace hrbfnpr::curves::shape_test
