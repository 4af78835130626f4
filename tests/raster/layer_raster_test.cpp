// SPDX-License-Identifier: MIT
// Compares the ink of frames by layers as pixels with a plain reference in doubles.
#include "raster/reference.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hrbfnpr::testing::layer_raster_test {
namespace {

using drawing::DepthConvention;
using output::DrawSettings;
using output::Format;

constexpr int width = 200; // several tiles of 64, the last ones partial
constexpr int height = 150;
constexpr Format formats[] = {Format::rgba8, Format::bgra8, Format::rgba8_premultiplied, Format::bgra8_premultiplied};

double decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double encoded(double light) { return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055; }

// Converts straight colours to premultiplied ones and back.
struct Blender {
    bool linear = false;

    [[nodiscard]] glm::dvec4 in(const glm::dvec4& straight) const {
        glm::dvec4 c = straight;
        for (int k = 0; k < 3; ++k) c[k] = (linear ? decoded(c[k]) : c[k]) * c.w;
        return c;
    }
    [[nodiscard]] glm::dvec4 out(const glm::dvec4& light) const {
        if (!(light.w > 0.0)) return glm::dvec4(0.0);
        glm::dvec4 c = light;
        for (int k = 0; k < 3; ++k) c[k] = linear ? encoded(c[k] / c.w) : c[k] / c.w;
        return c;
    }
};

// A mark as it was added.
struct Known {
    double x, y, depth, radius;
    glm::dvec4 color;
    double window = 0.5;
};

// Returns a picture's pixel as straight RGBA.
glm::dvec4 straight_at(const Picture& picture, int x, int y) {
    glm::dvec4 c;
    for (int k = 0; k < 4; ++k) c[k] = picture.at(x, y, k) / 255.0;
    if (picture.format == Format::bgra8 || picture.format == Format::bgra8_premultiplied) std::swap(c.x, c.z);
    const bool multiplied =
        picture.format == Format::rgba8_premultiplied || picture.format == Format::bgra8_premultiplied;
    if (multiplied && c.w > 0.0) c = glm::dvec4(glm::dvec3(c) / c.w, c.w);
    return c;
}

struct Wanted {
    glm::vec4 paper{1.0F};
    Blender blender;
    const Picture* under = nullptr;           // the content before the draw
    const std::vector<float>* host = nullptr; // the host's depths; larger is farther
};

std::vector<glm::dvec4> draw_known(std::vector<Known> marks, const Wanted& wanted) {
    std::stable_sort(marks.begin(), marks.end(), [](const Known& a, const Known& b) { return a.depth > b.depth; });
    std::vector<glm::dvec4> pixels(width * height, wanted.blender.in(glm::dvec4(wanted.paper)));
    const auto edge = [](double at, int limit) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(limit)));
    };
    for (const Known& mark : marks) {
        const double radius = std::max(0.5, mark.radius);
        const double paler = std::min(1.0, mark.radius / 0.5);
        const glm::dvec4 ink = wanted.blender.in(glm::dvec4(glm::dvec3(mark.color), 1.0));
        for (int y = edge(mark.y - radius - 1.0, height); y < edge(mark.y + radius + 2.0, height); ++y) {
            for (int x = edge(mark.x - radius - 1.0, width); x < edge(mark.x + radius + 2.0, width); ++x) {
                const auto at = static_cast<std::size_t>(y * width + x);
                if (wanted.host != nullptr && static_cast<double>((*wanted.host)[at]) < mark.window) continue;
                const double distance = std::hypot(x + 0.5 - mark.x, y + 0.5 - mark.y);
                const double alpha = std::clamp(radius + 0.5 - distance, 0.0, 1.0) * mark.color.w * paler * paler;
                pixels[at] = pixels[at] * (1.0 - alpha) + ink * alpha;
            }
        }
    }
    for (int i = 0; i < width * height; ++i) {
        glm::dvec4& pixel = pixels[static_cast<std::size_t>(i)];
        if (wanted.under != nullptr)
            pixel += wanted.blender.in(straight_at(*wanted.under, i % width, i / width)) * (1.0 - pixel.w);
        pixel = wanted.blender.out(pixel);
    }
    return pixels;
}

