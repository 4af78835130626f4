// SPDX-License-Identifier: MIT
// Tests contours smaller than a mesh cell: those of a bump in a plane, at an angle that just hides the bump's far side.
#include "curves/trace.h"

#include "traced.h"

namespace hrbfnpr::curves::small_loops_test {
namespace {

using namespace test_traced;

constexpr double side = 0.1;
constexpr double width = 0.35; // width of the bump's Gaussian
constexpr double height = 0.3;
const double steepest = height / width * std::exp(-0.5);

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// z = h exp(-r^2 / 2 s^2) around a point of the plane.
test::AnyField bump(const glm::dvec2& centre) {
    return {{{-1.0, -1.0, -0.2}, {1.0, 1.0, 0.45}}, [=](const glm::dvec3& p) {
                const glm::dvec2 q = (glm::dvec2(p) - centre) / width;
                const double e = height * std::exp(-0.5 * glm::dot(q, q));
                const glm::dvec2 slope = e / width * q;
                const double bend = -e / (width * width);
                return test::Field{
                    p.z - e,
                    {slope.x, slope.y, 1.0},
                    {bend * (q.x * q.x - 1.0), bend * q.x * q.y, 0.0, bend * (q.y * q.y - 1.0), 0.0, 0.0}};
            }};
}

// Along x the slope of the bump is steepest at -s; beside it the slope is less by the factor 1 - (dx/s)^2 - (dy/s)^2 /
// 2. A line of sight with the slope below is tangent to the surface along an ellipse with the half axis `reach` along
// x.
Eye grazing(double reach) {
    const double slope = steepest * (1.0 - reach * reach / (width * width));
    return Eye::at({1.0, 0.0, slope}, 3.0, false);
}

// Half of the loop's extent along x.
double reach_of(const Curves& curves) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    for (const CurvePoint& p : curves.point) {
        low = glm::min(low, p.position);
        high = glm::max(high, p.position);
    }
    return 0.5 * (high.x - low.x);
}

class SmallLoops : public testing::TestWithParam<double> {};

TEST_P(SmallLoops, AreFoundAnywhereInACell) {
    const double reach = 0.5 * GetParam() * side;
    std::int64_t between = 0;
    for (int i = 0; i < 25; ++i) {
        const glm::dvec2 centre(0.02 * (i % 5) + 0.003, 0.02 * (i / 5) - 0.007);
        const test::AnyField field = bump(centre);
        const Meshed meshed(runtime(), field, {{0.9, 0.9, 0.0}}, side);
        const Contours found(runtime(), meshed, grazing(reach).view());
        ASSERT_EQ(found.curves.count(), 1) << centre.x << ' ' << centre.y;
        expect_sound(runtime(), meshed, found);
        EXPECT_EQ(found.cusps(), 2);
        EXPECT_NEAR(reach_of(found.curves), reach, 0.1 * reach);
        for (const CurvePoint& p : found.curves.point)
            EXPECT_LE(glm::distance(glm::dvec2(p.position), centre - glm::dvec2(width, 0.0)), 1.6 * reach);
        between += found.report.loops;
    }
    EXPECT_GT(between, 0); // some loops pass between all vertices
}

// The sizes are in cells.
INSTANTIATE_TEST_SUITE_P(Sizes, SmallLoops, testing::Values(0.5, 0.25, 0.1));

TEST(SmallLoop, IsAbsentFromASteeperView) {
    const test::AnyField field = bump({0.01, 0.02});
    const Meshed meshed(runtime(), field, {{0.9, 0.9, 0.0}}, side);
    for (const double more : {1e-4, 1e-2, 0.3}) {
        const Eye eye = Eye::at({1.0, 0.0, steepest * (1.0 + more)}, 3.0, false);
        const Contours found(runtime(), meshed, eye.view());
        EXPECT_EQ(found.curves.count(), 0);
        EXPECT_EQ(found.report.missed, 0);
    }
}

} // namespace
} // namespace hrbfnpr::curves::small_loops_test
