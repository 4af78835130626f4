// SPDX-License-Identifier: MIT
// Forty parts: solids of one item or of several, and meshes.
#pragma once

#include "picture_mesh.h"
#include "technical_solid.h"

#include <numbers>
#include <string>

namespace bench {

// The classes of lines that a part has.
enum class LineClass { outline, sharp, tangent, hidden, section, intersection, border };
inline constexpr const char* line_class_names[] = {"outline", "sharp",        "tangent", "hidden",
                                                   "section", "intersection", "border"};

struct TechnicalPart {
    std::string name;
    std::vector<PlainSolid> items; // empty for a mesh
    PictureMesh mesh;
    std::vector<LineClass> classes; // beside sharp and hidden, which all parts have

    [[nodiscard]] bool is_mesh() const { return items.empty(); }
};

namespace technical {

using glm::dvec2;
using glm::dvec3;

inline const dvec3 x_axis(1.0, 0.0, 0.0);
inline const dvec3 y_axis(0.0, 1.0, 0.0);

// An angle of two plates. Its inner corner is filled by a fillet that is tangent to both plates.
[[nodiscard]] inline PlainSolid bracket(double width, double fillet, double hole) {
    const PlainSolid floor = box(4.0, width, 0.5).moved({0.0, 0.0, -1.0});
    const PlainSolid wall = box(0.5, width, 3.0).moved({-1.75, 0.0, 0.25});
    PlainSolid all = floor + wall;
    if (fillet > 0.0) {
        const dvec3 corner(-1.5, 0.0, -0.75);
        // It reaches into the plates, because faces that coincide would be surfaces inside the solid.
        const double inside = 0.1;
        const double middle = 0.5 * (fillet - inside);
        const PlainSolid filled =
            box(fillet + inside, width, fillet + inside).moved(corner + dvec3(middle, 0.0, middle));
        const PlainSolid round =
            cylinder(fillet, 2.0 * width).turned(90.0, x_axis).moved(corner + dvec3(fillet, 0.0, fillet));
        all = all + (filled - round);
    }
    if (hole > 0.0) all = all - cylinder(hole, 4.0).moved({0.7, 0.0, -1.0});
    return all;
}

// A shaft with steps, and a bore if `bore` is above 0.
[[nodiscard]] inline PlainSolid shaft(double bore, double taper) {
    PlainSolid all = cylinder(0.6, 4.0) + cylinder(1.2, 0.8).moved({0.0, 0.0, -0.6}) +
                     cone(0.9, 0.9 - taper, 1.0).moved({0.0, 0.0, 0.7});
    return bore > 0.0 ? all - cylinder(bore, 5.0) : all;
}

// Extrudes a closed polygon, anticlockwise, along z. The caps are fans around a corner from which all of the polygon is
// seen.
[[nodiscard]] inline PictureMesh extruded(const std::vector<dvec2>& polygon, double height) {
    PictureMesh mesh;
    const auto n = static_cast<std::int32_t>(polygon.size());
    for (const double z : {0.0, height})
        for (const dvec2& p : polygon) mesh.points.emplace_back(p, z);
    for (std::int32_t i = 0; i < n; ++i) {
        const std::int32_t k = (i + 1) % n;
        mesh.faces.push_back({i, k, n + k});
        mesh.faces.push_back({i, n + k, n + i});
    }
    for (std::int32_t i = 1; i + 1 < n; ++i) {
        mesh.faces.push_back({0, i + 1, i});
        mesh.faces.push_back({n, n + i, n + i + 1});
    }
    return mesh;
}

// Turns a profile (radius, height) around the z axis. The mesh is closed if the profile is.
[[nodiscard]] inline PictureMesh revolved(const std::vector<dvec2>& profile, bool closed, int steps = 240) {
    PictureMesh mesh;
    const auto rows = static_cast<std::int32_t>(profile.size());
    for (const dvec2& p : profile)
        for (int k = 0; k < steps; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / steps;
            mesh.points.emplace_back(p.x * std::cos(turn), p.x * std::sin(turn), p.y);
        }
    for (std::int32_t i = 0; i + (closed ? 0 : 1) < rows; ++i)
        for (std::int32_t k = 0; k < steps; ++k) {
            const std::int32_t j = (i + 1) % rows;
            const std::int32_t next = (k + 1) % steps;
            mesh.faces.push_back({i * steps + k, i * steps + next, j * steps + next});
            mesh.faces.push_back({i * steps + k, j * steps + next, j * steps + k});
        }
    return mesh;
}

} // namespace technical

[[nodiscard]] inline std::vector<TechnicalPart> technical_parts() {
    using namespace technical;
    using enum LineClass;
    std::vector<TechnicalPart> parts;
    const auto solid = [&](std::string name, PlainSolid of, std::vector<LineClass> classes) {
        classes.push_back(section);
        parts.push_back({std::move(name), {std::move(of)}, {}, std::move(classes)});
    };
    const auto items = [&](std::string name, std::vector<PlainSolid> of) {
        parts.push_back({std::move(name), std::move(of), {}, {intersection}});
    };
    const auto mesh = [&](std::string name, PictureMesh of, std::vector<LineClass> classes) {
        parts.push_back({std::move(name), {}, std::move(of), std::move(classes)});
    };
    // Brackets.
    solid("bracket", bracket(2.0, 0.0, 0.0), {});
    solid("bracket, hole", bracket(2.0, 0.0, 0.5), {outline});
    solid("bracket, fillet", bracket(2.0, 0.6, 0.0), {tangent});
    solid("bracket, fillet and hole", bracket(1.5, 0.9, 0.4), {tangent, outline});
    solid("bracket, narrow", bracket(0.6, 0.3, 0.0), {tangent});
    // Boxes and tubes that cross, as one solid.
    solid("boxes cross", box(3.0, 1.0, 1.0) + box(1.0, 3.0, 0.6).turned(25.0, x_axis), {});
    solid("three boxes cross", box(4.0, 0.8, 0.8) + box(0.8, 4.0, 0.8) + box(0.8, 0.8, 4.0), {});
    solid("box less box", box(3.0, 2.0, 1.5) - box(2.0, 2.5, 0.8).moved({0.0, 0.0, 0.6}), {});
    solid("tubes cross", cylinder(0.8, 4.0) + cylinder(0.6, 4.0).turned(90.0, x_axis), {outline});
    solid("tubes cross askew", cylinder(0.8, 4.0) + cylinder(0.5, 4.0).turned(60.0, x_axis).moved({0.2, 0.0, 0.3}),
          {outline});
    solid("hollow tee",
          (cylinder(0.9, 4.0) + cylinder(0.7, 2.0).turned(90.0, x_axis).moved({0.0, -1.2, 0.0})) - cylinder(0.7, 5.0) -
              cylinder(0.5, 3.0).turned(90.0, x_axis).moved({0.0, -1.2, 0.0}),
          {outline});
    solid("tube through box", box(2.0, 2.0, 2.0) + cylinder(0.5, 4.0).turned(35.0, y_axis), {outline});
    // Cavities.
    solid("box with a round cavity", box(2.0, 2.0, 2.0) - ball(0.7), {outline});
    solid("box with a box cavity", box(3.0, 2.0, 2.0) - box(1.5, 1.0, 0.8), {});
    solid("tube with closed ends", cylinder(1.0, 3.0) - cylinder(0.7, 2.4), {outline});
    solid("cavity and bore",
          box(3.0, 2.0, 2.0) - ball(0.6).moved({-0.6, 0.0, 0.0}) - cylinder(0.3, 3.0).moved({0.8, 0.0, 0.0}),
          {outline});
    // Cones.
    solid("cone", cone(1.0, 0.0, 2.0), {outline});
    solid("frustum", cone(1.2, 0.5, 1.5), {outline});
    solid("cone on a box", box(2.0, 2.0, 0.6) + cone(0.9, 0.2, 1.6).moved({0.0, 0.0, 1.0}), {outline});
    solid("countersunk plate", box(3.0, 2.0, 0.6) - cylinder(0.3, 2.0) - cone(0.3, 0.7, 0.4).moved({0.0, 0.0, 0.15}),
          {outline});
    // Turned parts.
    solid("shaft", shaft(0.0, 0.0), {outline});
    solid("shaft with a cone", shaft(0.0, 0.25), {outline});
    solid("bush", shaft(0.35, 0.25), {outline});
    solid("flange",
          (cylinder(1.6, 0.4) + cylinder(0.8, 1.8).moved({0.0, 0.0, 0.9})) - cylinder(0.5, 5.0) -
              cylinder(0.18, 2.0).moved({1.2, 0.0, 0.0}) - cylinder(0.18, 2.0).moved({-0.6, 1.04, 0.0}) -
              cylinder(0.18, 2.0).moved({-0.6, -1.04, 0.0}),
          {outline});
    solid("pulley", cylinder(1.5, 1.0) - (cylinder(2.0, 0.4) - cylinder(1.0, 0.5)) - cylinder(0.3, 2.0), {outline});
    // T-junctions: a line ends in the middle of another line's image.
    solid("plates",
          box(3.0, 3.0, 0.2) + box(2.0, 2.0, 0.2).moved({0.3, 0.2, 0.7}) + box(0.3, 0.3, 1.0).moved({0.3, 0.2, 0.3}),
          {});
    solid("comb",
          box(4.0, 1.5, 0.4) + box(0.3, 1.5, 1.2).moved({-1.5, 0.0, 0.7}) + box(0.3, 1.5, 1.2).moved({-0.5, 0.0, 0.7}) +
              box(0.3, 1.5, 1.2).moved({0.5, 0.0, 0.7}) + box(0.3, 1.5, 1.2).moved({1.5, 0.0, 0.7}),
          {});
    solid("ball in a cage",
          (box(2.4, 2.4, 2.4) - box(1.9, 1.9, 3.0) - box(1.9, 3.0, 1.9) - box(3.0, 1.9, 1.9)) + ball(0.9), {outline});
    // Several items.
    items("two boxes", {box(3.0, 1.0, 1.0), box(1.0, 3.0, 0.6).turned(25.0, x_axis)});
    items("box and tube", {box(2.0, 2.0, 2.0), cylinder(0.5, 4.0).turned(35.0, y_axis)});
    items("two tubes", {cylinder(0.8, 4.0), cylinder(0.6, 4.0).turned(80.0, x_axis)});
    items("ball and cone", {ball(1.0), cone(1.0, 0.3, 2.0).moved({0.6, 0.3, 0.5})});
    // Meshes.
    mesh("mesh: angle", extruded({{0, 0}, {4, 0}, {4, 0.6}, {0.6, 0.6}, {0.6, 3}, {0, 3}}, 2.0), {});
    mesh("mesh: hexagon", extruded({{1, 0}, {0.5, 0.866}, {-0.5, 0.866}, {-1, 0}, {-0.5, -0.866}, {0.5, -0.866}}, 0.8),
         {});
    mesh("mesh: wedge", extruded({{0, 0}, {3, 0}, {0, 1.2}}, 1.5), {});
    mesh("mesh: ring", revolved({{0.8, -0.4}, {1.4, -0.4}, {1.4, 0.4}, {0.8, 0.4}}, true), {outline});
    mesh("mesh: bush", revolved({{0.5, -1}, {1.5, -1}, {1.5, -0.5}, {0.9, -0.5}, {0.9, 1}, {0.5, 1}}, true), {outline});
    std::vector<dvec2> bowl;
    for (int i = 2; i <= 24; ++i) {
        const double turn = std::numbers::pi / 48.0 * i;
        bowl.emplace_back(std::sin(turn), -std::cos(turn));
    }
    mesh("mesh: open bowl", revolved(bowl, false), {outline, border});
    mesh("mesh: open tube", revolved({{1, -1}, {1, -0.5}, {1, 0}, {1, 0.5}, {1, 1}}, false), {outline, border});
    mesh("mesh: open cone", revolved({{0.3, 1}, {0.6, 0.4}, {0.9, -0.2}, {1.2, -0.8}}, false), {outline, border});
    return parts;
}

} // namespace bench
