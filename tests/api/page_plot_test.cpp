// SPDX-License-Identifier: MIT
// Tests pages for plotters, through the boundary.
#include "drawing_fixture.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace api_test::page_plot_test {
namespace {

struct Page : hrbfnpr_page_desc {
    Page() : hrbfnpr_page_desc(made(hrbfnpr_page_desc_init)) { format = HRBFNPR_PAGE_FORMAT_HPGL; }

    std::string write(const Context& context) {
        items = item.data();
        item_count = static_cast<std::int64_t>(item.size());
        annotations = annotation.data();
        annotation_count = static_cast<std::int64_t>(annotation.size());
        pens = pen.data();
        pen_count = static_cast<std::int64_t>(pen.size());
        std::string bytes;
        Error error;
        EXPECT_OK(hrbfnpr_page_write(context.get(), this, append, &bytes, &info, nullptr, error));
        EXPECT_EQ(info.bytes, static_cast<std::int64_t>(bytes.size()));
        return bytes;
    }
    void add(const Drawing& drawing, double x, double y, double scale) {
        item.push_back(made(hrbfnpr_page_item_init));
        item.back().drawing = drawing.get();
        item.back().x = x;
        item.back().y = y;
        item.back().scale = scale;
    }
    hrbfnpr_annotation& add(const std::vector<double>& points) {
        annotation.push_back(made(hrbfnpr_annotation_init));
        annotation.back().points = in(points, 2);
        return annotation.back();
    }
    static std::int32_t append(void* user, const void* data, std::uint64_t size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
        return 0;
    }

    std::vector<hrbfnpr_page_item> item;
    std::vector<hrbfnpr_annotation> annotation;
    std::vector<hrbfnpr_pen> pen;
    hrbfnpr_page_info info = made(hrbfnpr_page_info_init);
};

// Returns all numbers after PU and PD.
std::vector<double> coordinates(const std::string& hpgl) {
    std::vector<double> numbers;
    std::istringstream lines(hpgl);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("PU", 0) != 0 && line.rfind("PD", 0) != 0) continue;
        line = line.substr(2, line.find(';') - 2);
        for (char& c : line)
            if (c == ',') c = ' ';
        std::istringstream words(line);
        for (double number = 0.0; words >> number;) numbers.push_back(number);
    }
    return numbers;
}

TEST_F(DrawingTest, IsPlottedWithinItsFrame) {
    const Drawing drawing = drawn();
    Page page;
    page.width = 60.0;
    page.height = 50.0;
    page.add(drawing, 10.0, 5.0, 30.0 / side);
    page.tolerance = 0.01;
    const std::string bytes = page.write(context);
    EXPECT_EQ(bytes.substr(0, 9), "IN;\nSP1;\n");
    EXPECT_EQ(bytes.substr(bytes.size() - 8), "PU;SP0;\n");
    const std::vector<double> numbers = coordinates(bytes);
    ASSERT_GT(numbers.size(), 1000U);
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        EXPECT_TRUE(numbers[i] >= 400.0 && numbers[i] <= 1600.0) << numbers[i];
        EXPECT_TRUE(numbers[i + 1] >= 600.0 && numbers[i + 1] <= 1800.0) << numbers[i + 1];
    }
    EXPECT_GT(page.info.drawn, 10.0);
    EXPECT_GT(page.info.travelled, 10.0);
    EXPECT_GT(page.info.seconds, page.info.drawn / 30.0 + page.info.travelled / 80.0);
    EXPECT_EQ(page.write(context), bytes);
}

// The number of closed subpaths in an SVG page.
std::int64_t rings_of(const std::string& svg) {
    std::int64_t count = 0;
    for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 4)) {
        const std::size_t end = svg.find('"', at + 4);
        count +=
            std::count_if(svg.begin() + static_cast<std::ptrdiff_t>(at + 4),
                          svg.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c == 'Z' || c == 'z'; });
    }
    return count;
}

