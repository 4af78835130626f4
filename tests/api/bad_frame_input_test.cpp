// SPDX-License-Identifier: MIT
// The table of bad inputs, second half: generating and drawing.
#include "fixture.h"

#include <functional>
#include <limits>

namespace api_test::bad_frame_input_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr float nanf = std::numeric_limits<float>::quiet_NaN();

template <class T>
struct Row {
    std::function<void(T&)> change;
    const char* message;
};
TEST(BadInput, IsRefusedByGenerate) {
    using Desc = Generation;
    static const std::vector<double> bad_point{0, 0, nan};
    static const std::vector<double> far_point{1e3, 1e3, 1e3};
    const std::vector<Row<Desc>> rows = {
        {[](Desc& d) { d.box_resolution = 0; }, "generate_desc.box_resolution is 0; it must be from 1 to 256"},
        {[](Desc& d) { d.seed_source = HRBFNPR_SEED_POINTS; }, "generate_desc.seed_points is empty"},
        {[](Desc& d) { d.seed_source = HRBFNPR_SEED_SAMPLES; }, "seed_source is SAMPLES, which needs a model"},
        {[](Desc& d) {
             d.seed_source = HRBFNPR_SEED_POINTS;
             d.seed_points = in(bad_point);
         },
         "seed_points[0] is not finite; remove it"},
        {[](Desc& d) { d.seed_points.count = -4; }, "generate_desc.seed_points.count is -4"},
        {[](Desc& d) { d.shared_budget = -1; }, "generate_desc.shared_budget is -1"},
        {[](Desc& d) { d.layer_stride = -8; }, "generate_desc.layer_stride is -8"},
        {[](Desc& d) { d.layer[1].struct_size = 3; }, "generate_desc.layers[1].struct_size is 3"},
        {[](Desc& d) { d.layer[0].kind = HRBFNPR_LAYER_KIND_ANY; }, "generate_desc.layers[0].kind is 0"},
        {[](Desc& d) { d.layer[2].kind = HRBFNPR_LAYER_KIND_OWN; }, "generate_desc.layers[2].kind is 3"},
        {[](Desc& d) { d.layer[0].name = ""; }, "generate_desc.layers[0].name has no bytes"},
        {[](Desc& d) { d.layer[0].name = "0123456789012345678901234567890123456789012345678901234567890123"; },
         "generate_desc.layers[0].name has 64 or more bytes"},
        {[](Desc& d) { d.layer[0].name = "\xff"; }, "generate_desc.layers[0].name is not UTF-8; encode it as UTF-8"},
        {[](Desc& d) { d.layer[0].tone_begin = 0.5F; }, "generate_desc.layers[0].tone_begin is 0.5 and"},
        {[](Desc& d) { d.layer[0].levels = 13; }, "generate_desc.layers[0].levels is 13; it must be from -1 to 12"},
        {[](Desc& d) { d.layer[1].levels = -2; }, "generate_desc.layers[1].levels is -2"},
        {[](Desc& d) { d.layer[2].budget = -1; }, "generate_desc.layers[2].budget is -1"},
        {[](Desc& d) { d.layer[0].budget = 0; }, "generate_desc.layers[0].budget is 0; with BLUE_NOISE"},
        {[](Desc& d) { d.layer[0].density = HRBFNPR_DENSITY_CALLBACK; },
         "generate_desc.layers[0].density_function is NULL"},
        {[](Desc& d) { d.layer[1].separation = -1; }, "generate_desc.layers[1].separation is -1"},
        {[](Desc& d) { d.layer[1].separation = 1e-9, d.layer[1].budget = 0; }, "more than 100000000; use larger ones"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
             d.layer[2].guide = HRBFNPR_HATCH_GUIDE_LIGHT;
         },
         "generate_desc.layers[2].guide is 3; PUBLISHED strokes follow CURVATURE (0), COMBING (1)"},
        {[](Desc& d) { d.layer[1].start = 2; }, "generate_desc.layers[1].start is 2"},
        {[](Desc& d) { d.layer[1].start = 1; }, "generate_desc.layers[1].start is STIPPLES; only PUBLISHED strokes"},
        {[](Desc& d) { d.layer[0].start = 1; }, "generate_desc.layers[0].start is STIPPLES"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
             d.layer[0].start = 1;
         },
         "generate_desc.layers[0].start is STIPPLES, but the layer"},
        {[](Desc& d) { d.layer[2].start_level = 13; }, "generate_desc.layers[2].start_level is 13"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
             d.layer[2].start = 1;
             d.layer[2].start_level = 3;
         },
         "generate_desc.layers[2].start_level is 3; it must be at most 2, the levels of the stipples"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
             d.layer[0].levels = 12;
             d.layer[0].budget = 0;
         },
         "layers[0].levels is 12, which would grow to"}};
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const std::int64_t before = info_of(context).bytes_now;
    for (const auto& row : rows) {
        Error error;
        Generation desc = small_desc();
        row.change(desc);
        auto* set = reinterpret_cast<hrbfnpr_point_set*>(&desc);
        const bool is_size = std::string(row.message).find("struct_size") != std::string::npos;
        EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                     is_size ? HRBFNPR_STATUS_UNSUPPORTED_STRUCT : invalid, row.message);
        EXPECT_EQ(set, nullptr) << row.message;
    }
    Error error;
    Generation desc = small_desc();
    desc.seed_source = HRBFNPR_SEED_POINTS;
    desc.seed_points = in(far_point);
    hrbfnpr_point_set* set = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                 HRBFNPR_STATUS_NOT_CONVERGED, "none of 1 seeds reached the surface");
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), nullptr, desc.get(), nullptr, &set, error), invalid,
                 "model is NULL");
    EXPECT_FAILS(hrbfnpr_point_set_generate(nullptr, model.get(), desc.get(), nullptr, &set, error), invalid,
                 "context is NULL");
    desc.get();
    desc.layer_count = -1;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &set, error), invalid,
                 "generate_desc.layer_count is -1");
    desc.layer_count = 3;
    desc.layers = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &set, error), invalid,
                 "generate_desc.layers is NULL");
    EXPECT_EQ(info_of(context).bytes_now, before);
}

