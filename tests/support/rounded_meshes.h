// SPDX-License-Identifier: MIT
// Meshes of parts whose edges are rounded by fillets.
#pragma once

#include "support/meshes.h"

#include <cmath>
#include <vector>

namespace hrbfnpr::test {

// Joins two rows of vertices by quadrilaterals, each cut along one diagonal or the other.
inline void join_rows(Triangles& mesh, const std::vector<std::int32_t>& low, const std::vector<std::int32_t>& high,
                      bool other_diagonal) {
    for (std::size_t k = 0; k < low.size(); ++k) {
        const std::size_t next = (k + 1) % low.size();
        const std::int32_t a = low[k], b = low[next], c = high[next], d = high[k];
        const auto add = [&](std::int32_t p, std::int32_t q, std::int32_t r) {
            if (p != q && q != r && r != p) mesh.face(p, q, r);
        };
        add(a, b, other_diagonal ? d : c);
        add(other_diagonal ? b : a, c, d);
    }
}

// The box with the half sides x, y, z, whose edges and corners are rounded by a radius. A quarter circle has `parts`
// chords.
inline Triangles rounded_box(double x, double y, double z, double radius, int parts, bool other_diagonal = false) {
    constexpr double quarter = 1.5707963267948966;
    Triangles mesh;
    std::vector<std::vector<std::int32_t>> rows;
    for (const bool above : {false, true})
        for (int j = 0; j <= parts; ++j) {
            const double height = above ? quarter * j / parts : quarter * j / parts - quarter;
            const bool is_pole = above ? j == parts : j == 0;
            rows.emplace_back();
            for (int side = 0; side < 4; ++side)
                for (int i = 0; i <= parts; ++i) {
                    const double around = quarter * (side + static_cast<double>(i) / parts);
                    const double out = is_pole ? 0.0 : radius * std::cos(height);
                    const double sign_x = side == 0 || side == 3 ? 1.0 : -1.0, sign_y = side < 2 ? 1.0 : -1.0;
                    rows.back().push_back(
                        is_pole && i > 0 ? rows.back().back()
                                         : mesh.add(sign_x * (x - radius) + out * std::cos(around),
                                                    sign_y * (y - radius) + out * std::sin(around),
                                                    (above ? z - radius : radius - z) + radius * std::sin(height)));
                }
        }
    for (std::size_t j = 1; j < rows.size(); ++j) join_rows(mesh, rows[j - 1], rows[j], other_diagonal);
    const auto at = [&](const std::vector<std::int32_t>& row, int corner) {
        return row[static_cast<std::size_t>(corner * (parts + 1))];
    };
    mesh.face(at(rows.back(), 0), at(rows.back(), 1), at(rows.back(), 2));
    mesh.face(at(rows.back(), 0), at(rows.back(), 2), at(rows.back(), 3));
    mesh.face(at(rows.front(), 0), at(rows.front(), 2), at(rows.front(), 1));
    mesh.face(at(rows.front(), 0), at(rows.front(), 3), at(rows.front(), 2));
    return mesh;
}

struct ProfilePoint {
    double radius, z;
};

// Turns a profile about the z axis. It goes upward along the outside, and begins and ends on the axis.
inline Triangles turned_part(const std::vector<ProfilePoint>& profile, int around, bool other_diagonal = false) {
    Triangles mesh;
    std::vector<std::vector<std::int32_t>> rows;
    for (const ProfilePoint& p : profile) {
        rows.emplace_back();
        for (int k = 0; k < around; ++k) {
            const double angle = 6.283185307179586 * k / around;
            rows.back().push_back(p.radius == 0.0 && k > 0
                                      ? rows.back().front()
                                      : mesh.add(p.radius * std::cos(angle), p.radius * std::sin(angle), p.z));
        }
    }
    for (std::size_t j = 1; j < rows.size(); ++j) join_rows(mesh, rows[j - 1], rows[j], other_diagonal);
    return mesh;
}

// Adds an arc to a profile, without its first point. Angles are in quarters of a turn.
inline void add_arc(std::vector<ProfilePoint>& profile, double radius, double z, double of, double from, double to,
                    int parts) {
    for (int i = 1; i <= parts; ++i) {
        const double angle = 1.5707963267948966 * (from + (to - from) * i / parts);
        profile.push_back({radius + of * std::cos(angle), z + of * std::sin(angle)});
    }
}

// A pin of radius 1 on a plate of radius 3 that runs out into the plate by a fillet, with a rounded upper edge.
inline Triangles pin_on_plate(double fillet, int parts, int around, bool other_diagonal = false) {
    std::vector<ProfilePoint> profile{{0.0, 0.0}, {3.0, 0.0}, {3.0, 0.5}, {1.0 + fillet, 0.5}};
    for (int i = 1; i <= parts; ++i) {
        const double angle = 1.5707963267948966 * (3.0 - static_cast<double>(i) / parts);
        profile.push_back({1.0 + fillet + fillet * std::cos(angle), 0.5 + fillet + fillet * std::sin(angle)});
    }
    profile.push_back({1.0, 3.0 - fillet});
    add_arc(profile, 1.0 - fillet, 3.0 - fillet, fillet, 0.0, 1.0, parts);
    profile.push_back({0.0, 3.0});
    return turned_part(profile, around, other_diagonal);
}

// A cylinder of radius 1 between two half balls.
inline Triangles capsule(double height, int parts, int around, bool other_diagonal = false) {
    std::vector<ProfilePoint> profile{{0.0, -1.0}};
    for (int i = 1; i <= parts; ++i) {
        const double angle = 1.5707963267948966 * (static_cast<double>(i) / parts - 1.0);
        profile.push_back({std::cos(angle), std::sin(angle)});
    }
    profile.push_back({1.0, height});
    for (int i = 1; i <= parts; ++i) {
        const double angle = 1.5707963267948966 * i / parts;
        profile.push_back({i == parts ? 0.0 : std::cos(angle), height + std::sin(angle)});
    }
    return turned_part(profile, around, other_diagonal);
}

} // namespace hrbfnpr::test
