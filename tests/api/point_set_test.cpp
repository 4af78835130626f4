// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <cmath>

namespace api_test {
namespace {

TEST(PointSet, DefaultsAreStipples) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    auto desc = made(hrbfnpr_generate_desc_init);
    const auto layer = made(hrbfnpr_layer_desc_init);
    EXPECT_EQ(desc.layers, nullptr);
    EXPECT_EQ(desc.layer_count, 0);
    EXPECT_EQ(desc.shared_budget, 0);
    EXPECT_EQ(layer.kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_STIPPLES));
    EXPECT_EQ(layer.name, nullptr);
    EXPECT_EQ(layer.budget, 40000);
    EXPECT_EQ(layer.levels, -1);
    EXPECT_EQ(layer.density_strength, 0.5);
    EXPECT_EQ(layer.symmetry, static_cast<std::uint32_t>(HRBFNPR_SYMMETRY_CROSS));
    EXPECT_EQ(desc.box_resolution, 8U);
    EXPECT_EQ(desc.box_jitter, 0.25);
    EXPECT_EQ(desc.random_seed, 1U);
    desc.shared_budget = 500;
    hrbfnpr_point_set* raw = nullptr;
    ASSERT_OK(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &raw, error));
    const PointSet set(raw);
    EXPECT_EQ(info_of(set).layers, 1);
    EXPECT_STREQ(layer_info(set, 0).name, "stipples");
    EXPECT_EQ(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), 500U);
}

// Table 1: six seeds and four levels give 3750 stipples.
TEST(PointSet, ThePublishedCountsComeOut) {
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    Error error;
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 40000);
    desc.add(HRBFNPR_LAYER_KIND_PRINCIPAL, 40000);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    desc.seed_source = HRBFNPR_SEED_SAMPLES;
    const PointSet set = generate(context, model, desc);
    const hrbfnpr_point_set_info info = info_of(set);
    EXPECT_EQ(info.distribution, static_cast<std::uint32_t>(HRBFNPR_DISTRIBUTION_PUBLISHED));
    EXPECT_EQ(info.seed_source, static_cast<std::uint32_t>(HRBFNPR_SEED_SAMPLES));
    auto placement = made(hrbfnpr_placement_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_seed_placement(set.get(), &placement, error));
    EXPECT_EQ(placement.placed, 6);
    EXPECT_EQ(layer_info(set, 0).full_count, 3750);
    EXPECT_EQ(layer_info(set, 1).full_count, 6 * 2 * 27);
    EXPECT_EQ(layer_info(set, 0).levels, 4);
    EXPECT_EQ(layer_info(set, 1).levels, 3);
    EXPECT_EQ(layer_info(set, 1).strokes, 12);
    for (std::int64_t layer = 0; layer < 2; ++layer) {
        const hrbfnpr_layer_info of_layer = layer_info(set, layer);
        std::int64_t placed = 0;
        for (std::int32_t level = 0; level <= of_layer.levels; ++level) {
            EXPECT_OK(hrbfnpr_point_set_get_placement(set.get(), layer, level, &placement, error));
            placed += placement.placed;
            EXPECT_EQ(placement.attempted, placement.placed + placement.dropped_not_converged +
                                               placement.dropped_strayed + placement.dropped_degenerate +
                                               placement.dropped_budget);
        }
        EXPECT_EQ(placed, of_layer.marks);
        EXPECT_FAILS(hrbfnpr_point_set_get_placement(set.get(), layer, of_layer.levels + 1, &placement, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, "the layer has levels 0 to ");
        EXPECT_FAILS(hrbfnpr_point_set_get_placement(set.get(), layer, -1, &placement, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, "level is -1");
    }
    EXPECT_GT(layer_info(set, 0).step, 0.0);
    EXPECT_GT(info.spacing, 0.0);
    EXPECT_GT(info.bytes, 3000 * 40);
}

TEST(PointSet, ViewsOfAllAttributesFitTogether) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const PointSet set = generate(context, model, small_desc());
    const hrbfnpr_point_set_info info = info_of(set);
    for (std::int64_t layer = 0; layer < 3; ++layer) {
        const auto count = static_cast<std::size_t>(layer_info(set, layer).marks);
        ASSERT_GT(count, 0U);
        const auto position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        const auto normal = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL);
        const auto direction = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
        ASSERT_EQ(position.size(), 3 * count);
        ASSERT_EQ(normal.size(), 3 * count);
        ASSERT_EQ(direction.size(), 3 * count);
        EXPECT_EQ(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_CURVATURE).size(),
                  layer == principal ? 3 * count : 0);
        EXPECT_EQ(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), count);
        EXPECT_EQ(attribute<std::uint8_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_LEVEL).size(), count);
        EXPECT_EQ(attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE).size(), 2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            double tangent = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double p = static_cast<double>(position[3 * i + axis]) + info.origin[axis];
                ASSERT_NEAR(p, static_cast<double>(normal[3 * i + axis]), 1e-4); // the unit sphere
                tangent += static_cast<double>(normal[3 * i + axis] * direction[3 * i + axis]);
            }
            ASSERT_NEAR(tangent, 0.0, 1e-4);
        }
    }
}

