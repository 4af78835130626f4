// SPDX-License-Identifier: MIT
// Tests strokes as pixels: loops on every instruction set, coverage, joints, the order among dots.
#include "drawing/drawing.h"
#include "output/raster/raster.h"
#include "raster/reference.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace hrbfnpr::testing::strokes_test {
namespace {

using drawing::Cap;
using drawing::Stroke;
using drawing::StrokePoint;
using frame::LayerStyle;

constexpr std::int32_t side = 64;
constexpr std::int32_t stride = side + 16;

// The planes of a tile, and the segments of a stroke in and around it.
struct Laid {
    std::vector<float> transmittance = std::vector<float>(stride * side, 1.0F);
    std::array<std::vector<float>, 3> color;
    std::vector<float> host = std::vector<float>(stride * side, 1.0F);
    std::vector<float> cover = std::vector<float>(stride * side, 0.0F);
    std::vector<float> ink = cover;
    base::Memory memory;
    output::StrokeUnion overlaps{memory};

    Laid() { color.fill(std::vector<float>(stride * side, 0.0F)); }
    [[nodiscard]] output::DiscTile tile(bool colors, bool hosted) {
        output::DiscTile t{side, side, stride, transmittance.data(), {}, nullptr};
        for (std::size_t c = 0; c < 3 && colors; ++c) t.color[c] = color[c].data();
        if (hosted) t.host = host.data();
        return t;
    }
    [[nodiscard]] output::StrokePlanes strokes() { return {cover.data(), ink.data(), &overlaps}; }
    // Returns the tile's own pixels. The content of the padding beyond its width does not matter.
    [[nodiscard]] std::vector<float> pixels() const {
        std::vector<float> all;
        for (const std::vector<float>* const plane : {&transmittance, &color[0], &color[1], &color[2], &cover})
            for (int y = 0; y < side; ++y)
                all.insert(all.end(), plane->begin() + y * stride, plane->begin() + y * stride + side);
        return all;
    }
};

// Returns ten strokes of 12 points with very different widths. A few of their segments have no length.
std::vector<StrokePoint> random_points() {
    std::vector<StrokePoint> points;
    for (std::uint64_t s = 0; s < 10; ++s) {
        StrokePoint p{};
        const auto start = base::uniform4(21, s, base::Purpose::candidate);
        p.x = static_cast<float>(140.0 * start[0] + 60.0); // the tile begins at (100, 40)
        p.y = static_cast<float>(140.0 * start[1]);
        for (std::uint64_t i = 0; i < 12; ++i) {
            const auto u = base::uniform4(22, 12 * s + i, base::Purpose::candidate);
            if (i % 5 != 4) {
                p.x += static_cast<float>(16.0 * (u[0] - 0.5));
                p.y += static_cast<float>(16.0 * (u[1] - 0.5));
            }
            p.radius = static_cast<float>(s % 2 == 0 ? 1.2 * u[2] : 9.0 * u[2]);
            p.opacity = static_cast<float>(u[3]);
            p.window = static_cast<float>(0.2 + 0.6 * u[3]);
            points.push_back(p);
        }
    }
    return points;
}

TEST(StrokeLoops, GiveTheSameBitsFromEveryInstructionSet) {
    const std::vector<StrokePoint> points = random_points();
    for (const bool colors : {false, true}) {
        for (const bool hosted : {false, true}) {
            std::vector<float> expected;
            for (const base::InstructionSet set : test::instruction_sets()) {
                Laid laid;
                for (std::size_t i = 0; i < laid.host.size(); ++i)
                    laid.host[i] = 0.2F + 0.6F * static_cast<float>(i * 37 % 101) / 101.0F;
                const output::RasterLoops loops = output::raster_loops(set);
                for (std::uint32_t s = 0; s < 10; ++s) {
                    std::vector<std::uint32_t> numbers;
                    for (std::uint32_t i = 0; i < 11; ++i) numbers.push_back(12 * s + i);
                    const float color[] = {0.1F * static_cast<float>(s), 0.5F, 0.9F, 0.7F};
                    const Stroke stroke{12 * s, 12, 0, 0.0F, Cap::round, s % 2 == 0 ? Cap::flat : Cap::pointed, s == 7};
                    loops.stroke(laid.tile(colors, hosted),
                                 {points.data(), &stroke, numbers.data(), static_cast<std::int64_t>(numbers.size()),
                                  100.0F, 40.0F, color, 1.0F},
                                 laid.strokes());
                    for (int y = 0; y < side; ++y)
                        for (int x = 0; x < side; ++x)
                            ASSERT_EQ(laid.cover[static_cast<std::size_t>(y * stride + x)], 0.0F) << x << " " << y;
                }
                const std::vector<float> pixels = laid.pixels();
                if (expected.empty()) expected = pixels;
                ASSERT_EQ(std::memcmp(pixels.data(), expected.data(), pixels.size() * sizeof(float)), 0)
                    << static_cast<int>(set);
            }
            EXPECT_GT(std::count_if(expected.begin(), expected.begin() + side * side, [](float t) { return t < 0.9F; }),
                      side * side / 16);
        }
    }
}

TEST(StrokeLoops, LeaveOutPartsHiddenByTheHost) {
    for (const float toward : {1.0F, -1.0F}) {
        const StrokePoint ends[] = {{0.0F, 32.5F, 3.0F, 1.0F, 0.0F, 0.2F, 1.0F, 0.0F, 1},
                                    {64.0F, 32.5F, 3.0F, 1.0F, 0.0F, 0.8F, 1.0F, 64.0F, 2}};
        const Stroke stroke{0, 2};
        const std::uint32_t first = 0;
        const float color[] = {0.0F, 0.0F, 0.0F, 1.0F};
        Laid laid;
        std::fill(laid.host.begin(), laid.host.end(), 0.503F * toward);
        output::raster_loops(base::InstructionSet::automatic)
            .stroke(laid.tile(false, true), {ends, &stroke, &first, 1, 0.0F, 0.0F, color, toward}, laid.strokes());
        for (int x = 0; x < side; ++x)
            EXPECT_EQ(laid.transmittance[static_cast<std::size_t>(32 * stride + x)],
                      (x < 32) == (toward > 0.0F) ? 0.0F : 1.0F)
                << x;
    }
}

constexpr int width = 200;
constexpr int height = 100;

// Draws strokes in pixels, in layers named "a", "b" and so on, and dots.
class StrokePicture : public ::testing::Test {
protected:
    void add_line(const char* name, const std::vector<glm::dvec2>& places, double depth, const glm::vec4& ink,
                  float radius, frame::Shape shape = frame::Shape::strokes) {
        marks::Layer& layer = set.layers.add(runtime.memory, marks::Kind::own);
        layer.name = {};
        std::memcpy(layer.name.data(), name, std::strlen(name));
        std::uint32_t along = 0;
        for (const glm::dvec2& p : places) {
            const glm::dvec3 at(p.x, -p.y, -depth);
            add_mark(layer, at, {0, 0, 1}, {1, 0, 0}, 0, along++);
            set.bounds.extend(at);
        }
        marks::index_strokes(layer);
        LayerStyle style;
        style.name = name;
        style.contours = false;
        style.shape = shape;
        style.radius = radius;
        for (int c = 0; c < 4; ++c) style.ink[c] = ink[c];
        styles.push_back(style);
    }
    static std::vector<glm::dvec2> straight(double left, double right, double y, int points) {
        std::vector<glm::dvec2> places;
        for (int i = 0; i < points; ++i) places.emplace_back(left + (right - left) * i / (points - 1), y);
        return places;
    }
    void draw() {
        set.spacing = 5.0;
        set = clustered(runtime, std::move(set));
        frame::Style style;
        style.hidden_lines = frame::HiddenLines::show;
        style.tone = frame::Tone::none;
        style.tone_curve = frame::ToneCurve::linear;
        style.tone_fade = 0.0F;
        style.layers = styles;
        const std::array items{layered_item(set, style)};
        frame.draw(items, pixel_camera(width, height));
        raster.draw(frame.drawing(), picture.image(), {});
    }
    void clear() {
        set = marks::PointSet(runtime.memory);
        styles.clear();
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    std::vector<LayerStyle> styles;
    DrawnFrame frame{runtime};
    output::Raster raster{runtime};
    Picture picture{width, height};
};

constexpr glm::vec4 black(0.0F, 0.0F, 0.0F, 1.0F);

TEST_F(StrokePicture, CoversItsWidthTimesItsLength) {
    for (const float radius : {0.2F, 0.5F, 0.8F, 1.0F, 1.7F, 4.0F, 11.3F}) {
        for (const double y : {50.0, 50.5, 50.21}) {
            for (const int points : {2, 9, 161}) {
                clear();
                add_line("a", straight(20.0, 180.0, y, points), 0.0, black, radius);
                draw();
                ASSERT_EQ(frame.drawing().strokes.size(), 1);
                const double ink = picture.darkness(40, 0, 160, height) * 120.0 * height;
                const double expected = 2.0 * static_cast<double>(radius) * 120.0;
                EXPECT_NEAR(ink, expected, 0.01 * expected) << radius << " " << y << " " << points;
                // The ends are round: half a disc each.
                const double all = picture.darkness() * width * height;
                const double ends = pi * static_cast<double>(radius * radius);
                EXPECT_NEAR(all, 2.0 * static_cast<double>(radius) * 160.0 + ends, 0.005 * expected) << radius;
            }
        }
    }
}

TEST_F(StrokePicture, IsNoDarkerWhereItsSegmentsMeet) {
    for (const float radius : {0.7F, 1.5F, 5.0F}) {
        clear();
        std::vector<glm::dvec2> zigzag; // sharp turns, and steps shorter than the stroke's width
        for (int i = 0; i < 60; ++i) zigzag.emplace_back(20.0 + 2.5 * i, i % 2 == 0 ? 45.0 : 52.0);
        add_line("a", zigzag, 0.0, {0.0F, 0.0F, 0.0F, 0.5F}, radius);
        draw();
        int darkest = 255;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) darkest = std::min(darkest, picture.at(x, y, 0));
        EXPECT_EQ(darkest, 128) << radius;
    }
    clear();
    add_line("a", straight(20.0, 180.0, 50.5, 100), 0.0, {0.0F, 0.0F, 0.0F, 0.5F}, 2.0F);
    draw();
    for (int x = 25; x < 175; ++x) ASSERT_EQ(picture.at(x, 50, 0), 128) << x;
}

TEST_F(StrokePicture, TwoStrokesAreDarkerWhereTheyCross) {
    add_line("a", straight(20.0, 180.0, 50.5, 20), 0.0, {0.0F, 0.0F, 0.0F, 0.5F}, 3.0F);
    std::vector<glm::dvec2> down;
    for (int i = 0; i < 9; ++i) down.emplace_back(100.5, 10.0 + 10.0 * i);
    add_line("b", down, 1.0, {0.0F, 0.0F, 0.0F, 0.5F}, 3.0F);
    draw();
    EXPECT_EQ(picture.at(50, 50, 0), 128);
    EXPECT_EQ(picture.at(100, 20, 0), 128);
    EXPECT_EQ(picture.at(100, 50, 0), 64);
}

// A stroke that is seen from its end is a dot.
TEST_F(StrokePicture, AStrokeOfCoincidentMarksIsADot) {
    for (const int marks_of_it : {2, 5}) {
        clear();
        add_line("a", straight(20.0, 180.0, 20.5, 9), 0.0, black, 3.0F);
        add_line("b", std::vector<glm::dvec2>(static_cast<std::size_t>(marks_of_it), {100.5, 50.5}), 1.0, black, 3.0F);
        add_line("c", straight(20.0, 180.0, 80.5, 9), 2.0, black, 3.0F);
        draw();
        ASSERT_EQ(frame.drawing().strokes.size(), 3);
        EXPECT_EQ(picture.at(100, 50, 0), 0);
        EXPECT_EQ(picture.at(100, 65, 0), 255);
        EXPECT_EQ(picture.at(100, 35, 0), 255);
        EXPECT_NEAR(picture.darkness(90, 40, 111, 61) * 21.0 * 21.0, pi * 9.0, 0.06);
    }
}

// Any of the three may be dots, in any order of depth.
TEST_F(StrokePicture, StrokesAndDotsOfColoursArePaintedFarToNear) {
    const glm::vec4 inks[] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    std::array<int, 3> place{0, 1, 2}; // the order of the depths
    do {
        for (int dotted = 0; dotted < 8; ++dotted) { // bit l: layer l is drawn as dots
            clear();
            const char* const names[] = {"a", "b", "c"};
            for (std::size_t l = 0; l < 3; ++l) {
                const bool dots = (dotted >> l & 1) != 0;
                // All cross at (100, 50).
                std::vector<glm::dvec2> places;
                for (int i = -8; i <= 8; ++i)
                    places.emplace_back(100.5 + (l == 1 ? 0.0 : 5.0 * i), 50.5 + (l == 0 ? 0.0 : 5.0 * i));
                add_line(names[l], places, 2.0 * place[l], inks[l], 4.0F,
                         dots ? frame::Shape::dots : frame::Shape::strokes);
            }
            draw();
            EXPECT_FALSE(frame.drawing().one_color);
            const auto nearest = static_cast<std::size_t>(std::find(place.begin(), place.end(), 0) - place.begin());
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(picture.at(100, 50, c), inks[nearest][c] > 0.0F ? 255 : 0)
                    << "nearest " << nearest << " " << dotted;
            // Away from the others the first layer is completely visible.
            EXPECT_EQ(picture.at(140, 50, 0), 255);
            EXPECT_EQ(picture.at(140, 50, 1), 0);
        }
    } while (std::next_permutation(place.begin(), place.end()));
}

TEST_F(StrokePicture, OneColourGivesThePictureOfManyColours) {
    for (const bool many : {false, true}) {
        clear();
        add_line("a", {{20.0, 20.0}, {90.0, 80.0}, {130.0, 30.0}, {128.0, 80.0}}, 1.0, {0.2F, 0.1F, 0.6F, 0.7F}, 2.5F);
        add_line("b", straight(10.0, 190.0, 40.0, 15), 0.0, {0.2F, 0.1F, 0.6F, 0.7F}, 3.0F, frame::Shape::dots);
        if (many) add_line("c", {{-500.0, -500.0}, {-490.0, -500.0}}, 0.0, {1, 0, 0, 1}, 1.0F);
        static std::vector<std::byte> one;
        draw();
        EXPECT_EQ(frame.drawing().one_color, !many);
        if (!many) {
            one = picture.bytes;
            continue;
        }
        for (std::size_t i = 0; i < one.size(); ++i)
            ASSERT_NEAR(std::to_integer<int>(picture.bytes[i]), std::to_integer<int>(one[i]), 1) << i;
    }
}

TEST_F(StrokePicture, OutputsGiveTheMarkAtEachEnd) {
    add_line("a", straight(20.0, 180.0, 50.5, 9), 0.0, black, 3.0F);
    draw();
    std::vector<std::uint32_t> id(width * height, 77);
    std::vector<std::uint8_t> mark_class(width * height, 77);
    output::DrawSettings settings;
    settings.id = {reinterpret_cast<std::byte*>(id.data()), width * height, 4, base::Scalar::uint32, 1};
    settings.mark_class = {reinterpret_cast<std::byte*>(mark_class.data()), width * height, 1, base::Scalar::uint8, 1};
    raster.draw(frame.drawing(), picture.image(), settings);
    for (int x = 18; x < 183; ++x) {
        const auto at = static_cast<std::size_t>(50 * width + x);
        const double along = (x + 0.5 - 20.0) / 20.0;
        if (std::abs(along - std::floor(along) - 0.5) < 0.05) continue;
        EXPECT_EQ(id[at], static_cast<std::uint32_t>(std::clamp(std::lround(along), 0L, 8L)) + 1U) << x;
        EXPECT_EQ(mark_class[at], static_cast<std::uint8_t>(drawing::MarkClass::front));
        EXPECT_EQ(id[at + 4 * width], 0U);
        EXPECT_EQ(mark_class[at + 4 * width], 0U);
    }
}

// A pick beside an end hits exactly the ink that is drawn there.
TEST(StrokeSegments, CoverTheInkOfTheirEnds) {
    const StrokePoint a{10.0F, 20.0F, 3.0F, 1.0F, 0.0F, 0.2F, 1.0F, 0.0F, 1};
    const StrokePoint b{30.0F, 20.0F, 3.0F, 1.0F, 0.0F, 0.8F, 1.0F, 20.0F, 2};
    const float tip = 30.0F + 6.0F * drawing::point_length;
    float at = 0.0F;
    for (const Cap cap : {Cap::round, Cap::flat, Cap::pointed}) {
        const drawing::SegmentEnds ends{Cap::flat, cap};
        EXPECT_TRUE(drawing::covers(ends, a, b, 25.0F, 22.5F, at));
        EXPECT_NEAR(at, 0.75F, 1e-6F);
        EXPECT_FALSE(drawing::covers(ends, a, b, 25.0F, 23.5F, at));
        EXPECT_FALSE(drawing::covers(ends, a, b, 9.5F, 20.0F, at)) << "before a flat end";
        EXPECT_EQ(drawing::covers(ends, a, b, 32.5F, 20.0F, at), cap != Cap::flat);
        EXPECT_EQ(drawing::covers(ends, a, b, tip - 0.1F, 20.0F, at), cap == Cap::pointed);
        EXPECT_FALSE(drawing::covers(ends, a, b, tip + 0.1F, 20.0F, at));
        EXPECT_FALSE(drawing::covers(ends, a, b, tip - 1.0F, 21.0F, at));
        EXPECT_GE(10.0F + drawing::reach(ends, a, b), cap == Cap::pointed ? tip - 20.0F : 13.0F);
    }
    const Stroke stroke{5, 4, 0, 0.0F, Cap::pointed, Cap::flat};
    EXPECT_EQ(drawing::ends_of(stroke, 5).begin, Cap::pointed);
    EXPECT_EQ(drawing::ends_of(stroke, 5).end, Cap::round);
    EXPECT_EQ(drawing::ends_of(stroke, 6).begin, Cap::round);
    EXPECT_EQ(drawing::ends_of(stroke, 7).end, Cap::flat);
}

} // namespace
} // namespace hrbfnpr::testing::strokes_test
