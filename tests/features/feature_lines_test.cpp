// SPDX-License-Identifier: MIT
#include "features/feature_lines.h"

#include "feature_shapes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace hrbfnpr::curves::feature_lines_test {
namespace {

using namespace test_features;
using test_shapes::seeds;

constexpr double pi = 3.14159265358979323846;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

FeatureRequest request_of(FeatureKind kind, double lower = 0.0, double upper = 0.0) {
    FeatureRequest request;
    request.kind = kind;
    request.lower = lower;
    request.upper = upper;
    return request;
}

Subject of(const implicit::Implicit& implicit, const glm::dvec3& seed, double side) {
    return {runtime(), implicit, seeds(runtime(), {seed}), side};
}

// Checks the conditions that every result must meet.
void expect_lines(const FeatureLines& lines) {
    ASSERT_EQ(lines.first.size(), lines.count() + 1);
    ASSERT_EQ(lines.first[0], 0);
    ASSERT_EQ(lines.first[lines.count()], lines.point.size());
    for (std::int64_t line = 0; line < lines.count(); ++line)
        EXPECT_GE(lines.first[line + 1] - lines.first[line], lines.closed[line] != 0 ? 3 : 2);
    for (std::int64_t i = 0; i < lines.point.size(); ++i) {
        EXPECT_NEAR(glm::length(lines.point[i].normal), 1.0, 1e-12);
        EXPECT_GE(lines.point[i].strength, 0.0);
    }
}

TEST(FeatureLines, ParabolicLinesOfATorusAreItsTopAndBottom) {
    const test::Torus torus(1.0, 0.35);
    const Subject subject = of(torus, {1.35, 0.0, 0.0}, 0.08);
    const FeatureLines lines = subject.find(runtime(), request_of(FeatureKind::parabolic));
    expect_lines(lines);
    ASSERT_EQ(lines.count(), 2);
    const double unit = torus.diagonal();
    for (std::int64_t line = 0; line < 2; ++line) {
        EXPECT_EQ(lines.closed[line], 1);
        EXPECT_NEAR(length(lines, line), 2.0 * pi, 0.01);
    }
    for (std::int64_t i = 0; i < lines.point.size(); ++i) {
        const glm::dvec3 p = lines.point[i].position;
        EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-5);
        EXPECT_NEAR(std::abs(p.z), 0.35, 1e-8);
        EXPECT_NEAR(std::abs(lines.point[i].normal.z), 1.0, 1e-6);
        // K = cos v / (r (R + r cos v)); its slope there is 1 / (r^2 R).
        EXPECT_NEAR(lines.point[i].strength, unit * unit * unit / (0.35 * 0.35), 1e-3 * lines.point[i].strength);
    }
}

TEST(FeatureLines, HysteresisAndLengthDropLinesAndCountThem) {
    const test::Torus torus(1.0, 0.35);
    const Subject subject = of(torus, {1.35, 0.0, 0.0}, 0.1);
    FeatureRequest request = request_of(FeatureKind::parabolic, 1.0, 1e4);
    FeatureLines lines = subject.find(runtime(), request);
    EXPECT_EQ(lines.count(), 0);
    EXPECT_EQ(lines.weak, 2);
    request.upper = 2.0;
    request.shortest = 7.0 / torus.diagonal();
    lines = subject.find(runtime(), request);
    EXPECT_EQ(lines.count(), 0);
    EXPECT_EQ(lines.too_short, 2);
    request.shortest = 6.0 / torus.diagonal();
    EXPECT_EQ(subject.find(runtime(), request).count(), 2);
}

TEST(FeatureLines, RidgeOfAnEllipsoidIsItsSharpestSection) {
    const glm::dvec3 axes(1.0, 0.7, 0.4);
    const AnyField field({-axes, axes}, [&](const glm::dvec3& p) { return ellipsoid(p, axes); });
    const Subject subject = of(field, {1.0, 0.0, 0.0}, 0.05);
    const FeatureLines lines = subject.find(runtime(), request_of(FeatureKind::ridge));
    expect_lines(lines);
    ASSERT_EQ(lines.count(), 1);
    EXPECT_EQ(lines.closed[0], 1);
    EXPECT_NEAR(length(lines, 0), 5.3823, 0.02); // the perimeter of its ellipse with the axes 1 and 0.7
    for (const FeaturePoint& p : lines.point) EXPECT_NEAR(p.position.z, 0.0, 1e-5);
    EXPECT_EQ(subject.find(runtime(), request_of(FeatureKind::valley)).count(), 0);
}