// Returns the largest difference, in steps of 1/255 of the bytes that the format stores.
double difference(const Picture& picture, const std::vector<glm::dvec4>& expected) {
    const bool multiplied =
        picture.format == Format::rgba8_premultiplied || picture.format == Format::bgra8_premultiplied;
    const bool swapped = picture.format == Format::bgra8 || picture.format == Format::bgra8_premultiplied;
    double largest = 0.0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec4& e = expected[static_cast<std::size_t>(y * width + x)];
            for (int c = 0; c < 4; ++c) {
                const double value = multiplied && c < 3 ? e[c] * e.w : e[c];
                const double weight = multiplied || c == 3 ? 1.0 : e.w;
                const int channel = swapped && c < 3 ? 2 - c : c;
                largest = std::max(largest, weight * std::abs(picture.at(x, y, channel) - 255.0 * value));
            }
        }
    }
    return largest;
}

// Draws all marks at full size, without hiding any.
Style bare_style() {
    Style style = plain_style();
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    return style;
}

class LayerRaster : public ::testing::Test {
protected:
    // The places are anywhere, at the corners of tiles, on the image's border and beyond it.
    void add_marks(double radius, const glm::dvec4& color, int count, int lane) {
        sets.emplace_back(runtime.memory);
        Style style = bare_style();
        style.kind[0].radius = static_cast<float>(radius);
        style.kind[0].ink = glm::vec4(color);
        for (int i = 0; i < count; ++i) {
            const auto u = base::uniform4(static_cast<std::uint64_t>(lane), static_cast<std::uint64_t>(i),
                                          base::Purpose::candidate);
            double x = (width + 20.0) * u[0] - 10.0;
            double y = (height + 20.0) * u[1] - 10.0;
            if (i % 5 == 1) x = 64.0 * std::round(x / 64.0) + (u[3] - 0.5);
            if (i % 5 == 2) y = 64.0 * std::round(y / 64.0) + (u[3] - 0.5);
            if (i % 5 == 3) x = u[3] < 0.5 ? 0.0 : width;
            add_pixel_mark(sets.back(), x, y, 8.0 * u[2]);
            const float at = sets.back().layers[0].position[3 * i];
            const float down = -sets.back().layers[0].position[3 * i + 1];
            known.push_back({static_cast<double>(at), static_cast<double>(down), 8.0 * u[2],
                             static_cast<double>(style.kind[0].radius), glm::dvec4(style.kind[0].ink),
                             (10.0 + 8.0 * u[2]) / 20.0});
        }
        marks::cluster_marks(runtime, sets.back());
        styles.push_back(style);
    }
    void add_colors() {
        int lane = 20;
        for (const double radius : {0.3, 0.5, 0.8, 1.5, 3.7, 64.0}) {
            const auto u = base::uniform4(19, static_cast<std::uint64_t>(lane), base::Purpose::candidate);
            add_marks(radius, {u[0], u[1], u[2], 0.3 + 0.7 * u[3]}, radius > 60.0 ? 3 : 60, lane);
            ++lane;
        }
    }
    void add_one_color() {
        int lane = 40;
        for (const double radius : {0.3, 0.5, 0.8, 1.5, 3.7, 64.0}) {
            add_marks(radius, {0.2, 0.1, 0.7, 0.6}, radius > 60.0 ? 3 : 60, lane);
            ++lane;
        }
    }
    void draw(const glm::vec4& paper, DepthConvention convention = DepthConvention::zero_to_one) {
        std::vector<frame::Item> items;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            styles[i].paper = paper;
            items.push_back(layered_item(sets[i], styles[i]));
        }
        frame::Camera camera = pixel_camera(width, height);
        camera.depth = convention;
        camera.projection = frame::orthographic(height, width, height, 0.0, 20.0, convention);
        frame.draw(items, camera);
    }
    void expect_known(const Wanted& wanted, Format format, const char* what) {
        Picture picture(width, height, format);
        DrawSettings settings;
        settings.linear_light = wanted.blender.linear;
        if (wanted.under != nullptr) {
            settings.over = true;
            picture.bytes = wanted.under->bytes;
        }
        raster.draw(frame.drawing(), picture.image(), settings);
        EXPECT_LE(difference(picture, draw_known(known, wanted)), 0.55)
            << what << ", format " << static_cast<int>(format);
    }

    base::Runtime runtime;
    std::vector<marks::PointSet> sets;
    std::vector<Style> styles;
    std::vector<Known> known;
    DrawnFrame frame{runtime};
    output::Raster raster{runtime};
};

