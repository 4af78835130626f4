// SPDX-License-Identifier: MIT
// Clouds with known normals: surfaces (u, v) -> point, sampled evenly by area.
#pragma once

#include "samples.h"
#include "vec3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bench {

using Point = std::array<double, 3>;
// A map of the unit square; the cross product of its derivatives points outward.
using Patch = std::function<Point(double u, double v)>;

inline constexpr double tau = 6.283185307179586;

struct Facet {
    Point point;
    Point normal;
    double area; // per unit of u and v
};

inline Facet facet(const Patch& patch, double u, double v) {
    constexpr double h = 1e-5;
    const Point p = patch(u, v);
    const Point a = patch(u + h, v);
    const Point b = patch(u - h, v);
    const Point c = patch(u, v + h);
    const Point d = patch(u, v - h);
    Point n{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        n[i] = (a[j] - b[j]) * (c[k] - d[k]) - (a[k] - b[k]) * (c[j] - d[j]);
    }
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& x : n) x /= std::max(length, 1e-300);
    return {p, n, length / (4.0 * h * h)};
}

// Samples places of the unit square by area: rejection from a low-discrepancy sequence (Roberts 2018).
inline std::vector<Facet> by_area(const Patch& patch, std::int64_t count) {
    constexpr double plastic = 1.32471795724474602596;
    double most = 0.0;
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j) most = std::max(most, facet(patch, (i + 0.5) / 200.0, (j + 0.5) / 200.0).area);
    std::vector<Facet> facets;
    for (std::int64_t i = 0; static_cast<std::int64_t>(facets.size()) < count; ++i) {
        const double k = static_cast<double>(i) + 0.5;
        const Facet f = facet(patch, std::fmod(k / plastic, 1.0), std::fmod(k / (plastic * plastic), 1.0));
        if (f.area >= 1.02 * most * std::fmod(k * 0.6180339887498949, 1.0)) facets.push_back(f);
    }
    return facets;
}

// Chooses the facet farthest from all chosen ones, one by one, which is as even as farthest-point samples of a mesh.
inline std::vector<Facet> spread_out(const std::vector<Facet>& facets, std::int64_t count) {
    std::vector<double> distance(facets.size(), HUGE_VAL);
    std::vector<Facet> chosen;
    std::size_t next = 0;
    for (std::int64_t k = 0; k < count; ++k) {
        const Facet picked = facets[next];
        chosen.push_back(picked);
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const double x = facets[i].point[0] - picked.point[0];
            const double y = facets[i].point[1] - picked.point[1];
            const double z = facets[i].point[2] - picked.point[2];
            distance[i] = std::min(distance[i], x * x + y * y + z * z);
            if (i == 0 || distance[i] > distance[next]) next = i;
        }
        next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
    }
    return chosen;
}

inline Samples sampled(const Patch& patch, std::int64_t count) {
    constexpr std::int64_t spread = 4000; // more would take too long
    const std::vector<Facet> facets =
        count <= spread ? spread_out(by_area(patch, 10 * count), count) : by_area(patch, count);
    Samples samples;
    for (const Facet& f : facets) samples.add(f.point, f.normal);
    return samples;
}

// Returns the tube of this radius around a closed curve.
inline Patch tube(const std::function<Point(double)>& curve, double radius) {
    return [=](double u, double v) {
        constexpr double h = 1e-4;
        const Point c = curve(u);
        const Point a = curve(u + h);
        const Point b = curve(u - h);
        Point t{};
        Point s{}; // the second derivative, never parallel to the first for the curves below
        for (std::size_t i = 0; i < 3; ++i) {
            t[i] = a[i] - b[i];
            s[i] = a[i] + b[i] - 2.0 * c[i];
        }
        const double tt = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        const double ts = (t[0] * s[0] + t[1] * s[1] + t[2] * s[2]) / tt;
        for (std::size_t i = 0; i < 3; ++i) s[i] -= ts * t[i];
        const double ss = std::hypot(s[0], s[1], s[2]);
        const double tl = std::sqrt(tt);
        Point p{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            const double binormal = (t[j] * s[k] - t[k] * s[j]) / (tl * ss);
            p[i] = c[i] + radius * (-s[i] / ss * std::cos(tau * v) + binormal * std::sin(tau * v));
        }
        return p;
    };
}

inline Patch sphere_patch(double radius) {
    return [=](double u, double v) {
        const double z = 2.0 * v - 1.0;
        const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
        return Point{radius * flat * std::cos(tau * u), radius * flat * std::sin(tau * u), radius * z};
    };
}

inline Patch torus_patch(double ring, double radius) {
    return tube([=](double u) { return Point{ring * std::cos(tau * u), ring * std::sin(tau * u), 0.0}; }, radius);
}

inline Patch knot_patch() {
    return tube(
        [](double u) {
            const double t = tau * u;
            return Point{std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                         -std::sin(3.0 * t)};
        },
        0.35);
}

// Revolves the profile (r, z)(v) of a closed or open curve, whose right side is outside.
inline Patch turned(const std::function<std::array<double, 2>(double)>& profile) {
    return [=](double u, double v) {
        const auto [r, z] = profile(v);
        return Point{r * std::cos(tau * u), r * std::sin(tau * u), z};
    };
}

// A round plate of this thickness with a round rim, and a bowl of the same thickness.
inline Patch plate_patch(double radius, double thickness) {
    return turned([=](double v) -> std::array<double, 2> {
        const double rim = 0.25 * tau * thickness; // half a circle, the thickness its diameter
        const double length = 2.0 * radius + rim;
        double s = v * length;
        if (s < radius) return {s, -0.5 * thickness};
        s -= radius;
        if (s < rim) {
            const double a = s / (0.5 * thickness) - 0.25 * tau;
            return {radius + 0.5 * thickness * std::cos(a), 0.5 * thickness * std::sin(a)};
        }
        return {std::max(0.0, radius - (s - rim)), 0.5 * thickness};
    });
}

