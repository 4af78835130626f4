// SPDX-License-Identifier: MIT
// Tests the layout from a drawing to groups on a page, and lines cut into dashes.
#include "output/vector/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/runtime.h"

namespace hrbfnpr::testing::lay_out_test {
namespace {

using drawing::Cap;
using drawing::MarkClass;
using output::LineType;
using output::PagePath;
using output::PagePoint;

// A part of a line, as the page gets it.
struct Part {
    std::vector<output::PagePoint> points;
    drawing::Cap begin, end;
    bool closed;
    double opacity;

    [[nodiscard]] double length() const {
        double sum = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i)
            sum += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
        return sum;
    }
};

struct KeptGroup {
    output::PageGroup group;
    std::vector<Part> paths;
    std::vector<output::PageDot> dots;
    std::vector<std::string> texts;
};

class Groups final : public output::PageSink {
public:
    void begin_view(const output::PageView& view) override { views.push_back(view); }
    void begin_group(const output::PageGroup& group) override { groups.push_back({group, {}, {}, {}}); }
    void path(const output::PagePath& path) override {
        groups.back().paths.push_back(
            {{path.points.begin(), path.points.end()}, path.begin, path.end, path.closed, path.opacity});
    }
    void dot(const output::PageDot& dot) override { groups.back().dots.push_back(dot); }
    void text(const output::PageText& text) override { groups.back().texts.emplace_back(text.text); }
    void end_group() override {}
    void end_view() override {}
    void finish() override { finished = true; }

    std::vector<output::PageView> views;
    std::vector<KeptGroup> groups;
    bool finished = false;
};

class LayOut : public ::testing::Test {
protected:
    LayOut() {
        picture.window.viewport = {100.0, 50.0, 200.0, 100.0};
        for (const std::uint32_t kind : {1U, 3U, 1U}) {
            drawing::Layer layer{0, -1, MarkClass::silhouette, true, {0.1F, 0.2F, 0.3F, 0.5F}};
            layer.line_kind = kind;
            picture.layers.push_back(layer);
        }
    }
    void add(std::uint32_t layer, std::int32_t hidden, const std::vector<float>& opacity) {
        drawing::Stroke stroke;
        stroke.first = picture.points.size();
        stroke.count = static_cast<std::int32_t>(opacity.size());
        stroke.layer = layer;
        stroke.hidden_layers = hidden;
        stroke.cap_begin = Cap::pointed;
        for (std::size_t i = 0; i < opacity.size(); ++i)
            picture.points.push_back(
                {110.0F + 10.0F * static_cast<float>(i), 70.0F, 2.0F, opacity[i], 0.0F, 0.0F, 1.0F, 0.0F, 0});
        picture.strokes.push_back(stroke);
    }
    void lay_out(std::span<const output::Pen> pens = {}) {
        output::Placement placement{&picture, "front", 5.0, 7.0, 0.5};
        output::lay_out(memory, placement, pens, page, {});
    }

