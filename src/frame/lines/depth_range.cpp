// SPDX-License-Identifier: MIT
// Finds the depths between which line widths change. Vertices of the surfaces' meshes are sampled (see_samples), since
// a new contour may appear at any depth, while a surface moves smoothly. A sample near the border of the window moves
// towards the middle of all samples (range_of), so that a surface that enters the window changes widths smoothly.
#include "base/assert.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

// A vertex of a surface as the camera sees it.
struct SeenVertex {
    glm::dvec2 across; // the place in eye space, across the axis of the camera
    double depth;
    double weight; // 1 in the window, and 0 at its border and outside
};

// Returns a weight that falls smoothly from 1 inside of the window to 0 at its border.
double window_weight(const glm::dvec2& place, const glm::dvec4& window) noexcept {
    double weight = 1.0;
    for (const int axis : {0, 1}) {
        const double inside = std::min(place[axis] - window[axis], window[axis] + window[axis + 2] - place[axis]);
        const double share = std::clamp(inside / (line_tuning.depth_margin * window[axis + 2]), 0.0, 1.0);
        weight *= share * share * (3.0 - 2.0 * share);
    }
    return weight;
}

base::Array<SeenVertex> see_samples(const LineInput& in) {
    std::int64_t vertices = 0;
    for (const visibility::Occluder& of : in.traced.occluders) vertices += of.sheet_counter->mesh().vertices();
    const std::int64_t stride = std::max<std::int64_t>(1, vertices / line_tuning.most_depths);
    const glm::dvec4 window(in.scene.lens.viewport);
    const glm::dmat4 to_window = make_optics(in.scene.camera).window;
    base::Array<SeenVertex> seen(in.runtime.memory);
    for (const visibility::Occluder& of : in.traced.occluders) {
        const geometry::VecArray& vertex = of.sheet_counter->mesh().position;
        const glm::dmat4 to_eye = in.scene.camera.view * of.to_world;
        for (std::int64_t i = 0; i < vertex.size(); i += stride) {
            const glm::dvec4 eye = to_eye * glm::dvec4(vertex[i], 1.0);
            const glm::dvec4 at = to_window * eye;
            if (!(at.w > 0.0)) continue;
            const double weight = window_weight(glm::dvec2(at) / at.w, window);
            if (weight > 0.0) seen.push_back({glm::dvec2(eye), -eye.z, weight});
        }
    }
    return seen;
}

} // namespace

double DepthRange::share(double depth) const noexcept {
    return length > 0.0 ? std::clamp((depth - nearest) / length, 0.0, 1.0) : 0.0;
}

DepthRange find_depth_range(const LineInput& in) {
    const base::Array<SeenVertex> seen = see_samples(in);
    SeenVertex middle{glm::dvec2(0.0), 0.0, 0.0};
    for (const SeenVertex& s : seen) {
        middle.across += s.weight * s.across;
        middle.depth += s.weight * s.depth;
        middle.weight += s.weight;
    }
    if (!(middle.weight > 0.0)) return {};
    middle.across /= middle.weight;
    middle.depth /= middle.weight;
    double nearest = middle.depth;
    double farthest = middle.depth;
    double radius = 0.0;
    for (const SeenVertex& s : seen) {
        const double depth = middle.depth + s.weight * (s.depth - middle.depth);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
        radius = std::max(radius, s.weight * glm::distance(s.across, middle.across));
    }
    HRBFNPR_ASSERT(nearest <= farthest);
    return {nearest, std::max(farthest - nearest, 2.0 * line_tuning.flat_depth * radius)};
}

} // namespace hrbfnpr::frame