TEST(FeatureLines, RidgesOfARingWithAFlatTubeAreItsRims) {
    const AnyField field({glm::dvec3(-1.4, -1.4, -0.2), glm::dvec3(1.4, 1.4, 0.2)},
                         [](const glm::dvec3& p) { return elliptic_torus(p, 0.4, 0.2); });
    const Subject subject = of(field, {1.4, 0.0, 0.0}, 0.05);
    const FeatureLines lines = subject.find(runtime(), request_of(FeatureKind::ridge, 0.5, 1.0));
    expect_lines(lines);
    ASSERT_EQ(lines.count(), 2);
    for (std::int64_t line = 0; line < 2; ++line) {
        EXPECT_EQ(lines.closed[line], 1);
        const double radius =
            std::hypot(lines.point[lines.first[line]].position.x, lines.point[lines.first[line]].position.y);
        EXPECT_NEAR(std::min(std::abs(radius - 1.4), std::abs(radius - 0.6)), 0.0, 1e-5);
        EXPECT_NEAR(length(lines, line), 2.0 * pi * radius, 0.01);
    }
    for (const FeaturePoint& p : lines.point) EXPECT_NEAR(p.position.z, 0.0, 1e-5);
}

// The same surface turned inside out: ridges become valleys.
TEST(FeatureLines, RidgesBecomeValleysInsideOut) {
    const AnyField field({glm::dvec3(-1.4, -1.4, -0.2), glm::dvec3(1.4, 1.4, 0.2)}, [](const glm::dvec3& p) {
        Field f = elliptic_torus(p, 0.4, 0.2);
        for (double& h : f.hessian) h = -h;
        return Field{-f.value, -f.gradient, f.hessian};
    });
    const Subject subject = of(field, {1.4, 0.0, 0.0}, 0.05);
    EXPECT_EQ(subject.find(runtime(), request_of(FeatureKind::valley, 0.5, 1.0)).count(), 2);
    EXPECT_EQ(subject.find(runtime(), request_of(FeatureKind::ridge, 0.5, 1.0)).count(), 0);
}

TEST(FeatureLines, ASphereAndARoundTubeHaveNoRidges) {
    const test::Sphere sphere(1.0);
    const test::Torus torus(1.0, 0.35);
    for (const auto kind : {FeatureKind::ridge, FeatureKind::valley}) {
        EXPECT_EQ(of(sphere, {1.0, 0.0, 0.0}, 0.1).find(runtime(), request_of(kind, 0.1, 0.1)).count(), 0);
        EXPECT_EQ(of(torus, {1.35, 0.0, 0.0}, 0.1).find(runtime(), request_of(kind, 0.1, 0.1)).count(), 0);
    }
}

TEST(FeatureLines, SectionsOfATorusAreCircles) {
    const test::Torus torus(1.0, 0.35);
    const Subject subject = of(torus, {1.35, 0.0, 0.0}, 0.08);
    const std::array<double, 4> levels = {-0.2, 0.0, 0.1, 0.5};
    FeatureRequest request = request_of(FeatureKind::section);
    request.levels = levels;
    const FeatureLines lines = subject.find(runtime(), request);
    expect_lines(lines);
    EXPECT_EQ(lines.unresolved, 0);
    ASSERT_EQ(lines.count(), 6) << "two in each plane, none in the last";
    for (std::int64_t line = 0; line < 6; ++line) {
        EXPECT_EQ(lines.closed[line], 1);
        const double height = levels[static_cast<std::size_t>(lines.level[line])];
        const double half = std::sqrt(0.35 * 0.35 - height * height);
        for (std::int64_t i = lines.first[line]; i < lines.first[line + 1]; ++i) {
            const glm::dvec3 p = lines.point[i].position;
            EXPECT_NEAR(p.z, height, 1e-8);
            EXPECT_NEAR(std::abs(std::hypot(p.x, p.y) - 1.0), half, 1e-8);
            EXPECT_NEAR(lines.point[i].strength, half / 0.35, 1e-7);
        }
    }
}