constexpr glm::vec4 papers[] = {{1.0F, 1.0F, 1.0F, 1.0F}, {0.9F, 0.8F, 0.5F, 0.4F}, {0.0F, 0.0F, 0.0F, 0.0F}};

TEST_F(LayerRaster, EqualsThePlainReferenceInOneColour) {
    add_one_color();
    for (const glm::vec4& paper : papers) {
        draw(paper);
        ASSERT_TRUE(frame.drawing().one_color);
        for (const Format format : formats) {
            expect_known({paper, {false}, nullptr, nullptr}, format, "encoded");
            expect_known({paper, {true}, nullptr, nullptr}, format, "linear light");
        }
    }
}

TEST_F(LayerRaster, EqualsThePlainReferenceInManyColoursFromFarToNear) {
    add_colors();
    for (const glm::vec4& paper : papers) {
        draw(paper);
        ASSERT_FALSE(frame.drawing().one_color);
        for (const Format format : formats) {
            expect_known({paper, {false}, nullptr, nullptr}, format, "encoded");
            expect_known({paper, {true}, nullptr, nullptr}, format, "linear light");
        }
    }
}

TEST_F(LayerRaster, BlendsTheDrawingWithTheOldImage) {
    add_colors();
    for (const glm::vec4& paper : papers) {
        draw(paper);
        for (const Format format : formats) {
            Picture under(width, height, format);
            for (std::size_t i = 0; i < under.bytes.size(); i += 4) {
                const auto alpha = static_cast<std::uint8_t>(i / 4 % 256);
                for (std::size_t c = 0; c < 3; ++c) // valid as a premultiplied colour, too
                    under.bytes[i + c] = static_cast<std::byte>(i * (c + 3) / 7 % (std::size_t{alpha} + 1));
                under.bytes[i + 3] = static_cast<std::byte>(alpha);
            }
            expect_known({paper, {false}, &under, nullptr}, format, "over");
            expect_known({paper, {true}, &under, nullptr}, format, "over, in linear light");
        }
    }
}

TEST_F(LayerRaster, TheHostsDepthHidesExactlyTheMarksBehindIt) {
    for (const bool many : {false, true}) {
        sets.clear();
        styles.clear();
        known.clear();
        if (many)
            add_colors();
        else
            add_one_color();
        for (const auto convention :
             {DepthConvention::negative_one_to_one, DepthConvention::zero_to_one, DepthConvention::reversed}) {
            draw(papers[1], convention);
            std::vector<float> host;   // in the camera's convention
            std::vector<float> ascend; // rising away from the eye
            for (int i = 0; i < width * height; ++i) {
                // The steps are between the marks' depths, so that rounding decides nothing.
                const float depth = 0.4503F + 0.5F * static_cast<float>(i * 37 % 101) / 101.0F;
                ascend.push_back(depth);
                host.push_back(convention == DepthConvention::reversed ? 1.0F - depth : depth);
            }
            for (const Known& mark : known) {
                for (int step = 0; step < 101; ++step)
                    ASSERT_GT(std::abs(0.4503 + 0.5 * step / 101.0 - mark.window), 1e-6) << "rounding would decide";
            }
            DrawSettings settings;
            settings.host_depth = {reinterpret_cast<const std::byte*>(host.data()), width * height, sizeof(float),
                                   base::Scalar::float32, 1};
            Picture picture(width, height);
            raster.draw(frame.drawing(), picture.image(), settings);
            const auto expected = draw_known(known, {papers[1], {false}, nullptr, &ascend});
            EXPECT_LE(difference(picture, expected), 0.55) << static_cast<int>(convention);
        }
    }
}

