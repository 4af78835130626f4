// SPDX-License-Identifier: MIT
// Inks and fields of styles, by the C interface.
#include "fixture.h"

#include <string>

namespace api_test::ink_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;

// A sphere with stipples and a field of colours: red where x < 0, blue elsewhere.
class Inks : public testing::Test {
protected:
    Inks() : model(custom_sphere(context, sphere)), renderer(make_renderer(context)) {
        Generation desc;
        desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 4000);
        set = painted(generate(context, model, desc));
        layer.ink_field = "colour";
        style.layers = &layer;
        style.layer_count = 1;
        style.palette = palette;
        style.palette_count = 2;
        EXPECT_OK(hrbfnpr_item_init(&item, sizeof item));
        item.point_set = set.get();
        item.style = &style;
    }
    PointSet painted(const PointSet& base) {
        const std::vector<double> points{-1, 0, 0, 1, 0, 0};
        const std::vector<double> colours{0.8, 0.1, 0.1, 0.1, 0.1, 0.8};
        auto desc = made(hrbfnpr_field_desc_init);
        desc.kind = HRBFNPR_FIELD_KIND_COLOUR;
        desc.points = in(points);
        desc.values = in(colours);
        hrbfnpr_field* field = nullptr;
        EXPECT_OK(hrbfnpr_field_create(context.get(), &desc, nullptr, &field, error));
        auto named = made(hrbfnpr_mark_field_init);
        named.name = "colour";
        named.field = field;
        hrbfnpr_point_set* made_set = nullptr;
        EXPECT_OK(hrbfnpr_point_set_with_fields(context.get(), base.get(), &named, 1, 0, nullptr, &made_set, error));
        hrbfnpr_field_release(field);
        PointSet to;
        to.reset(made_set);
        return to;
    }
    void refused(const char* part) {
        Drawing drawing;
        EXPECT_FAILS(try_to_draw(renderer, item, camera, drawing, error), invalid, part);
    }
    static std::int32_t append(void* user, const void* data, std::uint64_t size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
        return 0;
    }
    std::string page_of(const Drawing& drawing, std::uint32_t format) {
        auto placement = made(hrbfnpr_page_item_init);
        placement.drawing = drawing.get();
        auto desc = made(hrbfnpr_page_desc_init);
        desc.items = &placement;
        desc.item_count = 1;
        desc.format = format;
        std::string text;
        EXPECT_OK(hrbfnpr_page_write(context.get(), &desc, append, &text, nullptr, nullptr, error));
        return text;
    }
    hrbfnpr_drawing_layer_info layer_of(const Drawing& drawing, std::int64_t number) {
        auto info = made(hrbfnpr_drawing_layer_info_init);
        EXPECT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), number, &info, error));
        return info;
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    Renderer renderer;
    PointSet set;
    float palette[8] = {1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.5F};
    hrbfnpr_layer_style layer = made(hrbfnpr_layer_style_init);
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_item item{};
    hrbfnpr_camera camera = front_camera(400);
};

TEST_F(Inks, AreLayersOfTheDrawing) {
    const Drawing drawing = draw_item(renderer, item, camera);
    const hrbfnpr_drawing_info info = info_of(drawing);
    ASSERT_EQ(info.layers, 3);
    std::int64_t dots = 0;
    for (std::int32_t i = 0; i < 3; ++i) {
        const hrbfnpr_drawing_layer_info ink = layer_of(drawing, i);
        EXPECT_EQ(ink.ink_number, i - 1);
        EXPECT_STREQ(ink.name, "stipples");
        EXPECT_EQ(ink.layer, 0);
        EXPECT_EQ(ink.dots > 100, i > 0);
        dots += ink.dots;
        EXPECT_EQ(ink.ink[3], i == 2 ? 0.5F : 1.0F);
    }
    EXPECT_EQ(dots, info.dots);
}

TEST_F(Inks, HaveGroupsAndPensOfTheirOwn) {
    const Drawing drawing = draw_item(renderer, item, camera);
    const std::string svg = page_of(drawing, HRBFNPR_PAGE_FORMAT_SVG);
    EXPECT_NE(svg.find("\"stipples ink 1\""), std::string::npos);
    EXPECT_NE(svg.find("\"stipples ink 2\""), std::string::npos);
    EXPECT_EQ(svg.find("run 2"), std::string::npos) << "inks of a layer are not sorted from far to near";
    const std::string plot = page_of(drawing, HRBFNPR_PAGE_FORMAT_HPGL);
    EXPECT_EQ(plot.find("SP1;"), std::string::npos);
    EXPECT_NE(plot.find("SP2;"), std::string::npos);
    EXPECT_NE(plot.find("SP3;"), std::string::npos);
}

TEST_F(Inks, DoNotChangeWhichMarksAreDrawn) {
    const std::vector<std::uint8_t> colours = rasterize(draw_item(renderer, item, camera), 400);
    const std::int64_t shown = info_of(draw_item(renderer, item, camera)).shown;
    layer.ink_field = nullptr;
    EXPECT_EQ(info_of(draw_item(renderer, item, camera)).shown, shown);
    EXPECT_NE(rasterize(draw_item(renderer, item, camera), 400), colours);
}

TEST_F(Inks, PicturesAreTheSameForAnyNumberOfThreads) {
    layer.palette_rule = HRBFNPR_PALETTE_MIXED;
    const std::vector<std::uint8_t> one = rasterize(draw_item(renderer, item, camera), 400);
    const Context other = make_context(4);
    const Renderer more = make_renderer(other);
    EXPECT_EQ(rasterize(draw_item(more, item, camera), 400), one);
}

TEST_F(Inks, BadPalettesAreRefused) {
    style.palette_count = 9;
    refused("items[0].style.palette_count is 9; it must be from 0 to 8");
    style.palette_count = 2;
    style.palette = nullptr;
    refused("items[0].style.palette is NULL");
    style.palette = palette;
    palette[5] = 1.5F;
    refused("items[0].style.palette[5] is 1.5; it must be from 0 to 1");
    style.palette_count = 0;
    refused("layers[0].ink_field is given, but items[0].style.palette has no inks");
}

TEST_F(Inks, UnknownFieldsAreRefused) {
    layer.ink_field = "paint";
    refused("items[0].style: ink_field of the layer \"stipples\" is \"paint\", which is no field");
    layer.ink_field = nullptr;
    layer.tone_field = "colour";
    refused("tone_field of the layer \"stipples\" is \"colour\", a field of kind COLOUR");
    style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    draw_item(renderer, item, camera);
}

} // namespace
} // namespace api_test::ink_test
