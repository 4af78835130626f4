// SPDX-License-Identifier: MIT
// Compares pixels of floats and of coverage with those of bytes.
#include "raster/reference.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::formats_test {
namespace {

using output::DrawSettings;
using output::Format;

constexpr int width = 150; // a few tiles in both directions
constexpr int height = 110;

double decoded(double e) { return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4); }
double encoded(double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055; }

struct Case {
    bool published, many, over, linear;
};

class Formats : public ::testing::TestWithParam<Case> {
protected:
    Formats() { settings.linear_light = GetParam().linear; }

    void draw(const glm::vec4& paper) {
        Style style;
        style.paper = paper;
        style.attenuation_front = 0.4;
        style.splat_overlap = 2.0F;
        style.kind[0].radius = 1.6F;
        style.kind[0].ink = {0.2F, 0.5F, 0.1F, 0.8F};
        style.silhouette_ink = style.kind[0].ink;
        Style other = style;
        if (GetParam().many) other.kind[0].ink = other.silhouette_ink = {0.9F, 0.1F, 0.3F, 0.9F};
        const auto item = [&](const Style& its, const glm::dmat4& transform) {
            return GetParam().published ? item_of(set, its, transform) : layered_item(set, its, transform);
        };
        const std::array items{item(style, glm::dmat4(1.0)), item(other, glm::dmat4(glm::dmat3(0.5)))};
        frame::Camera camera = front_camera(width, height, 1.5);
        camera.view = frame::look_at({0.0, -8.0, 5.0}, glm::dvec3(0.0), {0, 0, 1});
        frame.draw(items, camera);
        if (!GetParam().published) {
            EXPECT_EQ(frame.drawing().one_color, !GetParam().many);
        }
    }
    Picture draw_as(Format format, bool over = false) {
        Picture picture(width, height, format);
        DrawSettings own = settings;
        own.over = over;
        for (int i = 0; i < width * height && over; ++i) under(picture, i);
        raster.draw(frame.drawing(), picture.image(), own);
        return picture;
    }
    // The content before the draw in straight RGBA bytes. under() writes it in the picture's format.
    static std::array<int, 4> before(int i) { return {i % 256, i * 7 / 3 % 256, i * 3 % 256, i * 11 % 256}; }
    static void under(Picture& picture, int i) {
        const std::array<int, 4> straight = before(i);
        std::byte* const pixel = picture.bytes.data() + output::bytes_of_pixel(picture.format) * i;
        if (picture.format == Format::coverage8) {
            *pixel = static_cast<std::byte>(straight[3]);
            return;
        }
        for (std::size_t c = 0; c < 4; ++c) {
            auto value = static_cast<float>(straight[c]) / 255.0F;
            if (picture.format == Format::rgba32f_premultiplied && c < 3)
                value *= static_cast<float>(straight[3]) / 255.0F;
            if (picture.format == Format::rgba8)
                pixel[c] = static_cast<std::byte>(straight[c]);
            else
                std::memcpy(pixel + 4 * c, &value, sizeof value);
        }
    }

    base::Runtime runtime;
    marks::PointSet set = clustered(runtime, torus(runtime.memory, 70));
    DrawnFrame frame{runtime};
    output::Raster raster{runtime};
    DrawSettings settings;
};

constexpr glm::vec4 papers[] = {{1.0F, 1.0F, 1.0F, 1.0F}, {0.9F, 0.8F, 0.3F, 0.5F}, {0.0F, 0.0F, 0.0F, 0.0F}};

TEST_P(Formats, FloatsRoundToTheBytes) {
    for (const glm::vec4& paper : papers) {
        draw(paper);
        const Picture bytes = draw_as(Format::rgba8, GetParam().over);
        const Picture floats = draw_as(Format::rgba32f, GetParam().over);
        int between = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                for (int c = 0; c < 4; ++c) {
                    ASSERT_NEAR(floats.value(x, y, c), bytes.value(x, y, c), 0.503F / 255.0F) << x << " " << y;
                    const float steps = 255.0F * floats.value(x, y, c);
                    between += std::abs(steps - std::round(steps)) > 0.1F;
                }
            }
        }
        EXPECT_GT(between, 500) << "no finer than bytes";
    }
}

