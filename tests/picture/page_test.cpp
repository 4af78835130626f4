// SPDX-License-Identifier: MIT
#include "picture/page.h"

#include "planned_call.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace picture_tests::page_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class PageTest : public testing::Test {
protected:
    PageTest() {
        static_cast<void>(planned.call());
        desc.struct_size = sizeof desc;
        desc.paper_margin = 10.0;
        desc.page = &page;
    }
    // Returns a line and a text on a page of this many pixels.
    [[nodiscard]] PageContent content(glm::dvec2 size) {
        PageContent made(pool);
        made.size = size;
        PageNote line(pool);
        line.points = {{{0.0, 0.0}, size}, &pool};
        line.width = 1.0;
        made.notes.push_back(std::move(line));
        PageNote text(pool);
        text.points.emplace_back(size.x / 2.0, size.y / 2.0);
        text.text = "label";
        text.group = "texts";
        text.width = 10.0;
        made.notes.push_back(std::move(text));
        return made;
    }
    std::string written(const PageContent& of) {
        std::string bytes;
        const auto write = [](void* user, const void* data, std::uint64_t size) -> std::int32_t {
            static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
            return 0;
        };
        info = picture::defaults<hrbfnpr_page_info>(hrbfnpr_page_info_init);
        write_picture_page(*planned.context.get(), *planned.report, of, desc, "vase.ply", "{}", write, &bytes, &info,
                           nullptr);
        return bytes;
    }
    std::string refusal(const PageContent& of) {
        try {
            written(of);
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "";
    }
    const Vector<Note>& notes() const { return planned.report->notes; }

    PlannedCall planned;
    Pool& pool = planned.pool;
    hrbfnpr_page_desc page = picture::defaults<hrbfnpr_page_desc>(hrbfnpr_page_desc_init);
    hrbfnpr_picture_page_desc desc{};
    hrbfnpr_page_info info{};
};

TEST_F(PageTest, WithoutPaperAPixelIsACssPixel) {
    const std::string svg = written(content({960, 480}));
    EXPECT_NEAR(info.width, 254.0, 1e-9);
    EXPECT_NEAR(info.height, 127.0, 1e-9);
    EXPECT_NE(svg.find("vase.ply"), std::string::npos);
    EXPECT_NE(svg.find(std::string("Drawn by hrbfnpr ") + hrbfnpr_version_string()), std::string::npos);
    EXPECT_TRUE(notes().empty());
    page.title = "mine";
    EXPECT_EQ(written(content({960, 480})).find("vase.ply"), std::string::npos);
}

TEST_F(PageTest, PaperIsTurnedToFitBetter) {
    desc.paper = "A4";
    written(content({960, 480}));
    EXPECT_EQ(info.width, 297.0);
    EXPECT_EQ(info.height, 210.0);
    written(content({480, 960}));
    EXPECT_EQ(info.width, 210.0);
    desc.paper = " 300 x 2e2";
    written(content({480, 960}));
    EXPECT_EQ(info.width, 200.0);
    EXPECT_EQ(info.height, 300.0);
    desc.paper_margin = 100.0;
    EXPECT_EQ(refusal(content({480, 960})),
              "--page-margin 100 must be at least 0, and leave room on a page of 200 x 300 mm");
    desc.paper_margin = -1.0;
    EXPECT_EQ(refusal(content({960, 480})),
              "--page-margin -1 must be at least 0, and leave room on a page of 300 x 200 mm");
}

TEST_F(PageTest, UnknownPaperIsRefused) {
    desc.paper = "a9";
    EXPECT_EQ(refusal(content({1, 1})), "--page must be one of a0, a1, a2, a3, a4, a5, a6, letter, legal, tabloid, or "
                                        "WIDTHxHEIGHT in mm, such as 210x297, not 'a9'");
    for (const char* const wrong : {"", "x", "210", "210x", "0x297", "nanx1", "infx1", "1e7x1", "210x297mm", "-1x5"}) {
        desc.paper = wrong;
        EXPECT_NE(refusal(content({1, 1})).find("--page must be one of"), std::string::npos) << wrong;
    }
}

TEST_F(PageTest, PlotterFilesReportLengthAndTime) {
    page.format = HRBFNPR_PAGE_FORMAT_GCODE;
    written(content({960, 720}));
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0].code, std::uint32_t{HRBFNPR_NOTE_PLOTTED});
    EXPECT_EQ(notes()[0].text.find("the pen draws 0.3"), 0U) << notes()[0].text;
    EXPECT_NE(notes()[0].text.find(" m in about 1"), String::npos) << notes()[0].text;
}

TEST_F(PageTest, WidthsOfPensMustAscend) {
    const std::array<std::vector<double>, 4> wrong{{{0.5, 0.3}, {0.0, 0.3}, {-1.0}, {0.3, 2e3}}};
    for (const std::vector<double>& widths : wrong) {
        desc.pen_widths = {widths.data(), static_cast<std::int64_t>(widths.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
        EXPECT_NE(refusal(content({10, 10})).find("picture_page_desc.pen_widths["), std::string::npos);
    }
}

TEST_F(PageTest, MetadataMatchesPythonsJson) {
    auto camera = picture::defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    camera.view[4] = 1e-5; // row 0, column 1
    camera.view[13] = -0.1;
    camera.projection[10] = 1e16;
    camera.viewport[2] = 1600.0;
    camera.viewport[3] = 900.5;
    EXPECT_EQ(page_metadata("t\xc3\xb6pf \"1\".ply", "hatch", {}, 12, camera, pool),
              "{\"input\": \"t\\u00f6pf \\\"1\\\".ply\", \"style\": \"hatch\", \"marks\": 12, \"camera\": {\"view\": "
              "[[1.0, 1e-05, 0.0, 0.0], [0.0, 1.0, 0.0, -0.1], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]], "
              "\"projection\": [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1e+16, 0.0], [0.0, 0.0, 0.0, "
              "1.0]], \"viewport\": [0.0, 0.0, 1600.0, 900.5]}}");
}

} // namespace
} // namespace picture_tests::page_test
