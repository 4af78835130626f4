// SPDX-License-Identifier: MIT
// Tests strokes as line strips and as triangle strips.
#include "output/vertex/vertices.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace hrbfnpr::testing::strips_test {
namespace {

using base::Scalar;
using output::Primitive;
using output::VertexAttribute;
using output::VertexField;

struct Vertex {
    float x, y, window, radius, length;
    float color[4];
    std::uint32_t id, layer;
    glm::vec3 position;
    std::uint32_t line;
    std::uint8_t mark_class, is_paper;
};

// The fields have odd offsets.
constexpr std::int64_t stride = 67;
constexpr std::uint32_t line_number = 17;
constexpr std::array fields{VertexField{VertexAttribute::window, Scalar::float32, 1},
                            VertexField{VertexAttribute::radius, Scalar::float32, 13},
                            VertexField{VertexAttribute::length, Scalar::float32, 17},
                            VertexField{VertexAttribute::color, Scalar::float32, 21},
                            VertexField{VertexAttribute::id, Scalar::uint32, 37},
                            VertexField{VertexAttribute::layer, Scalar::uint32, 41},
                            VertexField{VertexAttribute::position, Scalar::float32, 45},
                            VertexField{VertexAttribute::mark_class, Scalar::uint8, 57},
                            VertexField{VertexAttribute::is_paper, Scalar::uint8, 58},
                            VertexField{VertexAttribute::line, Scalar::uint32, 61}};

class Strips : public ::testing::Test {
protected:
    Strips() {
        drawing.layers.push_back({0, 0, drawing::MarkClass::front, true, {0.1F, 0.2F, 0.3F, 0.8F}});
        drawing.layers.push_back({0, 0, drawing::MarkClass::silhouette, false, {1.0F, 0.0F, 0.0F, 1.0F}});
        drawing.layers.push_back({0, 1, drawing::MarkClass::front, true, {0.4F, 0.5F, 0.6F, 0.5F}});
        marks::Layer& layer = set.layers.add(runtime.memory, marks::Kind::own);
        for (int i = 0; i < 20; ++i) {
            for (const float c : {static_cast<float>(i), 1.0F, 2.0F}) layer.position.push_back(c);
            for (const float c : {0.0F, 0.0F, 1.0F}) layer.normal.push_back(c);
            for (const float c : {1.0F, 0.0F, 0.0F}) layer.direction.push_back(c);
            layer.rank.push_back(0.0F);
        }
        drawing.from_window = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0));
        drawing.items.push_back({&set, 1.0, glm::dmat4(1.0), glm::mat3(1.0F)});
        drawing.runs.push_back({0, 0, 20, 1});
    }
    void add_stroke(std::uint32_t layer, const std::vector<glm::vec2>& places) {
        const std::int64_t first = drawing.points.size();
        float length = 0.0F;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (i > 0) length += glm::distance(places[i], places[i - 1]);
            const auto along = static_cast<float>(i);
            drawing.points.push_back({places[i].x, places[i].y, 2.0F + along, 0.5F + 0.1F * along, 7.0F, 0.1F * along,
                                      100.0F, length, 20U - static_cast<std::uint32_t>(drawing.points.size())});
        }
        drawing.strokes.push_back({first, static_cast<std::int32_t>(places.size()), layer, 7.0F});
        drawing.strokes[drawing.strokes.size() - 1].line = line_number;
    }
    void write(Primitive primitive) {
        const output::VertexBound bound = output::vertex_bound(drawing, primitive);
        std::vector<std::byte> bytes(static_cast<std::size_t>(stride * bound.vertices), std::byte{0xCD});
        indices.assign(static_cast<std::size_t>(bound.indices) + 1, 12345);
        output::VertexScratch scratch(runtime);
        output::write_vertices(runtime, drawing, scratch, {primitive, fields, stride}, bytes.data(), indices.data());
        EXPECT_EQ(indices.back(), 12345U) << "written beyond the bound";
        indices.pop_back();
        vertices.clear();
        for (std::int64_t i = 0; i < bound.vertices; ++i) {
            const std::byte* const at = bytes.data() + stride * i;
            EXPECT_EQ(at[0], std::byte{0xCD});
            for (const std::int64_t unused : {59, 60}) EXPECT_EQ(at[unused], std::byte{0xCD});
            Vertex v{};
            std::memcpy(&v.x, at + 1, 20);
            std::memcpy(v.color, at + 21, 16);
            std::memcpy(&v.id, at + 37, 8);
            std::memcpy(&v.position[0], at + 45, 12);
            v.mark_class = std::to_integer<std::uint8_t>(at[57]);
            v.is_paper = std::to_integer<std::uint8_t>(at[58]);
            std::memcpy(&v.line, at + 61, 4);
            vertices.push_back(v);
        }
    }
    [[nodiscard]] glm::vec2 place_of(std::size_t vertex) const { return {vertices[vertex].x, vertices[vertex].y}; }
    // Compares all attributes except the position.
    void expect_point(const Vertex& v, std::int64_t number, std::uint32_t layer) const {
        const drawing::StrokePoint& p = drawing.points[number];
        EXPECT_EQ(v.window, p.window);
        EXPECT_EQ(v.radius, p.radius);
        EXPECT_EQ(v.length, p.length);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(v.color[c], drawing.layers[layer].ink[c]);
        EXPECT_EQ(v.color[3], drawing.layers[layer].ink.w * p.opacity);
        EXPECT_EQ(v.id, p.id);
        EXPECT_EQ(v.layer, layer);
        EXPECT_EQ(v.line, line_number);
        EXPECT_EQ(v.mark_class, static_cast<std::uint8_t>(drawing::MarkClass::front));
        EXPECT_EQ(v.is_paper, 0);
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    drawing::Drawing drawing{runtime.memory};
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

constexpr std::uint32_t restart = output::index_restart;

TEST_F(Strips, LinesGoThroughThePoints) {
    add_stroke(2, {{1, 2}, {4, 6}, {4, 16}});
    add_stroke(0, {{50, 50}, {60, 50}});
    write(Primitive::line_strips);
    ASSERT_EQ(vertices.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const drawing::StrokePoint& p = drawing.points[static_cast<std::int64_t>(i)];
        EXPECT_EQ(place_of(i), glm::vec2(p.x, p.y));
        expect_point(vertices[i], static_cast<std::int64_t>(i), i < 3 ? 2 : 0);
        EXPECT_EQ(vertices[i].position, glm::vec3(static_cast<float>(p.id - 1), 1.0F, 2.0F)) << "its mark";
    }
    drawing.layers[0].as_hatch = true;
    write(Primitive::line_strips);
    EXPECT_EQ(vertices[2].position, glm::vec3(17.0F, 1.0F, 2.0F));
    EXPECT_EQ(vertices[3].position, 2.0F * glm::vec3(50.0F, 50.0F, vertices[3].window)) << "what is drawn";
    EXPECT_EQ(vertices[2].length, 15.0F);
    EXPECT_EQ(vertices[3].length, 0.0F);
    EXPECT_EQ(indices, (std::vector<std::uint32_t>{0, 1, 2, restart, 3, 4, restart}));
}

TEST_F(Strips, TrianglesAreAsWideAsTheStroke) {
    add_stroke(2, {{10, 20}, {20, 20}, {40, 20}});
    add_stroke(0, {{50, 50}, {50, 90}});
    write(Primitive::triangle_strips);
    ASSERT_EQ(vertices.size(), 10U);
    for (std::size_t i = 0; i < 10; ++i) expect_point(vertices[i], static_cast<std::int64_t>(i / 2), i < 6 ? 2 : 0);
    for (std::size_t i = 0; i < 5; ++i) {
        const drawing::StrokePoint& p = drawing.points[static_cast<std::int64_t>(i)];
        const glm::vec2 side = place_of(2 * i) - glm::vec2(p.x, p.y);
        EXPECT_EQ(place_of(2 * i + 1) - glm::vec2(p.x, p.y), -side);
        EXPECT_NEAR(glm::length(side), p.radius, 1e-5F);
        EXPECT_EQ(vertices[2 * i].position, 2.0F * glm::vec3(place_of(2 * i), p.window));
        EXPECT_NEAR(i < 3 ? side.x : side.y, 0.0F, 1e-5F) << "across the stroke";
    }
    // These vertices are on the same side of the stroke.
    EXPECT_GT((place_of(0).y - 20.0F) * (place_of(2).y - 20.0F), 0.0F);
    EXPECT_GT((place_of(2).y - 20.0F) * (place_of(4).y - 20.0F), 0.0F);
    EXPECT_EQ(indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, restart, 6, 7, 8, 9, restart}));
}

