// SPDX-License-Identifier: MIT
#include "frame/scene/lighting.h"

#include "base/assert.h"
#include "frame/scene/angles.h"
#include "frame/scene/camera.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace hrbfnpr::frame {
namespace {

// Returns the matrix that takes the coordinates of a space to the space of the lighting.
[[nodiscard]] glm::dmat4 between(LightSpace from, LightSpace to, const LitSpace& space) {
    glm::dmat4 to_world(1.0);
    if (from == LightSpace::camera) {
        to_world = glm::inverse(space.view);
        for (int column = 0; column < 3; ++column) to_world[column] /= space.eye_unit;
    } else if (from == LightSpace::item) {
        to_world = space.to_world;
        for (int column = 0; column < 3; ++column) to_world[column] /= space.unit;
        to_world[3] = to_world * glm::dvec4(-space.origin, 1.0);
    }
    return to == LightSpace::camera ? space.view * to_world : to_world;
}

[[nodiscard]] glm::dvec3 unit_or_zero(const glm::dvec3& v) noexcept {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

// Adds a lamp. `origin` is that of the item in the space of the lighting.
void add_lamp(const LightStyle& light, LightSpace to, const LitSpace& space, const glm::dvec3& origin, float fill,
              Lighting& lighting) {
    if (light.kind == LightKind::directional && !(glm::length(light.place) > 0.0)) return;
    Lamp& lamp = lighting.lamps[lighting.count++];
    lamp.intensity = light.intensity;
    lamp.fill = fill;
    lamp.shadow = light.shadow;
    const bool is_place = light.kind == LightKind::place;
    glm::dvec3 place = light.place;
    if (is_place || light.space != to) {
        const glm::dvec4 given(place, is_place ? 1.0 : 0.0);
        place = glm::dvec3(between(light.space, to, space) * given) - (is_place ? origin : glm::dvec3(0.0));
    }
    if (!is_place) place = unit_or_zero(place);
    for (int k = 0; k < 3; ++k) lamp.place[k] = static_cast<float>(place[k]);
    lamp.place[3] = is_place ? 1.0F : 0.0F;
}

[[nodiscard]] glm::vec3 place_of(const Lamp& lamp) noexcept { return {lamp.place[0], lamp.place[1], lamp.place[2]}; }

[[nodiscard]] glm::vec3 times(const float (&m)[3][3], const glm::vec3& v) noexcept {
    const auto dot = [&](const float(&row)[3]) { return row[0] * v.x + row[1] * v.y + row[2] * v.z; };
    return {dot(m[0]), dot(m[1]), dot(m[2])};
}

[[nodiscard]] float power(float x, float exponent) noexcept { return exponent == 1.0F ? x : std::pow(x, exponent); }

// Returns tau of a sum of light. The loops use the same formula.
[[nodiscard]] float tone_of(const Lighting& s, float sum) noexcept {
    const float tau = power(std::clamp((sum - s.black) * s.per_range, 0.0F, 1.0F), s.gamma);
    if (s.steps == 0) return tau;
    const auto last = static_cast<float>(s.steps - 1);
    return std::min(std::floor(tau * static_cast<float>(s.steps)), last) * (1.0F / last);
}

// The shares of ambient light and of the light of lamps that occlusion leaves.
struct LeftOfLight {
    float ambient, lamps;
};
[[nodiscard]] LeftOfLight left_by_occlusion(const Lighting& s, const SeenShares& seen) noexcept {
    const float hidden = 1.0F - power(seen.open, s.occlusion_exponent);
    return {1.0F - s.occlusion * hidden, 1.0F - s.occlusion_lights * hidden};
}
[[nodiscard]] float left_of_lamp(const Lamp& lamp, const SeenShares& seen, std::int32_t number) noexcept {
    return 1.0F - lamp.shadow * (1.0F - seen.visible[static_cast<std::size_t>(number)]);
}

// Returns a lower bound of n . l for all places and normals in the bounds.
[[nodiscard]] float least_facing(const Lamp& lamp, const LitBounds& bounds) noexcept {
    const Angle cone{bounds.cosine, bounds.sine};
    if (lamp.place[3] == 0.0F) return cosines(glm::dot(bounds.axis, place_of(lamp)), cone).least;
    const glm::vec3 towards = place_of(lamp) - bounds.centre;
    const float distance = glm::length(towards);
    if (!(distance > bounds.radius)) return -1.0F;
    const float sine = bounds.radius / distance;
    return cosines(glm::dot(bounds.axis, towards / distance), sum(cone, {std::sqrt(1.0F - sine * sine), sine})).least;
}

} // namespace

Lighting lighting_of(const Style& style, const LitSpace& space) {
    static_assert(std::size(Lighting{}.lamps) == most_lights && std::size(LightShares{}.visible) == most_lights);
    HRBFNPR_ASSERT(style.lights.size() <= most_lights);
    Lighting lighting{};
    const LightStyle key = style.key_light();
    const LightSpace to = key.space == LightSpace::camera ? LightSpace::camera : LightSpace::world;
    const glm::dmat4& own = to == LightSpace::camera ? space.to_eye : space.to_world;
    const glm::mat3 normal = normal_matrix(own);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            lighting.normal[r][c] = normal[c][r];
            lighting.place[r][c] = static_cast<float>(own[c][r]);
        }
    }
    const bool published = style.visibility == Visibility::published || style.tone_rule == ToneRule::published;
    const float fill = published ? 0.0F : style.fill_light;
    add_lamp(key, to, space, glm::dvec3(own[3]), fill, lighting);
    lighting.exponent = static_cast<float>(style.tone_exponent);
    lighting.per_range = lighting.gamma = 1.0F;
    if (published) return lighting; // Published tones come from one light alone.
    for (std::size_t i = 1; i < style.lights.size(); ++i)
        add_lamp(style.lights[i], to, space, glm::dvec3(own[3]), 0.0F, lighting);
    lighting.ambient = 0.5F * (style.ambient_sky + style.ambient_ground);
    lighting.from_sky = 0.5F * (style.ambient_sky - style.ambient_ground);
    const glm::dvec3 up = unit_or_zero(glm::dmat3(between(LightSpace::world, to, space)) * style.ambient_up);
    for (int k = 0; k < 3; ++k) lighting.up[k] = static_cast<float>(up[k]);
    lighting.curvature_contrast = style.curvature_contrast;
    lighting.occlusion = style.occlusion;
    lighting.occlusion_lights = style.occlusion_lights;
    lighting.occlusion_exponent = style.occlusion_exponent;
    lighting.rim = style.rim_light;
    lighting.rim_exponent = style.rim_exponent;
    lighting.black = style.tone_black;
    lighting.per_range = 1.0F / (style.tone_white - style.tone_black);
    lighting.gamma = style.tone_gamma;
    lighting.steps = static_cast<std::int32_t>(style.tone_steps);
    return lighting;
}

