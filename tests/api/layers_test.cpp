// SPDX-License-Identifier: MIT
// Tests layers of marks through the C boundary: the caller's own, several of a kind, direction fields, refusals.
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <vector>

namespace api_test::layers_test {
namespace {

// Two stipples, an empty layer, and two hatching strokes, of three and of two marks.
struct Arrays {
    std::vector<double> position{10, 0, 0, 0, 10, 0};
    std::vector<float> normal{2, 0, 0, 0, 1, 0}; // the call normalises them
    std::vector<double> places{0, 0, 9, 1, 0, 9, 2, 0, 9, 0, 5, 9, 0, 6, 9};
    std::vector<float> up{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    std::vector<std::uint32_t> first{0, 3, 5};
    std::vector<std::uint8_t> direction{0, 1};
    std::vector<float> rank{0.25F, 0.25F, 0.25F, 0.75F, 0.75F};
    std::vector<float> width{0.5F, 1.0F, 0.75F, 0.25F, 1.0F};
    std::vector<std::uint8_t> level{0, 0, 0, 200, 200};
    std::vector<hrbfnpr_layer_arrays> layer = std::vector(3, made(hrbfnpr_layer_arrays_init));
    hrbfnpr_point_set_desc desc = made(hrbfnpr_point_set_desc_init);

    Arrays() {
        layer[0].kind = HRBFNPR_LAYER_KIND_STIPPLES;
        layer[0].position = in(position);
        layer[0].normal = in(normal);
        layer[2].kind = HRBFNPR_LAYER_KIND_HATCH;
        layer[2].name = "hand \xE2\x9C\x8E";
        layer[2].position = in(places);
        layer[2].normal = in(up);
        layer[2].stroke_first = in(first, 1);
        layer[2].stroke_direction = in(direction, 1);
        layer[2].rank = in(rank, 1);
        layer[2].width = in(width, 1);
        layer[2].level = in(level, 1);
        desc.layers = layer.data();
        desc.layer_count = 3;
    }
    Arrays(const Arrays&) = delete;
    Arrays& operator=(const Arrays&) = delete;
    ~Arrays() = default;
};

hrbfnpr_status create(const Context& context, const hrbfnpr_point_set_desc& desc, PointSet& set, Error& error) {
    hrbfnpr_point_set* made_set = nullptr;
    const hrbfnpr_status status = hrbfnpr_point_set_create(context.get(), &desc, &made_set, error);
    EXPECT_EQ(made_set != nullptr, status == HRBFNPR_STATUS_OK);
    set.reset(made_set);
    return status;
}

TEST(Layers, AreMadeFromArrays) {
    Error error;
    const Context context = make_context();
    const Arrays arrays;
    PointSet set;
    ASSERT_OK(create(context, arrays.desc, set, error));
    const hrbfnpr_point_set_info info = info_of(set);
    ASSERT_EQ(info.layers, 3);
    EXPECT_EQ(info.marks, 7);
    EXPECT_EQ(layer_info(set, 0).marks, 2);
    EXPECT_EQ(layer_info(set, 0).strokes, 0);
    EXPECT_EQ(layer_info(set, 2).marks, 5);
    EXPECT_EQ(layer_info(set, 2).strokes, 2);
    EXPECT_STREQ(layer_info(set, 0).name, "stipples");
    EXPECT_EQ(layer_info(set, 1).marks, 0);
    EXPECT_EQ(layer_info(set, 1).kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_OWN));
    EXPECT_STREQ(layer_info(set, 1).name, "own");
    EXPECT_EQ(layer_info(set, 2).kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_HATCH));
    EXPECT_EQ(layer_info(set, 2).levels, 200);
    EXPECT_STREQ(layer_info(set, 2).name, "hand \xE2\x9C\x8E");
    const auto position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(static_cast<double>(position[i]) + info.origin[i % 3], arrays.position[i]);
    EXPECT_EQ(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL), (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(attribute<float>(set, 2, HRBFNPR_MARK_ATTRIBUTE_RANK), arrays.rank);
    EXPECT_EQ(attribute<float>(set, 2, HRBFNPR_MARK_ATTRIBUTE_WIDTH), arrays.width);
    EXPECT_EQ(attribute<std::uint8_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_LEVEL), arrays.level);
    EXPECT_EQ(attribute<std::uint32_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST), arrays.first);
    EXPECT_EQ(attribute<std::uint32_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_STROKE),
              (std::vector<std::uint32_t>{0, 0, 0, 1, 0, 2, 3, 0, 3, 1}));
    EXPECT_EQ(attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE),
              (std::vector<std::uint32_t>{0, 0, 2, 0}));
    const auto along = attribute<float>(set, 2, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
    EXPECT_EQ(along, (std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0}));
    auto placed = made(hrbfnpr_placement_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_placement(set.get(), 2, 200, &placed, error));
    EXPECT_EQ(placed.placed, 2);
    EXPECT_OK(hrbfnpr_point_set_get_placement(set.get(), 2, 7, &placed, error));
    EXPECT_EQ(placed.attempted, 0);
    for (const float rank : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK)) {
        EXPECT_GE(rank, 0.0F);
        EXPECT_LT(rank, 1.0F);
    }
    draw(make_renderer(context), set, 16);
}

