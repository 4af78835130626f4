// SPDX-License-Identifier: MIT
#include "frame/scene/camera.h"

#include "base/status.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hrbfnpr::frame {
namespace {

void require_finite(const glm::dvec3& v, const char* name) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        fail(Status::invalid_argument, "%s is (%g, %g, %g); its components must be finite", name, v.x, v.y, v.z);
}

void require_size(double width, double height) {
    if (!std::isfinite(width) || !(width > 0.0))
        fail(Status::invalid_argument, "width is %g; it must be a positive number of pixels", width);
    if (!std::isfinite(height) || !(height > 0.0))
        fail(Status::invalid_argument, "height is %g; it must be a positive number of pixels", height);
}

void require_finite_planes(double near_plane, double far_plane) {
    if (!std::isfinite(near_plane)) fail(Status::invalid_argument, "near_plane is %g; it must be finite", near_plane);
    if (!std::isfinite(far_plane)) fail(Status::invalid_argument, "far_plane is %g; it must be finite", far_plane);
    if (!(near_plane < far_plane))
        fail(Status::invalid_argument, "near_plane is %g and far_plane is %g; near_plane must be the smaller one",
             near_plane, far_plane);
}

// The axes of a camera in world coordinates.
struct Axes {
    glm::dvec3 right, up, forward;
};

Axes camera_axes(const glm::dvec3& forward, const glm::dvec3& up) {
    // Scaled first, so that neither tiny nor huge vectors lose their squares.
    const auto unit = [](const glm::dvec3& v) {
        const glm::dvec3 a = glm::abs(v);
        const glm::dvec3 scaled = v / std::max({a.x, a.y, a.z});
        return scaled / glm::length(scaled);
    };
    if (up == glm::dvec3(0.0)) fail(Status::invalid_argument, "up is the zero vector; give it a length");
    const glm::dvec3 f = unit(forward);
    const glm::dvec3 right = glm::cross(f, unit(up));
    const double sine = glm::length(right);
    if (!(sine > 1e-10))
        fail(Status::invalid_argument,
             "up (%g, %g, %g) is parallel to the direction of view (%g, %g, %g); choose another one", up.x, up.y, up.z,
             f.x, f.y, f.z);
    const glm::dvec3 r = right / sine;
    return {r, glm::cross(r, f), f};
}

glm::dmat4 view_matrix(const Axes& axes, const glm::dvec3& eye) {
    glm::dmat4 view(1.0);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = axes.right[i];
        view[i][1] = axes.up[i];
        view[i][2] = -axes.forward[i];
    }
    view[3] = glm::dvec4(-glm::dot(axes.right, eye), -glm::dot(axes.up, eye), glm::dot(axes.forward, eye), 1.0);
    return view;
}

// The corners of a box as (right, up, forward) from its centre.
std::array<glm::dvec3, 8> corners_along(const Axes& axes, const glm::dvec3& half) {
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 p((i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                           (i & 4U) != 0 ? half.z : -half.z);
        corners[i] = {glm::dot(axes.right, p), glm::dot(axes.up, p), glm::dot(axes.forward, p)};
    }
    return corners;
}

// How far the eye has to be from the box's centre for the corners to lie between the lines of slope
// +-tangent through it, along one screen axis.
double reach(const std::array<glm::dvec3, 8>& corners, int axis, double tangent) {
    double distance = 0.0;
    for (const glm::dvec3& c : corners) distance = std::max(distance, std::abs(c[axis]) / tangent - c.z);
    return distance;
}

void check_view(const glm::dvec3& direction, double vertical_angle, double margin) {
    require_finite(direction, "direction");
    if (direction == glm::dvec3(0.0)) fail(Status::invalid_argument, "direction is the zero vector; give it a length");
    if (!(vertical_angle >= 0.0 && vertical_angle < std::numbers::pi))
        fail(Status::invalid_argument, "vertical_angle is %g; it must be 0 (orthographic) or an angle below pi radians",
             vertical_angle);
    if (!(margin >= 0.0 && margin <= 0.45))
        fail(Status::invalid_argument, "margin is %g; it must be a share of the picture from 0 to 0.45", margin);
}