Lighting own_lighting(const Lighting& lighting) noexcept {
    HRBFNPR_ASSERT(!lighting.rigid);
    Lighting own = lighting;
    own.rigid = true;
    glm::dmat3 place;
    glm::vec3 up(0.0F);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            place[c][r] = static_cast<double>(lighting.place[r][c]);
            up[c] += lighting.normal[r][c] * lighting.up[r];
        }
    const glm::dmat3 back = glm::inverse(place);
    if (glm::length(up) > 0.0F) up = glm::normalize(up);
    for (int k = 0; k < 3; ++k) own.up[k] = up[k];
    for (std::int32_t i = 0; i < own.count; ++i) {
        const Lamp& given = lighting.lamps[i];
        glm::vec3 towards(0.0F);
        if (given.place[3] == 0.0F) {
            // The sum over rows multiplies by the transposed matrix of normals, so that n . l stays the same.
            for (int k = 0; k < 3; ++k)
                for (int r = 0; r < 3; ++r) towards[k] += lighting.normal[r][k] * given.place[r];
            towards = glm::normalize(towards);
        } else {
            towards = glm::vec3(back * glm::dvec3(place_of(given)));
        }
        for (int k = 0; k < 3; ++k) own.lamps[i].place[k] = towards[k];
    }
    return own;
}

