// SPDX-License-Identifier: MIT
// The mean curvature on meshes of surfaces whose curvature is known.
#include "light/light.h"

#include "base/runtime.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <functional>
#include <vector>

namespace hrbfnpr::light::bend_test {
namespace {

using geometry::VecArray;

struct Point {
    glm::dvec3 place, normal;
};
using Chart = std::function<Point(double u, double v)>;

// A mesh of a chart of the unit square, and places on it.
struct ChartMesh {
    ChartMesh(const Chart& made, int rows_, double side) : chart(made), rows(rows_), mesh{position, corner, side} {
        for (int i = 0; i <= rows; ++i)
            for (int j = 0; j <= rows; ++j) position.push_back(chart(at(i), at(j)).place);
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < rows; ++j) {
                const int a = i * (rows + 1) + j, b = a + 1, c = a + rows + 1, d = c + 1;
                for (const int index : {a, c, b, b, c, d}) corner.push_back(index);
            }
    }
    [[nodiscard]] double at(int i) const { return static_cast<double>(i) / rows; }
    // Expects that scale H is found within `off` at places inside the unit square.
    void expect(const std::function<double(double u, double v)>& curvature, double scale, double off) {
        VecArray place(runtime.memory), normal(runtime.memory);
        std::vector<double> wanted;
        for (double u = 0.211; u < 0.8; u += 0.031)
            for (double v = 0.207; v < 0.8; v += 0.037) {
                const Point point = chart(u, v);
                place.push_back(point.place);
                normal.push_back(point.normal);
                wanted.push_back(scale * curvature(u, v));
            }
        const base::Array<float> bend =
            SurfaceBend(base::Work(runtime), mesh, scale).curvature(base::Work(runtime), {place, normal, 0.0});
        for (std::size_t i = 0; i < wanted.size(); ++i)
            EXPECT_NEAR(bend[static_cast<std::int64_t>(i)], wanted[i], off) << i;
    }

