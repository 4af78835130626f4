// SPDX-License-Identifier: MIT
#include "frame/lines/off_planes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr double shift = 2e-5;
// Of the shift: to one side, which no plane of symmetry is likely to hold.
constexpr double aside = 0.05;
constexpr double aside_angle = 0.9;

glm::dvec3 corner_of(const geometry::Bounds& box, int i) noexcept {
    return {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
            (i & 4) != 0 ? box.max.z : box.min.z};
}

} // namespace

Camera camera_off_planes(const Scene& scene, std::span<const Item> items) {
    geometry::Bounds box; // in eye space
    bool sharp = false;
    for (const Item& item : items) {
        if (item.lines == nullptr) continue;
        sharp = sharp || item.lines->creases().count() > 0;
        const glm::dmat4 to_eye = scene.camera.view * item.transform;
        for (int i = 0; i < 8; ++i)
            box.extend(glm::dvec3(to_eye * glm::dvec4(corner_of(item.lines->mesh().region, i), 1.0)));
    }
    Camera camera = scene.camera;
    const double radius = sharp ? 0.5 * glm::length(box.size()) : 0.0;
    const double middle = 0.5 * (box.min.z + box.max.z);
    if (!(radius > 0.0) || !std::isfinite(radius) || !std::isfinite(middle)) return camera;
    // x and y by (z - middle) to one side; w grows with it, so that an orthographic camera is a finite one.
    glm::dmat4 moved(1.0);
    const glm::dvec2 to_side = aside * shift * glm::dvec2(std::cos(aside_angle), std::sin(aside_angle));
    for (int axis = 0; axis < 2; ++axis) {
        moved[2][axis] = to_side[axis];
        moved[3][axis] = -to_side[axis] * middle;
    }
    if (make_optics(camera).centre.w == 0.0) {
        moved[2][3] = -shift / radius;
        moved[3][3] = 1.0 + shift / radius * middle;
    }
    camera.projection = camera.projection * moved;
    return camera;
}

} // namespace hrbfnpr::frame
