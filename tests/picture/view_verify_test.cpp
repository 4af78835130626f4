// SPDX-License-Identifier: MIT
// Tests that rays find and repair wrong pieces of a view's lines, on a fitted sphere of radius 1.
#include "picture/view_verify.h"

#include "picture/tuning_views.h"
#include "picture/views.h"
#include "planned_call.h"
#include "support/samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace picture_tests::view_verify_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::HasSubstr;
using testing::Not;

constexpr double scale = 20.0;

class ViewVerify : public testing::Test {
protected:
    ViewVerify() : solid(pool) {
        static_cast<void>(planned.call());
        const test::Samples samples = test::sphere(200);
        auto fit = picture::defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        surface.model = make<picture::Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(planned.context.get(), &fit, nullptr, made, error);
        });
        solid.model = surface.model;
        solid.diagonal = std::sqrt(12.0);
        solid.lines = make<LineSet>([&](hrbfnpr_line_set** made, hrbfnpr_error* error) {
            return hrbfnpr_line_set_create(planned.context.get(), solid.model.get(), nullptr, nullptr, made, error);
        });
        const Vector<ViewName> names({ViewName::front}, &pool);
        view = views_of(names, Vector<CutPlane>(&pool), standing({0, 0, 1}), pool)[0]; // The eye is at y = -infinity.
    }

    // Returns the line y = `depth`, z = 0 from x = -2 to 2, all of it drawn as hidden or as visible.
    ViewCurve line(double depth, bool hidden) {
        ViewCurve curve(pool);
        for (int i = -20; i <= 20; ++i) {
            curve.places.emplace_back(0.1 * i, depth, 0.0);
            curve.points.push_back(scale * view.flat(curve.places.back(), glm::dvec3(0.0)));
        }
        curve.hidden.assign(curve.points.size() - 1, hidden ? 1 : 0);
        return curve;
    }
    LineProof verify(Vector<ViewCurve>& curves, const CutPlane* plane = nullptr) {
        return verify_curves(curves, view, plane, solid, scale, nullptr, pool);
    }
    static void expect_hidden_between(const ViewCurve& curve, double low, double high) {
        ASSERT_EQ(curve.places.size(), curve.points.size());
        ASSERT_EQ(curve.hidden.size() + 1, curve.points.size());
        for (std::size_t i = 0; i < curve.hidden.size(); ++i) {
            const double x = 0.5 * (curve.places[i].x + curve.places[i + 1].x);
            EXPECT_NEAR(curve.points[i].x, scale * curve.places[i].x, 1e-9);
            if (std::min(std::abs(x - low), std::abs(x - high)) > 0.02) {
                EXPECT_EQ(curve.hidden[i] != 0, x > low && x < high) << x;
            }
        }
    }

    PlannedCall planned;
    Pool& pool = planned.pool;
    Surface surface;
    Solid solid;
    SheetView view;
};

TEST_F(ViewVerify, WrongPiecesAreDividedAndDrawnAsRaysShow) {
    for (const bool drawn_hidden : {false, true}) {
        Vector<ViewCurve> curves(&pool);
        curves.push_back(line(1.5, drawn_hidden));
        const LineProof proof = verify(curves);
        expect_hidden_between(curves[0], -1.0, 1.0);
        EXPECT_EQ(proof.pieces, 3);
        EXPECT_EQ(proof.agreeing, 3);
        EXPECT_EQ(proof.repaired, 1);
        for (const std::uint8_t sure : curves[0].sure) EXPECT_EQ(sure, 1);
    }
}

