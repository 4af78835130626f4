// SPDX-License-Identifier: MIT
// Tests what lines follow, on shapes where that is known.
#include "geometry/tangent_frame.h"
#include "support/line_spacing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::hatching::guides_test {
namespace {

using namespace marks;
using namespace test;

generate::Settings guided(Guide guide, double separation = 0.05) {
    generate::Settings settings = blue({Kind::hatch}, 0);
    of(settings, Kind::hatch).hatching.separation = separation;
    of(settings, Kind::hatch).hatching.field.guide = guide;
    return settings;
}

FieldSettings& field(generate::Settings& settings) { return of(settings, Kind::hatch).hatching.field; }

// The mean angle, in degrees, between lines and wanted(position, normal), where that vector is longer than `least`.
template <class Wanted>
double mean_angle(const PointSet& set, double least, Wanted&& wanted) {
    const Layer& marks = of(set, Kind::hatch);
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 n = vec(marks.normal, i);
        const glm::dvec3 w = wanted(position(set, Kind::hatch, i), n);
        if (glm::length(w) < least) continue;
        const double cosine = std::abs(glm::dot(vec(marks.direction, i), glm::normalize(w)));
        sum += std::acos(std::min(1.0, cosine)) * 180.0 / std::numbers::pi;
        count += 1.0;
    }
    return sum / count;
}

glm::dvec3 tangent_part(const glm::dvec3& v, const glm::dvec3& n) { return v - glm::dot(v, n) * n; }

TEST(Guides, SectionsAreCirclesAcrossTheAxis) {
    const glm::dvec3 z(0.0, 0.0, 1.0);
    const auto around = [&](const glm::dvec3&, const glm::dvec3& n) { return glm::cross(z, n); };
    generate::Settings settings = guided(Guide::sections);
    field(settings).axis = z;
    EXPECT_LT(mean_angle(make(Torus(), settings), 0.5, around), 3.0);
    EXPECT_LT(mean_angle(make(Sphere(), settings), 0.5, around), 3.0);
    EXPECT_LT(mean_angle(make(Cylinder(0.5), settings), 0.5, around), 2.0);
    field(settings).axis = {1.0, 0.0, 0.0};
    const auto across_x = [](const glm::dvec3&, const glm::dvec3& n) { return glm::cross({1.0, 0.0, 0.0}, n); };
    EXPECT_LT(mean_angle(make(Sphere(), settings), 0.5, across_x), 3.0);
}

TEST(Guides, LightIsFollowedAlongItsTangentPart) {
    const glm::dvec3 light = glm::normalize(glm::dvec3(1.0, 2.0, -1.0));
    const auto along = [&](const glm::dvec3&, const glm::dvec3& n) { return tangent_part(light, n); };
    generate::Settings settings = guided(Guide::light);
    field(settings).guide_direction = light;
    EXPECT_LT(mean_angle(make(Sphere(), settings), 0.5, along), 3.0);
    EXPECT_LT(mean_angle(make(Cylinder(0.5), settings), 0.5, along), 3.0);
}

// The lines are straight on a cylinder, and circles around the view on a ball.
TEST(Guides, SilhouetteIsConjugateToTheView) {
    const glm::dvec3 view = glm::normalize(glm::dvec3(1.0, 0.0, 0.3));
    generate::Settings settings = guided(Guide::silhouette);
    field(settings).guide_direction = view;
    const auto around = [&](const glm::dvec3&, const glm::dvec3& n) { return glm::cross(view, n); };
    EXPECT_LT(mean_angle(make(Sphere(), settings), 0.7, around), 3.0);
    const auto straight = [&](const glm::dvec3&, const glm::dvec3& n) {
        return glm::length(tangent_part(view, n)) * glm::dvec3(0.0, 0.0, 1.0);
    };
    EXPECT_LT(mean_angle(make(Cylinder(0.5), settings), 0.7, straight), 6.0);
}

TEST(Guides, CombingIsStarksFirstDirectionAwayFromItsBorders) {
    const auto combed = [](const glm::dvec3&, const glm::dvec3& n) {
        return geometry::combing_confidence(n) * geometry::combing_frame(n).r;
    };
    EXPECT_LT(mean_angle(make(Sphere(), guided(Guide::combing)), 0.9, combed), 5.0);
}

// With weight 0 lines follow curvature alone; larger weights move them towards the guide.
TEST(Guides, AreBlendedWithCurvature) {
    const Torus torus;
    const PointSet plain = make(torus, guided(Guide::curvature));
    generate::Settings settings = guided(Guide::light);
    field(settings).guide_direction = {1.0, 0.0, 0.0};
    field(settings).guide_weight = 0.0;
    EXPECT_TRUE(same_bits(plain, make(torus, settings)));
    const auto rings = [](const glm::dvec3& p, const glm::dvec3& n) {
        return glm::cross(n, glm::normalize(glm::dvec3(-p.y, p.x, 0.0)));
    };
    double before = mean_angle(plain, 0.0, rings);
    for (const double weight : {0.1, 1.0}) {
        field(settings).guide_weight = weight;
        const double angle = mean_angle(make(torus, settings), 0.0, rings);
        EXPECT_GT(angle, before + 1.0) << weight;
        before = angle;
    }
}

// On a face that is flat up to the tolerance of its fit the axis gives the lines, which are straight.
TEST(Guides, CurvatureIsIgnoredOnNearlyFlatFaces) {
    const auto sure = [](double curvature) {
        return std::abs(curvature_line(0.5 * curvature, 0.5 * curvature, 10.0)); // the diagonal is 10
    };
    EXPECT_EQ(sure(0.008), 0.0); // a radius of 12.5 diagonals
    EXPECT_GT(sure(0.05), 0.01);
    EXPECT_EQ(sure(3.0), 1.0);
}

} // namespace
} // namespace hrbfnpr::hatching::guides_test
