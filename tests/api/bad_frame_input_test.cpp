// The table of bad inputs, second half: generating and drawing.
#include "fixture.h"

#include <cmath>
#include <functional>
#include <limits>

namespace api_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr float nanf = std::numeric_limits<float>::quiet_NaN();

template <class T>
struct Row {
    std::function<void(T&)> change;
    const char* message;
};

TEST(BadInput, Generate) {
    using Desc = hrbfnpr_generate_desc;
    static const std::vector<double> bad_point{0, 0, nan};
    static const std::vector<double> far_point{1e3, 1e3, 1e3};
    const std::vector<Row<Desc>> rows = {
        {[](Desc& d) { d.groups = 0; }, "generate_desc.groups is 0"},
        {[](Desc& d) { d.groups = 8; }, "generate_desc.groups is 0x8; only the bits of 0x7"},
        {[](Desc& d) { d.distribution = 2; }, "generate_desc.distribution is 2"},
        {[](Desc& d) { d.seed_source = 4; }, "generate_desc.seed_source is 4"},
        {[](Desc& d) { d.flags = 4; }, "generate_desc.flags is 0x4"},
        {[](Desc& d) { d.box_resolution = 0; }, "generate_desc.box_resolution is 0; it must be from 1 to 256"},
        {[](Desc& d) { d.box_resolution = 257; }, "generate_desc.box_resolution is 257"},
        {[](Desc& d) { d.box_jitter = 0.6; }, "generate_desc.box_jitter is 0.6; it must be from 0 to 0.5"},
        {[](Desc& d) { d.initial_step = -1; }, "generate_desc.initial_step is -1"},
        {[](Desc& d) { d.initial_step = nan; }, "generate_desc.initial_step is nan"},
        {[](Desc& d) { d.projection_tolerance = 0; }, "generate_desc.projection_tolerance is 0"},
        {[](Desc& d) { d.seed_source = HRBFNPR_SEED_POINTS; }, "generate_desc.seed_points is empty"},
        {[](Desc& d) { d.seed_source = HRBFNPR_SEED_SAMPLES; }, "seed_source SAMPLES needs a model"},
        {[](Desc& d) {
             d.seed_source = HRBFNPR_SEED_POINTS;
             d.seed_points = in(bad_point);
         },
         "seed_points[0] is not finite"},
        {[](Desc& d) { d.seed_points.count = -4; }, "generate_desc.seed_points.count is -4"},
        {[](Desc& d) { d.group[0].levels = 13; }, "generate_desc.group[0].levels is 13; it must be from 0 to 12"},
        {[](Desc& d) { d.group[1].levels = -1; }, "generate_desc.group[1].levels is -1"},
        {[](Desc& d) { d.group[2].budget = -1; }, "generate_desc.group[2].budget is -1"},
        {[](Desc& d) { d.stroke_separation = -1; }, "generate_desc.stroke_separation is -1"},
        {[](Desc& d) { d.stroke_separation = 1e-9, d.group[1].budget = 0; }, "raise them or set group[1].budget"},
        {[](Desc& d) { d.stroke_step = nan; }, "generate_desc.stroke_step is nan"},
        {[](Desc& d) { d.stroke_length = -0.5; }, "generate_desc.stroke_length is -0.5"},
        {[](Desc& d) { d.stroke_field = 2; }, "generate_desc.stroke_field is 2"},
        {[](Desc& d) { d.reserved2 = 1; }, "generate_desc.reserved2 is 1"},
        {[](Desc& d) { d.group[1].reserved = 1; }, "generate_desc.group[1].reserved is 1"},
        {[](Desc& d) { d.group[1].seeds = 2; }, "generate_desc.group[1].seeds is 2"},
        {[](Desc& d) { d.group[1].seeds = 1; },
         "generate_desc.group[1].seeds is STIPPLES; only the PAPER distribution"},
        {[](Desc& d) { d.group[0].seeds = 1; }, "generate_desc.group[0].seeds is STIPPLES; the stipples themselves"},
        {[](Desc& d) { d.group[2].seed_level = 13; }, "generate_desc.group[2].seed_level is 13"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PAPER;
             d.group[2].seeds = 1;
             d.group[2].seed_level = 3;
         },
         "generate_desc.group[2].seed_level is 3, above the 2 levels of the stipples"},
        {[](Desc& d) {
             d.distribution = HRBFNPR_DISTRIBUTION_PAPER;
             d.group[0].levels = 12;
             d.group[0].budget = 0;
         },
         "group[0].levels = 12 would grow to"}};
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const std::int64_t before = info_of(context).bytes_now;
    for (const auto& row : rows) {
        Error error;
        hrbfnpr_generate_desc desc = small_desc();
        row.change(desc);
        auto* set = reinterpret_cast<hrbfnpr_point_set*>(&desc);
        EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &set, error), invalid,
                     row.message);
        EXPECT_EQ(set, nullptr) << row.message;
    }
    Error error;
    hrbfnpr_generate_desc desc = small_desc();
    desc.seed_source = HRBFNPR_SEED_POINTS;
    desc.seed_points = in(far_point);
    hrbfnpr_point_set* set = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &set, error),
                 HRBFNPR_STATUS_NOT_CONVERGED, "none of 1 seeds reached the surface");
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), nullptr, &desc, nullptr, &set, error), invalid,
                 "model is NULL");
    EXPECT_FAILS(hrbfnpr_point_set_generate(nullptr, model.get(), &desc, nullptr, &set, error), invalid,
                 "context is NULL");
    EXPECT_EQ(info_of(context).bytes_now, before);
}

