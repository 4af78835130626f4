// SPDX-License-Identifier: MIT
// Tests DXF by a reader of its own: the structure of the file, its tables, and the geometry of each kind of entity.
#include "output/vector/page.h"

#include "recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

namespace hrbfnpr::testing::dxf_test {
namespace {

using drawing::Cap;
using output::PageGroup;
using output::PagePoint;

struct Pair {
    int code;
    std::string value;
};

// An entity, an entry of a table, or an object.
struct Record {
    std::string type;
    std::vector<Pair> pairs;

    [[nodiscard]] std::string text(int code) const {
        for (const Pair& pair : pairs)
            if (pair.code == code) return pair.value;
        return {};
    }
    [[nodiscard]] bool has(int code) const { return !text(code).empty(); }
    [[nodiscard]] double number(int code) const { return std::stod(text(code)); }
    [[nodiscard]] std::vector<double> numbers(int code) const {
        std::vector<double> all;
        for (const Pair& pair : pairs)
            if (pair.code == code) all.push_back(std::stod(pair.value));
        return all;
    }
};

struct Dxf {
    std::vector<std::string> comments;
    std::map<std::string, std::string> header;
    std::map<std::string, std::vector<Record>> sections;
    std::vector<std::string> order; // the names of the sections

    [[nodiscard]] const std::vector<Record>& entities() const { return sections.at("ENTITIES"); }
    [[nodiscard]] std::map<std::string, Record> entries(const std::string& type) const {
        std::map<std::string, Record> found;
        for (const Record& record : sections.at("TABLES"))
            if (record.type == type) found[record.text(2)] = record;
        return found;
    }
};

Dxf read(const std::string& text) {
    Dxf dxf;
    std::istringstream stream(text);
    std::string code, value, section, variable;
    std::set<std::string> handles;
    bool ended = false, names_section = false;
    while (std::getline(stream, code)) {
        EXPECT_FALSE(ended) << "nothing follows EOF";
        EXPECT_TRUE(static_cast<bool>(std::getline(stream, value)));
        const int number = std::stoi(code);
        for (const char c : value) EXPECT_TRUE(c >= ' ' && c < 0x7F) << value;
        if (number == 999) {
            dxf.comments.push_back(value);
        } else if (number == 0 && value == "SECTION") {
            names_section = true;
        } else if (names_section) {
            EXPECT_EQ(number, 2);
            section = value;
            dxf.order.push_back(section);
            dxf.sections[section];
            names_section = false;
        } else if (number == 0 && value == "ENDSEC") {
            section.clear();
        } else if (number == 0 && value == "EOF") {
            ended = true;
        } else if (section == "HEADER") {
            if (number == 9)
                variable = value;
            else
                dxf.header[variable] += value + " ";
        } else if (number == 0) {
            dxf.sections[section].push_back({value, {}});
        } else {
            EXPECT_FALSE(section.empty() || dxf.sections[section].empty());
            dxf.sections[section].back().pairs.push_back({number, value});
            if (number == 5) {
                EXPECT_TRUE(handles.insert(value).second) << value;
                EXPECT_LT(std::stoul(value, nullptr, 16), std::stoul(dxf.header["$HANDSEED"], nullptr, 16));
            }
        }
    }
    EXPECT_TRUE(ended);
    for (const auto& [name, records] : dxf.sections)
        for (const Record& record : records)
            for (const Pair& pair : record.pairs) {
                const bool is_reference = pair.code == 330 || pair.code == 390 || pair.code == 350;
                EXPECT_TRUE(!is_reference || pair.value == "0" || handles.count(pair.value) > 0)
                    << record.type << ' ' << pair.code << ' ' << pair.value;
            }
    const auto layers = dxf.entries("LAYER");
    const auto types = dxf.entries("LTYPE");
    for (const Record& entity : dxf.entities()) {
        EXPECT_EQ(layers.count(entity.text(8)), 1U) << entity.text(8);
        EXPECT_TRUE(!entity.has(6) || types.count(entity.text(6)) == 1) << entity.text(6);
    }
    for (const auto& [name, layer] : layers) EXPECT_EQ(types.count(layer.text(6)), 1U) << name;
    return dxf;
}

class StringWriter final : public io::Writer {
public:
    void write(const void* data, std::uint64_t size) override {
        text.append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    }
    std::string text;
};

PageGroup group_named(const char* name, double pen_width = 0.5) {
    PageGroup group;
    std::snprintf(group.name, sizeof group.name, "%s", name);
    group.pen_width = pen_width;
    return group;
}

// A page of 200 by 100 mm.
struct Sheet {
    std::vector<GroupInput> groups;
    std::vector<output::PageText> texts;
    output::ShapeSettings shapes;
    output::PageCounts counts;

