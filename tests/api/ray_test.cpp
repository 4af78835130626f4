// SPDX-License-Identifier: MIT
// Tests rays and inside tests through the boundary: values, shapes, and an error that names every bad argument.
#include "fixture.h"

#include <cmath>
#include <functional>
#include <limits>

namespace api_test::ray_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Two rays at the unit sphere, with room for two hits of each.
struct Cast {
    std::vector<double> origin{-3, 0, 0.6, 0, 0, 5};
    std::vector<double> direction{2, 0, 0, 0, 1, 0};
    std::vector<std::uint32_t> hit = std::vector<std::uint32_t>(2, 77);
    std::vector<double> distance = std::vector<double>(4, -7);
    std::vector<double> place = std::vector<double>(12, -7);
    std::vector<float> unit = std::vector<float>(12, -7);
    std::vector<std::uint8_t> enter = std::vector<std::uint8_t>(4, 77);
    std::vector<std::uint8_t> state = std::vector<std::uint8_t>(2, 77);
    hrbfnpr_array origins = in(origin);
    hrbfnpr_array directions = in(direction);
    hrbfnpr_ray_hits hits = made(hrbfnpr_ray_hits_init);
    hrbfnpr_cast_desc desc = made(hrbfnpr_cast_desc_init);

    Cast() {
        desc.maximum_hits = 2;
        hits.count = out(hit, 1);
        hits.t = out(distance, 2);
        hits.position = out(place, 6);
        hits.normal = out(unit, 6);
        hits.entering = out(enter, 2);
        hits.status = out(state, 1);
        hits.hit_rays = -7;
    }
    hrbfnpr_status run(const hrbfnpr_model* model, hrbfnpr_error* error, hrbfnpr_operation* operation = nullptr) {
        return hrbfnpr_model_cast_rays(model, &origins, &directions, &desc, &hits, operation, error);
    }
};

TEST(CastRays, WritesTheHitsOfEachRaySideBySide) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Cast cast;
    ASSERT_OK(cast.run(model.get(), error));
    EXPECT_EQ(cast.hits.hit_rays, 1);
    EXPECT_EQ(cast.hit, (std::vector<std::uint32_t>{2, 0}));
    EXPECT_EQ(cast.state, (std::vector<std::uint8_t>{HRBFNPR_RAY_HIT, HRBFNPR_RAY_MISS}));
    EXPECT_EQ(cast.enter, (std::vector<std::uint8_t>{1, 0, 0, 0}));
    const double place[6] = {-0.8, 0, 0.6, 0.8, 0, 0.6};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(cast.place[i], place[i], 1e-8);
        EXPECT_NEAR(cast.unit[i], place[i], 1e-6);
        EXPECT_EQ(cast.place[6 + i], 0.0);
        EXPECT_EQ(cast.unit[6 + i], 0.0F);
    }
    EXPECT_NEAR(cast.distance[0], 1.1, 1e-8);
    EXPECT_NEAR(cast.distance[1], 1.9, 1e-8);
    EXPECT_EQ(cast.distance[2], infinity);
    EXPECT_EQ(cast.distance[3], infinity);
}

TEST(CastRays, AllArraysAndTheDescriptorAreOptional) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Cast cast;
    auto hits = made(hrbfnpr_ray_hits_init);
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &cast.origins, &cast.directions, nullptr, &hits, nullptr, error));
    EXPECT_EQ(hits.hit_rays, 1);
    hits.t = out(cast.distance, 1);
    hits.t.count = 2;
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &cast.origins, &cast.directions, nullptr, &hits, nullptr, error));
    EXPECT_NEAR(cast.distance[0], 1.1, 1e-8) << "the first hit is the default";
    EXPECT_EQ(cast.distance[1], infinity);
    // Without rays no work is done, not even for the bound.
    sphere.calls = 0;
    const hrbfnpr_array none{};
    hits.t = {};
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &none, &none, nullptr, &hits, nullptr, error));
    EXPECT_EQ(hits.hit_rays, 0);
    EXPECT_EQ(sphere.calls, 0);
}

