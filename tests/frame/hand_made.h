// SPDX-License-Identifier: MIT
// Point sets built by hand, and cameras to look at them.
#pragma once

#include "base/random.h"
#include "geometry/tangent_frame.h"
#include "marks/point_set.h"
#include "support/drawn.h"
#include "support/samples.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hrbfnpr::testing {

inline constexpr double pi = std::numbers::pi;

// Returns the first layer of a kind, and adds one if none exists.
inline marks::Layer& layer_of(marks::PointSet& set, marks::Kind kind) {
    for (marks::Layer& layer : set.layers)
        if (layer.kind == kind) return layer;
    return set.layers.add(set.layers.memory(), kind);
}

// Adds a mark of a stroke. Call index_strokes() for the layer afterwards.
inline void add_mark(marks::Layer& layer, const glm::dvec3& position, const glm::dvec3& normal,
                     const glm::dvec3& direction, std::uint32_t stroke, std::uint32_t place) {
    const auto index = static_cast<std::uint64_t>(layer.count());
    for (int k = 0; k < 3; ++k) {
        layer.position.push_back(static_cast<float>(position[k]));
        layer.normal.push_back(static_cast<float>(normal[k]));
        layer.direction.push_back(static_cast<float>(direction[k]));
    }
    layer.rank.push_back(static_cast<float>(base::uniform4(1, index, base::Purpose::rank)[0] * 0.99999));
    layer.level.push_back(0);
    layer.stroke.push_back(stroke);
    layer.stroke.push_back(place);
}

inline void add_stipple(marks::PointSet& set, const glm::dvec3& position, const glm::dvec3& normal) {
    marks::Layer& layer = layer_of(set, marks::Kind::stipples);
    add_mark(layer, position, normal, geometry::any_perpendicular(normal),
             2 * static_cast<std::uint32_t>(layer.count()), 0);
    set.bounds.extend(position + set.origin);
}

// Adds a stroke along x through these places.
inline void add_stroke(marks::PointSet& set, marks::Kind kind, const std::vector<glm::dvec3>& places,
                       const glm::dvec3& normal) {
    marks::Layer& layer = layer_of(set, kind);
    const std::uint32_t number = 2 * static_cast<std::uint32_t>(layer.strokes());
    std::uint32_t along = 0;
    for (const glm::dvec3& place : places) {
        add_mark(layer, place, normal, {1, 0, 0}, number, along++);
        set.bounds.extend(place + set.origin);
    }
    marks::index_strokes(layer);
}

inline glm::dvec3 spiral_direction(std::int64_t i, std::int64_t count) {
    const std::array<double, 3> p = test::spiral_point(i, count);
    return {p[0], p[1], p[2]};
}

// Evenly spaced stipples on a sphere.
inline marks::PointSet sphere(base::Memory& memory, int count, double radius = 1.0,
                              const glm::dvec3& centre = glm::dvec3(0.0)) {
    marks::PointSet set(memory);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 n = spiral_direction(i, count);
        add_stipple(set, centre + radius * n, n);
    }
    set.spacing = radius * std::sqrt(4.0 * pi / count);
    return set;
}

// A square of side 2 in the plane z = 0, facing +z.
inline marks::PointSet plane(base::Memory& memory, int side) {
    marks::PointSet set(memory);
    set.spacing = 2.0 / side;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j)
            add_stipple(set, {(i + 0.5) * set.spacing - 1.0, (j + 0.5) * set.spacing - 1.0, 0.0}, {0.0, 0.0, 1.0});
    }
    return set;
}

struct TorusPoint {
    glm::dvec3 position, normal, along, around;
};

// A point of the torus with the major radius 1 in the plane z = 0.
inline TorusPoint torus_point(double minor, double along, double around) {
    const glm::dvec3 out(std::cos(along), std::sin(along), 0.0);
    const glm::dvec3 n = std::cos(around) * out + std::sin(around) * glm::dvec3(0.0, 0.0, 1.0);
    return {out + minor * n, n, {-std::sin(along), std::cos(along), 0.0}, glm::cross(n, {-out.y, out.x, 0.0})};
}

