// SPDX-License-Identifier: MIT
// The tones of lights: the loops against the formulas for one place, and the bounds against many places.
#include "frame/scene/camera.h"
#include "frame/scene/lighting.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace hrbfnpr::frame::lighting_test {
namespace {

glm::vec3 unit(float at) { return glm::normalize(glm::vec3(std::sin(at), std::cos(1.7F * at), std::sin(2.3F * at))); }

LitSpace space_of(const glm::dmat4& to_world) {
    LitSpace space;
    space.view = glm::translate(glm::rotate(glm::dmat4(1.0), 0.7, {0.3, 1.0, 0.2}), {0.1, -0.2, -6.0});
    space.to_world = to_world;
    space.to_eye = space.view * to_world;
    return space;
}

glm::dmat4 turned() {
    return glm::rotate(glm::scale(glm::translate(glm::dmat4(1.0), {0.5, 1.0, -0.4}), glm::dvec3(1.7)), 1.1,
                       {1.0, 0.3, -0.5});
}
glm::dmat4 stretched() { return glm::scale(turned(), {1.0, 2.0, 0.6}); }

struct AllTerms {
    std::array<LightStyle, 4> lights{LightStyle{LightKind::directional, LightSpace::camera, {-0.4, 0.6, 0.7}, 0.7F},
                                     LightStyle{LightKind::place, LightSpace::world, {3.0, 2.0, 1.0}, 0.5F},
                                     LightStyle{LightKind::place, LightSpace::item, {-0.5, 0.4, 2.0}, 0.2F},
                                     LightStyle{LightKind::directional, LightSpace::item, {1.0, 0.0, 0.2}, 0.3F}};
    Style style;

    AllTerms() {
        style.lights = lights;
        style.ambient_sky = 0.2F;
        style.ambient_ground = 0.05F;
        style.ambient_up = {0.1, 0.2, 1.0};
        style.rim_light = 0.15F;
        style.tone_black = 0.05F;
        style.tone_white = 1.2F;
        style.tone_gamma = 1.3F;
        style.curvature_contrast = 0.4F;
    }
};

std::vector<Style> styles(const AllTerms& all) {
    std::vector<Style> found{Style(), all.style};
    Style sharp = all.style;
    sharp.tone_exponent = 2.5;
    found.push_back(sharp);
    Style steps = all.style;
    steps.tone_steps = 4;
    found.push_back(steps);
    Style below = all.style;
    below.ambient_sky = 0.0F;
    below.ambient_ground = 0.3F;
    found.push_back(below);
    return found;
}

TEST(Lighting, IsTheSameForOnePlaceAndForRows) {
    constexpr std::int64_t count = 61;
    constexpr std::size_t room = count + 16; // a vector may end beyond the last mark
    std::array<std::array<float, room>, 9> row{};
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 n = unit(static_cast<float>(i));
        const glm::vec3 p = 1.5F * unit(0.37F * static_cast<float>(i));
        for (int k = 0; k < 3; ++k) {
            row[static_cast<std::size_t>(k)][i] = p[k];
            row[static_cast<std::size_t>(3 + k)][i] = n[k];
        }
        row[6][i] = std::sin(static_cast<float>(i));
        row[8][i] = std::cos(static_cast<float>(3 * i));
    }
    LightShares shares;
    shares.bend = row[8].data();
    const AllTerms all;
    for (const Style& style : styles(all))
        for (const glm::dmat4& transform : {glm::dmat4(1.0), turned(), stretched()}) {
            Lighting lighting = lighting_of(style, space_of(transform));
            for (const bool own : {false, true}) {
                if (own) lighting = own_lighting(lighting);
                for (const base::InstructionSet set : test::instruction_sets()) {
                    projection_loops(set).light_rows(lighting,
                                                     {row[0].data(), row[1].data(), row[2].data(), row[3].data(),
                                                      row[4].data(), row[5].data(), count},
                                                     row[6].data(), shares, row[7].data());
                    for (std::size_t i = 0; i < count; ++i) {
                        SeenShares seen;
                        seen.bend = row[8][i];
                        EXPECT_NEAR(row[7][i],
                                    light_at(lighting, {row[0][i], row[1][i], row[2][i]},
                                             {row[3][i], row[4][i], row[5][i]}, row[6][i], seen),
                                    style.tone_steps > 0 ? 0.34F : 2e-6F)
                            << i;
                    }
                }
            }
        }
}

