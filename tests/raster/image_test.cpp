// SPDX-License-Identifier: MIT
// Tests the caller's image: formats, strides, viewports; depth, id and class outputs; host depth.
#include "raster/reference.h"

#include <gtest/gtest.h>

#include <cstring>

namespace hrbfnpr::testing::image_test {
namespace {

using drawing::MarkClass;
using output::DrawSettings;
using output::Format;
using output::Image;

constexpr int width = 90;
constexpr int height = 70;

class ImageTest : public ::testing::Test {
protected:
    void draw(const Style& style, const frame::Camera& camera = front_camera(width, height)) {
        const std::array items{item_of(set, style)};
        frame.draw(items, camera);
    }
    Picture draw_as(Format format) {
        Picture picture(width, height, format);
        raster.draw(frame.drawing(), picture.image(), {});
        return picture;
    }

    base::Runtime runtime;
    marks::PointSet set = sphere(runtime.memory, 3000);
    DrawnFrame frame{runtime};
    output::Raster raster{runtime};
};

TEST_F(ImageTest, FormatsDifferInOrderAndInMultiplication) {
    Style style;
    style.paper = {1.0F, 0.9F, 0.2F, 0.6F};
    style.kind[0].ink = {0.9F, 0.1F, 0.3F, 0.7F};
    draw(style);
    const Picture straight = draw_as(Format::rgba8);
    const Picture premultiplied = draw_as(Format::rgba8_premultiplied);
    const Picture bgra = draw_as(Format::bgra8);
    const Picture bgra_premultiplied = draw_as(Format::bgra8_premultiplied);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int alpha = straight.at(x, y, 3);
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(bgra.at(x, y, 2 - c), straight.at(x, y, c));
                ASSERT_EQ(bgra_premultiplied.at(x, y, 2 - c), premultiplied.at(x, y, c));
                ASSERT_NEAR(premultiplied.at(x, y, c), straight.at(x, y, c) * alpha / 255.0, 1.5);
            }
            ASSERT_EQ(bgra.at(x, y, 3), alpha);
            ASSERT_EQ(premultiplied.at(x, y, 3), alpha);
        }
    }
}

TEST_F(ImageTest, RowsMayBePaddedOrRunUpward) {
    draw(Style{});
    const Picture expected = draw_as(Format::rgba8);
    for (const std::int64_t stride :
         {std::int64_t{4 * width + 12}, std::int64_t{-4 * width}, std::int64_t{-4 * width - 8}}) {
        const std::int64_t pitch = std::abs(stride);
        std::vector<std::byte> memory(static_cast<std::size_t>(pitch * height), std::byte{0xAB});
        Image image{Format::rgba8, width, height, memory.data(), stride};
        if (stride < 0) image.pixels += pitch * (height - 1);
        raster.draw(frame.drawing(), image, {});
        for (int y = 0; y < height; ++y) {
            const std::byte* row = image.pixels + y * stride;
            ASSERT_EQ(std::memcmp(row, expected.bytes.data() + std::size_t{4} * width * static_cast<std::size_t>(y),
                                  std::size_t{4} * width),
                      0);
            for (std::int64_t k = 4 * width; k < pitch; ++k) ASSERT_EQ(row[k], std::byte{0xAB});
        }
    }
}

TEST_F(ImageTest, AViewportShiftsThePictureAndLeavesTheRestAlone) {
    draw(Style{});
    const Picture expected = draw_as(Format::rgba8);
    for (const glm::ivec2 at :
         {glm::ivec2(13, 7), glm::ivec2(-20, -31), glm::ivec2(60, 50), glm::ivec2(-500, 0), glm::ivec2(0, 5000)}) {
        frame::Camera camera = front_camera(width, height);
        camera.viewport = {at.x, at.y, width, height};
        draw(Style{}, camera);
        Picture picture(100, 80);
        std::fill(picture.bytes.begin(), picture.bytes.end(), std::byte{0x5A});
        raster.draw(frame.drawing(), picture.image(), {});
        for (int y = 0; y < 80; ++y) {
            for (int x = 0; x < 100; ++x) {
                const int u = x - at.x;
                const int v = y - at.y;
                const bool inside = u >= 0 && v >= 0 && u < width && v < height;
                for (int c = 0; c < 4; ++c)
                    ASSERT_NEAR(picture.at(x, y, c), inside ? expected.at(u, v, c) : 0x5A, inside ? 1 : 0);
            }
        }
    }
}

