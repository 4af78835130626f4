// SPDX-License-Identifier: MIT
// Meshes of shapes with edges.
#pragma once

#include "support/meshes.h"

namespace hrbfnpr::test {

// Each returns the distance from the axis at an angle.
inline double circle(double radius, double /*angle*/) { return radius; }
inline double polygon(int corners, double inradius, double angle) {
    const double turn = 6.283185307179586 / corners;
    return inradius / std::cos(std::fmod(angle, turn) - 0.5 * turn);
}

struct Ring {
    double radius, z;
    int corners = 0; // corners of a polygon with `radius` as inradius; 0: a circle
    [[nodiscard]] double at(double angle) const {
        return corners == 0 || radius == 0.0 ? circle(radius, angle) : polygon(corners, radius, angle);
    }
};

// Joins rings about the z axis, listed from the bottom outward and up. More rings are added between them, about
// `spacing` apart. segments: a multiple of the polygons' corners.
inline Triangles ringed(const std::vector<Ring>& rings, int segments, double spacing) {
    Triangles mesh;
    std::vector<std::vector<std::int32_t>> vertex;
    const auto add = [&](const Ring& a, const Ring& b, double t) {
        vertex.emplace_back();
        for (int k = 0; k < segments; ++k) {
            const double angle = 6.283185307179586 * k / segments;
            const double r = a.at(angle) + t * (b.at(angle) - a.at(angle));
            const double z = a.z + t * (b.z - a.z);
            if (r > 0.0 || k == 0)
                vertex.back().push_back(mesh.add(r * std::cos(angle), r * std::sin(angle), z));
            else
                vertex.back().push_back(vertex.back().front());
        }
    };
    add(rings[0], rings[0], 0.0);
    for (std::size_t i = 1; i < rings.size(); ++i) {
        const double length = std::hypot(rings[i].radius - rings[i - 1].radius, rings[i].z - rings[i - 1].z);
        const int parts = std::max(1, static_cast<int>(length / spacing));
        for (int k = 1; k <= parts; ++k) add(rings[i - 1], rings[i], static_cast<double>(k) / parts);
    }
    for (std::size_t i = 1; i < vertex.size(); ++i)
        for (int k = 0; k < segments; ++k) {
            const auto a = static_cast<std::size_t>(k);
            const auto b = static_cast<std::size_t>((k + 1) % segments);
            const std::vector<std::int32_t>& low = vertex[i - 1];
            const std::vector<std::int32_t>& high = vertex[i];
            if (low[a] != low[b]) mesh.face(low[a], low[b], high[b]);
            if (high[a] != high[b]) mesh.face(low[a], high[b], high[a]);
        }
    return mesh;
}

// A shaft with three steps of radius 1, 0.6 and 0.35, and a groove.
inline Triangles stepped_shaft(int segments) {
    return ringed({{0.0, 0.0},
                   {1.0, 0.0},
                   {1.0, 0.8},
                   {0.6, 0.8},
                   {0.6, 1.2},
                   {0.5, 1.2},
                   {0.5, 1.4},
                   {0.6, 1.4},
                   {0.6, 2.2},
                   {0.35, 2.2},
                   {0.35, 3.0},
                   {0.0, 3.0}},
                  segments, 6.0 / segments);
}

// The socket of a wrench: a square hole below and a hexagonal one above. `segments` is a multiple of 12.
inline Triangles socket(int segments) {
    return ringed({{0.0, 0.8},
                   {0.35, 0.8, 4},
                   {0.35, 0.0, 4},
                   {0.7, 0.0},
                   {0.7, 1.2},
                   {1.0, 1.2},
                   {1.0, 2.4},
                   {0.7, 2.4, 6},
                   {0.7, 1.3, 6},
                   {0.0, 1.3}},
                  segments, 6.0 / segments);
}

// A gear with trapezoidal teeth between the radii 0.8 and 1, a bore of 0.3 and a height of 0.4. Each straight part has
// `cuts` cuts.
inline Triangles gear(int teeth, int cuts) {
    constexpr double turn = 6.283185307179586;
    std::vector<std::array<double, 2>> outline;
    for (int tooth = 0; tooth < teeth; ++tooth) {
        const std::array<std::array<double, 2>, 5> corner{
            {{0.8, 0.0}, {0.8, 0.3}, {1.0, 0.45}, {1.0, 0.85}, {0.8, 1.0}}};
        for (std::size_t i = 0; i + 1 < corner.size(); ++i)
            for (int k = 0; k < cuts; ++k) {
                const double t = static_cast<double>(k) / cuts;
                const double from = turn * (tooth + corner[i][1]) / teeth;
                const double to = turn * (tooth + corner[i + 1][1]) / teeth;
                outline.push_back({(1.0 - t) * corner[i][0] * std::cos(from) + t * corner[i + 1][0] * std::cos(to),
                                   (1.0 - t) * corner[i][0] * std::sin(from) + t * corner[i + 1][0] * std::sin(to)});
            }
    }
    Triangles mesh;
    std::vector<std::vector<std::int32_t>> ring;
    const auto add = [&](double share, double z) { // share of the way from the bore outward
        ring.emplace_back();
        for (const auto& p : outline) {
            const double r = std::hypot(p[0], p[1]);
            const double by = (0.3 + share * (r - 0.3)) / r;
            ring.back().push_back(mesh.add(by * p[0], by * p[1], z));
        }
    };
    constexpr int parts = 6;
    for (int i = 0; i < parts; ++i) add(0.0, 0.4 - 0.4 * i / parts);
    for (int i = 0; i < parts; ++i) add(static_cast<double>(i) / parts, 0.0);
    for (int i = 0; i < parts; ++i) add(1.0, 0.4 * i / parts);
    for (int i = 0; i < parts; ++i) add(1.0 - static_cast<double>(i) / parts, 0.4);
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const std::vector<std::int32_t>& low = ring[i];
            const std::vector<std::int32_t>& high = ring[(i + 1) % ring.size()];
            const std::size_t next = (k + 1) % outline.size();
            mesh.face(low[k], low[next], high[next]);
            mesh.face(low[k], high[next], high[k]);
        }
    return mesh;
}

