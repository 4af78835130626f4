// SPDX-License-Identifier: MIT
// Tests surfaces that end where their samples end: meshes, borders, contours and rays.
#include "curves/mesh_checks.h"
#include "curves/traced.h"
#include "features/line_set.h"
#include "support/half_samples.h"

namespace hrbfnpr::curves::border_test {
namespace {

using namespace test;

LineSetSettings settings_of(const PartSamples& samples, double side, double limit) {
    LineSetSettings settings;
    settings.side = side;
    settings.seeds = samples.points;
    settings.support = {limit, samples.points, samples.normals};
    return settings;
}

struct Open {
    Open(const base::Runtime& runtime, const implicit::Implicit& surface, const PartSamples& samples, double side,
         double limit = 1.5)
        : lines(runtime, surface, std::make_unique<implicit::DifferencedShape>(surface),
                settings_of(samples, side, limit)) {}

    [[nodiscard]] const implicit::Domain& domain() const { return *lines.mesh().domain; }
    LineSet lines;
};

double off_surface(const implicit::Implicit& surface, const glm::dvec3& p) {
    double value = 0.0;
    double g[3];
    surface.evaluate({&p.x, &p.y, &p.z, 1}, {&value, {&g[0], &g[1], &g[2]}, {}});
    return std::abs(value) / std::hypot(g[0], g[1], g[2]);
}

class OpenSphere : public testing::Test {
protected:
    base::Runtime runtime = with_threads(2);
    SquareSphere sphere;
    PartSamples samples = sphere_cap(600, 0.0);
    Open open{runtime, sphere, samples, 0.07};
};

TEST_F(OpenSphere, MeshEndsAtTheLimit) {
    const SurfaceMesh& mesh = open.lines.mesh();
    const test_checks::Measures found = test_checks::measure(mesh, sphere);
    EXPECT_EQ(found.euler, 1); // a disc
    EXPECT_EQ(found.bad_edges + found.bad_across + found.unused, 0);
    EXPECT_LE(found.off, 1e-8);
    const Open whole(runtime, sphere, samples, 0.07, 1e9);
    EXPECT_EQ(whole.lines.left_out(), 0.0);
    EXPECT_NEAR(open.lines.left_out(), 0.45, 0.05);
    int on_border = 0;
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) {
        const double beyond = open.domain().beyond(mesh.position[i], mesh.gradient[i]);
        EXPECT_LE(beyond, 1e-7);
        on_border += std::abs(beyond) < 1e-7 ? 1 : 0;
    }
    EXPECT_GT(on_border, 100);
}

TEST_F(OpenSphere, BorderIsExact) {
    ASSERT_NE(open.lines.border_level(), nullptr);
    const Curves& border = open.lines.border().curves;
    ASSERT_EQ(border.count(), 1);
    EXPECT_EQ(border.closed[0], 1);
    EXPECT_LT(test_traced::sharpest_turn(border), 0.15);
    for (std::int64_t k = 0; k < border.pieces_of(0); ++k) {
        const CurvePoint& a = border.point[k];
        const CurvePoint& b = border.point[border.next(0, k)];
        EXPECT_LT(off_surface(sphere, a.position), 1e-8);
        EXPECT_NEAR(open.domain().beyond(a.position, a.gradient), 0.0, 1e-6);
        // The curve is exact between points, too.
        const glm::dvec3 middle = CubicPiece(a, b).at(0.5);
        EXPECT_LT(off_surface(sphere, middle), 1e-5);
        EXPECT_NEAR(open.domain().beyond(middle, middle), 0.0, 2e-3);
        // The surface lies to the left, as seen from outside.
        EXPECT_GT(glm::dot(glm::cross(a.position, b.position - a.position), glm::dvec3(0.0, 0.0, 1.0)), 0.0);
    }
}

TEST_F(OpenSphere, ContoursEndOnTheBorder) {
    for (const Eye& eye : eyes({{1.0, 0.2, 0.1}, {0.3, -1.0, -0.5}, {0.0, 0.7, 0.9}}, 4.0)) {
        const View view = eye.view();
        const ContourLevel level(sphere, view);
        TraceReport report;
        const Curves curves = trace(runtime, level, open.lines.mesh(), {}, report);
        ASSERT_EQ(curves.count(), 1);
        ASSERT_EQ(curves.closed[0], 0);
        EXPECT_EQ(report.broken + report.missed, 0);
        EXPECT_LT(test_traced::farthest_off(runtime, level, curves), 1e-7);
        for (std::int64_t i = 0; i < curves.point.size(); ++i) {
            const double beyond = open.domain().beyond(curves.point[i].position, curves.point[i].position);
            if (i == 0 || i + 1 == curves.point.size())
                EXPECT_NEAR(beyond, 0.0, 1e-6);
            else
                EXPECT_LT(beyond, 0.0);
        }
    }
}

TEST_F(OpenSphere, ContoursBeyondTheBorderAreDropped) {
    const View view = Eye::at({0.05, 0.0, -1.0}, 1.2, true).view(); // sees a circle at z = -0.83
    const ContourLevel level(sphere, view);
    TraceReport report;
    EXPECT_EQ(trace(runtime, level, open.lines.mesh(), {}, report).count(), 0);
}

TEST_F(OpenSphere, RaysPassThroughTheMissingPart) {
    const geometry::VecArray from = test_shapes::seeds(
        runtime, {{0.3, 0.2, 3.0}, {0.3, 0.2, 3.0}, {3.0, 0.1, 0.5}, {3.0, 0.1, -0.5}, {0.9, 0.1, -3.0}});
    const geometry::VecArray to = test_shapes::seeds(
        runtime, {{0.3, 0.2, -3.0}, {0.3, 0.2, 0.0}, {-3.0, 0.1, 0.5}, {-3.0, 0.1, -0.5}, {0.9, 0.1, 3.0}});
    const std::array<std::int32_t, 5> sheets{1, 1, 2, 0, 1};
    const base::Array<double> clear(runtime.memory, from.size());
    base::Array<SheetCounter::Result> answer(runtime.memory);
    open.lines.sheets().count(runtime, sphere, from, to, clear, answer);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        EXPECT_EQ(answer[static_cast<std::int64_t>(i)].sheets, sheets[i]) << i;
        EXPECT_TRUE(answer[static_cast<std::int64_t>(i)].certain) << i;
    }
}

