// SPDX-License-Identifier: MIT
#include "picture/views.h"

#include "picture/tuning_views.h"
#include "picture/view_lines.h"
#include "planned_call.h"
#include "support/half_samples.h"
#include "support/samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

namespace picture_tests::views_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::HasSubstr;
using testing::Not;

// Draws sheets of a sphere of radius 1.
class ViewsTest : public testing::Test {
protected:
    ViewsTest() {
        static_cast<void>(planned.call());
        const test::Samples samples = test::sphere(200);
        surface.model = fitted(samples.points, samples.normals);
        desc.views = "front,top";
        desc.model = "ball.ply";
        desc.unit_mm = 20.0;
    }
    [[nodiscard]] picture::Model fitted(const std::vector<double>& points, const std::vector<double>& normals) {
        const auto count = static_cast<std::int64_t>(points.size() / 3);
        auto fit = picture::defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {points.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {normals.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        return make<picture::Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(planned.context.get(), &fit, nullptr, made, error);
        });
    }
    std::string written() {
        std::string bytes;
        const auto write = [](void* user, const void* data, std::uint64_t size) -> std::int32_t {
            static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
            return 0;
        };
        const Call call = planned.call();
        std::vector<Surface> surfaces(others);
        surfaces.push_back(surface);
        write_views(call, surfaces, {0, 0, 1}, read_views(desc, call.report), write, &bytes, info);
        return bytes;
    }
    [[nodiscard]] std::string refusal() {
        try {
            written();
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "nothing was refused";
    }

    PlannedCall planned;
    Pool& pool = planned.pool;
    Surface surface;
    std::vector<Surface> others;
    hrbfnpr_views_desc desc = picture::defaults<hrbfnpr_views_desc>(hrbfnpr_views_desc_init);
    hrbfnpr_views_info info{};
};

TEST_F(ViewsTest, ASheetHasItsViewsInLayers) {
    desc.sections = "x:0.5";
    desc.flags = HRBFNPR_VIEWS_LABELS | HRBFNPR_VIEWS_CENTRE_LINES;
    desc.scale = "1:1";
    const std::string sheet = written();
    for (const char* const layer :
         {"outlines front", "outlines top", "outlines A-A", "hatching A-A", "cutting planes front", "centre lines top",
          "frame", "title block", "projection", "scale bar", "texts"})
        EXPECT_THAT(sheet, HasSubstr("inkscape:label=\"" + std::string(layer) + "\""));
    EXPECT_THAT(sheet, Not(HasSubstr("hidden"))); // No line of a ball is hidden.
    for (const char* const text :
         {">ball<", ">ball.ply<", ">1:1<", ">A4, mm<", ">Front view<", ">A-A<", "width=\"297mm\""})
        EXPECT_THAT(sheet, HasSubstr(text));
    EXPECT_EQ(info.views, 3);
    EXPECT_EQ(info.bytes, static_cast<std::int64_t>(sheet.size()));
    EXPECT_STREQ(info.scale_text, "1:1");
    EXPECT_STREQ(info.paper, "a4");
    EXPECT_EQ(info.width, 297.0);
    EXPECT_EQ(info.unit_mm, 20.0);
    ASSERT_EQ(planned.report->stages.size(), 2U);
    EXPECT_THAT(std::string(planned.report->stages[0].says), HasSubstr("0 sharp edges of the mesh on "));
    EXPECT_EQ(planned.report->stages[1].says, "front, top, A-A");
    EXPECT_EQ(written(), sheet);
}

// A bowl without thickness has no inside. Its cuts are an open and a closed line.
TEST_F(ViewsTest, CutsOfAShellAreLines) {
    const test::PartSamples bowl = test::sphere_cap(600, 0.0);
    surface.model = fitted(bowl.points, bowl.normals);
    desc.sections = "x:0;z:0.5";
    const std::string sheet = written();
    EXPECT_THAT(sheet, HasSubstr("outlines A-A"));
    EXPECT_THAT(sheet, HasSubstr("outlines B-B"));
    EXPECT_THAT(sheet, Not(HasSubstr("hatching")));
    for (const Note& note : planned.report->notes) EXPECT_NE(note.code, HRBFNPR_NOTE_SECTION_OPEN);
}

// Two balls of radius 1, a unit apart, cross in a circle that is seen as a line in the front view.
TEST_F(ViewsTest, SurfacesThatCrossHaveALine) {
    test::Samples samples = test::sphere(200);
    for (std::size_t i = 0; i < samples.points.size(); i += 3) samples.points[i] += 1.0;
    auto fit = picture::defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    others.emplace_back().model = make<picture::Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
        return hrbfnpr_model_fit(planned.context.get(), &fit, nullptr, made, error);
    });
    desc.views = "front";
    desc.sections = "z:0";
    desc.scale = "1:1";
    const std::string sheet = written();
    EXPECT_THAT(sheet, HasSubstr("outlines front"));
    // The circle is seen edge-on: a line of 34.6 mm that goes straight up.
    const std::size_t begin = sheet.find("inkscape:label=\"outlines front\"");
    const std::string group = sheet.substr(begin, sheet.find("</g>", begin) - begin);
    int upright = 0;
    for (std::size_t at = group.find(" d=\"M"); at != std::string::npos; at = group.find(" d=\"M", at + 1)) {
        const std::size_t end = group.find('"', at + 4);
        std::string path = group.substr(at + 5, end - at - 5);
        for (char& c : path)
            if (std::isalpha(static_cast<unsigned char>(c)) != 0) c = ' ';
        std::istringstream numbers(path);
        double x = 0.0, y = 0.0, wide = 0.0, high = 0.0;
        numbers >> x >> y;
        // All places after the first are relative; the sum of control points is at least as far as the path goes.
        for (double dx = 0.0, dy = 0.0; numbers >> dx >> dy;) {
            wide += std::abs(dx);
            high += std::abs(dy);
        }
        upright += wide < 1.0 && high > 34.0 ? 1 : 0;
    }
    EXPECT_EQ(upright, 1);
}

