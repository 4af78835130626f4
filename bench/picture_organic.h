// SPDX-License-Identifier: MIT
// Smooth inputs of the benchmark of pictures: a creature, a folded surface like a cortex, a scan, and terrain.
#pragma once

#include "picture_mesh.h"

#include <numbers>
#include <random>

namespace bench {

namespace detail {

// A ball that moves along a segment, and changes its radius.
struct Limb {
    glm::dvec3 from, to;
    double radius_from, radius_to;

    // Returns the distance of a place from the limb, and the radius of the limb there.
    [[nodiscard]] glm::dvec2 distance_and_radius(const glm::dvec3& p) const {
        const glm::dvec3 along = to - from;
        const double t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
        const double radius = glm::mix(radius_from, radius_to, t);
        return {glm::distance(p, from + t * along) - radius, radius};
    }
};

// Returns the limbs of a creature of length 2.5 with four legs, horns, a tail and a comb on its back; y is up.
[[nodiscard]] inline std::vector<Limb> creature() {
    std::vector<Limb> limbs = {
        {{-0.55, 0.0, 0.0}, {0.0, 0.08, 0.0}, 0.30, 0.27},    {{0.0, 0.08, 0.0}, {0.38, 0.05, 0.0}, 0.27, 0.34},
        {{0.45, 0.2, 0.0}, {0.8, 0.62, 0.0}, 0.22, 0.15},     {{0.8, 0.66, 0.0}, {1.05, 0.6, 0.0}, 0.2, 0.13},
        {{1.0, 0.62, 0.0}, {1.25, 0.56, 0.0}, 0.12, 0.09},    {{0.9, 0.5, 0.0}, {1.18, 0.42, 0.0}, 0.09, 0.06},
        {{-0.7, 0.1, 0.0}, {-1.0, 0.2, 0.1}, 0.2, 0.15},      {{-1.0, 0.2, 0.1}, {-1.25, 0.05, 0.2}, 0.15, 0.12},
        {{-1.25, 0.05, 0.2}, {-1.4, -0.25, 0.12}, 0.12, 0.1}, {{-1.4, -0.25, 0.12}, {-1.3, -0.5, -0.1}, 0.1, 0.06}};
    for (const double side : {-1.0, 1.0}) {
        limbs.push_back({{0.78, 0.8, side * 0.1}, {0.6, 1.05, side * 0.2}, 0.07, 0.05});
        limbs.push_back({{0.6, 1.05, side * 0.2}, {0.68, 1.25, side * 0.26}, 0.05, 0.03});
        limbs.push_back({{0.72, 0.74, side * 0.15}, {0.6, 0.8, side * 0.34}, 0.06, 0.04});
        limbs.push_back({{1.0, 0.72, side * 0.1}, {1.02, 0.73, side * 0.12}, 0.05, 0.05});
        for (const double x : {0.35, -0.55}) {
            limbs.push_back({{x, -0.05, side * 0.22}, {x + 0.08, -0.42, side * 0.28}, 0.17, 0.12});
            limbs.push_back({{x + 0.08, -0.42, side * 0.28}, {x, -0.8, side * 0.28}, 0.11, 0.08});
            for (int toe = -1; toe <= 1; ++toe)
                limbs.push_back({{x, -0.84, side * 0.28}, {x + 0.16, -0.86, side * 0.28 + 0.07 * toe}, 0.06, 0.045});
        }
    }
    for (int i = 0; i < 9; ++i) {
        const double x = 0.45 - 0.14 * i;
        limbs.push_back({{x, 0.32, 0.0}, {x - 0.07, 0.46, 0.0}, 0.06, 0.03});
    }
    return limbs;
}

// Waves whose product has bumps of about the given width.
[[nodiscard]] inline double bumps(const glm::dvec3& p, double width) {
    const double k = std::numbers::pi / width;
    const glm::dvec3 a = {0.8 * p.x + 0.6 * p.y, 0.8 * p.y - 0.6 * p.x, p.z};
    const glm::dvec3 b = {a.x, 0.6 * a.y + 0.8 * a.z, 0.6 * a.z - 0.8 * a.y};
    return std::sin(k * b.x + 2.0 * std::sin(0.4 * k * b.y)) * std::sin(k * b.y + 1.0) * std::sin(k * b.z + 2.0);
}

// A number in 0 .. 1 for each place of a lattice.
[[nodiscard]] inline double lattice(int i, int j) {
    auto h = static_cast<std::uint32_t>(i) * 0x9E3779B1U ^ static_cast<std::uint32_t>(j) * 0x85EBCA77U;
    h = (h ^ h >> 15) * 0x2C1B3C6DU;
    h = (h ^ h >> 12) * 0x297A2D39U;
    return static_cast<double>(h ^ h >> 15) / 4294967296.0;
}

[[nodiscard]] inline double noise(double x, double y) {
    const double fx = std::floor(x), fy = std::floor(y);
    const auto smooth = [](double t) { return t * t * t * (10.0 + t * (6.0 * t - 15.0)); };
    const double u = smooth(x - fx), v = smooth(y - fy);
    const int i = static_cast<int>(fx), j = static_cast<int>(fy);
    return glm::mix(glm::mix(lattice(i, j), lattice(i + 1, j), u),
                    glm::mix(lattice(i, j + 1), lattice(i + 1, j + 1), u), v);
}

} // namespace detail

// A creature with muscles, wrinkles and scales, about as hard to fit as a scanned statue.
[[nodiscard]] inline PictureMesh organic(double faces) {
    const std::vector<detail::Limb> limbs = detail::creature();
    Field field;
    const double scales = faces < 20000.0 ? 0.0 : 0.009; // coarse faces could not follow them
    field.value = [&limbs, scales](const glm::dvec3& p) {
        constexpr double blend = 0.06; // width over which limbs flow into each other
        double distance = 1e9, radius = 0.0;
        for (const detail::Limb& limb : limbs) {
            const glm::dvec2 next = limb.distance_and_radius(p);
            const double h = std::max(0.0, blend - std::abs(next.x - distance)) / blend;
            radius = next.x < distance ? glm::mix(next.y, radius, 0.5 * h) : glm::mix(radius, next.y, 0.5 * h);
            distance = std::min(next.x, distance) - 0.25 * h * h * blend;
        }
        if (std::abs(distance) > 0.2) return distance;
        const double height = std::min(1.0, radius / 0.15); // thin limbs have lower bumps
        return distance + height * (0.025 * detail::bumps(p, 0.22) + 0.016 * detail::bumps(p, 0.1) +
                                    scales * detail::bumps(p, 0.05));
    };
    field.steepness = 2.0;
    field.low = {-1.6, -1.0, -0.6};
    field.high = {1.45, 1.4, 0.6};
    return mesh_of(field, faces);
}

// A ball that is folded like a cortex. Deep grooves meander between narrow ridges. As in many files of such surfaces,
// coarse and noisy faces were divided into four flat ones, so that many edges of the coarse mesh look sharp.
[[nodiscard]] inline PictureMesh folded(double faces) {
    std::mt19937 random(7);
    const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    constexpr double waves = 12.0; // wave number of the pattern on the unit ball
    std::vector<glm::dvec4> pattern;
    for (int i = 0; i < 24; ++i) {
        const double z = 2.0 * number() - 1.0;
        const double phi = 2.0 * std::numbers::pi * number();
        const double r = std::sqrt(1.0 - z * z);
        pattern.emplace_back(waves * glm::dvec3(r * std::cos(phi), r * std::sin(phi), z),
                             2.0 * std::numbers::pi * number());
    }
    Field field;
    field.value = [&pattern](const glm::dvec3& p) {
        constexpr double depth = 0.26; // depth of the grooves; the ball has radius 1
        const glm::dvec3 q = p / glm::dvec3(0.85, 0.8, 1.0);
        const double radius = glm::length(q);
        const glm::dvec3 unit = q / std::max(radius, 1e-9);
        double level = 0.0;
        for (const glm::dvec4& wave : pattern) level += std::sin(glm::dot(glm::dvec3(wave), unit) + wave.w);
        level *= std::sqrt(2.0 / static_cast<double>(pattern.size())) / 0.45;
        return radius - 1.0 + depth * std::exp(-level * level);
    };
    field.steepness = 12.0;
    field.low = glm::dvec3(-1.1);
    field.high = glm::dvec3(1.1);
    PictureMesh coarse = mesh_of(field, faces / 4.0);
    constexpr double noise = 0.02; // each coordinate moves by at most this
    for (glm::dvec3& p : coarse.points)
        for (int c = 0; c < 3; ++c) p[c] += noise * (2.0 * number() - 1.0);
    return divided(coarse);
}

// Points of the creature as a scanner gives them: spread by area, moved by noise, without normals.
[[nodiscard]] inline PictureMesh raw_points(std::size_t count) {
    const PictureMesh mesh = organic(50000);
    std::mt19937 random(11);
    const auto number = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<double> area_until;
    double area = 0.0;
    const auto point = [&](std::int32_t i) { return mesh.points[static_cast<std::size_t>(i)]; };
    for (const Face& f : mesh.faces) {
        area += glm::length(glm::cross(point(f[1]) - point(f[0]), point(f[2]) - point(f[0])));
        area_until.push_back(area);
    }
    constexpr double deviation = 0.003; // standard deviation of the noise; the creature is 2.5 long
    PictureMesh cloud;
    while (cloud.points.size() < count) {
        const auto at = std::lower_bound(area_until.begin(), area_until.end(), area * number());
        const Face& f = mesh.faces[static_cast<std::size_t>(
            std::min<std::ptrdiff_t>(at - area_until.begin(), static_cast<std::ptrdiff_t>(mesh.faces.size()) - 1))];
        const double root = std::sqrt(number()), along = number();
        glm::dvec3 p = (1.0 - root) * point(f[0]) + root * (1.0 - along) * point(f[1]) + root * along * point(f[2]);
        for (int c = 0; c < 3; ++c) { // the sum of four uniform numbers is nearly a normal one
            const double sum = number() + number() + number() + number() - 2.0;
            p[c] += deviation * std::sqrt(3.0) * sum;
        }
        cloud.points.push_back(p);
    }
    return cloud;
}

// A height map of ridges and valleys with two faces for each of its cells; z is up.
[[nodiscard]] inline PictureMesh terrain(int side) {
    PictureMesh mesh;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double x = 10.0 * i / side, y = 10.0 * j / side;
            double height = 0.0, scale = 1.0, ridge = 1.0;
            for (double waves = 0.3; waves < 10.0; waves *= 2.03) {
                const double n = 1.0 - std::abs(2.0 * detail::noise(waves * x + 17.3, waves * y + 5.1) - 1.0);
                ridge = std::clamp(n * n * ridge * 1.6, 0.0, 1.0);
                height += scale * ridge;
                scale *= 0.5;
            }
            mesh.points.emplace_back(x, y, 1.3 * height);
        }
    for (std::int32_t j = 0; j < side; ++j)
        for (std::int32_t i = 0; i < side; ++i) {
            const std::int32_t a = j * (side + 1) + i, b = a + side + 1;
            mesh.faces.push_back({a, a + 1, b + 1});
            mesh.faces.push_back({a, b + 1, b});
        }
    return mesh;
}

} // namespace bench