TEST_F(Strips, TrianglesKeepTheirWidthAroundACorner) {
    add_stroke(0, {{0, 0}, {10, 0}, {10, 10}});
    write(Primitive::triangle_strips);
    const glm::vec2 side = place_of(2) - glm::vec2(10.0F, 0.0F);
    const float radius = drawing.points[1].radius;
    EXPECT_NEAR(std::abs(side.x), radius, 1e-5F);
    EXPECT_NEAR(std::abs(side.y), radius, 1e-5F);
    EXPECT_LT(side.x * side.y, 0.0F) << "along the corner's bisector";
    EXPECT_EQ(place_of(3) - glm::vec2(10.0F, 0.0F), -side);
    // The outer side of each segment stays on one side of the stroke.
    EXPECT_GT(side.y * place_of(0).y, 0.0F);
}

TEST_F(Strips, TrianglesAtSharpTurnsAreAtMostTwiceAsWide) {
    for (int degrees = 0; degrees <= 360; degrees += 3) {
        drawing.points.clear();
        drawing.strokes.clear();
        const auto angle = static_cast<float>(degrees) * 0.01745329252F;
        add_stroke(0, {{0, 0}, {10, 0}, {10.0F + 10.0F * std::cos(angle), 10.0F * std::sin(angle)}});
        write(Primitive::triangle_strips);
        const glm::vec2 side = place_of(2) - glm::vec2(10.0F, 0.0F);
        const float radius = drawing.points[1].radius;
        EXPECT_LE(glm::length(side), 2.0F * radius + 1e-4F) << degrees;
        const int off = degrees > 180 ? 360 - degrees : degrees;
        if (off > 119) continue;
        EXPECT_NEAR(std::abs(side.y), radius, 1e-3F) << degrees;
        EXPECT_NEAR(glm::length(side), radius / std::cos(0.5F * static_cast<float>(off) * 0.01745329252F), 1e-3F);
    }
}

