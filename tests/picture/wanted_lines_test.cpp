// SPDX-License-Identifier: MIT
#include "picture/wanted_lines.h"

#include "planned_call.h"

#include <gtest/gtest.h>

namespace picture_tests::wanted_lines_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class WantedLinesTest : public testing::Test {
protected:
    // Returns the message of the error, or "" if the text is understood.
    std::string refusal(const char* text) {
        try {
            static_cast<void>(parse_lines(text, pool));
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "";
    }

    base::Memory memory;
    Pool pool{memory};
};

TEST_F(WantedLinesTest, ReadsKindsAndTheirSettings) {
    const auto lines =
        parse_lines("contour,suggestive,ridge,section=x:7,isophotes=0.3:-.6,isophote,apparent-ridge", pool);
    ASSERT_EQ(lines.size(), 7U);
    EXPECT_EQ(lines[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_CONTOUR});
    EXPECT_EQ(lines[1].kind, std::uint32_t{HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR});
    EXPECT_EQ(lines[2].kind, std::uint32_t{HRBFNPR_LINE_KIND_RIDGE});
    EXPECT_EQ(lines[3].axis, 0);
    EXPECT_EQ(lines[3].planes, 7);
    EXPECT_EQ(lines[4].levels, (Vector<double>{{0.3, -0.6}, &pool}));
    EXPECT_EQ(lines[5].levels, (Vector<double>{{0.25, 0.5, 0.75}, &pool}));
    EXPECT_EQ(lines[6].kind, std::uint32_t{HRBFNPR_LINE_KIND_APPARENT_RIDGE});
    EXPECT_TRUE(parse_lines("none", pool).empty());
    EXPECT_TRUE(parse_lines("", pool).empty());
    EXPECT_EQ(parse_lines("sections=", pool)[0].planes, 10);
}

TEST_F(WantedLinesTest, NamesValidChoices) {
    EXPECT_EQ(refusal("contour,hatch"),
              "there are no lines 'hatch'; there are contour, suggestive, ridges, valleys, "
              "apparent, parabolic, isophotes, section, border, crease, intersection, shadow, terminator, "
              "soft, tangent and none");
    for (const char* const wrong : {"own", "contour,", ",contour", "Contour", "none,contour", "=", "con\xff"})
        EXPECT_NE(refusal(wrong).find("there are no lines"), std::string::npos) << wrong;
    EXPECT_EQ(refusal("section=w:3"), "'section=w:3' is not understood: write section=z:20 or isophotes=0.3:0.6");
    for (const char* const wrong : {"section=z", "section=z:0", "section=z:-4", "section=z:2.5", "section=z:1e3",
                                    "section=z:99999999999999999999", "section=z:4:4", "isophotes=a",
                                    "isophotes=0.3:", "isophotes=:", "contour=3", "border=x:4"})
        EXPECT_NE(refusal(wrong).find("is not understood"), std::string::npos) << wrong;
    EXPECT_EQ(refusal(std::string(5000, 'x').c_str()).substr(0, 23), "there are no lines 'xxx");
}

TEST_F(WantedLinesTest, FindsTheLinesThatAStyleNeedsOnce) {
    PlannedCall find(HRBFNPR_PRESET_ARCHAEOLOGICAL);
    const Call call = find.call();
    const Style style(HRBFNPR_PRESET_ARCHAEOLOGICAL, pool);
    const auto lines = wanted_lines(call, style, true);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_RIDGE});
    const Style blueprint(HRBFNPR_PRESET_BLUEPRINT, pool);
    EXPECT_TRUE(wanted_lines(call, blueprint, false).empty());
    const auto creases = wanted_lines(call, blueprint, true);
    ASSERT_EQ(creases.size(), 1U);
    EXPECT_EQ(creases[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_CREASE});
    const auto soft = wanted_lines(call, Style(HRBFNPR_PRESET_ENGRAVING, pool), true);
    ASSERT_EQ(soft.size(), 1U);
    EXPECT_EQ(soft[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_SOFT_EDGE});
    find.desc.lines = "soft-edges";
    const Call edges = find.call();
    EXPECT_EQ(wanted_lines(edges, style, true)[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_SOFT_EDGE});
    find.desc.lines = "valleys";
    const Call asked = find.call();
    EXPECT_EQ(wanted_lines(asked, style, true)[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_VALLEY});
    find.desc.lines = "shadow,terminators";
    const Call shadows = find.call();
    EXPECT_EQ(wanted_lines(shadows, style, true)[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_SHADOW});
    EXPECT_EQ(wanted_lines(shadows, style, true)[1].kind, std::uint32_t{HRBFNPR_LINE_KIND_TERMINATOR});
    find.desc.lines = "none";
    const Call nothing = find.call();
    EXPECT_TRUE(wanted_lines(nothing, style, true).empty());
}

