// SPDX-License-Identifier: MIT
// Occlusion and shadows against rays that are tested with closed forms.
#include "light/light.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace hrbfnpr::light::light_test {
namespace {

using geometry::Bvh;
using geometry::VecArray;

// A ball of radius 1 above a square floor that it touches.
struct BallOnFloor {
    explicit BallOnFloor(base::Memory& memory) : vertex(memory), triangle(memory) {
        constexpr int rows = 160;
        const auto number = [](int row, int column) { return row * (2 * rows) + column % (2 * rows); };
        for (int row = 0; row <= rows; ++row)
            for (int column = 0; column < 2 * rows; ++column) {
                const double theta = glm::pi<double>() * row / rows;
                const double phi = glm::pi<double>() * column / rows;
                vertex.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
            }
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < 2 * rows; ++column) {
                const int a = number(row, column);
                const int b = number(row, column + 1);
                const int c = number(row + 1, column);
                const int d = number(row + 1, column + 1);
                if (row > 0) triangle.push_back({a, c, b});
                if (row + 1 < rows) triangle.push_back({b, c, d});
            }
        const auto first = static_cast<std::int32_t>(vertex.size());
        for (const double x : {-half, half})
            for (const double y : {-half, half}) vertex.push_back({x, y, -1.0});
        triangle.push_back({first, first + 2, first + 1});
        triangle.push_back({first + 1, first + 2, first + 3});
    }
    static constexpr double half = 4.0;

    // Returns the t of the first hit of a ray with the ball or the floor, or infinity.
    static double plain_hit(const glm::dvec3& origin, const glm::dvec3& direction) {
        double first = std::numeric_limits<double>::infinity();
        const double b = glm::dot(origin, direction);
        const double root = b * b - glm::dot(origin, origin) + 1.0;
        for (const double way : {-b - std::sqrt(root), -b + std::sqrt(root)})
            if (way > 0.0) first = std::min(first, way); // NaN if the ray misses the ball
        const double t = (-1.0 - origin.z) / direction.z;
        const glm::dvec3 at = origin + t * direction;
        if (t > 0.0 && std::abs(at.x) < half && std::abs(at.y) < half) first = std::min(first, t);
        return first;
    }

    base::Array<glm::dvec3> vertex;
    base::Array<Bvh::Triangle> triangle;
};

class LightTest : public testing::Test {
protected:
    LightTest() : scene(runtime.memory), casters(base::Work(runtime), scene.vertex, scene.triangle) {
        // Half of the places lie on the ball, half on the floor.
        while (position.size() < 80000) {
            const double z = 1.0 - 2.0 * uniform(random);
            const double phi = 2.0 * glm::pi<double>() * uniform(random);
            const double r = std::sqrt(1.0 - z * z);
            const glm::dvec3 on_ball(r * std::cos(phi), r * std::sin(phi), z);
            const glm::dvec3 on_floor(4.0 * (2.0 * uniform(random) - 1.0), 4.0 * (2.0 * uniform(random) - 1.0), -1.0);
            // Where they touch, rays begin on the wrong side of the other one.
            if (std::hypot(on_floor.x, on_floor.y) < 0.12 || on_ball.z < -0.99) continue;
            add(on_ball, on_ball);
            add(on_floor, {0.0, 0.0, 1.0});
        }
    }
    void add(const glm::dvec3& place, const glm::dvec3& direction) {
        position.push_back(place);
        normal.push_back(direction);
    }
    [[nodiscard]] Places places() const { return {position, normal, 1e-3}; }
    // The openness of a place by 4000 random rays.
    double plain_openness(std::int64_t i, double reach) {
        const glm::dvec3 n = normal[i];
        double hidden = 0.0;
        constexpr int rays = 4000;
        for (int k = 0; k < rays; ++k) {
            // A unit vector around the tip of the normal is a cosine-weighted direction.
            const double z = 1.0 - 2.0 * uniform(random);
            const double phi = 2.0 * glm::pi<double>() * uniform(random);
            const double r = std::sqrt(1.0 - z * z);
            const glm::dvec3 direction = glm::normalize(n + glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
            const double t = BallOnFloor::plain_hit(position[i] + 1e-6 * n, direction);
            if (t < reach) hidden += 1.0 - t / reach;
        }
        return 1.0 - hidden / rays;
    }

    base::Runtime runtime;
    BallOnFloor scene;
    Bvh casters;
    std::mt19937 random{7};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    VecArray position{runtime.memory};
    VecArray normal{runtime.memory};
};

TEST_F(LightTest, OpennessIsThatOfManyRays) {
    Sky sky{2.0};
    sky.samples = 6000;
    const base::Array<float> open = find_openness(base::Work(runtime), casters, places(), sky);
    double error = 0.0;
    double most = 0.0;
    double darkest = 1.0;
    constexpr int tried = 1000;
    for (int k = 0; k < tried; ++k) {
        const std::int64_t i = 79 * k;
        const double off = std::abs(static_cast<double>(open[i]) - plain_openness(i, sky.reach));
        error += off / tried;
        most = std::max(most, off);
        darkest = std::min(darkest, static_cast<double>(open[i]));
    }
    EXPECT_LT(error, 0.012);
    EXPECT_LT(most, 0.15);
    EXPECT_LT(darkest, 0.2) << "where the ball touches the floor";
}

TEST_F(LightTest, OpennessIsOneWhereNothingIsNear) {
    Sky sky{1e-3};
    const base::Array<float> open = find_openness(base::Work(runtime), casters, {position, normal, 5e-3}, sky);
    EXPECT_EQ(*std::min_element(open.begin(), open.end()), 1.0F);
}

TEST_F(LightTest, ShadowsEndWhereTheyShould) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(1.0, 0.3, 1.2));
    const base::Array<float> visible = find_visible(base::Work(runtime), casters, places(), {towards});
    std::int64_t different = 0;
    for (std::int64_t i = 0; i < position.size(); ++i) {
        const bool faces = glm::dot(normal[i], towards) > 0.0;
        const bool hit = std::isfinite(BallOnFloor::plain_hit(position[i] + 1e-3 * normal[i], towards));
        if ((visible[i] > 0.5F) == (faces && !hit)) continue;
        ++different;
        // The chords of the mesh are up to 2e-4 inside the ball.
        const double past = glm::length(glm::cross(position[i], towards));
        EXPECT_NEAR(past, 1.0, 2e-3) << i;
    }
    EXPECT_LT(different, 40);
}

