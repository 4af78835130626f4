// SPDX-License-Identifier: MIT
// Surfaces of known topology, and seeds on them.
#pragma once

#include "curves/surface_mesh.h"
#include "support/analytic.h"
#include "surface/region.h"

namespace hrbfnpr::curves::test_shapes {

using test::AnyField;
using test::Field;

// (x/a)^2 + (y/b)^2 + (z/c)^2 - 1
inline Field ellipsoid(const glm::dvec3& p) {
    const glm::dvec3 axes(1.0, 0.6, 0.35);
    const glm::dvec3 q = p / axes;
    return {glm::dot(q, q) - 1.0, 2.0 * q / axes, {}};
}

// Two rings side by side, thickened: genus 2.  (x^2 (1 - x^2) - y^2)^2 + z^2 / 2 = 1/40 in half units.
inline Field two_holes(const glm::dvec3& p) {
    const double x2 = p.x * p.x;
    const double plane = x2 * (1.0 - x2) - p.y * p.y;
    return {plane * plane + 0.5 * p.z * p.z - 1.0 / 40.0,
            {2.0 * plane * (2.0 * p.x - 4.0 * p.x * x2), -4.0 * plane * p.y, p.z},
            {}};
}

// The nearer of two spheres with radii 0.5 and 0.3.
inline Field two_spheres(const glm::dvec3& p) {
    const glm::dvec3 a = p - glm::dvec3(-0.6, 0.1, 0.0);
    const glm::dvec3 b = p - glm::dvec3(0.6, -0.2, 0.1);
    const double da = glm::length(a) - 0.5;
    const double db = glm::length(b) - 0.3;
    return da < db ? Field{da, a / glm::length(a), {}} : Field{db, b / glm::length(b), {}};
}

// A spherical shell with the radii 1 - thickness and 1. f is not a distance.
struct Shell {
    double thickness;
    [[nodiscard]] Field operator()(const glm::dvec3& p) const {
        const double r = glm::length(p);
        if (r == 0.0) return {1.0, glm::dvec3(0.0), {}};
        const double outer = r - 1.0;
        const double inner = r - 1.0 + thickness;
        return {outer * inner / thickness, p * ((outer + inner) / (thickness * r)), {}};
    }
};

inline MeshSettings settings(const implicit::Implicit& implicit, double side) {
    MeshSettings settings;
    settings.region = surface::search_region(implicit);
    settings.side = side;
    return settings;
}

inline geometry::VecArray seeds(const base::Runtime& runtime, std::initializer_list<glm::dvec3> places) {
    geometry::VecArray array(runtime.memory);
    for (const glm::dvec3& place : places) array.push_back(place);
    return array;
}

} // namespace hrbfnpr::curves::test_shapes