// A plain reference, in world space: all lights, places and normals are transformed there.
double plain_tone(const Style& style, const LitSpace& space, const glm::dvec3& place, const glm::dvec3& normal,
                  double nu) {
    const glm::dvec3 at(space.to_world * glm::dvec4(place, 1.0));
    const glm::dvec3 n = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(space.to_world))) * normal);
    double sum = 0.0;
    for (const LightStyle& light : style.lights) {
        const glm::dmat4 to_world = light.space == LightSpace::camera ? glm::inverse(space.view)
                                    : light.space == LightSpace::item ? space.to_world
                                                                      : glm::dmat4(1.0);
        const bool is_place = light.kind == LightKind::place;
        const glm::dvec3 l(to_world * glm::dvec4(light.place, is_place ? 1.0 : 0.0));
        sum += double{light.intensity} *
               std::pow(std::max(0.0, glm::dot(n, glm::normalize(is_place ? l - at : l))), style.tone_exponent);
    }
    const glm::dvec3 first(glm::inverse(space.view) * glm::dvec4(style.lights[0].place, 0.0));
    const double away = std::max(0.0, -glm::dot(n, glm::normalize(first)));
    sum += double{style.fill_light} * away * away;
    const double up = glm::dot(n, glm::normalize(style.ambient_up));
    sum += 0.5 * (1.0 + up) * double{style.ambient_sky} + 0.5 * (1.0 - up) * double{style.ambient_ground};
    sum += double{style.rim_light} * std::pow(1.0 - std::abs(nu), double{style.rim_exponent});
    const double range = double{style.tone_white} - double{style.tone_black};
    return std::pow(std::clamp((sum - double{style.tone_black}) / range, 0.0, 1.0), double{style.tone_gamma});
}

TEST(Lighting, IsTheSumInWorldSpace) {
    const AllTerms all;
    for (const glm::dmat4& transform : {glm::dmat4(1.0), turned(), stretched()}) {
        const LitSpace space = space_of(transform);
        const Lighting lighting = lighting_of(all.style, space);
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 n = unit(static_cast<float>(i));
            const glm::vec3 p = 1.5F * unit(0.37F * static_cast<float>(i));
            const float nu = std::sin(static_cast<float>(i));
            EXPECT_NEAR(light_at(lighting, p, n, nu), plain_tone(all.style, space, p, n, double{nu}), 2e-6) << i;
        }
    }
}

TEST(Lighting, OfTheItemIsTheSameWhereAnglesAreKept) {
    const AllTerms all;
    const Lighting lighting = lighting_of(all.style, space_of(turned()));
    const Lighting own = own_lighting(lighting);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 n = unit(static_cast<float>(i));
        const glm::vec3 p = 1.5F * unit(0.37F * static_cast<float>(i));
        EXPECT_NEAR(light_at(lighting, p, n, 0.3F), light_at(own, p, n, 0.3F), 2e-6F);
        EXPECT_NEAR(facing(lighting, p, n), facing(own, p, n), 2e-6F);
    }
}

TEST(Lighting, DoesNotDependOnOriginAndUnit) {
    const AllTerms all;
    LitSpace space = space_of(turned());
    const Lighting lighting = lighting_of(all.style, space);
    LitSpace moved = space;
    moved.origin = {3.0, -2.0, 5.0};
    moved.unit = 4.0;
    moved.eye_unit = 8.0;
    for (int column = 0; column < 4; ++column)
        for (int r = 0; r < 3; ++r) moved.view[column][r] /= 8.0;
    moved.to_world[3] = space.to_world * glm::dvec4(moved.origin, 1.0);
    for (int column = 0; column < 3; ++column) moved.to_world[column] *= 4.0;
    moved.to_eye = moved.view * moved.to_world;
    const Lighting other = lighting_of(all.style, moved);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 n = unit(static_cast<float>(i));
        const glm::vec3 p = 1.5F * unit(0.37F * static_cast<float>(i));
        const glm::vec3 own((glm::dvec3(p) - moved.origin) / moved.unit);
        EXPECT_NEAR(light_at(lighting, p, n, 0.3F), light_at(other, own, n, 0.3F), 4e-6F);
    }
}

TEST(Lighting, BoundsHoldForAllPlacesAndNormals) {
    const AllTerms all;
    for (const Style& style : styles(all)) {
        const Lighting own = own_lighting(lighting_of(style, space_of(turned())));
        for (int i = 0; i < 100; ++i) {
            const float angle = 0.05F + 0.02F * static_cast<float>(i % 40);
            const LitBounds bounds{1.4F * unit(0.9F * static_cast<float>(i)), 0.05F + 0.01F * static_cast<float>(i),
                                   unit(static_cast<float>(i)), std::cos(angle), std::sin(angle)};
            SeenShares least_seen;
            least_seen.bend = -0.6F;
            const float least = least_light(own, bounds, least_seen);
            const glm::vec3 side = glm::normalize(glm::cross(bounds.axis, unit(7.7F)));
            for (int k = 0; k < 200; ++k) {
                const float turn = angle * std::sin(static_cast<float>(3 * k));
                const glm::vec3 other = glm::normalize(glm::cross(bounds.axis, side));
                const float around = 0.7F * static_cast<float>(k);
                const glm::vec3 away = std::cos(around) * side + std::sin(around) * other;
                const glm::vec3 n = std::cos(turn) * bounds.axis + std::sin(turn) * away;
                const glm::vec3 p = bounds.centre + bounds.radius * std::cos(static_cast<float>(k)) *
                                                        unit(0.3F * static_cast<float>(k));
                SeenShares seen;
                seen.bend = 0.6F * std::sin(static_cast<float>(k));
                EXPECT_GE(light_at(own, p, n, 0.5F, seen), least - 1e-5F) << i << " " << k;
            }
        }
    }
}

