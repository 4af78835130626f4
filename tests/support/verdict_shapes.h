// SPDX-License-Identifier: MIT
// Meshes of which it is known whether they stand for shapes with edges: cages of quads that are subdivided and cut in
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
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace hrbfnpr::test::verdict {

inline constexpr double pi = std::numbers::pi;

// A number in [-1, 1] that depends on nothing but its arguments.
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

// One round of Catmull and Clark, of a closed mesh.
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

// A box of unit cubes, from `low` to before `high`.
struct Block {
    std::array<int, 3> low, high;
};

// Tells of a place in cubes whether it is inside.
using Solid = std::function<bool(int, int, int)>;

inline Solid solid_of(const std::vector<Block>& blocks) {
    return [blocks](int x, int y, int z) {
        return std::any_of(blocks.begin(), blocks.end(), [&](const Block& b) {
            return x >= b.low[0] && x < b.high[0] && y >= b.low[1] && y < b.high[1] && z >= b.low[2] && z < b.high[2];
        });
    };
}

// The faces of the cubes inside [-most, most]^3 that are seen from outside.
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

// Four legs, a neck, a head with a muzzle and ears, and a tail.
inline std::vector<Block> animal() {
    return {{{-6, -3, 0}, {6, 3, 6}},  {{-6, -3, -6}, {-4, -1, 0}}, {{-6, 1, -6}, {-4, 3, 0}},
            {{4, -3, -6}, {6, -1, 0}}, {{4, 1, -6}, {6, 3, 0}},     {{4, -1, 6}, {7, 1, 9}},
            {{4, -2, 9}, {9, 2, 12}},  {{9, -1, 9}, {11, 1, 11}},   {{4, -2, 12}, {5, -1, 14}},
            {{4, 1, 12}, {5, 2, 14}},  {{-11, -1, 4}, {-6, 1, 6}}};
}

// The same with limbs of four sides.
inline std::vector<Block> simple_animal() {
    return {{{-3, -1, 0}, {3, 2, 3}}, {{-3, -1, -3}, {-2, 0, 0}}, {{-3, 1, -3}, {-2, 2, 0}}, {{2, -1, -3}, {3, 0, 0}},
            {{2, 1, -3}, {3, 2, 0}},  {{2, 0, 3}, {3, 1, 5}},     {{2, 0, 5}, {5, 1, 6}},    {{-6, 0, 2}, {-3, 1, 3}}};
}

inline std::vector<Block> bust() {
    return {{{-6, -3, 0}, {6, 3, 4}},  {{-2, -2, 4}, {2, 2, 6}},   {{-3, -3, 6}, {3, 3, 12}},
            {{-1, -5, 8}, {1, -3, 9}}, {{-4, -1, 8}, {-3, 1, 10}}, {{3, -1, 8}, {4, 1, 10}}};
}

inline std::vector<Block> person() {
    return {{{-3, -2, 0}, {3, 2, 8}},   {{-3, -1, -9}, {-1, 1, 0}},   {{1, -1, -9}, {3, 1, 0}},
            {{-10, -1, 5}, {-3, 1, 7}}, {{3, -1, 5}, {10, 1, 7}},     {{-1, -1, 8}, {1, 1, 9}},
            {{-2, -2, 9}, {2, 2, 13}},  {{-3, -3, -10}, {-1, 1, -9}}, {{1, -3, -10}, {3, 1, -9}},
            {{10, -1, 5}, {12, 0, 6}},  {{-12, -1, 5}, {-10, 0, 6}}};
}

// A frame of bars with `holes` by `holes` holes.
inline Solid frame(int holes) {
    return [holes](int x, int y, int z) {
        const int most = 2 * holes + 1;
        return z >= 0 && z < 1 && x >= 0 && y >= 0 && x < most && y < most && (x % 2 == 0 || y % 2 == 0);
    };
}

// Turns the outside of cubes into a cage as somebody models it: rounded off, bent, and uneven.
inline Quads cage(const Solid& inside, int most, int rounding, double uneven, std::uint64_t seed) {
    Quads mesh = outside_of(inside, most);
    for (int round = 0; round < rounding; ++round) {
        std::vector<glm::dvec3> sum(mesh.vertex.size(), glm::dvec3(0.0));
        std::vector<double> count(mesh.vertex.size(), 0.0);
        for (const auto& q : mesh.face)
            for (std::size_t k = 0; k < 4; ++k) {
                sum[static_cast<std::size_t>(q[k])] += mesh.at(q[(k + 1) % 4]) + mesh.at(q[(k + 3) % 4]);
                count[static_cast<std::size_t>(q[k])] += 2.0;
            }
        for (std::size_t v = 0; v < mesh.vertex.size(); ++v)
            mesh.vertex[v] = 0.6 * mesh.vertex[v] + 0.4 * sum[v] / count[v];
    }
    for (std::size_t v = 0; v < mesh.vertex.size(); ++v) {
        glm::dvec3& p = mesh.vertex[v];
        p += uneven * glm::dvec3(random(3 * v, seed), random(3 * v + 1, seed), random(3 * v + 2, seed));
        p += 0.6 * glm::dvec3(std::sin(0.31 * p.y + 0.2 * p.z), std::sin(0.27 * p.z + 1.0), std::sin(0.23 * p.x + 2.0));
        p *= 1.0 + 0.08 * std::sin(0.4 * p.x - 0.3 * p.z);
    }
    return mesh;
}

// ---- Grids

// Places p(u, v) for u and v in [0, 1], that may be closed in either direction. Places that are the same are welded
// when the mesh is made.
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

// About the z axis: radius and height by v, from the lowest point to the highest. Both ends may lie on the axis.
template <class Profile>
Quads turned(int columns, int rows, Profile&& profile) {
    return grid(columns, rows, [&](double u, double v) {
        const glm::dvec2 p = profile(v);
        const double angle = u < 1.0 ? 2.0 * pi * u : 0.0; // The last column is the first, to the bit.
        return glm::dvec3(p.x * std::cos(angle), p.x * std::sin(angle), p.y);
    });
}

inline Quads sphere(int columns, int rows) {
    return turned(columns, rows,
                  [](double v) { return glm::dvec2(v > 0.0 && v < 1.0 ? std::sin(pi * v) : 0.0, -std::cos(pi * v)); });
}

// Two half spheres on a cylinder.
inline Quads capsule(int columns, int rows) {
    return turned(columns, rows, [](double v) {
        const double z = v < 0.3 ? -1.0 : v > 0.7 ? 1.0 : 5.0 * (v - 0.5);
        const double angle = v < 0.3 ? pi / 0.6 * v : v > 0.7 ? pi / 0.6 * (v - 0.4) : 0.5 * pi;
        return glm::dvec2(v > 0.0 && v < 1.0 ? std::sin(angle) : 0.0, z - std::cos(angle));
    });
}

inline Quads torus(int columns, int rows, double tube) {
    return grid(columns, rows, [&](double u, double v) {
        const double a = u < 1.0 ? 2.0 * pi * u : 0.0, b = v < 1.0 ? 2.0 * pi * v : 0.0;
        const double r = 1.0 + tube * std::cos(b);
        return glm::dvec3(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
    });
}

// Waves in two directions that rise by `height` over a length of 1 / `waves`.
inline Quads waves(int n, int waves, double height) {
    return grid(n, n, [&](double u, double v) {
        return glm::dvec3(u, v, height * std::sin(2.0 * pi * waves * u) * std::sin(2.0 * pi * waves * v + 0.7));
    });
}

// ---- Scans

using Field = std::function<double(const glm::dvec3&)>;

// The surface where a field is 0, negative inside, in [-1, 1]^3: six tetrahedra a cube. Vertices are off along the
// edges of the grid by up to `noise` of its cells.
inline Triangles scan(const Field& field, int cells, double noise) {
    Triangles mesh;
    const auto place = [&](const std::array<int, 3>& i) {
        return glm::dvec3(2.0 * i[0] / cells - 1.0, 2.0 * i[1] / cells - 1.0, 2.0 * i[2] / cells - 1.0);
    };
    const auto key_of = [&](const std::array<int, 3>& i) { return (i[2] * (cells + 1) + i[1]) * (cells + 1) + i[0]; };
    std::vector<double> value;
    for (int z = 0; z <= cells; ++z)
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x) value.push_back(field(place({x, y, z})));
    std::map<std::pair<int, int>, std::int32_t> number;
    const auto crossing = [&](const std::array<int, 3>& a, const std::array<int, 3>& b) {
        const std::pair<int, int> key = std::minmax({key_of(a), key_of(b)});
        const auto [at, is_new] = number.try_emplace(key, static_cast<std::int32_t>(mesh.vertices.size() / 3));
        if (is_new) {
            const double va = value[static_cast<std::size_t>(key_of(a))],
                         vb = value[static_cast<std::size_t>(key_of(b))];
            const double t = std::clamp(va / (va - vb), 0.05, 0.95); // Scans have no needles.
            glm::dvec3 p = place(a) + t * (place(b) - place(a));
            const auto salt = static_cast<std::uint64_t>(key.first) * 7919U + static_cast<std::uint64_t>(key.second);
            for (int c = 0; c < 3; ++c) p[c] += noise * 2.0 / cells * random(salt, static_cast<std::uint64_t>(c));
            static_cast<void>(mesh.add(p.x, p.y, p.z));
        }
        return at->second;
    };
    const auto face = [&](std::int32_t a, std::int32_t b, std::int32_t c, const glm::dvec3& outward) {
        const auto p = [&](std::int32_t i) {
            const double* const v = mesh.vertices.data() + 3 * i;
            return glm::dvec3(v[0], v[1], v[2]);
        };
        if (glm::dot(glm::cross(p(b) - p(a), p(c) - p(a)), outward) < 0.0) std::swap(b, c);
        mesh.face(a, b, c);
    };
    constexpr std::array<std::array<std::size_t, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                for (const auto& order : orders) {
                    std::array<std::array<int, 3>, 4> corner{};
                    corner[0] = {x, y, z};
                    for (std::size_t k = 0; k < 3; ++k) {
                        corner[k + 1] = corner[k];
                        ++corner[k + 1][order[k]];
                    }
                    std::vector<std::array<int, 3>> in, out;
                    for (const auto& c : corner)
                        (value[static_cast<std::size_t>(key_of(c))] < 0.0 ? in : out).push_back(c);
                    if (in.empty() || out.empty()) continue;
                    glm::dvec3 outward(0.0);
                    for (const auto& c : out) outward += place(c) / static_cast<double>(out.size());
                    for (const auto& c : in) outward -= place(c) / static_cast<double>(in.size());
                    if (in.size() == 2) {
                        const std::int32_t a = crossing(in[0], out[0]), b = crossing(in[0], out[1]);
                        const std::int32_t c = crossing(in[1], out[1]), d = crossing(in[1], out[0]);
                        face(a, b, c, outward);
                        face(a, c, d, outward);
                    } else {
                        const auto& one = in.size() == 1 ? in : out;
                        const auto& three = in.size() == 1 ? out : in;
                        face(crossing(one[0], three[0]), crossing(one[0], three[1]), crossing(one[0], three[2]),
                             outward);
                    }
                }
    return mesh;
}

// The union of balls and of rods of two ends, with round transitions.
inline Field soft_body() {
    struct Rod {
        glm::dvec3 from, to;
        double radius;
    };
    const std::vector<Rod> rods{
        {{-0.4, 0.0, 0.0}, {0.35, 0.05, 0.05}, 0.22},   {{-0.4, -0.12, -0.1}, {-0.45, -0.15, -0.6}, 0.08},
        {{-0.4, 0.12, -0.1}, {-0.4, 0.17, -0.6}, 0.08}, {{0.3, -0.12, -0.1}, {0.33, -0.17, -0.6}, 0.07},
        {{0.3, 0.15, -0.1}, {0.3, 0.17, -0.6}, 0.08},   {{0.35, 0.0, 0.1}, {0.55, 0.0, 0.45}, 0.12},
        {{0.55, 0.0, 0.5}, {0.75, 0.0, 0.42}, 0.13},    {{0.5, 0.1, 0.55}, {0.47, 0.14, 0.75}, 0.05},
        {{0.5, -0.1, 0.55}, {0.47, -0.14, 0.75}, 0.05}, {{-0.5, 0.0, 0.1}, {-0.85, 0.05, 0.4}, 0.06}};
    return [rods](const glm::dvec3& p) {
        double sum = 0.0;
        for (const Rod& rod : rods) {
            const glm::dvec3 along = rod.to - rod.from;
            const double t = std::clamp(glm::dot(p - rod.from, along) / glm::dot(along, along), 0.0, 1.0);
            sum += std::exp(-(glm::distance(p, rod.from + t * along) - rod.radius) / 0.03);
        }
        return -std::log(std::max(sum, 1e-300));
    };
}

// One vertex for all that lie in one cell, as simple decimation has it.
inline Triangles clustered(const Triangles& fine, double cell) {
    std::map<std::array<long, 3>, std::vector<std::size_t>> cells;
    for (std::size_t v = 0; v < fine.vertices.size() / 3; ++v) {
        const auto of = [&](std::size_t c) { return std::lround(fine.vertices[3 * v + c] / cell); };
        cells[{of(0), of(1), of(2)}].push_back(v);
    }
    Triangles mesh;
    std::vector<std::int32_t> number(fine.vertices.size() / 3);
    for (const auto& [key, members] : cells) {
        glm::dvec3 sum(0.0);
        for (const std::size_t v : members)
            sum += glm::dvec3(fine.vertices[3 * v], fine.vertices[3 * v + 1], fine.vertices[3 * v + 2]);
        sum /= static_cast<double>(members.size());
        const std::int32_t n = mesh.add(sum.x, sum.y, sum.z);
        for (const std::size_t v : members) number[v] = n;
    }
    std::set<std::array<std::int32_t, 3>> seen;
    for (std::size_t i = 0; i < fine.triangles.size(); i += 3) {
        std::array<std::int32_t, 3> t{};
        for (std::size_t k = 0; k < 3; ++k) t[k] = number[static_cast<std::size_t>(fine.triangles[i + k])];
        std::array<std::int32_t, 3> sorted = t;
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !seen.insert(sorted).second) continue;
        mesh.face(t[0], t[1], t[2]);
    }
    return mesh;
}