TEST(CastRays, ReportsTheReasonForGivingUp) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Cast cast;
    cast.desc.evaluation_limit = 3;
    ASSERT_OK(cast.run(model.get(), error));
    EXPECT_EQ(cast.state[0], HRBFNPR_RAY_EVALUATION_LIMIT);
    EXPECT_EQ(cast.hits.hit_rays, 0);
    const scenes::Samples samples = scenes::torus(300);
    const Model torus = fit(context, samples);
    cast.desc.evaluation_limit = 20000;
    cast.origin = {-3, 0, 0, 0, 0, 5};
    ASSERT_OK(cast.run(torus.get(), error));
    EXPECT_EQ(cast.state[0], HRBFNPR_RAY_TRUNCATED);
    EXPECT_EQ(cast.hit[0], 2U);
}

// Fits a sphere's samples: hits lie on the fit, with its normal, and near the hits of the sphere.
TEST(CastRays, HitAFittedSphere) {
    Error error;
    const Context context = make_context();
    scenes::Samples samples;
    std::vector<double> origin;
    std::vector<double> direction;
    for (int i = 0; i < 400; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / 400.0;
        const double flat = std::sqrt(1.0 - z * z);
        const std::array<double, 3> p{flat * std::cos(2.4 * i), flat * std::sin(2.4 * i), z};
        samples.add(p, p);
        origin.insert(origin.end(), {3 * p[0], 3 * p[1], 3 * p[2]});
        direction.insert(direction.end(), {-p[0], -p[1], 0.1 - p[2]});
    }
    const Model model = fit(context, samples);
    const hrbfnpr_array from = in(origin);
    const hrbfnpr_array along = in(direction);
    std::vector<double> position(1200);
    std::vector<double> normal(1200);
    std::vector<double> t(400);
    std::vector<double> value(400);
    std::vector<double> gradient(1200);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.t = out(t, 1);
    hits.position = out(position);
    hits.normal = out(normal);
    ASSERT_OK(hrbfnpr_model_cast_rays(model.get(), &from, &along, nullptr, &hits, nullptr, error));
    EXPECT_EQ(hits.hit_rays, 400);
    const hrbfnpr_array points = in(position);
    const hrbfnpr_array_out values = out(value, 1);
    const hrbfnpr_array_out gradients = out(gradient);
    ASSERT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, &gradients, nullptr, nullptr, error));
    for (std::size_t i = 0; i < 400; ++i) {
        EXPECT_NEAR(value[i], 0.0, 1e-8);
        const double* g = &gradient[3 * i];
        const double slope = std::hypot(g[0], g[1], g[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(normal[3 * i + c], g[c] / slope, 1e-8);
            EXPECT_NEAR(position[3 * i + c], origin[3 * i + c] + t[i] * direction[3 * i + c], 1e-12);
        }
        EXPECT_NEAR(std::hypot(position[3 * i], position[3 * i + 1], position[3 * i + 2]), 1.0, 1e-4);
    }
}

// Many rays with many hits each fill more than one block; the result is the same as for few rays at a time.
TEST(CastRays, GiveTheSameHitsInManyBlocks) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere, 7);
    constexpr std::size_t count = 600;
    std::vector<double> origin;
    std::vector<double> direction;
    for (std::size_t i = 0; i < count; ++i) {
        origin.insert(origin.end(), {-3.0, 0.0, 0.0016 * static_cast<double>(i)});
        direction.insert(direction.end(), {1.0, 0.0, 0.0});
    }
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.maximum_hits = 256;
    std::vector<double> t(256 * count);
    const hrbfnpr_array from = in(origin);
    const hrbfnpr_array along = in(direction);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.t = out(t, 256);
    ASSERT_OK(hrbfnpr_model_cast_rays(model.get(), &from, &along, &desc, &hits, nullptr, error));
    for (std::size_t i = 0; i < count; ++i) {
        const double half = std::sqrt(1.0 - origin[3 * i + 2] * origin[3 * i + 2]);
        EXPECT_NEAR(t[256 * i], 3.0 - half, 1e-8) << i;
        EXPECT_NEAR(t[256 * i + 1], 3.0 + half, 1e-8) << i;
        EXPECT_EQ(t[256 * i + 2], infinity);
    }
}

