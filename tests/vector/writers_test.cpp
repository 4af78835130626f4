// SPDX-License-Identifier: MIT
// Tests the files of writers: numbers, characters, structure.
#include "output/vector/page.h"

#include "output/vector/text_out.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace hrbfnpr::testing::writers_test {
namespace {

using output::PageCounts;
using output::PageInfo;
using output::PagePath;
using output::PagePoint;
using output::TextOut;

class Text final : public io::Writer {
public:
    void write(const void* data, std::uint64_t size) override { all.append(static_cast<const char*>(data), size); }
    std::string all;
};

std::string written(double number) {
    Text text;
    TextOut out(text);
    out << number;
    out.flush();
    return text.all;
}

TEST(TextOut, WritesNumbersShortAndTheSameInEveryLocale) {
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    EXPECT_EQ(written(0.0), "0");
    EXPECT_EQ(written(-0.0001), "0");
    EXPECT_EQ(written(0.05), ".05");
    EXPECT_EQ(written(-12.3456), "-12.346");
    EXPECT_EQ(written(100.0), "100");
    EXPECT_EQ(written(-0.5), "-.5");
    EXPECT_EQ(written(1e300), "1000000000000");
    std::setlocale(LC_ALL, "C");
}

TEST(TextOut, EscapesAndBuffersText) {
    Text text;
    TextOut out(text);
    out.escaped("a<b>&\"'\x01");
    for (int i = 0; i < 5000; ++i) out << "0123456789";
    out.flush();
    EXPECT_EQ(text.all.substr(0, 28), "a&lt;b&gt;&amp;&quot;&#39; 0");
    EXPECT_EQ(text.all.size(), 27U + 50000U);
    EXPECT_EQ(out.bytes(), static_cast<std::int64_t>(text.all.size()));
}

std::string page_by(output::PageFormat format, PageCounts& counts, const output::ShapeSettings& shapes = {}) {
    base::Memory memory;
    Text text;
    PageInfo info;
    info.width = 100.0;
    info.height = 50.0;
    info.title = "A & B \xC3\xA9";
    info.program = "1.2.3";
    output::PageSettings settings;
    settings.format = format;
    settings.shapes = shapes;
    const std::unique_ptr<output::PageSink> writer = output::make_writer(memory, text, info, settings, counts);
    writer->begin_view({"front <1>", {0, 0, 100, 50}, {1.0F, 1.0F, 1.0F, 1.0F}, true});
    output::PageGroup group;
    std::snprintf(group.name, sizeof group.name, "contour hidden 1");
    group.ink = {1.0F, 0.0F, 0.0F, 0.5F};
    writer->begin_group(group);
    const std::vector<PagePoint> even{{1, 2, 0.25}, {30, 2, 0.25}, {40, 12, 0.25}};
    const std::vector<PagePoint> swelling{{1, 20, 0.1}, {30, 20, 0.5}, {60, 20, 0.0}};
    PagePath path;
    path.points = even;
    writer->path(path);
    path.points = swelling;
    path.opacity = 0.5;
    writer->path(path);
    writer->dot({50, 40, 0.7, 1.0, false});
    writer->text({3, 45, 3.5, "(M\xC3\xBCller) <\xE5\x85\x8E>"});
    writer->end_group();
    writer->end_view();
    writer->finish();
    EXPECT_EQ(counts.bytes, static_cast<std::int64_t>(text.all.size()));
    return text.all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Svg, HasLayersSizesAndTexts) {
    PageCounts counts;
    const std::string svg = page_by(output::PageFormat::svg, counts);
    EXPECT_TRUE(has(svg, R"(width="100mm" height="50mm" viewBox="0 0 100 50")"));
    EXPECT_TRUE(has(svg, "<title>A &amp; B \xC3\xA9</title>"));
    EXPECT_TRUE(has(svg, "hrbfnpr 1.2.3</metadata>"));
    EXPECT_TRUE(has(svg, R"(inkscape:groupmode="layer" inkscape:label="contour hidden 1" fill="#ff0000")"));
    EXPECT_TRUE(has(svg, R"(inkscape:label="front &lt;1&gt;")"));
    EXPECT_TRUE(has(svg, R"(<path fill="none" stroke-width=".5" stroke-opacity=".5" d="M1 2)"));
    EXPECT_TRUE(has(svg, R"(<path fill-opacity=".25" d="M)"));
    EXPECT_TRUE(has(svg, R"(<circle cx="50" cy="40" r=".7")"));
    EXPECT_TRUE(has(svg, ">(M\xC3\xBCller) &lt;\xE5\x85\x8E&gt;</text>"));
    EXPECT_EQ(counts.paths, 2);
    EXPECT_EQ(counts.dots, 1);
    EXPECT_EQ(counts.groups, 1);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(Svg, CanUseWidthClassesAndLineDots) {
    PageCounts counts;
    output::ShapeSettings settings;
    settings.widths = output::Widths::classes;
    settings.width_step = 2.0;
    settings.dots = output::DotShapes::lines;
    const std::string svg = page_by(output::PageFormat::svg, counts, settings);
    EXPECT_FALSE(has(svg, "<path fill-opacity"));
    for (const char* width : {".2", ".4", ".8"})
        EXPECT_TRUE(has(svg, std::string("stroke-width=\"") + width + '"')) << width;
    EXPECT_FALSE(has(svg, "<circle"));
    EXPECT_TRUE(has(svg, R"(stroke-width="1.4" stroke-opacity=".5" d="M50 40l0 0")"));
}

// The shapes of one page in SVG: a half circle of one width, one that swells, and a circle.
std::string svg_of_arcs(output::Curves curves, output::PageFormat format = output::PageFormat::svg) {
    base::Memory memory;
    Text text;
    PageInfo info;
    info.width = info.height = 100.0;
    output::PageSettings settings;
    settings.format = format;
    settings.shapes.curves = curves;
    PageCounts counts;
    const std::unique_ptr<output::PageSink> writer = output::make_writer(memory, text, info, settings, counts);
    writer->begin_group({});
    for (const double swelling : {0.0, 0.005})
        for (const double turn : {0.5, 1.0}) {
            std::vector<PagePoint> points;
            for (int i = 0; i <= 100; ++i) {
                const double angle = 0.02 * turn * std::numbers::pi * i;
                points.push_back(
                    {50.0 + 20.0 * std::cos(angle), 50.0 + 20.0 * std::sin(angle), 0.25 + swelling * (i % 100)});
            }
            if (turn == 1.0) points.back() = points[0];
            PagePath path;
            path.points = points;
            path.closed = turn == 1.0;
            writer->path(path);
        }
    writer->end_group();
    writer->finish();
    return text.all;
}

TEST(Svg, HasArcsWhereLinesOfOneWidthAreArcs) {
    const std::string arcs = svg_of_arcs(output::Curves::arcs), splines = svg_of_arcs(output::Curves::splines);
    EXPECT_TRUE(has(arcs, "d=\"M70 50a20 20 0 0 1 -20 20 20 20 0 0 1 -20 -20\"/>")) << arcs;
    EXPECT_TRUE(has(arcs, "d=\"M70 50a20 20 0 0 1 -30 17.321 20 20 0 0 1 0 -34.641 20 20 0 0 1 30 17.32z\"/>") ||
                has(arcs, "d=\"M70 50a20 20 0 0 1 -30 17.321 20 20 0 0 1 0 -34.642 20 20 0 0 1 30 17.321z\"/>"))
        << arcs;
    EXPECT_FALSE(has(splines, "a20"));
    EXPECT_FALSE(has(svg_of_arcs(output::Curves::lines), "a20"));
    // Lines of varying width are the same in both.
    const auto outlines = [](const std::string& svg) { return svg.substr(svg.find("<path d=")); };
    EXPECT_EQ(outlines(arcs), outlines(splines));
    EXPECT_EQ(svg_of_arcs(output::Curves::arcs, output::PageFormat::pdf),
              svg_of_arcs(output::Curves::splines, output::PageFormat::pdf));
}

TEST(Pdf, HasCorrectObjectOffsets) {
    PageCounts counts;
    const std::string pdf = page_by(output::PageFormat::pdf, counts);
    EXPECT_EQ(pdf.substr(0, 9), "%PDF-1.5\n");
    const std::size_t start = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
    ASSERT_EQ(pdf.substr(start, 5), "xref\n");
    std::size_t line = pdf.find('\n', start + 5) + 1;
    const int objects = std::stoi(pdf.substr(start + 7));
    for (int i = 0; i < objects; ++i, line += 20) {
        EXPECT_EQ(pdf[line + 19], '\n');
        if (i == 0) continue;
        const std::size_t offset = std::stoul(pdf.substr(line, 10));
        const std::string head = std::to_string(i) + " 0 obj\n";
        EXPECT_EQ(pdf.substr(offset, head.size()), head);
    }
    EXPECT_EQ(pdf.substr(line, 7), "trailer");
    const std::size_t content = pdf.find("stream\n") + 7;
    const std::size_t end = pdf.find("\nendstream");
    EXPECT_TRUE(has(pdf, "2 0 obj\n" + std::to_string(end - content) + "\nendobj"));
    EXPECT_TRUE(has(pdf, "/Title <FEFF0041002000260020004200200"
                         "0E9>"));
    EXPECT_TRUE(has(pdf, "(\\(M\xFCller\\) <?>) Tj"));
    EXPECT_TRUE(has(pdf, "/A64 << /ca .251 /CA .251 >>"));
}

} // namespace
} // namespace hrbfnpr::testing::writers_test