TEST_F(DrawingTest, HasTheSameStrokesInPlotOrder) {
    const Drawing drawing = drawn();
    Page page;
    page.format = HRBFNPR_PAGE_FORMAT_SVG;
    page.add(drawing, 0.0, 0.0, 100.0 / side);
    const std::int64_t rings_before = rings_of(page.write(context));
    const hrbfnpr_page_info before = page.info;
    EXPECT_EQ(before.drawn, 0.0);
    EXPECT_EQ(before.travelled, 0.0);
    EXPECT_EQ(before.seconds, 0.0);
    page.flags = HRBFNPR_PAGE_IN_PLOT_ORDER;
    page.join = page.shortest = page.dot_distance = 1e-9;
    // A join makes one path of two, or closes a path.
    const std::int64_t closed = rings_of(page.write(context)) - rings_before;
    EXPECT_GE(closed, 0);
    EXPECT_EQ(page.info.paths + page.info.joined - closed, before.paths);
    EXPECT_EQ(page.info.dots, before.dots);
    EXPECT_LT(page.info.groups, before.groups); // each group once, though inks of other colours lie on top
    EXPECT_GT(page.info.travelled, 0.0);
    // With half the travel speed, only the travel takes longer.
    const double seconds = page.info.seconds;
    page.travel_speed = 40.0;
    page.write(context);
    EXPECT_NEAR(page.info.seconds - seconds, page.info.travelled / 80.0, 1e-6);
}

TEST_F(DrawingTest, IsPlottedWithOnePenPerGroup) {
    const Drawing drawing = drawn();
    Page page;
    page.add(drawing, 0.0, 0.0, 100.0 / side);
    page.pen.push_back(made(hrbfnpr_pen_init));
    page.pen.back().groups = "arcs*";
    page.pen.back().number = 3;
    page.pen.back().width = 1.0;
    const std::string bytes = page.write(context);
    EXPECT_NE(bytes.find("SP1;"), std::string::npos);
    EXPECT_NE(bytes.find("SP3;"), std::string::npos);
    const std::int64_t narrow = page.info.dropped_dots;
    page.pen.back().groups = nullptr;
    page.pen.back().width = 10.0;
    page.write(context);
    EXPECT_GT(page.info.dropped_dots, narrow); // dots that are nearer to each other than half a pen are dropped
}

TEST(PagePlot, WritesAnnotationsWithoutADrawing) {
    const Context context = make_context();
    const std::vector<double> line{10.0, 90.0, 20.0, 90.0}, next{20.0, 90.0, 30.0, 90.0}, far{-50.0, 50.0, 150.0, 50.0};
    const std::vector<double> text{5.0, 5.0};
    Page page;
    page.width = page.height = 100.0;
    page.add(line);
    page.add(next);
    page.add(far);
    hrbfnpr_annotation& label = page.add(text);
    label.text = "Fig. 1";
    label.width = 4.0;
    EXPECT_EQ(page.write(context), "IN;\nSP1;\nPU200,3800;\nSI0.28,0.4;LBFig. 1\x03\nPU400,400;\nPD1200,400;\n"
                                   "PU0,2000;\nPD4000,2000;\nPU;\nPU;SP0;\n");
    EXPECT_EQ(page.info.joined, 1);
    EXPECT_EQ(page.info.paths, 2);
    EXPECT_EQ(page.info.segments, 2);
    EXPECT_DOUBLE_EQ(page.info.drawn, 120.0);

    page.format = HRBFNPR_PAGE_FORMAT_GCODE;
    page.pen_down = "M3 S40\nG4 P0.1";
    page.pen_up = "M5";
    page.title = "Fig. 1";
    page.draw_speed = 20.0;
    const std::string bytes = page.write(context);
    EXPECT_EQ(bytes.find("(Fig. 1)\n"), 0U);
    EXPECT_NE(bytes.find("G21\nG90\nG1 F1200\nM5\n"), std::string::npos);
    EXPECT_NE(bytes.find("G0 X10 Y10\nM3 S40\nG4 P0.1\nG1 X30 Y10 F1200\nM5\n"), std::string::npos);
    EXPECT_EQ(bytes.substr(bytes.size() - 6), "M5\nM2\n");
}

