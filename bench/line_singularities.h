// SPDX-License-Identifier: MIT
// Finds singular points of the field that the lines of a set follow, from their marks: around a circle in the tangent
// plane, the direction of the lines turns by half turns.  [Knoeppel et al. 2013]
#pragma once

#include "calls.h"
#include "evenness.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace bench {

struct Singularity {
    Vec3 position;
    int halves; // twice the index: 1 or -1, rarely more
};

// A field interpolated from the nearest marks.
class LineDirections {
public:
    LineDirections(const std::vector<Mark>& marks, const std::vector<Vec3>& direction, double separation)
        : marks_(marks), direction_(direction), reach_(1.5 * separation), grid_(marks, marks.size(), reach_) {}

    // Returns the mean exp(2 i angle) of the lines at p in the frame u, v of normal n; 0 if none is near.
    [[nodiscard]] std::complex<double> at(const Vec3& p, const Vec3& n, const Vec3& u, const Vec3& v) const {
        std::complex<double> sum(0.0);
        grid_.around(p, [&](std::size_t i) {
            const Vec3 way = marks_[i].position - p;
            const double far = std::sqrt(dot(way, way)) / reach_;
            const double cosine = dot(marks_[i].normal, n);
            if (far >= 1.0 || cosine < 0.2) return;
            const Vec3 d = carried(direction_[i], marks_[i].normal, n, cosine);
            const std::complex<double> z(dot(d, u), dot(d, v));
            sum += (1.0 - far) * z * z;
        });
        return sum;
    }
    // Returns the normal of the mark nearest to p among those with similar normals to n; 0 if there is none.
    [[nodiscard]] Vec3 nearest(const Vec3& p, const Vec3& n, Vec3& place) const {
        double least = reach_ * reach_;
        Vec3 normal{0.0, 0.0, 0.0};
        grid_.around(p, [&](std::size_t i) {
            const Vec3 way = marks_[i].position - p;
            if (dot(way, way) >= least || dot(marks_[i].normal, n) < 0.2) return;
            least = dot(way, way);
            normal = marks_[i].normal;
            place = marks_[i].position;
        });
        return normal;
    }

private:
    // Carries d by the shortest rotation from one normal to the other.
    [[nodiscard]] static Vec3 carried(const Vec3& d, const Vec3& from, const Vec3& to, double cosine) {
        const Vec3 axis = cross(from, to);
        const Vec3 turned = cross(axis, d);
        const double along = dot(axis, d) / (1.0 + cosine);
        Vec3 result{};
        for (std::size_t c = 0; c < 3; ++c) result[c] = cosine * d[c] + turned[c] + along * axis[c];
        return result;
    }

    const std::vector<Mark>& marks_;
    const std::vector<Vec3>& direction_;
    double reach_;
    Grid grid_;
};

// Returns twice the index of the field within a circle; 0 if a part of the circle has no lines.
[[nodiscard]] inline int winding(const LineDirections& lines, const Mark& centre, double radius) {
    constexpr int places = 24;
    const Vec3 n = centre.normal;
    const std::size_t least = std::abs(n[0]) < 0.6 ? 0 : std::abs(n[1]) < 0.6 ? 1 : 2;
    Vec3 u = cross(n, Vec3{least == 0 ? 1.0 : 0.0, least == 1 ? 1.0 : 0.0, least == 2 ? 1.0 : 0.0});
    const double size = std::sqrt(dot(u, u));
    for (double& c : u) c /= size;
    const Vec3 v = cross(n, u);
    std::complex<double> before(0.0);
    double turn = 0.0;
    for (int k = 0; k <= places; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / places;
        Vec3 p{};
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = centre.position[c] + radius * (std::cos(angle) * u[c] + std::sin(angle) * v[c]);
        Vec3 place = p;
        const Vec3 normal = lines.nearest(p, n, place);
        if (dot(normal, normal) == 0.0) return 0;
        const std::complex<double> z = lines.at(place, n, u, v);
        if (std::abs(z) == 0.0) return 0;
        if (k > 0) turn += std::arg(z / before);
        before = z;
    }
    return static_cast<int>(std::lround(turn / (2.0 * std::numbers::pi)));
}

// Tests a circle of two separations around every third mark; marks around the same singular point are merged.
[[nodiscard]] inline std::vector<Singularity> singularities(const std::vector<Mark>& marks,
                                                            const std::vector<Vec3>& direction, double separation) {
    const LineDirections lines(marks, direction, separation);
    const double radius = 2.0 * separation;
    struct Found {
        Mark mark;
        int halves;
        bool taken;
    };
    std::vector<Found> found;
    for (std::size_t i = 0; i < marks.size(); i += 3)
        if (const int halves = winding(lines, marks[i], radius); halves != 0)
            found.push_back({marks[i], halves, false});
    std::vector<Singularity> result;
    const auto belongs = [&](const Found& a, const Found& b) {
        const Vec3 way = a.mark.position - b.mark.position;
        return !b.taken && a.halves == b.halves && dot(way, way) < 4.0 * radius * radius &&
               dot(a.mark.normal, b.mark.normal) > 0.0;
    };
    for (Found& one : found) {
        if (one.taken) continue;
        Singularity all{{0.0, 0.0, 0.0}, one.halves};
        double count = 0.0;
        for (Found& other : found) {
            if (!belongs(one, other)) continue;
            for (std::size_t c = 0; c < 3; ++c) all.position[c] += other.mark.position[c];
            count += 1.0;
            if (&other != &one) other.taken = true;
        }
        one.taken = true;
        for (double& c : all.position) c /= count;
        if (count > 2.0) result.push_back(all);
    }
    return result;
}

} // namespace bench