// f > 0 outside. For a walker along the line whose up is outside, the part below the plane is to the left.
TEST(FeatureLines, UndirectedLinesHaveTheNegativeSideToTheirLeft) {
    const test::Sphere sphere(1.0);
    const Subject subject = of(sphere, {1.0, 0.0, 0.0}, 0.1);
    const std::array<double, 1> levels = {0.3};
    FeatureRequest request = request_of(FeatureKind::section);
    request.levels = levels;
    const FeatureLines lines = subject.find(runtime(), request);
    ASSERT_EQ(lines.count(), 1);
    for (std::int64_t i = 0; i + 1 < lines.point.size(); ++i) {
        const glm::dvec3 step = lines.point[i + 1].position - lines.point[i].position;
        EXPECT_LT(glm::cross(lines.point[i].normal, step).z, 0.0);
    }
}

TEST(FeatureLines, IsophotesOfASphereAreCirclesAboutTheLight) {
    const test::Sphere sphere(1.0);
    const Subject subject = of(sphere, {1.0, 0.0, 0.0}, 0.1);
    const std::array<double, 3> levels = {0.2, 0.5, 0.8};
    FeatureRequest request = request_of(FeatureKind::isophote);
    request.levels = levels;
    request.towards = {2.0, -1.0, 2.0, 0.0};
    const glm::dvec3 light(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0);
    const FeatureLines lines = subject.find(runtime(), request);
    expect_lines(lines);
    EXPECT_EQ(lines.unresolved, 0);
    ASSERT_EQ(lines.count(), 3);
    for (std::int64_t line = 0; line < 3; ++line) {
        EXPECT_EQ(lines.closed[line], 1);
        const double level = levels[static_cast<std::size_t>(lines.level[line])];
        for (std::int64_t i = lines.first[line]; i < lines.first[line + 1]; ++i) {
            EXPECT_NEAR(glm::dot(lines.point[i].position, light), level, 1e-5);
            EXPECT_NEAR(lines.point[i].strength, std::sqrt(1.0 - level * level) * sphere.diagonal(), 1e-2);
        }
    }
}

// B(w, w) on a torus and its slope, with the angles u around the axis and v around the tube.
struct OnTorus {
    glm::dvec3 position, normal;
    double g, strength;

    OnTorus(double u, double v, const glm::dvec4& eye, double unit) {
        const glm::dvec3 out(std::cos(u), std::sin(u), 0.0);
        const glm::dvec3 around(-out.y, out.x, 0.0);
        normal = std::cos(v) * out + glm::dvec3(0.0, 0.0, std::sin(v));
        const glm::dvec3 meridian = -std::sin(v) * out + glm::dvec3(0.0, 0.0, std::cos(v));
        position = out + 0.35 * normal;
        const double parallel = std::cos(v) / (1.0 + 0.35 * std::cos(v));
        const glm::dvec3 view = glm::normalize(glm::dvec3(eye) - eye.w * position);
        const double wu = glm::dot(view, around);
        const double wv = glm::dot(view, meridian);
        const double facing = glm::dot(view, normal);
        g = parallel * wu * wu + wv * wv / 0.35;
        // The slope has a part by `parallel` and a part by the turning frame. Along the meridian `parallel` changes by
        // -sin v / (1 + r cos v)^2 over r.
        const double change = -std::sin(v) / ((1.0 + 0.35 * std::cos(v)) * (1.0 + 0.35 * std::cos(v))) / 0.35;
        const double ring = 1.0 + 0.35 * std::cos(v);
        const double c112 = change;                                        // the change of B along the meridian
        const double mixed = (1.0 / 0.35 - parallel) * std::sin(v) / ring; // the same number, by Codazzi
        EXPECT_NEAR(c112, -mixed, 1e-9);
        strength = 3.0 * c112 * wu * wu * wv - 2.0 * facing * (parallel * parallel * wu * wu + wv * wv / 0.1225);
        strength *= unit * unit / (wu * wu + wv * wv);
        if (facing < 0.0) strength = -1.0;
    }
};

