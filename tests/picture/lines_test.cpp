// SPDX-License-Identifier: MIT
#include "picture/lines.h"

#include "planned_call.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace picture_tests::lines_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

constexpr double tau = 2.0 * std::numbers::pi;

class CreasesTest : public testing::Test {
protected:
    // Adds a side of four corners as two triangles with separate points, as in STL files.
    void add_side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
        for (const glm::dvec3& corner : {a, b, c, a, c, d}) {
            shape.points.push_back(corner);
            if (shape.points.size() % 3 == 0) {
                const auto last = static_cast<std::int64_t>(shape.points.size()) - 1;
                shape.triangles.push_back({last - 2, last - 1, last});
            }
        }
    }
    void add_box() {
        add_side({0, 0, 0}, {0, 2, 0}, {3, 2, 0}, {3, 0, 0});
        add_side({0, 0, 1}, {3, 0, 1}, {3, 2, 1}, {0, 2, 1});
        add_side({0, 0, 0}, {3, 0, 0}, {3, 0, 1}, {0, 0, 1});
        add_side({0, 2, 0}, {0, 2, 1}, {3, 2, 1}, {3, 2, 0});
        add_side({0, 0, 0}, {0, 0, 1}, {0, 2, 1}, {0, 2, 0});
        add_side({3, 0, 0}, {3, 2, 0}, {3, 2, 1}, {3, 0, 1});
    }
    // Adds a prism over a regular polygon.
    void add_prism(int corners) {
        const auto at = [&](int i, double z) {
            const double angle = tau * (i % corners) / corners;
            return glm::dvec3(std::cos(angle), std::sin(angle), z);
        };
        for (int i = 0; i < corners; ++i) {
            add_side(at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1));
            add_side(at(i + 1, 0), at(i, 0), {0, 0, 0}, {0, 0, 0});
            add_side(at(i, 1), at(i + 1, 1), {0, 0, 1}, {0, 0, 1});
        }
    }

    [[nodiscard]] Vector<Polyline> creases(double angle) {
        return mesh_creases(*planned.context.get(), shape, angle, nullptr, pool);
    }

    PlannedCall planned;
    Pool& pool = planned.pool;
    Shape shape{pool};
};

TEST_F(CreasesTest, ABoxHasTwelveEdgesOfTwoPoints) {
    add_box();
    const auto edges = creases(30.0);
    ASSERT_EQ(edges.size(), 12U);
    double length = 0.0;
    for (const Polyline& line : edges) {
        ASSERT_EQ(line.size(), 2U);
        length += glm::length(line[1] - line[0]);
    }
    EXPECT_EQ(length, 4.0 * (3.0 + 2.0 + 1.0));
    EXPECT_EQ(edges[0], (Polyline{{{0, 0, 0}, {0, 2, 0}}, &pool})); // Creases follow the order of the faces.
    EXPECT_TRUE(creases(95.0).empty());
}

TEST_F(CreasesTest, EdgesAroundARimAreOneClosedLine) {
    add_prism(24); // Sides meet at 15 degrees.
    const auto rims = creases(30.0);
    ASSERT_EQ(rims.size(), 2U);
    for (const Polyline& rim : rims) {
        EXPECT_EQ(rim.size(), 25U);
        EXPECT_EQ(rim.front(), rim.back());
    }
    EXPECT_EQ(creases(10.0).size(), 3U * 24U); // The edges between the sides are creases, too.
}

TEST_F(CreasesTest, FacetsOfARoundedShapeAreLeftOut) {
    add_prism(200); // At 1 degree all edges are creases, and rims end at each corner.
    const double diagonal = 3.0;
    auto lines = creases(1.0);
    EXPECT_EQ(lines.size(), 600U);
    lines = without_facets(std::move(lines), diagonal);
    EXPECT_EQ(lines.size(), 600U); // The mean crease is long enough.
    lines = without_facets(std::move(lines), 10.0 * diagonal);
    EXPECT_TRUE(lines.empty());
    EXPECT_TRUE(without_facets(std::move(lines), diagonal).empty());
}

TEST_F(CreasesTest, BadFacesAreIgnored) {
    EXPECT_THROW(static_cast<void>(creases(30.0)), Error);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    add_box();
    add_side({nan, 0, 0}, {0, nan, 0}, {0, 0, nan}, {nan, nan, nan});
    shape.triangles.push_back({0, 0, 0});
    shape.triangles.push_back({0, 0, 1});
    EXPECT_EQ(creases(30.0).size(), 12U); // The box has its twelve edges.
}