float light_at(const Lighting& lighting, const glm::vec3& place, const glm::vec3& normal, float nu,
               const SeenShares& seen) noexcept {
    glm::vec3 at = place;
    glm::vec3 n = normal;
    if (!lighting.rigid) {
        at = times(lighting.place, place);
        n = times(lighting.normal, normal);
        n /= glm::length(n);
    }
    float sum = lighting.ambient;
    sum += lighting.from_sky * glm::dot(glm::vec3(lighting.up[0], lighting.up[1], lighting.up[2]), n);
    float lamps = 0.0F;
    for (std::int32_t i = 0; i < lighting.count; ++i) {
        const Lamp& lamp = lighting.lamps[i];
        glm::vec3 towards = place_of(lamp);
        if (lamp.place[3] != 0.0F) {
            towards -= at;
            towards /= std::sqrt(std::max(glm::dot(towards, towards), 1e-30F));
        }
        const float cosine = glm::dot(towards, n);
        const float away = std::clamp(-cosine, 0.0F, 1.0F);
        lamps +=
            left_of_lamp(lamp, seen, i) * lamp.intensity * power(std::clamp(cosine, 0.0F, 1.0F), lighting.exponent);
        lamps += lamp.fill * away * away;
    }
    const LeftOfLight left = left_by_occlusion(lighting, seen);
    sum = left.ambient * sum + left.lamps * lamps;
    if (lighting.rim > 0.0F)
        sum += lighting.rim * power(std::clamp(1.0F - std::abs(nu), 0.0F, 1.0F), lighting.rim_exponent);
    sum += lighting.curvature_contrast * seen.bend;
    return tone_of(lighting, sum);
}

float facing(const Lighting& lighting, const glm::vec3& place, const glm::vec3& normal) noexcept {
    if (lighting.count == 0) return 0.0F;
    const Lamp& lamp = lighting.lamps[0];
    const glm::vec3 n = lighting.rigid ? normal : times(lighting.normal, normal);
    glm::vec3 towards = place_of(lamp);
    if (lamp.place[3] != 0.0F) {
        towards -= lighting.rigid ? place : times(lighting.place, place);
        towards /= std::sqrt(std::max(glm::dot(towards, towards), 1e-30F));
    }
    return glm::dot(towards, n) / (lighting.rigid ? 1.0F : glm::length(n));
}

float least_light(const Lighting& own, const LitBounds& bounds, const SeenShares& seen) noexcept {
    HRBFNPR_ASSERT(own.rigid);
    const LeftOfLight left = left_by_occlusion(own, seen);
    const Angle cone{bounds.cosine, bounds.sine};
    const Range up = cosines(glm::dot(bounds.axis, glm::vec3(own.up[0], own.up[1], own.up[2])), cone);
    float sum = own.ambient + (own.from_sky > 0.0F ? own.from_sky * up.least : own.from_sky * up.most);
    sum = sum * left.ambient + own.curvature_contrast * seen.bend;
    // The fill light and the rim light are left out, because the terminator may be in between.
    for (std::int32_t i = 0; i < own.count; ++i)
        sum += left.lamps * left_of_lamp(own.lamps[i], seen, i) * own.lamps[i].intensity *
               power(std::max(least_facing(own.lamps[i], bounds), 0.0F), own.exponent);
    return tone_of(own, sum);
}

float lightest_facing(const Lighting& own, float tau, float rounding) noexcept {
    HRBFNPR_ASSERT(rounding > 0.0F);
    constexpr float any = std::numeric_limits<float>::infinity();
    if (!own.rigid || own.count == 0 || own.lamps[0].place[3] != 0.0F || own.steps != 0) return any;
    const float above = tau + 2.0F * rounding;
    if (!(above < 1.0F)) return any;
    const float others = own.ambient - std::abs(own.from_sky);
    const float sum = power(std::max(above, 0.0F), 1.0F / own.gamma) / own.per_range + own.black - others;
    const float lit = power(std::max(sum, 0.0F) / own.lamps[0].intensity, 1.0F / own.exponent);
    const float least =
        tone_of(own, others + own.lamps[0].intensity * power(std::clamp(lit, 0.0F, 1.0F), own.exponent));
    return least > tau + rounding ? lit : any;
}

} // namespace hrbfnpr::frame
