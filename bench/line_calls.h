// SPDX-License-Identifier: MIT
// Lines of a surface as the benchmarks draw them: line sets, cameras around a box, and strokes as polylines.
#pragma once

#include "calls.h"
#include "orbit.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace bench {

struct ReleaseLineSet {
    void operator()(const hrbfnpr_line_set* handle) const { hrbfnpr_line_set_release(handle); }
};
using LineSet = std::unique_ptr<const hrbfnpr_line_set, ReleaseLineSet>;

[[nodiscard]] inline LineSet make_line_set(hrbfnpr_context* context, const hrbfnpr_model* model) {
    scenes::Check check;
    hrbfnpr_line_set* set = nullptr;
    check(hrbfnpr_line_set_create(context, model, nullptr, nullptr, &set, check.error()));
    return LineSet(set);
}

[[nodiscard]] inline hrbfnpr_line_set_info info_of(const hrbfnpr_line_set* set) {
    scenes::Check check;
    auto info = scenes::made(hrbfnpr_line_set_info_init);
    check(hrbfnpr_line_set_get_info(set, &info, check.error()));
    return info;
}

[[nodiscard]] inline hrbfnpr_model_info info_of(const hrbfnpr_model* model) {
    scenes::Check check;
    auto info = scenes::made(hrbfnpr_model_info_init);
    check(hrbfnpr_model_get_info(model, &info, check.error()));
    return info;
}

// Returns the directions of the corners, edges and faces of a cube, from the eye into the scene.
[[nodiscard]] inline std::vector<glm::dvec3> cube_directions() {
    std::vector<glm::dvec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
    return directions;
}

// Returns the same directions, turned a little, so that none lies along an axis or in a plane of symmetry.
[[nodiscard]] inline std::vector<glm::dvec3> turned_directions() {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.07, glm::normalize(glm::dvec3(0.5, 0.3, 0.8))));
    std::vector<glm::dvec3> directions = cube_directions();
    for (glm::dvec3& d : directions) d = turn * d;
    return directions;
}

// Returns a camera of 1280 x 720 pixels that the box fills; angle 0: orthographic.
[[nodiscard]] inline hrbfnpr_camera camera_of(const double* low, const double* high, const glm::dvec3& direction,
                                              double angle) {
    scenes::Check check;
    auto camera = scenes::made(hrbfnpr_camera_init);
    const glm::dvec3 up = std::abs(direction.y) > 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    check(hrbfnpr_camera_fit_bounds(&camera, low, high, glm::value_ptr(direction), glm::value_ptr(up), angle, 1280.0,
                                    720.0, 0.04, check.error()));
    return camera;
}

// A point of a stroke, as the library writes it.
struct LinePoint {
    float window[3]; // pixels, and depth
    float color[4];
    float length; // along its stroke, pixels
};

struct Polyline {
    std::vector<glm::dvec3> window; // pixels, and depth; a closed line repeats its first point at the end
    int layers = 0;                 // the number of surface layers that hide the line
};

// Draws contours alone; a part that n layers hide has the opacity 2^-n, so that one drawing shows the numbers of
// layers.
[[nodiscard]] inline hrbfnpr_line_style contour_style() {
    auto line = scenes::made(hrbfnpr_line_style_init);
    line.kind = HRBFNPR_LINE_KIND_CONTOUR;
    line.hidden = HRBFNPR_HIDDEN_PARTS_ATTENUATED;
    line.hidden_opacity = 0.5F;
    line.hidden_width = line.width;
    line.cap = HRBFNPR_CAP_FLAT;
    line.taper = 0.0F;
    line.shortest = 0.0F;
    return line;
}

// A style with lines alone, of one kind or several.
class LinesStyle {
public:
    explicit LinesStyle(std::vector<hrbfnpr_line_style> lines) : lines_(std::move(lines)) { layer_.shown = 0; }
    [[nodiscard]] hrbfnpr_style get() const {
        auto style = scenes::made(hrbfnpr_style_init);
        style.layers = &layer_;
        style.layer_count = 1;
        style.lines = lines_.data();
        style.line_count = static_cast<std::int64_t>(lines_.size());
        style.halo_width = 0.0F; // no gaps where a line passes behind another
        return style;
    }

private:
    std::vector<hrbfnpr_line_style> lines_;
    hrbfnpr_layer_style layer_ = scenes::made(hrbfnpr_layer_style_init);
};