    GroupInput& add(const PageGroup& group) {
        groups.emplace_back();
        groups.back().group = group;
        return groups.back();
    }
    std::string written() {
        base::Memory memory;
        StringWriter out;
        std::vector<PageGroup> all;
        for (const GroupInput& input : groups) all.push_back(input.group);
        output::PageInfo info;
        info.width = 200.0;
        info.height = 100.0;
        info.title = "A title\nof two lines, gr\xC3\xBCn";
        info.program = "1.2.3";
        info.groups = all;
        output::PageSettings settings;
        settings.format = output::PageFormat::dxf;
        settings.width = 200.0;
        settings.height = 100.0;
        settings.shapes = shapes;
        counts = {};
        const auto file = output::make_writer(memory, out, info, settings, counts);
        const auto clip = output::clip_to_frames(memory, *file, settings);
        clip->begin_view({"front", {0.0, 0.0, 150.0, 100.0}, {}, true});
        for (const GroupInput& input : groups) input.hand_to(*clip);
        if (!texts.empty()) {
            clip->begin_group(groups[0].group);
            for (const output::PageText& text : texts) clip->text(text);
            clip->end_group();
        }
        clip->end_view();
        clip->finish();
        EXPECT_EQ(counts.bytes, static_cast<std::int64_t>(out.text.size()));
        return out.text;
    }
    Dxf dxf() { return read(written()); }
};

Line circle(double x, double y, double radius, double from, double to, int count = 90) {
    Line line;
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        line.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), 0.25});
    }
    return line;
}

constexpr double pi = std::numbers::pi;

TEST(Dxf, HasItsSectionsTablesAndUnits) {
    Sheet sheet;
    sheet.add(group_named("contour")).add({{10.0, 90.0, 0.1}, {20.0, 80.0, 0.1}});
    const Dxf dxf = sheet.dxf();
    EXPECT_EQ(dxf.order, (std::vector<std::string>{"HEADER", "CLASSES", "TABLES", "BLOCKS", "ENTITIES", "OBJECTS"}));
    EXPECT_EQ(dxf.header.at("$ACADVER"), "AC1018 ");
    EXPECT_EQ(dxf.header.at("$INSUNITS"), "4 ");
    EXPECT_EQ(dxf.header.at("$EXTMAX"), "200.0 100.0 0.0 ");
    EXPECT_EQ(dxf.comments[0], "A title");
    EXPECT_EQ(dxf.comments[1], "of two lines, gr\\U+00FCn");
    EXPECT_EQ(dxf.comments.back(), "hrbfnpr 1.2.3");
    std::vector<std::string> tables;
    for (const Record& record : dxf.sections.at("TABLES"))
        if (record.type == "TABLE") tables.push_back(record.text(2));
    EXPECT_EQ(tables, (std::vector<std::string>{"VPORT", "LTYPE", "LAYER", "STYLE", "VIEW", "UCS", "APPID", "DIMSTYLE",
                                                "BLOCK_RECORD"}));
    ASSERT_EQ(dxf.entities().size(), 1U);
    const Record& line = dxf.entities()[0];
    EXPECT_EQ(line.type, "LINE");
    EXPECT_EQ(line.number(10), 10.0);
    EXPECT_EQ(line.number(20), 10.0); // y is up
    EXPECT_EQ(line.number(11), 20.0);
    EXPECT_EQ(line.number(21), 20.0);
}

TEST(Dxf, HasLayersWithInkWidthAndLineType) {
    Sheet sheet;
    PageGroup hidden = group_named("contour hidden 1", 0.25);
    hidden.line_type = output::LineType{2};
    hidden.ink = {1.0F, 0.5F, 0.0F, 0.5F};
    sheet.add(group_named("contour")).add({{10.0, 90.0, 0.1}, {20.0, 80.0, 0.1}});
    sheet.add(hidden).add({{10.0, 90.0, 0.1}, {20.0, 80.0, 0.1}});
    sheet.add(group_named("a<b>/\\\":;?*|=,`gr\xC3\xBCn \xF0\x9F\x90\x87"));
    const Dxf dxf = sheet.dxf();
    const auto layers = dxf.entries("LAYER");
    EXPECT_EQ(layers.size(), 4U); // with layer 0
    const Record& contour = layers.at("contour");
    EXPECT_EQ(contour.number(62), 7.0); // black on paper, white on a dark screen
    EXPECT_FALSE(contour.has(420));
    EXPECT_EQ(contour.text(6), "Continuous");
    EXPECT_EQ(contour.number(370), 50.0);
    const Record& dashed = layers.at("contour hidden 1");
    EXPECT_EQ(dashed.number(420), 0xFF8000);
    EXPECT_EQ(dashed.text(6), "ACAD_ISO02W100");
    EXPECT_EQ(dashed.number(370), 25.0);
    EXPECT_EQ(layers.count("a_b____________gr\\U+00FCn _"), 1U);
    const Record type = dxf.entries("LTYPE").at("ACAD_ISO02W100");
    EXPECT_EQ(type.numbers(49), (std::vector<double>{12.0, -3.0}));
    EXPECT_EQ(type.number(40), 15.0);
    ASSERT_EQ(dxf.entities().size(), 2U); // dashes are not cut
    EXPECT_FALSE(dxf.entities()[0].has(62) || dxf.entities()[0].has(370) || dxf.entities()[0].has(440));
    EXPECT_EQ(dxf.entities()[1].number(48), 0.25);
    EXPECT_EQ(dxf.entities()[1].number(440), 0x02000000 + 128);
}

