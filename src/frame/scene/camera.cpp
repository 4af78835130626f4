// SPDX-License-Identifier: MIT
// 1. look_at, perspective and orthographic check their arguments and build matrices.
// 2. fit_bounds and fit_points find an eye that sees everything, and build a camera there.
// 3. check, make_optics and make_lens prepare any camera, also a host's, for a frame.
#include "frame/scene/camera.h"

#include "base/assert.h"
#include "base/status.h"
#include "frame/scene/tuning.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// The largest side of a viewport, in pixels. With larger coordinates, a float has no sub-pixel precision.
constexpr double largest_viewport = 1048576.0;

// ---- Checks

bool is_finite(const glm::dvec3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_finite(const glm::dvec3& v, const char* name) {
    if (!is_finite(v))
        fail(Status::invalid_argument, "%s is (%g, %g, %g); its components must be finite", name, v.x, v.y, v.z);
}

void require_finite(const glm::dmat4& m, const char* name) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4]))
            fail(Status::invalid_argument, "camera.%s[%d] is %g; all 16 elements must be finite", name, i,
                 m[i / 4][i % 4]);
}

void require_size(double width, double height) {
    if (!std::isfinite(width) || !(width > 0.0))
        fail(Status::invalid_argument, "width is %g; it must be a positive number of pixels", width);
    if (!std::isfinite(height) || !(height > 0.0))
        fail(Status::invalid_argument, "height is %g; it must be a positive number of pixels", height);
}

void require_planes(double near_plane, double far_plane) {
    if (!std::isfinite(near_plane)) fail(Status::invalid_argument, "near_plane is %g; it must be finite", near_plane);
    if (!std::isfinite(far_plane)) fail(Status::invalid_argument, "far_plane is %g; it must be finite", far_plane);
    if (!(near_plane < far_plane))
        fail(Status::invalid_argument, "near_plane is %g and far_plane is %g; near_plane must be below far_plane",
             near_plane, far_plane);
}

void require_view(const glm::dvec3& direction, double vertical_angle, double margin) {
    require_finite(direction, "direction");
    if (direction == glm::dvec3(0.0)) fail(Status::invalid_argument, "direction is the zero vector; give it a length");
    if (!(vertical_angle >= 0.0 && vertical_angle < std::numbers::pi))
        fail(Status::invalid_argument, "vertical_angle is %g; it must be 0 (orthographic) or an angle below pi radians",
             vertical_angle);
    if (!(margin >= 0.0 && margin <= 0.45))
        fail(Status::invalid_argument, "margin is %g; it must be a share of the picture from 0 to 0.45", margin);
}

glm::dvec3 point_at(const base::InView& points, std::int64_t i) {
    const glm::dvec3 p(points.get(i, 0), points.get(i, 1), points.get(i, 2));
    if (!is_finite(p))
        fail(Status::invalid_argument, "points[%lld] is (%g, %g, %g); its coordinates must be finite",
             static_cast<long long>(i), p.x, p.y, p.z);
    return p;
}

// ---- Matrices

// The axes of a camera in world coordinates.
struct Axes {
    glm::dvec3 right, up, forward;

    [[nodiscard]] glm::dvec3 along(const glm::dvec3& p) const noexcept {
        return {glm::dot(right, p), glm::dot(up, p), glm::dot(forward, p)};
    }
};