class BadFrame : public testing::Test {
protected:
    BadFrame() : model(custom_sphere(context, sphere)), set(generate(context, model, small_desc())) {
        item = item_of(set, &style);
        EXPECT_OK(draw());
        kept = std::move(drawing);
    }

    hrbfnpr_status call(const hrbfnpr_item* items, std::int64_t count, std::int64_t stride) {
        auto* made_drawing = reinterpret_cast<hrbfnpr_drawing*>(this);
        const hrbfnpr_status status =
            hrbfnpr_renderer_draw(renderer.get(), items, count, stride, &camera, &made_drawing, error);
        EXPECT_EQ(made_drawing != nullptr, status == HRBFNPR_STATUS_OK);
        drawing.reset(made_drawing);
        return status;
    }
    hrbfnpr_status draw() { return call(&item, 1, 0); }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    PointSet set;
    Renderer renderer = make_renderer(context);
    hrbfnpr_camera camera = front_camera();
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_item item;
    Drawing drawing;
    Drawing kept; // a valid drawing
};

TEST_F(BadFrame, InvalidStylesAreRefused) {
    using Style = hrbfnpr_style;
    const std::vector<Row<Style>> rows = {
        {[](Style& s) { s.hidden_lines = 3; }, "items[0].style.hidden_lines is 3; it must be one of HRBFNPR_HIDDEN"},
        {[](Style& s) { s.halo_width = nanf; }, "items[0].style.halo_width is nan"},
        {[](Style& s) { s.tone = HRBFNPR_TONE_CALLBACK; }, "items[0].style.tone_function is NULL"},
        {[](Style& s) { s.light[0] = s.light[1] = s.light[2] = 0; }, "items[0].style.light is zero"},
        {[](Style& s) { s.layer_count = 1; }, "items[0].style.layers is NULL"},
        {[](Style& s) { s.layer_count = -1; }, "items[0].style.layer_count is -1"},
        {[](Style& s) { s.depth_min = 1; }, "items[0].style.depth_min is 1 and depth_max is 0"},
        {[](Style& s) { s.depth_max = 1; }, "they must be 0 < depth_min < depth_max"},
        {[](Style& s) { s.depth_max = nan; }, "items[0].style.depth_max is nan"},
        {[](Style& s) { s.silhouette_radius_zoom = 2; }, "items[0].style.silhouette_radius_zoom is 2"}};
    const hrbfnpr_style good = style;
    for (const auto& row : rows) {
        style = good;
        row.change(style);
        EXPECT_FAILS(draw(), invalid, row.message);
    }
    style = good;
    style.struct_size = 2;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].style.struct_size is 2");
    // The valid drawing from before still exists.
    EXPECT_GT(info_of(kept).dots, 0);
}

