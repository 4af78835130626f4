// SPDX-License-Identifier: MIT
// Layers of marks through the C boundary: the caller's own, several of a kind, fields of directions, refusals.
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
    std::vector<float> normal{2, 0, 0, 0, 1, 0}; // normalised on the way
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

TEST(Layers, OfArraysAreChecked) {
    Error error;
    const Context context = make_context();
    const auto refused = [&](auto&& change) {
        Arrays arrays;
        change(arrays);
        PointSet set;
        return create(context, arrays.desc, set, error);
    };
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(refused([](Arrays& a) { a.position[4] = NAN; }), invalid,
                 "point_set_desc.layers[0].position[1] is not finite");
    EXPECT_FAILS(refused([](Arrays& a) { a.normal[0] = 0; }), invalid, "layers[0].normal[0] is zero");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[0].normal.count = 1; }), invalid,
                 "layers[0].normal has 1 elements and .position has 2");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[0].normal = {}; }), invalid, "layers[0].normal has 0 elements");
    EXPECT_FAILS(refused([](Arrays& a) { a.rank[1] = 1.5F; }), invalid, "layers[2].rank[1] is outside [0,1)");
    EXPECT_FAILS(refused([](Arrays& a) { a.width[1] = 0.0F; }), invalid, "layers[2].width[1] is ");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[2].level.scalar = HRBFNPR_SCALAR_FLOAT32; }), invalid,
                 "point_set_desc.layers[2].level.scalar is 1; it must be HRBFNPR_SCALAR_ UINT8");
    EXPECT_FAILS(refused([](Arrays& a) { a.layer[2].stroke_first.components = 2; }), invalid,
                 "point_set_desc.layers[2].stroke_first.components is 2; it must be 1");
    EXPECT_FAILS(refused([](Arrays& a) { a.first[0] = 1; }), invalid, "layers[2].stroke_first[0] is ");
    EXPECT_FAILS(refused([](Arrays& a) { a.first[1] = 7; }), invalid,
                 "point_set_desc.layers[2].stroke_first[1] is 7; it must rise from 0 to the 5 marks");
    EXPECT_FAILS(refused([](Arrays& a) { a.first[2] = 4; }), invalid, "layers[2].stroke_first[2] is ");
    EXPECT_FAILS(refused([](Arrays& a) { a.first[2] = 6; }), invalid, "layers[2].stroke_first[2] is ");
    EXPECT_FAILS(refused([](Arrays& a) { a.direction[1] = 2; }), invalid,
                 "point_set_desc.layers[2].stroke_direction[1] is 2; it must be 0 or 1");
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
    EXPECT_FAILS(refused([](Arrays& a) { a.desc = made(hrbfnpr_point_set_desc_init); }), invalid, "there is no mark");
    EXPECT_FAILS(refused([](Arrays& a) { a.desc.layers = nullptr; }), invalid, "point_set_desc.layers is NULL");
    hrbfnpr_point_set* set = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_create(context.get(), nullptr, &set, error), invalid, "point_set_desc is NULL");
    EXPECT_EQ(set, nullptr);
}

// A list of elements that are larger than the library's, or smaller, each with its own size.
TEST(Layers, ListsHaveStrides) {
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
                 "point_set_desc.layers[2] has fields that this library");
    wide[2].more = 0;
    wide[2].known.struct_size = offsetof(hrbfnpr_layer_arrays, stroke_first); // older than strokes
    arrays.desc.layer_stride = sizeof(Wide);
    ASSERT_OK(create(context, arrays.desc, set, error));
    EXPECT_EQ(layer_info(set, 2).strokes, 0);
}