TEST(Layers, InvalidArraysAreRefused) {
    Error error;
    const Context context = make_context();
    const auto refused = [&](auto&& change) {
        Arrays arrays;
        change(arrays);
        PointSet set;
        return create(context, arrays.desc, set, error);
    };
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[2].level.scalar = HRBFNPR_SCALAR_FLOAT32; }), invalid,
                 "point_set_desc.layers[2].level.scalar is 1; it must be HRBFNPR_SCALAR_UINT8");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[2].stroke_first.components = 2; }), invalid,
                 "point_set_desc.layers[2].stroke_first.components is 2; it must be 1");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[2].stroke_first = {}; }), invalid, "layers[2].stroke_direction has 2");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[1].kind = HRBFNPR_LAYER_KIND_ANY; }), invalid,
                 "point_set_desc.layers[1].kind is 0");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[1].kind = 4; }), invalid, "point_set_desc.layers[1].kind is 4");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[0].name = ""; }), invalid,
                 "point_set_desc.layers[0].name has no bytes");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[1].struct_size = 7; }), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "layers[1].struct_size is 7");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc.reserved = 3; }), invalid, "point_set_desc.reserved is 3");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc.layer_count = -1; }), invalid, "point_set_desc.layer_count is -1");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc.layer_stride = 4; }), invalid, "point_set_desc.layer_stride is 4");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc = made(hrbfnpr_point_set_desc_init); }), invalid,
                 "no layer has a mark");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc.layers = nullptr; }), invalid, "point_set_desc.layers is NULL");
    hrbfnpr_point_set* set = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_create(context.get(), nullptr, &set, error), invalid, "point_set_desc is NULL");
    EXPECT_EQ(set, nullptr);
}

// The elements of a list are larger or smaller than the library's, and each states its own size.
TEST(Layers, ListsMayHaveStrides) {
    Error error;
    const Context context = make_context();
    Arrays arrays;
    struct Wide {
        hrbfnpr_layer_arrays known;
        std::uint64_t more;
    };
    std::vector<Wide> wide(3);
    for (std::size_t i = 0; i < 3; ++i) {
        wide[i].known = arrays.layer[i];
        wide[i].known.struct_size = sizeof(Wide);
        wide[i].more = 0;
    }
    arrays.desc.layers = &wide[0].known;
    PointSet set;
    ASSERT_OK(create(context, arrays.desc, set, error));
    EXPECT_EQ(layer_info(set, 2).strokes, 2);
    wide[2].more = 1;
    EXPECT_FAILS(create(context, arrays.desc, set, error), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "point_set_desc.layers[2] sets fields that this library");
    wide[2].more = 0;
    wide[2].known.struct_size = offsetof(hrbfnpr_layer_arrays, stroke_first); // older than strokes
    arrays.desc.layer_stride = sizeof(Wide);
    ASSERT_OK(create(context, arrays.desc, set, error));
    EXPECT_EQ(layer_info(set, 2).strokes, 0);
}

