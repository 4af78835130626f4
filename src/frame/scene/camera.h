// SPDX-License-Identifier: MIT
// The camera as the frame sees it, the functions that build its matrices, and the numbers that a frame derives from it
// once.
#pragma once

#include "base/view.h"
#include "drawing/dot.h"
#include "geometry/vec.h"

namespace hrbfnpr::frame {

using drawing::DepthConvention;

struct Camera {
    DepthConvention depth = DepthConvention::negative_one_to_one;
    glm::dmat4 view{1.0};
    glm::dmat4 projection{1.0};
    glm::dvec4 viewport{0.0}; // x and y of the top-left corner, width and height, in pixels
};

// These functions throw Error{invalid_argument} that names the argument.
[[nodiscard]] glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);
[[nodiscard]] glm::dmat4 perspective(double vertical_angle, double width, double height, double near_plane,
                                     double far_plane, DepthConvention depth);
[[nodiscard]] glm::dmat4 orthographic(double view_height, double width, double height, double near_plane,
                                      double far_plane, DepthConvention depth);
// Returns a camera that looks at the centre of a box. It is orthographic if vertical_angle is 0.
[[nodiscard]] Camera fit_bounds(const geometry::Bounds& bounds, const glm::dvec3& direction, const glm::dvec3& up,
                                double vertical_angle, double width, double height, double margin,
                                DepthConvention depth);
// Returns a camera that looks at points, which have 3 components and are relative to `origin`. There must be at least
// one. The points are centred in the picture and as large as it allows.
[[nodiscard]] Camera fit_points(const base::InView& points, const glm::dvec3& origin, const glm::dvec3& direction,
                                const glm::dvec3& up, double vertical_angle, double width, double height, double margin,
                                DepthConvention depth);
// Throws Error{invalid_argument} if nothing can be drawn with the camera.
void check(const Camera& camera);

// The mapping from eye space to the window, in double. The camera is checked, but its projection may be singular.
struct Optics {
    // The matrix from eye space to (x w, y w, depth w, w), with x and y in pixels and the window depth.
    glm::dmat4 window{1.0};
    glm::dvec4 centre{0.0}; // in eye space: the eye (w = 1), or the direction of all lines of sight (w = 0)
};
[[nodiscard]] Optics make_optics(const Camera& camera);

// The optics in float, with other numbers for drawing marks.
struct Lens {
    glm::mat4 window{1.0F};
    glm::vec4 centre{0.0F};
    glm::vec4 viewport{0.0F}; // x, y, width, height
    float pixels = 0.0F;      // the number of pixels per eye unit where w is 1
    float eye_per_world = 1.0F;
    float diagonal = 0.0F; // the diagonal of the viewport, in pixels

    // Returns v of [NPAR 6]: the vector from the camera to a point, not normalised.
    [[nodiscard]] glm::vec3 sight(const glm::vec3& eye) const noexcept {
        return centre.w == 0.0F ? glm::vec3(centre) : eye - glm::vec3(centre);
    }
};
[[nodiscard]] Lens make_lens(const Camera& camera);

// Returns the cube root of the factor by which a transform scales volumes.
[[nodiscard]] double mean_scale(const glm::dmat4& transform) noexcept;

// Returns the inverse transpose, scaled to the range of floats. Only the directions of its products matter.
[[nodiscard]] glm::mat3 normal_matrix(const glm::dmat4& m);

} // namespace hrbfnpr::frame
