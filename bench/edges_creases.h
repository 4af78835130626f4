// SPDX-License-Identifier: MIT
// The distances between the creases that a line set traces and the true ones.
#pragma once

#include "edge_places.h"
#include "line_calls.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace bench {

// In % of the diagonal.
struct CreaseErrors {
    double p95 = 0.0, most = 0.0; // from traced points to the curves through the mesh's edges
    double corner_p95 = 0.0;      // from ends of the mesh's edges, which are on true creases, to traced lines
    double found = 0.0;           // share of these ends that have a traced line within 0.1 %
    std::int64_t points = 0;      // the number of traced points
};

// Shows all creases from the least angle on: front and back, hidden ones, and those on the contour.
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

// Returns the place in the world of a place in the window with its depth.
[[nodiscard]] inline glm::dvec3 unprojected(const hrbfnpr_camera& camera, const glm::dvec3& window) {
    const glm::dmat4 to_clip = glm::make_mat4(camera.projection) * glm::make_mat4(camera.view);
    const glm::dvec4 clip(2.0 * (window.x - camera.viewport[0]) / camera.viewport[2] - 1.0,
                          1.0 - 2.0 * (window.y - camera.viewport[1]) / camera.viewport[3], 2.0 * window.z - 1.0, 1.0);
    const glm::dvec4 place = glm::inverse(to_clip) * clip;
    return glm::dvec3(place) / place.w;
}

[[nodiscard]] inline double distance_to_line(const std::vector<glm::dvec3>& line, const glm::dvec3& p) {
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::dvec3 along = line[i + 1] - line[i];
        const double square = glm::dot(along, along);
        const double share = square > 0.0 ? std::clamp(glm::dot(p - line[i], along) / square, 0.0, 1.0) : 0.0;
        least = std::min(least, glm::distance(p, line[i] + share * along));
    }
    return least;
}

// Each edge has two places; only the first is compared.
[[nodiscard]] inline bool is_compared(const std::vector<EdgePlace>& places, std::size_t i) {
    return i % 2 == 0 && places[i].angle >= 40.0;
}

// Compares the model's creases of 30 degrees and more with the mesh's edges of 20 degrees and more, and the mesh's
// edges of 40 degrees and more with these creases.  The points are those of lines drawn from three sides; they are on
// the lines' cubics, with the precision of floats.
[[nodiscard]] inline CreaseErrors crease_errors(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                const std::vector<EdgePlace>& places) {
    const auto info = info_of(model);
    const glm::dvec3 low = glm::make_vec3(info.bounds_min);
    const glm::dvec3 high = glm::make_vec3(info.bounds_max);
    const double unit = 0.01 * glm::distance(low, high);
    const LineSet lines = make_line_set(context, model);
    const scenes::PointSet marks = generate(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 20));
    LinePainter painter(context, marks.get(), lines.get(), {all_creases(30.0)});
    std::vector<double> off;
    std::vector<double> nearest(places.size(), 1e300);
    for (const glm::dvec3& direction : {glm::dvec3(-1.0, -0.8, -0.6), {0.7, -0.5, 1.0}, {0.3, 1.0, -0.4}}) {
        const hrbfnpr_camera camera =
            camera_of(glm::value_ptr(low), glm::value_ptr(high), glm::normalize(direction), 0.0);
        painter.draw(camera);
        for (const Polyline& line : painter.polylines()) {
            std::vector<glm::dvec3> points;
            for (const glm::dvec3& window : line.window) points.push_back(unprojected(camera, window));
            for (const glm::dvec3& p : points) off.push_back(distance_to_edges(places, 20.0, {p.x, p.y, p.z}) / unit);
            for (std::size_t i = 0; i < places.size(); ++i)
                if (is_compared(places, i))
                    nearest[i] = std::min(nearest[i], distance_to_line(points, glm::make_vec3(places[i].from.data())));
        }
    }
    CreaseErrors errors;
    errors.points = static_cast<std::int64_t>(off.size());
    if (off.empty()) return errors;
    std::sort(off.begin(), off.end());
    errors.p95 = off[static_cast<std::size_t>(0.95 * static_cast<double>(off.size() - 1))];
    errors.most = off.back();
    std::vector<double> missed;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (is_compared(places, i)) missed.push_back(nearest[i] / unit);
    const auto found = std::count_if(missed.begin(), missed.end(), [](double d) { return d <= 0.1; });
    errors.found = static_cast<double>(found) / static_cast<double>(missed.size());
    std::sort(missed.begin(), missed.end());
    errors.corner_p95 = missed[missed.size() * 95 / 100];
    return errors;
}

} // namespace bench
