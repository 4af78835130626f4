#include "fixture.h"

#include <cmath>

namespace api_test {
namespace {

hrbfnpr_point_set_info info_of(const PointSet& set) {
    Error error;
    auto info = made(hrbfnpr_point_set_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
    return info;
}

TEST(PointSet, DefaultsAreStipples) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    auto desc = made(hrbfnpr_generate_desc_init);
    EXPECT_EQ(desc.groups, 1U);
    EXPECT_EQ(desc.group[0].levels, 4);
    EXPECT_EQ(desc.group[1].levels, 3);
    EXPECT_EQ(desc.box_resolution, 8U);
    EXPECT_EQ(desc.box_jitter, 0.25);
    EXPECT_EQ(desc.random_seed, 1U);
    desc.group[0].budget = 500;
    const PointSet set = generate(context, model, desc);
    EXPECT_EQ(attribute<float>(set, HRBFNPR_GROUP_STIPPLE, HRBFNPR_ATTRIBUTE_RANK).size(), 500U);
    EXPECT_TRUE(attribute<float>(set, HRBFNPR_GROUP_COMBING, HRBFNPR_ATTRIBUTE_RANK).empty());
}

// Table 1: six seeds and four levels give 3750 stipples.
TEST(PointSet, ThePublishedCountsComeOut) {
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    auto desc = made(hrbfnpr_generate_desc_init);
    desc.groups = 3;
    desc.distribution = HRBFNPR_DISTRIBUTION_PAPER;
    desc.seed_source = HRBFNPR_SEED_SAMPLES;
    const PointSet set = generate(context, model, desc);
    const hrbfnpr_point_set_info info = info_of(set);
    EXPECT_EQ(info.distribution, static_cast<std::uint32_t>(HRBFNPR_DISTRIBUTION_PAPER));
    EXPECT_EQ(info.seed_source, static_cast<std::uint32_t>(HRBFNPR_SEED_SAMPLES));
    EXPECT_EQ(info.seeds.placed, 6);
    EXPECT_EQ(info.group[0].full_count, 3750);
    EXPECT_EQ(info.group[1].full_count, 6 * 2 * 27);
    for (const hrbfnpr_group_info& group : info.group) {
        std::int64_t placed = 0;
        for (const hrbfnpr_level_info& level : group.level) {
            placed += level.placed;
            EXPECT_EQ(level.attempted, level.placed + level.dropped_not_converged + level.dropped_strayed +
                                           level.dropped_degenerate + level.dropped_budget);
        }
        EXPECT_EQ(placed, group.count);
    }
    EXPECT_GT(info.group[0].step, 0.0);
    EXPECT_GT(info.spacing, 0.0);
    EXPECT_GT(info.bytes, 3000 * 40);
}

TEST(PointSet, ViewsOfAllAttributesFitTogether) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const PointSet set = generate(context, model, small_desc());
    const hrbfnpr_point_set_info info = info_of(set);
    for (std::uint32_t group = 0; group < 3; ++group) {
        const auto count = static_cast<std::size_t>(info.group[group].count);
        ASSERT_GT(count, 0U);
        const auto position = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_POSITION);
        const auto normal = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_NORMAL);
        const auto direction = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_DIRECTION);
        ASSERT_EQ(position.size(), 3 * count);
        ASSERT_EQ(normal.size(), 3 * count);
        ASSERT_EQ(direction.size(), 3 * count);
        EXPECT_EQ(attribute<float>(set, group, HRBFNPR_ATTRIBUTE_CURVATURE).size(), group == 1 ? 3 * count : 0);
        EXPECT_EQ(attribute<float>(set, group, HRBFNPR_ATTRIBUTE_RANK).size(), count);
        EXPECT_EQ(attribute<std::uint8_t>(set, group, HRBFNPR_ATTRIBUTE_LEVEL).size(), count);
        EXPECT_EQ(attribute<std::uint32_t>(set, group, HRBFNPR_ATTRIBUTE_STROKE).size(), 2 * count);
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
    hrbfnpr_generate_desc desc = small_desc();
    desc.flags = HRBFNPR_GENERATE_CURVATURE_OF_STIPPLES | HRBFNPR_GENERATE_CURVATURE_OF_COMBING;
    const PointSet set = generate(context, model, desc);
    for (std::uint32_t group = 0; group < 3; ++group) {
        const auto curvature = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_CURVATURE);
        ASSERT_FALSE(curvature.empty());
        EXPECT_NEAR(curvature[0], -1.0F, 1e-3F);
    }
}

