// SPDX-License-Identifier: MIT
#include "camera.h"

#include <algorithm>

namespace viewer {

namespace {

struct Axes {
    Vec right, up, back;
};

Axes axes_of(const View& view) {
    const Vec back = unit(view.eye - view.target);
    const Vec right = unit(cross(view.up, back));
    return {right, cross(back, right), back};
}

Vec turned(const Vec& v, const Vec& axis, double angle) { // Rodrigues' formula
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
}

} // namespace

View view_by(const hrbfnpr_camera& camera, const Vec& target, const Vec& up) {
    View view;
    view.up = up;
    view.target = target;
    view.view.emplace();
    view.projection.emplace();
    std::copy(camera.view, camera.view + 16, view.view->begin());
    std::copy(camera.projection, camera.projection + 16, view.projection->begin());
    view.given_size = {static_cast<int>(camera.viewport[2]), static_cast<int>(camera.viewport[3])};
    return view;
}

void take_over(View& view) {
    if (!view.view) return;
    const auto& m = *view.view;
    const auto row = [&](int r) {
        return Vec{m[static_cast<std::size_t>(r)], m[static_cast<std::size_t>(r) + 4],
                   m[static_cast<std::size_t>(r) + 8]};
    };
    const Vec right = row(0), up = row(1), back = row(2);
    const double distance = std::max(std::abs(m[14]), 1e-9);
    view.eye = -1.0 * (m[12] * right + m[13] * up + m[14] * back);
    const double away = std::max(dot(view.eye - view.target, back), 1e-3 * distance);
    view.target = view.eye - away * back;
    if (std::abs(dot(view.up, right)) > 1e-6) view.up = up; // a picture that is rolled stays rolled
    const auto& p = *view.projection;
    const bool flat = p[15] != 0;
    view.vertical_angle = flat ? 0 : 2 * std::atan(1 / std::abs(p[5]));
    view.view_height = flat ? 2 / std::abs(p[5]) : 2 * away * std::tan(view.vertical_angle / 2);
    view.view.reset();
    view.projection.reset();
}

hrbfnpr_camera camera_of(const View& view, Size size) {
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    const double width = size.width, height = size.height;
    if (view.view) {
        std::copy(view.view->begin(), view.view->end(), camera.view);
        std::copy(view.projection->begin(), view.projection->end(), camera.projection);
        camera.viewport[2] = width;
        camera.viewport[3] = height;
        // The whole former picture is fitted into the new size. At its own size nothing changes.
        const Size given = view.given_size;
        if (given.width > 0 && (given.width != size.width || given.height != size.height)) {
            const double scale = std::min(width / given.width, height / given.height);
            for (std::size_t column = 0; column < 4; ++column) {
                camera.projection[4 * column] *= scale * given.width / width;
                camera.projection[4 * column + 1] *= scale * given.height / height;
            }
        }
        return camera;
    }
    checked([&](auto* error) {
        return hrbfnpr_camera_look_at(&camera, view.eye.data(), view.target.data(), view.up.data(), error);
    });
    checked([&](auto* error) {
        return view.vertical_angle > 0 ? hrbfnpr_camera_perspective(&camera, view.vertical_angle, width, height,
                                                                    view.near_plane, view.far_plane, error)
                                       : hrbfnpr_camera_orthographic(&camera, view.view_height, width, height,
                                                                     view.near_plane, view.far_plane, error);
    });
    return camera;
}

void enclose(View& view, const Vec& centre, double radius) {
    const double distance = dot(view.eye - centre, unit(view.eye - view.target));
    const double ball = 1.1 * std::max(radius, 1e-9);
    view.near_plane = distance - ball;
    view.far_plane = std::max(distance + ball, 1e-3 * ball);
    if (view.vertical_angle > 0) view.near_plane = std::max(view.near_plane, 1e-3 * view.far_plane);
}

void orbit(View& view, double across, double upward) {
    take_over(view);
    constexpr double pole = 0.02; // least angle in radians between the view direction and the vertical
    const Vec up = unit(view.up);
    Vec away = turned(view.eye - view.target, up, across);
    const double above = std::asin(std::clamp(dot(unit(away), up), -1.0, 1.0));
    const double limit = std::acos(-1.0) / 2 - pole;
    const Vec right = unit(cross(up, away));
    away = turned(away, right, above - std::clamp(above + upward, -limit, limit));
    view.eye = view.target + away;
}

void pan(View& view, double across, double upward) {
    take_over(view);
    const Axes axes = axes_of(view);
    const double height = view.vertical_angle > 0
                              ? 2 * length(view.eye - view.target) * std::tan(view.vertical_angle / 2)
                              : view.view_height;
    const Vec shift = (-across * height) * axes.right + (-upward * height) * axes.up;
    view.eye = view.eye + shift;
    view.target = view.target + shift;
}

void zoom(View& view, double factor) {
    take_over(view);
    view.view_height /= factor;
    if (view.vertical_angle > 0) view.eye = view.target + (1 / factor) * (view.eye - view.target);
}

Vec window_of(const hrbfnpr_camera& camera, const Vec& place) {
    std::array<double, 4> eye{}, clip{};
    for (std::size_t row = 0; row < 4; ++row) {
        eye[row] = camera.view[12 + row];
        for (std::size_t k = 0; k < 3; ++k) eye[row] += camera.view[4 * k + row] * place[k];
    }
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t k = 0; k < 4; ++k) clip[row] += camera.projection[4 * k + row] * eye[k];
    const double w = clip[3] == 0 ? 1e-300 : clip[3];
    return {camera.viewport[0] + (0.5 + 0.5 * clip[0] / w) * camera.viewport[2],
            camera.viewport[1] + (0.5 - 0.5 * clip[1] / w) * camera.viewport[3], -eye[2]};
}

double units_per_pixel(const hrbfnpr_camera& camera, const Vec& place) {
    const double distance = camera.projection[15] != 0 ? 1 : window_of(camera, place)[2];
    return 2 * std::abs(distance) / (std::abs(camera.projection[5]) * camera.viewport[3]);
}

Vec to_world(const hrbfnpr_camera& camera, const Vec& d) {
    const double* const m = camera.view;
    return {m[0] * d[0] + m[1] * d[1] + m[2] * d[2], m[4] * d[0] + m[5] * d[1] + m[6] * d[2],
            m[8] * d[0] + m[9] * d[1] + m[10] * d[2]};
}

Vec to_camera(const hrbfnpr_camera& camera, const Vec& d) {
    const double* const m = camera.view;
    return {m[0] * d[0] + m[4] * d[1] + m[8] * d[2], m[1] * d[0] + m[5] * d[1] + m[9] * d[2],
            m[2] * d[0] + m[6] * d[1] + m[10] * d[2]};
}

std::pair<Vec, Vec> ray_of(const hrbfnpr_camera& camera, double x, double y) {
    const double* const p = camera.projection;
    const double u = 2 * (x - camera.viewport[0]) / camera.viewport[2] - 1;
    const double v = 1 - 2 * (y - camera.viewport[1]) / camera.viewport[3];
    const Vec eye = -1.0 * to_world(camera, {camera.view[12], camera.view[13], camera.view[14]});
    if (p[15] == 0) return {eye, unit(to_world(camera, {(u + p[8]) / p[0], (v + p[9]) / p[5], -1}))};
    const Vec beside = to_world(camera, {(u - p[12]) / p[0], (v - p[13]) / p[5], 0});
    return {eye + beside, to_world(camera, {0, 0, -1})};
}

} // namespace viewer