TEST(PointSet, CurvatureOnRequest) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Generation desc = small_desc();
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.flags = HRBFNPR_LAYER_WITH_CURVATURE;
    const PointSet set = generate(context, model, desc);
    for (std::int64_t layer = 0; layer < 3; ++layer) {
        const auto curvature = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_CURVATURE);
        ASSERT_FALSE(curvature.empty());
        EXPECT_NEAR(curvature[0], -1.0F, 1e-3F);
    }
}

TEST(PointSet, RefusesUnknownViews) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const PointSet set = generate(context, model, small_desc());
    hrbfnpr_array view{};
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 3, 0, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "layer is 3; the set has 3");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 0, 10, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "attribute is 10");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 0, 0, nullptr, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "out_view is NULL");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), -1, 0, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "layer is -1");
    auto info = made(hrbfnpr_layer_info_init);
    EXPECT_FAILS(hrbfnpr_point_set_get_layer_info(set.get(), 3, &info, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "layer is 3");
}

TEST(PointSet, StepPatchesAreSquares) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    auto desc = made(hrbfnpr_generate_desc_init);
    desc.initial_step = 0.125;
    std::vector<double> corner(5 * 12);
    const hrbfnpr_array_out corners = out(corner, 12);
    double step = 0.0;
    EXPECT_OK(hrbfnpr_point_set_step_patches(context.get(), model.get(), &desc, &corners, &step, nullptr, error));
    EXPECT_EQ(step, 0.125);
    for (std::size_t patch = 0; patch < 5; ++patch)
        for (std::size_t side = 0; side < 4; ++side) {
            double length = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double d =
                    corner[12 * patch + 3 * side + axis] - corner[12 * patch + 3 * ((side + 1) % 4) + axis];
                length += d * d;
            }
            EXPECT_NEAR(std::sqrt(length), 0.25, 1e-9);
        }
    EXPECT_FAILS(hrbfnpr_point_set_step_patches(context.get(), model.get(), &desc, nullptr, &step, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "corners is NULL");
}

// Two stipples, an empty layer, and a combing stroke of two marks.
struct Arrays {
    std::vector<double> position{10, 0, 0, 0, 10, 0};
    std::vector<float> normal{2, 0, 0, 0, 1, 0}; // normalised on the way
    std::vector<float> rank{0.25F, 0.75F};
    std::vector<float> width{0.5F, 1.0F};
    std::vector<std::uint8_t> level{0, 1};
    std::vector<std::uint32_t> first{0, 2};
    std::vector<std::uint8_t> side{1};
    std::vector<hrbfnpr_layer_arrays> layer = std::vector(3, made(hrbfnpr_layer_arrays_init));
    hrbfnpr_point_set_desc desc = made(hrbfnpr_point_set_desc_init);

    Arrays() {
        layer[0].kind = HRBFNPR_LAYER_KIND_STIPPLES;
        layer[2].kind = HRBFNPR_LAYER_KIND_COMBING;
        layer[2].name = "hair";
        layer[0].position = layer[2].position = in(position);
        layer[0].normal = layer[2].normal = in(normal);
        layer[2].rank = in(rank, 1);
        layer[2].width = in(width, 1);
        layer[2].level = in(level, 1);
        layer[2].stroke_first = in(first, 1);
        layer[2].stroke_direction = in(side, 1);
        desc.layers = layer.data();
        desc.layer_count = 3;
    }
    Arrays(const Arrays&) = delete;
    Arrays& operator=(const Arrays&) = delete;
    ~Arrays() = default;
};

PointSet create(const Context& context, const hrbfnpr_point_set_desc& desc) {
    Error error;
    hrbfnpr_point_set* set = nullptr;
    EXPECT_OK(hrbfnpr_point_set_create(context.get(), &desc, &set, error));
    return PointSet(set);
}