TEST_F(BadFrame, InvalidLayerStylesAreRefused) {
    using Layer = hrbfnpr_layer_style;
    const std::vector<Row<Layer>> rows = {
        {[](Layer& l) { l.ink[2] = nanf; }, "items[0].style.layers[1].ink[2] is nan"}};
    Layer layers[2] = {made(hrbfnpr_layer_style_init), made(hrbfnpr_layer_style_init)};
    style.layers = layers;
    style.layer_count = 2;
    for (const auto& row : rows) {
        layers[1] = layers[0];
        row.change(layers[1]);
        EXPECT_FAILS(draw(), invalid, row.message);
    }
    layers[1] = layers[0];
    EXPECT_OK(draw());
    layers[1].struct_size = 2;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].style.layers[1].struct_size is 2");
    style.layer_stride = 4;
    EXPECT_FAILS(draw(), invalid, "items[0].style.layer_stride is 4");
}

TEST_F(BadFrame, InvalidPosesAreRefused) {
    using Pose = hrbfnpr_layer_pose;
    static std::vector<float> place, normal;
    place = attribute<float>(set, by_curvature, HRBFNPR_MARK_ATTRIBUTE_POSITION);
    normal = attribute<float>(set, by_curvature, HRBFNPR_MARK_ATTRIBUTE_NORMAL);
    static std::vector<float> bad_place, long_normal;
    bad_place = place;
    bad_place[4] = nanf;
    long_normal = normal;
    for (float& component : long_normal) component *= 3.0F;
    auto good = made(hrbfnpr_layer_pose_init);
    good.layer = by_curvature;
    good.position = in(place);
    good.normal = in(normal);
    Pose pose = good;
    item.poses = &pose;
    item.pose_count = 1;
    EXPECT_OK(draw());
    const std::vector<Row<Pose>> rows = {
        {[](Pose& p) { p.layer = -1; }, "items[0].poses[0].layer is -1; it must be at least 0"},
        {[](Pose& p) { p.layer = 3; }, "items[0].poses[0].layer is 3"},
        {[](Pose& p) { --p.position.count; }, "items[0].poses[0].position.count is "},
        {[](Pose& p) { ++p.normal.count; }, "items[0].poses[0].normal.count is "},
        {[](Pose& p) { p.normal = {}; }, "items[0].poses[0].position or normal is empty; both are needed"},
        {[](Pose& p) { p.position.components = 2; }, "items[0].poses[0].position.components is 2"},
        {[](Pose& p) { p.position.scalar = HRBFNPR_SCALAR_UINT8; }, "items[0].poses[0].position.scalar is 3"},
        {[](Pose& p) { p.position = in(bad_place); }, "items[0].poses[0].position[1] is "},
        {[](Pose& p) { p.normal = in(long_normal); }, "items[0].poses[0].normal[0] has the length 3; it must be 1"},
        {[](Pose& p) { p.direction = in(long_normal); }, "items[0].poses[0].direction[0] has the length 3"}};
    for (const auto& row : rows) {
        pose = good;
        row.change(pose);
        EXPECT_FAILS(draw(), invalid, row.message);
    }
    pose = good;
    pose.struct_size = 4;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].poses[0].struct_size is 4");
    Pose twice[2] = {good, good};
    item.poses = twice;
    item.pose_count = 2;
    EXPECT_FAILS(draw(), invalid, "items[0].poses[1].layer is 1, which");
    item.pose_count = -1;
    EXPECT_FAILS(draw(), invalid, "items[0].pose_count is -1");
    item.pose_count = 1;
    item.model = model.get();
    EXPECT_FAILS(draw(), invalid, "items[0].model is given together with poses");
    item.model = nullptr;
    item.poses = nullptr;
    EXPECT_FAILS(draw(), invalid, "items[0].poses is NULL");
}

