// SPDX-License-Identifier: MIT
// Cameras for tests of lines, and the directions to a cube's corners, edges and faces.
#pragma once

#include "curves/curves.h"
#include "geometry/tangent_frame.h"

#include <glm/matrix.hpp>

#include <vector>

namespace hrbfnpr::test {

// A camera that looks at the origin, or along -back if it is orthographic. The image has 800 by 800 pixels, y down.
struct Eye {
    static constexpr double size = 800.0;

    glm::dvec3 back, right, up; // orthonormal; `back` points to the eye
    double distance;            // distance of the eye from the origin
    double pixels;              // pixels per unit at the origin
    bool perspective;

    // Makes a camera that sees the origin from the direction `towards`.
    static Eye at(const glm::dvec3& towards, double distance, bool perspective, double pixels = 250.0) {
        const glm::dvec3 back = glm::normalize(towards);
        const glm::dvec3 right = geometry::any_perpendicular(back);
        return {back, right, glm::cross(back, right), distance, pixels, perspective};
    }
    [[nodiscard]] glm::dvec3 place() const noexcept { return distance * back; }
    [[nodiscard]] glm::dvec4 centre() const noexcept {
        return perspective ? glm::dvec4(place(), 1.0) : glm::dvec4(-back, 0.0);
    }
    [[nodiscard]] glm::dmat4 to_window() const {
        const double w = perspective ? 1.0 / distance : 0.0; // change of the weight per unit along the view
        const glm::dvec4 weight(-w * back, 1.0);
        const glm::dvec4 x = glm::dvec4(pixels * right, 0.0) + 0.5 * size * weight;
        const glm::dvec4 y = glm::dvec4(-pixels * up, 0.0) + 0.5 * size * weight;
        const glm::dvec4 depth(-back, distance);
        return glm::transpose(glm::dmat4(x, y, depth, weight));
    }
    // Returns the view for an object with this transform.
    [[nodiscard]] curves::View view(const glm::dmat4& to_world = glm::dmat4(1.0)) const {
        const glm::dvec4 own = glm::inverse(to_world) * centre();
        return {own.w != 0.0 ? own / own.w : own, to_window() * to_world};
    }
};

// Directions to the 6 faces, 12 edges and 8 corners of a cube. `turned` tilts them, so that none is along a symmetry of
// a shape.
inline std::vector<glm::dvec3> cube_directions(double turned = 0.0) {
    std::vector<glm::dvec3> found;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    found.push_back(glm::normalize(glm::dvec3(x, y, z) + turned * glm::dvec3(0.71, -0.43, 0.56)));
    return found;
}

// Returns both kinds of cameras for each of these directions.
inline std::vector<Eye> eyes(const std::vector<glm::dvec3>& directions, double distance) {
    std::vector<Eye> found;
    for (const glm::dvec3& towards : directions)
        for (const bool perspective : {true, false}) found.push_back(Eye::at(towards, distance, perspective));
    return found;
}

} // namespace hrbfnpr::test
