// SPDX-License-Identifier: MIT
// Contours of constant width, and the published band, against the contours of a sphere and a torus.
#include "frame/line_of_sight.h"
#include "generate/generate.h"
#include "support/analytic.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hrbfnpr::testing::contours_test {
namespace {

using drawing::MarkClass;
using frame::SilhouetteLaw;

constexpr int size = 600;
constexpr double minor = 0.4;

// Evenly spread stipples in a blue-noise order.
marks::PointSet spread(const base::Runtime& runtime, const implicit::Implicit& surface, std::int64_t marks) {
    generate::Settings settings;
    settings.layers.emplace_back().budget = marks;
    return clustered(runtime, generate::generate(runtime, surface, {}, settings, {}));
}

Style contours(float width) {
    Style style;
    style.hidden_lines = frame::HiddenLines::show;
    style.kind[0].shown = false;
    style.contour_kinds = 1;
    style.silhouette_width = width;
    return style;
}

// Points of a torus's contours: two around the tube for each place along it.
std::vector<glm::dvec3> torus_contour(const glm::dvec3& eye, bool from_point) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 6000; ++i) {
        const double along = 2.0 * pi * i / 6000.0;
        const glm::dvec3 out(std::cos(along), std::sin(along), 0.0);
        const glm::dvec3 v = from_point ? eye - out : eye;
        for (int side = 0; side < 2; ++side) {
            // n . v = minor for a point, 0 for a direction, with n = cos a out + sin a z.
            const double a = glm::dot(v, out);
            const double length = std::hypot(a, v.z);
            const double turn = std::acos(std::clamp((from_point ? minor : 0.0) / length, -1.0, 1.0));
            points.push_back(torus_point(minor, along, std::atan2(v.z, a) + (side == 0 ? turn : -turn)).position);
        }
    }
    return points;
}

std::vector<glm::dvec3> sphere_contour(const glm::dvec3& eye, bool from_point) {
    std::vector<glm::dvec3> points;
    const glm::dvec3 n = glm::normalize(eye);
    const glm::dvec3 t = geometry::any_perpendicular(n);
    const glm::dvec3 s = glm::cross(n, t);
    const double near_part = from_point ? 1.0 / glm::length(eye) : 0.0;
    for (int i = 0; i < 6000; ++i) {
        const double angle = 2.0 * pi * i / 6000.0;
        points.push_back(near_part * n +
                         std::sqrt(1.0 - near_part * near_part) * (std::cos(angle) * t + std::sin(angle) * s));
    }
    return points;
}

glm::dvec2 image_of(const frame::Camera& camera, const glm::dvec3& p) {
    const glm::dvec4 clip = camera.projection * camera.view * glm::dvec4(p, 1.0);
    return {camera.viewport.x + camera.viewport.z * (0.5 + 0.5 * clip.x / clip.w),
            camera.viewport.y + camera.viewport.w * (0.5 - 0.5 * clip.y / clip.w)};
}

// Pixels between two sets of places in the picture.
double nearest_of(const std::vector<glm::dvec2>& places, const glm::dvec2& at) {
    double least = 1e9;
    for (const glm::dvec2& p : places) least = std::min(least, glm::dot(p - at, p - at));
    return std::sqrt(least);
}

struct Line {
    double marks = 0.0;
    double strayed = 0.0;  // marks farther from the contour than 1.1 widths
    double farthest = 0.0; // of all marks, widths
    double astray = 0.0;   // of those, away from cusps
    double bare = 0.0;     // share of the contour farther than a pixel, or a width, from every mark
    double widest_gap = 0.0;
};

// Curvature of the surface along the line of sight.
using Bend = std::function<double(const Mark&)>;

double sphere_bend(const Mark&) { return 1.0; }

Bend torus_bend(const glm::dvec3& eye, bool from_point) {
    return [=](const Mark& mark) {
        const glm::dvec3 v = from_point ? eye - mark.position : eye;
        const glm::dvec3 w = glm::normalize(v - glm::dot(v, mark.normal) * mark.normal);
        const glm::dvec3 out = glm::normalize(glm::dvec3(mark.position.x, mark.position.y, 0.0));
        const double outward = glm::dot(mark.normal, out);
        const double along = glm::dot(w, glm::dvec3(-out.y, out.x, 0.0));
        return along * along * outward / (1.0 + minor * outward) + (1.0 - along * along) / minor;
    };
}

