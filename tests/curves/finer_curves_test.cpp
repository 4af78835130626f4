// SPDX-License-Identifier: MIT
// Tests the refinement of curves: exact points where they are requested, and no change elsewhere. Also tests meshes
// that join parts that are separate on the surface.
#include "curves/curve_changes.h"

#include "traced.h"

namespace hrbfnpr::curves::finer_curves_test {
namespace {

using namespace test_traced;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

class FinerCurves : public testing::Test {
protected:
    FinerCurves()
        : eye(Eye::at({0.3, -0.5, 0.6}, 5.0, true)), view(eye.view()), of(runtime(), torus, {{1.4, 0.0, 0.0}}, 0.1) {}

    [[nodiscard]] static TraceSettings coarse() {
        TraceSettings settings;
        settings.longest = 4.0;
        settings.turn = 1.0;
        return settings;
    }
    [[nodiscard]] glm::dvec2 seen(const glm::dvec3& p) const {
        const glm::dvec4 q = view.to_window * glm::dvec4(p, 1.0);
        return glm::dvec2(q) / q.w;
    }
    // The largest distance between the middle of a piece and the exact curve, in pixels.
    [[nodiscard]] double farthest(const Contours& found, const Curves& curves) const {
        base::Array<CurvePoint> middle(runtime().memory);
        for (std::int64_t c = 0; c < curves.count(); ++c)
            for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
                const std::int64_t at = curves.first[c] + k;
                CurvePoint p;
                p.position = CubicPiece(curves.point[at], curves.point[curves.next(c, at)]).at(0.5);
                middle.push_back(p);
            }
        geometry::VecArray before(runtime().memory);
        for (const CurvePoint& p : middle) before.push_back(p.position);
        std::int64_t evaluations = 0;
        const base::Array<double> none(runtime().memory, middle.size());
        bring_closer(runtime(), found.level, none, middle, evaluations);
        double most = 0.0;
        for (std::int64_t i = 0; i < middle.size(); ++i)
            most = std::max(most, glm::distance(seen(before[i]), seen(middle[i].position)));
        return most;
    }

    const test::Torus torus{1.0, 0.4};
    const Eye eye;
    const View view;
    const Meshed of;
};

TEST_F(FinerCurves, StayWithinTheTolerance) {
    const Contours found(runtime(), of, view, coarse());
    ASSERT_GT(farthest(found, found.curves), 2e-3);
    base::Array<std::uint8_t> all(runtime().memory, found.curves.point.size());
    std::fill(all.begin(), all.end(), std::uint8_t{1});
    std::int64_t evaluations = 0;
    const Curves finer =
        finer_curves(runtime(), found.level, view, found.curves, std::as_const(all).span(), 1e-4, evaluations);
    EXPECT_LE(farthest(found, finer), 1e-4);
    EXPECT_GT(evaluations, 0);
    EXPECT_EQ(finer.count(), found.curves.count());
    EXPECT_EQ(count_cusps(finer), found.cusps());
}

TEST_F(FinerCurves, AreUnchangedWithoutMarkedPoints) {
    const Contours found(runtime(), of, view, coarse());
    const base::Array<std::uint8_t> none(runtime().memory, found.curves.point.size());
    std::int64_t evaluations = 0;
    const Curves same = finer_curves(runtime(), found.level, view, found.curves, none.span(), 1e-4, evaluations);
    ASSERT_EQ(same.point.size(), found.curves.point.size());
    for (std::int64_t i = 0; i < same.point.size(); ++i)
        EXPECT_EQ(same.point[i].position, found.curves.point[i].position);
    EXPECT_EQ(evaluations, 0);
}

// Cassini's ovals about the x axis with a gap of 2 sqrt(a^2 - c^2).
struct Ovals {
    double gap;
    [[nodiscard]] test::Field operator()(const glm::dvec3& p) const {
        const glm::dvec3 a(0.6, 0.0, 0.0);
        const glm::dvec3 q = p - a;
        const glm::dvec3 r = p + a;
        const double qq = glm::dot(q, q);
        const double rr = glm::dot(r, r);
        const double cc = 0.36 - 0.25 * gap * gap;
        return {qq * rr - cc * cc, 2.0 * rr * q + 2.0 * qq * r,
                test::operator+(test::identity(2.0 * (qq + rr)), test::outer(q, r, 8.0))};
    }
};

// A mesh that joins the two ovals has sign changes that no contour passes.
TEST(NearParts, HaveNoContourInTheGapBetweenThem) {
    for (const double gap : {0.005, 0.01, 0.02}) {
        const test::AnyField surface({glm::dvec3(-1.0, -0.5, -0.5), glm::dvec3(1.0, 0.5, 0.5)}, Ovals{gap});
        for (const double side : {0.05, 0.06, 0.07, 0.08}) {
            const Meshed of(runtime(), surface, {{0.84, 0.0, 0.0}, {-0.84, 0.0, 0.0}}, side);
            for (const Eye& eye : test::eyes(cube_directions(0.1), 5.0)) {
                const Contours found(runtime(), of, eye.view());
                EXPECT_EQ(found.report.missed, 0) << gap << ' ' << side;
                EXPECT_EQ(found.report.broken, 0) << gap << ' ' << side;
                EXPECT_EQ(found.closed(), found.curves.count());
            }
        }
    }
}

} // namespace
} // namespace hrbfnpr::curves::finer_curves_test