TEST_F(ViewVerify, RightPiecesStayAndUndecidedOnesAreNotSure) {
    Vector<ViewCurve> curves(&pool);
    curves.push_back(line(-1.5, false));           // before the sphere
    ViewCurve& beside = curves.emplace_back(pool); // far behind the sphere, and 0.01 mm beside its outline
    for (const double y : {1.5, 1.6}) {
        beside.places.emplace_back(1.0 + 0.01 / scale, y, 0.0);
        beside.points.push_back(scale * view.flat(beside.places.back(), glm::dvec3(0.0)));
    }
    beside.points[1] += glm::dvec2(0.0, 0.1); // The view sees the line as a point, which no curve is.
    beside.hidden.assign(1, 1);
    curves.push_back(line(-1.5, false));
    curves[2].places.clear(); // not compared
    const LineProof proof = verify(curves);
    EXPECT_EQ(proof.pieces, 2);
    EXPECT_EQ(proof.agreeing, 1);
    EXPECT_EQ(proof.undecided, 1);
    EXPECT_EQ(proof.repaired, 0);
    EXPECT_EQ(curves[0].hidden, line(-1.5, false).hidden);
    EXPECT_EQ(curves[0].sure.front(), 1);
    EXPECT_EQ(curves[1].sure.front(), 0);
    EXPECT_EQ(curves[1].hidden.front(), 1);
    EXPECT_TRUE(curves[2].sure.empty());
}

// A cutting plane takes away the part before it. Its cut face hides lines.
TEST_F(ViewVerify, RaysOfSectionsEndAtThePlane) {
    const CutPlane plane{String("A", &pool), glm::dvec3(0.0, -1.0, 0.0), 0.5}; // y = -0.5
    Vector<ViewCurve> curves(&pool);
    curves.push_back(line(1.5, false));
    EXPECT_EQ(verify(curves, &plane).agreeing, 3);
    expect_hidden_between(curves[0], -1.0, 1.0);
    const CutPlane beyond{String("B", &pool), glm::dvec3(0.0, -1.0, 0.0), -0.6}; // y = 0.6: less of the sphere is left
    curves[0] = line(1.5, true);
    EXPECT_EQ(verify(curves, &beyond).agreeing, 3);
    expect_hidden_between(curves[0], -0.8, 0.8);
}

// A gap narrower than two millimetres stays open if rays show it, and is closed as noise otherwise.
TEST_F(ViewVerify, NarrowGapsStayIfTheyAreSure) {
    for (const bool is_sure : {false, true}) {
        Vector<ViewCurve> curves(&pool);
        ViewCurve& curve = curves.emplace_back(pool);
        for (int i = 0; i <= 40; ++i) curve.points.emplace_back(1.0 * i, 0.0);
        curve.hidden.assign(40, 0);
        curve.hidden[20] = 1;
        if (is_sure) curve.sure.assign(40, 1);
        const ShownLines shown = draw_in_order(curves, true, pool);
        EXPECT_EQ(shown.outlines.size(), is_sure ? 2U : 1U);
    }
}

TEST_F(ViewVerify, TheSheetCarriesItsFigures) {
    auto desc = picture::defaults<hrbfnpr_views_desc>(hrbfnpr_views_desc_init);
    desc.views = "front,top";
    desc.unit_mm = 20.0;
    hrbfnpr_views_info info{};
    const auto written = [&] {
        std::string bytes;
        const auto write = [](void* user, const void* data, std::uint64_t size) -> std::int32_t {
            static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
            return 0;
        };
        const Call call = planned.call();
        write_views(call, std::span(&surface, 1), {0, 0, 1}, read_views(desc, call.report), write, &bytes, info);
        return bytes;
    };
    EXPECT_THAT(written(), Not(HasSubstr("pieces of lines")));
    EXPECT_EQ(info.pieces, 0);
    desc.flags = HRBFNPR_VIEWS_VERIFY;
    EXPECT_THAT(written(), HasSubstr("; 2 of 2 pieces of lines agree with rays; 0 undecided, 0 repaired"));
    EXPECT_EQ(info.pieces, 2);
    EXPECT_EQ(info.agreeing, 2);
    EXPECT_EQ(info.undecided + info.repaired, 0);
    ASSERT_EQ(planned.report->notes.size(), 1U);
    EXPECT_EQ(planned.report->notes[0].code, std::uint32_t{HRBFNPR_NOTE_LINES_VERIFIED});
    EXPECT_EQ(planned.report->notes[0].severity, std::uint32_t{HRBFNPR_SEVERITY_NOTE});
}

} // namespace
} // namespace picture_tests::view_verify_test
