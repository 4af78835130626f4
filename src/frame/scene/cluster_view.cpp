// SPDX-License-Identifier: MIT
#include "frame/scene/cluster_view.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr float angle_tolerance = 1e-4F;

void set_row(float (&to)[4], const glm::vec4& from) noexcept {
    for (int k = 0; k < 4; ++k) to[k] = from[k];
}
void set_rows(float (&to)[3][3], const glm::mat3& from) noexcept {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) to[r][c] = from[c][r];
    }
}

Seer seer_of(const ItemView& item, const Lens& lens) noexcept {
    Seer seer{};
    glm::mat4 to_eye(item.to_eye);
    to_eye[3] = glm::vec4(item.eye_offset, 1.0F);
    const glm::mat4 to_clip(glm::dmat4(lens.window) * glm::dmat4(to_eye));
    for (int r = 0; r < 4; ++r) set_row(seer.clip[r], glm::row(to_clip, r));
    for (int r = 0; r < 3; ++r) set_row(seer.eye[r], glm::row(to_eye, r));
    set_rows(seer.normal, item.normal_to_eye);
    set_rows(seer.normal_light, item.normal_to_light);
    for (int k = 0; k < 3; ++k) {
        seer.light[k] = item.light[k];
        seer.centre[k] = lens.centre[k];
    }
    seer.parallel = lens.centre.w == 0.0F;
    seer.pixels = lens.pixels;
    return seer;
}

[[nodiscard]] glm::vec3 vector(const std::array<float, 3>& a) noexcept { return {a[0], a[1], a[2]}; }

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
    middle = std::clamp(middle, -1.0F, 1.0F);
    const float sine = std::sqrt(1.0F - middle * middle);
    const float both = middle * spread.cosine;
    const float side = sine * spread.sine;
    return {middle > -spread.cosine ? both - side : -1.0F, middle < spread.cosine ? both + side : 1.0F};
}

// Where a ball lies.
struct Sides {
    bool outside = false; // surely, even if it is larger by `margin` on the screen
    bool inside = true;   // surely
};

[[nodiscard]] Sides sides_of(const glm::vec4& eye, float radius, float margin, const Frustum& frustum) noexcept {
    Sides sides;
    for (std::size_t k = 0; k < frustum.plane.size(); ++k) {
        const float distance = glm::dot(frustum.plane[k], eye);
        const float slack = radius * frustum.norm[k];
        sides.outside = sides.outside || distance + (k < 4 ? margin : 0.0F) < -slack;
        sides.inside = sides.inside && distance > slack;
    }
    return sides;
}

} // namespace