void check_bounds(const geometry::Bounds& bounds) {
    require_finite(bounds.min, "bounds_min");
    require_finite(bounds.max, "bounds_max");
    for (int i = 0; i < 3; ++i) {
        if (!(bounds.min[i] <= bounds.max[i]))
            fail(Status::invalid_argument, "bounds_min[%d] is %g, above bounds_max[%d] = %g; swap them", i,
                 bounds.min[i], i, bounds.max[i]);
    }
}

glm::dvec3 point_at(const base::InView& points, std::int64_t i) {
    const glm::dvec3 p(points.get(i, 0), points.get(i, 1), points.get(i, 2));
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        fail(Status::invalid_argument, "points[%lld] is (%g, %g, %g); its coordinates must be finite",
             static_cast<long long>(i), p.x, p.y, p.z);
    return p;
}

// What a camera has to see, in its own axes (right, up, forward) from an anchor.  Seen from an eye e,
// a point p lies between the lines of slope t on the right if p_x - e_x <= t (p_z - e_z), that is
// p_x - t p_z <= e_x - t e_z: the largest left side of all points is all that matters, and likewise
// on the other three sides.  With t = 0 the four are the extents of an orthographic picture.
struct Support {
    glm::dvec2 above{-std::numeric_limits<double>::infinity()}; // max of p - t p_z
    glm::dvec2 below{-std::numeric_limits<double>::infinity()}; // max of -p - t p_z
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();

    void add(const glm::dvec3& p, const glm::dvec2& slope) noexcept {
        above = glm::max(above, glm::dvec2(p) - slope * p.z);
        below = glm::max(below, -glm::dvec2(p) - slope * p.z);
        nearest = std::min(nearest, p.z);
        farthest = std::max(farthest, p.z);
    }
};

} // namespace

glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
    require_finite(eye, "eye");
    require_finite(target, "target");
    require_finite(up, "up");
    if (eye == target) fail(Status::invalid_argument, "eye and target are the same point; move one of them");
    return view_matrix(camera_axes(target - eye, up), eye);
}

glm::dmat4 perspective(double vertical_angle, double width, double height, double near_plane, double far_plane,
                       DepthConvention depth) {
    if (!(vertical_angle > 0.0 && vertical_angle < std::numbers::pi))
        fail(Status::invalid_argument, "vertical_angle is %g; it must lie between 0 and pi radians", vertical_angle);
    require_size(width, height);
    require_finite_planes(near_plane, far_plane);
    if (!(near_plane > 0.0))
        fail(Status::invalid_argument, "near_plane is %g; it must be positive for a perspective camera", near_plane);
    const double aspect = width / height;
    switch (depth) {
    case DepthConvention::negative_one_to_one:
        return glm::perspectiveRH_NO(vertical_angle, aspect, near_plane, far_plane);
    case DepthConvention::zero_to_one: return glm::perspectiveRH_ZO(vertical_angle, aspect, near_plane, far_plane);
    case DepthConvention::reversed: return glm::perspectiveRH_ZO(vertical_angle, aspect, far_plane, near_plane);
    }
    fail(Status::invalid_argument, "depth_convention %u is not one of HRBFNPR_DEPTH_...", static_cast<unsigned>(depth));
}

glm::dmat4 orthographic(double view_height, double width, double height, double near_plane, double far_plane,
                        DepthConvention depth) {
    if (!std::isfinite(view_height) || !(view_height > 0.0))
        fail(Status::invalid_argument, "view_height is %g; it must be positive", view_height);
    require_size(width, height);
    require_finite_planes(near_plane, far_plane);
    const double y = 0.5 * view_height;
    const double x = y * width / height;
    switch (depth) {
    case DepthConvention::negative_one_to_one: return glm::orthoRH_NO(-x, x, -y, y, near_plane, far_plane);
    case DepthConvention::zero_to_one: return glm::orthoRH_ZO(-x, x, -y, y, near_plane, far_plane);
    case DepthConvention::reversed: return glm::orthoRH_ZO(-x, x, -y, y, far_plane, near_plane);
    }
    fail(Status::invalid_argument, "depth_convention %u is not one of HRBFNPR_DEPTH_...", static_cast<unsigned>(depth));
}