// The directions of an icosphere, at distances by direction.
template <class Distance>
Triangles star(int levels, Distance&& distance) {
    Triangles mesh = icosphere(levels);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        const double by = distance(glm::dvec3(mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]), i / 3);
        for (std::size_t c = 0; c < 3; ++c) mesh.vertices[i + c] *= by;
    }
    return mesh;
}

// A cortex: narrow grooves of a depth along where a sum of waves is near 0.
inline Triangles folded(int levels, double depth, double width, double waves) {
    return star(levels, [&](const glm::dvec3& d, std::size_t) {
        const double sum = std::sin(waves * d.x + 2.0 * std::sin(0.6 * waves * d.y)) +
                           std::sin(waves * d.y + 2.0 * std::sin(0.6 * waves * d.z)) +
                           std::sin(waves * d.z + 2.0 * std::sin(0.6 * waves * d.x));
        return 1.0 - depth * std::exp(-sum * sum / (width * width));
    });
}

// A head with a nose, a chin, sockets and ears, as a scanner sees one; off by up to `noise` along each ray.
inline Triangles head(int levels, double noise) {
    return star(levels, [&](const glm::dvec3& d, std::size_t v) {
        const auto bump = [&](const glm::dvec3& at, double width) {
            const double off = glm::distance(d, glm::normalize(at)) / width;
            return std::exp(-off * off);
        };
        return 1.0 + 0.2 * d.z * d.z + 0.45 * bump({1.0, 0.0, -0.1}, 0.13) + 0.15 * bump({1.0, 0.0, -0.9}, 0.3) -
               0.12 * bump({1.0, 0.35, 0.2}, 0.15) - 0.12 * bump({1.0, -0.35, 0.2}, 0.15) +
               0.35 * bump({0.0, 1.0, 0.0}, 0.14) + 0.35 * bump({0.0, -1.0, 0.0}, 0.14) +
               0.03 * std::sin(9.0 * d.x + 4.0 * d.z) * std::sin(8.0 * d.y) + noise * random(v, 5);
    });
}

