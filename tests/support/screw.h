// SPDX-License-Identifier: MIT
// A screw: a shaft with a thread of several turns, flat at both ends.
#pragma once

#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace hrbfnpr::test {

// The profile of a thread along one turn: its height, 0 to 1.
struct ThreadProfile {
    // Shares of a turn: flat at the root, rising, flat at the crest; the rest is falling. Triangular profiles have no
    // flat part.
    double root, rise, crest;
    [[nodiscard]] double at(double share) const {
        if (share < root) return 0.0;
        if (share < root + rise) return (share - root) / rise;
        if (share < root + rise + crest) return 1.0;
        return (1.0 - share) / (1.0 - root - rise - crest);
    }
    // Returns the shares at which the profile bends.
    [[nodiscard]] std::vector<double> corners() const {
        std::vector<double> at{0.0};
        for (const double c : {root, root + rise, root + rise + crest})
            if (c > at.back() + 1e-9) at.push_back(c);
        return at;
    }
};
inline constexpr ThreadProfile triangular{0.0, 0.5, 0.0};
inline constexpr ThreadProfile trapezoidal{0.15, 0.35, 0.15};

// A thread about the z axis with inner radius 0.8, outer radius 1 and a pitch of 0.4. Its turns are side by side, and
// it is cut off flat at z = 0 and at the top. Below it is a shaft of radius 0.65.
class Screw {
public:
    // segments: around the axis; cuts: for each straight part of the profile.
    Screw(int turns, const ThreadProfile& profile, int segments, int cuts)
        : profile_(profile), segments_(segments), height_(pitch * turns) {
        cut_shares(cuts);
        const auto lines = static_cast<int>(shares_.size());
        for (int j = -lines; j < turns * lines; ++j)
            for (int k = 0; k < segments; ++k) {
                add({point(k, j), point(k + 1, j), point(k + 1, j + 1)});
                add({point(k, j), point(k + 1, j + 1), point(k, j + 1)});
            }
        close(height_, {}, 0.0);
        close(0.0, {0.65, 0.65}, -0.5);
    }
    Triangles mesh;

private:
    static constexpr double turn = 6.283185307179586;
    static constexpr double pitch = 0.4;
    // A point on the unrolled cylinder: `along` in segments about the axis, and z upward.
    struct Point {
        double along, z;
    };

    void cut_shares(int cuts) {
        const std::vector<double> corners = profile_.corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const double to = i + 1 < corners.size() ? corners[i + 1] : 1.0;
            for (int k = 0; k < cuts; ++k) shares_.push_back(corners[i] + (to - corners[i]) * k / cuts);
        }
    }
    [[nodiscard]] Point point(int k, int j) const {
        const auto lines = static_cast<int>(shares_.size());
        const int whole = j >= 0 ? j / lines : -((lines - 1 - j) / lines);
        const double share = shares_[static_cast<std::size_t>(j - whole * lines)];
        return {static_cast<double>(k), pitch * (whole + share + static_cast<double>(k) / segments_)};
    }
    [[nodiscard]] std::int32_t vertex(const Point& p) {
        const double along = std::fmod(p.along, segments_);
        const std::array<long, 2> key{std::lround(1e6 * along) % std::lround(1e6 * segments_), std::lround(1e7 * p.z)};
        const auto [found, added] = known_.try_emplace(key, 0);
        if (added) {
            const double t = p.z / pitch - p.along / segments_;
            const double r = 0.8 + 0.2 * profile_.at(t - std::floor(t + 1e-9));
            const double angle = turn * along / segments_;
            found->second = mesh.add(r * std::cos(angle), r * std::sin(angle), p.z);
        }
        return found->second;
    }
    // Adds the part of a triangle between the ends.
    void add(std::vector<Point> corner) {
        for (const double side : {1.0, -1.0}) {
            const auto off = [&](const Point& p) { return side > 0.0 ? p.z : height_ - p.z; };
            std::vector<Point> kept;
            for (std::size_t i = 0; i < corner.size(); ++i) {
                const Point& a = corner[i];
                const Point& b = corner[(i + 1) % corner.size()];
                if (off(a) > -1e-9) kept.push_back(a);
                if ((off(a) > 1e-9 && off(b) < -1e-9) || (off(a) < -1e-9 && off(b) > 1e-9)) {
                    const double t = off(a) / (off(a) - off(b));
                    kept.push_back({a.along + t * (b.along - a.along), side > 0.0 ? 0.0 : height_});
                }
            }
            corner = kept;
        }
        for (std::size_t i = 2; i < corner.size(); ++i) {
            const std::int32_t a = vertex(corner[0]);
            const std::int32_t b = vertex(corner[i - 1]);
            const std::int32_t c = vertex(corner[i]);
            if (a != b && b != c && c != a) mesh.face(a, b, c);
        }
    }
    // Closes the end at a height: rings of these radii inward, a shaft down to `bottom`, and a lid.
    void close(double z, const std::vector<double>& radii, double bottom) {
        std::vector<std::pair<double, std::int32_t>> rim;
        for (const auto& [key, v] : known_)
            if (key[1] == std::lround(1e7 * z))
                rim.push_back({turn * 1e-6 * static_cast<double>(key[0]) / segments_, v});
        std::sort(rim.begin(), rim.end());
        std::vector<std::int32_t> ring;
        for (const auto& [angle, v] : rim) ring.push_back(v);
        const auto join = [&](double radius, double to) {
            std::vector<std::int32_t> next;
            for (const auto& [angle, v] : rim)
                next.push_back(mesh.add(radius * std::cos(angle), radius * std::sin(angle), to));
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::size_t n = (i + 1) % ring.size();
                quad(ring[i], ring[n], next[n], next[i], z > 0.0);
            }
            ring = next;
        };
        const bool shaft = !radii.empty();
        const double end = shaft ? bottom : z;
        if (shaft) {
            join(radii[0], z);
            for (int k = 1; k <= 6; ++k) join(radii[1], z + (bottom - z) * k / 6);
        }
        for (const double r : {0.5, 0.3, 0.12}) join(r, end);
        const std::int32_t middle = mesh.add(0.0, 0.0, end);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::size_t n = (i + 1) % ring.size();
            z > 0.0 ? mesh.face(ring[i], ring[n], middle) : mesh.face(ring[n], ring[i], middle);
        }
    }
    void quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, bool up) {
        up ? mesh.face(a, b, c) : mesh.face(b, a, c);
        up ? mesh.face(a, c, d) : mesh.face(a, d, c);
    }

    const ThreadProfile& profile_;
    const int segments_;
    const double height_;
    std::vector<double> shares_;
    std::map<std::array<long, 2>, std::int32_t> known_;
};

inline Triangles screw(int turns, const ThreadProfile& profile, int segments, int cuts) {
    return std::move(Screw(turns, profile, segments, cuts).mesh);
}

} // namespace hrbfnpr::test