float lit_of(const ItemView& item, const Seer& seer, const glm::vec3& normal) noexcept {
    if (seer.rigid) return seer.light[0] * normal.x + seer.light[1] * normal.y + seer.light[2] * normal.z;
    const glm::vec3 turned = item.normal_to_light * normal;
    return glm::dot(turned, item.light) / glm::length(turned);
}

ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept {
    ItemSight sight;
    sight.seer = seer_of(item, lens);
    const glm::mat3 square = glm::transpose(item.to_eye) * item.to_eye;
    const float mean = (square[0][0] + square[1][1] + square[2][2]) / 3.0F;
    float largest = 0.0F;
    float off = 0.0F;
    for (int r = 0; r < 3; ++r) {
        largest = std::max(largest, std::abs(square[0][r]) + std::abs(square[1][r]) + std::abs(square[2][r]));
        for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(square[c][r] - (c == r ? mean : 0.0F)));
    }
    sight.rigid = off <= angle_tolerance * mean;
    sight.scale = std::sqrt(largest);
    const glm::vec4 middle(item.to_eye * item.centre + item.eye_offset, 1.0F);
    sight.inside = sides_of(middle, item.radius * sight.scale * 1.0001F, 0.0F, frustum).inside;
    const glm::dmat3 back = glm::inverse(glm::dmat3(item.to_eye));
    const glm::dvec3 centre(lens.centre);
    sight.eye = lens.centre.w == 0.0F ? glm::vec3(glm::normalize(back * centre))
                                      : glm::vec3(back * (centre - glm::dvec3(item.eye_offset)));
    if (!sight.rigid) return sight;
    const glm::vec3 light = glm::transpose(item.normal_to_light) * item.light;
    if (glm::length(light) > 0.0F) sight.light = glm::normalize(light);
    sight.seer.rigid = true;
    set_rows(sight.seer.normal, item.normal_to_eye / std::cbrt(std::abs(glm::determinant(item.normal_to_eye))));
    for (int k = 0; k < 3; ++k) sight.seer.light[k] = sight.light[k];
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

ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens, const Frustum& frustum,
                         float reach) noexcept {
    ClusterView view;
    const glm::vec3 own = vector(extent.centre);
    const Seer& seer = sight.seer;
    const glm::vec4 at(own, 1.0F);
    const auto dot_row = [&](const float(&row)[4]) { return row[0] * at.x + row[1] * at.y + row[2] * at.z + row[3]; };
    const glm::vec4 eye(dot_row(seer.eye[0]), dot_row(seer.eye[1]), dot_row(seer.eye[2]), 1.0F);
    const float radius = extent.radius * sight.scale * 1.0001F;
    const float w = dot_row(seer.clip[3]);
    const float w_most = w + radius * frustum.w_norm;
    if (w_most > 0.0F) view.pixels_per_unit = lens.pixels / (w > 0.0F ? w : w_most);
    if (!(w - radius * frustum.w_norm > 0.0F)) return view; // some may be behind the camera
    view.nearest = w - radius * frustum.w_norm;
    const Sides sides = sight.inside ? Sides{false, true} : sides_of(eye, radius, reach * w_most, frustum);
    view.outside = sides.outside;
    view.inside = sides.inside;
    if (!sight.rigid) return view;
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
// cone's; and elsewhere in the ball n . v is less by no more than its radius.  No root is taken.
bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept {
    if (!sight.rigid || !(extent.cone_cosine > 0.0F)) return false;
    const glm::vec3 v = sight.seer.parallel ? sight.eye : vector(extent.centre) - sight.eye;
    const float radius = sight.seer.parallel ? 0.0F : extent.radius;
    const float along = glm::dot(vector(extent.axis), v);
    const float least = along * extent.cone_cosine - radius;
    const float across = glm::dot(v, v) - along * along;
    return along > 0.0F && least > 0.0F &&
           least * least > 1.001F * std::max(across, 0.0F) * extent.cone_sine * extent.cone_sine;
}

float least_lit(const marks::StrokePiece& piece, const ItemSight& sight) noexcept {
    if (!sight.rigid) return -1.0F;
    return cosines(glm::dot(vector(piece.tone_axis), sight.light), {piece.tone_cosine, piece.tone_sine}).least;
}

float pixels_per_unit_at(const marks::Cluster& cluster, const ItemSight& sight, const Lens& lens) noexcept {
    const float(&row)[4] = sight.seer.clip[3];
    const float w = row[0] * cluster.centre[0] + row[1] * cluster.centre[1] + row[2] * cluster.centre[2] + row[3];
    return w > 0.0F ? lens.pixels / w : 1.0F;
}

namespace {

// The turn of the normal for a step w along the surface.
[[nodiscard]] glm::vec3 turn_for(const marks::Cluster& cluster, const glm::vec3& w) noexcept {
    const auto& s = cluster.shape;
    return {s[0] * w.x + s[1] * w.y + s[2] * w.z, s[1] * w.x + s[3] * w.y + s[4] * w.z,
            s[2] * w.x + s[4] * w.y + s[5] * w.z};
}

} // namespace

float radial_curvature(const marks::Cluster& cluster, const glm::vec3& n, const glm::vec3& v) noexcept {
    const glm::vec3 w = v - glm::dot(v, n) * n; // the line of sight along the surface
    return glm::dot(w, turn_for(cluster, w)) / glm::dot(w, w);
}

glm::vec3 contour_direction(const marks::Cluster& cluster, const glm::vec3& n, const glm::vec3& v) noexcept {
    return glm::cross(n, turn_for(cluster, v - glm::dot(v, n) * n));
}

} // namespace hrbfnpr::frame
