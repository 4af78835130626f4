// SPDX-License-Identifier: MIT
// Images that are projected onto a ball, against closed forms.
#include "paint/projection.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <random>

namespace hrbfnpr::paint::projection_test {
namespace {

constexpr int width = 80, height = 60;

// An image whose value is linear in the place of the middle of the pixel, so that interpolation gives it back.
double linear(double x, double y) { return 0.1 + 0.6 * x / width + 0.25 * y / height; }

Pixels linear_image(base::Memory& memory) {
    Pixels pixels(memory, FieldKind::scalar, width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            float* const to = pixels.at(column, row);
            to[0] = static_cast<float>(0.5 * linear(column + 0.5, row + 0.5)); // multiplied by alpha
            to[1] = 0.5F;
        }
    return pixels;
}

// A camera at z = 4 that looks at the origin. The viewport does not begin at 0, and has other sides than the image.
constexpr glm::dvec4 viewport{13.0, 7.0, 400.0, 300.0};

Projector perspective() {
    const double f = 2.0; // the cotangent of half the vertical angle
    glm::dmat4 view(1.0);
    view[3] = {0.0, 0.0, -4.0, 1.0};
    glm::dmat4 window(0.0); // to x w, y w, 0, w
    const double aspect = viewport.z / viewport.w;
    window[0][0] = 0.5 * viewport.z * f / aspect;
    window[1][1] = -0.5 * viewport.w * f;
    window[2] = {-(viewport.x + 0.5 * viewport.z), -(viewport.y + 0.5 * viewport.w), 0.0, -1.0};
    return {window * view, {0.0, 0.0, 4.0, 1.0}, viewport, nullptr, 0.0};
}

Projector orthographic() {
    glm::dmat4 window(0.0);
    window[0][0] = 100.0;
    window[1][1] = -100.0;
    window[3] = {viewport.x + 0.5 * viewport.z, viewport.y + 0.5 * viewport.w, 0.0, 1.0};
    return {window, {0.0, 0.0, -1.0, 0.0}, viewport, nullptr, 0.0};
}

std::vector<Place> places_of_ball(int count) {
    std::mt19937 random(5);
    std::normal_distribution<double> number;
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(number(random), number(random), number(random)));
        places.push_back({n, n});
    }
    return places;
}

// Two triangles that form the square from (-s, -s) to (s, s) at a height z.
geometry::Bvh square(const base::Work& work, double s, double z) {
    base::Array<glm::dvec3> corner(work.memory);
    for (const double x : {-s, s})
        for (const double y : {-s, s}) corner.push_back({x, y, z});
    base::Array<geometry::Bvh::Triangle> triangle(work.memory);
    triangle.push_back({0, 2, 1});
    triangle.push_back({1, 2, 3});
    return {work, corner, triangle};
}

TEST(PaintProjection, FallsOnTheSideOfABallThatFacesAnEye) {
    base::Runtime runtime;
    const Projection projection(linear_image(runtime.memory), perspective());
    int seen = 0;
    for (const Place& place : places_of_ball(4000)) {
        const Sample sample = projection.at(place);
        const glm::dvec3& p = place.position;
        ASSERT_NEAR(sample.weight, p.z > 0.25 ? 0.5 : 0.0, 1e-12)
            << p.z; // the tangents from the eye touch at z = 1 / 4
        if (sample.weight == 0.0) continue;
        const double scale = 2.0 * 0.5 * height / (4.0 - p.z); // pixels of the image for each unit at p
        const double x = 0.5 * width + scale * p.x, y = 0.5 * height - scale * p.y;
        ASSERT_NEAR(sample.value.x, linear(x, y), 1e-6);
        ++seen;
    }
    EXPECT_GT(seen, 1000);
}

TEST(PaintProjection, FallsOnHalfABallAlongParallelLines) {
    base::Runtime runtime;
    const Projection projection(linear_image(runtime.memory), orthographic());
    for (const Place& place : places_of_ball(2000)) {
        const Sample sample = projection.at(place);
        ASSERT_NEAR(sample.weight, place.position.z > 0.0 ? 0.5 : 0.0, 1e-12);
        if (sample.weight > 0.0) {
            ASSERT_NEAR(sample.value.x,
                        linear(0.5 * width + 20.0 * place.position.x, 0.5 * height - 20.0 * place.position.y), 1e-6);
        }
    }
}

TEST(PaintProjection, EndsAtTheBordersOfTheViewport) {
    base::Runtime runtime;
    const Projection projection(linear_image(runtime.memory), orthographic());
    const auto weight = [&](double x, double y) { return projection.at({{x, y, 0.0}, {0.0, 0.0, 1.0}}).weight; };
    EXPECT_DOUBLE_EQ(weight(1.999, 1.499), 0.5);
    EXPECT_EQ(weight(2.001, 0.0), 0.0);
    EXPECT_EQ(weight(0.0, -1.501), 0.0);
    EXPECT_EQ(weight(-2.001, 0.0), 0.0);
}

TEST(PaintProjection, DoesNotReachWhatIsHidden) {
    base::Runtime runtime;
    const geometry::Bvh cover = square(runtime, 0.3, 2.0);
    for (const bool is_perspective : {false, true}) {
        Projector projector = is_perspective ? perspective() : orthographic();
        projector.occluders = &cover;
        const Projection projection(linear_image(runtime.memory), projector);
        int hidden = 0;
        for (const Place& place : places_of_ball(4000)) {
            const glm::dvec3& p = place.position;
            if (p.z < 0.3) continue;
            // Where the line of sight meets the height of the cover.
            const double share = is_perspective ? (4.0 - 2.0) / (4.0 - p.z) : 1.0;
            const double away = std::max(std::abs(p.x), std::abs(p.y)) * share;
            if (std::abs(away - 0.3) < 1e-9) continue;
            ASSERT_NEAR(projection.at(place).weight, away < 0.3 ? 0.0 : 0.5, 1e-12) << p.x << " " << p.y;
            hidden += away < 0.3 ? 1 : 0;
        }
        EXPECT_GT(hidden, 30);
    }
}

TEST(PaintProjection, TransparentPixelsDoNotCount) {
    base::Runtime runtime;
    Pixels pixels(runtime.memory, FieldKind::colour, 2, 1);
    const float red[4] = {0.25F, 0.0F, 0.0F, 0.25F}, none[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    std::copy(red, red + 4, pixels.at(0, 0));
    std::copy(none, none + 4, pixels.at(1, 0));
    const Projection projection(std::move(pixels), orthographic());
    const Sample middle = projection.at({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
    EXPECT_NEAR(middle.weight, 0.125, 1e-12);
    EXPECT_NEAR(middle.value.x, 1.0, 1e-12);
    EXPECT_NEAR(middle.value.y, 0.0, 1e-12);
}

} // namespace
} // namespace hrbfnpr::paint::projection_test