// ---- Parts of machines

// An outline in counter-clockwise order, and a point from which all of it is seen.
struct Outline {
    std::vector<glm::dvec2> points;
    glm::dvec2 middle{0.0};
};

// A polygon whose corners are cut by arcs of `segments` chords; 0: sharp corners, 1: chamfers.
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

// A prism of an outline: walls of long quads, ends of triangles around the middle.
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

// An angle iron, whose inner corner is round.
inline Triangles bracket(int segments) {
    Outline outline{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.3}}, {0.25, 0.25}};
    for (int k = 0; k <= segments; ++k) {
        const double a = -0.5 * pi - 0.5 * pi * k / segments;
        outline.points.emplace_back(0.55 + 0.25 * std::cos(a), 0.55 + 0.25 * std::sin(a));
    }
    outline.points.emplace_back(0.3, 1.5);
    outline.points.emplace_back(0.0, 1.5);
    return prism(outline, 1.0);
}

// A box, 2 by 1.4 by 1, all of whose edges are round, or chamfered: 1 chord.
inline Triangles round_box(double radius, int chords) {
    const glm::dvec3 core = glm::dvec3(1.0, 0.7, 0.5) - radius;
    Quads all;
    std::vector<double> steps; // in units of the core from the middle, and angles beyond it
    for (int k = 0; k <= chords; ++k) steps.push_back(-1.0 - 0.25 * pi * (chords - k) / std::max(chords, 1));
    std::vector<double> coordinate = steps;
    for (std::size_t k = steps.size(); k-- > 0;) coordinate.push_back(-steps[k]);
    const int n = static_cast<int>(coordinate.size()) - 1;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto first = static_cast<std::int32_t>(all.vertex.size());
            const Quads face = grid(n, n, [&](double s, double t) {
                const auto split = [&](double at, double half, double& base, double& slope) {
                    const double c = coordinate[static_cast<std::size_t>(std::lround(at * n))];
                    base = std::clamp(c, -1.0, 1.0) * half;
                    slope = std::abs(c) > 1.0 ? std::copysign(std::tan(std::abs(c) - 1.0), c) : 0.0;
                };
                glm::dvec3 base(0.0), direction(0.0);
                split(s, core[u], base[u], direction[u]);
                split(t, core[v], base[v], direction[v]);
                base[axis] = side * core[axis];
                direction[axis] = side;
                return base + radius * glm::normalize(direction);
            });
            all.vertex.insert(all.vertex.end(), face.vertex.begin(), face.vertex.end());
            for (auto q : face.face) {
                if (side < 0.0) std::swap(q[1], q[3]);
                all.face.push_back({first + q[0], first + q[1], first + q[2], first + q[3]});
            }
        }
    for (glm::dvec3& p : all.vertex) p = glm::round(p * 1e9) * 1e-9; // Seams are welded.
    return cut(all, Cut::first);
}