class BadFrame : public testing::Test {
protected:
    BadFrame() : model(custom_sphere(context, sphere)), set(generate(context, model, small_desc())) {
        item = item_of(set, &style);
        EXPECT_OK(prepare());
    }

    hrbfnpr_status prepare() { return hrbfnpr_renderer_prepare(renderer.get(), &item, 1, 0, &camera, nullptr, error); }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    PointSet set;
    Renderer renderer = make_renderer(context);
    hrbfnpr_camera camera = front_camera();
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_item item;
};

TEST_F(BadFrame, Style) {
    using Style = hrbfnpr_style;
    const std::vector<Row<Style>> rows = {
        {[](Style& s) { s.hidden_lines = 3; }, "items[0].style.hidden_lines is 3; it must be one of HRBFNPR_HIDDEN"},
        {[](Style& s) { s.silhouette_threshold = 0; }, "items[0].style.silhouette_threshold is 0; it must be between"},
        {[](Style& s) { s.silhouette_threshold = 1; }, "items[0].style.silhouette_threshold is 1"},
        {[](Style& s) { s.attenuation_front = -1; }, "items[0].style.attenuation_front is -1"},
        {[](Style& s) { s.attenuation_back = nan; }, "items[0].style.attenuation_back is nan"},
        {[](Style& s) { s.cover_radius = -1; }, "items[0].style.cover_radius is -1"},
        {[](Style& s) { s.halo_width = nanf; }, "items[0].style.halo_width is nan"},
        {[](Style& s) { s.cover_layers = -1; }, "items[0].style.cover_layers is -1"},
        {[](Style& s) { s.visibility = 2; }, "items[0].style.visibility is 2"},
        {[](Style& s) { s.tone_curve = 2; }, "items[0].style.tone_curve is 2"},
        {[](Style& s) { s.silhouette_law = 2; }, "items[0].style.silhouette_law is 2"},
        {[](Style& s) { s.tone_fade = 1.5F; }, "items[0].style.tone_fade is 1.5"},
        {[](Style& s) { s.silhouette_width = -1; }, "items[0].style.silhouette_width is -1"},
        {[](Style& s) { s.tone = 3; }, "items[0].style.tone is 3"},
        {[](Style& s) { s.tone = HRBFNPR_TONE_CALLBACK; }, "items[0].style.tone_function is NULL"},
        {[](Style& s) { s.tone_rule = 2; }, "items[0].style.tone_rule is 2"},
        {[](Style& s) { s.light_space = 2; }, "items[0].style.light_space is 2"},
        {[](Style& s) { s.light[1] = nan; }, "items[0].style.light is nan"},
        {[](Style& s) { s.light[0] = s.light[1] = s.light[2] = 0; }, "items[0].style.light is zero"},
        {[](Style& s) { s.tone_exponent = 0; }, "items[0].style.tone_exponent is 0"},
        {[](Style& s) { s.silhouette_groups = 8; }, "items[0].style.silhouette_groups is 0x8"},
        {[](Style& s) { s.depth_min = 1; }, "items[0].style.depth_min is 1 and depth_max is 0"},
        {[](Style& s) { s.depth_max = 1; }, "it must be 0 < depth_min < depth_max"},
        {[](Style& s) { s.depth_max = nan; }, "items[0].style.depth_max is nan"},
        {[](Style& s) { s.zoom_reference = -1; }, "items[0].style.zoom_reference is -1"},
        {[](Style& s) { s.zoom_exponent = -1; }, "items[0].style.zoom_exponent is -1"},
        {[](Style& s) { s.paper[3] = 2; }, "items[0].style.paper[3] is 2; it must be from 0 to 1"},
        {[](Style& s) { s.silhouette_ink[0] = -1; }, "items[0].style.silhouette_ink[0] is -1"},
        {[](Style& s) { s.silhouette_radius = 0; }, "items[0].style.silhouette_radius is 0"},
        {[](Style& s) { s.silhouette_radius_zoom = 2; }, "items[0].style.silhouette_radius_zoom is 2"},
        {[](Style& s) { s.group[1].shown = 2; }, "items[0].style.group[1].shown is 2"},
        {[](Style& s) { s.group[1].sets = 4; }, "items[0].style.group[1].sets is 0x4"},
        {[](Style& s) { s.group[2].share = 1.5F; }, "items[0].style.group[2].share is 1.5"},
        {[](Style& s) { s.group[0].radius = 0; }, "items[0].style.group[0].radius is 0"},
        {[](Style& s) { s.group[0].radius = 1e9F; }, "items[0].style.group[0].radius is 1e+09"},
        {[](Style& s) { s.group[0].radius_zoom = -1; }, "items[0].style.group[0].radius_zoom is -1"},
        {[](Style& s) { s.group[0].ink[2] = nanf; }, "items[0].style.group[0].ink[2] is nan"}};
    const hrbfnpr_style good = style;
    for (const auto& row : rows) {
        style = good;
        row.change(style);
        EXPECT_FAILS(prepare(), invalid, row.message);
    }
    style = good;
    style.struct_size = 2;
    EXPECT_FAILS(prepare(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].style.struct_size is 2");
    // The good frame from before is still there.
    std::int64_t count = 0;
    EXPECT_OK(hrbfnpr_renderer_vertex_bound(renderer.get(), &count, error));
    EXPECT_GT(count, 0);
}

TEST_F(BadFrame, ItemsAndCamera) {
    const auto call = [&](const hrbfnpr_item* items, std::int64_t count, std::int64_t stride) {
        return hrbfnpr_renderer_prepare(renderer.get(), items, count, stride, &camera, nullptr, error);
    };
    EXPECT_FAILS(call(nullptr, 1, 0), invalid, "items is NULL");
    EXPECT_FAILS(call(&item, -1, 0), invalid, "item_count is -1");
    EXPECT_FAILS(call(&item, std::numeric_limits<std::int64_t>::max(), 0), invalid,
                 "item_count is 9223372036854775807");
    EXPECT_FAILS(call(&item, 1, -8), invalid, "item_stride is -8");
    EXPECT_FAILS(call(&item, 1, 4), invalid, "item_stride is 4");
    const hrbfnpr_item good = item;
    item.point_set = nullptr;
    EXPECT_FAILS(prepare(), invalid, "items[0].point_set is NULL");
    item = good;
    item.reserved = 1;
    EXPECT_FAILS(prepare(), invalid, "items[0].reserved is 1");
    item = good;
    item.transform[5] = nan;
    EXPECT_FAILS(prepare(), invalid, "items[0].transform[5] is nan");
    item = good;
    item.transform[3] = 1;
    EXPECT_FAILS(prepare(), invalid, "items[0].transform is not affine");
    item = good;
    item.transform[10] = 0;
    EXPECT_FAILS(prepare(), invalid, "items[0].transform is singular");
    item = good;
    item.struct_size = 1;
    EXPECT_FAILS(prepare(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "items[0].struct_size is 1");
    item = good;
    hrbfnpr_item two[2] = {good, good};
    hrbfnpr_style black = style;
    black.paper[0] = 0;
    two[1].style = &black;
    EXPECT_FAILS(call(two, 2, 0), invalid, "items[1].style.paper differs");
    black = style;
    black.visibility = HRBFNPR_VISIBILITY_PAINTED;
    EXPECT_FAILS(call(two, 2, 0), invalid, "items[1].style.visibility differs");
    EXPECT_FAILS(hrbfnpr_renderer_prepare(renderer.get(), &item, 1, 0, nullptr, nullptr, error), invalid,
                 "camera is NULL");
    EXPECT_FAILS(hrbfnpr_renderer_prepare(nullptr, &item, 1, 0, &camera, nullptr, error), invalid, "renderer is NULL");
    const hrbfnpr_camera good_camera = camera;
    camera = made(hrbfnpr_camera_init);
    EXPECT_FAILS(prepare(), invalid, "camera.viewport is 0 x 0 pixels");
    camera = good_camera;
    camera.view[7] = nan;
    EXPECT_FAILS(prepare(), invalid, "camera.view[7] is nan");
    camera = good_camera;
    camera.depth_convention = 9;
    EXPECT_FAILS(prepare(), invalid, "camera.depth_convention is 9");
    camera = good_camera;
    hrbfnpr_frame_info info;
    info.struct_size = 0;
    EXPECT_FAILS(hrbfnpr_renderer_prepare(renderer.get(), &item, 1, 0, &camera, &info, error),
                 HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "frame_info.struct_size is 0");
}

TEST_F(BadFrame, Image) {
    std::vector<std::uint8_t> pixels;
    hrbfnpr_image good = image_of(pixels, 16);
    const std::vector<Row<hrbfnpr_image>> rows = {
        {[](auto& i) { i.format = 0; }, "image.format is 0; it must be one of HRBFNPR_FORMAT_..."},
        {[](auto& i) { i.format = 5; }, "image.format is 5"},
        {[](auto& i) { i.width = 0; }, "image.width is 0; it must be from 1 to 32768"},
        {[](auto& i) { i.height = -3; }, "image.height is -3"},
        {[](auto& i) { i.width = 32769; }, "image.width is 32769"},
        {[](auto& i) { i.pixels = nullptr; }, "image.pixels is NULL"},
        {[](auto& i) { i.row_stride = 63; }, "image.row_stride is 63; it must be 0, or at least 4 * width = 64"},
        {[](auto& i) { i.row_stride = -63; }, "image.row_stride is -63"},
        {[](auto& i) { i.row_stride = std::numeric_limits<std::int64_t>::min(); }, "image.row_stride is -9223"},
        {[](auto& i) { i.row_stride = std::int64_t{1} << 50; }, "image.row_stride is"},
        {[](auto& i) { i.row_stride = -(std::int64_t{1} << 47); }, "is beyond the address space"}};
    for (const auto& row : rows) {
        hrbfnpr_image image = good;
        row.change(image);
        EXPECT_FAILS(hrbfnpr_renderer_draw_image(renderer.get(), &image, nullptr, error), invalid, row.message);
    }
    EXPECT_FAILS(hrbfnpr_renderer_draw_image(renderer.get(), nullptr, nullptr, error), invalid, "image is NULL");
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(1024, 0));
}

TEST_F(BadFrame, DrawDesc) {
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 16);
    std::vector<float> depth(256);
    std::vector<std::uint32_t> id(256);
    const auto call = [&](auto&& change) {
        auto desc = made(hrbfnpr_draw_desc_init);
        change(desc);
        return hrbfnpr_renderer_draw_image(renderer.get(), &image, &desc, error);
    };
    EXPECT_FAILS(call([](auto& d) { d.flags = 4; }), invalid, "draw_desc.flags is 0x4");
    EXPECT_FAILS(call([&](auto& d) { d.depth = out(depth, 2); }), invalid, "draw_desc.depth.components is 2");
    EXPECT_FAILS(call([&](auto& d) { d.depth = out(id, 1); }), invalid,
                 "draw_desc.depth.scalar is 4; it must be HRBFNPR_SCALAR_ FLOAT32");
    EXPECT_FAILS(call([&](auto& d) { d.id = out(depth, 1); }), invalid, "draw_desc.id.scalar is 1");
    EXPECT_FAILS(call([&](auto& d) { d.class_ = out(depth, 1); }), invalid, "draw_desc.class_.scalar is 1");
    depth.resize(255);
    EXPECT_FAILS(call([&](auto& d) { d.host_depth = in(depth, 1); }), invalid,
                 "draw_desc.host_depth.count is 255; it must be 256");
}