class LinesTest : public testing::Test {
protected:
    LinesTest() {
        const test::Samples samples = test::sphere(200);
        auto fit = picture::defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        surface.model = make<picture::Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(planned.context.get(), &fit, nullptr, made, error);
        });
    }
    LineSet lines_of(const char* text) {
        planned.desc.lines = text;
        const Call call = planned.call();
        return make_lines(call, surface, style, parse_lines(text, pool), Vector<LinesOnce>(&pool), false);
    }
    const Vector<Note>& notes() const { return planned.report->notes; }

    PlannedCall planned;
    Pool& pool = planned.pool;
    picture::Style style{HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, pool};
    Surface surface;
};

TEST_F(LinesTest, SectionsStandEvenlyBetweenTheBounds) {
    const Call call = planned.call();
    const auto once = lines_found_once(call, *surface.model.get(), parse_lines("contour,section=x:4,ridges", pool));
    ASSERT_EQ(once.size(), 2U);
    ASSERT_EQ(once[0].levels.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(once[0].levels[i], -0.75 + 0.5 * static_cast<double>(i), 0.02);
    EXPECT_EQ(once[0].plane, glm::dvec3(1, 0, 0));
    EXPECT_EQ(once[1].kind, std::uint32_t{HRBFNPR_LINE_KIND_RIDGE});
    EXPECT_TRUE(once[1].levels.empty());
}

TEST_F(LinesTest, ReportsFoundLinesAndTheEndOfTheSurface) {
    EXPECT_TRUE(lines_of("contour,section=z:3"));
    ASSERT_EQ(planned.report->stages.size(), 1U);
    EXPECT_NE(planned.report->stages[0].says.find("3 view-independent lines on "), String::npos);
    EXPECT_TRUE(notes().empty());
    EXPECT_TRUE(lines_of("border"));
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0].code, std::uint32_t{HRBFNPR_NOTE_LINES_END});
    EXPECT_EQ(notes()[0].severity, std::uint32_t{HRBFNPR_SEVERITY_INFO});
    EXPECT_EQ(notes()[0].text, "lines: the surface has no border within support 3");
    planned.change("line_set.support", "2.5");
    EXPECT_TRUE(lines_of("contour"));
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0].text, "lines: the surface has no border within support 2.5");
    planned.change("line_set.support", "0");
    EXPECT_TRUE(lines_of("border"));
    EXPECT_TRUE(notes().empty());
}

TEST_F(LinesTest, LinesThatNoStyleDrawsAreNotSearched) {
    style.base.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    EXPECT_FALSE(lines_of("contour"));
    style.base.visibility = HRBFNPR_VISIBILITY_DEPTH_LAYERS;
    style.lines.clear();
    EXPECT_FALSE(lines_of("contour"));
    EXPECT_TRUE(planned.report->stages.empty());
}

TEST_F(LinesTest, CreasesNeedAMeshOrAModelWithEdges) {
    try {
        static_cast<void>(lines_of("crease"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::invalid_argument);
        EXPECT_STREQ(error.what(), "creases need a mesh, or a model with sharp edges; this file has neither");
    }
    const auto shape = std::make_shared<Shape>(pool);
    shape->points = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}}, &pool};
    shape->triangles.push_back({0, 1, 2});
    shape->triangles.push_back({1, 3, 2});
    surface.shape = shape;
    ASSERT_TRUE(lines_of("crease"));
    EXPECT_NE(planned.report->stages[0].says.find("1 view-independent line on "), String::npos);
}

TEST_F(LinesTest, WarnsOfDoubtfulLines) {
    static_cast<void>(planned.call());
    hrbfnpr_drawing_info info{};
    tell_doubts(*planned.report, info);
    EXPECT_TRUE(notes().empty());
    info.line_broken = 2;
    info.line_contradictions = 3;
    info.line_tangles = 4;
    tell_doubts(*planned.report, info);
    ASSERT_EQ(notes().size(), 3U);
    EXPECT_EQ(notes()[0].text, "2 lines broken off inside the surface, or missing: more samples there would help");
    EXPECT_EQ(notes()[1].text, "3 lines possibly drawn where hidden, or left out where visible");
    EXPECT_EQ(notes()[2].text, "4 places where many lines cross: hidden parts of lines may be wrong there");
    EXPECT_EQ(notes()[2].code, std::uint32_t{HRBFNPR_NOTE_LINES_TANGLED});
    EXPECT_EQ(notes()[2].severity, std::uint32_t{HRBFNPR_SEVERITY_WARNING});
}

} // namespace
} // namespace picture_tests::lines_test
