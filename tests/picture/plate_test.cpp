// SPDX-License-Identifier: MIT
#include "picture/plate.h"

#include "picture/lettering.h"
#include "picture/look.h"
#include "picture/tuning_lines.h"
#include "planned_call.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace picture_tests::plate_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

using Pixels = std::vector<std::uint8_t>;
constexpr std::int32_t width = 240;
constexpr std::int32_t height = 200;

// Draws a plate of a sphere, seen without perspective.
class PlateTest : public testing::Test {
protected:
    PlateTest() : planned(HRBFNPR_PRESET_ARCHAEOLOGICAL) {
        const test::Samples samples = test::sphere(200);
        auto fit = picture::defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        model = make<picture::Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(planned.context.get(), &fit, nullptr, made, error);
        });
        auto layer = picture::defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
        layer.budget = 1000;
        auto desc = picture::defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
        desc.layers = &layer;
        desc.layer_count = 1;
        marks = make<PointSet>([&](hrbfnpr_point_set** made, hrbfnpr_error* error) {
            return hrbfnpr_point_set_generate(planned.context.get(), model.get(), &desc, nullptr, made, error);
        });
        const glm::dvec3 eye(0, 0, 9);
        const glm::dvec3 target(0.0);
        const glm::dvec3 up(0, 1, 0);
        test_call(
            [&](hrbfnpr_error* error) { return hrbfnpr_camera_look_at(&camera, &eye[0], &target[0], &up[0], error); });
        test_call([&](hrbfnpr_error* error) {
            return hrbfnpr_camera_orthographic(&camera, 2.5, width, height, 1.0, 20.0, error);
        });
        draw();
    }
    template <class F>
    static void test_call(F&& f) {
        picture::call(f);
    }
    void draw() {
        Surface surface;
        surface.model = model;
        const Call call = planned.call();
        lines =
            make_lines(call, surface, style, parse_lines("contour", pool), section_lines(call, model, camera), false);
        const auto renderer = make<Renderer>([&](hrbfnpr_renderer** made, hrbfnpr_error* error) {
            return hrbfnpr_renderer_create(planned.context.get(), made, error);
        });
        const hrbfnpr_style view = style.view();
        auto item = picture::defaults<hrbfnpr_item>(hrbfnpr_item_init);
        item.point_set = marks.get();
        item.style = &view;
        item.line_set = lines.get();
        drawing = make<Drawing>([&](hrbfnpr_drawing** made, hrbfnpr_error* error) {
            return hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, made, error);
        });
    }
    [[nodiscard]] Plate plate(const char* unit) const { return {model, marks, lines, camera, style, unit}; }
    [[nodiscard]] static hrbfnpr_image image_of(Pixels& pixels, std::uint32_t format, glm::ivec2 size) {
        const bool has_floats = format == HRBFNPR_FORMAT_RGBA32F || format == HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED;
        const int bytes = format == HRBFNPR_FORMAT_COVERAGE8 ? 1 : has_floats ? 16 : 4;
        pixels.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y * bytes), 77);
        auto image = picture::defaults<hrbfnpr_image>(hrbfnpr_image_init);
        image.format = format;
        image.width = size.x;
        image.height = size.y;
        image.pixels = pixels.data();
        return image;
    }
    [[nodiscard]] Pixels rasterized(const char* unit, std::uint32_t format = HRBFNPR_FORMAT_RGBA8) {
        Pixels pixels;
        const Plate of = plate(unit);
        rasterize_plate(*planned.context.get(), of, drawing, image_of(pixels, format, plate_size(of, pool)), pool);
        return pixels;
    }

    PlannedCall planned;
    Pool& pool = planned.pool;
    picture::Style style{HRBFNPR_PRESET_ARCHAEOLOGICAL, pool};
    picture::Model model;
    PointSet marks;
    LineSet lines;
    Drawing drawing;
    hrbfnpr_camera camera = picture::defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
};

TEST_F(PlateTest, ArchaeologicalFindsGetASectionAndABarByDefault) {
    const auto wants = [&](std::uint32_t preset, std::uint32_t profile, const char* bar) {
        planned.desc.preset = preset;
        planned.desc.profile = profile;
        planned.desc.scale_bar = bar;
        const Call call = planned.call();
        const String unit = unit_of_bar(call.options, pool);
        EXPECT_EQ(is_plate(call.options), has_section(call.options) || !unit.empty());
        return (has_section(call.options) ? "section " : " ") + std::string(unit);
    };
    EXPECT_EQ(wants(HRBFNPR_PRESET_ARCHAEOLOGICAL, HRBFNPR_PROFILE_AUTO, nullptr), "section units");
    EXPECT_EQ(wants(HRBFNPR_PRESET_ARCHAEOLOGICAL, HRBFNPR_PROFILE_NO, "none"), " ");
    EXPECT_EQ(wants(HRBFNPR_PRESET_STIPPLE, HRBFNPR_PROFILE_AUTO, nullptr), " ");
    EXPECT_EQ(wants(HRBFNPR_PRESET_STIPPLE, HRBFNPR_PROFILE_YES, "cm"), "section cm");
    EXPECT_EQ(wants(HRBFNPR_PRESET_STIPPLE, HRBFNPR_PROFILE_AUTO, ""), " ");
}