// Groups of one name share a layer. Names are the same if they differ in case only.
TEST(Dxf, SaysWhatIsNotAsInTheLayer) {
    Sheet sheet;
    PageGroup other = group_named("Contour", 0.7);
    other.ink = {0.0F, 0.0F, 1.0F, 1.0F};
    other.line_type = output::LineType{4};
    sheet.add(group_named("contour")).add({{10.0, 90.0, 0.1}, {20.0, 80.0, 0.1}});
    sheet.add(other).add({{10.0, 90.0, 0.1}, {20.0, 80.0, 0.1}});
    const Dxf dxf = sheet.dxf();
    EXPECT_EQ(dxf.entries("LAYER").size(), 2U);
    const Record& line = dxf.entities()[1];
    EXPECT_EQ(line.text(8), "contour");
    EXPECT_EQ(line.text(6), "ACAD_ISO04W100");
    EXPECT_EQ(line.number(62), 5.0);
    EXPECT_EQ(line.number(420), 255.0);
    EXPECT_EQ(line.number(370), 70.0);
}

TEST(Dxf, WritesArcsAndCircles) {
    Sheet sheet;
    GroupInput& input = sheet.add(group_named("contour"));
    input.add(circle(50.0, 40.0, 20.0, 0.0, 2.0 * pi), true);
    input.add(circle(50.0, 40.0, 10.0, 0.0, 0.5 * pi)); // from right to below
    input.add(circle(50.0, 40.0, 10.0, 0.5 * pi, 0.0));
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 3U);
    EXPECT_EQ(dxf.entities()[0].type, "CIRCLE");
    EXPECT_NEAR(dxf.entities()[0].number(40), 20.0, 1e-6);
    for (const std::size_t i : {1U, 2U}) {
        const Record& arc = dxf.entities()[i];
        EXPECT_EQ(arc.type, "ARC");
        EXPECT_NEAR(arc.number(10), 50.0, 1e-6);
        EXPECT_NEAR(arc.number(20), 60.0, 1e-6);
        EXPECT_NEAR(arc.number(40), 10.0, 1e-6);
        EXPECT_NEAR(arc.number(50), 270.0, 1e-6);
        EXPECT_NEAR(std::fmod(arc.number(51), 360.0), 0.0, 1e-6);
    }
    EXPECT_EQ(sheet.counts.segments, 3);
}

TEST(Dxf, WritesLinesWithArcsAsPolylines) {
    Sheet sheet;
    Line slot = circle(60.0, 50.0, 10.0, -0.5 * pi, 0.5 * pi);
    for (const PagePoint& p : circle(30.0, 50.0, 10.0, 0.5 * pi, 1.5 * pi)) slot.push_back(p);
    slot.push_back(slot[0]);
    sheet.add(group_named("contour")).add(slot, true);
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 1U);
    const Record& line = dxf.entities()[0];
    ASSERT_EQ(line.type, "LWPOLYLINE");
    EXPECT_EQ(line.number(90), 4.0);
    EXPECT_EQ(line.number(70), 1.0);
    const std::vector<double> bulges = line.numbers(42);
    ASSERT_EQ(bulges.size(), 2U);
    for (const double bulge : bulges) EXPECT_NEAR(bulge, -1.0, 0.03); // half turns, clockwise where y is up
}

