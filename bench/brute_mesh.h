// SPDX-License-Identifier: MIT
// Distances to a mesh and whether places are inside it, by a loop over all faces: the reference for signs of models.
#pragma once

#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench {

class BruteMesh {
public:
    using Point = std::array<double, 3>;

    explicit BruteMesh(const hrbfnpr::test::Triangles& mesh) {
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            Face face;
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    face[k][c] = mesh.vertices[3 * static_cast<std::size_t>(mesh.triangles[i + k]) + c];
            faces_.push_back(face);
        }
    }

    // Sums the solid angles of all faces (van Oosterom and Strackee, "The solid angle of a plane triangle", 1983).
    [[nodiscard]] bool inside(const Point& p) const {
        double angle = 0.0;
        for (const Face& face : faces_) {
            const Point a = less(face[0], p), b = less(face[1], p), c = less(face[2], p);
            const double x = length(a), y = length(b), z = length(c);
            angle += 2.0 * std::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
        }
        return angle > 6.283185307179586;
    }

    [[nodiscard]] double distance(const Point& p) const {
        double least = 1e300;
        for (const Face& face : faces_) least = std::min(least, distance(p, face));
        return least;
    }

    [[nodiscard]] static Point less(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
    [[nodiscard]] static double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
    [[nodiscard]] static Point cross(const Point& a, const Point& b) {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    [[nodiscard]] static double length(const Point& a) { return std::sqrt(dot(a, a)); }
    [[nodiscard]] static double distance(const Point& p, const std::array<Point, 3>& f) {
        const Point n = cross(less(f[1], f[0]), less(f[2], f[0]));
        bool over = dot(n, n) > 0.0;
        double least = 1e300;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point e = less(f[(k + 1) % 3], f[k]), v = less(p, f[k]);
            over = over && dot(cross(e, v), n) >= 0.0;
            const double t = std::clamp(dot(v, e) / std::max(dot(e, e), 1e-300), 0.0, 1.0);
            least = std::min(least, length({v[0] - t * e[0], v[1] - t * e[1], v[2] - t * e[2]}));
        }
        return over ? std::abs(dot(less(p, f[0]), n)) / length(n) : least;
    }

private:
    using Face = std::array<Point, 3>;
    std::vector<Face> faces_;
};

} // namespace bench