// The layers of a generated set and the caller's own: a fourth layer with strokes.
TEST(Layers, OfASetAndTheCallersOwn) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const PointSet base = generate(context, custom_sphere(context, sphere), small_desc());
    std::vector<double> position;
    std::vector<std::uint32_t> first{0};
    for (int s = 0; s < 6; ++s) {
        for (int i = 0; i < 40; ++i) {
            const double a = 1.0471975512 * s;
            const double b = 0.5 + 0.05 * i;
            position.insert(position.end(), {std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)});
        }
        first.push_back(static_cast<std::uint32_t>(40 * s + 40));
    }
    auto own = made(hrbfnpr_layer_arrays_init);
    own.position = own.normal = in(position);
    own.stroke_first = in(first, 1);
    auto desc = made(hrbfnpr_point_set_desc_init);
    desc.base = base.get();
    desc.layers = &own;
    desc.layer_count = 1;
    PointSet set;
    ASSERT_OK(create(context, desc, set, error));
    const hrbfnpr_point_set_info info = info_of(set);
    const hrbfnpr_point_set_info before = info_of(base);
    ASSERT_EQ(info.layers, 4);
    EXPECT_EQ(info.marks, before.marks + 240);
    EXPECT_EQ(info.distribution, before.distribution);
    EXPECT_EQ(info.spacing, before.spacing);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(info.origin[axis], before.origin[axis]);
    for (std::int64_t layer = 0; layer < 3; ++layer) {
        for (const std::uint32_t which : {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_RANK})
            EXPECT_EQ(attribute<float>(set, layer, which), attribute<float>(base, layer, which));
        EXPECT_EQ(attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST),
                  attribute<std::uint32_t>(base, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST));
        EXPECT_STREQ(layer_info(set, layer).name, layer_info(base, layer).name);
    }
    EXPECT_STREQ(layer_info(set, 3).name, "own");
    EXPECT_EQ(layer_info(set, 3).strokes, 6);
    const auto rank = attribute<float>(set, 3, HRBFNPR_MARK_ATTRIBUTE_RANK);
    for (std::size_t i = 0; i < rank.size(); ++i) EXPECT_EQ(rank[i], rank[i / 40 * 40]);
    EXPECT_NE(rank[0], rank[40]);
    // It is drawn: more ink than without it.
    const auto ink = [&](const PointSet& which) {
        std::int64_t sum = 0;
        for (const std::uint8_t byte : draw(make_renderer(context), which, 200)) sum += 255 - byte;
        return sum;
    };
    EXPECT_GT(ink(set), ink(base));
    // And kept by a file.
    const std::vector<std::uint8_t> bytes = saved(set);
    hrbfnpr_point_set* loaded = nullptr;
    ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                            &loaded, error));
    const PointSet again(loaded);
    EXPECT_EQ(saved(again), bytes);
    EXPECT_EQ(layer_info(again, 3).strokes, 6);
    // A set alone gives a copy.
    auto copy = made(hrbfnpr_point_set_desc_init);
    copy.base = base.get();
    ASSERT_OK(create(context, copy, set, error));
    EXPECT_EQ(info_of(set).marks, before.marks);
}

// ---- generated -----------------------------------------------------------------------------

std::int32_t only_north(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                        double* density) {
    for (std::int64_t i = 0; i < count; ++i) density[i] = positions[3 * i + 2] > 0.0 ? 1.0 : 0.0;
    return 0;
}

TEST(Layers, OfOneKindHaveSettingsOfTheirOwn) {
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
    double hole = 0.0;   // about the axis there is no direction

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

// Lines of BLUE_NOISE follow the field; strokes of PUBLISHED follow it and cross it.
TEST(Layers, FollowTheCallersField) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED}) {
        SCOPED_TRACE(distribution);
        Field field;
        Generation desc = along(field);
        desc.distribution = distribution;
        const PointSet set = generate(context, model, desc);
        EXPECT_GT(field.calls, 0);
        const hrbfnpr_layer_info info = layer_info(set, 0);
        EXPECT_EQ(info.kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_HATCH));
        EXPECT_STREQ(info.name, "hatch");
        EXPECT_GT(info.strokes, 20);
        const auto position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        const auto direction = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
        const auto stroke = attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE);
        const hrbfnpr_point_set_info all = info_of(set);
        std::size_t off = 0;
        std::size_t across = 0;
        for (std::size_t i = 0; i < direction.size() / 3; ++i) {
            const double x = all.origin[0] + double{position[3 * i]};
            const double y = all.origin[1] + double{position[3 * i + 1]};
            const double around = (-y * double{direction[3 * i]} + x * double{direction[3 * i + 1]}) / std::hypot(x, y);
            const bool crosses = stroke[2 * i] % 2 != 0;
            across += crosses ? 1U : 0U;
            off += std::abs(std::abs(around) - (crosses ? 0.0 : 1.0)) > 0.01 ? 1U : 0U;
        }
        EXPECT_LT(off, direction.size() / 3 / 50) << "but at the poles";
        EXPECT_EQ(across > 0, distribution == HRBFNPR_DISTRIBUTION_PUBLISHED);
    }
}

