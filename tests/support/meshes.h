// SPDX-License-Identifier: MIT
// Triangle meshes of known shapes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace hrbfnpr::test {

struct Triangles {
    std::vector<double> vertices;        // packed x y z
    std::vector<std::int32_t> triangles; // three of each

    [[nodiscard]] std::int32_t add(double x, double y, double z) {
        vertices.insert(vertices.end(), {x, y, z});
        return static_cast<std::int32_t>(vertices.size() / 3 - 1);
    }
    void face(std::int32_t a, std::int32_t b, std::int32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
    [[nodiscard]] std::size_t faces() const { return triangles.size() / 3; }

    [[nodiscard]] Triangles turned() const {
        Triangles result = *this;
        for (std::size_t i = 0; i < triangles.size(); i += 3) std::swap(result.triangles[i], result.triangles[i + 1]);
        return result;
    }
    [[nodiscard]] Triangles moved(double scale, double x, double y, double z) const {
        Triangles result = *this;
        const std::array<double, 3> by{x, y, z};
        for (std::size_t i = 0; i < vertices.size(); ++i) result.vertices[i] = scale * vertices[i] + by[i % 3];
        return result;
    }
    [[nodiscard]] Triangles with(const Triangles& other) const {
        Triangles result = *this;
        const auto first = static_cast<std::int32_t>(vertices.size() / 3);
        result.vertices.insert(result.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const std::int32_t corner : other.triangles) result.triangles.push_back(corner + first);
        return result;
    }
    // Returns the faces whose centre satisfies accept(x, y, z).
    template <class Accept>
    [[nodiscard]] Triangles where(Accept&& accept) const {
        Triangles result;
        result.vertices = vertices;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            std::array<double, 3> middle{};
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    middle[c] += vertices[3 * static_cast<std::size_t>(triangles[i + k]) + c] / 3.0;
            if (accept(middle[0], middle[1], middle[2])) result.face(triangles[i], triangles[i + 1], triangles[i + 2]);
        }
        return result;
    }
    // Returns the mesh with separate vertices for each face, as in STL files.
    [[nodiscard]] Triangles unwelded() const {
        Triangles result;
        for (const std::int32_t corner : triangles) {
            const auto at = 3 * static_cast<std::size_t>(corner);
            result.triangles.push_back(result.add(vertices[at], vertices[at + 1], vertices[at + 2]));
        }
        return result;
    }
};

// A sphere of radius 1 with 20 * 4^levels faces.
inline Triangles icosphere(int levels) {
    Triangles mesh;
    const double t = 0.5 * (1.0 + std::sqrt(5.0));
    const auto add = [&](double x, double y, double z) {
        const double length = std::sqrt(x * x + y * y + z * z);
        return mesh.add(x / length, y / length, z / length);
    };
    for (const double a : {-1.0, 1.0})
        for (const double b : {-t, t}) static_cast<void>(add(a, b, 0.0));
    for (const double a : {-1.0, 1.0})
        for (const double b : {-t, t}) static_cast<void>(add(0.0, a, b));
    for (const double a : {-1.0, 1.0})
        for (const double b : {-t, t}) static_cast<void>(add(b, 0.0, a));
    const auto squared = [&](int i, int j) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double off =
                mesh.vertices[3 * static_cast<std::size_t>(i) + c] - mesh.vertices[3 * static_cast<std::size_t>(j) + c];
            sum += off * off;
        }
        return sum;
    };
    // Three corners that are an edge length apart make a face, which is turned outward.
    const double edge = 4.0 / (1.0 + t * t) + 1e-9;
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k) {
                if (squared(i, j) > edge || squared(j, k) > edge || squared(i, k) > edge) continue;
                const double* const v = mesh.vertices.data();
                const auto at = [&](int n, int c) { return v[3 * n + c]; };
                const double volume = at(i, 0) * (at(j, 1) * at(k, 2) - at(j, 2) * at(k, 1)) +
                                      at(i, 1) * (at(j, 2) * at(k, 0) - at(j, 0) * at(k, 2)) +
                                      at(i, 2) * (at(j, 0) * at(k, 1) - at(j, 1) * at(k, 0));
                if (volume > 0.0)
                    mesh.face(i, j, k);
                else
                    mesh.face(i, k, j);
            }
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto key = std::minmax(a, b);
            const auto found = middles.find(key);
            if (found != middles.end()) return found->second;
            const auto i = 3 * static_cast<std::size_t>(a), j = 3 * static_cast<std::size_t>(b);
            const double x = mesh.vertices[i] + mesh.vertices[j];
            const double y = mesh.vertices[i + 1] + mesh.vertices[j + 1];
            const double z = mesh.vertices[i + 2] + mesh.vertices[j + 2];
            return middles[key] = add(x, y, z);
        };
        std::vector<std::int32_t> before;
        before.swap(mesh.triangles);
        for (std::size_t i = 0; i < before.size(); i += 3) {
            const std::int32_t a = before[i], b = before[i + 1], c = before[i + 2];
            const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            mesh.face(a, ab, ca);
            mesh.face(ab, b, bc);
            mesh.face(ca, bc, c);
            mesh.face(ab, bc, ca);
        }
    }
    return mesh;
}