// A cube with flat chamfers and flat corners.
inline Triangles chamfered_cube(double chamfer) {
    Triangles mesh;
    const auto at = [&](int axis, int corner) { // the vertex of a corner of the cube that lies on the side of an axis
        std::array<double, 3> p{};
        for (int c = 0; c < 3; ++c) {
            const double sign = (corner >> c & 1) != 0 ? 1.0 : -1.0;
            p[static_cast<std::size_t>(c)] = sign * (c == axis ? 1.0 : 1.0 - chamfer);
        }
        return mesh.add(p[0], p[1], p[2]);
    };
    const auto outward = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        const auto p = [&](std::int32_t i) {
            return glm::dvec3(mesh.vertices[static_cast<std::size_t>(3 * i)],
                              mesh.vertices[static_cast<std::size_t>(3 * i + 1)],
                              mesh.vertices[static_cast<std::size_t>(3 * i + 2)]);
        };
        if (glm::dot(glm::cross(p(b) - p(a), p(c) - p(a)), p(a) + p(b) + p(c)) < 0.0) std::swap(b, c);
        mesh.face(a, b, c);
    };
    const auto quad = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
        outward(a, b, c);
        outward(a, c, d);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
        for (const int side : {0, 1 << axis})
            quad(at(axis, side), at(axis, side | u), at(axis, side | u | v), at(axis, side | v));
        const int other = (axis + 1) % 3;
        for (const int a : {0, 1 << axis})
            for (const int b : {0, u})
                quad(at(axis, a | b), at(axis, a | b | v), at(other, a | b | v), at(other, a | b));
    }
    for (int corner = 0; corner < 8; ++corner) outward(at(0, corner), at(1, corner), at(2, corner));
    return mesh;
}