// The rays go through the surface beside its border, towards the middle of the sphere: the triangles do not tell there
// where the surface ends.
TEST_F(OpenSphere, RaysNextToTheBorderCountTheRightSheets) {
    geometry::VecArray from(runtime.memory);
    geometry::VecArray to(runtime.memory);
    for (const CurvePoint& p : open.lines.border().curves.point) {
        const glm::dvec3 inward = glm::normalize(glm::cross(p.gradient, p.direction()));
        for (const double by : {-1e-4, 1e-4}) {
            const glm::dvec3 place = glm::normalize(p.position + by * inward);
            from.push_back(1.2 * place);
            to.push_back(0.8 * place);
        }
    }
    const base::Array<double> clear(runtime.memory, from.size());
    base::Array<SheetCounter::Result> answer(runtime.memory);
    open.lines.sheets().count(runtime, sphere, from, to, clear, answer);
    int told = 0;
    for (std::int64_t i = 0; i < answer.size(); ++i) {
        if (!answer[i].certain) continue;
        EXPECT_EQ(answer[i].sheets, i % 2) << i;
        ++told;
    }
    EXPECT_GT(told, answer.size() / 4);
}

TEST_F(OpenSphere, FacingPartsFitTogether) {
    const View view = Eye::at({1.0, 0.2, 0.3}, 4.0, true).view();
    const SurfaceLines border = with_turns(runtime, open.lines.border(), sphere, view);
    const SurfaceLines outside = facing_parts(runtime.memory, border, view, true);
    const SurfaceLines inside = facing_parts(runtime.memory, border, view, false);
    ASSERT_EQ(outside.curves.count(), 1);
    ASSERT_EQ(inside.curves.count(), 1);
    const auto& a = outside.curves.point;
    const auto& b = inside.curves.point;
    EXPECT_LT(glm::distance(a[0].position, b[b.size() - 1].position), 1e-12);
    EXPECT_LT(glm::distance(b[0].position, a[a.size() - 1].position), 1e-12);
    // The parts meet where the line of sight is tangent to the surface, which is where a contour ends.
    const ContourLevel level(sphere, view);
    TraceReport report;
    const Curves contour = trace(runtime, level, open.lines.mesh(), {}, report);
    ASSERT_EQ(contour.count(), 1);
    for (const glm::dvec3& end : {a[0].position, b[0].position}) {
        EXPECT_NEAR(glm::dot(glm::normalize(end), glm::normalize(view.sight(end))), 0.0, 1e-6);
        EXPECT_LT(std::min(glm::distance(end, contour.point[0].position),
                           glm::distance(end, contour.point[contour.point.size() - 1].position)),
                  1e-3 * open.lines.mesh().side);
    }
}

TEST(Border, AHalfTorusHasTwoBorders) {
    const base::Runtime runtime = with_threads(2);
    const Torus torus(1.0, 0.4);
    const Open open(runtime, torus, half_torus(1.0, 0.4), 0.06);
    EXPECT_EQ(open.lines.border().curves.count(), 2);
    EXPECT_EQ(test_checks::measure(open.lines.mesh(), torus).euler, 0); // a tube
    for (const CurvePoint& p : open.lines.border().curves.point) EXPECT_LT(p.position.y, 0.0);
}

TEST(Border, AFullySampledSphereIsNotCut) {
    const base::Runtime runtime = with_threads(2);
    const SquareSphere sphere;
    const Open open(runtime, sphere, sphere_cap(600, -1.0), 0.07);
    EXPECT_EQ(open.lines.border().curves.count(), 0);
    EXPECT_EQ(open.lines.left_out(), 0.0);
}

TEST(Border, ASurfaceWithoutAnySupportIsAnError) {
    const base::Runtime runtime = with_threads(2);
    const SquareSphere sphere;
    PartSamples turned = sphere_cap(600, 0.0);
    for (double& n : turned.normals) n = -n;
    try {
        const Open open(runtime, sphere, turned, 0.1);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::not_converged);
        EXPECT_NE(std::string(error.what()).find("support"), std::string::npos);
    }
}

} // namespace
} // namespace hrbfnpr::curves::border_test