class Contours : public ::testing::Test {
protected:
    Line line(const marks::PointSet& set, float width, const frame::Camera& camera,
              const std::vector<glm::dvec3>& contour, const Bend& bend) {
        Style style = contours(width);
        style.hidden_lines = hidden_lines;
        style.halo_width = halo;
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera);
        std::vector<glm::dvec2> truth;
        for (const glm::dvec3& p : contour) truth.push_back(image_of(camera, p));
        std::vector<glm::dvec2> drawn;
        Line result;
        for (const Disc& disc : frame.discs()) {
            EXPECT_EQ(disc.mark_class, MarkClass::silhouette);
            drawn.emplace_back(disc.x, disc.y);
            const double off = nearest_of(truth, drawn.back()) / static_cast<double>(width);
            result.farthest = std::max(result.farthest, off);
            result.strayed += off > 1.1;
            result.astray += off > 1.1 && std::abs(bend(mark_of(set, disc.id - 1))) > 1.25;
        }
        result.marks = static_cast<double>(drawn.size());
        double inside = 0.0;
        for (std::size_t i = 0; i < truth.size(); i += 3) {
            if (truth[i].x < 3.0 || truth[i].x > size - 3.0 || truth[i].y < 3.0 || truth[i].y > size - 3.0) continue;
            const double gap = nearest_of(drawn, truth[i]);
            inside += 1.0;
            result.bare += gap > std::max(1.0, static_cast<double>(width));
            result.widest_gap = std::max(result.widest_gap, gap);
        }
        result.bare /= std::max(1.0, inside);
        return result;
    }

    // A sphere hides none of its own contour.
    void expect_whole_sphere() {
        const marks::PointSet set = spread(runtime, test::Sphere(), 150000);
        const glm::dvec3 eye(1.0, -2.0, 3.0);
        for (const auto hidden : {frame::HiddenLines::hide, frame::HiddenLines::attenuate}) {
            hidden_lines = hidden;
            for (const double half : {3.0, 1.25}) {
                const Line found =
                    line(set, 1.0F, camera_from(eye, size, half), sphere_contour(eye, false), sphere_bend);
                EXPECT_LE(found.farthest, 1.1) << half;
                EXPECT_LE(found.bare, 0.01) << half;
                EXPECT_LE(found.widest_gap, 3.0) << half;
            }
        }
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
    frame::HiddenLines hidden_lines = frame::HiddenLines::show;
    float halo = 0.0F;
};

TEST_F(Contours, OfASphereAreThinAndWhole) {
    const marks::PointSet set = spread(runtime, test::Sphere(), 150000);
    const glm::dvec3 eye(1.0, -2.0, 3.0);
    for (const float width : {0.7F, 1.0F, 2.0F}) {
        for (const double half : {3.0, 1.25, 0.8}) {
            const Line ortho = line(set, width, camera_from(eye, size, half), sphere_contour(eye, false), sphere_bend);
            EXPECT_LE(ortho.farthest, 1.11) << width << " " << half;
            EXPECT_LE(ortho.bare, 0.002) << width << " " << half;
            EXPECT_LE(ortho.widest_gap, 2.0) << width << " " << half;
            frame::Camera near_by = camera_from(eye, size, half);
            near_by.view = frame::look_at(eye, glm::dvec3(0.0), {0, 0, 1});
            near_by.projection = frame::perspective(0.4 * half, size, size, 0.1, 20.0, near_by.depth);
            const Line perspective = line(set, width, near_by, sphere_contour(eye, true), sphere_bend);
            EXPECT_LE(perspective.farthest, 1.11) << width << " " << half;
            EXPECT_LE(perspective.bare, 0.002) << width << " " << half;
            EXPECT_LE(perspective.widest_gap, 2.0) << width << " " << half;
        }
    }
}