TEST_F(LayerRaster, DiscsDrawnOneByOneGiveThePicture) {
    // An ordinary frame: layers, halos and tone.
    const marks::PointSet ball = clustered(runtime, sphere(runtime.memory, 6000, 1.0));
    const marks::PointSet ring = clustered(runtime, torus(runtime.memory, 70));
    for (const glm::vec4& paper : papers) {
        for (const bool many : {false, true}) {
            Style style;
            style.paper = paper;
            style.kind[0].radius = 1.3F;
            style.attenuation_front = 0.3;
            style.attenuation_back = 0.2;
            style.splat_overlap = 2.0F; // makes hidden ink visible
            Style other = style;
            if (many) other.kind[0].ink = {0.1F, 0.6F, 0.2F, 0.7F};
            const std::array items{layered_item(ball, style), layered_item(ring, other)};
            frame::Camera camera = front_camera(width, height);
            camera.view = frame::look_at({3.0, 4.0, 8.0}, glm::dvec3(0.0), {0, 1, 0});
            frame.draw(items, camera);
            EXPECT_EQ(frame.drawing().one_color, !many);
            Picture picture(width, height);
            raster.draw(frame.drawing(), picture.image(), {});
            const auto discs = frame.discs();
            EXPECT_TRUE(std::any_of(discs.begin(), discs.end(),
                                    [](const Disc& d) { return d.color.w > 0.05F && d.color.w < 0.5F; }));
            EXPECT_LE(largest_difference(picture, draw_plainly(reference_discs(discs), width, height, paper)), 0.6);
        }
    }
}

// discs() and info().shown count the same ink, although parts of the torus are outside the picture.
TEST_F(LayerRaster, DiscsMatchTheCountInTheInfo) {
    const marks::PointSet ring = clustered(runtime, torus(runtime.memory, 70));
    Style style;
    style.kind[0].radius = 1.3F;
    const std::array items{layered_item(ring, style)};
    for (const double half : {0.6, 0.9, 1.25}) {
        frame::Camera camera = front_camera(width, height, half);
        camera.view = frame::look_at({3.0, 4.0, 8.0}, glm::dvec3(0.0), {0, 1, 0});
        frame.draw(items, camera);
        EXPECT_EQ(static_cast<std::int64_t>(frame.discs().size()), frame.info().shown) << half;
    }
}

TEST_F(LayerRaster, AViewportShiftsThePictureAndLeavesTheRestAlone) {
    add_colors();
    draw(papers[0]);
    Picture expected(width, height);
    raster.draw(frame.drawing(), expected.image(), {});
    for (const glm::ivec2 at : {glm::ivec2(13, 7), glm::ivec2(-20, -31), glm::ivec2(160, 120), glm::ivec2(-500, 0)}) {
        std::vector<frame::Item> items;
        for (std::size_t i = 0; i < sets.size(); ++i) items.push_back(layered_item(sets[i], styles[i]));
        frame::Camera camera = pixel_camera(width, height);
        camera.viewport = {at.x, at.y, width, height};
        frame.draw(items, camera);
        Picture picture(220, 170);
        std::fill(picture.bytes.begin(), picture.bytes.end(), std::byte{0x5A});
        raster.draw(frame.drawing(), picture.image(), {});
        for (int y = 0; y < 170; ++y) {
            for (int x = 0; x < 220; ++x) {
                const int u = x - at.x;
                const int v = y - at.y;
                const bool inside = u >= 0 && v >= 0 && u < width && v < height;
                for (int c = 0; c < 4; ++c)
                    ASSERT_NEAR(picture.at(x, y, c), inside ? expected.at(u, v, c) : 0x5A, inside ? 1 : 0);
            }
        }
    }
}

} // namespace
} // namespace hrbfnpr::testing::layer_raster_test
