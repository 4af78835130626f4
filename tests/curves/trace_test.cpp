// SPDX-License-Identifier: MIT
// Tests traced contours of surfaces whose contours are known.
#include "curves/trace.h"

#include "support/contour_shapes.h"
#include "traced.h"

namespace hrbfnpr::curves::trace_test {
namespace {

using namespace test_traced;

constexpr double tau = 6.283185307179586;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

TEST(Trace, GivesTheKnownCircleOfASphere) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        const Contours found(runtime(), meshed, eye.view());
        expect_sound(runtime(), meshed, found);
        ASSERT_EQ(found.curves.count(), 1);
        EXPECT_EQ(found.cusps(), 0);
        const double height = eye.perspective ? 1.0 / 3.0 : 0.0;
        for (const CurvePoint& p : found.curves.point) {
            EXPECT_NEAR(glm::length(p.position), 1.0, 1e-7);
            EXPECT_NEAR(glm::dot(p.position, eye.back), height, 1e-7);
        }
        EXPECT_NEAR(length(found.curves, 0), tau * std::sqrt(1.0 - height * height), 1e-4);
    }
}

// Tracing that starts from the curves of a view half a degree away gives the curves of this view with fewer
// evaluations. A curve that is missing there is found as without them.
TEST(Trace, ContinuesFromThePreviousView) {
    const test::Torus torus(1.0, 0.45);
    const Meshed meshed(runtime(), torus, {{1.45, 0.0, 0.0}}, 0.05);
    const auto seen_from = [](double angle) {
        View view;
        view.eye = {4.0 * std::sin(angle), -4.0 * std::cos(angle), 2.5, 1.0};
        return view;
    };
    Curves last(runtime().memory);
    for (int frame = 0; frame < 12; ++frame) {
        const ContourLevel level(torus, seen_from(0.01 * frame));
        TraceReport cold;
        Curves anew = trace(runtime(), level, meshed.mesh, {}, cold);
        ASSERT_EQ(anew.count(), 2);
        if (frame > 0) {
            const Curves near = moved_contours(runtime().memory, level.view(), last, meshed.mesh.side);
            EXPECT_EQ(near.point.size(), last.point.size());
            TraceReport warm;
            const Curves found = trace(runtime(), level, meshed.mesh, {}, warm, &near);
            ASSERT_EQ(found.count(), 2);
            EXPECT_EQ(warm.broken + warm.missed, 0);
            EXPECT_LT(warm.evaluations, cold.evaluations);
            EXPECT_LT(farthest_off(runtime(), level, found), 1e-7);
            EXPECT_NEAR(length(found, 0) + length(found, 1), length(anew, 0) + length(anew, 1), 1e-3);
            Curves one(runtime().memory);
            for (std::int64_t i = 0; i < near.first[1]; ++i) one.point.push_back(near.point[i]);
            one.first.push_back(one.point.size());
            one.closed.push_back(1);
            TraceReport half;
            EXPECT_EQ(trace(runtime(), level, meshed.mesh, {}, half, &one).count(), 2);
            EXPECT_GT(half.added, 0);
        }
        last = std::move(anew);
    }
}

// In the image with y up, the surface lies to the left of the outline.
TEST(Trace, OutlineKeepsTheSurfaceOnItsLeft) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        const Contours found(runtime(), meshed, eye.view());
        for (const CurvePoint& p : found.curves.point)
            EXPECT_GT(glm::dot(glm::cross(p.position, p.direction()), eye.back), 0.0);
    }
}

TEST(Trace, GivesTheKnownSectionOfAnEllipsoid) {
    const test::Ellipsoid ellipsoid({1.0, 0.7, 0.45});
    const Meshed meshed(runtime(), ellipsoid, {{1.0, 0.0, 0.0}}, 0.06);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        const Contours found(runtime(), meshed, eye.view());
        expect_sound(runtime(), meshed, found);
        ASSERT_EQ(found.curves.count(), 1);
        EXPECT_EQ(found.cusps(), 0);
        const glm::dvec3 polar = ellipsoid.times(glm::dvec3(eye.centre()));
        for (const CurvePoint& p : found.curves.point)
            EXPECT_NEAR(glm::dot(polar, p.position), eye.perspective ? 1.0 : 0.0, 1e-6);
    }
}

// The curvature of the circle through three points.
double circle_curvature(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return 2.0 * glm::length(glm::cross(b - a, c - a)) /
           (glm::distance(a, b) * glm::distance(b, c) * glm::distance(a, c));
}