// The cube [-1, 1]^3 without a cylinder about the z axis. `segments`, a multiple of 8, is the number around it.
inline Triangles drilled_cube(double radius, int segments) {
    Triangles mesh;
    const int rings = segments / 8;
    const auto place = [&](int k, double share, double z) {
        const double angle = 6.283185307179586 * k / segments;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double out = 1.0 / std::max(std::abs(c), std::abs(s));
        const double r = radius + share * (out - radius);
        return mesh.add(r * c, r * s, z);
    };
    const auto strip = [&](const std::vector<std::int32_t>& low, const std::vector<std::int32_t>& high) {
        for (int k = 0; k < segments; ++k) {
            const auto a = static_cast<std::size_t>(k);
            const auto b = static_cast<std::size_t>((k + 1) % segments);
            mesh.face(low[a], low[b], high[b]);
            mesh.face(low[a], high[b], high[a]);
        }
    };
    std::vector<std::vector<std::int32_t>> around; // closed: down the hole, outward below, up the sides, inward above
    const auto ring = [&](double share, double z) {
        around.emplace_back();
        for (int k = 0; k < segments; ++k) around.back().push_back(place(k, share, z));
    };
    for (int i = 0; i < rings; ++i) ring(0.0, 1.0 - 2.0 * i / rings);
    for (int i = 0; i < rings; ++i) ring(static_cast<double>(i) / rings, -1.0);
    for (int i = 0; i < rings; ++i) ring(1.0, -1.0 + 2.0 * i / rings);
    for (int i = 0; i < rings; ++i) ring(1.0 - static_cast<double>(i) / rings, 1.0);
    for (std::size_t i = 0; i < around.size(); ++i) strip(around[i], around[(i + 1) % around.size()]);
    return mesh;
}