TEST_F(BadFrame, InvalidItemsAndCamerasAreRefused) {
    EXPECT_FAILS(call(nullptr, 1, 0), invalid, "items is NULL");
    EXPECT_FAILS(call(&item, -1, 0), invalid, "item_count is -1");
    EXPECT_FAILS(call(&item, std::numeric_limits<std::int64_t>::max(), 0), invalid,
                 "item_count is 9223372036854775807");
    EXPECT_FAILS(call(&item, 1, -8), invalid, "item_stride is -8");
    EXPECT_FAILS(call(&item, 1, 4), invalid, "item_stride is 4");
    const hrbfnpr_item good = item;
    item.point_set = nullptr;
    EXPECT_FAILS(draw(), invalid, "items[0].point_set is NULL");
    item = good;
    item.sides = 2;
    EXPECT_FAILS(draw(), invalid, "items[0].sides is 2; it must be one of HRBFNPR_SIDES_* (0 to 1)");
    item = good;
    item.transform[5] = nan;
    EXPECT_FAILS(draw(), invalid, "items[0].transform[5] is nan");
    item = good;
    item.transform[3] = 1;
    EXPECT_FAILS(draw(), invalid, "items[0].transform is not affine");
    item = good;
    item.transform[10] = 0;
    EXPECT_FAILS(draw(), invalid, "items[0].transform is singular");
    item = good;
    item.struct_size = 1;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].struct_size is 1");
    item = good;
    hrbfnpr_item two[2] = {good, good};
    hrbfnpr_style black = style;
    black.paper[0] = 0;
    two[1].style = &black;
    EXPECT_FAILS(call(two, 2, 0), invalid, "items[1].style.paper differs");
    black = style;
    black.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    EXPECT_FAILS(call(two, 2, 0), invalid, "items[1].style.visibility differs");
    hrbfnpr_drawing* out = nullptr;
    EXPECT_FAILS(hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, nullptr, &out, error), invalid, "camera is NULL");
    EXPECT_FAILS(hrbfnpr_renderer_draw(nullptr, &item, 1, 0, &camera, &out, error), invalid, "renderer is NULL");
    EXPECT_FAILS(hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, nullptr, error), invalid,
                 "out_drawing is NULL");
    const hrbfnpr_camera good_camera = camera;
    camera = made(hrbfnpr_camera_init);
    EXPECT_FAILS(draw(), invalid, "camera.viewport is 0 x 0 pixels");
    camera = good_camera;
    camera.view[7] = nan;
    EXPECT_FAILS(draw(), invalid, "camera.view[7] is nan");
    camera = good_camera;
    camera.depth_convention = 9;
    EXPECT_FAILS(draw(), invalid, "camera.depth_convention is 9");
    camera = good_camera;
}

