// SPDX-License-Identifier: MIT
#include "frame/scene/cluster_view.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::frame {
namespace {

constexpr float anywhere = std::numeric_limits<float>::infinity();

[[nodiscard]] glm::vec3 vector(const std::array<float, 3>& a) noexcept { return {a[0], a[1], a[2]}; }

void set_rows(float (&to)[3][3], const glm::mat3& from) noexcept {
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) to[r][c] = from[c][r];
}

Seer seer_of(const ItemView& item, const Lens& lens) noexcept {
    Seer seer{};
    glm::mat4 to_eye(item.to_eye);
    to_eye[3] = glm::vec4(item.eye_offset, 1.0F);
    const glm::mat4 to_clip(glm::dmat4(lens.window) * glm::dmat4(to_eye));
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            seer.clip[r][c] = to_clip[c][r];
            if (r < 3) seer.eye[r][c] = to_eye[c][r];
        }
    set_rows(seer.normal, item.normal_to_eye);
    seer.light = item.light;
    for (int k = 0; k < 3; ++k) seer.centre[k] = lens.centre[k];
    seer.parallel = lens.centre.w == 0.0F;
    seer.pixels = lens.pixels;
    return seer;
}

// Cosine and sine of an angle in [0, pi].
struct Angle {
    float cosine, sine;
};

[[nodiscard]] Angle sum(const Angle& a, const Angle& b) noexcept {
    const float sine = a.sine * b.cosine + a.cosine * b.sine;
    if (sine < 0.0F) return {-1.0F, 0.0F}; // beyond pi
    return {a.cosine * b.cosine - a.sine * b.sine, sine};
}

struct Range {
    float least, most;
};

// Cosines of the angles that differ by no more than `spread` from one whose cosine is `middle`.
[[nodiscard]] Range cosines(float middle, const Angle& spread) noexcept {
    HRBFNPR_ASSERT(spread.sine >= 0.0F && spread.sine <= 1.001F && std::abs(spread.cosine) <= 1.001F);
    middle = std::clamp(middle, -1.0F, 1.0F);
    const float sine = std::sqrt(1.0F - middle * middle);
    const float both = middle * spread.cosine;
    const float side = sine * spread.sine;
    return {middle > -spread.cosine ? both - side : -1.0F, middle < spread.cosine ? both + side : 1.0F};
}

// Where a ball lies. `beyond` is how far it surely lies outside of a side of the picture, in pixels times w; outside of
// the range of depths it is infinite.
struct Sides {
    float beyond = -anywhere;
    bool inside = true; // surely
};

[[nodiscard]] Sides sides_of(const glm::vec4& eye, float radius, const Frustum& frustum) noexcept {
    Sides sides;
    for (std::size_t k = 0; k < frustum.plane.size(); ++k) {
        const float distance = glm::dot(frustum.plane[k], eye);
        const float slack = radius * frustum.norm[k];
        const float outside = -slack - distance;
        sides.beyond = std::max(sides.beyond, k < 4 ? outside : outside > 0.0F ? anywhere : -anywhere);
        sides.inside = sides.inside && distance > slack;
    }
    return sides;
}

} // namespace

ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept {
    ItemSight sight{seer_of(item, lens)};
    const glm::mat3 square = glm::transpose(item.to_eye) * item.to_eye;
    const float mean = (square[0][0] + square[1][1] + square[2][2]) / 3.0F;
    float largest = 0.0F;
    float off = 0.0F;
    for (int r = 0; r < 3; ++r) {
        largest = std::max(largest, std::abs(square[0][r]) + std::abs(square[1][r]) + std::abs(square[2][r]));
        for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(square[c][r] - (c == r ? mean : 0.0F)));
    }
    sight.scale = std::sqrt(largest);
    const glm::vec4 middle(item.to_eye * item.centre + item.eye_offset, 1.0F);
    sight.inside = sides_of(middle, item.radius * sight.scale * scene_tuning.rounding, frustum).inside;
    const glm::dmat3 back = glm::inverse(glm::dmat3(item.to_eye));
    const glm::dvec3 centre(lens.centre);
    sight.eye = sight.seer.parallel ? glm::vec3(glm::normalize(back * centre))
                                    : glm::vec3(back * (centre - glm::dvec3(item.eye_offset)));
    if (!(off <= scene_tuning.angle_tolerance * mean)) return sight;
    // Normals keep their lengths, and the light comes to them.
    set_rows(sight.seer.normal, item.normal_to_eye / std::cbrt(std::abs(glm::determinant(item.normal_to_eye))));
    Light& light = sight.seer.light;
    glm::vec3 towards(0.0F);
    for (int k = 0; k < 3; ++k)
        for (int r = 0; r < 3; ++r) towards[k] += light.normal[r][k] * light.towards[r];
    if (glm::length(towards) > 0.0F) sight.light = glm::normalize(towards);
    for (int k = 0; k < 3; ++k) light.towards[k] = sight.light[k];
    sight.seer.rigid = light.rigid = true;
    return sight;
}