// ---- generated -----------------------------------------------------------------------------

std::int32_t only_north(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                        double* density) {
    for (std::int64_t i = 0; i < count; ++i) density[i] = positions[3 * i + 2] > 0.0 ? 1.0 : 0.0;
    return 0;
}

TEST(Layers, TwoLayersOfOneKindHaveSeparateSettings) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Generation desc;
    hrbfnpr_layer_desc& dark = desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 400);
    dark.name = "dark";
    dark.tone_begin = 0.5F;
    dark.tone_end = 1.0F;
    hrbfnpr_layer_desc& north = desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 300);
    north.name = "north";
    north.density = HRBFNPR_DENSITY_CALLBACK;
    north.density_function = only_north;
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 300);
    const PointSet set = generate(context, model, desc);
    ASSERT_EQ(info_of(set).layers, 3);
    EXPECT_EQ(layer_info(set, 0).marks, 400);
    EXPECT_EQ(layer_info(set, 1).marks, 300);
    EXPECT_STREQ(layer_info(set, 0).name, "dark");
    EXPECT_STREQ(layer_info(set, 1).name, "north");
    EXPECT_STREQ(layer_info(set, 2).name, "hatch");
    for (const float rank : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK)) EXPECT_LE(rank, 0.5F);
    const double origin = info_of(set).origin[2];
    const auto share_north = [&](std::int64_t layer) {
        const auto position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        int above = 0;
        for (std::size_t i = 2; i < position.size(); i += 3) above += origin + double{position[i]} > 0.0 ? 1 : 0;
        return 3.0 * above / static_cast<double>(position.size());
    };
    EXPECT_NEAR(share_north(0), 0.5, 0.05);
    EXPECT_EQ(share_north(1), 1.0);
}

struct Field {
    int calls = 0;
    std::int32_t result = 0;
    double spoilt = 0.0; // added to directions
    double hole = 0.0;   // radius around the axis without directions

    static std::int32_t call(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* directions) {
        auto& self = *static_cast<Field*>(user);
        ++self.calls;
        for (std::int64_t i = 0; i < count; ++i) {
            EXPECT_NEAR(std::hypot(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]), 1.0, 1e-9);
            directions[3 * i] = -positions[3 * i + 1] + self.spoilt;
            directions[3 * i + 1] = positions[3 * i];
            directions[3 * i + 2] = 0.0;
            if (std::hypot(positions[3 * i], positions[3 * i + 1]) < self.hole)
                directions[3 * i] = directions[3 * i + 1] = 0.0;
        }
        return self.result;
    }
};

Generation along(Field& field) {
    Generation desc = one_layer(HRBFNPR_LAYER_KIND_HATCH, 3000);
    desc.layer[0].direction_function = Field::call;
    desc.layer[0].direction_user = &field;
    return desc;
}

TEST(Layers, AFieldThatFailsIsReported) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const auto run = [&](Field field, std::uint32_t distribution) {
        Generation desc = along(field);
        desc.distribution = distribution;
        hrbfnpr_point_set* set = nullptr;
        const hrbfnpr_status status =
            hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error);
        hrbfnpr_point_set_release(set);
        return status;
    };
    for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED}) {
        EXPECT_FAILS(run({0, 5, 0.0}, distribution), HRBFNPR_STATUS_CALLBACK, "direction_function returned 5");
        EXPECT_FAILS(run({0, 0, NAN}, distribution), HRBFNPR_STATUS_CALLBACK, "direction_function gave nan");
        EXPECT_FAILS(run({0, 0, INFINITY}, distribution), HRBFNPR_STATUS_CALLBACK, "direction_function gave inf");
    }
}

} // namespace
} // namespace api_test::layers_test