TEST_F(LightTest, BordersStayWhereRaysBeginHighAboveTheSurface) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(1.0, 0.3, 1.2));
    const base::Array<float> visible = find_visible(base::Work(runtime), casters, {position, normal, 0.05}, {towards});
    for (std::int64_t i = 1; i < position.size(); i += 2) { // on the floor
        const bool hit = std::isfinite(BallOnFloor::plain_hit(position[i] + 1e-9 * normal[i], towards));
        if ((visible[i] > 0.5F) == !hit) continue;
        const double past = glm::length(glm::cross(position[i], towards));
        EXPECT_NEAR(past, 1.0, 1e-3) << i;
    }
}

TEST_F(LightTest, PenumbrasHaveTheSharesOfTheDisc) {
    Lamp lamp{glm::normalize(glm::dvec3(0.8, 0.0, 1.0)), false, 0.15};
    lamp.rays = 64;
    const base::Array<float> visible = find_visible(base::Work(runtime), casters, places(), lamp);
    double error = 0.0;
    int half_shaded = 0;
    for (std::int64_t i = 1; i < position.size(); i += 2) { // on the floor
        if (visible[i] > 0.1F && visible[i] < 0.9F) ++half_shaded;
        if (i % 101 != 0) continue;
        int seen = 0;
        constexpr int rays = 1000;
        const glm::dvec3 u = glm::normalize(glm::cross(lamp.place, glm::dvec3(0.0, 1.0, 0.3)));
        const glm::dvec3 v = glm::cross(lamp.place, u);
        for (int k = 0; k < rays; ++k) {
            const double r = std::tan(lamp.softness) * std::sqrt(uniform(random));
            const double phi = 2.0 * glm::pi<double>() * uniform(random);
            const glm::dvec3 way = glm::normalize(lamp.place + r * std::cos(phi) * u + r * std::sin(phi) * v);
            seen += std::isfinite(BallOnFloor::plain_hit(position[i] + 1e-3 * normal[i], way)) ? 0 : 1;
        }
        error = std::max(error, std::abs(static_cast<double>(visible[i]) - static_cast<double>(seen) / rays));
    }
    EXPECT_GT(half_shaded, 500);
    EXPECT_LT(error, 0.08);
}

TEST_F(LightTest, ALampBeforeAWallIsSeen) {
    const Lamp before{{0.0, 0.0, 3.0}, true};
    const Lamp inside{{0.0, 0.0, 0.0}, true};
    const base::Array<float> lit = find_visible(base::Work(runtime), casters, places(), before);
    const base::Array<float> dark = find_visible(base::Work(runtime), casters, places(), inside);
    for (std::int64_t i = 1; i < position.size(); i += 2) {
        EXPECT_EQ(dark[i], 0.0F) << "the ball is before it";
        // The shadow of the ball on the floor is a disc.
        const double radius = std::hypot(position[i].x, position[i].y);
        const double edge = 4.0 * std::tan(std::asin(1.0 / 3.0));
        if (std::abs(radius - edge) < 0.01) continue;
        EXPECT_EQ(lit[i] > 0.5F, radius > edge) << radius;
    }
}

} // namespace
} // namespace hrbfnpr::light::light_test