TEST(PointSet, RefusesUnknownViews) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    hrbfnpr_generate_desc desc = small_desc();
    const PointSet set = generate(context, model, desc);
    hrbfnpr_array view{};
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 3, 0, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "group is 3");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 0, 8, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "attribute is 8");
    EXPECT_FAILS(hrbfnpr_point_set_view(set.get(), 0, 0, nullptr, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "out_view is NULL");
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

// Two stipples and a stroke of two marks.
struct Arrays {
    std::vector<double> position{10, 0, 0, 0, 10, 0};
    std::vector<float> normal{2, 0, 0, 0, 1, 0}; // normalised on the way
    std::vector<float> rank{0.25F, 0.75F};
    std::vector<std::uint8_t> level{0, 1};
    std::vector<std::uint32_t> stroke{4, 0, 4, 1};
    hrbfnpr_point_set_desc desc = made(hrbfnpr_point_set_desc_init);

    Arrays() {
        desc.group[0].position = desc.group[2].position = in(position);
        desc.group[0].normal = desc.group[2].normal = in(normal);
        desc.group[2].rank = in(rank, 1);
        desc.group[2].level = in(level, 1);
        desc.group[2].stroke = in(stroke, 2);
    }
};

TEST(PointSet, IsMadeFromArrays) {
    Error error;
    const Context context = make_context();
    const Arrays arrays;
    hrbfnpr_point_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_point_set_create_from_arrays(context.get(), &arrays.desc, &made_set, error));
    const PointSet set(made_set);
    const hrbfnpr_point_set_info info = info_of(set);
    EXPECT_EQ(info.group[0].count, 2);
    EXPECT_EQ(info.group[1].count, 0);
    EXPECT_EQ(info.group[2].strokes, 1);
    const auto position = attribute<float>(set, 0, HRBFNPR_ATTRIBUTE_POSITION);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(static_cast<double>(position[i]) + info.origin[i % 3], arrays.position[i]);
    EXPECT_EQ(attribute<float>(set, 0, HRBFNPR_ATTRIBUTE_NORMAL), (std::vector<float>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(attribute<float>(set, 2, HRBFNPR_ATTRIBUTE_RANK), arrays.rank);
    EXPECT_EQ(attribute<std::uint8_t>(set, 2, HRBFNPR_ATTRIBUTE_LEVEL), arrays.level);
    EXPECT_EQ(attribute<std::uint32_t>(set, 2, HRBFNPR_ATTRIBUTE_STROKE), arrays.stroke);
    for (const float rank : attribute<float>(set, 0, HRBFNPR_ATTRIBUTE_RANK)) {
        EXPECT_GE(rank, 0.0F);
        EXPECT_LT(rank, 1.0F);
    }
}

TEST(PointSet, ArraysAreChecked) {
    Error error;
    const Context context = make_context();
    hrbfnpr_point_set* set = nullptr;
    const auto create = [&](auto&& change) {
        Arrays arrays;
        change(arrays);
        return hrbfnpr_point_set_create_from_arrays(context.get(), &arrays.desc, &set, error);
    };
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(create([](Arrays& a) { a.position[4] = NAN; }), invalid, "group[0].position[1] is not finite");
    EXPECT_FAILS(create([](Arrays& a) { a.normal[0] = 0; }), invalid, "group[0].normal[0] is zero");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.group[0].normal.count = 1; }), invalid,
                 "group[0].normal has 1 elements and group[0].position has 2");
    EXPECT_FAILS(create([](Arrays& a) { a.rank[1] = 1.5F; }), invalid, "group[2].rank[1] is outside [0,1)");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.group[2].level.scalar = HRBFNPR_SCALAR_FLOAT32; }), invalid,
                 "point_set_desc.group[2].level.scalar is 1; it must be HRBFNPR_SCALAR_ UINT8");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.group[2].stroke.components = 1; }), invalid,
                 "point_set_desc.group[2].stroke.components is 1; it must be 2");
    EXPECT_FAILS(create([](Arrays& a) { a.desc.reserved = 3; }), invalid, "point_set_desc.reserved is 3");
    EXPECT_FAILS(create([](Arrays& a) { a.desc = made(hrbfnpr_point_set_desc_init); }), invalid, "there is no mark");
    EXPECT_FAILS(hrbfnpr_point_set_create_from_arrays(context.get(), nullptr, &set, error), invalid,
                 "point_set_desc is NULL");
    EXPECT_EQ(set, nullptr);
}

} // namespace
} // namespace api_test
