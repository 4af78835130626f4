// SPDX-License-Identifier: MIT
// Points and normals of exactly known shapes, well spread and the same on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hrbfnpr::test {

struct Samples {
    std::vector<double> points;  // packed x y z
    std::vector<double> normals; // unit, outward

    void add(const std::array<double, 3>& point, const std::array<double, 3>& normal) {
        points.insert(points.end(), point.begin(), point.end());
        normals.insert(normals.end(), normal.begin(), normal.end());
    }
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(points.size() / 3); }
};

// The i-th of n points of Fibonacci's spiral on the unit sphere.
inline std::array<double, 3> spiral_point(std::int64_t i, std::int64_t n) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(n);
    const double angle = 2.399963229728653 * static_cast<double>(i);
    const double flat = std::sqrt(1.0 - z * z);
    return {flat * std::cos(angle), flat * std::sin(angle), z};
}

// The six axis points of the unit sphere.
inline Samples sphere_6() {
    Samples samples;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            std::array<double, 3> p{};
            p[axis] = sign;
            samples.add(p, p);
        }
    }
    return samples;
}

inline Samples sphere(std::int64_t count) {
    Samples samples;
    for (std::int64_t i = 0; i < count; ++i) samples.add(spiral_point(i, count), spiral_point(i, count));
    return samples;
}

// Adds a tube about a circle of radius 1 around `centre`, in the plane of the unit vectors e1 and e2. The angles follow
// the plastic number's sequence (Roberts 2018). The tube's angle is warped so that samples are even by area.
inline void add_torus(Samples& samples, int count, double tube, const std::array<double, 3>& centre,
                      const std::array<double, 3>& e1, const std::array<double, 3>& e2) {
    constexpr double plastic = 1.32471795724474602596;
    constexpr double tau = 6.283185307179586;
    const std::array<double, 3> axis{e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2],
                                     e1[0] * e2[1] - e1[1] * e2[0]};
    for (int i = 0; i < count; ++i) {
        const double phi = tau * std::fmod((i + 0.5) / plastic, 1.0);
        const double area = tau * std::fmod((i + 0.5) / (plastic * plastic), 1.0);
        double theta = area; // solves theta + tube sin theta = area
        for (int step = 0; step < 20; ++step)
            theta -= (theta + tube * std::sin(theta) - area) / (1.0 + tube * std::cos(theta));
        std::array<double, 3> normal{};
        std::array<double, 3> point{};
        for (std::size_t c = 0; c < 3; ++c) {
            const double out = e1[c] * std::cos(phi) + e2[c] * std::sin(phi);
            normal[c] = out * std::cos(theta) + axis[c] * std::sin(theta);
            point[c] = centre[c] + (out + normal[c] * tube);
        }
        samples.add(point, normal);
    }
}

// A torus about z with ring radius 1 and tube radius 0.4.
inline Samples torus(int count) {
    Samples samples;
    add_torus(samples, count, 0.4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return samples;
}

// The same torus with more even samples, for one count at a time: the golden angle around the ring, and equal areas
// around the tube.
inline Samples even_torus(std::int64_t count) {
    constexpr double tau = 6.283185307179586;
    constexpr double tube = 0.4;
    Samples samples;
    for (std::int64_t i = 0; i < count; ++i) {
        const double area = tau * ((static_cast<double>(i) + 0.5) / static_cast<double>(count));
        double v = area; // solves v + tube sin v = area
        for (int step = 0; step < 20; ++step) v -= (v + tube * std::sin(v) - area) / (1.0 + tube * std::cos(v));
        const double u = std::fmod(2.399963229728653 * static_cast<double>(i), tau);
        const double ring = 1.0 + tube * std::cos(v);
        samples.add({ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)},
                    {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)});
    }
    return samples;
}

// The sphere of radius 1 + bump sin 4x cos(3y + z), which is nowhere a polynomial of low degree.
inline Samples bumpy(std::int64_t count, double bump = 0.15) {
    Samples samples;
    for (std::int64_t i = 0; i < count; ++i) {
        const std::array<double, 3> s = spiral_point(i, count);
        const double phase = 3.0 * s[1] + s[2];
        const double radius = 1.0 + bump * std::sin(4.0 * s[0]) * std::cos(phase);
        const std::array<double, 3> slope{4.0 * bump * std::cos(4.0 * s[0]) * std::cos(phase),
                                          -3.0 * bump * std::sin(4.0 * s[0]) * std::sin(phase),
                                          -bump * std::sin(4.0 * s[0]) * std::sin(phase)};
        const double along = slope[0] * s[0] + slope[1] * s[1] + slope[2] * s[2];
        std::array<double, 3> point{};
        std::array<double, 3> normal{};
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] = radius * s[c];
            normal[c] = radius * s[c] - (slope[c] - along * s[c]);
        }
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        for (double& c : normal) c /= length;
        samples.add(point, normal);
    }
    return samples;
}

// Adds a sample of a torus of radii 3 and 1 about z, at an angle around z and one around the tube.
inline void add_of_torus(Samples& samples, double around, double tube) {
    const std::array<double, 3> normal{std::cos(tube) * std::cos(around), std::cos(tube) * std::sin(around),
                                       std::sin(tube)};
    samples.add({3.0 * std::cos(around) + normal[0], 3.0 * std::sin(around) + normal[1], normal[2]}, normal);
}

// Wires on that torus: both equators, and four circles around the tube.
inline Samples torus_wires(double spacing) {
    constexpr double tau = 6.283185307179586;
    Samples samples;
    const auto steps = [&](double radius) { return static_cast<int>(tau * radius / spacing); };
    for (const double tube : {0.0, 0.5 * tau})
        for (int i = 0, n = steps(3.0 + std::cos(tube)); i < n; ++i) add_of_torus(samples, tau * (i + 0.5) / n, tube);
    for (int turn = 0; turn < 4; ++turn)
        for (int i = 0, n = steps(1.0); i < n; ++i) add_of_torus(samples, 0.25 * tau * turn + 0.1, tau * (i + 0.5) / n);
    return samples;
}

// Cross sections of that torus by planes across x, from -3 to 3. The torus reaches from -4 to 4.
inline Samples torus_sections(int planes, int each) {
    constexpr double tau = 6.283185307179586;
    Samples samples;
    for (int plane = 0; plane < planes; ++plane) {
        const double x = -3.0 + 6.0 * plane / (planes - 1);
        for (int i = 0; i < each; ++i) {
            const double tube = tau * (i + 0.5) / each;
            const double cosine = x / (3.0 + std::cos(tube));
            if (std::abs(cosine) > 1.0) continue;
            for (const double side : {1.0, -1.0}) add_of_torus(samples, side * std::acos(cosine), tube);
        }
    }
    return samples;
}

// Adds noise of this deviation, a sum of uniform numbers that is the same on every machine.
inline Samples with_noise(Samples samples, double deviation) {
    std::uint64_t state = 1;
    const auto uniform = [&] { // splitmix64
        std::uint64_t x = state += 0x9E3779B97F4A7C15U;
        x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
        x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
        return static_cast<double>((x ^ (x >> 31U)) >> 11U) / 9007199254740992.0 - 0.5;
    };
    for (double& x : samples.points) x += deviation * 2.0 * (uniform() + uniform() + uniform());
    return samples;
}

} // namespace hrbfnpr::test