TEST_P(Formats, PremultipliedFloatsAreStraightFloatsTimesAlpha) {
    for (const glm::vec4& paper : papers) {
        draw(paper);
        const Picture straight = draw_as(Format::rgba32f, GetParam().over);
        const Picture premultiplied = draw_as(Format::rgba32f_premultiplied, GetParam().over);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float alpha = straight.value(x, y, 3);
                ASSERT_NEAR(premultiplied.value(x, y, 3), alpha, 1e-6F);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(premultiplied.value(x, y, c), straight.value(x, y, c) * alpha, 2e-6F)
                        << x << " " << y << " " << c;
            }
        }
    }
}

// "Over" gives the drawing on transparent paper, blended with the old content by the plain formula.
TEST_P(Formats, OverFollowsThePlainBlendFormula) {
    if (!GetParam().over) return;
    draw(papers[2]);
    const Picture layer = draw_as(Format::rgba32f_premultiplied);
    const Picture over = draw_as(Format::rgba32f, true);
    const bool linear = GetParam().linear;
    const auto light = [&](double c) { return linear ? decoded(c) : c; };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::array<int, 4> was = before(y * width + x);
            const double own = static_cast<double>(layer.value(x, y, 3));
            const double old = was[3] / 255.0;
            const double alpha = own + (1.0 - own) * old;
            ASSERT_NEAR(static_cast<double>(over.value(x, y, 3)), alpha, 1e-5);
            if (alpha < 0.01) continue;
            for (int c = 0; c < 3; ++c) {
                const double top = own > 0.0 ? light(static_cast<double>(layer.value(x, y, c)) / own) * own : 0.0;
                const double sum = top + (1.0 - own) * old * light(was[static_cast<std::size_t>(c)] / 255.0);
                ASSERT_NEAR(static_cast<double>(over.value(x, y, c)), linear ? encoded(sum / alpha) : sum / alpha, 5e-4)
                    << x << " " << y << " " << c;
            }
        }
    }
}

// Coverage is the amount of ink, for any paper and in linear light, too.
TEST_P(Formats, CoverageIsTheAlphaOfTheDrawingOnTransparentPaper) {
    draw(papers[2]);
    const Picture layer = draw_as(Format::rgba32f);
    for (const glm::vec4& paper : papers) {
        draw(paper);
        const Picture coverage = draw_as(Format::coverage8, GetParam().over);
        int inked = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float own = layer.value(x, y, 3);
                const float old = GetParam().over ? static_cast<float>(before(y * width + x)[3]) / 255.0F : 0.0F;
                ASSERT_NEAR(coverage.value(x, y, 0), own + (1.0F - own) * old, 0.51F / 255.0F) << x << " " << y;
                inked += own > 0.1F;
            }
        }
        EXPECT_GT(inked, 1000);
    }
}

TEST_P(Formats, RowsMayBePadded) {
    draw(papers[1]);
    for (const Format format : {Format::coverage8, Format::rgba32f}) {
        const Picture expected = draw_as(format);
        const std::int64_t row = output::bytes_of_pixel(format) * width;
        for (const std::int64_t stride : {row + 16, -row - 32}) {
            const std::int64_t pitch = std::abs(stride);
            std::vector<std::byte> memory(static_cast<std::size_t>(pitch * height), std::byte{0xAB});
            output::Image image{format, width, height, memory.data(), stride};
            if (stride < 0) image.pixels += pitch * (height - 1);
            raster.draw(frame.drawing(), image, settings);
            for (int y = 0; y < height; ++y) {
                const std::byte* const at = image.pixels + y * stride;
                ASSERT_EQ(std::memcmp(at, expected.bytes.data() + row * y, static_cast<std::size_t>(row)), 0);
                for (std::int64_t k = row; k < pitch; ++k) ASSERT_EQ(at[k], std::byte{0xAB});
            }
        }
    }
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (int bits = 0; bits < 16; ++bits)
        all.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0});
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Formats, ::testing::ValuesIn(cases()), [](const auto& one) {
    const Case& c = one.param;
    return std::string(c.published ? "published" : "layers") + (c.many ? "_colours" : "_colour") +
           (c.over ? "_over" : "") + (c.linear ? "_linear" : "");
});

} // namespace
} // namespace hrbfnpr::testing::formats_test