TEST_F(Strips, CoincidentPointsAreAccepted) {
    add_stroke(0, {{5, 5}, {5, 5}, {15, 5}, {15, 5}});
    add_stroke(0, {{5, 5}, {5, 5}});
    write(Primitive::triangle_strips);
    ASSERT_EQ(vertices.size(), 12U);
    for (const Vertex& v : vertices) EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
}

TEST_F(Strips, KeepTheirWidthWhereAPointIsRepeated) {
    add_stroke(0, {{5, 5}, {15, 5}, {15, 5}, {25, 5}});
    write(Primitive::triangle_strips);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(std::abs(vertices[i].y - 5.0F), drawing.points[static_cast<std::int64_t>(i / 2)].radius, 1e-5F)
            << i;
}

TEST_F(Strips, PointedEndsHaveATip) {
    add_stroke(0, {{10, 20}, {20, 20}});
    add_stroke(0, {{50, 50}, {50, 90}});
    add_stroke(2, {{10, 60}, {20, 60}});
    drawing.strokes[0].cap_begin = drawing.strokes[0].cap_end = drawing::Cap::pointed;
    drawing.strokes[2].cap_end = drawing::Cap::pointed;
    write(Primitive::triangle_strips);
    ASSERT_EQ(vertices.size(), 18U);
    EXPECT_EQ(place_of(0), glm::vec2(10.0F - 2.0F * drawing::point_length * 2.0F, 20.0F));
    EXPECT_EQ(place_of(1), place_of(0));
    EXPECT_EQ(place_of(7), glm::vec2(20.0F + 2.0F * drawing::point_length * 3.0F, 20.0F));
    EXPECT_EQ(vertices[6].id, vertices[5].id);
    EXPECT_NEAR(place_of(8).y, 50.0F, 1e-5F);
    EXPECT_NEAR(std::abs(place_of(12).y - 60.0F), 2.0F, 1e-5F);
    EXPECT_EQ(indices, (std::vector<std::uint32_t>{0,  1,  2,       3,  4,  5,  6,  7,  restart, 8,      9,
                                                   10, 11, restart, 12, 13, 14, 15, 16, 17,      restart}));
    write(Primitive::line_strips);
    EXPECT_EQ(vertices.size(), 6U);
}

