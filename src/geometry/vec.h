// SPDX-License-Identifier: MIT
// Vectors and boxes: GLM outside the solver, Eigen inside it.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <limits>

namespace hrbfnpr::geometry {

struct Bounds {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    void extend(const glm::dvec3& p) noexcept {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    [[nodiscard]] bool empty() const noexcept { return !(min.x <= max.x); }
    [[nodiscard]] glm::dvec3 centre() const noexcept { return 0.5 * (min + max); }
    [[nodiscard]] glm::dvec3 size() const noexcept { return max - min; }
    [[nodiscard]] double longest_side() const noexcept { return glm::max(glm::max(size().x, size().y), size().z); }
    [[nodiscard]] double diagonal() const noexcept { return glm::length(max - min); }
    [[nodiscard]] Bounds grown(double by) const noexcept { return {min - by, max + by}; }
    [[nodiscard]] bool contains(const glm::dvec3& p) const noexcept {
        return glm::all(glm::lessThanEqual(min, p)) && glm::all(glm::lessThanEqual(p, max));
    }
};

} // namespace hrbfnpr::geometry