TEST(Dxf, WritesCubicsAsSplines) {
    Sheet sheet;
    Line wave;
    for (int i = 0; i <= 200; ++i) wave.push_back({10.0 + 0.5 * i, 50.0 + 10.0 * std::sin(0.06 * i), 0.25});
    sheet.add(group_named("contour")).add(wave);
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 1U);
    const Record& spline = dxf.entities()[0];
    ASSERT_EQ(spline.type, "SPLINE");
    const std::vector<double> x = spline.numbers(10), y = spline.numbers(20), knots = spline.numbers(40);
    ASSERT_EQ(x.size(), spline.number(73));
    ASSERT_EQ(knots.size(), spline.number(72));
    ASSERT_EQ(knots.size(), x.size() + 4);
    EXPECT_TRUE(std::is_sorted(knots.begin(), knots.end()));
    // The spline is the chain of cubics through every third control point.
    double most = 0.0;
    for (std::size_t i = 0; i + 3 < x.size(); i += 3)
        for (double t = 0.0; t <= 1.0; t += 0.125) {
            const double s = 1.0 - t;
            const auto at = [&](const std::vector<double>& c) {
                return s * s * s * c[i] + 3.0 * s * s * t * c[i + 1] + 3.0 * s * t * t * c[i + 2] +
                       t * t * t * c[i + 3];
            };
            most = std::max(most, std::abs(at(y) - (50.0 - 10.0 * std::sin(0.12 * (at(x) - 10.0)))));
        }
    EXPECT_LT(most, 0.1);
    sheet.shapes.curves = output::Curves::lines;
    const Dxf straight = sheet.dxf();
    EXPECT_EQ(straight.entities()[0].type, "LWPOLYLINE");
    EXPECT_FALSE(straight.entities()[0].has(42));
}

TEST(Dxf, WritesLinesOfVaryingWidthWithTheirWidths) {
    Sheet sheet;
    GroupInput& input = sheet.add(group_named("hatch", 0.0));
    input.add({{10.0, 50.0, 0.1}, {30.0, 50.0, 0.5}, {60.0, 50.0, 0.2}});
    input.paths[0].end = Cap::pointed;
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 1U);
    const Record& line = dxf.entities()[0];
    EXPECT_EQ(line.type, "LWPOLYLINE");
    EXPECT_EQ(line.numbers(40), (std::vector<double>{0.2, 1.0, 0.4, 0.0}));
    EXPECT_EQ(line.numbers(41), (std::vector<double>{1.0, 0.4, 0.0, 0.0}));
    EXPECT_GT(line.numbers(10).back(), 60.0);
    sheet.shapes.widths = output::Widths::classes;
    const Dxf classes = sheet.dxf();
    EXPECT_GT(classes.entities().size(), 3U);
    for (const Record& one : classes.entities()) EXPECT_TRUE(one.has(370) && !one.has(41));
}

TEST(Dxf, WritesDotsAsCirclesOrPoints) {
    Sheet sheet;
    GroupInput& input = sheet.add(group_named("stipples", 0.0));
    input.dots = {{10.0, 90.0, 0.3, 1.0, false}, {190.0, 90.0, 0.3, 1.0, false}}; // the second is beyond the frame
    const Dxf circles = sheet.dxf();
    ASSERT_EQ(circles.entities().size(), 1U);
    EXPECT_EQ(circles.entities()[0].type, "CIRCLE");
    EXPECT_NEAR(circles.entities()[0].number(40), 0.3, 1e-9);
    EXPECT_NEAR(circles.entities()[0].number(20), 10.0, 1e-9);
    sheet.shapes.dots = output::DotShapes::lines;
    const Dxf points = sheet.dxf();
    ASSERT_EQ(points.entities().size(), 1U);
    EXPECT_EQ(points.entities()[0].type, "POINT");
    EXPECT_EQ(points.entities()[0].number(370), 60.0);
}

TEST(Dxf, CutsLinesAtTheFrame) {
    Sheet sheet;
    sheet.add(group_named("contour")).add({{140.0, 50.0, 0.25}, {180.0, 50.0, 0.25}});
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 1U);
    EXPECT_EQ(dxf.entities()[0].number(11), 150.0);
}

TEST(Dxf, EscapesTexts) {
    Sheet sheet;
    sheet.add(group_named("texts"));
    sheet.texts = {{10.0, 90.0, 3.5, "\xC3\x98 12 \xC3\x97 5 100%%c ^J\n\xF0\x9F\x90\x87"}};
    const Dxf dxf = sheet.dxf();
    ASSERT_EQ(dxf.entities().size(), 1U);
    EXPECT_EQ(dxf.entities()[0].text(1), "\\U+00D8 12 \\U+00D7 5 100%%%%c ^ J ?");
    EXPECT_EQ(dxf.entities()[0].number(40), 3.5);
}

TEST(Dxf, IsTheSameEveryTime) {
    Sheet sheet;
    sheet.add(group_named("contour")) = random_lines(1, 100, 30.0, 40);
    EXPECT_EQ(sheet.written(), sheet.written());
}

} // namespace
} // namespace hrbfnpr::testing::dxf_test
