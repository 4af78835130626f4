// SPDX-License-Identifier: MIT
// Meshes of which it is known whether they approximate shapes with edges: cages of quads that are subdivided and cut in
// either direction, grids, scans, folds and parts of machines.
#pragma once

#include "support/sharp_meshes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace hrbfnpr::test::verdict {

inline constexpr double pi = std::numbers::pi;

// A number in [-1, 1] that depends only on its arguments.
inline double random(std::uint64_t i, std::uint64_t stream) {
    std::uint64_t bits = (i + 1) * 0x9E3779B97F4A7C15U + (stream + 1) * 0xD1B54A32D192ED03U;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<double>((bits ^ (bits >> 31U)) >> 11U) * 0x1p-52 - 1.0;
}

// ---- Meshes of quads

struct Quads {
    std::vector<glm::dvec3> vertex;
    std::vector<std::array<std::int32_t, 4>> face;

    [[nodiscard]] glm::dvec3& at(std::int32_t i) { return vertex[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const glm::dvec3& at(std::int32_t i) const { return vertex[static_cast<std::size_t>(i)]; }
};

enum class Cut { first, second, shorter, random };

inline Triangles cut(const Quads& quads, Cut how) {
    Triangles mesh;
    for (const glm::dvec3& p : quads.vertex) static_cast<void>(mesh.add(p.x, p.y, p.z));
    for (std::size_t f = 0; f < quads.face.size(); ++f) {
        const auto& q = quads.face[f];
        const bool shorter =
            glm::distance(quads.at(q[0]), quads.at(q[2])) < glm::distance(quads.at(q[1]), quads.at(q[3]));
        const bool first =
            how == Cut::first || (how == Cut::shorter && shorter) || (how == Cut::random && random(f, 1) > 0.0);
        if (first) {
            mesh.face(q[0], q[1], q[2]);
            mesh.face(q[0], q[2], q[3]);
        } else {
            mesh.face(q[0], q[1], q[3]);
            mesh.face(q[1], q[2], q[3]);
        }
    }
    return mesh;
}

// One round of Catmull-Clark subdivision of a closed mesh.
inline Quads subdivided(const Quads& coarse) {
    struct EdgePoint {
        std::int32_t number = -1;
        glm::dvec3 middles{0.0};
        int faces = 0;
    };
    Quads fine;
    fine.vertex = coarse.vertex;
    std::vector<glm::dvec3> middle;
    std::map<std::pair<std::int32_t, std::int32_t>, EdgePoint> edge;
    std::vector<glm::dvec3> middles(coarse.vertex.size(), glm::dvec3(0.0)), halves = middles;
    std::vector<double> faces(coarse.vertex.size(), 0.0), edges = faces;
    for (const auto& q : coarse.face) {
        middle.push_back(0.25 * (coarse.at(q[0]) + coarse.at(q[1]) + coarse.at(q[2]) + coarse.at(q[3])));
        for (std::size_t k = 0; k < 4; ++k) {
            EdgePoint& point = edge[std::minmax(q[k], q[(k + 1) % 4])];
            point.middles += middle.back();
            ++point.faces;
            middles[static_cast<std::size_t>(q[k])] += middle.back();
            faces[static_cast<std::size_t>(q[k])] += 1.0;
        }
    }
    for (auto& [ends, point] : edge) {
        const glm::dvec3 half = 0.5 * (coarse.at(ends.first) + coarse.at(ends.second));
        for (const std::int32_t end : {ends.first, ends.second}) {
            halves[static_cast<std::size_t>(end)] += half;
            edges[static_cast<std::size_t>(end)] += 1.0;
        }
        point.number = static_cast<std::int32_t>(fine.vertex.size());
        fine.vertex.push_back(0.5 * half + 0.5 * point.middles / static_cast<double>(point.faces));
    }
    for (std::size_t v = 0; v < coarse.vertex.size(); ++v) {
        const double n = std::max(faces[v], 1.0);
        fine.vertex[v] =
            (middles[v] / n + 2.0 * halves[v] / std::max(edges[v], 1.0) + (n - 3.0) * coarse.vertex[v]) / n;
    }
    for (std::size_t f = 0; f < coarse.face.size(); ++f) {
        const auto& q = coarse.face[f];
        const auto centre = static_cast<std::int32_t>(fine.vertex.size());
        fine.vertex.push_back(middle[f]);
        for (std::size_t k = 0; k < 4; ++k)
            fine.face.push_back({q[k], edge[std::minmax(q[k], q[(k + 1) % 4])].number, centre,
                                 edge[std::minmax(q[k], q[(k + 3) % 4])].number});
    }
    return fine;
}

inline Quads subdivided(Quads mesh, int rounds) {
    for (int i = 0; i < rounds; ++i) mesh = subdivided(mesh);
    return mesh;
}

// ---- Cages of figures

// A box of unit cubes, from `low` up to but not including `high`.
struct Block {
    std::array<int, 3> low, high;
};

// Tells whether a unit cube is inside.
using Solid = std::function<bool(int, int, int)>;

inline Solid solid_of(const std::vector<Block>& blocks) {
    return [blocks](int x, int y, int z) {
        return std::any_of(blocks.begin(), blocks.end(), [&](const Block& b) {
            return x >= b.low[0] && x < b.high[0] && y >= b.low[1] && y < b.high[1] && z >= b.low[2] && z < b.high[2];
        });
    };
}

// The outer faces of the cubes inside [-most, most]^3.
inline Quads outside_of(const Solid& inside, int most) {
    Quads mesh;
    std::map<std::array<int, 3>, std::int32_t> number;
    const auto vertex = [&](const std::array<int, 3>& p) {
        const auto [at, is_new] = number.try_emplace(p, static_cast<std::int32_t>(mesh.vertex.size()));
        if (is_new) mesh.vertex.emplace_back(p[0], p[1], p[2]);
        return at->second;
    };
    for (int z = -most; z < most; ++z)
        for (int y = -most; y < most; ++y)
            for (int x = -most; x < most; ++x) {
                if (!inside(x, y, z)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (const int side : {0, 1}) {
                        std::array<int, 3> beyond{x, y, z};
                        beyond[axis] += side == 1 ? 1 : -1;
                        if (inside(beyond[0], beyond[1], beyond[2])) continue;
                        std::array<int, 3> corner{x, y, z};
                        corner[axis] += side;
                        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                        std::array<std::int32_t, 4> face{};
                        for (std::size_t k = 0; k < 4; ++k) {
                            std::array<int, 3> p = corner;
                            p[u] += k == 1 || k == 2 ? 1 : 0;
                            p[v] += k >= 2 ? 1 : 0;
                            face[side == 1 ? k : 3 - k] = vertex(p);
                        }
                        mesh.face.push_back(face);
                    }
            }
    return mesh;
}

// A body with four legs, a neck, a head with a muzzle and ears, and a tail.
inline std::vector<Block> animal() {
    return {{{-6, -3, 0}, {6, 3, 6}},  {{-6, -3, -6}, {-4, -1, 0}}, {{-6, 1, -6}, {-4, 3, 0}},
            {{4, -3, -6}, {6, -1, 0}}, {{4, 1, -6}, {6, 3, 0}},     {{4, -1, 6}, {7, 1, 9}},
            {{4, -2, 9}, {9, 2, 12}},  {{9, -1, 9}, {11, 1, 11}},   {{4, -2, 12}, {5, -1, 14}},
            {{4, 1, 12}, {5, 2, 14}},  {{-11, -1, 4}, {-6, 1, 6}}};
}

inline std::vector<Block> person() {
    return {{{-3, -2, 0}, {3, 2, 8}},   {{-3, -1, -9}, {-1, 1, 0}},   {{1, -1, -9}, {3, 1, 0}},
            {{-10, -1, 5}, {-3, 1, 7}}, {{3, -1, 5}, {10, 1, 7}},     {{-1, -1, 8}, {1, 1, 9}},
            {{-2, -2, 9}, {2, 2, 13}},  {{-3, -3, -10}, {-1, 1, -9}}, {{1, -3, -10}, {3, 1, -9}},
            {{10, -1, 5}, {12, 0, 6}},  {{-12, -1, 5}, {-10, 0, 6}}};
}

// Moves each vertex towards the mean of its neighbours, by a share of the distance.
inline void relax(Quads& mesh, double share) {
    std::vector<glm::dvec3> sum(mesh.vertex.size(), glm::dvec3(0.0));
    std::vector<double> count(mesh.vertex.size(), 0.0);
    for (const auto& q : mesh.face)
        for (std::size_t k = 0; k < 4; ++k) {
            sum[static_cast<std::size_t>(q[k])] += mesh.at(q[(k + 1) % 4]) + mesh.at(q[(k + 3) % 4]);
            count[static_cast<std::size_t>(q[k])] += 2.0;
        }
    for (std::size_t v = 0; v < mesh.vertex.size(); ++v)
        mesh.vertex[v] = (1.0 - share) * mesh.vertex[v] + share * sum[v] / count[v];
}

// Turns the outside of cubes into a cage like a modeller's: rounded, bent, and uneven.
inline Quads cage(const Solid& inside, int most, int rounding, double uneven, std::uint64_t seed) {
    Quads mesh = outside_of(inside, most);
    for (int round = 0; round < rounding; ++round) relax(mesh, 0.4);
    for (std::size_t v = 0; v < mesh.vertex.size(); ++v) {
        glm::dvec3& p = mesh.vertex[v];
        p += uneven * glm::dvec3(random(3 * v, seed), random(3 * v + 1, seed), random(3 * v + 2, seed));
        p += 0.6 * glm::dvec3(std::sin(0.31 * p.y + 0.2 * p.z), std::sin(0.27 * p.z + 1.0), std::sin(0.23 * p.x + 2.0));
        p *= 1.0 + 0.08 * std::sin(0.4 * p.x - 0.3 * p.z);
    }
    return mesh;
}

// A cage of quads around a smooth union of nine ellipsoids, each of which lies on an earlier one.
inline Quads blob(std::uint64_t seed) {
    std::vector<glm::dvec3> centre{glm::dvec3(0.0)}, radius{glm::dvec3(6.0, 5.0, 5.0)};
    for (std::uint64_t k = 1; k < 9; ++k) {
        const std::size_t on =
            k < 4 ? 0 : static_cast<std::size_t>((random(k, seed) + 1.0) / 2.0 * static_cast<double>(k));
        const auto three = [&](std::uint64_t stream) {
            return glm::dvec3(random(10 * k, stream), random(10 * k + 1, stream), random(10 * k + 2, stream));
        };
        centre.push_back(centre[on] + glm::normalize(three(seed + 100)) * radius[on]);
        radius.push_back(glm::max(radius[on] * (0.55 + 0.25 * three(seed + 200)), glm::dvec3(1.2)));
    }
    const auto field = [&](const glm::dvec3& p) {
        double sum = 0.0;
        for (std::size_t k = 0; k < centre.size(); ++k)
            sum += std::exp(-8.0 * (glm::length((p - centre[k]) / radius[k]) - 1.0));
        return -std::log(sum) / 8.0;
    };
    Quads mesh = outside_of([&](int x, int y, int z) { return field(glm::dvec3(x, y, z) + 0.5) < 0.0; }, 24);
    for (glm::dvec3& p : mesh.vertex)
        for (int step = 0; step < 3; ++step) {
            constexpr double h = 1e-4;
            glm::dvec3 gradient(0.0);
            for (int c = 0; c < 3; ++c) {
                glm::dvec3 off(0.0);
                off[c] = h;
                gradient[c] = (field(p + off) - field(p - off)) / (2.0 * h);
            }
            p -= 0.7 * field(p) / glm::dot(gradient, gradient) * gradient;
        }
    relax(mesh, 0.3);
    return mesh;
}

// ---- Grids

// A grid of places p(u, v) for u and v in [0, 1]. It may be closed in either direction: equal places are welded when
// the mesh is made.
template <class Place>
Quads grid(int columns, int rows, Place&& place) {
    Quads mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            mesh.vertex.push_back(place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i;
            mesh.face.push_back({a, a + 1, a + columns + 2, a + columns + 1});
        }
    return mesh;
}

// A surface of revolution about the z axis. The profile gives radius and height for v, from the lowest point to the
// highest. Both ends may be on the axis.
template <class Profile>
Quads turned(int columns, int rows, Profile&& profile) {
    return grid(columns, rows, [&](double u, double v) {
        const glm::dvec2 p = profile(v);
        const double angle = u < 1.0 ? 2.0 * pi * u : 0.0; // The last column is the first, to the bit.
        return glm::dvec3(p.x * std::cos(angle), p.x * std::sin(angle), p.y);
    });
}

// A cylinder with two half spheres.
inline Quads capsule(int columns, int rows) {
    return turned(columns, rows, [](double v) {
        const double z = v < 0.3 ? -1.0 : v > 0.7 ? 1.0 : 5.0 * (v - 0.5);
        const double angle = v < 0.3 ? pi / 0.6 * v : v > 0.7 ? pi / 0.6 * (v - 0.4) : 0.5 * pi;
        return glm::dvec2(v > 0.0 && v < 1.0 ? std::sin(angle) : 0.0, z - std::cos(angle));
    });
}

// ---- Folds

// An icosphere whose distance from the centre depends on the direction.
template <class Distance>
Triangles star(int levels, Distance&& distance) {
    Triangles mesh = icosphere(levels);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        const double by = distance(glm::dvec3(mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]), i / 3);
        for (std::size_t c = 0; c < 3; ++c) mesh.vertices[i + c] *= by;
    }
    return mesh;
}

// A cortex: narrow grooves of a given depth where a sum of waves is near 0.
inline Triangles folded(int levels, double depth, double width, double waves) {
    return star(levels, [&](const glm::dvec3& d, std::size_t) {
        const double sum = std::sin(waves * d.x + 2.0 * std::sin(0.6 * waves * d.y)) +
                           std::sin(waves * d.y + 2.0 * std::sin(0.6 * waves * d.z)) +
                           std::sin(waves * d.z + 2.0 * std::sin(0.6 * waves * d.x));
        return 1.0 - depth * std::exp(-sum * sum / (width * width));
    });
}

// ---- Parts of machines

// An outline in counter-clockwise order, and a point inside from which all of it can be seen.
struct Outline {
    std::vector<glm::dvec2> points;
    glm::dvec2 middle{0.0};
};

// A polygon whose corners are replaced by arcs of `segments` chords; 0: sharp corners, 1: chamfers.
inline Outline rounded(const std::vector<glm::dvec2>& corners, double radius, int segments) {
    Outline outline;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 before = glm::normalize(corners[(i + count - 1) % count] - corners[i]);
        const glm::dvec2 after = glm::normalize(corners[(i + 1) % count] - corners[i]);
        if (segments == 0) outline.points.push_back(corners[i]);
        const double half = 0.5 * std::acos(std::clamp(glm::dot(before, after), -1.0, 1.0));
        const glm::dvec2 centre = corners[i] + radius / std::sin(half) * glm::normalize(before + after);
        const glm::dvec2 from = corners[i] + radius / std::tan(half) * before - centre;
        const bool left = before.x * after.y - before.y * after.x < 0.0;
        const double turn = (left ? 1.0 : -1.0) * (pi - 2.0 * half);
        for (int k = 0; segments > 0 && k <= segments; ++k) {
            const double a = turn * k / segments;
            outline.points.push_back(centre + glm::dvec2(from.x * std::cos(a) - from.y * std::sin(a),
                                                         from.x * std::sin(a) + from.y * std::cos(a)));
        }
    }
    return outline;
}

