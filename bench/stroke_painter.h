// SPDX-License-Identifier: MIT
// Strokes of a drawing as the library writes them, and the ink coverage of each pixel.
#pragma once

#include "calls.h"
#include "drawn_stroke.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

// A renderer with one point set and its style, and a line set if there is one.
class StrokePainter {
public:
    StrokePainter(hrbfnpr_context* context, const hrbfnpr_point_set* set, const Style& style,
                  const hrbfnpr_line_set* lines = nullptr)
        : style_(style) {
        hrbfnpr_renderer* raw = nullptr;
        check_(hrbfnpr_renderer_create(context, &raw, check_.error()));
        renderer_.reset(raw);
        item_.point_set = set;
        item_.style = style_.get();
        item_.line_set = lines;
    }
    StrokePainter(const StrokePainter&) = delete;
    StrokePainter& operator=(const StrokePainter&) = delete;

    void draw(const hrbfnpr_camera& camera) {
        drawing_.reset();
        hrbfnpr_drawing* drawing = nullptr;
        check_(hrbfnpr_renderer_draw(renderer_.get(), &item_, 1, 0, &camera, &drawing, check_.error()));
        drawing_.reset(drawing);
    }
    [[nodiscard]] const hrbfnpr_drawing* drawing() const { return drawing_.get(); }
    // Returns the strokes of the last drawing; strokes from line sets have no marks.
    [[nodiscard]] std::vector<DrawnStroke> strokes() {
        constexpr std::uint32_t primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
        std::int64_t vertices = 0;
        std::int64_t indices = 0;
        check_(hrbfnpr_drawing_vertex_bound(drawing_.get(), primitive, &vertices, &indices, check_.error()));
        std::vector<StrokePoint> points(static_cast<std::size_t>(vertices));
        std::vector<std::uint32_t> order(static_cast<std::size_t>(indices));
        const hrbfnpr_vertex_layout layout = layout_of_point();
        check_(hrbfnpr_drawing_write_vertices(drawing_.get(), &layout, points.data(), vertices, &vertices, order.data(),
                                              indices, &indices, check_.error()));
        std::vector<DrawnStroke> strokes;
        bool begins = true;
        for (std::int64_t i = 0; i < indices; ++i) {
            const std::uint32_t index = order[static_cast<std::size_t>(i)];
            if (begins) strokes.emplace_back();
            begins = index == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART);
            if (!begins) strokes.back().push_back(points[index]);
        }
        return strokes;
    }
    // Returns the number of dots in the drawing.
    [[nodiscard]] std::int64_t dots() {
        std::int64_t count = 0;
        check_(hrbfnpr_drawing_vertex_bound(drawing_.get(), HRBFNPR_PRIMITIVE_POINTS, &count, nullptr, check_.error()));
        return count;
    }
    // Returns the share of each pixel that ink covers.
    [[nodiscard]] std::vector<float> coverage(int width, int height) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        auto image = scenes::made(hrbfnpr_image_init);
        image.format = HRBFNPR_FORMAT_COVERAGE8;
        image.width = width;
        image.height = height;
        image.pixels = bytes.data();
        check_(hrbfnpr_drawing_rasterize(drawing_.get(), &image, nullptr, check_.error()));
        std::vector<float> share;
        share.reserve(bytes.size());
        for (const std::uint8_t byte : bytes) share.push_back(static_cast<float>(byte) / 255.0F);
        return share;
    }

private:
    [[nodiscard]] hrbfnpr_vertex_layout layout_of_point() {
        auto layout = scenes::made(hrbfnpr_vertex_layout_init);
        layout.primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
        layout.stride = sizeof(StrokePoint);
        layout.attributes = attributes_.data();
        layout.attribute_count = static_cast<std::int64_t>(attributes_.size());
        constexpr std::array<std::uint32_t, 3> which{HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_VERTEX_ATTRIBUTE_RADIUS,
                                                     HRBFNPR_VERTEX_ATTRIBUTE_ID};
        constexpr std::array<std::size_t, 3> at{offsetof(StrokePoint, x), offsetof(StrokePoint, radius),
                                                offsetof(StrokePoint, id)};
        for (std::size_t i = 0; i < which.size(); ++i) {
            attributes_[i] = scenes::made(hrbfnpr_vertex_attribute_init);
            attributes_[i].attribute = which[i];
            attributes_[i].scalar = i < 2 ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_UINT32;
            attributes_[i].offset = static_cast<std::uint32_t>(at[i]);
        }
        return layout;
    }

    scenes::Check check_;
    scenes::Renderer renderer_;
    scenes::Drawing drawing_;
    Style style_;
    hrbfnpr_item item_ = scenes::made(hrbfnpr_item_init);
    std::array<hrbfnpr_vertex_attribute, 3> attributes_{};
};

} // namespace bench