TEST_F(Strips, ClosedStripsHaveNoSeam) {
    add_stroke(0, {{10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}});
    drawing.points[4].radius = drawing.points[0].radius;
    drawing.strokes[0].closed = true;
    drawing.strokes[0].cap_begin = drawing::Cap::pointed; // closed strokes ignore their caps
    write(Primitive::triangle_strips);
    ASSERT_EQ(vertices.size(), 10U);
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_EQ(place_of(i), place_of(8 + i));
        EXPECT_NEAR(std::abs(place_of(i).x - 10.0F), drawing.points[0].radius, 1e-5F);
        EXPECT_NEAR(std::abs(place_of(i).y - 10.0F), drawing.points[0].radius, 1e-5F);
    }
}

TEST_F(Strips, AreEmptyWithoutStrokes) {
    for (const Primitive primitive : {Primitive::line_strips, Primitive::triangle_strips}) {
        write(primitive);
        EXPECT_TRUE(vertices.empty());
        EXPECT_TRUE(indices.empty());
    }
}

TEST_F(Strips, ManyStrokesKeepTheirOrder) {
    set.layers[0].rank.resize(3000);
    for (int i = 0; i < 1000; ++i) {
        const auto y = static_cast<float>(i);
        drawing.points.push_back({0.0F, y, 1.0F, 1.0F, 7.0F, 0.5F, 1.0F, 0.0F, 1});
        drawing.points.push_back({9.0F, y, 1.0F, 1.0F, 7.0F, 0.5F, 1.0F, 9.0F, 2});
        drawing.points.push_back({18.0F, y, 1.0F, 1.0F, 7.0F, 0.5F, 1.0F, 18.0F, 3});
        drawing.strokes.push_back({3 * i, 3, 0, 7.0F});
    }
    write(Primitive::line_strips);
    ASSERT_EQ(vertices.size(), 3000U);
    ASSERT_EQ(indices.size(), 4000U);
    for (std::size_t i = 0; i < 3000; ++i)
        ASSERT_EQ(place_of(i), glm::vec2(9.0F * static_cast<float>(i % 3), static_cast<float>(i / 3)));
    for (std::size_t i = 0; i < 4000; ++i)
        ASSERT_EQ(indices[i], i % 4 == 3 ? restart : static_cast<std::uint32_t>(i / 4 * 3 + i % 4));
}

// The primitive `points` writes the dots, numbered in the order of painting.
TEST_F(Strips, DotsAreNumberedInPaintingOrder) {
    for (const float depth : {3.0F, 5.0F, 4.0F, 6.0F}) {
        drawing::Dot dot{};
        dot.x = depth;
        dot.opacity = depth < 6.0F ? 0.5F : 0.0F; // the last one is invisible
        dot.depth = depth;
        dot.id = 1;
        dot.mark_class = drawing::MarkClass::front;
        drawing.dots.push_back(dot);
    }
    drawing.dot_ranges.push_back({0, 4});
    drawing.dot_count = 3;
    write(Primitive::points);
    ASSERT_EQ(vertices.size(), 3U);
    EXPECT_EQ(vertices[0].x, 5.0F);
    EXPECT_EQ(vertices[1].x, 4.0F);
    EXPECT_EQ(vertices[2].x, 3.0F);
    EXPECT_EQ(vertices[0].length, 0.0F);
    EXPECT_EQ(indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

} // namespace
} // namespace hrbfnpr::testing::strips_test