TEST_F(BadFrame, InvalidImagesAreRefused) {
    std::vector<std::uint8_t> pixels;
    hrbfnpr_image good = image_of(pixels, 16);
    const std::vector<Row<hrbfnpr_image>> rows = {
        {[](auto& i) { i.format = 0; }, "image.format is 0; it must be one of HRBFNPR_FORMAT_*"},
        {[](auto& i) { i.format = 8; }, "image.format is 8"},
        {[](auto& i) { i.width = 0; }, "image.width is 0; it must be from 1 to 32768"},
        {[](auto& i) { i.height = -3; }, "image.height is -3"},
        {[](auto& i) { i.width = 32769; }, "image.width is 32769"},
        {[](auto& i) { i.pixels = nullptr; }, "image.pixels is NULL"},
        {[](auto& i) { i.row_stride = 63; }, "image.row_stride is 63; pixels of 4 bytes make rows of 64"},
        {[](auto& i) { i.row_stride = -63; }, "image.row_stride is -63"},
        {[](auto& i) { i.row_stride = std::numeric_limits<std::int64_t>::min(); }, "image.row_stride is -9223"},
        {[](auto& i) { i.row_stride = std::int64_t{1} << 50; }, "image.row_stride is"},
        {[](auto& i) { i.row_stride = -(std::int64_t{1} << 47); }, "exceeds the address space"}};
    for (const auto& row : rows) {
        hrbfnpr_image image = good;
        row.change(image);
        EXPECT_FAILS(hrbfnpr_drawing_rasterize(kept.get(), &image, nullptr, error), invalid, row.message);
    }
    EXPECT_FAILS(hrbfnpr_drawing_rasterize(kept.get(), nullptr, nullptr, error), invalid, "image is NULL");
    EXPECT_FAILS(hrbfnpr_drawing_rasterize(nullptr, &good, nullptr, error), invalid, "drawing is NULL");
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(1024, 0));
}

TEST_F(BadFrame, InvalidRasterDescriptorsAreRefused) {
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 16);
    std::vector<float> depth(256);
    std::vector<std::uint32_t> id(256);
    const auto call = [&](auto&& change) {
        auto desc = made(hrbfnpr_raster_desc_init);
        change(desc);
        return hrbfnpr_drawing_rasterize(kept.get(), &image, &desc, error);
    };
    EXPECT_FAILS(call([](auto& d) { d.flags = 4; }), invalid, "raster_desc.flags is 0x4");
    EXPECT_FAILS(call([&](auto& d) { d.depth = out(depth, 2); }), invalid, "raster_desc.depth.components is 2");
    EXPECT_FAILS(call([&](auto& d) { d.depth = out(id, 1); }), invalid,
                 "raster_desc.depth.scalar is 4; it must be HRBFNPR_SCALAR_FLOAT32");
    EXPECT_FAILS(call([&](auto& d) { d.id = out(depth, 1); }), invalid, "raster_desc.id.scalar is 1");
    EXPECT_FAILS(call([&](auto& d) { d.mark_class = out(depth, 1); }), invalid, "raster_desc.mark_class.scalar is 1");
    depth.resize(255);
    EXPECT_FAILS(call([&](auto& d) { d.host_depth = in(depth, 1); }), invalid,
                 "raster_desc.host_depth.count is 255; it must be 256");
}