Camera fit_bounds(const geometry::Bounds& bounds, const glm::dvec3& direction, const glm::dvec3& up,
                  double vertical_angle, double width, double height, double margin, DepthConvention depth) {
    check_bounds(bounds);
    check_view(direction, vertical_angle, margin);
    require_finite(up, "up");
    require_size(width, height);
    const Axes axes = camera_axes(direction, up);
    const glm::dvec3 centre = bounds.centre();
    glm::dvec3 half = 0.5 * bounds.size();
    // A point has no size to fill a picture with; it is shown as if it had some.
    if (half == glm::dvec3(0.0)) half = glm::dvec3(std::max(1e-3, 1e-6 * glm::length(centre)));
    const double size = 2.0 * glm::length(half);
    const double slack = 0.05 * size;
    const std::array<glm::dvec3, 8> corners = corners_along(axes, half);
    glm::dvec3 extent(0.0);
    for (const glm::dvec3& c : corners) extent = glm::max(extent, glm::abs(c));

    const double used = 1.0 - 2.0 * margin;
    const double aspect = width / height;
    Camera camera;
    camera.depth = depth;
    camera.viewport = {0.0, 0.0, width, height};
    if (vertical_angle == 0.0) {
        // 1e-9: a line seen end-on has no height.
        const double view_height = 2.0 * std::max({extent.y, extent.x / aspect, 1e-9 * size}) / used;
        const double back = extent.z + 2.0 * slack;
        camera.view = view_matrix(axes, centre - back * axes.forward);
        camera.projection = orthographic(view_height, width, height, slack, 2.0 * back - slack, depth);
        return camera;
    }
    const double tangent = std::tan(0.5 * vertical_angle);
    // Never closer than the slack to the nearest corner, or it could touch the eye.
    const double back =
        std::max({reach(corners, 0, tangent * aspect * used), reach(corners, 1, tangent * used), extent.z + slack});
    camera.view = view_matrix(axes, centre - back * axes.forward);
    const double nearest = back - extent.z;
    camera.projection = perspective(vertical_angle, width, height, std::max(nearest - slack, 0.5 * nearest),
                                    back + extent.z + slack, depth);
    return camera;
}

Camera fit_points(const base::InView& points, const glm::dvec3& origin, const glm::dvec3& direction,
                  const glm::dvec3& up, double vertical_angle, double width, double height, double margin,
                  DepthConvention depth) {
    check_view(direction, vertical_angle, margin);
    require_finite(origin, "origin");
    require_finite(up, "up");
    require_size(width, height);
    const Axes axes = camera_axes(direction, up);
    const double used = 1.0 - 2.0 * margin;
    const glm::dvec2 aspect(width / height, 1.0);
    const glm::dvec2 slope = std::tan(0.5 * vertical_angle) * used * aspect;
    const glm::dvec3 anchor = point_at(points, 0);
    Support support;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = point_at(points, i) - anchor;
        support.add({glm::dot(axes.right, p), glm::dot(axes.up, p), glm::dot(axes.forward, p)}, slope);
    }
    const glm::dvec2 width_needed = 0.5 * (support.above + support.below); // of the half picture
    const double size = std::max({width_needed.x, width_needed.y, support.farthest - support.nearest,
                                  1e-6 * glm::length(origin + anchor), 1e-3 * (points.count == 1 ? 1.0 : 0.0)});
    const double slack = 0.1 * size;
    glm::dvec3 eye(0.5 * (support.above - support.below), support.nearest - 2.0 * slack);
    Camera camera;
    camera.depth = depth;
    camera.viewport = {0.0, 0.0, width, height};
    if (vertical_angle == 0.0) {
        const double half = std::max({width_needed.x / aspect.x, width_needed.y, 1e-9 * size}) / used;
        camera.projection = orthographic(2.0 * half, width, height, slack, support.farthest - eye.z + slack, depth);
    } else {
        eye.z = std::min({-width_needed.x / slope.x, -width_needed.y / slope.y, support.nearest - 0.5 * slack});
        const double nearest = support.nearest - eye.z;
        camera.projection = perspective(vertical_angle, width, height, std::max(nearest - slack, 0.5 * nearest),
                                        support.farthest - eye.z + slack, depth);
    }
    camera.view = view_matrix(axes, origin + anchor + eye.x * axes.right + eye.y * axes.up + eye.z * axes.forward);
    return camera;
}

} // namespace hrbfnpr::frame