TEST_F(BadFrame, VertexLayout) {
    using Layout = hrbfnpr_vertex_layout;
    auto good = made(hrbfnpr_vertex_layout_init);
    good.attribute_count = 2;
    good.attributes[0] = {HRBFNPR_VERTEX_POSITION, HRBFNPR_SCALAR_FLOAT32, 0, 0};
    good.attributes[1] = {HRBFNPR_VERTEX_ID, HRBFNPR_SCALAR_UINT32, 12, 0};
    const std::vector<Row<Layout>> rows = {
        {[](Layout& l) { l.attribute_count = 0; }, "layout.attribute_count is 0; it must be from 1 to 16"},
        {[](Layout& l) { l.attribute_count = 17; }, "layout.attribute_count is 17"},
        {[](Layout& l) { l.stride = 15; }, "layout.stride is 15; the attributes end at 16"},
        {[](Layout& l) { l.stride = -16; }, "layout.stride is -16"},
        {[](Layout& l) { l.stride = std::numeric_limits<std::int64_t>::max(); }, "are beyond the address space"},
        {[](Layout& l) { l.attributes[1].attribute = 9; }, "layout.attributes[1].attribute is 9"},
        {[](Layout& l) { l.attributes[1].reserved = 1; }, "layout.attributes[1].reserved is 1"},
        {[](Layout& l) { l.attributes[0].scalar = HRBFNPR_SCALAR_FLOAT64; },
         "layout.attributes[0].scalar is 2; attribute 0 cannot have that type"},
        {[](Layout& l) { l.attributes[0].scalar = 99; }, "layout.attributes[0].scalar is 99"},
        {[](Layout& l) {
             l.stride = 16;
             l.attributes[0].offset = 0xFFFFFFFFU;
         },
         "layout.stride is 16; the attributes end at 4294967307"}};
    std::vector<std::uint8_t> room(1 << 20);
    std::int64_t count = -7;
    for (const auto& row : rows) {
        Layout layout = good;
        row.change(layout);
        EXPECT_FAILS(hrbfnpr_renderer_write_vertices(renderer.get(), &layout, room.data(), 65536, &count, error),
                     invalid, row.message);
        EXPECT_EQ(count, -7);
    }
    EXPECT_FAILS(hrbfnpr_renderer_write_vertices(renderer.get(), &good, room.data(), 65536, nullptr, error), invalid,
                 "count is NULL");
    EXPECT_FAILS(hrbfnpr_renderer_write_vertices(renderer.get(), &good, nullptr, 65536, &count, error), invalid,
                 "destination is NULL");
    EXPECT_FAILS(hrbfnpr_renderer_write_vertices(renderer.get(), &good, room.data(), -1, &count, error), invalid,
                 "capacity is -1");
    EXPECT_OK(hrbfnpr_renderer_write_vertices(renderer.get(), &good, room.data(), 65536, &count, error));
    EXPECT_GT(count, 0);
}

} // namespace
} // namespace api_test
