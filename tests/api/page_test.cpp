// SPDX-License-Identifier: MIT
// Tests pages through the C boundary: the written bytes, and an error that names every bad argument.
#include "drawing_fixture.h"

#include <functional>
#include <limits>

namespace api_test::page_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;

std::int32_t append(void* user, const void* data, std::uint64_t size) {
    static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
    return 0;
}

std::int32_t fail_to_write(void* /*user*/, const void* /*data*/, std::uint64_t /*size*/) { return 5; }

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

class PageTest : public DrawingTest {
protected:
    PageTest() {
        layers[0].shape = HRBFNPR_SHAPE_STROKES;
        drawing = drawn();
        item.drawing = drawing.get();
        desc.items = &item;
        desc.item_count = 1;
    }

    std::string written() {
        std::string text;
        EXPECT_OK(hrbfnpr_page_write(context.get(), &desc, append, &text, &info, nullptr, error));
        EXPECT_EQ(info.bytes, static_cast<std::int64_t>(text.size()));
        return text;
    }

    void refused(const char* part) {
        std::string text;
        EXPECT_FAILS(hrbfnpr_page_write(context.get(), &desc, append, &text, nullptr, nullptr, error), invalid, part);
        EXPECT_TRUE(text.empty());
    }

    Drawing drawing;
    hrbfnpr_page_item item = made(hrbfnpr_page_item_init);
    hrbfnpr_page_desc desc = made(hrbfnpr_page_desc_init);
    hrbfnpr_page_info info = made(hrbfnpr_page_info_init);
};

TEST_F(PageTest, HasAllDotsAndPathsOfTheDrawing) {
    auto counts = made(hrbfnpr_drawing_info_init);
    EXPECT_OK(hrbfnpr_drawing_get_info(drawing.get(), &counts, error));
    ASSERT_GT(counts.dots, 100);
    ASSERT_GT(counts.strokes, 1);
    const std::string svg = written();
    EXPECT_EQ(info.dots, counts.dots);
    EXPECT_GE(info.paths, counts.strokes);
    EXPECT_EQ(count_of(svg, "<circle"), static_cast<std::size_t>(info.dots));
    EXPECT_EQ(count_of(svg, "<path"), static_cast<std::size_t>(info.paths));
    EXPECT_EQ(count_of(svg, "inkscape:groupmode"), static_cast<std::size_t>(info.groups) + 1); // plus the paper
    EXPECT_NEAR(info.width, side * 25.4 / 96.0, 1e-9);
    EXPECT_NE(svg.find("arcs"), std::string::npos);
    EXPECT_NE(svg.find(hrbfnpr_version_string()), std::string::npos);
    EXPECT_EQ(svg, written());
    desc.flags = HRBFNPR_PAGE_WITHOUT_PAPER;
    EXPECT_EQ(count_of(written(), "<rect"), 1U); // the frame of the page
    desc.format = HRBFNPR_PAGE_FORMAT_PDF;
    EXPECT_EQ(written().substr(0, 5), "%PDF-");
}

TEST_F(PageTest, WritesAnnotationsPensAndPlaces) {
    const std::vector<double> line{10, 10, 60, 10};
    hrbfnpr_annotation notes[2] = {made(hrbfnpr_annotation_init), made(hrbfnpr_annotation_init)};
    notes[0].points = notes[1].points = in(line, 2);
    notes[1].text = "Fig. 1";
    desc.annotations = notes;
    desc.annotation_count = 2;
    auto pen = made(hrbfnpr_pen_init);
    pen.groups = "annot*";
    pen.width = 0.7;
    pen.ink[0] = pen.ink[3] = 1.0F;
    desc.pens = &pen;
    desc.pen_count = 1;
    desc.width = 100.0;
    desc.height = 80.0;
    desc.title = "Two & one";
    item.name = "front";
    item.x = 5.0;
    item.scale = 0.5;
    const std::string svg = written();
    EXPECT_DOUBLE_EQ(info.width, 100.0);
    EXPECT_NE(svg.find("height=\"80mm\""), std::string::npos);
    EXPECT_NE(svg.find("<title>Two &amp; one</title>"), std::string::npos);
    EXPECT_NE(svg.find("inkscape:label=\"front\""), std::string::npos);
    EXPECT_NE(svg.find("inkscape:label=\"annotations\" fill=\"#ff0000\""), std::string::npos);
    EXPECT_NE(svg.find("stroke-width=\".7\" stroke-linecap=\"butt\" d=\"M10 10l50 0"), std::string::npos);
    EXPECT_NE(svg.find(">Fig. 1</text>"), std::string::npos);
    desc.item_count = 0;
    const std::string alone = written();
    EXPECT_EQ(count_of(alone, "<path"), 1U);
    EXPECT_EQ(count_of(alone, "fill=\"#ffffff\""), 1U); // the white paper
}