struct Row {
    std::function<void(Cast&)> change;
    const char* message;
};

TEST(CastRays, BadArgumentsAreNamed) {
    const std::vector<Row> rows = {
        {[](Cast& c) { c.origin[4] = nan; }, "origins[1] is NaN or infinite; all origins must be finite"},
        {[](Cast& c) { c.direction[0] = infinity; }, "directions[0] is NaN or infinite; all directions must be finite"},
        {[](Cast& c) { c.direction[4] = 0; }, "directions[1] is zero; all directions must have a length above 0"},
        {[](Cast& c) { c.directions.count = 1; },
         "directions has 1 elements, but origins has 2; give one direction for each origin"},
        {[](Cast& c) { c.origins.components = 2; }, "origins.components is 2; it must be 3"},
        {[](Cast& c) { c.directions.scalar = HRBFNPR_SCALAR_UINT8; }, "directions.scalar is 3"},
        {[](Cast& c) { c.desc.t_min = infinity; }, "cast_desc.t_min is inf; it must be a finite number"},
        {[](Cast& c) { c.desc.t_min = nan; }, "cast_desc.t_min is nan"},
        {[](Cast& c) { c.desc.t_max = nan; }, "cast_desc.t_max is nan"},
        {[](Cast& c) {
             c.desc.t_min = 2;
             c.desc.t_max = 1;
         },
         "cast_desc.t_max is 1; it must be at least t_min, which is 2"},
        {[](Cast& c) { c.hits.count.scalar = HRBFNPR_SCALAR_UINT8; },
         "ray_hits.count.scalar is 3; it must be HRBFNPR_SCALAR_UINT32"},
        {[](Cast& c) { c.hits.t.count = 4; }, "ray_hits.t.count is 4; it must be 2"},
        {[](Cast& c) { c.hits.position.components = 3; }, "ray_hits.position.components is 3; it must be 6"},
        {[](Cast& c) { c.hits.normal.scalar = HRBFNPR_SCALAR_UINT32; }, "ray_hits.normal.scalar is 4"},
        {[](Cast& c) { c.hits.entering.scalar = HRBFNPR_SCALAR_FLOAT32; }, "ray_hits.entering.scalar is 1"},
        {[](Cast& c) { c.hits.status.data = nullptr; },
         "ray_hits.status.data is NULL, but its count is 2; give the data, or set count to 0"},
        {[](Cast& c) { c.hits.reserved = 1; }, "ray_hits.reserved is 1; it must be 0"}};
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    for (const Row& row : rows) {
        Error error;
        Cast cast;
        row.change(cast);
        EXPECT_FAILS(cast.run(model.get(), error), invalid, row.message);
        EXPECT_EQ(cast.hits.hit_rays, -7);
        EXPECT_EQ(cast.hit, (std::vector<std::uint32_t>(2, 77)));
        EXPECT_EQ(cast.distance, (std::vector<double>(4, -7)));
        EXPECT_EQ(cast.state, (std::vector<std::uint8_t>(2, 77)));
    }
    Error error;
    Cast cast;
    EXPECT_FAILS(cast.run(nullptr, error), invalid, "model is NULL");
    EXPECT_FAILS(hrbfnpr_model_cast_rays(model.get(), nullptr, &cast.directions, nullptr, &cast.hits, nullptr, error),
                 invalid, "origins is NULL");
    EXPECT_FAILS(hrbfnpr_model_cast_rays(model.get(), &cast.origins, nullptr, nullptr, &cast.hits, nullptr, error),
                 invalid, "directions is NULL");
    EXPECT_FAILS(
        hrbfnpr_model_cast_rays(model.get(), &cast.origins, &cast.directions, nullptr, nullptr, nullptr, error),
        invalid, "ray_hits is NULL");
}

