// SPDX-License-Identifier: MIT
#include "picture/paint.h"

#include "picture/handles.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace picture_tests::paint_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

hrbfnpr_dab dab_at(std::uint32_t map, glm::dvec3 position, glm::dvec3 normal, double radius, double strength,
                   double value, glm::dvec3 direction) {
    hrbfnpr_dab dab{};
    dab.struct_size = sizeof dab;
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

// Computes the weight by the formula of the header, dab by dab, without a search.
double weight_by_formula(const hrbfnpr_dab& dab, const glm::dvec3& place, const glm::dvec3& normal) {
    double distance = 0.0, facing = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        distance += (place[axis] - dab.position[axis]) * (place[axis] - dab.position[axis]);
        facing += normal[axis] * dab.normal[axis];
    }
    const double share = distance / (dab.radius * dab.radius);
    return share < 1.0 && facing > 0.0 ? dab.strength * (1.0 - share) * (1.0 - share) : 0.0;
}

class PaintTest : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};
};

// A reference program in Python computed the expected values.
TEST_F(PaintTest, MatchesReferenceValues) {
    const PaintedMap map(two_dabs(HRBFNPR_DAB_DENSITY), HRBFNPR_DAB_DENSITY, pool);
    const std::array density{0.62875, 0.870271875, 0.841636775390625, 1.0};
    const std::array<glm::dvec3, 4> directions{
        glm::dvec3(0.35, 0.5625, 0.140625), glm::dvec3(0.0398671875, 0.9384765625, 0.234619140625),
        glm::dvec3(0.09390076171875, 0.738525390625, 0.18463134765625), glm::dvec3(0.0)};
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_NEAR(map.pulled(1.0, places[i], normals[i]), density[i], 1e-15);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(map.direction(places[i], normals[i])[axis], directions[i][axis], 1e-15);
    }
}

TEST_F(PaintTest, ManyDabsAreFoundByPosition) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0), some(0.01, 0.3);
    std::vector<hrbfnpr_dab> dabs;
    for (int i = 0; i < 300; ++i)
        dabs.push_back(dab_at(static_cast<std::uint32_t>(i % 3), {anywhere(random), anywhere(random), anywhere(random)},
                              {anywhere(random), anywhere(random), anywhere(random)}, some(random), 0.9, some(random),
                              {anywhere(random), anywhere(random), anywhere(random)}));
    const PaintedMap tones(dabs, HRBFNPR_DAB_TONE, pool);
    const PaintedMap ways(dabs, HRBFNPR_DAB_DIRECTION, pool);
    int painted = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 place(anywhere(random), anywhere(random), anywhere(random));
        const glm::dvec3 normal(anywhere(random), anywhere(random), anywhere(random));
        double value = 0.5;
        glm::dvec3 way(0.0);
        for (const hrbfnpr_dab& dab : dabs) {
            const double weight = weight_by_formula(dab, place, normal);
            if (dab.map == HRBFNPR_DAB_TONE) value += weight * (dab.value - value);
            if (dab.map != HRBFNPR_DAB_DIRECTION || weight == 0.0) continue;
            const glm::dvec3 along(dab.direction[0], dab.direction[1], dab.direction[2]);
            way = (1.0 - weight) * way + (glm::dot(way, along) < 0.0 ? -weight : weight) * along;
            ++painted;
        }
        ASSERT_DOUBLE_EQ(tones.pulled(0.5, place, normal), value);
        for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(ways.direction(place, normal)[axis], way[axis], 1e-15);
    }
    EXPECT_GT(painted, 100);
}

TEST_F(PaintTest, NothingIsPaintedBeyondTheEdgeOrOnTheBack) {
    const auto dabs = two_dabs(HRBFNPR_DAB_TONE);
    const PaintedMap map({dabs.data(), 1}, HRBFNPR_DAB_TONE, pool);
    const glm::dvec3 middle = places[0];
    EXPECT_NEAR(map.pulled(1.0, middle, {0.0, 0.0, 1.0}), 1.0 - 0.8 * 0.9, 1e-15);
    EXPECT_EQ(map.pulled(1.0, middle, {0.0, 0.0, -1.0}), 1.0);
    EXPECT_EQ(map.pulled(1.0, middle, {1.0, 0.0, 0.0}), 1.0); // This normal is perpendicular to the dab's.
    EXPECT_EQ(map.pulled(1.0, middle + glm::dvec3(0.5 + 1e-9, 0.0, 0.0), {0.0, 0.0, 1.0}), 1.0);
    EXPECT_LT(map.pulled(1.0, middle + glm::dvec3(0.4, 0.0, 0.0), {0.0, 0.0, 1.0}), 1.0);
    EXPECT_EQ(map.pulled(1.0, glm::dvec3(not_a_number), {0.0, 0.0, 1.0}), 1.0);
    EXPECT_EQ(map.pulled(1.0, glm::dvec3(1e300), {0.0, 0.0, 1.0}), 1.0);
    const PaintedMap none({}, HRBFNPR_DAB_TONE, pool);
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.pulled(0.5, middle, {0.0, 0.0, 1.0}), 0.5);
    EXPECT_EQ(none.direction(middle, {0.0, 0.0, 1.0}), glm::dvec3(0.0));
    auto vast = dabs[0];
    vast.radius = 1e299;
    const PaintedMap far(std::span(&vast, 1), HRBFNPR_DAB_TONE, pool);
    EXPECT_NEAR(far.pulled(1.0, glm::dvec3(1e6), {0.0, 0.0, 1.0}), 1.0 - 0.8 * 0.9, 1e-15);
}