TEST_F(ImageTest, OverBlendsTheDrawingWithTheOldImage) {
    Style style;
    style.paper = glm::vec4(0.0F);
    style.kind[0].ink = {0.0F, 0.0F, 0.0F, 0.5F};
    draw(style);
    const Picture layer = draw_as(Format::rgba8);
    DrawSettings over;
    over.over = true;
    for (const Format format : {Format::rgba8, Format::bgra8, Format::rgba8_premultiplied}) {
        Picture picture(width, height, format);
        for (std::size_t i = 0; i < picture.bytes.size(); i += 4) {
            const std::uint8_t under[] = {100, 60, 20, 200}; // valid as a premultiplied colour, too
            std::memcpy(picture.bytes.data() + i, under, 4);
        }
        raster.draw(frame.drawing(), picture.image(), over);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double a = layer.at(x, y, 3) / 255.0; // all ink is black
                const double alpha = a + (1.0 - a) * 200.0 / 255.0;
                ASSERT_NEAR(picture.at(x, y, 3), 255.0 * alpha, 1.01);
                for (int c = 0; c < 3; ++c) {
                    const double under = c == 0 ? 100.0 : c == 1 ? 60.0 : 20.0;
                    const double expected = format == Format::rgba8_premultiplied
                                                ? (1.0 - a) * under
                                                : (1.0 - a) * under * (200.0 / 255.0) / alpha;
                    ASSERT_NEAR(picture.at(x, y, c), expected, 1.01);
                }
            }
        }
    }
}

TEST_F(ImageTest, OverAnEmptyImageGivesTheDrawingItself) {
    Style style;
    style.paper = glm::vec4(0.0F);
    draw(style);
    const Picture layer = draw_as(Format::rgba8);
    Picture picture(width, height);
    DrawSettings over;
    over.over = true;
    raster.draw(frame.drawing(), picture.image(), over);
    EXPECT_EQ(picture.bytes, layer.bytes);
}

template <class T>
base::OutView out_view(std::vector<T>& values, base::Scalar scalar) {
    return {reinterpret_cast<std::byte*>(values.data()), static_cast<std::int64_t>(values.size()),
            std::int64_t{sizeof(T)}, scalar, 1};
}

TEST_F(ImageTest, OutputsGiveTheNearestSurfaceAndTheTopmostMark) {
    set = marks::PointSet(runtime.memory);
    add_pixel_mark(set, 20.5, 20.5, 3.0);
    add_pixel_mark(set, 24.5, 20.5, 1.0);
    add_stipple(set, {60.5, -20.5, -2.0}, {1.0, 0.0, 0.0});  // silhouette
    add_stipple(set, {60.5, -50.5, -2.0}, {0.0, 0.0, -1.0}); // back: paper only
    Style style;
    style.tone = frame::Tone::none;
    style.splat_radius = 3.0F;
    style.halo_width = 1.0F;
    style.kind[0].radius = 3.0F;
    for (const auto convention : {drawing::DepthConvention::zero_to_one, drawing::DepthConvention::reversed}) {
        frame::Camera camera = pixel_camera(width, height);
        camera.depth = convention;
        camera.projection = frame::orthographic(height, width, height, 0.0, 20.0, convention);
        draw(style, camera);
        std::vector<float> depth(width * height, -7.0F);
        std::vector<std::uint32_t> id(width * height, 77);
        std::vector<std::uint8_t> mark_class(width * height, 77);
        DrawSettings settings;
        settings.depth = out_view(depth, base::Scalar::float32);
        settings.id = out_view(id, base::Scalar::uint32);
        settings.mark_class = out_view(mark_class, base::Scalar::uint8);
        Picture picture(width, height);
        raster.draw(frame.drawing(), picture.image(), settings);
        struct Expected {
            int x, y;
            double eye;
            std::uint32_t id;
            MarkClass mark_class;
        };
        const Expected table[] = {{20, 20, 13.0, 1, MarkClass::front},      {24, 20, 11.0, 2, MarkClass::front},
                                  {22, 20, 11.0, 2, MarkClass::front}, // both marks cover it
                                  {60, 20, 12.0, 3, MarkClass::silhouette}, {60, 50, 12.0, 4, MarkClass::back},
                                  {60, 54, 12.0, 4, MarkClass::back}, // the halo of mark 4
                                  {60, 55, 20.0, 0, MarkClass::none},       {0, 0, 20.0, 0, MarkClass::none}};
        for (const Expected& e : table) {
            const auto i = static_cast<std::size_t>(e.y * width + e.x);
            const double window = convention == drawing::DepthConvention::reversed ? 1.0 - e.eye / 20.0 : e.eye / 20.0;
            EXPECT_NEAR(static_cast<double>(depth[i]), window, 1e-6) << e.x << " " << e.y;
            EXPECT_EQ(id[i], e.id) << e.x << " " << e.y;
            EXPECT_EQ(mark_class[i], static_cast<std::uint8_t>(e.mark_class)) << e.x << " " << e.y;
        }
    }
}

