// SPDX-License-Identifier: MIT
// Meshes for edges_verdict.h beyond those that tests share: scans, decimated and noisy meshes, machine parts.
#pragma once

#include "support/verdict_shapes.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace hrbfnpr::test::verdict {

// A simpler version of animal(), whose limbs have four sides.
inline std::vector<Block> simple_animal() {
    return {{{-3, -1, 0}, {3, 2, 3}}, {{-3, -1, -3}, {-2, 0, 0}}, {{-3, 1, -3}, {-2, 2, 0}}, {{2, -1, -3}, {3, 0, 0}},
            {{2, 1, -3}, {3, 2, 0}},  {{2, 0, 3}, {3, 1, 5}},     {{2, 0, 5}, {5, 1, 6}},    {{-6, 0, 2}, {-3, 1, 3}}};
}

inline std::vector<Block> bust() {
    return {{{-6, -3, 0}, {6, 3, 4}},  {{-2, -2, 4}, {2, 2, 6}},   {{-3, -3, 6}, {3, 3, 12}},
            {{-1, -5, 8}, {1, -3, 9}}, {{-4, -1, 8}, {-3, 1, 10}}, {{3, -1, 8}, {4, 1, 10}}};
}

// A frame of bars with `holes` by `holes` holes.
inline Solid frame(int holes) {
    return [holes](int x, int y, int z) {
        const int most = 2 * holes + 1;
        return z >= 0 && z < 1 && x >= 0 && y >= 0 && x < most && y < most && (x % 2 == 0 || y % 2 == 0);
    };
}

inline Quads sphere(int columns, int rows) {
    return turned(columns, rows,
                  [](double v) { return glm::dvec2(v > 0.0 && v < 1.0 ? std::sin(pi * v) : 0.0, -std::cos(pi * v)); });
}

inline Quads torus(int columns, int rows, double tube) {
    return grid(columns, rows, [&](double u, double v) {
        const double a = u < 1.0 ? 2.0 * pi * u : 0.0, b = v < 1.0 ? 2.0 * pi * v : 0.0;
        const double r = 1.0 + tube * std::cos(b);
        return glm::dvec3(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
    });
}

// `waves` waves per unit length in two directions, with the amplitude `height`.
inline Quads waves(int n, int waves, double height) {
    return grid(n, n, [&](double u, double v) {
        return glm::dvec3(u, v, height * std::sin(2.0 * pi * waves * u) * std::sin(2.0 * pi * waves * v + 0.7));
    });
}

using Field = std::function<double(const glm::dvec3&)>;

// Triangulates the zero level of a field, negative inside, in [-1, 1]^3, by six tetrahedra per cube. Vertices are
// displaced by up to `noise` cells.
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
            const double t = std::clamp(va / (va - vb), 0.05, 0.95); // scans have no needle triangles
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

// A union of rods with round ends, with smooth transitions.
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

// Merges all vertices in each cell into one, as simple decimation does.
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

// A scanned head with a nose, a chin, sockets and ears, with errors of up to `noise` along each ray.
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

// An angle bracket whose inner corner is round.
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

// A box of 2 by 1.4 by 1 with rounded edges; with 1 chord, chamfered ones.
inline Triangles round_box(double radius, int chords) {
    const glm::dvec3 core = glm::dvec3(1.0, 0.7, 0.5) - radius;
    Quads all;
    std::vector<double> steps; // units of the core from the middle, and angles beyond it
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
    for (glm::dvec3& p : all.vertex) p = glm::round(p * 1e9) * 1e-9; // weld seams
    return cut(all, Cut::first);
}

// A cube with flat chamfers and flat corners.
inline Triangles chamfered_cube(double chamfer) {
    Triangles mesh;
    const auto at = [&](int axis, int corner) { // the vertex of a cube corner on the face across an axis
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

// The intersection of two cylinders of radius 1 that cross at right angles.
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

// An open sheet with two folds at right angles.
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

// Rounds coordinates, as a text file with few digits does.
inline Triangles as_text(Triangles mesh, double digit = 1e-6) {
    for (double& x : mesh.vertices) x = std::round(x / digit) * digit;
    return mesh;
}

// Moves every coordinate by up to `off`.
inline Triangles rough(Triangles mesh, double off) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.vertices[i] += off * random(i, 11);
    return mesh;
}

// Moves the vertices of round walls about the z axis and along it, but not those on edges. Afterwards the vertices are
// no longer in rows.
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
