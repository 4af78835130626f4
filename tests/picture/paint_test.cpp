// SPDX-License-Identifier: MIT
#include "picture/paint.h"

#include "picture/make.h"
#include "planned_call.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace picture_tests::paint_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

hrbfnpr_dab dab_at(std::uint32_t map, glm::dvec3 position, glm::dvec3 normal, double radius, double strength,
                   double value, glm::dvec3 direction) {
    auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
    dab.map = map;
    for (int axis = 0; axis < 3; ++axis) {
        dab.position[axis] = position[axis];
        dab.normal[axis] = normal[axis];
        dab.direction[axis] = direction[axis];
    }
    dab.radius = radius;
    dab.strength = strength;
    dab.value = value;
    return dab;
}

// Returns two dabs that overlap.
std::array<hrbfnpr_dab, 2> two_dabs(std::uint32_t map) {
    return {dab_at(map, {0.1, 0.2, 0.3}, {0.0, 0.0, 1.0}, 0.5, 0.8, 0.1, {1.0, 0.0, 0.0}),
            dab_at(map, {0.3, 0.2, 0.3}, {0.0, 0.6, 0.8}, 0.4, 1.0, 0.9, {0.0, 1.0, 0.25})};
}
const std::array<glm::dvec3, 4> places{glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0.25, 0.25, 0.3),
                                       glm::dvec3(0.35, 0.1, 0.4), glm::dvec3(2.0)};
const std::array<glm::dvec3, 4> normals{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.6, 0.0, 0.8),
                                        glm::dvec3(0.0, -0.6, 0.8), glm::dvec3(0.0, 0.0, -1.0)};

struct Evaluated {
    std::array<double, 12> values{};
    std::array<double, 4> weights{};
};

// Evaluates a field at the four places.
Evaluated evaluated(const hrbfnpr_field* field, std::uint32_t components) {
    Evaluated found;
    const hrbfnpr_array at{&places[0].x, 4, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array facing{&normals[0].x, 4, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array_out values{found.values.data(), 4, 0, HRBFNPR_SCALAR_FLOAT64, components};
    const hrbfnpr_array_out weights{found.weights.data(), 4, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_field_evaluate(field, &at, &facing, &values, &weights, nullptr, error);
    });
    return found;
}

// Returns a field that has the same value everywhere.
Field constant_field(const Call& call, std::uint32_t kind, const std::array<double, 3>& value) {
    auto desc = defaults<hrbfnpr_field_desc>(hrbfnpr_field_desc_init);
    const glm::dvec3 point(0.0);
    desc.kind = kind;
    desc.points = {&point.x, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.values = {value.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, kind == HRBFNPR_FIELD_KIND_SCALAR ? 1U : 3U};
    return make<Field>([&](hrbfnpr_field** made, hrbfnpr_error* error) {
        return hrbfnpr_field_create(&call.context, &desc, nullptr, made, error);
    });
}

// A reference program in Python computed the expected values.
TEST(Paint, EachMapReachesItsLayers) {
    std::vector<hrbfnpr_dab> dabs;
    for (const std::uint32_t map : {HRBFNPR_DAB_TONE, HRBFNPR_DAB_DENSITY, HRBFNPR_DAB_DIRECTION})
        for (const hrbfnpr_dab& dab : two_dabs(map)) dabs.push_back(dab);
    PlannedCall given;
    given.desc.dabs = dabs.data();
    given.desc.dab_count = static_cast<std::int64_t>(dabs.size());
    const Call call = given.call();
    Marks marks(call.pool);
    for (const std::uint32_t kind : {HRBFNPR_LAYER_KIND_STIPPLES, HRBFNPR_LAYER_KIND_HATCH}) {
        marks.layers.push_back(defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init));
        marks.layers.back().kind = kind;
    }
    set_paint(call, marks);
    EXPECT_EQ(marks.dabs.size(), 4U); // Dabs of tone do not decide where marks are.
    EXPECT_EQ(marks.layers[0].direction_field, nullptr);
    EXPECT_EQ(marks.layers[1].density_field, nullptr);
    ASSERT_EQ(marks.layers[0].density, std::uint32_t{HRBFNPR_DENSITY_FIELD});
    const Evaluated density = evaluated(marks.layers[0].density_field, 1);
    const Marks copy(marks); // The copy keeps the fields alive.
    marks = Marks(call.pool);
    const Evaluated direction = evaluated(copy.layers[1].direction_field, 3);
    const std::array expected{0.62875, 0.870271875, 0.841636775390625, 1.0};
    const std::array<glm::dvec3, 4> ways{
        glm::dvec3(0.35, 0.5625, 0.140625), glm::dvec3(0.0398671875, 0.9384765625, 0.234619140625),
        glm::dvec3(0.09390076171875, 0.738525390625, 0.18463134765625), glm::dvec3(0.0)};
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(1.0 + density.weights[i] * (density.values[i] - 1.0), expected[i], 1e-14);
        EXPECT_EQ(direction.weights[i], i < 3 ? 1.0 : 0.0); // A faint direction counts fully.
        const glm::dvec3 way(direction.values[3 * i], direction.values[3 * i + 1], direction.values[3 * i + 2]);
        EXPECT_NEAR(glm::length(glm::cross(way, ways[i])), 0.0, 1e-14);
    }
}

TEST(Paint, NumbersLieOverOthers) {
    const auto dabs = two_dabs(HRBFNPR_DAB_TONE);
    PlannedCall given;
    given.desc.dabs = dabs.data();
    given.desc.dab_count = 2;
    const Call call = given.call();
    const Field painted = field_of_dabs(call, HRBFNPR_DAB_TONE);
    EXPECT_FALSE(field_of_dabs(call, HRBFNPR_DAB_DENSITY));
    const Evaluated above = evaluated(painted.get(), 1);
    const Field below = constant_field(call, HRBFNPR_FIELD_KIND_SCALAR, {0.5});
    const Evaluated both = evaluated(numbers_over(call, below, painted)->field.get(), 1);
    const Evaluated alone = evaluated(numbers_over(call, {}, painted)->field.get(), 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(both.weights[i], 1.0);
        EXPECT_NEAR(both.values[i], 0.5 + above.weights[i] * (above.values[i] - 0.5), 1e-15);
        EXPECT_EQ(alone.weights[i], above.weights[i]);
        EXPECT_NEAR(alone.values[i], above.values[i], 1e-15);
    }
}

TEST(Paint, DirectionsReplaceOthersInTheWholeDab) {
    auto dab = two_dabs(HRBFNPR_DAB_DIRECTION)[0];
    dab.strength = 0.25;
    PlannedCall given;
    given.desc.dabs = &dab;
    given.desc.dab_count = 1;
    const Call call = given.call();
    const Field painted = field_of_dabs(call, HRBFNPR_DAB_DIRECTION);
    const Field below = constant_field(call, HRBFNPR_FIELD_KIND_DIRECTION, {-1.0, -1.0, 0.0});
    const Evaluated both = evaluated(directions_over(call, below, painted)->field.get(), 3);
    EXPECT_NEAR(both.values[1] / both.values[0], 0.0, 1e-15);  // inside the dab
    EXPECT_NEAR(both.values[10] / both.values[9], 1.0, 1e-15); // far from it
    EXPECT_EQ(both.weights[0], 1.0);
    EXPECT_EQ(both.weights[3], 1.0);
}

} // namespace
} // namespace picture_tests::paint_test