// A pipe of quads that bends by a right angle, with flat ends.
inline Triangles elbow(int around, int along) {
    Quads pipe = grid(around, along, [&](double u, double v) {
        const double a = u < 1.0 ? 2.0 * pi * u : 0.0, b = 0.5 * pi * v;
        const double r = 1.0 - 0.3 * std::cos(a);
        return glm::dvec3(r * std::cos(b), r * std::sin(b), 0.3 * std::sin(a));
    });
    Triangles mesh = cut(pipe, Cut::first);
    for (const bool last : {false, true}) {
        const std::int32_t first = last ? along * (around + 1) : 0;
        const std::int32_t middle = last ? mesh.add(std::cos(0.5 * pi), 1.0, 0.0) : mesh.add(1.0, 0.0, 0.0);
        for (std::int32_t k = 0; k < around; ++k) {
            const std::int32_t a = first + k, b = first + k + 1;
            if (last)
                mesh.face(a, b, middle);
            else
                mesh.face(b, a, middle);
        }
    }
    return mesh;
}

// What two cylinders of radius 1 that cross at right angles have in common.
inline Triangles crossed_cylinders(int n) {
    Triangles mesh;
    for (int side = 0; side < 4; ++side) {
        const Quads patch = grid(n, n, [&](double u, double v) {
            const double angle = pi * (v - 0.5), reach = v > 0.0 && v < 1.0 ? std::cos(angle) : 0.0;
            const double x = (2.0 * u - 1.0) * reach, z = std::sin(angle);
            return side == 0   ? glm::dvec3(-x, reach, z)
                   : side == 1 ? glm::dvec3(x, -reach, z)
                   : side == 2 ? glm::dvec3(reach, x, z)
                               : glm::dvec3(-reach, -x, z);
        });
        mesh = mesh.with(cut(patch, Cut::first));
    }
    return mesh;
}

