// SPDX-License-Identifier: MIT
// A renderer with one point set, its style and an image.
#pragma once

#include "calls.h"
#include "timing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

// A disc, as the library writes it.
struct Disc {
    std::uint32_t id; // 1 + number of the mark
    float radius;     // pixels
    float color[4];
    std::uint32_t mark_class;
    std::uint32_t is_paper;
    float window[3]; // pixels, and depth
};

class Painter {
public:
    Painter(hrbfnpr_context* context, const hrbfnpr_point_set* set, const Style& style, int width = 0, int height = 0)
        : style_(style), pixels_(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        hrbfnpr_renderer* raw = nullptr;
        check_(hrbfnpr_renderer_create(context, &raw, check_.error()));
        renderer_.reset(raw);
        check_(hrbfnpr_item_init(&item_, sizeof item_));
        item_.point_set = set;
        item_.style = style_.get();
        check_(hrbfnpr_image_init(&image_, sizeof image_));
        image_.format = HRBFNPR_FORMAT_RGBA8;
        image_.width = width;
        image_.height = height;
        image_.pixels = pixels_.data();
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    void use(const hrbfnpr_point_set* set) { item_.point_set = set; }
    void use(const hrbfnpr_shading* shading) { item_.shading = shading; }
    // Makes the drawing without an image.
    void make_drawing(const hrbfnpr_camera& camera) {
        drawing_.reset(); // the next one reuses its memory
        hrbfnpr_drawing* drawing = nullptr;
        check_(hrbfnpr_renderer_draw(renderer_.get(), &item_, 1, 0, &camera, &drawing, check_.error()));
        drawing_.reset(drawing);
    }
    void draw(const hrbfnpr_camera& camera) {
        make_drawing(camera);
        image_ms_ =
            1e3 * seconds([&] { check_(hrbfnpr_drawing_rasterize(drawing_.get(), &image_, nullptr, check_.error())); });
    }
    [[nodiscard]] const hrbfnpr_drawing* drawing() const { return drawing_.get(); }
    [[nodiscard]] const std::vector<Disc>& discs(const hrbfnpr_camera& camera) {
        make_drawing(camera);
        std::int64_t count = 0;
        check_(hrbfnpr_drawing_vertex_bound(drawing_.get(), HRBFNPR_PRIMITIVE_POINTS, &count, nullptr, check_.error()));
        discs_.resize(static_cast<std::size_t>(count));
        const hrbfnpr_vertex_layout layout = layout_of_disc();
        check_(hrbfnpr_drawing_write_vertices(drawing_.get(), &layout, discs_.data(), count, &count, nullptr, 0,
                                              nullptr, check_.error()));
        discs_.resize(static_cast<std::size_t>(count));
        return discs_;
    }
    [[nodiscard]] hrbfnpr_drawing_info info() {
        hrbfnpr_drawing_info info;
        check_(hrbfnpr_drawing_info_init(&info, sizeof info));
        check_(hrbfnpr_drawing_get_info(drawing_.get(), &info, check_.error()));
        return info;
    }
    // The time that the last draw() took to rasterize the drawing.
    [[nodiscard]] double image_ms() const { return image_ms_; }
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return pixels_; }
    [[nodiscard]] std::vector<std::uint8_t>& pixels() { return pixels_; }

private:
    [[nodiscard]] hrbfnpr_vertex_layout layout_of_disc() {
        hrbfnpr_vertex_layout layout;
        check_(hrbfnpr_vertex_layout_init(&layout, sizeof layout));
        layout.stride = sizeof(Disc);
        layout.attributes = attributes_.data();
        const auto add = [&](std::uint32_t attribute, std::uint32_t scalar, std::size_t offset) {
            hrbfnpr_vertex_attribute& next = attributes_[static_cast<std::size_t>(layout.attribute_count++)];
            check_(hrbfnpr_vertex_attribute_init(&next, sizeof next));
            next.attribute = attribute;
            next.scalar = scalar;
            next.offset = static_cast<std::uint32_t>(offset);
        };
        add(HRBFNPR_VERTEX_ATTRIBUTE_ID, HRBFNPR_SCALAR_UINT32, offsetof(Disc, id));
        add(HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, offsetof(Disc, radius));
        add(HRBFNPR_VERTEX_ATTRIBUTE_COLOR, HRBFNPR_SCALAR_FLOAT32, offsetof(Disc, color));
        add(HRBFNPR_VERTEX_ATTRIBUTE_CLASS, HRBFNPR_SCALAR_UINT32, offsetof(Disc, mark_class));
        add(HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER, HRBFNPR_SCALAR_UINT32, offsetof(Disc, is_paper));
        add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(Disc, window));
        return layout;
    }

    scenes::Check check_;
    scenes::Renderer renderer_;
    scenes::Drawing drawing_;
    std::array<hrbfnpr_vertex_attribute, 6> attributes_{};
    double image_ms_ = 0.0;
    Style style_;
    hrbfnpr_item item_{};
    hrbfnpr_image image_{};
    std::vector<std::uint8_t> pixels_;
    std::vector<Disc> discs_;
};

} // namespace bench