    base::Memory memory;
    drawing::Drawing picture{memory};
    Groups page;
};

TEST_F(LayOut, GroupsLayersWithHiddenLinesFirst) {
    add(0, 0, {1, 1, 1});
    add(0, 2, {1, 1});
    add(2, 0, {1, 1});
    lay_out();
    ASSERT_EQ(page.groups.size(), 3U);
    EXPECT_STREQ(page.groups[0].group.name, "contour hidden 2");
    EXPECT_STREQ(page.groups[1].group.name, "contour");
    EXPECT_STREQ(page.groups[2].group.name, "contour 2");
    ASSERT_EQ(page.groups[1].paths.size(), 1U);
    const Part& path = page.groups[1].paths[0];
    EXPECT_EQ(path.points.size(), 3U);
    EXPECT_DOUBLE_EQ(path.points[0].x, 10.0); // 5 + (110 - 100) / 2
    EXPECT_DOUBLE_EQ(path.points[0].y, 17.0);
    EXPECT_DOUBLE_EQ(path.points[0].radius, 1.0);
    EXPECT_EQ(path.begin, Cap::pointed);
    EXPECT_EQ(path.end, Cap::round);
    EXPECT_DOUBLE_EQ(page.views[0].frame.right, 105.0);
    EXPECT_EQ(page.views[0].name, "front");
}

TEST_F(LayOut, NamesGroupsByTheirOwnLines) {
    picture.layers[0].line_kind = picture.layers[1].line_kind = 10;
    std::string_view("crease").copy(picture.layers[0].line_name.data(), 63);
    std::string_view("outer").copy(picture.layers[2].line_name.data(), 63);
    add(0, 1, {1, 1});
    add(1, 0, {1, 1});
    add(2, 0, {1, 1});
    lay_out();
    ASSERT_EQ(page.groups.size(), 3U);
    EXPECT_STREQ(page.groups[0].group.name, "crease hidden 1");
    EXPECT_STREQ(page.groups[1].group.name, "own");
    EXPECT_STREQ(page.groups[2].group.name, "contour");
}

TEST_F(LayOut, CutsStrokesWhereTheirOpacityChanges) {
    add(0, 0, {1.0F, 1.0F, 0.99F, 0.5F, 0.5F, 0.0F, 0.0F, 0.0F});
    lay_out();
    const std::vector<Part>& paths = page.groups[0].paths;
    ASSERT_EQ(paths.size(), 4U); // invisible parts are left out
    EXPECT_EQ(paths[0].points.size(), 3U);
    EXPECT_EQ(paths[0].begin, Cap::pointed);
    EXPECT_EQ(paths[0].end, Cap::flat);
    EXPECT_EQ(paths[1].begin, Cap::flat);
    EXPECT_NEAR(paths[1].opacity, 0.745, 1e-3);
    EXPECT_DOUBLE_EQ(paths[1].points[0].x, paths[0].points[2].x);
    EXPECT_NEAR(paths[3].opacity, 0.25, 1e-3);
}

TEST_F(LayOut, UsesTheLastMatchingPen) {
    add(0, 0, {1, 1});
    add(0, 1, {1, 1});
    add(1, 0, {1, 1});
    const std::vector<output::Pen> pens{{"", 0.7, {}, 3, {}},
                                        {"contour*", 0.5, {1.0F, 0.0F, 0.0F, 1.0F}, 1, {}},
                                        {"contour hidden*", 0.25, {}, 2, static_cast<LineType>(2)},
                                        {"conto", 9.0, {}, 9, {}}};
    lay_out(pens);
    EXPECT_EQ(page.groups[0].group.pen, 2U);
    EXPECT_EQ(page.groups[0].group.line_type, static_cast<LineType>(2));
    EXPECT_EQ(page.groups[0].group.ink, glm::vec4(0.1F, 0.2F, 0.3F, 0.5F));
    EXPECT_EQ(page.groups[1].group.pen, 1U);
    EXPECT_EQ(page.groups[1].group.ink, glm::vec4(1.0F, 0.0F, 0.0F, 1.0F));
    EXPECT_DOUBLE_EQ(page.groups[2].group.pen_width, 0.7);
}

// Stipples in their own ink and in two inks of a palette.
class LayOutInks : public LayOut {
protected:
    LayOutInks() {
        set.layers.add(memory, marks::Kind::stipples);
        picture.items.push_back({&set, 1.0, glm::dmat4(1.0), glm::mat3(1.0F)});
        picture.layers.clear();
        for (const std::int32_t number : {-1, 0, 1}) {
            drawing::Layer layer;
            layer.ink = {0.0F, 0.2F, 0.3F + 0.1F * static_cast<float>(number), 1.0F};
            layer.ink_number = number;
            picture.layers.push_back(layer);
        }
        picture.one_color = false;
    }
    // Adds a dot that all others overlap.
    void add_dot(std::uint32_t layer, float depth) {
        picture.dots.push_back({150.0F, 100.0F, 3.0F, 1.0F, depth, 0.5F, 1.0F, 1, layer, MarkClass::front, 0});
    }
    void lay_out_dots(std::span<const output::Pen> pens = {}) {
        picture.dot_ranges.push_back({0, picture.dots.size()});
        lay_out(pens);
    }

    marks::PointSet set{memory};
};

TEST_F(LayOutInks, EachInkIsOneGroupEvenIfInksOverlap) {
    for (int i = 0; i < 6; ++i) add_dot(static_cast<std::uint32_t>(i % 3), static_cast<float>(i));
    lay_out_dots();
    ASSERT_EQ(page.groups.size(), 3U);
    EXPECT_STREQ(page.groups[0].group.name, "stipples");
    EXPECT_STREQ(page.groups[1].group.name, "stipples ink 1");
    EXPECT_STREQ(page.groups[2].group.name, "stipples ink 2");
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(page.groups[i].dots.size(), 2U);
        EXPECT_EQ(page.groups[i].group.pen, i + 1);
    }
}