TEST_F(BadFrame, InvalidVertexLayoutsAreRefused) {
    Layout good;
    good.add(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, 0);
    good.add(HRBFNPR_VERTEX_ATTRIBUTE_ID, HRBFNPR_SCALAR_UINT32, 12);
    const std::vector<Row<Layout>> rows = {
        {[](Layout& l) { l.attribute.clear(); }, "layout.attributes is empty"},
        {[](Layout& l) { l.attribute.resize(65, l.attribute[0]); }, "layout.attribute_count is 65"},
        {[](Layout& l) { l.attribute_stride = -24; }, "layout.attribute_stride is -24"},
        {[](Layout& l) { l.primitive = 0; }, "layout.primitive is 0; it must be one of HRBFNPR_PRIMITIVE_"},
        {[](Layout& l) { l.primitive = 4; }, "layout.primitive is 4"},
        {[](Layout& l) { l.stride = 15; }, "layout.stride is 15, but by offset and size the attributes end at byte 16"},
        {[](Layout& l) { l.stride = -16; }, "layout.stride is -16"},
        {[](Layout& l) { l.stride = std::numeric_limits<std::int64_t>::max(); }, "exceed the address space"},
        {[](Layout& l) { l.attribute[1].attribute = 14; }, "layout.attributes[1].attribute is 14"},
        {[](Layout& l) { l.attribute[0].scalar = HRBFNPR_SCALAR_FLOAT64; },
         "layout.attributes[0].scalar is 2, a type that attribute 0 cannot have"},
        {[](Layout& l) { l.attribute[0].scalar = 99; }, "layout.attributes[0].scalar is 99"},
        {[](Layout& l) {
             l.stride = 16;
             l.attribute[0].offset = 0xFFFFFFFFU;
         },
         "layout.stride is 16, but by offset and size the attributes end at byte 4294967307"}};
    std::vector<std::uint8_t> room(1 << 20);
    std::int64_t count = -7;
    const auto write = [&](const hrbfnpr_vertex_layout* layout, void* vertices, std::int64_t capacity,
                           std::uint32_t* indices = nullptr, std::int64_t index_capacity = 0) {
        return hrbfnpr_drawing_write_vertices(kept.get(), layout, vertices, capacity, &count, indices, index_capacity,
                                              nullptr, error);
    };
    for (const auto& row : rows) {
        Layout layout = good;
        row.change(layout);
        EXPECT_FAILS(write(layout.get(), room.data(), 65536), invalid, row.message);
        EXPECT_EQ(count, -7);
    }
    Layout cut = good;
    cut.attribute[1].struct_size = 4;
    EXPECT_FAILS(write(cut.get(), room.data(), 65536), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "layout.attributes[1].struct_size is 4");
    std::uint32_t index = 7;
    EXPECT_FAILS(write(nullptr, room.data(), 65536), invalid, "layout is NULL");
    EXPECT_FAILS(write(good.get(), nullptr, 65536), invalid, "vertices is NULL");
    EXPECT_FAILS(write(good.get(), room.data(), -1), invalid, "vertex_capacity is -1");
    EXPECT_FAILS(write(good.get(), room.data(), 65536, nullptr, 5), invalid, "indices is NULL");
    EXPECT_FAILS(write(good.get(), room.data(), 65536, &index, -5), invalid, "index_capacity is -5");
    EXPECT_EQ(count, -7);
    EXPECT_FAILS(write(good.get(), room.data(), 65536, &index, 1), HRBFNPR_STATUS_BUFFER_TOO_SMALL,
                 "they must be at least");
    EXPECT_EQ(index, 7U);
    EXPECT_OK(write(good.get(), room.data(), 65536));
    EXPECT_GT(count, 0);
    EXPECT_FAILS(hrbfnpr_drawing_vertex_bound(kept.get(), 0, &count, nullptr, error), invalid, "primitive is 0");
    EXPECT_FAILS(hrbfnpr_drawing_vertex_bound(kept.get(), 4, &count, nullptr, error), invalid, "primitive is 4");
    EXPECT_FAILS(hrbfnpr_drawing_vertex_bound(nullptr, 1, &count, nullptr, error), invalid, "drawing is NULL");
    EXPECT_OK(hrbfnpr_drawing_vertex_bound(kept.get(), 1, nullptr, nullptr, error));
}