// Lines, and none near the poles.
TEST(Layers, FollowAFieldWithHoles) {
    const Context context = make_context();
    Sphere sphere;
    Field field;
    field.hole = 0.2;
    Generation desc = along(field);
    desc.layer[0].budget = 2000;
    const PointSet set = generate(context, custom_sphere(context, sphere), desc);
    const auto position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION);
    const auto direction = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
    const auto stroke = attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE);
    const hrbfnpr_point_set_info info = info_of(set);
    std::int64_t seen = 0;
    for (std::size_t i = 0; i < stroke.size() / 2; ++i) {
        const double x = info.origin[0] + double{position[3 * i]};
        const double y = info.origin[1] + double{position[3 * i + 1]};
        const double r = std::hypot(x, y);
        if (r < 0.4 || stroke[2 * i] % 2 != 0) continue;
        EXPECT_GT(std::abs(double{direction[3 * i]} * -y + double{direction[3 * i + 1]} * x) / r, 0.95) << i;
        ++seen;
    }
    EXPECT_GT(seen, 200);
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

TEST(Layers, ACancelEndsAFieldSoon) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    for (int at = 1; at < 64; at *= 2) {
        Field field;
        Generation desc = along(field);
        const Operation operation = make_operation(context);
        Watcher watcher;
        watcher.cancel_at_call = static_cast<std::size_t>(at);
        ASSERT_OK(hrbfnpr_operation_set_callback(operation.get(), Watcher::call, &watcher, error));
        hrbfnpr_point_set* set = nullptr;
        const hrbfnpr_status status =
            hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), operation.get(), &set, error);
        if (watcher.values.size() < watcher.cancel_at_call) {
            EXPECT_OK(status);
            hrbfnpr_point_set_release(set);
            break;
        }
        EXPECT_EQ(status, HRBFNPR_STATUS_CANCELLED) << at;
        EXPECT_EQ(set, nullptr);
    }
}

// What a preset names is what its style shows.
TEST(Layers, OfPresets) {
    for (std::uint32_t preset = 0; preset <= HRBFNPR_PRESET_FULL; ++preset) {
        Error error;
        hrbfnpr_style style;
        ASSERT_OK(hrbfnpr_style_init_preset(&style, sizeof style, preset, error));
        std::int64_t count = -1;
        const hrbfnpr_layer_desc* const layers = hrbfnpr_preset_layers(preset, &count);
        ASSERT_GT(count, 0);
        for (std::int64_t i = 0; i < count; ++i) {
            ASSERT_EQ(layers[i].struct_size, sizeof *layers);
            hrbfnpr_layer_desc defaults = made(hrbfnpr_layer_desc_init);
            defaults.kind = layers[i].kind;
            if (layers[i].kind == HRBFNPR_LAYER_KIND_HATCH) {
                defaults.name = layers[i].name;
                defaults.angle = layers[i].angle;
            }
            if (preset == HRBFNPR_PRESET_COMBING && i > 0) defaults.guide = HRBFNPR_HATCH_GUIDE_COMBING;
            EXPECT_EQ(std::memcmp(&defaults, &layers[i], sizeof defaults), 0);
        }
        const auto has = [&](std::uint32_t kind) {
            return std::any_of(layers, layers + count, [&](const auto& layer) { return layer.kind == kind; });
        };
        for (std::int64_t i = 0; i < style.layer_count; ++i) {
            const hrbfnpr_layer_style& layer = style.layers[i];
            const bool is_made = layer.kind == HRBFNPR_LAYER_KIND_STIPPLES || layer.kind == HRBFNPR_LAYER_KIND_HATCH;
            EXPECT_TRUE(layer.shown == 0 || !is_made || has(layer.kind)) << preset << ", kind " << layer.kind;
            // Styles of hatching find the layers that they are named for.
            const bool is_named = std::any_of(layers, layers + count, [&](const auto& one) {
                return layer.name != nullptr && one.name != nullptr && std::strcmp(one.name, layer.name) == 0;
            });
            EXPECT_TRUE(layer.name == nullptr || is_named) << preset << ", " << layer.name;
        }
    }
    std::int64_t count = 7;
    EXPECT_EQ(hrbfnpr_preset_layers(0xFFFFFFFFU, &count), nullptr);
    EXPECT_EQ(count, 0);
    EXPECT_NE(hrbfnpr_preset_layers(HRBFNPR_PRESET_FULL, nullptr), nullptr);
    // As they are they can be generated from.
    Error error;
    const Context context = make_context();
    Sphere sphere;
    auto desc = made(hrbfnpr_generate_desc_init);
    desc.layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_FULL, &desc.layer_count);
    desc.shared_budget = 600;
    hrbfnpr_point_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_point_set_generate(context.get(), custom_sphere(context, sphere).get(), &desc, nullptr, &made_set,
                                         error));
    const PointSet set(made_set);
    EXPECT_EQ(info_of(set).layers, 3);
}

} // namespace
} // namespace api_test::layers_test