// A closed ring of closed rings of vertices, joined by quadrilaterals that are cut in two.
template <class Place>
Triangles ring_of_rings(int around, int along, Place&& place) {
    Triangles mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            const std::array<double, 3> p = place(static_cast<double>(i) / around, static_cast<double>(j) / along);
            static_cast<void>(mesh.add(p[0], p[1], p[2]));
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            const int k = (i + 1) % around, l = (j + 1) % along;
            mesh.face(i * along + j, k * along + j, k * along + l);
            mesh.face(i * along + j, k * along + l, i * along + l);
        }
    return mesh;
}

// A torus about the z axis with radii 1 and `tube`.
inline Triangles torus(int around, int along, double tube) {
    constexpr double turn = 6.283185307179586;
    return ring_of_rings(around, along, [&](double u, double v) {
        const double r = 1.0 + tube * std::cos(turn * v);
        return std::array<double, 3>{r * std::cos(turn * u), r * std::sin(turn * u), tube * std::sin(turn * v)};
    });
}

// A ring that is alternately thin and thick and winds up and down. A smooth surface through few samples bulges out of
// it.
inline Triangles wound_ring(int around, int along) {
    constexpr double turn = 6.283185307179586;
    return ring_of_rings(around, along, [&](double u, double v) {
        const double tube = 0.1 + 0.08 * std::sin(5.0 * turn * u);
        const double r = 1.0 + tube * std::cos(turn * v);
        return std::array<double, 3>{r * std::cos(turn * u), r * std::sin(turn * u),
                                     0.4 * std::sin(2.0 * turn * u) + tube * std::sin(turn * v)};
    });
}

// A tetrahedron: four faces with sharp edges.
inline Triangles tetrahedron() {
    Triangles mesh;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) static_cast<void>(mesh.add(x, y, x * y));
    mesh.face(0, 3, 1);
    mesh.face(0, 1, 2);
    mesh.face(0, 2, 3);
    mesh.face(1, 3, 2);
    return mesh;
}

// A box from 0 to (x, y, z). Each side has 2 * cells^2 triangles.
inline Triangles box(double x, double y, double z, int cells) {
    Triangles mesh;
    const std::array<double, 3> size{x, y, z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const auto first = static_cast<std::int32_t>(mesh.vertices.size() / 3);
            for (int i = 0; i <= cells; ++i)
                for (int j = 0; j <= cells; ++j) {
                    std::array<double, 3> p{};
                    p[axis] = high ? size[axis] : 0.0;
                    p[(axis + 1) % 3] = size[(axis + 1) % 3] * i / cells;
                    p[(axis + 2) % 3] = size[(axis + 2) % 3] * j / cells;
                    static_cast<void>(mesh.add(p[0], p[1], p[2]));
                }
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const std::int32_t a = first + i * (cells + 1) + j, b = a + cells + 1;
                    if (high) {
                        mesh.face(a, b, b + 1);
                        mesh.face(a, b + 1, a + 1);
                    } else {
                        mesh.face(a, b + 1, b);
                        mesh.face(a, a + 1, b + 1);
                    }
                }
        }
    return mesh;
}

} // namespace hrbfnpr::test