TEST_F(ImageTest, OutputsOutsideTheViewportStayUntouched) {
    frame::Camera camera = front_camera(20, 20);
    camera.viewport.x = 10.0;
    draw(Style{}, camera);
    std::vector<std::uint32_t> mark_class(width * height, 77);
    DrawSettings settings;
    settings.mark_class = out_view(mark_class, base::Scalar::uint32);
    Picture picture(width, height);
    raster.draw(frame.drawing(), picture.image(), settings);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(mark_class[static_cast<std::size_t>(y * width + x)] == 77, x < 10 || x >= 30 || y >= 20);
    }
}

TEST_F(ImageTest, TheHostsDepthHidesMarksPixelByPixel) {
    set = marks::PointSet(runtime.memory);
    add_pixel_mark(set, 45.0, 35.0);
    Style style = plain_style();
    style.kind[0].radius = 20.0F;
    for (const auto convention : {drawing::DepthConvention::zero_to_one, drawing::DepthConvention::reversed}) {
        frame::Camera camera = pixel_camera(width, height);
        camera.depth = convention;
        camera.projection = frame::orthographic(height, width, height, 0.0, 20.0, convention);
        draw(style, camera); // the mark is halfway between near and far
        const bool reversed = convention == drawing::DepthConvention::reversed;
        std::vector<float> host(width * height);
        for (std::size_t i = 0; i < host.size(); ++i) {
            const bool left = i % width < 45;
            host[i] = left == reversed ? 0.9F : 0.1F; // the left half is near
        }
        host[35 * width + 50] = std::numeric_limits<float>::quiet_NaN(); // NaN hides nothing
        DrawSettings settings;
        settings.host_depth = {reinterpret_cast<const std::byte*>(host.data()), width * height, sizeof(float),
                               base::Scalar::float32, 1};
        std::vector<std::uint32_t> id(width * height);
        settings.id = out_view(id, base::Scalar::uint32);
        Picture picture(width, height);
        raster.draw(frame.drawing(), picture.image(), settings);
        for (int x = 27; x < 63; ++x) {
            EXPECT_EQ(picture.at(x, 35, 0), x < 45 ? 255 : 0) << x;
            EXPECT_EQ(id[static_cast<std::size_t>(35 * width + x)], x < 45 ? 0U : 1U);
        }
    }
}

TEST_F(ImageTest, AOnePixelImageIsAccepted) {
    draw(Style{}, front_camera(1, 1));
    Picture picture(1, 1);
    raster.draw(frame.drawing(), picture.image(), {});
    EXPECT_EQ(picture.at(0, 0, 3), 255);
}

} // namespace
} // namespace hrbfnpr::testing::image_test
