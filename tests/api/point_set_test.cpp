// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <cmath>

namespace api_test::point_set_test {
namespace {

TEST(PointSet, DefaultsAreStipples) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    auto desc = made(hrbfnpr_generate_desc_init);
    desc.shared_budget = 500;
    hrbfnpr_point_set* raw = nullptr;
    ASSERT_OK(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &raw, error));
    const PointSet set(raw);
    EXPECT_EQ(info_of(set).layers, 1);
    EXPECT_STREQ(layer_info(set, 0).name, "stipples");
    EXPECT_EQ(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), 500U);
}

// Table 1: six seeds and four levels give 3750 stipples.
TEST(PointSet, ReproducesThePublishedCounts) {
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    Error error;
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 40000);
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 40000);
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
                     HRBFNPR_STATUS_INVALID_ARGUMENT, "it must be from 0 to ");
        EXPECT_FAILS(hrbfnpr_point_set_get_placement(set.get(), layer, -1, &placement, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, "level is -1");
    }
    EXPECT_GT(layer_info(set, 0).step, 0.0);
    EXPECT_GT(info.spacing, 0.0);
    EXPECT_GT(info.bytes, 3000 * 40);
}

TEST(PointSet, ViewsOfAllAttributesAreConsistent) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Generation desc = small_desc();
    desc.layer[by_curvature].flags = HRBFNPR_LAYER_WITH_CURVATURE;
    const PointSet set = generate(context, model, desc);
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
                  layer == by_curvature ? 3 * count : 0);
        EXPECT_EQ(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), count);
        EXPECT_EQ(attribute<std::uint8_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_LEVEL).size(), count);
        EXPECT_EQ(attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE).size(), 2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            double tangent = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double p = static_cast<double>(position[3 * i + axis]) + info.origin[axis];
                ASSERT_NEAR(p, static_cast<double>(normal[3 * i + axis]), 1e-4); // on the unit sphere
                tangent += static_cast<double>(normal[3 * i + axis] * direction[3 * i + axis]);
            }
            ASSERT_NEAR(tangent, 0.0, 1e-4);
        }
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
                 "layer is 3; it must be at least 0 and below the number of layers, 3");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 0, 11, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "attribute is 11");
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

} // namespace
} // namespace api_test::point_set_test
