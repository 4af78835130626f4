// SPDX-License-Identifier: MIT
// Hand-made lines of hatching, and measures of the ink that is drawn.
#pragma once

#include "frame/hand_made.h"
#include "frame/hatch_law_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace hrbfnpr::testing {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::LayerStyle;

inline constexpr int size = 500;
inline constexpr int finest = 3;
inline constexpr double step = 0.01;                     // distance of the finest lines
inline constexpr double coarsest = step * (1 << finest); // distance of the lines of level 0

// The darkness at a place.
using Darkness = std::function<double(const glm::dvec3&)>;
inline std::int32_t give_tones(void* user, std::int64_t count, const float* positions, const float*, float* tau) {
    const auto& darkness = *static_cast<const Darkness*>(user);
    for (std::int64_t i = 0; i < count; ++i)
        tau[i] = static_cast<float>(1.0 - darkness({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}));
    return 0;
}

inline std::uint8_t level_of(int line) {
    std::uint8_t level = finest;
    while (level > 0 && line % 2 == 0) {
        line /= 2;
        --level;
    }
    return level;
}

struct Line {
    double y, from, to;
    std::uint8_t level;
};

// Adds a line along x in the plane z = 0, facing +z; by default its marks are as far apart as the finest lines.
inline void add_line(marks::PointSet& set, const Line& line, double apart = step) {
    std::vector<glm::dvec3> places;
    const int count = static_cast<int>(std::lround((line.to - line.from) / apart)) + 1;
    for (int i = 0; i < count; ++i) places.emplace_back(line.from + apart * i, line.y, 0.0);
    add_stroke(set, marks::Kind::own, places, {0, 0, 1});
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    for (int i = 0; i < count; ++i) layer.level[layer.count() - 1 - i] = line.level;
}

inline void set_nesting(marks::PointSet& set, double separation, int levels) {
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    layer.report.step = separation;
    layer.report.levels = levels;
    set.spacing = step;
}

// Nested lines over [-1, 1] in x and y.
inline marks::PointSet nested_plane(base::Memory& memory) {
    marks::PointSet set(memory);
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    std::uint32_t number = 0;
    for (int line = -100; line <= 100; ++line, number += 2) {
        for (int i = -100; i <= 100; ++i) {
            const glm::dvec3 place(step * i, step * line, 0.0);
            add_mark(layer, place, {0, 0, 1}, {1, 0, 0}, number, static_cast<std::uint32_t>(i + 100));
            layer.level[layer.count() - 1] = level_of(line);
            set.bounds.extend(place);
        }
    }
    marks::index_strokes(layer);
    set_nesting(set, step, finest);
    return set;
}

