// A renderer with one point set, its style and an image.
#pragma once

#include "calls.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

// A disc as the library hands it over.
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
    Painter(hrbfnpr_context* context, const hrbfnpr_point_set* set, const hrbfnpr_style& style, int width = 0,
            int height = 0)
        : style_(style), pixels_(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        hrbfnpr_renderer* raw = nullptr;
        check_(hrbfnpr_renderer_create(context, &raw, check_.error()));
        renderer_.reset(raw);
        check_(hrbfnpr_item_init(&item_, sizeof item_));
        item_.point_set = set;
        item_.style = &style_;
        check_(hrbfnpr_image_init(&image_, sizeof image_));
        image_.format = HRBFNPR_FORMAT_RGBA8;
        image_.width = width;
        image_.height = height;
        image_.pixels = pixels_.data();
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    void use(const hrbfnpr_point_set* set) { item_.point_set = set; }
    void prepare(const hrbfnpr_camera& camera) {
        check_(hrbfnpr_renderer_prepare(renderer_.get(), &item_, 1, 0, &camera, nullptr, check_.error()));
    }
    void draw(const hrbfnpr_camera& camera) {
        prepare(camera);
        check_(hrbfnpr_renderer_draw_image(renderer_.get(), &image_, nullptr, check_.error()));
    }
    [[nodiscard]] const std::vector<Disc>& discs(const hrbfnpr_camera& camera) {
        prepare(camera);
        std::int64_t count = 0;
        check_(hrbfnpr_renderer_vertex_bound(renderer_.get(), &count, check_.error()));
        discs_.resize(static_cast<std::size_t>(count));
        const hrbfnpr_vertex_layout layout = layout_of_disc();
        check_(hrbfnpr_renderer_write_vertices(renderer_.get(), &layout, discs_.data(), count, &count, check_.error()));
        discs_.resize(static_cast<std::size_t>(count));
        return discs_;
    }
    [[nodiscard]] hrbfnpr_drawing_info info() {
        hrbfnpr_drawing_info info;
        check_(hrbfnpr_drawing_info_init(&info, sizeof info));
        check_(hrbfnpr_renderer_get_info(renderer_.get(), &info, check_.error()));
        return info;
    }
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return pixels_; }
    [[nodiscard]] std::vector<std::uint8_t>& pixels() { return pixels_; }

private:
    [[nodiscard]] hrbfnpr_vertex_layout layout_of_disc() {
        hrbfnpr_vertex_layout layout;
        check_(hrbfnpr_vertex_layout_init(&layout, sizeof layout));
        layout.stride = sizeof(Disc);
        const auto add = [&](std::uint32_t attribute, std::uint32_t scalar, std::size_t offset) {
            layout.attributes[layout.attribute_count++] = {attribute, scalar, static_cast<std::uint32_t>(offset), 0};
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
    hrbfnpr_style style_;
    hrbfnpr_item item_{};
    hrbfnpr_image image_{};
    std::vector<std::uint8_t> pixels_;
    std::vector<Disc> discs_;
};

} // namespace bench