TEST_F(WantedLinesTest, LinesAreSizedByThePen) {
    PlannedCall plain(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE);
    const Call call = plain.call();
    Style style(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, pool);
    size_lines(call, style, 2.0, true);
    ASSERT_EQ(style.lines.size(), 5U); // the contour, the crease, the soft edge, the intersection and the border
    EXPECT_EQ(style.lines[2].kind, std::uint32_t{HRBFNPR_LINE_KIND_SOFT_EDGE});
    EXPECT_FLOAT_EQ(style.lines[2].width, 2.2F);
    EXPECT_FLOAT_EQ(style.lines[0].width, 4.4F);
    EXPECT_FLOAT_EQ(style.lines[0].taper, 24.0F);
    EXPECT_EQ(style.lines[3].kind, std::uint32_t{HRBFNPR_LINE_KIND_INTERSECTION});
    EXPECT_FLOAT_EQ(style.lines[3].width, 2.8F);
    EXPECT_EQ(style.lines[4].kind, std::uint32_t{HRBFNPR_LINE_KIND_BORDER});
    EXPECT_FLOAT_EQ(style.lines[4].width, 4.4F);
    EXPECT_EQ(style.lines[4].taper, 0.0F);
    plain.desc.line_width = 3.0;
    const Call wider = plain.call();
    Style wide(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, pool);
    size_lines(wider, wide, 2.0, false);
    ASSERT_EQ(wide.lines.size(), 4U);
    EXPECT_FLOAT_EQ(wide.lines[0].width, 3.0F);
    EXPECT_FLOAT_EQ(wide.lines[1].width, 1.9090908765792847F);
}

TEST_F(WantedLinesTest, HiddenPartsOfShadowsAreDrawnOnlyIfAsked) {
    PlannedCall asked(HRBFNPR_PRESET_SILHOUETTE);
    asked.desc.lines = "contour,shadow,terminator,section";
    const Call call = asked.call();
    Style style(HRBFNPR_PRESET_SILHOUETTE, pool);
    size_lines(call, style, 1.0, true);
    ASSERT_EQ(style.lines.size(), 4U);
    EXPECT_EQ(style.lines[0].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_ATTENUATED});
    EXPECT_EQ(style.lines[1].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_NONE});
    EXPECT_EQ(style.lines[2].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_NONE});
    EXPECT_EQ(style.lines[3].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_ATTENUATED});
}

TEST_F(WantedLinesTest, RequestedLinesReplaceTheLinesOfTheStyle) {
    PlannedCall asked(HRBFNPR_PRESET_XRAY);
    asked.desc.lines = "crease,isophotes=0.2,section,intersections";
    const Call call = asked.call();
    Style style(HRBFNPR_PRESET_XRAY, pool);
    const hrbfnpr_line_style contour = style.lines[0];
    size_lines(call, style, 1.0, true);
    ASSERT_EQ(style.lines.size(), 5U);
    EXPECT_EQ(style.lines[4].kind, std::uint32_t{HRBFNPR_LINE_KIND_INTERSECTION});
    EXPECT_EQ(style.lines[4].width, contour.width);
    EXPECT_EQ(style.lines[4].taper, 0.0F);
    style.lines.pop_back();
    EXPECT_EQ(style.lines[0].kind, std::uint32_t{HRBFNPR_LINE_KIND_CREASE});
    EXPECT_EQ(style.lines[0].width, contour.width);
    EXPECT_EQ(style.lines[0].hidden, contour.hidden);
    EXPECT_EQ(style.lines[1].kind, std::uint32_t{HRBFNPR_LINE_KIND_OWN});
    EXPECT_STREQ(style.lines[1].name, "crease");
    EXPECT_FLOAT_EQ(style.lines[2].width, 0.6F * contour.width);
    EXPECT_EQ(style.lines[2].taper, contour.taper);
    EXPECT_EQ(static_cast<const double*>(style.lines[2].levels.data)[0], 0.2);
    EXPECT_EQ(style.lines[3].taper, 0.0F);
    EXPECT_TRUE(needs_curvature(style));
    style.lines.pop_back();
    style.lines.pop_back();
    EXPECT_FALSE(needs_curvature(style));
}

// The contours of a sketch are drawn twice. So is the border, in the same pencils.
TEST_F(WantedLinesTest, BordersAreDrawnAsContoursAre) {
    PlannedCall plain(HRBFNPR_PRESET_SKETCH);
    const Call call = plain.call();
    Style style(HRBFNPR_PRESET_SKETCH, pool);
    const Vector<hrbfnpr_line_style> contours(style.lines.begin(), style.lines.begin() + 2, &pool);
    size_lines(call, style, 1.0, true);
    ASSERT_EQ(style.lines.size(), 7U);
    for (std::size_t i = 0; i < 2; ++i) {
        const hrbfnpr_line_style& border = style.lines[5 + i];
        EXPECT_EQ(border.kind, std::uint32_t{HRBFNPR_LINE_KIND_BORDER});
        EXPECT_EQ(border.width, contours[i].width);
        EXPECT_EQ(border.ink[0], contours[i].ink[0]);
        EXPECT_EQ(border.wobble, contours[i].wobble);
        EXPECT_EQ(border.far_factor, contours[i].far_factor);
    }
}

TEST_F(WantedLinesTest, RequestedLinesHaveTheInkOfTheContour) {
    PlannedCall asked(HRBFNPR_PRESET_BLUEPRINT);
    asked.desc.lines = "contour,ridges,border";
    const Call call = asked.call();
    Style style(HRBFNPR_PRESET_BLUEPRINT, pool);
    size_lines(call, style, 1.0, true);
    ASSERT_EQ(style.lines.size(), 3U);
    EXPECT_GT(style.lines[0].ink[0], 0.9F);
    EXPECT_EQ(style.lines[1].ink[0], style.lines[0].ink[0]);
    EXPECT_EQ(style.lines[1].outline_factor, 1.0F);
    EXPECT_EQ(style.lines[2].ink[0], style.lines[0].ink[0]);
    EXPECT_EQ(style.lines[2].outline_factor, style.lines[0].outline_factor);
}

} // namespace
} // namespace picture_tests::wanted_lines_test