Axes camera_axes(const glm::dvec3& forward, const glm::dvec3& up) {
    // Vectors are scaled first, so that squares of tiny and huge vectors stay in the range of a double.
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
             "up (%g, %g, %g) is parallel to the direction of view (%g, %g, %g); choose another up", up.x, up.y, up.z,
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

// Calls make(full_range, near, far). In clip space, depth goes from -1 or 0 to 1, or from 1 to 0.
template <class Make>
glm::dmat4 with_depth(DepthConvention depth, double near_plane, double far_plane, const Make& make) {
    if (depth > DepthConvention::reversed)
        fail(Status::invalid_argument, "depth_convention is %u; it must be one of HRBFNPR_DEPTH_*",
             static_cast<unsigned>(depth));
    if (depth == DepthConvention::reversed) std::swap(near_plane, far_plane);
    return make(depth == DepthConvention::negative_one_to_one, near_plane, far_plane);
}

// The extent that a camera must see, along the camera's axes (right, up, forward) from an anchor. Seen from an eye e, a
// point p lies between the lines of slope t on the right if p_x - e_x <= t (p_z - e_z), which is the same as p_x - t
// p_z <= e_x - t e_z. So only the largest left side of all points matters, and likewise on the other three sides. With
// t = 0 the four numbers are the extents of an orthographic picture.
struct Support {
    glm::dvec2 above{-std::numeric_limits<double>::infinity()}; // the largest p - t p_z
    glm::dvec2 below{-std::numeric_limits<double>::infinity()}; // the largest -p - t p_z
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();

    void add(const glm::dvec3& p, const glm::dvec2& slope) noexcept {
        above = glm::max(above, glm::dvec2(p) - slope * p.z);
        below = glm::max(below, -glm::dvec2(p) - slope * p.z);
        nearest = std::min(nearest, p.z);
        farthest = std::max(farthest, p.z);
    }
};

// Returns a projection whose near plane is before the nearest point, but not too close to the eye.
glm::dmat4 perspective_around(double vertical_angle, double width, double height, double nearest, double farthest,
                              double slack, DepthConvention depth) {
    return perspective(vertical_angle, width, height, std::max(nearest - slack, 0.5 * nearest), farthest + slack,
                       depth);
}

// Returns the point of eye space in which all lines of sight meet, and which has no image. It is the common null vector
// of the rows for x, y and w. For parallel projections it is at infinity.
glm::dvec4 centre_of_projection(const glm::dmat4& projection) {
    const glm::dmat4 rows = glm::transpose(projection);
    const glm::dvec4& a = rows[0];
    const glm::dvec4& b = rows[1];
    const glm::dvec4& c = rows[3];
    const auto minor = [&](int i, int j, int k) {
        return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
               a[k] * (b[i] * c[j] - b[j] * c[i]);
    };
    const glm::dvec4 null(minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2));
    const double direction = glm::length(glm::dvec3(null));
    if (!(direction > 0.0) && null.w == 0.0)
        fail(Status::invalid_argument, "camera.projection is singular; build it with hrbfnpr_camera_perspective or "
                                       "_orthographic, or take the host's");
    if (std::abs(null.w) > 1e-12 * direction) return null / null.w;
    // The eye looks along -z.
    const double length = null.z > 0.0 ? -direction : direction;
    return {glm::dvec3(null) / length, 0.0};
}

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
    require_planes(near_plane, far_plane);
    if (!(near_plane > 0.0))
        fail(Status::invalid_argument, "near_plane is %g; it must be positive for a perspective camera", near_plane);
    return with_depth(depth, near_plane, far_plane, [&](bool full_range, double n, double f) {
        return full_range ? glm::perspectiveRH_NO(vertical_angle, width / height, n, f)
                          : glm::perspectiveRH_ZO(vertical_angle, width / height, n, f);
    });
}

glm::dmat4 orthographic(double view_height, double width, double height, double near_plane, double far_plane,
                        DepthConvention depth) {
    if (!std::isfinite(view_height) || !(view_height > 0.0))
        fail(Status::invalid_argument, "view_height is %g; it must be positive", view_height);
    require_size(width, height);
    require_planes(near_plane, far_plane);
    const double y = 0.5 * view_height;
    const double x = y * width / height;
    return with_depth(depth, near_plane, far_plane, [&](bool full_range, double n, double f) {
        return full_range ? glm::orthoRH_NO(-x, x, -y, y, n, f) : glm::orthoRH_ZO(-x, x, -y, y, n, f);
    });
}

Camera fit_bounds(const geometry::Bounds& bounds, const glm::dvec3& direction, const glm::dvec3& up,
                  double vertical_angle, double width, double height, double margin, DepthConvention depth) {
    require_finite(bounds.min, "bounds_min");
    require_finite(bounds.max, "bounds_max");
    for (int i = 0; i < 3; ++i)
        if (!(bounds.min[i] <= bounds.max[i]))
            fail(Status::invalid_argument, "bounds_min[%d] is %g, above bounds_max[%d] = %g; swap them", i,
                 bounds.min[i], i, bounds.max[i]);
    require_view(direction, vertical_angle, margin);
    require_finite(up, "up");
    require_size(width, height);
    const Axes axes = camera_axes(direction, up);
    const glm::dvec3 centre = bounds.centre();
    glm::dvec3 half = 0.5 * bounds.size();
    // A single point has no size, so a small size is used.
    if (half == glm::dvec3(0.0)) half = glm::dvec3(std::max(1e-3, 1e-6 * glm::length(centre)));
    const double size = 2.0 * glm::length(half);
    const double slack = 0.5 * scene_tuning.fit_slack * size;
    const double used = 1.0 - 2.0 * margin;
    const double aspect = width / height;
    const double tangent = std::tan(0.5 * vertical_angle);
    const glm::dvec2 slope(tangent * aspect * used, tangent * used);
    glm::dvec3 extent(0.0);
    // The least distance between the eye and the centre at which all corners are between the lines of these slopes.
    double reach = 0.0;
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 c = axes.along(
            {(i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y, (i & 4U) != 0 ? half.z : -half.z});
        extent = glm::max(extent, glm::abs(c));
        if (tangent > 0.0) reach = std::max({reach, std::abs(c.x) / slope.x - c.z, std::abs(c.y) / slope.y - c.z});
    }
    Camera camera{depth, {}, {}, {0.0, 0.0, width, height}};
    double back = extent.z + 2.0 * slack;
    if (vertical_angle == 0.0) {
        // The term with 1e-9 is for a line seen end-on, which has no height.
        const double view_height = 2.0 * std::max({extent.y, extent.x / aspect, 1e-9 * size}) / used;
        camera.projection = orthographic(view_height, width, height, slack, 2.0 * back - slack, depth);
    } else {
        // The slack keeps the eye away from the nearest corner.
        back = std::max(reach, extent.z + slack);
        camera.projection =
            perspective_around(vertical_angle, width, height, back - extent.z, back + extent.z, slack, depth);
    }
    camera.view = view_matrix(axes, centre - back * axes.forward);
    return camera;
}