TEST_F(PaintTest, TonesStartFromTheLightOfTheStyle) {
    Style style(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, pool);
    const std::array light{1.0, 2.0, 2.0};
    std::copy(light.begin(), light.end(), style.base.light);
    style.base.light_space = HRBFNPR_LIGHT_CAMERA;
    style.base.tone_exponent = 1.5;
    style.base.fill_light = 0.25F;
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    const std::array eye{3.0, 2.0, 1.0}, target{0.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
    ASSERT_EQ(hrbfnpr_camera_look_at(&camera, eye.data(), target.data(), up.data(), nullptr), HRBFNPR_STATUS_OK);
    Marks marks(pool);
    set_paint(two_dabs(HRBFNPR_DAB_TONE), camera, style, marks, pool);
    ASSERT_EQ(style.base.tone, std::uint32_t{HRBFNPR_TONE_CALLBACK});
    std::array<float, 12> at{}, facing{};
    for (std::size_t i = 0; i < places.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            at[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(places[i][axis]);
            facing[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(normals[i][axis]);
        }
    std::array<float, 4> tau{};
    const Style copy(style); // The copy holds the paint, too.
    style = Style(pool);
    EXPECT_EQ(copy.base.tone_function(copy.base.tone_user, 4, at.data(), facing.data(), tau.data()), 0);
    const std::array expected{0.5426253080368042F, 0.848617672920227F, 0.6977830529212952F, 0.12555603682994843F};
    for (std::size_t i = 0; i < tau.size(); ++i) EXPECT_FLOAT_EQ(tau[i], expected[i]);
}

TEST_F(PaintTest, EachMapAppliesToItsLayers) {
    std::vector<hrbfnpr_dab> dabs;
    for (const std::uint32_t map : {HRBFNPR_DAB_DENSITY, HRBFNPR_DAB_DIRECTION})
        for (const hrbfnpr_dab& dab : two_dabs(map)) dabs.push_back(dab);
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    Style style(pool);
    Marks marks(pool);
    for (const std::uint32_t kind : {HRBFNPR_LAYER_KIND_STIPPLES, HRBFNPR_LAYER_KIND_HATCH}) {
        marks.layers.push_back(defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init));
        marks.layers.back().kind = kind;
    }
    set_paint(dabs, camera, style, marks, pool);
    EXPECT_EQ(style.base.tone, std::uint32_t{HRBFNPR_TONE_LIGHT});
    EXPECT_EQ(marks.layers[0].density_function, painted_density);
    EXPECT_EQ(marks.layers[0].direction_function, nullptr);
    EXPECT_EQ(marks.layers[1].density_function, nullptr);
    ASSERT_EQ(marks.layers[1].direction_function, painted_direction);
    std::array<double, 3> way{};
    EXPECT_EQ(painted_direction(marks.layers[1].direction_user, 1, &places[0].x, &normals[0].x, way.data()), 0);
    EXPECT_NEAR(way[1], 0.5625, 1e-15);
    double density = 0.0;
    EXPECT_EQ(painted_density(marks.layers[0].density_user, 1, &places[0].x, &normals[0].x, &density), 0);
    EXPECT_NEAR(density, 0.62875, 1e-15);
}

TEST_F(PaintTest, ALightWithoutDirectionIsRefused) {
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    Style style(pool);
    std::fill(style.base.light, style.base.light + 3, 0.0);
    Marks marks(pool);
    EXPECT_THROW(set_paint(two_dabs(HRBFNPR_DAB_TONE), camera, style, marks, pool), Error);
    style.base.tone = HRBFNPR_TONE_NONE; // Without a tone no light is needed.
    set_paint(two_dabs(HRBFNPR_DAB_TONE), camera, style, marks, pool);
    EXPECT_EQ(style.base.tone_function, painted_tone);
}

} // namespace
} // namespace picture_tests::paint_test
