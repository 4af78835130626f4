// SPDX-License-Identifier: MIT
// Tests what a drawing knows about the marks that its dots and strokes come from.
#include "drawing/drawing.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace hrbfnpr::testing::drawing_test {
namespace {

using drawing::Drawing;
using drawing::Identity;
using drawing::MarkSource;

// Adds a layer of `count` marks at (10 number + i, 0, 0).
void add_layer(marks::PointSet& set, float number, int count) {
    marks::Layer& layer = set.layers.add(set.layers.memory(), marks::Kind::own);
    for (int i = 0; i < count; ++i) {
        for (const float c : {10.0F * number + static_cast<float>(i), 0.0F, 0.0F}) layer.position.push_back(c);
        for (const float c : {0.0F, 0.0F, 1.0F}) layer.normal.push_back(c);
        for (const float c : {0.0F, 1.0F, 0.0F}) layer.direction.push_back(c);
        layer.rank.push_back(0.5F);
        layer.level.push_back(0);
    }
}

// The first item has layers of 3, 0, 4 (two strokes, crosswise) and 0 marks; the second has layers of 0 and 2 marks.
class DrawingTest : public ::testing::Test {
protected:
    DrawingTest() {
        add_layer(first, 0.0F, 3);
        add_layer(first, 1.0F, 0);
        add_layer(first, 2.0F, 4);
        add_layer(first, 3.0F, 0);
        for (const std::uint32_t number : {6U, 1U, 2U, 1U, 6U, 0U, 2U, 0U}) first.layers[2].stroke.push_back(number);
        marks::index_strokes(first.layers[2]);
        add_layer(second, 4.0F, 0);
        add_layer(second, 5.0F, 2);
        drawing.items.push_back({&first, 1.0, glm::dmat4(1.0), glm::mat3(1.0F)});
        glm::dmat4 moved(2.0);
        moved[3] = {0.0, 0.0, 7.0, 1.0};
        drawing.items.push_back({&second, 1.0, moved, glm::mat3(0.5F)});
        std::uint32_t id = 1;
        for (std::int32_t item = 0; item < 2; ++item) {
            const marks::PointSet& set = *drawing.items[item].set;
            for (std::int32_t layer = 0; layer < set.layers.size(); ++layer) {
                drawing.runs.push_back({item, layer, set.layers[layer].count(), id});
                id += static_cast<std::uint32_t>(set.layers[layer].count());
            }
        }
    }

    base::Memory memory;
    marks::PointSet first{memory};
    marks::PointSet second{memory};
    Drawing drawing{memory};
};

TEST_F(DrawingTest, FindsTheLayerOfAnIdAcrossEmptyLayers) {
    EXPECT_EQ(drawing.run_of(0), nullptr);
    EXPECT_EQ(drawing.run_of(10), nullptr);
    EXPECT_EQ(drawing.run_of(0xFFFFFFFFU), nullptr);
    for (std::uint32_t id = 1; id < 10; ++id) {
        const auto* const run = drawing.run_of(id);
        ASSERT_NE(run, nullptr) << id;
        EXPECT_EQ(run->item, id < 8 ? 0 : 1) << id;
        EXPECT_EQ(run->layer, id < 4 ? 0 : id < 8 ? 2 : 1) << id;
    }
}

TEST_F(DrawingTest, FindsNoIdsWithoutMarks) {
    const Drawing empty(memory);
    EXPECT_EQ(empty.run_of(1), nullptr);
    drawing.clear();
    EXPECT_EQ(drawing.run_of(1), nullptr);
}

TEST_F(DrawingTest, IdentifiesMarksAndTheirStrokes) {
    const auto expect = [&](std::uint32_t id, const Identity& e) {
        const Identity found = drawing.identify(id);
        EXPECT_EQ(found.item, e.item) << id;
        EXPECT_EQ(found.layer, e.layer) << id;
        EXPECT_EQ(found.mark, e.mark) << id;
        EXPECT_EQ(found.stroke, e.stroke) << id;
        EXPECT_EQ(found.place, e.place) << id;
    };
    expect(1, {0, 0, 0, -1, 0});
    expect(3, {0, 0, 2, -1, 0});
    expect(4, {0, 2, 0, 1, 1}); // strokes in the order of their numbers: 2, then 6
    expect(5, {0, 2, 1, 0, 1});
    expect(6, {0, 2, 2, 1, 0});
    expect(7, {0, 2, 3, 0, 0});
    expect(8, {1, 1, 0, -1, 0});
    expect(9, {1, 1, 1, -1, 0});
}

TEST_F(DrawingTest, GivesTheWorldPositionOfAMark) {
    const MarkSource plain = drawing.source(6);
    EXPECT_EQ(plain.position, glm::vec3(22.0F, 0.0F, 0.0F));
    EXPECT_EQ(plain.normal, glm::vec3(0.0F, 0.0F, 1.0F));
    EXPECT_EQ(plain.direction, glm::vec3(0.0F, 1.0F, 0.0F));
    const MarkSource moved = drawing.source(9);
    EXPECT_EQ(moved.position, glm::vec3(102.0F, 0.0F, 7.0F));
    EXPECT_EQ(moved.normal, glm::vec3(0.0F, 0.0F, 1.0F));
    EXPECT_EQ(moved.direction, glm::vec3(0.0F, 1.0F, 0.0F));
}

TEST_F(DrawingTest, GivesThePositionOfAPosedMark) {
    drawing.runs[2].posed = 0; // ids 4 to 7
    for (int i = 0; i < 4; ++i) {
        for (const float c : {0.0F, static_cast<float>(i), 0.0F}) drawing.posed_position.push_back(c);
        for (const float c : {1.0F, 0.0F, 0.0F}) drawing.posed_normal.push_back(c);
        for (const float c : {0.0F, 0.0F, 1.0F}) drawing.posed_direction.push_back(c);
    }
    MarkSource source = drawing.source(6);
    EXPECT_EQ(source.position, glm::vec3(0.0F, 2.0F, 0.0F));
    EXPECT_EQ(source.normal, glm::vec3(1.0F, 0.0F, 0.0F));
    EXPECT_EQ(source.direction, glm::vec3(0.0F, 1.0F, 0.0F)) << "as in the set";
    drawing.runs[2].poses_directions = true;
    source = drawing.source(6);
    EXPECT_EQ(source.direction, glm::vec3(0.0F, 0.0F, 1.0F));
}

} // namespace
} // namespace hrbfnpr::testing::drawing_test
