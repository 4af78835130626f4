// SPDX-License-Identifier: MIT
// Technical inputs of the benchmark of pictures: a CAD part, a gear train, a turntable plate, and a chair whose faces
// are given twice.
#pragma once

#include "picture_profiles.h"

#include <glm/gtc/matrix_transform.hpp>

namespace bench {

namespace detail {

inline constexpr double pi = std::numbers::pi;

[[nodiscard]] inline glm::dmat4 moved(double x, double y, double z) {
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

// Returns a quarter of a circle as (radius, height) pairs: from `start` to `end`, bulging towards (end.x, start.y).
[[nodiscard]] inline std::vector<glm::dvec2> quarter(const glm::dvec2& start, const glm::dvec2& end, int steps) {
    std::vector<glm::dvec2> arc;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 0.5 * pi * i / steps;
        arc.push_back({start.x + (end.x - start.x) * std::sin(angle), end.y + (start.y - end.y) * std::cos(angle)});
    }
    return arc;
}

[[nodiscard]] inline std::vector<glm::dvec2> joined(std::vector<glm::dvec2> a, const std::vector<glm::dvec2>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// Returns a disc or a ring from z = 0 up, whose upper and lower outer edges are bevelled.
[[nodiscard]] inline PictureMesh disc(double radius, double bore, double height, double bevel, int sides) {
    Profiles part;
    part.turned({{radius - bevel, 0.0}, {radius, bevel}, {radius, height - bevel}, {radius - bevel, height}}, sides);
    std::vector<Loop> holes;
    if (bore > 0.0) {
        part.turned({{bore, 0.0}, {bore, height}}, sides, glm::dvec2(0.0), true);
        holes.push_back(reversed(circle(bore, sides)));
    }
    for (const bool is_top : {false, true})
        part.cap(circle(radius - bevel, sides), holes, is_top ? height : 0.0, is_top);
    return part.take();
}

// Returns a spur gear with round bore.
[[nodiscard]] inline PictureMesh gear(int teeth, double module, double height, double bore) {
    const double pitch = 2.0 * pi / teeth;
    const double root = 0.5 * module * teeth - 1.25 * module;
    const double tip = 0.5 * module * teeth + module;
    constexpr int flank = 3; // sides of each flank of a tooth
    Loop loop;
    for (int tooth = 0; tooth < teeth; ++tooth) {
        const auto add = [&](double radius, double of_pitch) {
            const double angle = pitch * (tooth + of_pitch);
            loop.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        };
        const auto half_width = [](double u) { return 0.36 - 0.25 * u + 0.06 * u * (1.0 - u); };
        for (int i = 0; i <= flank; ++i) {
            const double u = static_cast<double>(i) / flank;
            add(glm::mix(root, tip, u), -half_width(u));
        }
        add(tip, 0.0);
        for (int i = flank; i >= 0; --i) {
            const double u = static_cast<double>(i) / flank;
            add(glm::mix(root, tip, u), half_width(u));
        }
        add(root, 0.5);
    }
    Profiles part;
    part.wall(loop, 0.0, loop, height);
    part.turned({{bore, 0.0}, {bore, height}}, 24, glm::dvec2(0.0), true);
    for (const bool is_top : {false, true}) part.cap(loop, {reversed(circle(bore, 24))}, is_top ? height : 0.0, is_top);
    return part.take();
}

// Returns a screw with a hexagonal head and a bevelled end.
[[nodiscard]] inline PictureMesh screw(double radius, double length) {
    constexpr int sides = 24;
    const Loop head = circle(1.8 * radius, 6);
    Profiles part;
    part.turned({{0.8 * radius, 0.0}, {radius, 0.2 * radius}, {radius, length}}, sides);
    part.cap(circle(0.8 * radius, sides), {}, 0.0, false);
    part.cap(head, {reversed(circle(radius, sides))}, length, false);
    part.wall(head, length, head, length + 1.2 * radius);
    part.cap(head, {}, length + 1.2 * radius, true);
    return part.take();
}

// Returns a plate with rounded corners and round holes.
[[nodiscard]] inline PictureMesh drilled(const glm::dvec2& size, double height, const std::vector<glm::dvec3>& holes) {
    const Loop outer = rounded_rectangle(size, 8.0, 8);
    Profiles part;
    part.wall(outer, 0.0, outer, height);
    std::vector<Loop> loops;
    for (const glm::dvec3& hole : holes) {
        loops.push_back(reversed(circle(hole.z, 24, {hole.x, hole.y})));
        part.wall(loops.back(), 0.0, loops.back(), height);
    }
    for (const bool is_top : {false, true}) part.cap(outer, loops, is_top ? height : 0.0, is_top);
    return part.take();
}

} // namespace detail

// A flange with a boss, counterbored holes, blind holes, a bore with a step, a pocket and fillets: 33 smooth sheets.
[[nodiscard]] inline PictureMesh cad_part() {
    using detail::joined;
    using detail::quarter;
    constexpr int sides = 72;
    Profiles part;
    const auto outline = [](double inset) {
        return rounded_rectangle(glm::dvec2(120.0, 90.0) - 2.0 * inset, 14.0 - inset, 12);
    };
    part.wall(outline(0.0), 0.0, outline(0.0), 11.0);
    const auto rounded = [&](int i) {
        return glm::dvec2(3.0 - 3.0 * std::cos(i * detail::pi / 16.0), 3.0 * std::sin(i * detail::pi / 16.0));
    };
    for (int i = 0; i < 8; ++i)
        part.wall(outline(rounded(i).x), 11.0 + rounded(i).y, outline(rounded(i + 1).x), 11.0 + rounded(i + 1).y);
    std::vector<Loop> above, below;
    for (int i = 0; i < 4; ++i) { // counterbored holes
        const glm::dvec2 at((i % 2 == 0 ? 1.0 : -1.0) * 47.0, (i < 2 ? 1.0 : -1.0) * 32.0);
        part.turned({{3.3, 0.0}, {3.3, 7.0}, {6.0, 7.0}, {6.0, 14.0}}, 36, at, true);
        above.push_back(reversed(circle(6.0, 36, at)));
        below.push_back(reversed(circle(3.3, 36, at)));
    }
    above.push_back(reversed(circle(34.0, sides)));
    part.cap(outline(rounded(8).x), above, 14.0, true);
    part.turned(joined(quarter({34.0, 14.0}, {28.0, 20.0}, 8), {{28.0, 38.0}, {26.0, 40.0}}), sides);
    std::vector<Loop> on_boss = {reversed(circle(14.0, sides))};
    for (int i = 0; i < 6; ++i) { // blind holes
        const double angle = detail::pi / 3.0 * (i + 0.5);
        const glm::dvec2 at = 20.0 * glm::dvec2(std::cos(angle), std::sin(angle));
        part.turned({{0.0, 27.0}, {2.5, 28.5}, {2.5, 40.0}}, 24, at, true);
        on_boss.push_back(reversed(circle(2.5, 24, at)));
    }
    part.cap(circle(26.0, sides), on_boss, 40.0, true);
    part.turned({{9.0, 6.0}, {9.0, 22.0}, {14.0, 22.0}, {14.0, 40.0}}, sides, glm::dvec2(0.0), true);
    const Loop pocket = reversed(rounded_rectangle({60.0, 50.0}, 8.0, 10));
    part.wall(pocket, 0.0, pocket, 6.0);
    part.cap(reversed(pocket), {reversed(circle(9.0, sides))}, 6.0, false);
    below.push_back(pocket);
    part.cap(outline(0.0), below, 0.0, false);
    return part.take();
}

// A gear train of 100 parts: two plates, 4 pillars, 15 axles with two gears and three washers each, and 4 screws.
[[nodiscard]] inline PictureMesh assembly() {
    using detail::moved;
    constexpr double module = 2.0;
    std::vector<glm::dvec3> holes; // x, y, radius
    struct Axle {
        double x, y;
        int wheel, pinion; // teeth
        double level;
    };
    std::vector<Axle> axles;
    for (int i = 0; i < 15; ++i) {
        const double x = -104.0 + 52.0 * (i % 5), y = -52.0 + 52.0 * (i / 5);
        axles.push_back({x, y, 20 + 5 * (i % 4), 12 + i % 5, 12.0 + 11.0 * (i % 3)});
        holes.push_back({x, y, 3.2});
    }
    for (const double x : {-136.0, 136.0})
        for (const double y : {-86.0, 86.0}) holes.push_back({x, y, 3.0});
    PictureMesh all;
    const PictureMesh plate = detail::drilled({300.0, 200.0}, 6.0, holes);
    all.append(plate);
    all.append(plate, moved(0.0, 0.0, 60.0));
    for (const Axle& axle : axles) {
        all.append(detail::disc(3.0, 0.0, 80.0, 0.6, 24), moved(axle.x, axle.y, -6.0));
        all.append(detail::gear(axle.wheel, module, 6.0, 3.0), moved(axle.x, axle.y, axle.level));
        all.append(detail::gear(axle.pinion, module, 9.0, 3.0), moved(axle.x, axle.y, axle.level + 7.0));
        for (const double z : {-2.0, 7.0, 58.0})
            all.append(detail::disc(6.0, 3.1, 1.5, 0.2, 16), moved(axle.x, axle.y, z));
    }
    for (std::size_t i = 15; i < 19; ++i) {
        all.append(detail::disc(6.0, 0.0, 54.0, 1.0, 32), moved(holes[i].x, holes[i].y, 6.0));
        all.append(detail::screw(3.0, 7.5), moved(holes[i].x, holes[i].y, 60.0));
    }
    return all;
}

namespace detail {

inline constexpr int stud_sides = 64;

// Adds a stud with rounded edges to a part whose upper side is at `z`. Returns the hole that it needs in that side.
[[nodiscard]] inline Loop add_stud(Profiles& part, const glm::dvec2& at, double z) {
    constexpr int steps = 6; // sides of a rounded edge
    std::vector<glm::dvec2> profile = quarter({2.8, z}, {2.4, z + 0.4}, steps);
    const double top = z + 1.8;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 0.5 * pi * i / steps;
        profile.push_back({2.0 + 0.4 * std::cos(angle), top - 0.4 + 0.4 * std::sin(angle)});
    }
    profile.push_back({1.4, top});
    profile.push_back({1.3, top - 0.1});
    part.turned(profile, stud_sides, at);
    part.cap(circle(1.3, stud_sides, at), {}, top - 0.1, true);
    return reversed(circle(2.8, stud_sides, at));
}

// Adds studs in a square grid of `count` by `count` whose distance from the middle is within these limits.
[[nodiscard]] inline std::vector<Loop> add_studs(Profiles& part, int count, double least, double most, double z) {
    std::vector<Loop> holes;
    const double middle = 0.5 * (count - 1);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const glm::dvec2 from_middle(i - middle, j - middle);
            const double distance = glm::length(from_middle);
            if (distance > least && distance < most) holes.push_back(add_stud(part, 8.0 * from_middle, z));
        }
    return holes;
}

[[nodiscard]] inline PictureMesh turntable_base() {
    Profiles base;
    const Loop square = rounded_rectangle({64.0, 64.0}, 2.0, 6);
    base.wall(square, 0.0, square, 3.2);
    base.cap(square, add_studs(base, 8, 4.0, 8.0, 3.2), 3.2, true);
    base.cap(square, {}, 0.0, false);
    return base.take();
}

// Returns a round table whose rim has 60 rounded teeth.
[[nodiscard]] inline PictureMesh turntable_top() {
    constexpr int sides = 720;
    Profiles table;
    Loop rim;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * pi * i / sides;
        const double radius = 28.0 + 0.8 * std::clamp(1.6 * std::cos(60.0 * angle), -1.0, 1.0);
        rim.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    const Loop shoulder = circle(26.0, sides);
    table.wall(rim, 4.0, rim, 7.0);
    table.wall(rim, 7.0, shoulder, 7.6);
    table.wall(shoulder, 4.0, rim, 4.0);
    table.cap(shoulder, add_studs(table, 6, 0.0, 2.9, 7.6), 7.6, true);
    table.cap(shoulder, {}, 4.0, false);
    return table.take();
}

} // namespace detail

// A turntable plate of 6 parts: a square base and a round table with studs, and four pins; all edges are rounded
// finely.
[[nodiscard]] inline PictureMesh turntable_plate() {
    PictureMesh all = detail::turntable_base();
    all.append(detail::turntable_top());
    for (const double x : {-30.0, 30.0})
        for (const double y : {-30.0, 30.0})
            all.append(detail::disc(1.2, 0.0, 8.0, 0.3, detail::stud_sides), detail::moved(x, y, -7.0));
    return all;
}

} // namespace bench