TEST(PointSet, IsMadeFromArrays) {
    const Context context = make_context();
    const Arrays arrays;
    const PointSet set = create(context, arrays.desc);
    const hrbfnpr_point_set_info info = info_of(set);
    EXPECT_EQ(info.layers, 3);
    EXPECT_EQ(info.marks, 4);
    EXPECT_EQ(layer_info(set, 0).marks, 2);
    EXPECT_EQ(layer_info(set, 0).strokes, 0);
    EXPECT_STREQ(layer_info(set, 0).name, "stipples");
    EXPECT_EQ(layer_info(set, 1).marks, 0);
    EXPECT_EQ(layer_info(set, 1).kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_OWN));
    EXPECT_STREQ(layer_info(set, 1).name, "own");
    EXPECT_EQ(layer_info(set, 2).strokes, 1);
    EXPECT_STREQ(layer_info(set, 2).name, "hair");
    const auto position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(static_cast<double>(position[i]) + info.origin[i % 3], arrays.position[i]);
    EXPECT_EQ(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL), (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(attribute<float>(set, 2, HRBFNPR_MARK_ATTRIBUTE_RANK), arrays.rank);
    EXPECT_EQ(attribute<float>(set, 2, HRBFNPR_MARK_ATTRIBUTE_WIDTH), arrays.width);
    EXPECT_EQ(attribute<std::uint8_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_LEVEL), arrays.level);
    EXPECT_EQ(attribute<std::uint32_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_STROKE),
              (std::vector<std::uint32_t>{1, 0, 1, 1}));
    EXPECT_EQ(attribute<std::uint32_t>(set, 2, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST), arrays.first);
    for (const float rank : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK)) {
        EXPECT_GE(rank, 0.0F);
        EXPECT_LT(rank, 1.0F);
    }
}

TEST(PointSet, ABaseComesFirst) {
    const Context context = make_context();
    Sphere sphere;
    const PointSet base = generate(context, custom_sphere(context, sphere), small_desc());
    Arrays arrays;
    for (double& coordinate : arrays.position) coordinate *= 0.1;
    arrays.desc.base = base.get();
    const PointSet set = create(context, arrays.desc);
    const hrbfnpr_point_set_info info = info_of(set);
    const hrbfnpr_point_set_info before = info_of(base);
    ASSERT_EQ(info.layers, 6);
    EXPECT_EQ(info.marks, before.marks + 4);
    EXPECT_EQ(info.distribution, before.distribution);
    EXPECT_EQ(info.spacing, before.spacing);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(info.origin[axis], before.origin[axis]);
    for (std::int64_t layer = 0; layer < 3; ++layer) {
        EXPECT_STREQ(layer_info(set, layer).name, layer_info(base, layer).name);
        for (const std::uint32_t which : {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_RANK})
            EXPECT_EQ(attribute<float>(set, layer, which), attribute<float>(base, layer, which));
        EXPECT_EQ(attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST),
                  attribute<std::uint32_t>(base, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST));
    }
    EXPECT_STREQ(layer_info(set, 5).name, "hair");
    auto copy = made(hrbfnpr_point_set_desc_init); // of a set alone
    copy.base = base.get();
    EXPECT_EQ(info_of(create(context, copy)).marks, before.marks);
}

