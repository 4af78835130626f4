// SPDX-License-Identifier: MIT
#include "picture/view_layout.h"

#include "picture/view_marks.h"
#include "planned_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace picture_tests::view_layout_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::HasSubstr;

class ViewLayoutTest : public testing::Test {
protected:
    ViewLayoutTest() { static_cast<void>(planned.call()); }

    [[nodiscard]] const Report& report() const { return *planned.report; }
    template <class F>
    [[nodiscard]] static std::string refusal(F&& f) {
        try {
            static_cast<void>(f());
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "nothing was refused";
    }
    // Sets up a sheet of four points that stand along z, cut by three planes.
    void set_up_sheet() {
        points = {{{0, 0, 0}, {40, 24, 16}, {10, 30, 2}, {-3, 5, 7}}, &pool};
        middle = middle_of(points, axes);
        const Vector<AskedCut> cuts = parse_sections("z:20;y;1:1:0:5", report());
        const Vector<ViewName> names = parse_views("front,left,top,iso", report());
        planes = planes_of(cuts, names, axes, middle, pool);
        cells = cells_of(views_of(names, planes, axes, pool), planes, points, middle, Projection::first, axes.up, true,
                         pool);
    }
    [[nodiscard]] SheetLayout chosen(const char* paper, const char* scale) {
        return choose_layout(cells, parse_paper(paper, report()), parse_scale(scale, report()), {1.0, 15.0, axes.up},
                             report());
    }

    PlannedCall planned;
    Pool& pool = planned.pool;
    Standing axes = standing({0, 0, 1});
    Points points{&pool};
    glm::dvec3 middle{0.0};
    Vector<CutPlane> planes{&pool};
    Vector<ViewCell> cells{&pool};
};

TEST_F(ViewLayoutTest, ViewsAndSectionsAreParsed) {
    const Vector<ViewName> names = parse_views("top,front,top", report());
    EXPECT_EQ(names, (Vector<ViewName>{{ViewName::top, ViewName::front}, &pool}));
    EXPECT_THAT(refusal([&] { return parse_views("front,side", report()); }),
                HasSubstr("--views: there is no view 'side'; there are front, back, left, right, top, bottom, iso"));
    EXPECT_THAT(refusal([&] { return parse_views("", report()); }), HasSubstr("no view ''"));

    const Vector<AskedCut> cuts = parse_sections("z:20; -x;+y:-2.5;1:1:0:5", report());
    ASSERT_EQ(cuts.size(), 4U);
    EXPECT_EQ(cuts[0].normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(cuts[0].place, 20.0);
    EXPECT_FALSE(cuts[0].is_signed);
    EXPECT_EQ(cuts[1].normal, glm::dvec3(-1, 0, 0));
    EXPECT_FALSE(cuts[1].place.has_value());
    EXPECT_TRUE(cuts[1].is_signed && cuts[2].is_signed && cuts[3].is_signed);
    EXPECT_EQ(cuts[2].place, -2.5);
    EXPECT_EQ(cuts[3].normal, glm::dvec3(1, 1, 0));
    EXPECT_TRUE(parse_sections("", report()).empty());
    for (const char* const text : {"w:3", "z:1:2", "0:0:0:1", ";", "zz"})
        EXPECT_THAT(refusal([&] { return parse_sections(text, report()); }), HasSubstr("is not a plane")) << text;
    for (const char* const text : {"z:", "z:nan", "x:1e999", "1:1:0:a"})
        EXPECT_THAT(refusal([&] { return parse_sections(text, report()); }), HasSubstr("a finite number")) << text;
}

TEST_F(ViewLayoutTest, PapersAreLandscapeAndScalesAreRatios) {
    EXPECT_FALSE(parse_paper("Auto", report()).has_value());
    const auto a3 = parse_paper("A3", report());
    EXPECT_EQ(a3->name, "a3");
    EXPECT_EQ(a3->width, 420.0);
    EXPECT_EQ(parse_paper("letter", report())->height, 215.9);
    EXPECT_EQ(parse_paper("210x297", report())->name, "210 x 297");
    EXPECT_EQ(parse_paper("210x297", report())->height, 297.0);
    for (const char* const text : {"a99", "", "0x5", "10", "nanx3"})
        EXPECT_THAT(refusal([&] { return parse_paper(text, report()); }), HasSubstr("--page")) << text;
    EXPECT_FALSE(parse_scale("auto", report()).has_value());
    EXPECT_EQ(parse_scale("1:2", report())->value, 0.5);
    EXPECT_EQ(parse_scale("2.5:1", report())->text, "2.5:1");
    for (const char* const text : {"1:0", "", "2", "-1:2", "1:", "a:b"})
        EXPECT_THAT(refusal([&] { return parse_scale(text, report()); }), HasSubstr("--scale must be auto or like 1:2"))
            << text;
}

TEST_F(ViewLayoutTest, ScalesFollowTheStandard) {
    const Vector<SheetScale> scales = standard_scales(pool);
    const auto one = std::find_if(scales.begin(), scales.end(), [](const SheetScale& s) { return s.text == "1:1"; });
    ASSERT_GE(one - scales.begin(), 4);
    std::string around;
    for (auto scale = one - 4; scale <= one + 4; ++scale) (around += scale->text) += ' ';
    EXPECT_EQ(around, "20:1 10:1 5:1 2:1 1:1 1:2 1:5 1:10 1:20 ");
    for (std::size_t i = 1; i < scales.size(); ++i) EXPECT_LT(scales[i].value, scales[i - 1].value);
}

TEST_F(ViewLayoutTest, ViewsLookTheRightWay) {
    set_up_sheet();
    const auto sees = [&](std::size_t cell, const glm::dvec3& right, const glm::dvec3& up) {
        const SheetView& view = cells[cell].view;
        EXPECT_LT(glm::length(view.right - right) + glm::length(view.up - up), 1e-12) << view.name;
        EXPECT_LT(glm::length(view.eye - glm::cross(right, up)), 1e-12) << view.name;
    };
    const double half = std::sqrt(0.5);
    sees(0, {1, 0, 0}, {0, 0, 1});        // The front is -y if z is up.
    sees(1, {0, -1, 0}, {0, 0, 1});       // This is the view from the left.
    sees(2, {1, 0, 0}, {0, 1, 0});        // From above, the front is at the bottom.
    sees(4, {1, 0, 0}, {0, 1, 0});        // The cut z:20 is seen from above.
    sees(5, {1, 0, 0}, {0, 0, 1});        // The cut y is turned to be seen from the front.
    sees(6, {-half, half, 0}, {0, 0, 1}); // Its normal gives the direction.
    EXPECT_EQ(cells[5].view.name, "B-B");
    EXPECT_EQ(planes[1].place, -15.0);
    // In an isometric view all axes have the length that the scale gives.
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 end = middle;
        end[axis] += 7.0;
        EXPECT_NEAR(glm::length(cells[3].view.flat(end, middle)), 7.0, 1e-12);
    }
    EXPECT_FALSE(cells[3].view.is_edge_on({0, 0, 1}));
    EXPECT_TRUE(cells[0].view.is_edge_on({0, 0, 1}));
    EXPECT_FALSE(cells[0].view.is_edge_on({0, 1, 0}));
}

TEST_F(ViewLayoutTest, PlacesMatchReferenceValues) { // A reference program in Python computed the numbers.
    set_up_sheet();
    EXPECT_EQ(middle, glm::dvec3(18.5, 15, 8));
    EXPECT_EQ(cells[0].cuts.size(), 1U);
    EXPECT_EQ(cells[2].cuts.size(), 2U);
    const SheetLayout layout = chosen("auto", "auto");
    EXPECT_EQ(layout.scale.text, "2:1");
    EXPECT_EQ(layout.page.name, "a3");
    const glm::dvec2 expected[] = {{92.86724134104449, 41.0},  {199.04415587728428, 41.0}, {92.86724134104449, 128.0},
                                   {208.5704353189131, 131.0}, {92.86724134104449, 234.5}, {288.2210704135241, 41.0},
                                   {363.8987399431877, 41.0}};
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(layout.centres[i], expected[i]) << i;
}

TEST_F(ViewLayoutTest, TheSmallestPaperWithRoomIsTakenAtAScale) {
    set_up_sheet();
    EXPECT_EQ(chosen("auto", "1:1").page.name, "a3");
    EXPECT_EQ(chosen("auto", "1:1").centres[3].y, 137.75);
    EXPECT_EQ(chosen("auto", "1:2").page.name, "a4");
    for (const char* const scale : {"1:1", "1:2", "1:5"}) { // No view meets the title block.
        const SheetLayout layout = chosen("auto", scale);
        for (std::size_t i = 0; i < cells.size(); ++i)
            EXPECT_FALSE(cells[i].box(layout.unit_scale).moved(layout.centres[i]).meets(block_of(layout.page)));
    }
}

TEST_F(ViewLayoutTest, ViewsWithoutRoomAreRefusedWithARemedy) {
    set_up_sheet();
    EXPECT_EQ(refusal([&] { return chosen("a4", "10:1"); }),
              "--scale 10:1: the views need 1505 x 997 mm, but a4 has room for 255 x 178 mm: --scale 1:2 fits");
    EXPECT_EQ(refusal([&] { return chosen("a4", "2:1"); }).substr(0, 24), "--scale 2:1: the views n");
    EXPECT_THAT(refusal([&] { return chosen("a4", "2:1"); }), HasSubstr("--scale 1:2 or --page a3 fits"));
    EXPECT_EQ(refusal([&] { return chosen("100x50", "auto"); }),
              "--page 100 x 50 is too small for these views: use a larger page or a smaller --spacing");
}

TEST_F(ViewLayoutTest, FirstAndThirdAngleAreMirrored) {
    set_up_sheet();
    const Vector<ViewName> names = parse_views("front,left,top", report());
    const auto place = [&](Projection projection) {
        cells = cells_of(views_of(names, Vector<CutPlane>(&pool), axes, pool), Vector<CutPlane>(&pool), points, middle,
                         projection, axes.up, false, pool);
        return chosen("a3", "1:1");
    };
    const SheetLayout first = place(Projection::first);
    EXPECT_GT(first.centres[1].x, first.centres[0].x); // The left view is at the right, the top view below.
    EXPECT_GT(first.centres[2].y, first.centres[0].y);
    EXPECT_EQ(first.centres[1].y, first.centres[0].y);
    const SheetLayout third = place(Projection::third);
    EXPECT_LT(third.centres[1].x, third.centres[0].x);
    EXPECT_LT(third.centres[2].y, third.centres[0].y);
}

TEST_F(ViewLayoutTest, TextsFitTheirRoom) {
    EXPECT_EQ(width_of_sheet_text("Isometric view", 3.5), 30.962290502793294);
    EXPECT_EQ(width_of_sheet_text("\xC3\xA4", 1.0), width_of_sheet_text("a", 1.0)); // Letters are counted, not bytes.
    SheetContent content(0.5, false, pool);
    const SheetPage page{String("a4", &pool), 297.0, 210.0};
    add_title_block(content, page,
                    {"A title that is rather long, too long for the block of a sheet, h\xC3\xA4h\xC3\xA4h\xC3\xA4 "
                     "h\xC3\xA4h\xC3\xA4h\xC3\xA4 and so on, and on, and on, and on",
                     "", "1:1", "A4, mm"},
                    Projection::first, pool);
    const SheetAnnotations made = annotations_of(content, pool);
    bool is_shortened = false;
    for (const hrbfnpr_annotation& one : made.list) {
        if (one.text == nullptr) continue;
        EXPECT_LT(width_of_sheet_text(one.text, one.width), 98.0) << one.text;
        is_shortened = is_shortened || std::string(one.text).ends_with("...");
    }
    EXPECT_TRUE(is_shortened);
    for (const auto& [longest, length] : {std::pair(0.3, 0.2), {1.99, 1.0}, {4.99, 2.0}, {73.0, 50.0}})
        EXPECT_EQ(length_of_bar(longest), length);
}

} // namespace
} // namespace picture_tests::view_layout_test