// A reference that shares no code with the library: the sign changes of g on a grid of 2400 x 1200 angles.
std::vector<glm::dvec3> suggestive_of_torus(const glm::dvec4& eye, double unit, double least) {
    std::vector<glm::dvec3> found;
    constexpr int rows = 1200;
    for (int i = 0; i < 2 * rows; ++i) {
        const double u = pi * i / rows;
        OnTorus before(u, 0.0, eye, unit);
        for (int k = 1; k <= rows; ++k) {
            const OnTorus here(u, 2.0 * pi * k / rows, eye, unit);
            const double share = before.g / (before.g - here.g);
            if ((before.g < 0.0) != (here.g < 0.0) && std::min(before.strength, here.strength) >= least)
                found.push_back(glm::mix(before.position, here.position, share));
            before = here;
        }
    }
    for (int k = 0; k < rows; ++k) {
        OnTorus before(0.0, 2.0 * pi * k / rows, eye, unit);
        for (int i = 1; i <= 2 * rows; ++i) {
            const OnTorus here(pi * i / rows, 2.0 * pi * k / rows, eye, unit);
            const double share = before.g / (before.g - here.g);
            if ((before.g < 0.0) != (here.g < 0.0) && std::min(before.strength, here.strength) >= least)
                found.push_back(glm::mix(before.position, here.position, share));
            before = here;
        }
    }
    return found;
}

class Suggestive : public testing::TestWithParam<glm::dvec4> {};

TEST_P(Suggestive, ContoursOfATorusMatchADenseReference) {
    const test::Torus torus(1.0, 0.35);
    const Subject subject = of(torus, {1.35, 0.0, 0.0}, 0.06);
    const double unit = torus.diagonal();
    const double pixel = unit / 720.0;
    FeatureRequest request = request_of(FeatureKind::suggestive_contour, 2.0, 2.0);
    request.towards = GetParam();
    const FeatureLines lines = subject.find(runtime(), request);
    expect_lines(lines);
    EXPECT_EQ(lines.unresolved, 0);
    ASSERT_GT(lines.count(), 0);
    const double precision = Places(suggestive_of_torus(GetParam(), unit, 1.9), pixel).share(along(lines, pixel));
    EXPECT_GE(precision, 0.99);
    const double recall = Places(along(lines, pixel), pixel).share(suggestive_of_torus(GetParam(), unit, 2.1));
    EXPECT_GE(recall, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Eyes, Suggestive,
                         testing::Values(glm::dvec4(0.0, -0.8, 0.6, 0.0), glm::dvec4(1.0, 3.0, 1.6, 1.0),
                                         glm::dvec4(-0.6, 0.7, 0.45, 0.0)));

TEST(FeatureLines, ApparentRidgesAreMaximaOfViewDependentCurvature) {
    const glm::dvec3 axes(1.0, 0.7, 0.4);
    const AnyField field({-axes, axes}, [&](const glm::dvec3& p) { return ellipsoid(p, axes); });
    const Subject subject = of(field, {1.0, 0.0, 0.0}, 0.05);
    FeatureRequest request = request_of(FeatureKind::apparent_ridge, 1.0, 2.0);
    request.towards = {0.0, -1.0, 0.05, 0.0};
    const FeatureLines lines = subject.find(runtime(), request);
    expect_lines(lines);
    ASSERT_GT(lines.count(), 0);
    std::int64_t maxima = 0;
    for (std::int64_t i = 0; i < lines.point.size(); ++i) {
        const double h = 2e-3;
        std::array<double, 3> q{};
        for (int k = -1; k <= 1; ++k) {
            // The nearby point of the ellipsoid itself: the direction scaled onto the surface.
            const Field f = ellipsoid(lines.point[i].position, axes);
            const ShapePoint here = shape_point(f.gradient, f.hessian, {});
            const FeatureValue v = feature_value(request.kind, here, lines.point[i].position, request.towards, 1.0);
            glm::dvec3 p = lines.point[i].position + k * h * v.along;
            p /= std::sqrt(ellipsoid(p, axes).value + 1.0);
            const Field g = ellipsoid(p, axes);
            q[static_cast<std::size_t>(k + 1)] =
                feature_value(request.kind, shape_point(g.gradient, g.hessian, {}), p, request.towards, 1.0).strength;
        }
        maxima += q[1] > q[0] && q[1] > q[2] ? 1 : 0;
    }
    EXPECT_EQ(maxima, lines.point.size());
    EXPECT_LE(lines.unresolved, 60); // these are at the contour, where q1 has a pole
}

} // namespace
} // namespace hrbfnpr::curves::feature_lines_test
