// SPDX-License-Identifier: MIT
// Values of points and triangles against a search through all of them.
#include "paint/field.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace hrbfnpr::paint::points_test {
namespace {

using Triangle = TriangleValues::Triangle;

struct Soup {
    std::vector<glm::dvec3> points;
    std::vector<Triangle> triangles;
};

Soup random_soup(int points, int triangles) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::uniform_int_distribution<std::int32_t> corner(0, points - 1);
    Soup soup;
    for (int i = 0; i < points; ++i) soup.points.emplace_back(number(random), number(random), number(random));
    for (int i = 0; i < triangles; ++i) soup.triangles.push_back({corner(random), corner(random), corner(random)});
    return soup;
}

std::vector<glm::dvec3> random_places(int count) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    std::vector<glm::dvec3> places;
    for (int i = 0; i < count; ++i) places.emplace_back(number(random), number(random), number(random));
    return places;
}

template <class T>
base::Array<T> array_of(base::Memory& memory, const std::vector<T>& from) {
    base::Array<T> array(memory);
    for (const T& one : from) array.push_back(one);
    return array;
}

std::vector<Sample> samples_of(const base::Work& work, const Field& field, const std::vector<glm::dvec3>& places) {
    std::vector<Sample> samples(places.size());
    field.evaluate(
        work, static_cast<std::int64_t>(places.size()),
        [&](std::int64_t i) {
            return Place{places[static_cast<std::size_t>(i)], glm::dvec3(0.0, 0.0, 1.0)};
        },
        [&](std::int64_t i, const Sample& sample) { samples[static_cast<std::size_t>(i)] = sample; });
    return samples;
}

// A place of a triangle, as the corner a plus u (b - a) + v (c - a).
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    std::array<double, 3> weight{};
};

// Finds the nearest place of a triangle by steps: the inside by the two normal equations, then each side.
Nearest nearest_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
    Nearest best;
    const auto offer = [&](double u, double v) {
        const glm::dvec3 away = a + u * (b - a) + v * (c - a) - p;
        if (const double squared = glm::dot(away, away); squared < best.squared) best = {squared, {1.0 - u - v, u, v}};
    };
    const glm::dvec3 x = b - a, y = c - a, q = p - a;
    const double xx = glm::dot(x, x), xy = glm::dot(x, y), yy = glm::dot(y, y);
    const double det = xx * yy - xy * xy;
    if (det > 0.0) {
        const double u = (yy * glm::dot(x, q) - xy * glm::dot(y, q)) / det;
        const double v = (xx * glm::dot(y, q) - xy * glm::dot(x, q)) / det;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) offer(u, v);
    }
    const auto along = [](const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& at) {
        const glm::dvec3 way = to - from;
        const double squared = glm::dot(way, way);
        return squared > 0.0 ? std::clamp(glm::dot(at - from, way) / squared, 0.0, 1.0) : 0.0;
    };
    offer(along(a, b, p), 0.0);
    offer(0.0, along(a, c, p));
    const double t = along(b, c, p);
    offer(1.0 - t, t);
    return best;
}

class PaintPoints : public ::testing::Test {
protected:
    base::Runtime runtime;
    base::Work work{runtime};
    base::Memory& memory = runtime.memory;
};

TEST_F(PaintPoints, TrianglesEqualASearchThroughAll) {
    const Soup soup = random_soup(60, 90);
    std::vector<double> values;
    for (const glm::dvec3& p : soup.points) values.insert(values.end(), {0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y, p.z * p.z});
    const Field field(FieldKind::colour, {0.0, 0.0},
                      TriangleValues(work, array_of(memory, soup.points), array_of(memory, soup.triangles),
                                     FieldKind::colour, array_of(memory, values), 0.0));
    const std::vector<glm::dvec3> places = random_places(3000);
    const std::vector<Sample> samples = samples_of(work, field, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        Nearest best;
        Triangle of{};
        for (const Triangle& t : soup.triangles) {
            const auto corner = [&](int k) {
                return soup.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
            };
            const Nearest own = nearest_of(corner(0), corner(1), corner(2), places[i]);
            if (own.squared < best.squared) {
                best = own;
                of = t;
            }
        }
        glm::dvec3 expected(0.0);
        for (std::size_t k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) expected[c] += best.weight[k] * values[static_cast<std::size_t>(3 * of[k] + c)];
        EXPECT_EQ(samples[i].weight, 1.0);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(samples[i].value[c], expected[c], 1e-9) << "place " << i;
    }
}

TEST_F(PaintPoints, PointsGiveTheValueOfTheNearest) {
    const Soup soup = random_soup(500, 0);
    geometry::VecArray points(memory);
    std::vector<double> values;
    for (const glm::dvec3& p : soup.points) {
        points.push_back(p);
        values.push_back(static_cast<double>(values.size()));
    }
    constexpr double reach = 0.15;
    const Field field(FieldKind::scalar, {0.0, 0.0},
                      PointValues(work, points, FieldKind::scalar, array_of(memory, values), reach));
    const std::vector<glm::dvec3> places = random_places(2000);
    const std::vector<Sample> samples = samples_of(work, field, places);
    int none = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto nearest =
            std::min_element(soup.points.begin(), soup.points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
                return glm::distance(a, places[i]) < glm::distance(b, places[i]);
            });
        const bool is_near = glm::distance(*nearest, places[i]) <= reach;
        ASSERT_EQ(samples[i].weight, is_near ? 1.0 : 0.0) << "place " << i;
        ASSERT_EQ(samples[i].value.x, is_near ? static_cast<double>(nearest - soup.points.begin()) : 0.0);
        none += is_near ? 0 : 1;
    }
    EXPECT_GT(none, 500);
    EXPECT_LT(none, 1900);
}