TEST(PointSet, ArraysAreChecked) {
    Error error;
    const Context context = make_context();
    hrbfnpr_point_set* set = nullptr;
    const auto create = [&](auto&& change) {
        Arrays arrays;
        change(arrays);
        return hrbfnpr_point_set_create(context.get(), &arrays.desc, &set, error);
    };
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(create([](Arrays& a) { a.position[4] = NAN; }), invalid,
                 "point_set_desc.layers[0].position[1] is not finite");
    EXPECT_FAILS(create([](Arrays& a) { a.normal[0] = 0; }), invalid, "layers[0].normal[0] is zero");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[0].normal.count = 1; }), invalid,
                 "layers[0].normal has 1 elements and .position has 2");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[0].normal = {}; }), invalid, "layers[0].normal has 0 elements");
    EXPECT_FAILS(create([](Arrays& a) { a.rank[1] = 1.5F; }), invalid, "layers[2].rank[1] is outside [0,1)");
    EXPECT_FAILS(create([](Arrays& a) { a.width[1] = 0.0F; }), invalid, "layers[2].width[1] is ");
    EXPECT_FAILS(create([](Arrays& a) { a.first[0] = 1; }), invalid, "layers[2].stroke_first[0] is ");
    EXPECT_FAILS(create([](Arrays& a) { a.first[1] = 1; }), invalid, "layers[2].stroke_first[1] is ");
    EXPECT_FAILS(create([](Arrays& a) { a.first[1] = 3; }), invalid, "layers[2].stroke_first[1] is ");
    EXPECT_FAILS(create([](Arrays& a) { a.side[0] = 2; }), invalid, "layers[2].stroke_direction[0] is ");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[2].stroke_first = {}; }), invalid, "layers[2].stroke_direction has 1");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[2].level.scalar = HRBFNPR_SCALAR_FLOAT32; }), invalid,
                 "point_set_desc.layers[2].level.scalar is 1; it must be HRBFNPR_SCALAR_ UINT8");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[2].stroke_first.components = 2; }), invalid,
                 "point_set_desc.layers[2].stroke_first.components is 2; it must be 1");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[1].kind = HRBFNPR_LAYER_KIND_ANY; }), invalid, "layers[1].kind is 0");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[1].kind = 6; }), invalid, "layers[1].kind is 6");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[1].name = ""; }), invalid, "layers[1].name has no bytes");
    EXPECT_FAILS(create([](Arrays& a) { a.layer[1].struct_size = 7; }), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "layers[1].struct_size is 7");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.reserved = 3; }), invalid, "point_set_desc.reserved is 3");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.layer_count = -1; }), invalid,
                 "the number of point_set_desc.layers is -1");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.layer_stride = 4; }), invalid,
                 "the stride of point_set_desc.layers is 4");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.layers = nullptr; }), invalid, "point_set_desc.layers is NULL");
    EXPECT_FAILS(create([](Arrays& a) { a.desc = made(hrbfnpr_point_set_desc_init); }), invalid, "there is no mark");
    EXPECT_FAILS(hrbfnpr_point_set_create(context.get(), nullptr, &set, error), invalid, "point_set_desc is NULL");
    EXPECT_EQ(set, nullptr);
}

TEST(PointSet, LayersHaveNamesAndMayBeOfOneKind) {
    const Context context = make_context();
    Sphere sphere;
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 200).name = "dark";
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 100).name = "light";
    desc.add(HRBFNPR_LAYER_KIND_PRINCIPAL, 300);
    desc.layer[0].tone_begin = 0.5F;
    desc.layer[0].tone_end = 1.0F;
    const PointSet set = generate(context, custom_sphere(context, sphere), desc);
    ASSERT_EQ(info_of(set).layers, 3);
    EXPECT_STREQ(layer_info(set, 0).name, "dark");
    EXPECT_STREQ(layer_info(set, 1).name, "light");
    EXPECT_STREQ(layer_info(set, 2).name, "principal");
    EXPECT_EQ(layer_info(set, 1).marks, 100);
    for (const float rank : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK)) EXPECT_LE(rank, 0.5F);
}

// Rings around the z axis, and none near the poles, where the callback gives no direction.
std::int32_t around(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                    double* directions) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = positions + 3 * i;
        double* d = directions + 3 * i;
        d[0] = -p[1];
        d[1] = p[0];
        d[2] = 0.0;
        if (std::hypot(p[0], p[1]) < 0.2) d[0] = d[1] = 0.0;
    }
    return 0;
}

TEST(PointSet, StrokesFollowTheCallersField) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_FIELD, 2000).direction_function = around;
    desc.layer[0].symmetry = HRBFNPR_SYMMETRY_LINE;
    const Model model = custom_sphere(context, sphere);
    const PointSet set = generate(context, model, desc);
    const auto position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION);
    const auto direction = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
    const auto stroke = attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE);
    const hrbfnpr_point_set_info info = info_of(set);
    std::int64_t seen = 0;
    for (std::size_t i = 0; i < stroke.size() / 2; ++i) {
        const double x = static_cast<double>(position[3 * i]) + info.origin[0];
        const double y = static_cast<double>(position[3 * i + 1]) + info.origin[1];
        const double r = std::hypot(x, y);
        if (r < 0.4 || stroke[2 * i] % 2 != 0) continue;
        const double along =
            (static_cast<double>(direction[3 * i]) * -y + static_cast<double>(direction[3 * i + 1]) * x) / r;
        EXPECT_GT(std::abs(along), 0.95) << i;
        ++seen;
    }
    EXPECT_GT(seen, 200);
    desc.layer[0].direction_function = [](void*, std::int64_t, const double*, const double*, double*) { return 9; };
    hrbfnpr_point_set* none = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &none, error),
                 HRBFNPR_STATUS_CALLBACK, "direction_function returned 9");
    desc.layer[0].direction_function = [](void*, std::int64_t, const double*, const double*, double* d) {
        d[0] = NAN;
        return 0;
    };
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &none, error),
                 HRBFNPR_STATUS_CALLBACK, "direction_function gave nan");
}

} // namespace
} // namespace api_test
