// SPDX-License-Identifier: MIT
// A camera path around a model, and the image of a place.
#pragma once

#include "calls.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace bench {

// The matrices of a camera.
struct Lens {
    explicit Lens(const hrbfnpr_camera& camera)
        : view(glm::make_mat4(camera.view)), to_clip(glm::make_mat4(camera.projection) * view),
          eye(glm::inverse(view)[3]), viewport(glm::make_vec4(camera.viewport)) {}

    // Returns the pixel of a place.
    [[nodiscard]] glm::dvec2 image_of(const glm::dvec3& place) const {
        const glm::dvec4 clip = to_clip * glm::dvec4(place, 1.0);
        return {viewport.x + (clip.x / clip.w + 1.0) / 2.0 * viewport.z,
                viewport.y + (1.0 - clip.y / clip.w) / 2.0 * viewport.w};
    }
    [[nodiscard]] bool holds(const glm::dvec2& pixel, double margin) const {
        return pixel.x > viewport.x + margin && pixel.x < viewport.x + viewport.z - margin &&
               pixel.y > viewport.y + margin && pixel.y < viewport.y + viewport.w - margin;
    }
    // Returns n . v, where v points from the eye to the place: negative for marks that face the eye.
    [[nodiscard]] double facing(const glm::dvec3& place, const glm::dvec3& normal) const {
        return glm::dot(normal, glm::normalize(place - eye));
    }

    glm::dmat4 view;
    glm::dmat4 to_clip;
    glm::dvec3 eye;
    glm::dvec4 viewport;
};

// A path around the middle of a point set, which fills the picture at angle 0 and zoom 1.
class Orbit {
public:
    Orbit(const hrbfnpr_point_set* set, int width, int height) {
        const hrbfnpr_point_set_info info = info_of(set);
        std::int64_t layer = 0;
        while (layer_info(set, layer).marks == 0) ++layer;
        scenes::Check check;
        hrbfnpr_array places{};
        check(hrbfnpr_point_set_view(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, &places, check.error()));
        check(hrbfnpr_camera_init(&start_, sizeof start_));
        const Vec3 direction{-0.3, -0.2, -1.0};
        const Vec3 up{0.0, 1.0, 0.0};
        check(hrbfnpr_camera_fit_points(&start_, &places, info.origin, direction.data(), up.data(), 0.5, width, height,
                                        0.02, check.error()));
        middle_ = 0.5 * (glm::make_vec3(info.bounds_min) + glm::make_vec3(info.bounds_max));
        part_planes(start_);
    }

    [[nodiscard]] hrbfnpr_camera at(double degrees, double zoom = 1.0) const {
        hrbfnpr_camera camera = start_;
        const glm::dmat4 turn =
            glm::rotate(glm::translate(glm::dmat4(1.0), middle_), glm::radians(degrees), glm::dvec3(0.0, 1.0, 0.0)) *
            glm::translate(glm::dmat4(1.0), -middle_);
        const glm::dmat4 view = glm::make_mat4(start_.view) * turn;
        for (std::size_t i = 0; i < 16; ++i) camera.view[i] = glm::value_ptr(view)[i];
        // Zoom changes the projection alone, so that the same marks face the eye.
        camera.projection[0] *= zoom;
        camera.projection[5] *= zoom;
        return camera;
    }

private:
    // Moves the planes so that the set fits between them at any angle.  Assumes OpenGL's depths and a perspective.
    static void part_planes(hrbfnpr_camera& camera) {
        double* const p = camera.projection;
        const double near = 0.5 * p[14] / (p[10] - 1.0);
        const double far = 2.0 * p[14] / (p[10] + 1.0);
        p[10] = (far + near) / (near - far);
        p[14] = 2.0 * far * near / (near - far);
    }

    hrbfnpr_camera start_{};
    glm::dvec3 middle_{0.0};
};

} // namespace bench