Frustum frustum_of(const Lens& lens) noexcept {
    const glm::vec4 x = glm::row(lens.window, 0);
    const glm::vec4 y = glm::row(lens.window, 1);
    const glm::vec4 depth = glm::row(lens.window, 2);
    const glm::vec4 w = glm::row(lens.window, 3);
    const glm::vec4& v = lens.viewport;
    Frustum frustum;
    frustum.plane = {x - v.x * w, (v.x + v.z) * w - x, y - v.y * w, (v.y + v.w) * w - y, depth, w - depth};
    for (std::size_t k = 0; k < frustum.plane.size(); ++k) frustum.norm[k] = glm::length(glm::vec3(frustum.plane[k]));
    frustum.w_norm = glm::length(glm::vec3(w));
    return frustum;
}

ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens,
                         const Frustum& frustum) noexcept {
    HRBFNPR_ASSERT(extent.radius >= 0.0F);
    ClusterView view;
    const glm::vec3 own = vector(extent.centre);
    const Seer& seer = sight.seer;
    const auto dot_row = [&](const float(&r)[4]) { return r[0] * own.x + r[1] * own.y + r[2] * own.z + r[3]; };
    const glm::vec4 eye(dot_row(seer.eye[0]), dot_row(seer.eye[1]), dot_row(seer.eye[2]), 1.0F);
    const float radius = extent.radius * sight.scale * scene_tuning.rounding;
    const float w = dot_row(seer.clip[3]);
    const float w_most = w + radius * frustum.w_norm;
    if (w_most > 0.0F) view.pixels_per_unit = lens.pixels / (w > 0.0F ? w : w_most);
    if (!(w - radius * frustum.w_norm > 0.0F)) return view; // some may be after the camera's plane
    view.nearest = w - radius * frustum.w_norm;
    const Sides sides = sight.inside ? Sides{} : sides_of(eye, radius, frustum);
    view.beyond = sides.beyond / w_most;
    view.inside = sides.inside;
    if (!seer.rigid) return view;
    const glm::vec3 axis = vector(extent.axis);
    const Angle cone{extent.cone_cosine, extent.cone_sine};
    view.lit_min = cosines(glm::dot(axis, sight.light), cone).least;
    Angle spread = cone;
    glm::vec3 sight_line = sight.eye;
    if (!seer.parallel) {
        sight_line = own - sight.eye;
        const float distance = glm::length(sight_line);
        if (!(distance > extent.radius)) return view;
        const float sine = extent.radius / distance;
        spread = sum(cone, {std::sqrt(1.0F - sine * sine), sine});
        sight_line /= distance;
    }
    const Range nu = cosines(glm::dot(axis, sight_line), spread);
    view.nu_min = nu.least;
    view.nu_max = nu.most;
    return view;
}

// At a place v from the eye, n within the cone has n . v >= |v| cos(a + c), a the angle between v and the axis, c the
// cone's; and elsewhere in the ball n . v is less by no more than its radius. No root is taken.
bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept {
    HRBFNPR_ASSERT(extent.radius >= 0.0F);
    if (!sight.seer.rigid || !(extent.cone_cosine > 0.0F)) return false;
    const glm::vec3 v = sight.seer.parallel ? sight.eye : vector(extent.centre) - sight.eye;
    const float radius = sight.seer.parallel ? 0.0F : extent.radius;
    const float along = glm::dot(vector(extent.axis), v);
    const float least = along * extent.cone_cosine - radius;
    const float across = glm::dot(v, v) - along * along;
    return along > 0.0F && least > 0.0F &&
           least * least > 1.001F * std::max(across, 0.0F) * extent.cone_sine * extent.cone_sine;
}

float least_lit(const marks::StrokePiece& piece, const ItemSight& sight) noexcept {
    if (!sight.seer.rigid) return -1.0F;
    return cosines(glm::dot(vector(piece.tone_axis), sight.light), {piece.tone_cosine, piece.tone_sine}).least;
}

} // namespace hrbfnpr::frame