// A surface z = height(x, y) over [-1, 1]^2, in squares.
template <class Height>
Triangles height_field(int n, Height&& height) {
    Triangles mesh;
    const auto coordinate = [&](int i) { return 2.0 * i / n - 1.0; };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            static_cast<void>(mesh.add(coordinate(i), coordinate(j), height(coordinate(i), coordinate(j))));
    const auto at = [&](int i, int j) { return static_cast<std::int32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            mesh.face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return mesh;
}

// A plate, 15 by 9 by 3.6, with round corners. The chamfer at the top is as wide as the corners' radius, so there it is
// a quarter of a cone, whose tip is a corner of the top.
inline Triangles chamfered_plate(int cuts) {
    constexpr double chamfer = 1.0;
    const std::array<std::array<double, 2>, 4> middles{{{14.0, 8.0}, {1.0, 8.0}, {1.0, 1.0}, {14.0, 1.0}}};
    Triangles mesh;
    std::vector<std::int32_t> below, above, top;
    const int per = cuts + 1;
    for (int k = 0; k < 4 * per; ++k) {
        const std::array<double, 2>& middle = middles[static_cast<std::size_t>(k / per)];
        const double angle = 0.5 * 3.141592653589793 * (k / per + static_cast<double>(k % per) / cuts);
        const double x = middle[0] + chamfer * std::cos(angle), y = middle[1] + chamfer * std::sin(angle);
        below.push_back(mesh.add(x, y, 0.0));
        above.push_back(mesh.add(x, y, 3.6 - chamfer));
    }
    for (const std::array<double, 2>& middle : middles) top.push_back(mesh.add(middle[0], middle[1], 3.6));
    for (std::size_t k = 0; k < below.size(); ++k) {
        const std::size_t next = (k + 1) % below.size();
        const std::size_t corner = k / static_cast<std::size_t>(per), other = next / static_cast<std::size_t>(per);
        if (k > 0 && next > 0) mesh.face(below[0], below[next], below[k]);
        mesh.face(below[k], below[next], above[next]);
        mesh.face(below[k], above[next], above[k]);
        mesh.face(above[k], above[next], top[corner]);
        if (corner != other) mesh.face(above[next], top[other], top[corner]);
    }
    mesh.face(top[0], top[1], top[2]);
    mesh.face(top[0], top[2], top[3]);
    return mesh;
}

// A step along y = 0 of height x^2 / 4 that fades at x = 0. The side y > 0 is higher. n: squares along each axis.
inline Triangles fading_step(int n) {
    Triangles mesh;
    std::vector<std::int32_t> vertex[2]; // for each half
    const auto height = [](double x) { return x > 0.0 ? 0.25 * x * x : 0.0; };
    for (int upper = 0; upper < 2; ++upper)
        for (int j = 0; j <= n / 2; ++j)
            for (int i = 0; i <= n; ++i) {
                const double x = -1.0 + 2.0 * i / n;
                const bool joined = upper == 1 && j == 0 && 2 * i <= n;
                vertex[upper].push_back(
                    joined ? vertex[0][static_cast<std::size_t>(i)]
                           : mesh.add(x, (upper == 1 ? 2.0 : -2.0) * j / n, upper == 1 ? height(x) : 0.0));
            }
    const auto at = [&](int upper, int i, int j) { return vertex[upper][static_cast<std::size_t>(j * (n + 1) + i)]; };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n / 2; ++j) {
            mesh.face(at(1, i, j), at(1, i + 1, j), at(1, i + 1, j + 1));
            mesh.face(at(1, i, j), at(1, i + 1, j + 1), at(1, i, j + 1));
            mesh.face(at(0, i, j), at(0, i + 1, j + 1), at(0, i + 1, j));
            mesh.face(at(0, i, j), at(0, i, j + 1), at(0, i + 1, j + 1));
        }
        if (2 * i < n) continue;
        mesh.face(at(0, i, 0), at(0, i + 1, 0), at(1, i + 1, 0));
        if (2 * i > n) mesh.face(at(0, i, 0), at(1, i + 1, 0), at(1, i, 0));
    }
    return mesh;
}

} // namespace hrbfnpr::test
