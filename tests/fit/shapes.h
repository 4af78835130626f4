// Samples of shapes that are known exactly, and a call of fit() in one line.
#pragma once

#include "fit/fit.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test {

struct Cloud {
    std::vector<double> points;  // packed
    std::vector<double> normals; // unit, outward

    void add(const glm::dvec3& p, const glm::dvec3& n) {
        points.insert(points.end(), {p.x, p.y, p.z});
        normals.insert(normals.end(), {n.x, n.y, n.z});
    }
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(points.size() / 3); }
    [[nodiscard]] glm::dvec3 point(std::int64_t i) const {
        const auto at = static_cast<std::size_t>(3 * i);
        return {points[at], points[at + 1], points[at + 2]};
    }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const {
        const auto at = static_cast<std::size_t>(3 * i);
        return {normals[at], normals[at + 1], normals[at + 2]};
    }
    // Every point p becomes scale * p + shift.
    [[nodiscard]] Cloud moved(double scale, const glm::dvec3& shift) const {
        Cloud result;
        for (std::int64_t i = 0; i < count(); ++i) result.add(scale * point(i) + shift, normal(i));
        return result;
    }
};

constexpr double golden_angle = 2.399963229728653;

// Fibonacci's spiral on the unit sphere.
inline Cloud sphere(int count) {
    Cloud cloud;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt(1.0 - z * z);
        const glm::dvec3 n(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z);
        cloud.add(n, n);
    }
    return cloud;
}

// About z: centre circle of radius 1, tube of radius 0.4; nearly even.
inline glm::dvec3 torus_point(double u, double v) {
    const double ring = 1.0 + 0.4 * std::cos(v);
    return {ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)};
}
inline glm::dvec3 torus_normal(double u, double v) {
    return {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
}
inline Cloud torus(int count) {
    Cloud cloud;
    constexpr double tau = 6.283185307179586;
    for (int i = 0; i < count; ++i) {
        const double t = (i + 0.5) / count;
        // v of even area: v + 0.4 sin v = tau t.
        double v = tau * t;
        for (int step = 0; step < 20; ++step) v -= (v + 0.4 * std::sin(v) - tau * t) / (1.0 + 0.4 * std::cos(v));
        const double u = std::fmod(golden_angle * i, tau);
        cloud.add(torus_point(u, v), torus_normal(u, v));
    }
    return cloud;
}

// A bumpy closed surface: f is not of a low degree anywhere.
inline Cloud bumpy(int count) {
    Cloud cloud = sphere(count);
    Cloud result;
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const glm::dvec3 s = cloud.point(i);
        const double bump = 0.15 * std::sin(4 * s.x) * std::cos(3 * s.y + s.z);
        const glm::dvec3 gradient(0.6 * std::cos(4 * s.x) * std::cos(3 * s.y + s.z),
                                  -0.45 * std::sin(4 * s.x) * std::sin(3 * s.y + s.z),
                                  -0.15 * std::sin(4 * s.x) * std::sin(3 * s.y + s.z));
        const glm::dvec3 tangent = gradient - glm::dot(gradient, s) * s;
        result.add((1.0 + bump) * s, glm::normalize((1.0 + bump) * s - tangent));
    }
    return result;
}

inline hrbfnpr::base::InView view(const std::vector<double>& packed) {
    return {reinterpret_cast<const std::byte*>(packed.data()), static_cast<std::int64_t>(packed.size() / 3), 24,
            hrbfnpr::base::Scalar::float64, 3};
}

inline hrbfnpr::fit::FitInput input(const Cloud& cloud) {
    hrbfnpr::fit::FitInput result;
    result.points = view(cloud.points);
    result.normals = view(cloud.normals);
    return result;
}

inline hrbfnpr::fit::FitInput input(const Cloud& cloud, hrbfnpr::kernel::Kind kernel, std::int32_t degree) {
    hrbfnpr::fit::FitInput result = input(cloud);
    result.kernel = kernel;
    result.polynomial_degree = degree;
    return result;
}

struct Sampled {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
};

inline Sampled at(const hrbfnpr::implicit::HrbfData& data, const glm::dvec3& p) {
    Sampled s;
    hrbfnpr::implicit::evaluate(data, {&p.x, &p.y, &p.z, 1},
                                {&s.value, {&s.gradient.x, &s.gradient.y, &s.gradient.z}, {}});
    return s;
}

// First-order distance of p from the surface f = 0.
inline double distance(const hrbfnpr::implicit::HrbfData& data, const glm::dvec3& p) {
    const Sampled s = at(data, p);
    return s.value / glm::length(s.gradient);
}

} // namespace test
