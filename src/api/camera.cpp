// SPDX-License-Identifier: MIT
#include "api/camera.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/views.h"

using namespace hrbfnpr;

static_assert(static_cast<int>(frame::DepthConvention::negative_one_to_one) == HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE);
static_assert(static_cast<int>(frame::DepthConvention::zero_to_one) == HRBFNPR_DEPTH_ZERO_TO_ONE);
static_assert(static_cast<int>(frame::DepthConvention::reversed) == HRBFNPR_DEPTH_REVERSED);

namespace hrbfnpr::api {

namespace {

void set_camera(hrbfnpr_camera& to, const frame::Camera& from) noexcept {
    to.depth_convention = static_cast<std::uint32_t>(from.depth);
    from_matrix(to.view, from.view);
    from_matrix(to.projection, from.projection);
    for (int i = 0; i < 4; ++i) to.viewport[i] = from.viewport[i];
}

void set_projection(hrbfnpr_camera& camera, const glm::dmat4& projection, double width, double height) noexcept {
    from_matrix(camera.projection, projection);
    camera.viewport[2] = width;
    camera.viewport[3] = height;
}

frame::DepthConvention depth_of(const hrbfnpr_camera& camera) {
    Checks("camera").one_of("depth_convention", camera.depth_convention, HRBFNPR_DEPTH_REVERSED + 1, "HRBFNPR_DEPTH_*");
    return static_cast<frame::DepthConvention>(camera.depth_convention);
}

glm::dvec3 vector(const double* components, const char* name) {
    require_pointer(components, name);
    return {components[0], components[1], components[2]};
}

// Calls body(full) with a copy of the camera, so that a failure does not change the camera.
template <class F>
hrbfnpr_status change_camera(hrbfnpr_camera* camera, hrbfnpr_error* error, F&& body) noexcept {
    return guarded(error, [&] {
        hrbfnpr_camera full = read_struct(camera, "camera");
        body(full);
        write_struct(camera, full);
    });
}

} // namespace

template <>
hrbfnpr_camera defaults() noexcept {
    hrbfnpr_camera camera{};
    set_camera(camera, frame::Camera{});
    return camera;
}

frame::Camera to_camera(const hrbfnpr_camera& camera) {
    return {depth_of(camera),
            to_matrix(camera.view),
            to_matrix(camera.projection),
            {camera.viewport[0], camera.viewport[1], camera.viewport[2], camera.viewport[3]}};
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size) {
    return api::init_struct(camera, struct_size);
}

hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye, const double* target, const double* up,
                                      hrbfnpr_error* error) {
    return api::change_camera(camera, error, [&](hrbfnpr_camera& full) {
        api::from_matrix(full.view,
                         frame::look_at(api::vector(eye, "eye"), api::vector(target, "target"), api::vector(up, "up")));
    });
}

hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle, double width, double height,
                                          double near_plane, double far_plane, hrbfnpr_error* error) {
    return api::change_camera(camera, error, [&](hrbfnpr_camera& full) {
        const glm::dmat4 projection =
            frame::perspective(vertical_angle, width, height, near_plane, far_plane, api::depth_of(full));
        api::set_projection(full, projection, width, height);
    });
}

hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height, double width, double height,
                                           double near_plane, double far_plane, hrbfnpr_error* error) {
    return api::change_camera(camera, error, [&](hrbfnpr_camera& full) {
        const glm::dmat4 projection =
            frame::orthographic(view_height, width, height, near_plane, far_plane, api::depth_of(full));
        api::set_projection(full, projection, width, height);
    });
}

hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min, const double* bounds_max,
                                         const double* direction, const double* up, double vertical_angle, double width,
                                         double height, double margin, hrbfnpr_error* error) {
    return api::change_camera(camera, error, [&](hrbfnpr_camera& full) {
        const geometry::Bounds bounds{api::vector(bounds_min, "bounds_min"), api::vector(bounds_max, "bounds_max")};
        api::set_camera(full, frame::fit_bounds(bounds, api::vector(direction, "direction"), api::vector(up, "up"),
                                                vertical_angle, width, height, margin, api::depth_of(full)));
    });
}

hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points, const double* origin,
                                         const double* direction, const double* up, double vertical_angle, double width,
                                         double height, double margin, hrbfnpr_error* error) {
    return api::change_camera(camera, error, [&](hrbfnpr_camera& full) {
        const base::InView view = api::in_view(api::deref(points, "points"), "points", api::points_type);
        if (view.empty()) fail(Status::invalid_argument, "points is empty; give at least one point");
        const glm::dvec3 from = origin != nullptr ? api::vector(origin, "origin") : glm::dvec3(0.0);
        api::set_camera(full, frame::fit_points(view, from, api::vector(direction, "direction"), api::vector(up, "up"),
                                                vertical_angle, width, height, margin, api::depth_of(full)));
    });
}

} // extern "C"
