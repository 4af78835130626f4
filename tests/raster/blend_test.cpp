// SPDX-License-Identifier: MIT
// Compares discs as pixels with the plain reference: coverage, blending, paper.
#include "raster/reference.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::blend_test {
namespace {

class Blend : public ::testing::Test {
protected:
    Picture draw_marks(const Style& style, int width, int height) {
        const std::array items{item_of(set, style)};
        frame.draw(items, pixel_camera(width, height));
        Picture picture(width, height);
        raster.draw(frame.drawing(), picture.image(), {});
        return picture;
    }
    void expect_reference(const Style& style, int width, int height) {
        const Picture picture = draw_marks(style, width, height);
        const auto expected = draw_plainly(reference_discs(frame.discs()), width, height, style.paper);
        EXPECT_LE(largest_difference(picture, expected), 0.51);
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    DrawnFrame frame{runtime};
    output::Raster raster{runtime};
};

TEST_F(Blend, NoMarksLeavePaper) {
    Style style = plain_style();
    style.paper = {1.0F, 0.5F, 0.0F, 1.0F};
    const Picture picture = draw_marks(style, 70, 40);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 70; ++x) {
            ASSERT_EQ(picture.at(x, y, 0), 255);
            ASSERT_EQ(picture.at(x, y, 1), 128);
            ASSERT_EQ(picture.at(x, y, 2), 0);
            ASSERT_EQ(picture.at(x, y, 3), 255);
        }
    }
}

TEST_F(Blend, ADiscHasTheAreaOfItsCircleWhereverItsCentreLies) {
    for (const float radius : {0.5F, 0.8F, 1.0F, 1.5F, 4.0F, 12.3F}) {
        for (const glm::dvec2 centre : {glm::dvec2(20.0, 20.0), glm::dvec2(20.5, 20.5), glm::dvec2(20.3, 19.9)}) {
            set = marks::PointSet(runtime.memory);
            add_pixel_mark(set, centre.x, centre.y);
            Style style = plain_style();
            style.kind[0].radius = radius;
            const double area = draw_marks(style, 40, 40).darkness() * 1600.0;
            const double expected = pi * static_cast<double>(radius * radius);
            // The linear rim adds pi/12. Small discs are affected more by the pixel grid.
            EXPECT_NEAR(area, expected + pi / 12.0, radius < 1.4F ? 0.35 : 0.02 * expected) << radius;
        }
    }
}

TEST_F(Blend, ATinyDiscGetsPalerInsteadOfSmaller) {
    set = marks::PointSet(runtime.memory);
    add_pixel_mark(set, 20.5, 20.5);
    Style style = plain_style();
    for (const float radius : {0.5F, 0.25F, 0.1F, 1e-30F}) {
        style.kind[0].radius = radius;
        const Picture picture = draw_marks(style, 40, 40);
        const float alpha = 4.0F * radius * radius;
        EXPECT_EQ(picture.at(20, 20, 0), static_cast<int>(255.0F * (1.0F - alpha) + 0.5F));
        EXPECT_EQ(picture.at(21, 20, 0), 255); // one pixel from the disc's centre
    }
}

TEST_F(Blend, AHugeDiscCoversEverything) {
    add_pixel_mark(set, 20.0, 20.0);
    Style style = plain_style();
    for (const float radius : {1e3F, 1e6F, 1e15F, 1e30F}) {
        style.kind[0].radius = radius;
        EXPECT_EQ(draw_marks(style, 300, 200).darkness(), 1.0) << radius;
    }
}

TEST_F(Blend, LaterDiscsCoverEarlierDiscs) {
    add_pixel_mark(set, 20.5, 20.5, 1.0); // id 1, the farther one
    add_pixel_mark(set, 20.5, 20.5, 0.0);
    Style far_style = plain_style();
    far_style.kind[0].ink = {1.0F, 0.0F, 0.0F, 1.0F};
    const Picture same = draw_marks(far_style, 40, 40);
    EXPECT_EQ(same.at(20, 20, 0), 255);
    Style half = plain_style();
    half.kind[0].ink = {0.0F, 0.0F, 0.0F, 0.5F};
    EXPECT_EQ(draw_marks(half, 40, 40).at(20, 20, 0), 64); // 255 / 4, rounded
}

TEST_F(Blend, EqualsThePlainReference) {
    for (int i = 0; i < 300; ++i) {
        const auto u = base::uniform4(11, static_cast<std::uint64_t>(i), base::Purpose::candidate);
        add_pixel_mark(set, 150.0 * u[0] - 5.0, 110.0 * u[1] - 5.0, 3.0 * u[2]);
    }
    set.spacing = 6.0;
    Style style;
    style.tone = frame::Tone::none;
    style.kind[0].ink = {0.1F, 0.2F, 0.6F, 0.8F};
    for (const float radius : {0.3F, 1.7F, 9.0F}) {
        style.kind[0].radius = radius;
        for (const glm::vec4 paper : {glm::vec4(1.0F), glm::vec4(0.9F, 0.8F, 0.7F, 0.5F), glm::vec4(0.0F)}) {
            style.paper = paper;
            style.attenuation_front = 0.4;
            style.splat_overlap = 2.0F;
            expect_reference(style, 140, 100);
        }
    }
}

TEST_F(Blend, TransparentPaperErases) {
    add_pixel_mark(set, 20.5, 20.5, 5.0); // ink, and far in front of it a layer whose paper covers it
    for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) add_pixel_mark(set, 17.0 + x, 17.0 + y, 0.0);
    }
    set.spacing = 1.0;
    Style style;
    style.tone = frame::Tone::none;
    style.kind[0].radius = 2.0F;
    style.paper = glm::vec4(0.0F);
    // The near marks have no ink: all but the first mark are light.
    set.layers[0].rank[0] = 0.999F;
    for (std::int64_t i = 1; i < set.layers[0].count(); ++i) set.layers[0].rank[i] = 0.1F;
    style.kind[0].share = 0.01F;
    style.attenuation_front = 0.0;
    EXPECT_EQ(draw_marks(style, 40, 40).at(20, 20, 3), 255);
    style.attenuation_front = 1.0;
    EXPECT_EQ(draw_marks(style, 40, 40).at(20, 20, 3), 0);
    style.attenuation_front = 0.5;
    style.splat_overlap = 1.0F;
    const int left = draw_marks(style, 40, 40).at(20, 20, 3);
    EXPECT_NEAR(left, 128, 10); // one layer of opacity 0.5, from overlapping discs
}

} // namespace
} // namespace hrbfnpr::testing::blend_test