TEST_F(BadFrame, InvalidMarkResultsAndIdsAreRefused) {
    const std::int64_t marks = layer_info(set, stipples).marks;
    std::vector<std::uint8_t> shown(static_cast<std::size_t>(marks), 77);
    std::vector<float> radius(static_cast<std::size_t>(marks));
    const auto results = [&](std::int64_t item_number, std::int64_t layer, auto&& change) {
        auto wanted = made(hrbfnpr_mark_results_init);
        wanted.shown = out(shown, 1);
        wanted.radius = out(radius, 1);
        change(wanted);
        return hrbfnpr_drawing_mark_results(kept.get(), item_number, layer, &wanted, error);
    };
    const auto as_is = [](auto&) {};
    EXPECT_FAILS(results(1, 0, as_is), invalid, "item is 1; it must be at least 0 and below the number of items, 1");
    EXPECT_FAILS(results(-1, 0, as_is), invalid, "item is -1");
    EXPECT_FAILS(results(0, 3, as_is), invalid,
                 "layer is 3; in the point set of item 0 it must be at least 0 and below 3");
    EXPECT_FAILS(results(0, -1, as_is), invalid, "layer is -1");
    EXPECT_FAILS(results(0, 0, [](auto& r) { --r.shown.count; }), invalid, "mark_results.shown.count is ");
    EXPECT_FAILS(results(0, 0, [](auto& r) { r.radius.scalar = HRBFNPR_SCALAR_FLOAT64; }), invalid,
                 "mark_results.radius.scalar is 2");
    EXPECT_FAILS(results(0, 0, [](auto& r) { r.reserved = 1; }), invalid, "mark_results.reserved is 1");
    EXPECT_FAILS(results(0, 0, [](auto& r) { r.struct_size = 3; }), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "mark_results.struct_size is 3");
    EXPECT_FAILS(hrbfnpr_drawing_mark_results(kept.get(), 0, 0, nullptr, error), invalid, "mark_results is NULL");
    EXPECT_EQ(shown, std::vector<std::uint8_t>(shown.size(), 77)) << "a failed call wrote something";
    std::uint32_t index = 0;
    std::int64_t count = -7;
    const auto indices = [&](std::int64_t layer, std::uint32_t mark_class, std::uint32_t primitive, std::uint32_t* to,
                             std::int64_t capacity) {
        return hrbfnpr_drawing_write_mark_indices(kept.get(), 0, layer, mark_class, primitive, to, capacity, &count,
                                                  error);
    };
    EXPECT_FAILS(indices(3, 1, 1, &index, 1), invalid, "layer is 3");
    EXPECT_FAILS(indices(0, HRBFNPR_CLASS_BACK, 1, &index, 1), invalid, "mark_class is 2");
    EXPECT_FAILS(indices(0, HRBFNPR_CLASS_NONE, 1, &index, 1), invalid, "mark_class is 0");
    EXPECT_FAILS(indices(0, 1, 4, &index, 1), invalid, "primitive is 4");
    EXPECT_FAILS(indices(0, 1, 1, &index, -1), invalid, "capacity is -1");
    EXPECT_FAILS(indices(0, 1, 1, nullptr, 1), invalid, "indices is NULL");
    EXPECT_FAILS(hrbfnpr_drawing_write_mark_indices(kept.get(), 0, 0, 1, 1, &index, 1, nullptr, error), invalid,
                 "count is NULL");
    EXPECT_EQ(count, -7);
    EXPECT_FAILS(indices(0, 1, 1, nullptr, 0), HRBFNPR_STATUS_BUFFER_TOO_SMALL, "the number of indices");
    EXPECT_GT(count, 0);
    auto identity = made(hrbfnpr_mark_identity_init);
    identity.mark = -7;
    const auto last = static_cast<std::uint32_t>(info_of(set).marks);
    EXPECT_FAILS(hrbfnpr_drawing_identify(kept.get(), 0, &identity, error), invalid,
                 "id is 0; the marks of this drawing");
    EXPECT_FAILS(hrbfnpr_drawing_identify(kept.get(), last + 1, &identity, error), invalid, "have the ids 1 to ");
    EXPECT_FAILS(hrbfnpr_drawing_identify(kept.get(), 1, nullptr, error), invalid, "mark_identity is NULL");
    EXPECT_EQ(identity.mark, -7);
    EXPECT_OK(hrbfnpr_drawing_identify(kept.get(), last, &identity, error));
    auto layer = made(hrbfnpr_drawing_layer_info_init);
    const std::int64_t layers = info_of(kept).layers;
    EXPECT_FAILS(hrbfnpr_drawing_get_layer_info(kept.get(), layers, &layer, error), invalid, "number is ");
    EXPECT_FAILS(hrbfnpr_drawing_get_layer_info(kept.get(), -1, &layer, error), invalid, "number is -1");
    EXPECT_FAILS(hrbfnpr_drawing_get_layer_info(kept.get(), 0, nullptr, error), invalid, "drawing_layer_info is NULL");
}

} // namespace
} // namespace api_test::bad_frame_input_test
