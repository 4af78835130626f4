// SPDX-License-Identifier: MIT
// How far the creases that a line set traces are from the true ones.
#pragma once

#include "line_calls.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace bench {

// In % of the diagonal.
struct CreaseErrors {
    double p95 = 0.0, most = 0.0;
    std::int64_t points = 0; // that were compared
};

// All creases from the least angle on, in front and behind, also where they are parts of the contour.
[[nodiscard]] inline hrbfnpr_line_style all_creases(double least_angle) {
    auto line = scenes::made(hrbfnpr_line_style_init);
    line.kind = HRBFNPR_LINE_KIND_CREASE;
    line.hidden = HRBFNPR_HIDDEN_PARTS_SHOWN;
    line.taper = 0.0F;
    line.shortest = 0.0F;
    line.fade = 0.0F;
    line.lower = least_angle;
    line.upper = least_angle;
    return line;
}

// Where a place of the window, with its depth, is in the world.
[[nodiscard]] inline glm::dvec3 unprojected(const hrbfnpr_camera& camera, const glm::dvec3& window) {
    const glm::dmat4 to_clip = glm::make_mat4(camera.projection) * glm::make_mat4(camera.view);
    const glm::dvec4 clip(2.0 * (window.x - camera.viewport[0]) / camera.viewport[2] - 1.0,
                          1.0 - 2.0 * (window.y - camera.viewport[1]) / camera.viewport[3], 2.0 * window.z - 1.0, 1.0);
    const glm::dvec4 place = glm::inverse(to_clip) * clip;
    return glm::dvec3(place) / place.w;
}

// distance(place): from the nearest true crease.  low, high: of the model's box.  Points are those of the drawn lines,
// from three sides: they are on the lines' cubics, and as exact as floats.
template <class Distance>
[[nodiscard]] CreaseErrors crease_errors(hrbfnpr_context* context, const hrbfnpr_point_set* marks,
                                         const hrbfnpr_line_set* lines, const double* low, const double* high,
                                         double least_angle, Distance&& distance) {
    LinePainter painter(context, marks, lines, {all_creases(least_angle)});
    const double diagonal = glm::distance(glm::make_vec3(low), glm::make_vec3(high));
    std::vector<double> off;
    for (const glm::dvec3& direction : {glm::dvec3(-1.0, -0.8, -0.6), {0.7, -0.5, 1.0}, {0.3, 1.0, -0.4}}) {
        const hrbfnpr_camera camera = camera_of(low, high, glm::normalize(direction), 0.0);
        painter.draw(camera);
        for (const Polyline& line : painter.polylines())
            for (const glm::dvec3& window : line.window)
                off.push_back(100.0 * distance(unprojected(camera, window)) / diagonal);
    }
    CreaseErrors errors;
    errors.points = static_cast<std::int64_t>(off.size());
    if (off.empty()) return errors;
    std::sort(off.begin(), off.end());
    errors.p95 = off[static_cast<std::size_t>(0.95 * static_cast<double>(off.size() - 1))];
    errors.most = off.back();
    return errors;
}

} // namespace bench