// A twisted blade with a sharp trailing edge and a round leading edge.
inline Triangles blade(int around, int along) {
    const auto place = [&](double u, double v) {
        const double angle = u < 1.0 ? 2.0 * pi * u : 0.0;
        const double x = 0.5 * (1.0 + std::cos(angle));
        const double y = 0.12 * std::sin(angle) * std::sqrt(std::max(1.0 - x, 0.0)) * 1.6 + 0.1 * x * (1.0 - x);
        const double twist = 0.8 * v, size = 1.0 - 0.4 * v;
        return glm::dvec3(size * ((x - 0.4) * std::cos(twist) - y * std::sin(twist)),
                          size * ((x - 0.4) * std::sin(twist) + y * std::cos(twist)), 2.5 * v);
    };
    Triangles mesh = cut(grid(around, along, place), Cut::first);
    for (const bool last : {false, true}) {
        const std::int32_t first = last ? along * (around + 1) : 0;
        for (std::int32_t k = 0; k < around / 2; ++k) { // strips from one side of the profile to the other
            const std::int32_t a = first + k, b = first + k + 1, c = first + around - k - 1, d = first + around - k;
            for (const auto& t : {std::array{a, b, c}, std::array{a, c, d}}) {
                if (t[0] == t[1] || t[1] == t[2] || (k == 0 && t == std::array{a, c, d})) continue;
                if (last)
                    mesh.face(t[0], t[1], t[2]);
                else
                    mesh.face(t[0], t[2], t[1]);
            }
        }
    }
    return mesh;
}