TEST(PagePlot, FillsWideLinesUnlessDisabled) {
    const Context context = make_context();
    const std::vector<double> line{10.0, 50.0, 60.0, 50.0}, thin{10.0, 70.0, 60.0, 70.0};
    Page page;
    page.width = page.height = 100.0;
    page.add(line).width = 1.2;
    page.add(thin).width = 0.3;
    for (const std::uint32_t format : {HRBFNPR_PAGE_FORMAT_HPGL, HRBFNPR_PAGE_FORMAT_GCODE}) {
        page.format = format;
        page.flags = 0;
        page.write(context);
        EXPECT_EQ(page.info.filled_paths, 1);
        EXPECT_EQ(page.info.paths, 2);
        EXPECT_NEAR(page.info.drawn, 50.0 + 5.0 * 49.7 + 4.0 * 0.225, 0.2); // 0.9 mm between the outer passes
        const double seconds = page.info.seconds;
        page.flags = HRBFNPR_PAGE_SINGLE_PASS;
        page.write(context);
        EXPECT_EQ(page.info.filled_paths, 0);
        EXPECT_NEAR(page.info.drawn, 100.0, 1e-9);
        EXPECT_LT(page.info.seconds, seconds - 4.0 * 49.0 / 30.0);
    }
    // SVG and PDF fill with passes only if a pen has a width and the page is in plot order.
    page.pen.push_back(made(hrbfnpr_pen_init));
    for (const std::uint32_t format : {HRBFNPR_PAGE_FORMAT_SVG, HRBFNPR_PAGE_FORMAT_PDF}) {
        page.format = format;
        for (const std::uint32_t flags : {0U, std::uint32_t{HRBFNPR_PAGE_IN_PLOT_ORDER}})
            for (const double width : {0.0, 0.3}) {
                page.flags = flags;
                page.pen.back().width = width;
                page.write(context);
                EXPECT_EQ(page.info.filled_paths, flags != 0 && width > 0.0 ? 1 : 0);
            }
    }
}

// Lines that cannot be joined, in `groups` groups.
Page many_lines(const std::vector<double>& points, int lines, int groups) {
    static const char* const names[] = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};
    Page page;
    page.width = page.height = 200.0;
    const int each = static_cast<int>(points.size()) / 2 / lines;
    for (int i = 0; i < lines; ++i) {
        page.annotation.push_back(made(hrbfnpr_annotation_init));
        page.annotation.back().points = {points.data() + 2 * each * i, each, 0, HRBFNPR_SCALAR_FLOAT64, 2};
        page.annotation.back().group = names[i * groups / lines];
    }
    return page;
}

std::vector<double> wavy(int lines) {
    constexpr int each = 8;
    std::vector<double> points;
    for (int i = 0; i < lines; ++i)
        for (int k = 0; k < each; ++k) {
            points.push_back(1.0 + 198.0 * std::fmod(0.754877666 * i, 1.0) + 0.1 * k);
            points.push_back(1.0 + 198.0 * std::fmod(0.569840291 * i, 1.0) + 0.1 * std::sin(k));
        }
    return points;
}

std::int64_t peak_of(const std::vector<double>& points, int lines, int groups) {
    const Context context = make_context();
    const std::int64_t before = info_of(context).bytes_peak;
    Page page = many_lines(points, lines, groups);
    page.write(context);
    EXPECT_EQ(page.info.groups, groups);
    return info_of(context).bytes_peak - before;
}

TEST(PagePlot, NeedsMemoryForItsLargestGroupOnly) {
    const std::vector<double> points = wavy(20000);
    const std::int64_t one = peak_of(points, 20000, 1);
    EXPECT_LT(one, 20000 * 1800); // bytes of a line of 8 points
    EXPECT_LT(peak_of(points, 20000, 10), one / 2);
    const std::vector<double> half(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2));
    EXPECT_GT(peak_of(half, 10000, 1), one / 3); // grows no faster than linearly
}

} // namespace
} // namespace api_test::page_plot_test