TEST_F(PageTest, RefusesInvalidDescriptors) {
    const auto with = [&](auto member, auto value, const char* part) {
        const hrbfnpr_page_desc before = desc;
        desc.*member = value;
        refused(part);
        desc = before;
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    with(&hrbfnpr_page_desc::title, "\xFF", "page_desc.title is not UTF-8");
    with(&hrbfnpr_page_desc::item_count, std::int64_t{0}, "page_desc has no items and no annotations");
    with(&hrbfnpr_page_desc::item_count, std::int64_t{-1}, "page_desc.item_count");
    with(&hrbfnpr_page_desc::curves, 3U, "page_desc.curves");
    with(&hrbfnpr_page_desc::longest, 0.5, "page_desc.longest is 0.5; it must be 0 for no limit, or 1 to 1e+06");
    with(&hrbfnpr_page_desc::longest, nan, "page_desc.longest");
    const auto put = [&](auto member, auto value, const char* part) {
        const hrbfnpr_page_item before = item;
        item.*member = value;
        refused(part);
        item = before;
    };
    put(&hrbfnpr_page_item::drawing, static_cast<const hrbfnpr_drawing*>(nullptr),
        "page_desc.items[0].drawing is NULL");
    put(&hrbfnpr_page_item::scale, 0.0, "page_desc.items[0].scale");
    put(&hrbfnpr_page_item::x, nan, "page_desc.items[0].x");
    put(&hrbfnpr_page_item::x, -1000.0, "set page_desc.width and height");
    put(&hrbfnpr_page_item::name, "\xC0", "page_desc.items[0].name is not UTF-8; encode it as UTF-8");
    auto pen = made(hrbfnpr_pen_init);
    desc.pens = &pen;
    desc.pen_count = 1;
    pen.number = 0;
    refused("page_desc.pens[0].number");
    pen.number = 1;
    pen.line_type = 16;
    refused("page_desc.pens[0].line_type");
    desc.pen_count = 0;
    auto note = made(hrbfnpr_annotation_init);
    desc.annotations = &note;
    desc.annotation_count = 1;
    refused("page_desc.annotations[0].points has 0 elements; it must have at least 2");
    note.text = "T";
    refused("page_desc.annotations[0].points has 0 elements; it must have at least 1");
    const std::vector<double> bad{1.0, nan};
    note.points = in(bad, 2);
    refused("page_desc.annotations[0].points");
    note.group = "";
    refused("page_desc.annotations[0].group has 0 bytes");
}

TEST_F(PageTest, StopsAtAWriteErrorOrACancel) {
    EXPECT_FAILS(hrbfnpr_page_write(context.get(), &desc, fail_to_write, nullptr, nullptr, nullptr, error),
                 HRBFNPR_STATUS_IO, "write returned 5");
    EXPECT_FAILS(hrbfnpr_page_write(context.get(), &desc, nullptr, nullptr, nullptr, nullptr, error), invalid,
                 "write is NULL");
    EXPECT_FAILS(hrbfnpr_page_write(context.get(), nullptr, append, nullptr, nullptr, nullptr, error), invalid,
                 "desc is NULL");
    const Operation operation = make_operation(context);
    hrbfnpr_operation_cancel(operation.get());
    std::string text;
    EXPECT_EQ(hrbfnpr_page_write(context.get(), &desc, append, &text, nullptr, operation.get(), error),
              HRBFNPR_STATUS_CANCELLED);
}

TEST_F(PageTest, WritesPaperDiscsInDrawingOrder) {
    layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_DOTS;
    style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
    drawing = drawn();
    item.drawing = drawing.get();
    const Vertices points = vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS);
    const std::string svg = written();
    EXPECT_EQ(info.groups, 1);
    EXPECT_EQ(count_of(svg, "<circle"), points.vertex.size());
    std::size_t paper = 0;
    for (const Vertex& v : points.vertex) paper += v.is_paper;
    ASSERT_GT(paper, 10U);
    EXPECT_EQ(count_of(svg, "fill=\"#ffffff\"/>") + count_of(svg, "fill=\"#ffffff\" fill-opacity"), paper + 1);
    desc.flags = HRBFNPR_PAGE_IN_PLOT_ORDER;
    refused("PUBLISHED");
    desc.flags = 0;
    desc.format = HRBFNPR_PAGE_FORMAT_HPGL;
    refused("PUBLISHED");
    desc.format = HRBFNPR_PAGE_FORMAT_DXF;
    refused("which DXF does not have");
}

} // namespace
} // namespace api_test::page_test
