// SPDX-License-Identifier: MIT
#include "frame/scene/lens.h"

#include "base/status.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr double largest_viewport = 1048576.0; // pixels a side: beyond it a float has no sub-pixel places

void require_finite(const glm::dmat4& m, const char* name) {
    for (int i = 0; i < 16; ++i) {
        const double value = m[i / 4][i % 4];
        if (!std::isfinite(value))
            fail(Status::invalid_argument, "camera.%s[%d] is %g; all 16 elements must be finite", name, i, value);
    }
}

} // namespace

void check(const Camera& camera) {
    require_finite(camera.view, "view");
    require_finite(camera.projection, "projection");
    for (int i = 0; i < 4; ++i) {
        if (!(std::abs(camera.viewport[i]) <= largest_viewport))
            fail(Status::invalid_argument, "camera.viewport[%d] is %g; it must be a number of pixels up to %g", i,
                 camera.viewport[i], largest_viewport);
    }
    if (!(camera.viewport[2] > 0.0 && camera.viewport[3] > 0.0))
        fail(Status::invalid_argument, "camera.viewport is %g x %g pixels; set its width and height",
             camera.viewport[2], camera.viewport[3]);
    if (camera.depth > DepthConvention::reversed)
        fail(Status::invalid_argument, "camera.depth_convention %u is not one of HRBFNPR_DEPTH_...",
             static_cast<unsigned>(camera.depth));
    if (!(mean_scale(camera.view) > 0.0))
        fail(Status::invalid_argument, "camera.view is singular; it must be invertible");
}

namespace {

// The point of eye space that has no image, where all lines of sight meet: the common null
// vector of the x, y and w rows.  At infinity for parallel projections.
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

glm::dmat4 window_matrix(const Camera& camera) {
    const glm::dvec4 v = camera.viewport;
    const bool half_range = camera.depth == DepthConvention::negative_one_to_one;
    glm::dmat4 from_clip(0.0);
    from_clip[0][0] = 0.5 * v[2];
    from_clip[1][1] = -0.5 * v[3]; // rows go down
    from_clip[2][2] = half_range ? 0.5 : 1.0;
    from_clip[3] = {v[0] + 0.5 * v[2], v[1] + 0.5 * v[3], half_range ? 0.5 : 0.0, 1.0};
    return from_clip * camera.projection;
}

} // namespace

double mean_scale(const glm::dmat4& transform) noexcept {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(transform))));
}

Optics make_optics(const Camera& camera) { return {window_matrix(camera), centre_of_projection(camera.projection)}; }

Lens make_lens(const Camera& camera) {
    const Optics optics = make_optics(camera);
    Lens lens;
    lens.window = glm::mat4(optics.window);
    lens.centre = glm::vec4(optics.centre);
    lens.viewport = glm::vec4(camera.viewport);
    const glm::dmat4& p = camera.projection;
    // The mean of both axes, whatever turn in the image plane the projection contains.
    const double x = 0.5 * camera.viewport[2] * std::hypot(p[0][0], p[1][0]);
    const double y = 0.5 * camera.viewport[3] * std::hypot(p[0][1], p[1][1]);
    lens.pixels = static_cast<float>(std::sqrt(x * y));
    lens.eye_per_world = static_cast<float>(mean_scale(camera.view));
    lens.diagonal = static_cast<float>(std::hypot(camera.viewport[2], camera.viewport[3]));
    return lens;
}

} // namespace hrbfnpr::frame