// The curvature of the cone or cylinder of sight, measured across it and from the drawn curve alone.
double apparent_curvature(const Eye& eye, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    if (!eye.perspective) {
        const auto flat = [&](const glm::dvec3& p) { return p - glm::dot(p, eye.back) * eye.back; };
        return circle_curvature(flat(a), flat(b), flat(c));
    }
    const auto on_sphere = [&](const glm::dvec3& p) { return glm::normalize(p - eye.place()); };
    const double whole = circle_curvature(on_sphere(a), on_sphere(b), on_sphere(c));
    return std::sqrt(std::max(0.0, whole * whole - 1.0)) / glm::distance(b, eye.place());
}

// K = radial curvature times apparent curvature.  [Koenderink 1984]
TEST(Trace, RadialTimesApparentCurvatureIsGaussian) {
    const test::Ellipsoid ellipsoid({1.0, 0.7, 0.45});
    const Meshed meshed(runtime(), ellipsoid, {{1.0, 0.0, 0.0}}, 0.06);
    TraceSettings fine;
    fine.longest = 0.25;
    for (const Eye& eye : test::eyes(cube_directions(0.1), 3.0)) {
        const Contours found(runtime(), meshed, eye.view(), fine);
        const std::int64_t count = found.curves.point.size();
        ASSERT_GT(count, 50);
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 p = found.curves.point[i].position;
            const test::Field field = ellipsoid.at(p);
            const glm::dvec3 v = glm::normalize(found.view.sight(p));
            const double radial =
                (field.hessian[0] * v.x * v.x + field.hessian[3] * v.y * v.y + field.hessian[5] * v.z * v.z) /
                glm::length(field.gradient);
            const double apparent = apparent_curvature(eye, found.curves.point[(i + count - 1) % count].position, p,
                                                       found.curves.point[(i + 1) % count].position);
            EXPECT_NEAR(radial * apparent, ellipsoid.curvature(p), 0.03 * ellipsoid.curvature(p));
        }
    }
}

void expect_sound_at_all_views(const Meshed& meshed, double distance) {
    for (const Eye& eye : test::eyes(cube_directions(0.05), distance)) {
        SCOPED_TRACE(testing::Message() << (eye.perspective ? "perspective " : "orthographic ") << eye.back.x << ' '
                                        << eye.back.y << ' ' << eye.back.z);
        const Contours found(runtime(), meshed, eye.view());
        EXPECT_GT(found.curves.count(), 0);
        expect_sound(runtime(), meshed, found);
        EXPECT_LE(found.report.evaluations, 3 * found.curves.point.size());
    }
}

TEST(Trace, IsSoundOnAGenusTwoSurface) {
    const test::TwoHoles surface;
    const Meshed meshed(runtime(), surface, {{1.05, 0.1, 0.0}}, 0.04);
    ASSERT_GT(meshed.mesh.triangles(), 1000);
    expect_sound_at_all_views(meshed, 3.0);
}

TEST(Trace, IsSoundOnAKnot) {
    const test::Knot knot;
    const Meshed meshed(runtime(), knot, {{1.0 + test::Knot::tube, 0.0, 0.0}}, 0.05);
    ASSERT_GT(meshed.mesh.triangles(), 1000);
    expect_sound_at_all_views(meshed, 4.0);
}

// The contours end where the surface leaves its region.
TEST(Trace, OpenContoursEndAtTheBorder) {
    const test::Cylinder cylinder(0.5, 1.0);
    const Meshed meshed(runtime(), cylinder, {{0.5, 0.0, 0.0}}, 0.07);
    for (const Eye& eye : test::eyes(cube_directions(0.1), 3.0)) {
        if (std::abs(eye.back.z) > 0.95) continue; // in perspective, the view may be along the axis
        const Contours found(runtime(), meshed, eye.view());
        ASSERT_EQ(found.curves.count(), 2);
        EXPECT_EQ(found.closed(), 0);
        EXPECT_EQ(found.report.broken, 0);
        EXPECT_LE(farthest_off(runtime(), found.level, found.curves), 1e-6 * meshed.mesh.side);
        for (std::int64_t c = 0; c < 2; ++c) {
            const double a = found.curves.point[found.curves.first[c]].position.z;
            const double b = found.curves.point[found.curves.first[c + 1] - 1].position.z;
            EXPECT_NEAR(std::min(a, b), meshed.mesh.region.min.z, 2e-3 * meshed.mesh.side);
            EXPECT_NEAR(std::max(a, b), meshed.mesh.region.max.z, 2e-3 * meshed.mesh.side);
        }
    }
}

TEST(Trace, NothingIsSeenFromWithinASphere) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.1);
    for (const double distance : {0.0001, 0.5, 0.95})
        for (const glm::dvec3& towards : cube_directions(0.1)) {
            const Contours found(runtime(), meshed, Eye::at(towards, distance, true).view());
            EXPECT_EQ(found.curves.count(), 0);
            EXPECT_EQ(found.report.starts, 0);
        }
}

