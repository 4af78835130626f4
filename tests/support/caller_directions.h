// SPDX-License-Identifier: MIT
// Direction fields of a caller.
#pragma once

#include "marks/site.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::test {

// The caller's direction function, and statistics of its calls.
struct Caller {
    glm::dvec3 (*direction)(const glm::dvec3& p, const glm::dvec3& n) = nullptr;
    std::int64_t calls = 0;
    std::int64_t most = 0;
    double farthest = 0.0;
    std::int32_t result = 0;

    [[nodiscard]] marks::DirectionFunction function() noexcept { return {call, this}; }

    static std::int32_t call(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* directions) {
        auto& self = *static_cast<Caller*>(user);
        ++self.calls;
        self.most = std::max(self.most, count);
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 p(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
            const glm::dvec3 n(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
            EXPECT_NEAR(glm::length(n), 1.0, 1e-9);
            self.farthest = std::max(self.farthest, glm::length(p));
            const glm::dvec3 d = self.direction(p, n);
            for (int k = 0; k < 3; ++k) directions[3 * i + k] = d[k];
        }
        return self.result;
    }
};

// A helix about z at 30 degrees, which is no principal direction of a sphere or torus. It is neither tangent nor of
// unit length.
inline glm::dvec3 helix(const glm::dvec3& p, const glm::dvec3& n) {
    const glm::dvec3 around = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
    const glm::dvec3 across = glm::cross(n, around);
    return 17.0 * (std::cos(0.5236) * around + std::sin(0.5236) * across) + 5.0 * n;
}

// Returns the angle between a line and the helix's tangent direction.
inline double degrees_off_helix(const glm::dvec3& line, const glm::dvec3& p, const glm::dvec3& n, bool across = false) {
    const glm::dvec3 d = helix(p, n);
    const glm::dvec3 along = glm::normalize(d - glm::dot(d, n) * n);
    const double cosine = std::abs(glm::dot(line, across ? glm::cross(n, along) : along));
    return 57.29577951308232 * std::acos(std::min(1.0, cosine));
}

inline glm::dvec3 no_direction(const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.0); }
inline glm::dvec3 not_a_number(const glm::dvec3&, const glm::dvec3&) { return {1.0, std::nan(""), 0.0}; }

} // namespace hrbfnpr::test