TEST_F(Contours, OfATorusAreThinAndWhole) {
    const marks::PointSet set = spread(runtime, test::Torus(1.0, minor), 250000);
    for (const double tilt : {0.2, 0.7, 1.1}) {
        const glm::dvec3 eye(0.0, -4.0 * std::sin(tilt), 4.0 * std::cos(tilt));
        for (const double half : {1.6, 0.9}) {
            const Line ortho =
                line(set, 1.0F, camera_from(eye, size, half), torus_contour(eye, false), torus_bend(eye, false));
            // At a cusp the surface does not bend along the line of sight, and the law of a circle ends there.
            // Elsewhere it is off in clusters of a few marks, which have the shape of the cell that they are cut from.
            EXPECT_LE(ortho.astray, 0.005 * ortho.marks) << tilt << " " << half;
            EXPECT_LE(ortho.strayed, 0.015 * ortho.marks) << tilt << " " << half;
            EXPECT_LE(ortho.farthest, 8.0);
            EXPECT_LE(ortho.bare, 0.005) << tilt << " " << half << " " << ortho.widest_gap;
            frame::Camera near_by = camera_from(eye, size, half);
            near_by.view = frame::look_at(eye, glm::dvec3(0.0), {0, 1, 0});
            near_by.projection = frame::perspective(0.5 * half, size, size, 0.1, 20.0, near_by.depth);
            const Line perspective = line(set, 1.0F, near_by, torus_contour(eye, true), torus_bend(eye, true));
            EXPECT_LE(perspective.astray, 0.005 * perspective.marks) << tilt << " " << half;
            EXPECT_LE(perspective.strayed, 0.015 * perspective.marks) << tilt << " " << half;
            EXPECT_LE(perspective.bare, 0.005) << tilt << " " << half << " " << perspective.widest_gap;
        }
    }
}

TEST_F(Contours, AreNotHiddenByTheirOwnLayer) { expect_whole_sphere(); }

// Marks a pixel inside of the contour lie many pixels nearer to the eye than it: their halo must not hide it.
TEST_F(Contours, AreNotHiddenByTheirOwnHalo) {
    halo = 2.0F;
    expect_whole_sphere();
}

TEST_F(Contours, AreOfOneDensityWhateverTheZoom) {
    const marks::PointSet set = spread(runtime, test::Sphere(), 60000);
    for (const double half : {3.0, 2.0, 1.4}) {
        const Line found =
            line(set, 1.0F, camera_from({0, 0, 1}, size, half), sphere_contour({0, 0, 1}, false), sphere_bend);
        const double pixels = 2.0 * pi * size / (2.0 * half);
        EXPECT_GT(found.marks, 2.0 * pixels) << half;
        EXPECT_LT(found.marks, 4.0 * pixels) << half;
    }
}

TEST_F(Contours, ByAngleAreThePublishedBand) {
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 150));
    for (const double threshold : {0.05, 0.2, 0.4}) {
        Style style = contours(1.0F);
        style.silhouette_law = SilhouetteLaw::angle;
        style.silhouette_threshold = threshold;
        style.tone_fade = 0.0F;
        const glm::dvec3 toward = glm::normalize(glm::dvec3(0.2, -1.0, 1.0));
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera_from(toward, size, 1.8));
        const std::vector<float> share = seen_share(frame, set.layers[0].count());
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            const double nu = std::abs(glm::dot(mark_of(set, i).normal, toward));
            if (std::abs(nu - threshold) < 1e-5) continue;
            ASSERT_EQ(share[static_cast<std::size_t>(i) + 1], nu < threshold ? 1.0F : -1.0F) << nu;
        }
    }
}

TEST(StretchedContours, LieOnTheOutlineOfAnEllipsoid) {
    const base::Runtime runtime;
    const marks::PointSet set = clustered(runtime, sphere(runtime.memory, 60000));
    glm::dmat4 stretched(1.0);
    stretched[0][0] = 1.1;
    stretched[1][1] = 0.8;
    stretched[2][2] = 0.6;
    Style style = all_front(frame::HiddenLines::show);
    style.contour_kinds = 1;
    DrawnFrame frame(runtime);
    const std::array items{layered_item(set, style, stretched)};
    frame.draw(items, front_camera(600, 600));
    const double pixel = 2.5 / 600.0;
    std::array<int, 90> around{};
    for (const Disc& disc : frame.discs()) {
        if (disc.mark_class != drawing::MarkClass::silhouette) continue;
        const double x = (static_cast<double>(disc.x) - 300.0) * pixel;
        const double y = (static_cast<double>(disc.y) - 300.0) * pixel;
        // The outline, to first order.
        const double f = x * x / 1.21 + y * y / 0.64 - 1.0;
        const double off = std::abs(f) / (2.0 * std::hypot(x / 1.21, y / 0.64));
        ASSERT_LE(off, 2.5 * pixel) << x << " " << y;
        ++around[static_cast<std::size_t>((std::atan2(y, x) + pi) / (2.0 * pi) * 89.999)];
    }
    for (const int marks : around) EXPECT_GT(marks, 0);
}

} // namespace
} // namespace hrbfnpr::testing::contours_test