// Stipples on a torus, in evenly spaced rings.
inline marks::PointSet torus(base::Memory& memory, int rings, double minor = 0.45) {
    marks::PointSet set(memory);
    set.spacing = 2.0 * pi * minor / rings;
    for (int r = 0; r < rings; ++r) {
        const double around = 2.0 * pi * r / rings;
        const int count = static_cast<int>(2.0 * pi * (1.0 + minor * std::cos(around)) / set.spacing);
        for (int i = 0; i < count; ++i) {
            const TorusPoint p = torus_point(minor, 2.0 * pi * (i + 0.618 * r) / count, around);
            add_stipple(set, p.position, p.normal);
        }
    }
    return set;
}

// Adds strokes on the torus: direction 0 runs the long way, direction 1 around the tube.
inline void add_torus_strokes(marks::PointSet& set, marks::Kind kind, int strokes, int marks, double length,
                              double minor = 0.45) {
    marks::Layer& layer = layer_of(set, kind);
    for (int s = 0; s < strokes; ++s) {
        const auto u = base::uniform4(7, static_cast<std::uint64_t>(s), base::Purpose::candidate);
        double around = 2.0 * pi * u[1];
        // The density follows the area without rejection: there are more strokes on the outer side.
        if (u[2] > 1.0 / (1.0 + minor) * (1.0 + minor * std::cos(around)) / 1.0) around += pi;
        for (std::uint32_t d = 0; d < 2; ++d) {
            for (int m = 0; m < marks; ++m) {
                const double t = (m - (marks - 1) / 2.0) / marks * length;
                const double a = 2.0 * pi * u[0] + (d == 0 ? t / (1.0 + minor * std::cos(around)) : 0.0);
                const TorusPoint p = torus_point(minor, a, around + (d == 1 ? t / minor : 0.0));
                add_mark(layer, p.position, p.normal, d == 0 ? p.along : p.around,
                         static_cast<std::uint32_t>(2 * s) + d, static_cast<std::uint32_t>(m));
                // A stroke is shown completely.
                layer.rank.back() = static_cast<float>(u[3]);
            }
        }
    }
    marks::index_strokes(layer);
}

// A camera that sees [-half, half] in x and y, from z = 10 along -z.
inline frame::Camera front_camera(int width, int height, double half = 1.25) {
    frame::Camera camera;
    camera.view = frame::look_at({0.0, 0.0, 10.0}, glm::dvec3(0.0), {0.0, 1.0, 0.0});
    camera.projection = frame::orthographic(2.0 * half, width, height, 1.0, 20.0, camera.depth);
    camera.viewport = {0.0, 0.0, width, height};
    return camera;
}

// All marks are ink, and there are no discs of paper.
inline Style plain_style() {
    Style style;
    style.hidden_lines = frame::HiddenLines::show;
    style.tone = frame::Tone::none;
    return style;
}

// Frames by depth layers see only clusters. Call this for complete sets.
inline marks::PointSet clustered(const base::Runtime& runtime, marks::PointSet set) {
    marks::cluster_marks(runtime, set);
    return set;
}

// An item that is drawn by depth layers unless the style says otherwise. The set must be clustered().
inline frame::Item layered_item(const marks::PointSet& set, const frame::Style& style,
                                const glm::dmat4& transform = glm::dmat4(1.0)) {
    frame::Item item;
    item.set = &set;
    item.style = style;
    item.transform = transform;
    return item;
}
inline frame::Item layered_item(const marks::PointSet& set, const Style& style,
                                const glm::dmat4& transform = glm::dmat4(1.0)) {
    return layered_item(set, kept(style), transform);
}

// An item with the published visibility.
inline frame::Item item_of(const marks::PointSet& set, const frame::Style& style,
                           const glm::dmat4& transform = glm::dmat4(1.0)) {
    frame::Item item = layered_item(set, style, transform);
    item.style.visibility = frame::Visibility::published;
    return item;
}
inline frame::Item item_of(const marks::PointSet& set, const Style& style,
                           const glm::dmat4& transform = glm::dmat4(1.0)) {
    return item_of(set, kept(style), transform);
}

} // namespace hrbfnpr::testing