TEST(BarLength, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_EQ(bar_length(1.0), 1.0);
    EXPECT_EQ(bar_length(1.99), 1.0);
    EXPECT_EQ(bar_length(2.0), 2.0);
    EXPECT_EQ(bar_length(49.0), 20.0);
    EXPECT_EQ(bar_length(0.07), 0.05);
    EXPECT_EQ(bar_length(1e9), 1e9);
    for (const double none :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(bar_length(none), 0.0);
}

TEST_F(PlateTest, TheSectionIsAHatchedDiscAtTheScaleOfTheDrawing) {
    const glm::ivec2 size = plate_size(plate(""), pool);
    const double scale = height / 2.5;                           // The sphere's radius in pixels.
    EXPECT_NEAR(size.x, width + 2.0 * scale + 0.1 * width, 8.0); // The marks near the plane set the width.
    EXPECT_EQ(size.y, height);
    const Pixels pixels = rasterized("");
    const auto darkness = [&](int x, int y) { return 255 - pixels[static_cast<std::size_t>(4 * (y * size.x + x))]; };
    const double middle = 0.5 * (width + size.x);
    double ink = 0.0;
    double outside = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = width; x < size.x; ++x) {
            const double radius = std::hypot(x + 0.5 - middle, y + 0.5 - 0.5 * height);
            if (radius < scale - 8.0) ink += darkness(x, y) / 255.0;
            if (radius > scale + 8.0) outside += darkness(x, y) / 255.0;
        }
    // As in print, ink covers 0.7 of each 9 pixels. Antialiasing makes lines that are narrower than a pixel slightly
    // darker.
    const double area = std::numbers::pi * (scale - 8.0) * (scale - 8.0);
    EXPECT_NEAR(ink / area, 0.7 / 9.0, 0.2 * 0.7 / 9.0);
    EXPECT_EQ(outside, 0.0);
}

TEST_F(PlateTest, TheDrawingIsUnchangedAtTheLeft) {
    const glm::ivec2 size = plate_size(plate("cm"), pool);
    EXPECT_EQ(size.y, height + 44); // The strip has its least height.
    const Pixels pixels = rasterized("cm");
    Pixels alone;
    const hrbfnpr_image image = image_of(alone, HRBFNPR_FORMAT_RGBA8, {width, height});
    test_call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error); });
    for (int y = 0; y < height; ++y)
        EXPECT_TRUE(std::equal(alone.begin() + 4 * width * y, alone.begin() + 4 * width * (y + 1),
                               pixels.begin() + 4 * size.x * y));
    // The bar of 0.5 units in 2.5 is 40 of the 200 pixels long and has five fields.
    const auto is_dark = [&](int x, int y) { return pixels[static_cast<std::size_t>(4 * (y * size.x + x))] < 128; };
    const int y = height + 44 / 3 + 2;
    int dark = 0;
    for (int x = 0; x < size.x; ++x) dark += is_dark(x, y) ? 1 : 0;
    EXPECT_NEAR(dark, 24 + 4, 4);
    EXPECT_TRUE(is_dark(width / 2, y));
    EXPECT_FALSE(is_dark(width / 2 + 8, y));
}

TEST_F(PlateTest, AllFormatsHaveTheSamePicture) {
    const Pixels rgba = rasterized("cm");
    const Pixels bgra = rasterized("cm", HRBFNPR_FORMAT_BGRA8);
    const Pixels premultiplied = rasterized("cm", HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED);
    const Pixels coverage = rasterized("cm", HRBFNPR_FORMAT_COVERAGE8);
    const Pixels floats = rasterized("cm", HRBFNPR_FORMAT_RGBA32F);
    ASSERT_EQ(rgba.size(), 4 * coverage.size());
    EXPECT_EQ(rgba, premultiplied); // They are equal on opaque paper.
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        EXPECT_EQ(rgba[4 * i], bgra[4 * i + 2]);
        EXPECT_NEAR(255 - rgba[4 * i], coverage[i], 2); // The ink is black on white.
        float red = 0.0F;
        std::memcpy(&red, floats.data() + 16 * i, sizeof red);
        EXPECT_NEAR(255.0F * red, rgba[4 * i], 1.0F);
    }
}