inline Patch bowl_patch(double radius, double thickness) {
    const double outer = radius + 0.5 * thickness;
    const double inner = radius - 0.5 * thickness;
    return turned([=](double v) -> std::array<double, 2> {
        const double rim = 0.25 * tau * thickness;
        const double length = 0.25 * tau * (outer + inner) + rim;
        double s = v * length;
        if (s < 0.25 * tau * outer) {
            const double a = s / outer - 0.25 * tau;
            return {outer * std::cos(a), outer * std::sin(a)};
        }
        s -= 0.25 * tau * outer;
        if (s < rim) {
            const double a = s / (0.5 * thickness);
            return {radius + 0.5 * thickness * std::cos(a), 0.5 * thickness * std::sin(a)};
        }
        const double a = -(s - rim) / inner;
        return {std::max(0.0, inner * std::cos(a)), inner * std::sin(a)};
    });
}

inline Patch terrain_patch(double height, double lift = 0.0, double side = 1.0) {
    return [=](double u, double v) {
        const double x = side > 0.0 ? u : 1.0 - u;
        return Point{4.0 * x - 2.0, 4.0 * v - 2.0,
                     lift + height * (std::sin(5.0 * x) * std::cos(4.0 * v) + 0.4 * std::sin(11.0 * v + 3.0 * x))};
    };
}

inline Patch half(const Patch& patch) {
    return [=](double u, double v) { return patch(0.5 * u, v); };
}

inline Samples together(Samples a, const Samples& b) {
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
    return a;
}

// Samples curves u = const and v = const of a patch: wires and cross sections.
inline Samples lines_of(const Patch& patch, int across, int along, int points) {
    Samples samples;
    const auto add = [&](double u, double v) {
        const Facet f = facet(patch, u, v);
        samples.add(f.point, f.normal);
    };
    for (int k = 0; k < across; ++k)
        for (int i = 0; i < points; ++i) add((k + 0.37) / across, (i + 0.5) / points);
    for (int k = 0; k < along; ++k)
        for (int i = 0; i < points; ++i) add((i + 0.5) / points, (k + 0.63) / along);
    return samples;
}

// Returns the distance between a surface's samples if they were a hexagonal lattice.
inline double lattice_spacing(double area, std::int64_t count) {
    return std::sqrt(1.1547 * area / static_cast<double>(count));
}

inline double diagonal_of(const Samples& samples) {
    Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Point high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], samples.points[i]);
        high[i % 3] = std::max(high[i % 3], samples.points[i]);
    }
    return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

// Adds normally distributed noise of `deviation` diagonals in all directions.
inline Samples noisy(Samples samples, double deviation, std::uint64_t seed) {
    const double sigma = deviation * diagonal_of(samples);
    std::uint64_t state = seed;
    const auto uniform = [&] { // splitmix64
        std::uint64_t x = state += 0x9E3779B97F4A7C15U;
        x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
        x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
        return (static_cast<double>((x ^ (x >> 31U)) >> 11U) + 0.5) / 9007199254740992.0;
    };
    for (double& x : samples.points) x += sigma * std::sqrt(-2.0 * std::log(uniform())) * std::cos(tau * uniform());
    return samples;
}

struct NamedCloud {
    std::string name;
    Samples samples;
    bool smooth;            // the mean angle is judged, too
    double wall = HUGE_VAL; // thickness of the thinnest wall
};

inline std::vector<NamedCloud> analytic_clouds() {
    std::vector<NamedCloud> clouds;
    const auto add = [&](const std::string& name, Samples samples, double thickness = HUGE_VAL) {
        const bool smooth = samples.count() >= 2000;
        clouds.push_back({name + "_" + std::to_string(samples.count()), std::move(samples), smooth, thickness});
    };
    for (const int n : {25, 100, 1000, 20000}) add("sphere", sampled(sphere_patch(1.0), n));
    for (const int n : {100, 500, 2000, 10000}) add("torus", sampled(torus_patch(1.0, 0.4), n));
    for (const int n : {1000, 4000, 50000}) add("knot", sampled(knot_patch(), n));
    for (const double walls : {1.0, 1.5}) {
        const std::string wall = walls == 1.0 ? "_1" : "_1.5";
        for (const int n : {1000, 4000, 30000}) {
            const double plate = walls * lattice_spacing(tau, n);
            const double bowl = walls * lattice_spacing(2.0 * tau, n);
            add("plate" + wall, sampled(plate_patch(1.0, plate), n), plate);
            add("bowl" + wall, sampled(bowl_patch(1.0, bowl), n), bowl);
        }
        for (const int n : {2000, 20000}) {
            const double gap = walls * lattice_spacing(35.0, n);
            add("sheets" + wall,
                together(sampled(terrain_patch(0.15, 0.5 * gap), n / 2),
                         sampled(terrain_patch(0.15, -0.5 * gap, -1.0), n / 2)),
                gap);
        }
    }
    add("sphere_lines", lines_of(sphere_patch(1.0), 8, 6, 40));
    add("torus_sections", lines_of(torus_patch(1.0, 0.4), 16, 0, 40));
    add("knot_wires", lines_of(knot_patch(), 80, 4, 40));
    for (const int n : {500, 4000}) add("half_torus", sampled(half(torus_patch(1.0, 0.4)), n));
    for (const int n : {500, 5000}) add("half_sphere", sampled(half(sphere_patch(1.0)), n));
    for (const int n : {500, 10000}) add("terrain", sampled(terrain_patch(0.15), n));
    return clouds;
}

} // namespace bench