TEST_F(PaintPoints, TrianglesHaveNoValueBeyondTheirReach) {
    const std::vector<glm::dvec3> corners = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const Field field(FieldKind::scalar, {0.0, 0.0},
                      TriangleValues(work, array_of(memory, corners), array_of<Triangle>(memory, {{0, 1, 2}}),
                                     FieldKind::scalar, array_of<double>(memory, {1.0, 2.0, 3.0}), 0.5));
    const std::vector<Sample> samples = samples_of(work, field, {{0.25, 0.25, 0.499}, {0.25, 0.25, -0.501}});
    EXPECT_EQ(samples[0].weight, 1.0);
    EXPECT_NEAR(samples[0].value.x, 1.75, 1e-12);
    EXPECT_EQ(samples[1].weight, 0.0);
    EXPECT_EQ(samples[1].value.x, 0.0);
}

// A triangle whose corners lie on a line is that line, and one whose corners coincide is a point.
TEST_F(PaintPoints, TrianglesWithoutAreaAreLinesAndPoints) {
    const std::vector<glm::dvec3> corners = {{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {9.0, 9.0, 9.0}};
    const Field field(FieldKind::scalar, {0.0, 0.0},
                      TriangleValues(work, array_of(memory, corners),
                                     array_of<Triangle>(memory, {{0, 1, 2}, {3, 3, 3}}), FieldKind::scalar,
                                     array_of<double>(memory, {0.0, 8.0, 5.0, 3.0}), 0.0));
    const std::vector<Sample> samples = samples_of(work, field, {{3.0, 1.0, 0.0}, {9.0, 9.0, 8.0}});
    EXPECT_NEAR(samples[0].value.x, 6.0, 1e-12);
    EXPECT_NEAR(samples[1].value.x, 3.0, 1e-12);
}

TEST_F(PaintPoints, DirectionsHaveNoSign) {
    const std::vector<glm::dvec3> corners = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const Field field(FieldKind::direction, {0.0, 0.0},
                      TriangleValues(work, array_of(memory, corners), array_of<Triangle>(memory, {{0, 1, 2}}),
                                     FieldKind::direction,
                                     array_of<double>(memory, {1.0, 0.0, 0.0, -1.0, 0.1, 0.0, 1.0, 0.1, 0.0}), 0.0));
    for (const Sample& sample : samples_of(work, field, {{0.3, 0.3, 0.0}, {0.5, 0.5, 0.0}, {0.8, 0.1, 0.0}})) {
        EXPECT_EQ(sample.weight, 1.0);
        EXPECT_GT(std::abs(sample.value.x), 0.99);
    }
}

TEST_F(PaintPoints, RangesMapAndClamp) {
    const auto mapped = [&](double low, double high, double value) {
        geometry::VecArray point(memory);
        point.push_back({0.0, 0.0, 0.0});
        const Field field(FieldKind::scalar, {low, high},
                          PointValues(work, point, FieldKind::scalar, array_of<double>(memory, {value}), 0.0));
        return samples_of(work, field, {{1.0, 2.0, 3.0}})[0].value.x;
    };
    EXPECT_EQ(mapped(0.0, 0.0, -7.0), -7.0);
    EXPECT_EQ(mapped(10.0, 20.0, 12.5), 0.25);
    EXPECT_EQ(mapped(20.0, 10.0, 12.5), 0.75);
    EXPECT_EQ(mapped(10.0, 20.0, 9.0), 0.0);
    EXPECT_EQ(mapped(10.0, 20.0, 21.0), 1.0);
}

TEST_F(PaintPoints, NumbersThatOverflowSayNothing) {
    const auto weight_at = [&](double size, const std::array<double, 2>& range, double value) {
        const std::vector<glm::dvec3> corners = {{0.0, 0.0, 0.0}, {size, 0.0, 0.0}, {0.0, size, 0.0}};
        const Field field(FieldKind::scalar, range,
                          TriangleValues(work, array_of(memory, corners), array_of<Triangle>(memory, {{0, 1, 2}}),
                                         FieldKind::scalar, array_of<double>(memory, {value, value, value}), 0.0));
        const Sample sample = samples_of(work, field, {{0.0, 0.0, 0.0}})[0];
        EXPECT_TRUE(std::isfinite(sample.value.x));
        return sample.weight;
    };
    EXPECT_EQ(weight_at(1e200, {0.0, 0.0}, 1.0), 0.0);
    EXPECT_EQ(weight_at(1.0, {-1.7e308, 1.7e308}, 1e308), 0.0);
    EXPECT_EQ(weight_at(1e70, {-1e300, 1e300}, 1.7e308), 1.0);
}

} // namespace
} // namespace hrbfnpr::paint::points_test