// Draws the contours of one surface, or the given lines.
class LinePainter {
public:
    LinePainter(hrbfnpr_context* context, const hrbfnpr_point_set* marks, const hrbfnpr_line_set* lines,
                std::vector<hrbfnpr_line_style> drawn = {contour_style()})
        : context_(context), drawn_(std::move(drawn)), style_(drawn_.get()) {
        begin_anew();
        item_.point_set = marks;
        item_.line_set = lines;
        item_.style = &style_;
    }
    LinePainter(const LinePainter&) = delete;
    LinePainter& operator=(const LinePainter&) = delete;

    // Starts with a new renderer, which keeps nothing from earlier drawings.
    void begin_anew() {
        drawing_.reset();
        hrbfnpr_renderer* renderer = nullptr;
        check_(hrbfnpr_renderer_create(context_, &renderer, check_.error()));
        renderer_.reset(renderer);
    }
    void draw(const hrbfnpr_camera& camera) {
        drawing_.reset();
        hrbfnpr_drawing* drawing = nullptr;
        check_(hrbfnpr_renderer_draw(renderer_.get(), &item_, 1, 0, &camera, &drawing, check_.error()));
        drawing_.reset(drawing);
    }
    [[nodiscard]] hrbfnpr_drawing_info info() const {
        auto info = scenes::made(hrbfnpr_drawing_info_init);
        check_(hrbfnpr_drawing_get_info(drawing_.get(), &info, nullptr));
        return info;
    }
    // Returns the lines of the last drawing.
    [[nodiscard]] std::vector<Polyline> polylines() {
        constexpr std::uint32_t primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
        std::int64_t vertices = 0;
        std::int64_t indices = 0;
        check_(hrbfnpr_drawing_vertex_bound(drawing_.get(), primitive, &vertices, &indices, check_.error()));
        std::vector<LinePoint> points(static_cast<std::size_t>(vertices));
        std::vector<std::uint32_t> order(static_cast<std::size_t>(indices));
        const hrbfnpr_vertex_layout layout = layout_of_point();
        check_(hrbfnpr_drawing_write_vertices(drawing_.get(), &layout, points.data(), vertices, &vertices, order.data(),
                                              indices, &indices, check_.error()));
        std::vector<Polyline> lines;
        bool begins = true;
        for (std::int64_t i = 0; i < indices; ++i) {
            const std::uint32_t index = order[static_cast<std::size_t>(i)];
            if (begins) lines.emplace_back();
            begins = index == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART);
            if (begins) continue;
            const LinePoint& p = points[index];
            lines.back().window.emplace_back(p.window[0], p.window[1], p.window[2]);
            lines.back().layers = static_cast<int>(std::lround(-std::log2(std::max(p.color[3], 1e-6F))));
        }
        return lines;
    }

private:
    [[nodiscard]] hrbfnpr_vertex_layout layout_of_point() {
        auto layout = scenes::made(hrbfnpr_vertex_layout_init);
        layout.primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
        layout.stride = sizeof(LinePoint);
        layout.attributes = attributes_.data();
        layout.attribute_count = static_cast<std::int64_t>(attributes_.size());
        constexpr std::array<std::uint32_t, 3> which{HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_VERTEX_ATTRIBUTE_COLOR,
                                                     HRBFNPR_VERTEX_ATTRIBUTE_LENGTH};
        constexpr std::array<std::size_t, 3> at{offsetof(LinePoint, window), offsetof(LinePoint, color),
                                                offsetof(LinePoint, length)};
        for (std::size_t i = 0; i < which.size(); ++i) {
            check_(hrbfnpr_vertex_attribute_init(&attributes_[i], sizeof attributes_[i]));
            attributes_[i].attribute = which[i];
            attributes_[i].scalar = HRBFNPR_SCALAR_FLOAT32;
            attributes_[i].offset = static_cast<std::uint32_t>(at[i]);
        }
        return layout;
    }

    hrbfnpr_context* context_;
    scenes::Check check_;
    scenes::Renderer renderer_;
    scenes::Drawing drawing_;
    LinesStyle drawn_;
    hrbfnpr_style style_;
    hrbfnpr_item item_ = scenes::made(hrbfnpr_item_init);
    std::array<hrbfnpr_vertex_attribute, 3> attributes_{};
};

} // namespace bench