Camera fit_points(const base::InView& points, const glm::dvec3& origin, const glm::dvec3& direction,
                  const glm::dvec3& up, double vertical_angle, double width, double height, double margin,
                  DepthConvention depth) {
    HRBFNPR_ASSERT(points.count > 0);
    require_view(direction, vertical_angle, margin);
    require_finite(origin, "origin");
    require_finite(up, "up");
    require_size(width, height);
    const Axes axes = camera_axes(direction, up);
    const double used = 1.0 - 2.0 * margin;
    const glm::dvec2 aspect(width / height, 1.0);
    const glm::dvec2 slope = std::tan(0.5 * vertical_angle) * used * aspect;
    const glm::dvec3 anchor = point_at(points, 0);
    Support support;
    for (std::int64_t i = 0; i < points.count; ++i) support.add(axes.along(point_at(points, i) - anchor), slope);
    const glm::dvec2 needed = 0.5 * (support.above + support.below); // half the extent of the picture
    const double size = std::max({needed.x, needed.y, support.farthest - support.nearest,
                                  1e-6 * glm::length(origin + anchor), 1e-3 * (points.count == 1 ? 1.0 : 0.0)});
    const double slack = scene_tuning.fit_slack * size;
    glm::dvec3 eye(0.5 * (support.above - support.below), support.nearest - 2.0 * slack);
    Camera camera{depth, {}, {}, {0.0, 0.0, width, height}};
    if (vertical_angle == 0.0) {
        const double half = std::max({needed.x / aspect.x, needed.y, 1e-9 * size}) / used;
        camera.projection = orthographic(2.0 * half, width, height, slack, support.farthest - eye.z + slack, depth);
    } else {
        eye.z = std::min({-needed.x / slope.x, -needed.y / slope.y, support.nearest - 0.5 * slack});
        camera.projection = perspective_around(vertical_angle, width, height, support.nearest - eye.z,
                                               support.farthest - eye.z, slack, depth);
    }
    camera.view = view_matrix(axes, origin + anchor + eye.x * axes.right + eye.y * axes.up + eye.z * axes.forward);
    return camera;
}

void check(const Camera& camera) {
    require_finite(camera.view, "view");
    require_finite(camera.projection, "projection");
    for (int i = 0; i < 4; ++i)
        if (!(std::abs(camera.viewport[i]) <= largest_viewport))
            fail(Status::invalid_argument, "camera.viewport[%d] is %g; it must be a number of pixels up to %g", i,
                 camera.viewport[i], largest_viewport);
    if (!(camera.viewport[2] > 0.0 && camera.viewport[3] > 0.0))
        fail(Status::invalid_argument, "camera.viewport is %g x %g pixels; set its width and height",
             camera.viewport[2], camera.viewport[3]);
    if (camera.depth > DepthConvention::reversed)
        fail(Status::invalid_argument, "camera.depth_convention is %u; it must be one of HRBFNPR_DEPTH_*",
             static_cast<unsigned>(camera.depth));
    if (!(mean_scale(camera.view) > 0.0))
        fail(Status::invalid_argument, "camera.view is singular; it must be invertible");
}

glm::mat3 normal_matrix(const glm::dmat4& m) {
    const glm::dmat3 inverse = glm::inverseTranspose(glm::dmat3(m));
    double largest = 0.0;
    for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(inverse[i / 3][i % 3]));
    return glm::mat3(inverse / largest);
}

double mean_scale(const glm::dmat4& transform) noexcept {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(transform))));
}

Optics make_optics(const Camera& camera) {
    const glm::dvec4 v = camera.viewport;
    const bool half_range = camera.depth == DepthConvention::negative_one_to_one;
    glm::dmat4 from_clip(0.0);
    from_clip[0][0] = 0.5 * v[2];
    from_clip[1][1] = -0.5 * v[3]; // Rows are counted downward.
    from_clip[2][2] = half_range ? 0.5 : 1.0;
    from_clip[3] = {v[0] + 0.5 * v[2], v[1] + 0.5 * v[3], half_range ? 0.5 : 0.0, 1.0};
    return {from_clip * camera.projection, centre_of_projection(camera.projection)};
}

Lens make_lens(const Camera& camera) {
    const Optics optics = make_optics(camera);
    const glm::dmat4& p = camera.projection;
    // The scale is the mean over both axes, which does not change if the image is rotated.
    const double x = 0.5 * camera.viewport[2] * std::hypot(p[0][0], p[1][0]);
    const double y = 0.5 * camera.viewport[3] * std::hypot(p[0][1], p[1][1]);
    return {glm::mat4(optics.window),
            glm::vec4(optics.centre),
            glm::vec4(camera.viewport),
            static_cast<float>(std::sqrt(x * y)),
            static_cast<float>(mean_scale(camera.view)),
            static_cast<float>(std::hypot(camera.viewport[2], camera.viewport[3]))};
}

} // namespace hrbfnpr::frame