class Hatch : public ::testing::Test {
protected:
    Hatch() {
        layer.shape = frame::Shape::hatch;
        layer.contours = false;
        style.hidden_lines = frame::HiddenLines::show;
        style.tone = frame::Tone::callback;
        style.tone_function = give_tones;
        style.tone_user = &darkness;
    }
    void cluster() { set = clustered(runtime, std::move(set)); }
    const drawing::Drawing& draw(const frame::Camera& camera) {
        style.layers = std::span(&layer, 1);
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera);
        return frame.drawing();
    }
    // Draws the set behind a blank set, which hides it and has no halo itself.
    const drawing::Drawing& draw_behind(const marks::PointSet& blank, const glm::dmat4& transform, double halo = 0.0) {
        frame::LayerStyle unseen;
        unseen.share = 0.0F;
        unseen.contours = false;
        style.hidden_lines = frame::HiddenLines::hide;
        style.halo_width = 0.0F;
        frame::Style blank_style = style;
        blank_style.tone = frame::Tone::none;
        blank_style.layers = std::span(&unseen, 1);
        style.layers = std::span(&layer, 1);
        style.halo_width = static_cast<float>(halo);
        const std::array items{layered_item(set, style), layered_item(blank, blank_style, transform)};
        frame.draw(items, front_camera(size, size, 1.25));
        return frame.drawing();
    }
    [[nodiscard]] std::span<const StrokePoint> points_of(std::int64_t stroke) const {
        const Stroke& s = frame.drawing().strokes[stroke];
        return frame.drawing().points.span().subspan(static_cast<std::size_t>(s.first),
                                                     static_cast<std::size_t>(s.count));
    }
    // The ink of the strokes per area of a rectangle around the picture's middle, in pixels. Overlaps are counted
    // twice.
    [[nodiscard]] double ink(double half_width, double half_height, double middle = 0.5 * size,
                             double lower = 0.0) const {
        double sum = 0.0;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            for (std::size_t i = 1; i < points.size(); ++i) {
                const StrokePoint& a = points[i - 1];
                const StrokePoint& b = points[i];
                const double whole = static_cast<double>(std::hypot(b.x - a.x, b.y - a.y));
                const int parts =
                    8 + static_cast<int>(4.0 * whole); // short parts, so that the rectangle cuts them precisely
                const double length = whole / parts;
                for (int k = 0; k < parts; ++k) {
                    const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(parts);
                    const double x = static_cast<double>(std::lerp(a.x, b.x, t)) - middle;
                    const double y = static_cast<double>(std::lerp(a.y, b.y, t)) - middle - lower;
                    if (std::abs(x) < half_width && std::abs(y) < half_height)
                        sum += 2.0 * static_cast<double>(std::lerp(a.radius, b.radius, t)) * length;
                }
            }
        }
        return sum / (4.0 * half_width * half_height);
    }
    // The hatching on the plane: the rectangle has whole periods of the coarsest lines, and begins between two lines.
    [[nodiscard]] double plane_ink(double half) const {
        const double pixels = 0.5 * size / half;
        const double periods = std::floor(std::min(0.9, 0.9 * half) / coarsest);
        const double side = pixels * coarsest * periods;
        return ink(side, side, 0.5 * size, 0.3 * step * pixels);
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    LayerStyle layer;
    frame::Style style;
    Darkness darkness = [](const glm::dvec3&) { return 1.0; };
    DrawnFrame frame{runtime};
};

[[nodiscard]] inline double coverage(const LayerStyle& layer, double dark) {
    return static_cast<double>(law::hatch_coverage(layer, static_cast<float>(dark)));
}

// The half width at a place along a stroke that goes to the right.
[[nodiscard]] inline double radius_at(std::span<const StrokePoint> points, double x) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const StrokePoint& a = points[i - 1];
        const StrokePoint& b = points[i];
        const auto at = static_cast<float>(x);
        if (a.x <= at && at <= b.x)
            return static_cast<double>(std::lerp(a.radius, b.radius, (at - a.x) / std::max(b.x - a.x, 1e-6F)));
    }
    return 0.0;
}

// Adds a circle around z. If `whole`, its last mark is its first one again.
inline void add_circle(marks::PointSet& set, double radius, double z, const glm::dvec3& normal, int marks,
                       bool whole = true) {
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    const std::uint32_t number = 2 * static_cast<std::uint32_t>(layer.strokes());
    for (int i = 0; i < marks + (whole ? 1 : 0); ++i) {
        const double a = 2.0 * pi * (i % marks) / marks;
        const glm::dvec3 out(std::cos(a), std::sin(a), 0.0);
        const glm::dvec3 n(normal.x * out.x, normal.x * out.y, normal.z);
        const glm::dvec3 place = radius * out + glm::dvec3(0.0, 0.0, z);
        add_mark(layer, place, n, {-out.y, out.x, 0.0}, number, static_cast<std::uint32_t>(i));
        set.bounds.extend(place);
    }
    marks::index_strokes(layer);
}

// Adds nested circles of latitude around z on the unit sphere.
inline void add_latitudes(marks::PointSet& set) {
    constexpr int lines = 160;
    for (int i = 1; i < lines; ++i) {
        const double a = pi * i / lines;
        add_circle(set, std::sin(a), std::cos(a), {std::sin(a), 0.0, std::cos(a)},
                   20 + static_cast<int>(200 * std::sin(a)));
        marks::Layer& layer = layer_of(set, marks::Kind::own);
        for (std::int64_t m = layer.stroke_first[i - 1]; m < layer.stroke_first[i]; ++m) layer.level[m] = level_of(i);
    }
    set_nesting(set, pi / lines, finest);
}

} // namespace hrbfnpr::testing