TEST_F(ViewsTest, UnitsAndTitlesAreApplied) {
    desc.unit_mm = 0.0;
    desc.flags = HRBFNPR_VIEWS_UNIT_IS_METRE;
    desc.title = "Ball & more";
    desc.views = "front";
    const std::string sheet = written();
    EXPECT_THAT(sheet, HasSubstr(">Ball &amp; more<"));
    EXPECT_EQ(info.unit_mm, 1000.0);
    EXPECT_STREQ(info.scale_text, "1:10"); // The sphere takes 200 of 247 mm.
    ASSERT_EQ(planned.report->notes.size(), 1U);
    EXPECT_EQ(planned.report->notes[0].code, std::uint32_t{HRBFNPR_NOTE_UNIT_IS_METRE});
    EXPECT_EQ(planned.report->notes[0].text, "glTF is in metres: a unit is 1000 mm (--unit-mm changes it)");
}

TEST_F(ViewsTest, ImpossibleViewsAreRefusedInTheCallersWords) {
    desc.sections = "x:3";
    EXPECT_THAT(refusal(), HasSubstr("--section: the plane at 3 misses the model, which lies between -0.999"));
    desc.sections = "y:-3"; // The cut is seen against its axis, but the message uses the axis.
    EXPECT_THAT(refusal(), HasSubstr("--section: the plane at -3 misses the model, which lies between -"));
    desc.sections = nullptr;
    desc.smooth = "ridges,hills";
    EXPECT_THAT(refusal(), HasSubstr("'hills'; there are ridges, valleys, suggestive and none"));
    desc.smooth = nullptr;
    desc.scale = "100:1";
    desc.paper = "a4";
    EXPECT_THAT(refusal(), HasSubstr("--scale 100:1: the views need"));
    desc.scale = nullptr;
    desc.line_width = 0.0;
    EXPECT_THAT(refusal(), HasSubstr("views_desc.line_width is 0; it must be from 0.01 to 1000"));
    desc.line_width = 0.5;
    desc.hidden = 3;
    EXPECT_THAT(refusal(), HasSubstr("views_desc.hidden is 3"));
    desc.hidden = 0;
    desc.title = "\xFF";
    EXPECT_THAT(refusal(), HasSubstr("views_desc.title is not UTF-8"));
}