// A sheet that is folded at right angles twice; open.
inline Triangles folded_sheet(int n) {
    return cut(
        grid(3 * n, n,
             [&](double u, double v) {
                 const double s = 3.0 * u;
                 const double x = s < 1.0 ? s : s < 2.0 ? 1.0 : s - 1.0, z = s < 1.0 ? 0.0 : s < 2.0 ? s - 1.0 : 1.0;
                 return glm::dvec3(x, 1.5 * v, z);
             }),
        Cut::first);
}

// Each triangle in four, that lie in its plane. Edges are cut in the middle, or at 0.3 to 0.7 of them.
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

// As a file of text has it, whose digits end somewhere.
inline Triangles as_text(Triangles mesh, double digit = 1e-6) {
    for (double& x : mesh.vertices) x = std::round(x / digit) * digit;
    return mesh;
}

// Every coordinate off by up to `off`.
inline Triangles rough(Triangles mesh, double off) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.vertices[i] += off * random(i, 11);
    return mesh;
}

// Moves vertices about the z axis and along it where neither crosses an edge: those on round walls, which are nowhere
// in rows then.
inline Triangles scattered(Triangles mesh, double off) {
    std::map<std::pair<std::int32_t, std::int32_t>, glm::dvec3> normal;
    const auto at = [&](std::int32_t i) {
        const auto v = 3 * static_cast<std::size_t>(i);
        return glm::dvec3(mesh.vertices[v], mesh.vertices[v + 1], mesh.vertices[v + 2]);
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const std::array<std::int32_t, 3> t{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
        const glm::dvec3 n = glm::normalize(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
        for (std::size_t k = 0; k < 3; ++k) normal[{t[k], t[(k + 1) % 3]}] = n;
    }
    std::vector<std::uint8_t> stays(mesh.vertices.size() / 3, 0);
    for (const auto& [ends, n] : normal) {
        const auto other = normal.find({ends.second, ends.first});
        const bool bends = other == normal.end() || glm::dot(n, other->second) < 0.9;
        const bool is_wall = std::abs(n.z) < 0.1 && std::hypot(at(ends.first).x, at(ends.first).y) > 1e-9;
        for (const std::int32_t end : {ends.first, ends.second})
            if (bends || !is_wall) stays[static_cast<std::size_t>(end)] = 1;
    }
    for (std::size_t v = 0; v < stays.size(); ++v) {
        if (stays[v] != 0) continue;
        const glm::dvec3 p = at(static_cast<std::int32_t>(v));
        const double turn = off * random(2 * v, 13);
        mesh.vertices[3 * v] = p.x * std::cos(turn) - p.y * std::sin(turn);
        mesh.vertices[3 * v + 1] = p.x * std::sin(turn) + p.y * std::cos(turn);
        mesh.vertices[3 * v + 2] += off * random(2 * v + 1, 13);
    }
    return mesh;
}

} // namespace hrbfnpr::test::verdict