TEST(Lipschitz, IsTheBoundUsedToCastRays) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    double bound = 0.0;
    ASSERT_OK(hrbfnpr_model_lipschitz(model.get(), &bound, nullptr, error));
    EXPECT_NEAR(bound, 1.5 * std::sqrt(3.0) * (1.0 + 0.05 * std::sqrt(12.0)), 1e-12); // |grad f| in a corner
    Cast automatic;
    Cast given;
    given.desc.lipschitz = bound;
    ASSERT_OK(automatic.run(model.get(), error));
    const int calls = sphere.calls;
    ASSERT_OK(given.run(model.get(), error));
    EXPECT_LT(sphere.calls - calls, calls);
    EXPECT_EQ(given.distance, automatic.distance);
    EXPECT_FAILS(hrbfnpr_model_lipschitz(model.get(), nullptr, nullptr, error), invalid, "lipschitz is NULL");
    EXPECT_FAILS(hrbfnpr_model_lipschitz(nullptr, &bound, nullptr, error), invalid, "model is NULL");
}

TEST(Contains, FindsThePointsInside) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    std::vector<double> point{0, 0, 0, 0.7, 0.7, 0, 0.8, 0.8, 0, 50, 0, 0, 0, -0.99, 0};
    std::vector<std::uint8_t> inside(5, 77);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out answers = out(inside, 1);
    std::int64_t count = -7;
    ASSERT_OK(hrbfnpr_model_contains(model.get(), &points, &answers, &count, nullptr, error));
    EXPECT_EQ(inside, (std::vector<std::uint8_t>{1, 1, 0, 0, 1}));
    EXPECT_EQ(count, 3);
    EXPECT_OK(hrbfnpr_model_contains(model.get(), &points, nullptr, nullptr, nullptr, error));
    const hrbfnpr_array none{};
    EXPECT_OK(hrbfnpr_model_contains(model.get(), &none, nullptr, &count, nullptr, error));
    EXPECT_EQ(count, 0);
}

TEST(Contains, BadArgumentsAreNamed) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    std::vector<double> point{0, 0, 0, 1, nan, 1};
    std::vector<std::uint8_t> inside(2, 77);
    const hrbfnpr_array points = in(point);
    hrbfnpr_array_out answers = out(inside, 1);
    std::int64_t count = -7;
    const auto call = [&](hrbfnpr_error* error) {
        return hrbfnpr_model_contains(model.get(), &points, &answers, &count, nullptr, error);
    };
    Error error;
    EXPECT_FAILS(call(error), invalid, "points[1] is NaN or infinite; all points must be finite");
    answers.scalar = HRBFNPR_SCALAR_FLOAT32;
    EXPECT_FAILS(call(error), invalid, "inside.scalar is 1; it must be HRBFNPR_SCALAR_UINT8");
    answers = out(inside, 1);
    answers.count = 1;
    EXPECT_FAILS(call(error), invalid, "inside.count is 1; it must be 2");
    EXPECT_FAILS(hrbfnpr_model_contains(model.get(), nullptr, nullptr, nullptr, nullptr, error), invalid,
                 "points is NULL");
    EXPECT_FAILS(hrbfnpr_model_contains(nullptr, &points, nullptr, nullptr, nullptr, error), invalid, "model is NULL");
    EXPECT_EQ(count, -7);
    EXPECT_EQ(inside[0], 77);
}

TEST(CastRays, AFailureOfTheFunctionFailsTheCall) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const std::int64_t before = info_of(context).bytes_now;
    for (const int at : {1, 30, 56}) { // calls for the bound's grid, and for the rays
        Error error;
        sphere.calls = 0;
        sphere.fail_at = at;
        EXPECT_FAILS(Cast().run(model.get(), error), HRBFNPR_STATUS_CALLBACK, "function returned 7; it must return 0");
    }
    EXPECT_EQ(info_of(context).bytes_now, before);
}

} // namespace
} // namespace api_test::ray_test