// A prism over an outline: the walls are long quads, the ends are triangles around the middle.
inline Triangles prism(const Outline& outline, double height, int storeys = 1) {
    Triangles mesh;
    const auto count = static_cast<std::int32_t>(outline.points.size());
    for (int j = 0; j <= storeys; ++j)
        for (const glm::dvec2& p : outline.points) static_cast<void>(mesh.add(p.x, p.y, height * j / storeys));
    const std::int32_t low = mesh.add(outline.middle.x, outline.middle.y, 0.0);
    const std::int32_t high = mesh.add(outline.middle.x, outline.middle.y, height);
    for (std::int32_t a = 0; a < count; ++a) {
        const std::int32_t b = (a + 1) % count;
        for (std::int32_t j = 0; j < storeys; ++j) {
            mesh.face(j * count + a, j * count + b, (j + 1) * count + b);
            mesh.face(j * count + a, (j + 1) * count + b, (j + 1) * count + a);
        }
        mesh.face(b, a, low);
        mesh.face(storeys * count + a, storeys * count + b, high);
    }
    return mesh;
}

inline std::vector<glm::dvec2> rectangle(double x, double y) { return {{-x, -y}, {x, -y}, {x, y}, {-x, y}}; }

// Divides each triangle into four in its own plane. Edges are cut in the middle, or at 0.3 to 0.7 of their length if
// `uneven`.
inline Triangles finer(const Triangles& coarse, int rounds, bool uneven = false) {
    Triangles mesh = coarse;
    for (int round = 0; round < rounds; ++round) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> cuts;
        const auto between = [&](std::int32_t a, std::int32_t b) {
            const auto [at, is_new] =
                cuts.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.vertices.size() / 3));
            if (is_new) {
                const auto i = 3 * static_cast<std::size_t>(std::min(a, b)),
                           j = 3 * static_cast<std::size_t>(std::max(a, b));
                const double t = uneven ? 0.5 + 0.2 * random(static_cast<std::uint64_t>(at->second), 9) : 0.5;
                const auto mix = [&](std::size_t c) {
                    return (1.0 - t) * mesh.vertices[i + c] + t * mesh.vertices[j + c];
                };
                static_cast<void>(mesh.add(mix(0), mix(1), mix(2)));
            }
            return at->second;
        };
        std::vector<std::int32_t> before;
        before.swap(mesh.triangles);
        for (std::size_t i = 0; i < before.size(); i += 3) {
            const std::int32_t a = before[i], b = before[i + 1], c = before[i + 2];
            const std::int32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
            mesh.face(a, ab, ca);
            mesh.face(ab, b, bc);
            mesh.face(ca, bc, c);
            mesh.face(ab, bc, ca);
        }
    }
    return mesh;
}

} // namespace hrbfnpr::test::verdict