// Checks only that the trace ends and that all points are finite.
void expect_finite(const Contours& found) {
    for (const CurvePoint& p : found.curves.point) {
        EXPECT_TRUE(std::isfinite(p.position.x + p.position.y + p.position.z));
        EXPECT_GT(glm::length(p.direction()), 0.0);
    }
}

TEST(Trace, IsFiniteWithTheEyeOnTheSurface) {
    const test::SquareSphere sphere;
    const Meshed ball(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.1);
    const test::Torus torus(1.0, 0.35);
    const Meshed ring(runtime(), torus, {{1.35, 0.0, 0.0}}, 0.08);
    for (const glm::dvec3& towards : cube_directions(0.1)) {
        expect_finite(Contours(runtime(), ball, Eye::at(towards, 1.0, true).view()));
        const double angle = 5.0 * towards.x;
        const double around = 3.0 * towards.y;
        const double r = 1.0 + 0.35 * std::cos(around);
        const glm::dvec3 place(r * std::cos(angle), r * std::sin(angle), 0.35 * std::sin(around));
        expect_finite(Contours(runtime(), ring, Eye::at(place, glm::length(place), true).view()));
    }
}

TEST(Trace, EndsWhereTheFunctionIsNaN) {
    const test::SquareSphere sphere;
    const test::AnyField torn(sphere.bounds(), [&](const glm::dvec3& p) {
        test::Field field = sphere.at(p);
        if (p.x + 0.3 * p.y > 0.4) field.value = field.gradient.x = field.hessian[0] = NAN;
        return field;
    });
    const Meshed meshed(runtime(), torn, {{-1.0, 0.0, 0.0}}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(0.05), 3.0)) {
        const Contours found(runtime(), meshed, eye.view());
        expect_finite(found);
        for (const CurvePoint& p : found.curves.point) EXPECT_LE(p.position.x + 0.3 * p.position.y, 0.4);
    }
    const test::AnyField flat(sphere.bounds(), [&](const glm::dvec3& p) {
        return test::Field{sphere.at(p).value, glm::dvec3(0.0), {}};
    });
    const Meshed levelled(runtime(), flat, {{-1.0, 0.0, 0.0}}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(0.05), 3.0))
        expect_finite(Contours(runtime(), levelled, eye.view()));
}

// A spherical shell with its second derivatives.
test::AnyField shell_of(double thickness) {
    return {test::cube(1.0), [=](const glm::dvec3& p) {
                test::Field field = test_shapes::Shell{thickness}(p);
                const double r = glm::length(p);
                if (r == 0.0) return field;
                const double across = glm::dot(field.gradient, p) / (r * r);
                field.hessian =
                    test::operator+(test::identity(across), test::outer(p / r, p / r, 2.0 / thickness - across));
                return field;
            }};
}

// Where the wall is thinner than a cell, the mesh is torn, and changes of sign on it have no curve. A finer mesh is
// made around them, and finds all curves.
TEST(Trace, FindsCurvesOfThinWallsOnAFinerMesh) {
    const test::AnyField shell = shell_of(0.1);
    const Meshed meshed(runtime(), shell, {{1.0, 0.0, 0.0}, {0.9, 0.0, 0.0}}, 0.15);
    const Contours found(runtime(), meshed, Eye::at({1.0, 0.3, 0.2}, 3.0, false).view());
    EXPECT_EQ(found.report.missed, 0);
    EXPECT_EQ(found.curves.count(), 2);
}

// The finer mesh of the whole box around these changes takes 77 590 evaluations.
TEST(Trace, MeshesAgainOnlyAroundChangesWithoutACurve) {
    const test::AnyField shell = shell_of(0.05);
    const Meshed meshed(runtime(), shell, {{1.0, 0.0, 0.0}, {0.95, 0.0, 0.0}}, 0.1);
    shell.evaluations = 0;
    const Contours found(runtime(), meshed, Eye::at({1.0, 0.3, 0.2}, 3.0, false).view());
    EXPECT_EQ(found.report.missed, 0);
    EXPECT_GT(shell.evaluations, 10'000); // otherwise no finer mesh was made
    EXPECT_LT(shell.evaluations, 50'000);
}

TEST(Trace, FindsNothingOnAnEmptyMesh) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {}, 0.08);
    ASSERT_EQ(meshed.mesh.triangles(), 0);
    for (const Eye& eye : test::eyes({{1.0, 0.3, 0.2}}, 3.0)) {
        const Contours found(runtime(), meshed, eye.view());
        EXPECT_EQ(found.curves.count(), 0);
        EXPECT_EQ(found.curves.point.size(), 0);
    }
}

} // namespace
} // namespace hrbfnpr::curves::trace_test