    base::Runtime runtime;
    Chart chart;
    int rows;
    VecArray position{runtime.memory};
    base::Array<std::int32_t> corner{runtime.memory};
    SurfaceTriangles mesh;
};

// A ball, or the inside of a bowl if the radius is negative.
Chart ball(double radius) {
    return [radius](double u, double v) {
        const double theta = 0.2 + 2.0 * u, phi = 2.0 * v;
        const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        return Point{std::abs(radius) * n, radius > 0.0 ? n : -n};
    };
}

TEST(Bend, OfABallIsTheSameEverywhere) {
    for (const double scale : {0.05, 0.1, 0.2})
        ChartMesh(ball(1.0), 200, 0.01).expect([](double, double) { return 1.0; }, scale, 0.02 * scale);
}

TEST(Bend, OfAHollowIsNegative) {
    ChartMesh bowl(ball(-0.5), 200, 0.01);
    for (std::int64_t i = 0; i < bowl.corner.size(); i += 3) std::swap(bowl.corner[i], bowl.corner[i + 1]);
    bowl.expect([](double, double) { return -2.0; }, 0.1, 0.005);
}

TEST(Bend, OfATorusIsThatOfTheFormula) {
    constexpr double large = 1.0, small = 0.4;
    const auto angle = [](double v) { return glm::two_pi<double>() * v; };
    ChartMesh torus(
        [&](double u, double v) {
            const double phi = 2.0 * u, theta = angle(v);
            const glm::dvec3 out(std::cos(phi), std::sin(phi), 0.0);
            const glm::dvec3 n = std::cos(theta) * out + std::sin(theta) * glm::dvec3(0.0, 0.0, 1.0);
            return Point{large * out + small * n, n};
        },
        300, 0.01);
    torus.expect(
        [&](double, double v) {
            const double cosine = std::cos(angle(v));
            return (large + 2.0 * small * cosine) / (2.0 * small * (large + small * cosine));
        },
        0.05, 0.003);
}

TEST(Bend, OfAReliefIsThatOfTheFormula) {
    constexpr double height = 0.05, wave = 8.0;
    ChartMesh relief(
        [](double u, double v) {
            const double slope = height * wave * std::cos(wave * u);
            return Point{{u, v, height * std::sin(wave * u)}, glm::normalize(glm::dvec3(-slope, 0.0, 1.0))};
        },
        250, 0.006);
    relief.expect(
        [](double u, double) {
            const double slope = height * wave * std::cos(wave * u);
            return 0.5 * height * wave * wave * std::sin(wave * u) / std::pow(1.0 + slope * slope, 1.5);
        },
        0.02, 0.002);
}

// Contrast is the hyperbolic tangent of three times the curvature, less its mean, whose weight is the area.
TEST(Bend, ContrastHasTheMeanZero) {
    constexpr double height = 0.05, wave = 8.0, scale = 0.02;
    ChartMesh relief(
        [](double u, double v) {
            const double slope = height * wave * std::cos(wave * u);
            return Point{{u, v, height * std::sin(wave * u) - 0.2 * u * u},
                         glm::normalize(glm::dvec3(0.4 * u - slope, 0.0, 1.0))};
        },
        250, 0.006);
    const base::Work work(relief.runtime);
    VecArray place(work.memory), normal(work.memory);
    std::vector<double> area;
    for (double u = 0.001; u < 1.0; u += 0.004)
        for (double v = 0.05; v < 1.0; v += 0.1) {
            const Point point = relief.chart(u, v);
            place.push_back(point.place);
            normal.push_back(point.normal);
            area.push_back(1.0 / point.normal.z);
        }
    const SurfaceBend bend(work, relief.mesh, scale);
    const base::Array<float> curvature = bend.curvature(work, {place, normal, 0.0});
    const base::Array<float> contrast = bend.contrast(work, {place, normal, 0.0});
    double sum = 0.0, whole = 0.0;
    const double off = std::tanh(3.0 * double{curvature[0]}) - double{contrast[0]};
    EXPECT_GT(off, 0.01);
    for (std::int64_t i = 0; i < contrast.size(); ++i) {
        EXPECT_NEAR(std::tanh(3.0 * double{curvature[i]}) - double{contrast[i]}, off, 1e-5);
        sum += area[static_cast<std::size_t>(i)] * double{contrast[i]};
        whole += area[static_cast<std::size_t>(i)];
    }
    EXPECT_NEAR(sum / whole, 0.0, 0.004);
}

TEST(Bend, OfAThinPlateIsZeroOnBothSides) {
    ChartMesh plate([](double u, double v) { return Point{{u, v, 0.0}, {0.0, 0.0, 1.0}}; }, 100, 0.01);
    const auto first = static_cast<std::int32_t>(plate.position.size());
    const std::int64_t corners = plate.corner.size();
    for (std::int32_t i = 0; i < first; ++i) plate.position.push_back(plate.position[i] - glm::dvec3(0.0, 0.0, 0.01));
    for (std::int64_t i = 0; i < corners; i += 3)
        for (const std::int64_t k : {1, 0, 2}) plate.corner.push_back(first + plate.corner[i + k]);
    plate.expect([](double, double) { return 0.0; }, 0.05, 1e-9);
}

TEST(Bend, KeepsItsBits) {
    const base::Runtime two = test::with_threads(2);
    ChartMesh torus(ball(1.0), 150, 0.01);
    VecArray place(torus.runtime.memory);
    for (std::int64_t i = 0; i < torus.position.size(); ++i) place.push_back(torus.position[i]);
    const Places places{place, place, 0.0};
    const base::Array<float> both = SurfaceBend(base::Work(two), torus.mesh, 0.05).contrast(base::Work(two), places);
    const base::Runtime one = test::with_threads(1);
    const base::Array<float> alone = SurfaceBend(base::Work(one), torus.mesh, 0.05).contrast(base::Work(one), places);
    for (std::int64_t i = 0; i < place.size(); ++i) EXPECT_EQ(both[i], alone[i]);
}

} // namespace
} // namespace hrbfnpr::light::bend_test