TEST(Lighting, IsAboveAToneWhereTheFirstLampIsFacedEnough) {
    const AllTerms all;
    std::vector<Style> tried = styles(all);
    for (const double exponent : {0.5, 1.0, 3.0}) {
        Style style;
        style.tone_exponent = exponent;
        tried.push_back(style);
    }
    for (const Style& style : tried) {
        const Lighting own = own_lighting(lighting_of(style, space_of(turned())));
        for (float tau = 0.0F; tau <= 1.0F; tau += 0.05F) {
            const float lightest = lightest_facing(own, tau, 1e-4F);
            for (int i = 0; i < 300; ++i) {
                const glm::vec3 n = unit(static_cast<float>(i));
                const glm::vec3 p = 1.5F * unit(0.37F * static_cast<float>(i));
                EXPECT_TRUE(facing(own, p, n) <= lightest || light_at(own, p, n, 0.5F) > tau) << tau << " " << i;
            }
        }
    }
}

float simple(float cosine, double exponent, float fill) {
    Style style;
    style.tone_exponent = exponent;
    style.fill_light = fill;
    style.light = {0.0, 0.0, 1.0};
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    return light_at(lighting_of(style, {}), glm::vec3(0.0F), {sine, 0.0F, cosine}, -1.0F);
}

TEST(Lighting, OfOneLightIsThePowerOfTheCosine) {
    EXPECT_EQ(simple(-0.5F, 1.0, 0.0F), 0.0F);
    EXPECT_FLOAT_EQ(simple(0.3F, 1.0, 0.0F), 0.3F);
    EXPECT_FLOAT_EQ(simple(0.5F, 2.0, 0.0F), 0.25F);
    EXPECT_NEAR(simple(0.25F, 0.5, 0.0F), 0.5F, 1e-7);
    EXPECT_EQ(simple(1.0F, 1.0, 0.0F), 1.0F);
}

TEST(Lighting, OfTheFillIsTheSquaredCosineOnTheDarkSide) {
    for (const float fill : {0.0F, 0.25F, 1.0F}) {
        EXPECT_FLOAT_EQ(simple(-0.5F, 1.0, fill), 0.25F * fill);
        EXPECT_EQ(simple(-1.0F, 1.0, fill), fill);
        EXPECT_EQ(simple(0.0F, 1.0, fill), 0.0F);
        for (const double exponent : {0.5, 1.0, 2.0})
            EXPECT_EQ(simple(0.3F, exponent, fill), simple(0.3F, exponent, 0.0F)) << "the lit side stays";
    }
}

TEST(Lighting, OfPublishedStylesHasNoFill) {
    Style style;
    style.fill_light = 0.4F;
    EXPECT_EQ(lighting_of(style, {}).lamps[0].fill, 0.4F);
    style.tone_rule = ToneRule::published;
    EXPECT_EQ(lighting_of(style, {}).lamps[0].fill, 0.0F);
    style.tone_rule = ToneRule::share;
    style.visibility = Visibility::published;
    EXPECT_EQ(lighting_of(style, {}).lamps[0].fill, 0.0F);
}

TEST(Lighting, OfRidgesIsMoreThanThatOfHollows) {
    Style style;
    style.light = {0.0, 0.0, 1.0};
    style.curvature_contrast = 0.5F;
    const Lighting lighting = lighting_of(style, {});
    const auto tone = [&](float bend) {
        SeenShares seen;
        seen.bend = bend;
        return light_at(lighting, glm::vec3(0.0F), {0.8F, 0.0F, 0.6F}, -1.0F, seen);
    };
    EXPECT_FLOAT_EQ(tone(0.0F), 0.6F);
    EXPECT_FLOAT_EQ(tone(0.4F), 0.8F);
    EXPECT_FLOAT_EQ(tone(-1.0F), 0.1F);
}

TEST(Lighting, StepsAreFlatFromBlackToWhite) {
    Style style;
    style.tone_steps = 3;
    style.light = {0.0, 0.0, 1.0};
    const Lighting lighting = lighting_of(style, {});
    const auto tone = [&](float z) {
        return light_at(lighting, glm::vec3(0.0F), {std::sqrt(1.0F - z * z), 0.0F, z}, -1.0F);
    };
    EXPECT_EQ(tone(0.0F), 0.0F);
    EXPECT_EQ(tone(0.3F), 0.0F);
    EXPECT_EQ(tone(0.4F), 0.5F);
    EXPECT_EQ(tone(0.6F), 0.5F);
    EXPECT_EQ(tone(0.7F), 1.0F);
    EXPECT_EQ(tone(1.0F), 1.0F);
}

} // namespace
} // namespace hrbfnpr::frame::lighting_test
