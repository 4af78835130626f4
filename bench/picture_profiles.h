// SPDX-License-Identifier: MIT
// Closed meshes of machine parts, tessellated as CAD programs do it: walls between loops of points, and flat caps.
#pragma once

#include "picture_mesh.h"

#include <map>
#include <numbers>

namespace bench {

// A closed polygon in the plane, without its first point again.
using Loop = std::vector<glm::dvec2>;

[[nodiscard]] inline Loop circle(double radius, int sides, const glm::dvec2& centre = glm::dvec2(0.0)) {
    Loop loop;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        loop.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return loop;
}

// Returns a rectangle about the origin whose corners are arcs of `steps` sides.
[[nodiscard]] inline Loop rounded_rectangle(const glm::dvec2& size, double radius, int steps) {
    Loop loop;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 sign(corner == 0 || corner == 3 ? 1.0 : -1.0, corner < 2 ? 1.0 : -1.0);
        for (int i = 0; i <= steps; ++i) {
            const double angle = 0.5 * std::numbers::pi * (corner + static_cast<double>(i) / steps);
            loop.push_back(sign * (0.5 * size - radius) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
    }
    return loop;
}

[[nodiscard]] inline Loop reversed(Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

namespace detail {

[[nodiscard]] inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Joins a hole to a polygon by a bridge from the hole's rightmost point to the nearest point of the polygon that it
// sees between all holes. Returns false if it sees none.
[[nodiscard]] inline bool bridge(Loop& polygon, std::vector<Loop>& holes, std::size_t which) {
    const Loop& hole = holes[which];
    const auto crosses = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
        if (a == c || a == d || b == c || b == d) return false;
        return turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
    };
    const auto start = static_cast<std::size_t>(
        std::max_element(hole.begin(), hole.end(), [](const auto& a, const auto& b) { return a.x < b.x; }) -
        hole.begin());
    std::size_t best = polygon.size();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double distance = glm::distance(polygon[i], hole[start]);
        if (best < polygon.size() && distance >= glm::distance(polygon[best], hole[start])) continue;
        bool sees = true;
        const auto passes = [&](const Loop& loop) {
            for (std::size_t k = 0; sees && k < loop.size(); ++k)
                sees = !crosses(polygon[i], hole[start], loop[k], loop[(k + 1) % loop.size()]);
        };
        passes(polygon);
        for (const Loop& other : holes) passes(other);
        const glm::dvec2& before = polygon[(i + polygon.size() - 1) % polygon.size()];
        const glm::dvec2& after = polygon[(i + 1) % polygon.size()];
        const bool convex = turn(before, polygon[i], after) >= 0.0;
        const bool left_of_before = turn(before, polygon[i], hole[start]) > 0.0;
        const bool left_of_after = turn(polygon[i], after, hole[start]) > 0.0;
        if (sees && (convex ? left_of_before && left_of_after : left_of_before || left_of_after)) best = i;
    }
    if (best == polygon.size()) return false;
    Loop joined(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    for (std::size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(start + i) % hole.size()]);
    joined.insert(joined.end(), polygon.begin() + static_cast<std::ptrdiff_t>(best), polygon.end());
    polygon = std::move(joined);
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(which));
    return true;
}

// Cuts a polygon into triangles by clipping ears, the shortest cuts first.
[[nodiscard]] inline std::vector<std::array<glm::dvec2, 3>> triangulated(Loop polygon) {
    std::vector<std::array<glm::dvec2, 3>> triangles;
    while (polygon.size() > 2) {
        const std::size_t n = polygon.size();
        std::size_t best = n;
        double shortest = 1e300;
        for (std::size_t i = 0; i < n; ++i) {
            const glm::dvec2 &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n];
            if (turn(a, b, c) <= 1e-12 || glm::distance(a, c) >= shortest) continue;
            bool empty = true;
            for (std::size_t k = 0; empty && k < n; ++k) {
                const glm::dvec2& p = polygon[k];
                if (p == a || p == b || p == c) continue;
                empty = turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0;
            }
            if (!empty) continue;
            best = i;
            shortest = glm::distance(a, c);
        }
        if (best == n) break; // the rest has no area
        triangles.push_back({polygon[(best + n - 1) % n], polygon[best], polygon[(best + 1) % n]});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace detail

// Builds one closed mesh.  Points at the same place are one vertex.  Outer loops run anticlockwise seen from above, and
// loops of holes clockwise, so that all faces look outward.
class Profiles {
public:
    // Adds the wall from a loop at one height to a loop of as many points at another.
    void wall(const Loop& from, double from_z, const Loop& to, double to_z) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::size_t next = (i + 1) % from.size();
            const std::array<std::int32_t, 4> corner = {vertex(from[i], from_z), vertex(from[next], from_z),
                                                        vertex(to[next], to_z), vertex(to[i], to_z)};
            face(corner[0], corner[1], corner[2]);
            face(corner[0], corner[2], corner[3]);
        }
    }
    // Adds walls through circles of (radius, height) pairs, each with `sides` sides.
    void turned(const std::vector<glm::dvec2>& profile, int sides, const glm::dvec2& centre = glm::dvec2(0.0),
                bool is_hole = false) {
        const auto ring = [&](double radius) {
            const Loop loop = circle(radius, sides, centre);
            return is_hole ? reversed(loop) : loop;
        };
        for (std::size_t i = 0; i + 1 < profile.size(); ++i)
            wall(ring(profile[i].x), profile[i].y, ring(profile[i + 1].x), profile[i + 1].y);
    }
    void cap(const Loop& outer, std::vector<Loop> holes, double z, bool is_top) {
        Loop polygon = outer;
        while (!holes.empty()) {
            bool found = false;
            for (std::size_t which = 0; which < holes.size() && !found; ++which)
                found = detail::bridge(polygon, holes, which);
            if (!found) throw std::runtime_error("a hole of a cap cannot be bridged");
        }
        for (const auto& t : detail::triangulated(polygon)) {
            const std::int32_t a = vertex(t[0], z), b = vertex(t[1], z), c = vertex(t[2], z);
            if (is_top)
                face(a, b, c);
            else
                face(a, c, b);
        }
    }
    [[nodiscard]] PictureMesh take() { return std::move(mesh_); }

private:
    [[nodiscard]] std::int32_t vertex(const glm::dvec2& p, double z) {
        const auto [found, is_new] = known_.try_emplace({p.x, p.y, z}, static_cast<std::int32_t>(mesh_.points.size()));
        if (is_new) mesh_.points.emplace_back(p, z);
        return found->second;
    }
    void face(std::int32_t a, std::int32_t b, std::int32_t c) {
        if (a != b && b != c && c != a) mesh_.faces.push_back({a, b, c});
    }

    std::map<std::array<double, 3>, std::int32_t> known_;
    PictureMesh mesh_;
};

} // namespace bench