TEST_F(PlateTest, ASmallerOrLargerImageIsAccepted) {
    const Pixels whole = rasterized("cm");
    const glm::ivec2 size = plate_size(plate("cm"), pool);
    Pixels pixels;
    rasterize_plate(*planned.context.get(), plate("cm"), drawing,
                    image_of(pixels, HRBFNPR_FORMAT_RGBA8, {width + 20, 30}), pool);
    for (int y = 0; y < 30; ++y)
        EXPECT_TRUE(std::equal(pixels.begin() + 4 * (width + 20) * y, pixels.begin() + 4 * (width + 20) * (y + 1),
                               whole.begin() + 4 * size.x * y));
    rasterize_plate(*planned.context.get(), plate("cm"), drawing, image_of(pixels, HRBFNPR_FORMAT_RGBA8, size + 1),
                    pool);
    EXPECT_EQ(pixels.back(), 77); // The rest of the image is not touched.
    EXPECT_TRUE(std::equal(whole.begin(), whole.begin() + 4 * size.x, pixels.begin()));
    auto bad = image_of(pixels, HRBFNPR_FORMAT_RGBA8, size);
    bad.format = 9;
    EXPECT_THROW(rasterize_plate(*planned.context.get(), plate("cm"), drawing, bad, pool), Error);
}

TEST_F(PlateTest, TransparentPaperStaysTransparentWithAHatchedSection) {
    const Pixels opaque = rasterized("cm");
    style.base.paper[3] = 0.0F;
    draw();
    const Pixels clear = rasterized("cm");
    ASSERT_EQ(clear.size(), opaque.size());
    std::int64_t off = 0;
    for (std::size_t i = 0; i < clear.size(); i += 4)
        if (std::abs(clear[i + 3] - (255 - opaque[i])) > 2) ++off;
    EXPECT_LT(off, static_cast<std::int64_t>(clear.size()) / 4 / 200); // Lines of the drawing overlap in a few pixels.
}

TEST_F(PlateTest, APageHasTheSameContent) {
    const PageContent page = plate_page(*planned.context.get(), plate("cm"), drawing, pool);
    ASSERT_EQ(page.drawings.size(), 2U);
    EXPECT_STREQ(page.drawings[0].name, "view");
    EXPECT_STREQ(page.drawings[1].name, "profile");
    EXPECT_EQ(page.drawings[1].corner, glm::dvec2(width, 0.0));
    EXPECT_EQ(page.size, glm::dvec2(plate_size(plate("cm"), pool)));
    double hatching = 0.0;
    std::vector<const PageNote*> bar;
    for (const PageNote& note : page.notes) {
        if (std::string_view(note.group) == "section hatching")
            hatching += glm::length(note.points[1] - note.points[0]);
        else
            bar.push_back(&note);
    }
    const double scale = height / 2.5;
    EXPECT_NEAR(hatching * 9.0, std::numbers::pi * scale * scale, 0.02 * std::numbers::pi * scale * scale);
    ASSERT_EQ(bar.size(), 6U);
    EXPECT_NEAR(bar[0]->points[1].x - bar[0]->points[0].x, 0.5 * scale, 1e-9);
    EXPECT_EQ(bar[4]->text, "0");
    EXPECT_EQ(bar[5]->text, "0.5 cm");
    EXPECT_EQ(plate_page(*planned.context.get(), plate(""), drawing, pool).notes.size(), page.notes.size() - 6);
}

TEST(Lettering, LettersStandOnTheLineAndOthersAreBoxes) {
    base::Memory memory;
    Pool pool(memory);
    const double radius = text_stroke_radius(80.0);
    for (char c = '!'; c <= '~'; ++c) {
        const std::string_view text(&c, 1);
        for (const Segment& stroke : strokes_of_text(text, {100.0, 200.0}, 80.0, pool))
            for (const glm::dvec2& point : stroke) {
                EXPECT_GE(point.x - radius, 100.0) << c;
                EXPECT_LE(point.x + radius, 100.0 + width_of_text(text, 80.0)) << c;
                EXPECT_GE(point.y - radius, 120.0 - 1e-9) << c;
                EXPECT_LE(point.y + radius, 220.0) << c; // Some small letters reach below the baseline.
            }
    }
    const auto micro = strokes_of_text("\xc2\xb5", {0, 0}, 10.0, pool);
    EXPECT_EQ(micro, strokes_of_text("\xce\xbc", {0, 0}, 10.0, pool));
    const auto box = strokes_of_text("\xc3\xa9", {0, 0}, 10.0, pool);
    EXPECT_EQ(box.size(), 4U);
    for (const char* const text : {"\xff", "\xc3", "\xe2\x82", "\xf0\x9f\x98\x80"})
        EXPECT_EQ(strokes_of_text(text, {0, 0}, 10.0, pool), box);
    EXPECT_EQ(width_of_text("20", 10.0), 2.0 * width_of_text("0", 10.0));
    EXPECT_EQ(width_of_text("", 10.0), 0.0);
}

} // namespace
} // namespace picture_tests::plate_test