TEST_F(ViewsTest, LinesLieOnTheSurface) {
    constexpr double scale = 20.0;
    const Standing axes = standing({0, 0, 1});
    const Vector<ViewName> names({ViewName::front}, &pool);
    const Vector<AskedCut> cuts = parse_sections("x:0.5", *planned.report);
    const Vector<CutPlane> planes = planes_of(cuts, names, axes, glm::dvec3(0.0), pool);
    Solid solid(pool);
    solid.model = surface.model;
    solid.diagonal = std::sqrt(12.0);
    auto marks = picture::defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    auto layer = picture::defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    layer.budget = 20;
    marks.layers = &layer;
    marks.layer_count = 1;
    solid.marks = make<PointSet>([&](hrbfnpr_point_set** made, hrbfnpr_error* error) {
        return hrbfnpr_point_set_generate(planned.context.get(), solid.model.get(), &marks, nullptr, made, error);
    });
    auto section = picture::defaults<hrbfnpr_line_desc>(hrbfnpr_line_desc_init);
    section.kind = HRBFNPR_LINE_KIND_SECTION;
    section.name = "A";
    section.plane[0] = 1.0;
    section.plane[2] = 0.0;
    section.levels = {&planes[0].place, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    auto lines = picture::defaults<hrbfnpr_line_set_desc>(hrbfnpr_line_set_desc_init);
    lines.lines = &section;
    lines.line_count = 1;
    solid.lines = make<LineSet>([&](hrbfnpr_line_set** made, hrbfnpr_error* error) {
        return hrbfnpr_line_set_create(planned.context.get(), solid.model.get(), &lines, nullptr, made, error);
    });
    solid.renderer = make<Renderer>([&](hrbfnpr_renderer** made, hrbfnpr_error* error) {
        return hrbfnpr_renderer_create(planned.context.get(), made, error);
    });
    const Vector<SheetView> views = views_of(names, planes, axes, pool);

    const ViewLines front = lines_of_view(views[0], planes, solid, scale, nullptr, pool);
    EXPECT_TRUE(front.outlines.empty());
    ASSERT_EQ(front.curves.size(), 1U);
    EXPECT_EQ(front.curves[0].points.front(), front.curves[0].points.back());
    for (const glm::dvec2& p : front.curves[0].points) EXPECT_NEAR(glm::length(p), scale, 0.1);
    for (const std::uint8_t hidden : front.curves[0].hidden) EXPECT_EQ(hidden, 0);

    // The larger part of the sphere is beyond the plane. Its contour and the outline of the cut are both visible.
    const ViewLines cut = lines_of_view(views[1], planes, solid, scale, nullptr, pool);
    ASSERT_EQ(cut.outlines.size(), 1U);
    for (const glm::dvec2& p : cut.outlines[0]) EXPECT_NEAR(glm::length(p), std::sqrt(0.75) * scale, 0.1);
    ASSERT_EQ(cut.curves.size(), 2U);
    EXPECT_EQ(cut.curves[1].rank, 0);
    for (const glm::dvec2& p : cut.curves[0].points) EXPECT_NEAR(glm::length(p), scale, 0.1);
    for (const std::uint8_t hidden : cut.curves[0].hidden) EXPECT_EQ(hidden, 0);

    // The sphere hides edges of a mesh that are farther from the eye: two lines cross it, one beyond its middle and one
    // before.
    for (const double side : {1.0, -1.0}) {
        Points edge(&pool);
        for (int i = -20; i <= 20; ++i) edge.emplace_back(0.1 * i, 0.5 * side, 0.0); // The eye is at y = -infinity.
        solid.creases.clear();
        solid.creases.push_back(std::move(edge));
        const ViewLines seen = lines_of_view(views[0], planes, solid, scale, nullptr, pool);
        ASSERT_FALSE(seen.curves.empty());
        const ViewCurve& line = seen.curves[0];
        for (std::size_t i = 0; i < line.hidden.size(); ++i) {
            const double x = (line.points[i].x + line.points[i + 1].x) / 2.0 / scale;
            const bool is_behind = side > 0.0 ? std::abs(x) < 1.0 : std::abs(x) < std::sqrt(0.75);
            if (std::abs(std::abs(x) - (side > 0.0 ? 1.0 : std::sqrt(0.75))) > 0.03) {
                EXPECT_EQ(line.hidden[i] != 0, is_behind) << x;
            }
        }
    }
}

TEST_F(ViewsTest, ShortEdgesWithFreeEndsAreFacets) {
    const auto line = [&](std::initializer_list<glm::dvec3> points) { return Points(points, &pool); };
    Vector<Points> edges(&pool);
    edges.push_back(line({{0, 0, 0}, {0.01, 0, 0}})); // Both ends are free.
    edges.push_back(line({{5, 0, 0}, {6, 0, 0}}));    // Both ends are free, but it is long.
    edges.push_back(line({{0, 1, 0}, {0.01, 1, 0}})); // Both ends meet another edge.
    edges.push_back(line({{0.01, 1, 0}, {0, 2, 0}, {0, 1, 0}}));
    EXPECT_EQ(without_loose_edges(std::move(edges), 10.0, pool).size(), 3U);
    EXPECT_TRUE(without_loose_edges(Vector<Points>(&pool), 10.0, pool).empty());
}

} // namespace
} // namespace picture_tests::views_test
