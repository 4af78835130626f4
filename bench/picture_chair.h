// SPDX-License-Identifier: MIT
// A chair of turned parts whose faces are given twice, as some modelling programs export them.
#pragma once

#include "picture_profiles.h"

namespace bench {

namespace detail {

// Adds a turned bar with beads from one place to another.
inline void add_bar(PictureMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double radius_from,
                    double radius_to) {
    constexpr int sides = 20;
    constexpr int rings = 24;
    const double length = glm::distance(from, to);
    std::vector<glm::dvec2> profile; // (radius, height)
    for (int i = 0; i <= rings; ++i) {
        const double t = static_cast<double>(i) / rings;
        const double beads = 1.0 + 0.15 * std::sin(6.0 * std::numbers::pi * t) * std::sin(std::numbers::pi * t);
        profile.push_back({glm::mix(radius_from, radius_to, t) * beads, length * t});
    }
    Profiles part;
    part.turned(profile, sides);
    part.cap(circle(profile.front().x, sides), {}, 0.0, false);
    part.cap(circle(profile.back().x, sides), {}, length, true);
    const glm::dvec3 z = glm::normalize(to - from);
    const glm::dvec3 across = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(across, z));
    mesh.append(part.take(), glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                                        glm::dvec4(from, 1.0)));
}

// Returns a seat with round edges and a hollow.
[[nodiscard]] inline PictureMesh seat() {
    constexpr int steps = 12;
    const auto outline = [](int step) {
        const double inset = 1.5 * (1.0 - std::sin(std::numbers::pi * step / steps));
        return rounded_rectangle(glm::dvec2(44.0, 42.0) - 2.0 * inset, 9.0 - inset, 16);
    };
    const auto hollow = [](int step) {
        Loop loop = rounded_rectangle({41.0, 39.0}, 7.5, 16);
        for (glm::dvec2& p : loop) p *= 1.0 - step / 13.0;
        return loop;
    };
    const auto height = [](int step) {
        return 45.0 - 1.2 * std::pow(std::sin(0.5 * std::numbers::pi * step / steps), 2.0);
    };
    Profiles part;
    part.cap(outline(0), {}, 42.0, false);
    for (int i = 0; i < steps; ++i) part.wall(outline(i), 42.0 + 0.25 * i, outline(i + 1), 42.25 + 0.25 * i);
    part.wall(outline(steps), 45.0, hollow(0), 45.0);
    for (int i = 0; i < steps; ++i) part.wall(hollow(i), height(i), hollow(i + 1), height(i + 1));
    part.cap(hollow(steps), {}, height(steps), true);
    return part.take();
}

} // namespace detail

// A chair of 39 parts with arms. Each face is given twice, with opposite orientations; z is up.
[[nodiscard]] inline PictureMesh double_sided_chair() {
    PictureMesh all = detail::seat();
    const auto bar = [&all](const glm::dvec3& from, const glm::dvec3& to, double radius_from, double radius_to) {
        detail::add_bar(all, from, to, radius_from, radius_to);
    };
    for (const double side : {-1.0, 1.0}) {
        bar({side * 19.0, -19.0, 0.0}, {side * 17.0, -16.0, 42.0}, 1.4, 2.0); // legs
        bar({side * 18.0, 20.0, 0.0}, {side * 17.0, 16.0, 42.0}, 1.4, 2.0);
        bar({side * 17.0, 17.0, 44.5}, {side * 18.0, 24.0, 90.0}, 1.8, 1.3);
        bar({side * 18.6, -18.2, 12.0}, {side * 17.7, 18.8, 12.0}, 1.0, 1.0);
        bar({side * 18.0, -16.0, 44.5}, {side * 20.0, -16.0, 64.0}, 1.5, 1.2); // arms
        bar({side * 20.0, -19.0, 65.0}, {side * 18.0, 21.0, 68.0}, 1.7, 1.4);
        for (int i = 0; i < 5; ++i)
            bar({side * 18.2, 5.5 * i - 11.0, 44.5}, {side * 19.3, 6.0 * i - 11.0, 65.0 + 0.4 * i}, 0.7, 0.7);
    }
    bar({-18.0, 0.0, 12.0}, {18.0, 0.0, 12.0}, 1.0, 1.0);
    bar({-18.8, -18.6, 20.0}, {18.8, -18.6, 20.0}, 1.0, 1.0);
    bar({-17.6, 18.4, 20.0}, {17.6, 18.4, 20.0}, 1.0, 1.0);
    for (int i = -5; i <= 5; ++i) bar({2.8 * i, 17.5, 44.5}, {3.0 * i, 23.5, 86.5}, 0.8, 0.8);
    bar({-21.0, 24.0, 88.0}, {21.0, 24.0, 88.0}, 2.2, 2.2);
    const std::size_t once = all.faces.size();
    for (std::size_t i = 0; i < once; ++i) {
        const Face f = all.faces[i];
        all.faces.push_back({f[0], f[2], f[1]});
    }
    return all;
}

} // namespace bench