TEST_F(LayOutInks, NamesTellTheSideAndTheNumberBeforeTheInk) {
    for (const std::int32_t number : {-1, 1}) {
        drawing::Layer back = picture.layers[1 + number];
        back.other_side = true;
        picture.layers.push_back(back);
    }
    picture.layers.push_back(picture.layers[2]); // a second item with the same marks
    for (std::uint32_t layer = 0; layer < 6; ++layer) add_dot(layer, 6.0F - static_cast<float>(layer));
    lay_out_dots();
    std::vector<std::string> names;
    for (const KeptGroup& group : page.groups) names.emplace_back(group.group.name);
    EXPECT_EQ(names, (std::vector<std::string>{"stipples", "stipples ink 1", "stipples ink 2", "stipples back",
                                               "stipples back ink 2", "stipples 2 ink 2"}));
}

TEST_F(LayOutInks, OtherLayersAreStillPaintedFromFarToNear) {
    drawing::Layer other;
    other.layer = 1;
    other.ink = {1.0F, 0.0F, 0.0F, 1.0F};
    set.layers.add(memory, marks::Kind::stipples);
    picture.layers.push_back(other);
    add_dot(1, 3.0F);
    add_dot(3, 2.0F);
    add_dot(2, 1.0F);
    lay_out_dots();
    ASSERT_EQ(page.groups.size(), 3U);
    EXPECT_STREQ(page.groups[0].group.name, "stipples ink 1");
    EXPECT_STREQ(page.groups[1].group.name, "stipples");
    EXPECT_STREQ(page.groups[2].group.name, "stipples ink 2, run 2");
}

TEST_F(LayOutInks, APenForAllGroupsIsTheFirstOfARow) {
    for (std::uint32_t i = 0; i < 3; ++i) add_dot(i, 0.0F);
    const std::vector<output::Pen> pens{{"", 0.3, {}, 4, {}}, {"stipples ink 2", 0.5, {}, 1, {}}};
    lay_out_dots(pens);
    ASSERT_EQ(page.groups.size(), 3U);
    EXPECT_EQ(page.groups[0].group.pen, 4U);
    EXPECT_EQ(page.groups[1].group.pen, 5U);
    EXPECT_EQ(page.groups[2].group.pen, 1U);
    EXPECT_DOUBLE_EQ(page.groups[2].group.pen_width, 0.5);
}

std::vector<Part> dashed(std::uint32_t type, const std::vector<PagePoint>& line, bool closed = false) {
    base::Memory memory;
    Groups found;
    const auto types = output::line_types(memory, found);
    output::PageGroup group;
    group.pen_width = 0.5;
    group.line_type = static_cast<LineType>(type);
    types->begin_group(group);
    PagePath path;
    path.points = line;
    path.closed = closed;
    types->path(path);
    types->end_group();
    return found.groups[0].paths;
}

TEST(LineTypes, BeginAndEndWithADash) {
    const std::vector<PagePoint> line{{0, 0, 0.25}, {30, 0, 0.25}, {30, 73, 0.25}};
    const std::vector<Part> dashes = dashed(2, line); // dashes of 6 mm, gaps of 1.5 mm
    ASSERT_EQ(dashes.size(), 14U);
    EXPECT_DOUBLE_EQ(dashes.front().points.front().x, 0.0);
    EXPECT_NEAR(dashes.back().points.back().y, 73.0, 1e-9);
    for (const Part& dash : dashes) {
        EXPECT_NEAR(dash.length(), dashes.front().length(), 1e-9);
        EXPECT_NEAR(dash.length(), 6.0, 0.2);
        EXPECT_EQ(dash.begin, Cap::flat);
    }
}

TEST(LineTypes, MayHaveDotsAndCloseEvenly) {
    const std::vector<PagePoint> square{{0, 0, 1}, {50, 0, 1}, {50, 50, 1}, {0, 50, 1}, {0, 0, 1}};
    const std::vector<Part> found = dashed(4, square, true); // lengths of 12 and 0.25 alternate
    ASSERT_EQ(found.size() % 2, 0U);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].length(), i % 2 == 0 ? 12.0 : 0.25, 0.5) << i;
    EXPECT_EQ(dashed(1, square, true).size(), 1U);
    EXPECT_TRUE(dashed(0, square, true)[0].closed);
    const std::vector<PagePoint> shorter{{0, 0, 1}, {2, 0, 1}};
    EXPECT_EQ(dashed(2, shorter).size(), 1U);
}

} // namespace
} // namespace hrbfnpr::testing::lay_out_test
