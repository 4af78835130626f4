// SPDX-License-Identifier: MIT
// Stages of frames, of functions that read drawings, and of pages.
#include "stages/stages.h"

#include <array>
#include <cstring>

namespace api_test {
namespace {

// The memory is allocated before the call, so that no request within the call is the test's own.
struct Text {
    std::vector<char> room = std::vector<char>(std::size_t{4} << 20);
    std::size_t used = 0;

    static std::int32_t write(void* user, const void* data, std::uint64_t size) {
        auto& self = *static_cast<Text*>(user);
        if (self.used + size > self.room.size()) return 1;
        std::memcpy(self.room.data() + self.used, data, size);
        self.used += size;
        return 0;
    }
};

hrbfnpr_image image_in(std::vector<std::uint8_t>& pixels, std::uint32_t format, std::int32_t side, int bytes) {
    auto image = made(hrbfnpr_image_init);
    pixels.assign(static_cast<std::size_t>(bytes) * static_cast<std::size_t>(side * side), 0);
    image.format = format;
    image.width = image.height = side;
    image.pixels = pixels.data();
    return image;
}

void append_pixels(Bytes& bytes, const hrbfnpr_drawing* drawing, std::int32_t side) {
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_in(pixels, HRBFNPR_FORMAT_RGBA8, side, 4);
    EXPECT_EQ(hrbfnpr_drawing_rasterize(drawing, &image, nullptr, nullptr), HRBFNPR_STATUS_OK);
    append(bytes, pixels);
}

} // namespace

hrbfnpr_camera Stages::camera() const { return front_camera(sizes_.pixels); }

void Stages::renew_renderer() { renderer_ = make_renderer(context_); }

void Stages::add_frame(std::vector<Stage>& stages, const std::string& name, const hrbfnpr_style& style, bool lines,
                       std::uint32_t sides, const hrbfnpr_shading* shading) {
    add(
        stages, name,
        [this, style, lines, sides, shading](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
            const hrbfnpr_camera view = camera();
            auto item = made(hrbfnpr_item_init);
            item.point_set = set_.get();
            item.style = &style;
            item.sides = sides;
            item.shading = shading;
            if (lines) item.line_set = curved_lines_.get();
            hrbfnpr_drawing* drawing = nullptr;
            const auto status = attempt([&] {
                return hrbfnpr_renderer_draw_with_operation(renderer_.get(), &item, 1, 0, &view, attempt.operation,
                                                            &drawing, error);
            });
            EXPECT_EQ(drawing != nullptr, status == HRBFNPR_STATUS_OK);
            if (const Drawing owned(drawing); owned) append_pixels(bytes, drawing, sizes_.pixels);
            return status;
        },
        [this] { renew_renderer(); });
}

void Stages::add_frames(std::vector<Stage>& stages) {
    constexpr std::array<std::pair<std::uint32_t, const char*>, 3> shapes{{{HRBFNPR_SHAPE_DOTS, "frame.dots"},
                                                                           {HRBFNPR_SHAPE_STROKES, "frame.strokes"},
                                                                           {HRBFNPR_SHAPE_HATCH, "frame.hatch"}}};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        layer_styles_[i] = made(hrbfnpr_layer_style_init);
        layer_styles_[i].shape = shapes[i].first;
        auto style = made(hrbfnpr_style_init);
        style.layers = &layer_styles_[i];
        style.layer_count = 1;
        add_frame(stages, shapes[i].second, style, false);
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
        add_frame(stages, std::string(shapes[i].second) + ".hidden", style, false);
        if (shapes[i].first == HRBFNPR_SHAPE_HATCH)
            add_frame(stages, "frame.both_sides", style, false, HRBFNPR_SIDES_BOTH);
    }
    auto published = made(hrbfnpr_style_init);
    published.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    add_frame(stages, "frame.published", published, false);
    const std::array<std::uint32_t, 4> kinds{HRBFNPR_LINE_KIND_CONTOUR, HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR,
                                             HRBFNPR_LINE_KIND_RIDGE, HRBFNPR_LINE_KIND_APPARENT_RIDGE};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        line_styles_[i] = made(hrbfnpr_line_style_init);
        line_styles_[i].kind = kinds[i];
    }
    line_styles_[0].hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
    auto style = made(hrbfnpr_style_init);
    style.lines = line_styles_.data();
    style.line_count = 1;
    add_frame(stages, "frame.contours", style, true);
    style.line_count = static_cast<std::int64_t>(kinds.size());
    add_frame(stages, "frame.lines", style, true);
    add(stages, "renderer", [this](Attempt& attempt, Bytes&, hrbfnpr_error* error) {
        hrbfnpr_renderer* renderer = nullptr;
        const auto status = attempt([&] { return hrbfnpr_renderer_create(context_.get(), &renderer, error); });
        EXPECT_EQ(renderer != nullptr, status == HRBFNPR_STATUS_OK);
        hrbfnpr_renderer_release(renderer);
        return status;
    });
}

// Marks and lines with two lights that cast shadows, and a sky.
hrbfnpr_item Stages::lit_item() {
    for (hrbfnpr_light& light : lights_) {
        light = made(hrbfnpr_light_init);
        light.intensity = 0.5F;
        light.shadow = 1.0F;
    }
    lights_[1].kind = HRBFNPR_LIGHT_KIND_PLACE;
    lights_[1].space = HRBFNPR_LIGHT_ITEM;
    lights_[1].place[0] = 4.0;
    lights_[1].softness = 0.2F;
    lit_style_ = made(hrbfnpr_style_init);
    lit_style_.lights = lights_.data();
    lit_style_.light_count = static_cast<std::int64_t>(lights_.size());
    lit_style_.ambient_sky = 0.3F;
    for (auto [line, kind] : {std::pair{&shadow_lines_[0], HRBFNPR_LINE_KIND_SHADOW},
                              std::pair{&shadow_lines_[1], HRBFNPR_LINE_KIND_TERMINATOR}}) {
        *line = made(hrbfnpr_line_style_init);
        line->kind = kind;
    }
    lit_style_.lines = shadow_lines_.data();
    lit_style_.line_count = static_cast<std::int64_t>(shadow_lines_.size());
    auto item = item_of(set_, &lit_style_);
    item.line_set = curved_lines_.get();
    return item;
}

// Makes the occluders and the shading that all stages share.
void Stages::make_shading() {
    Error error;
    const hrbfnpr_item item = lit_item();
    const hrbfnpr_camera view = camera();
    hrbfnpr_occluders* occluders = nullptr;
    EXPECT_OK(hrbfnpr_occluders_create(context_.get(), &item, 1, 0, nullptr, &occluders, error));
    occluders_.reset(occluders);
    hrbfnpr_shading* shading = nullptr;
    EXPECT_OK(hrbfnpr_shading_create(context_.get(), occluders, &item, &view, nullptr, nullptr, &shading, error));
    shading_.reset(shading);
}

void Stages::add_lights(std::vector<Stage>& stages) {
    make_shading();
    const hrbfnpr_item item = lit_item();
    const hrbfnpr_camera view = camera();
    const auto append_drawn = [this, item, view](Bytes& bytes, const hrbfnpr_shading* shading) {
        hrbfnpr_item shaded = item;
        shaded.shading = shading;
        append_pixels(bytes, draw_item(make_renderer(context_), shaded, view).get(), sizes_.pixels);
    };
    add(stages, "light.occluders", [=, this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr_occluders* occluders = nullptr;
        const auto status = attempt([&] {
            return hrbfnpr_occluders_create(context_.get(), &item, 1, 0, attempt.operation, &occluders, error);
        });
        EXPECT_EQ(occluders != nullptr, status == HRBFNPR_STATUS_OK);
        const Occluders owned(occluders);
        if (!owned) return status;
        hrbfnpr_shading* shading = nullptr;
        EXPECT_EQ(hrbfnpr_shading_create(context_.get(), occluders, &item, &view, nullptr, nullptr, &shading, nullptr),
                  HRBFNPR_STATUS_OK);
        append_drawn(bytes, Shading(shading).get());
        return status;
    });
    const auto add_shading = [&](const char* name, const hrbfnpr_shading* previous) {
        add(stages, name, [=, this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
            auto desc = made(hrbfnpr_shading_desc_init);
            desc.previous = previous;
            desc.flags = HRBFNPR_SHADING_WITH_LINES;
            hrbfnpr_shading* shading = nullptr;
            const auto status = attempt([&] {
                return hrbfnpr_shading_create(context_.get(), occluders_.get(), &item, &view, &desc, attempt.operation,
                                              &shading, error);
            });
            EXPECT_EQ(shading != nullptr, status == HRBFNPR_STATUS_OK);
            const Shading owned(shading);
            if (owned) append_drawn(bytes, shading);
            return status;
        });
    };
    add_shading("light.shading", nullptr);
    add_shading("light.moved", shading_.get());
    add_frame(stages, "frame.shaded", lit_style_, true, HRBFNPR_SIDES_FRONT, shading_.get());
}

// Strokes and contours whose hidden parts are dashed.
const hrbfnpr_drawing* Stages::drawing() {
    if (drawing_) return drawing_.get();
    auto layer = made(hrbfnpr_layer_style_init);
    layer.shape = HRBFNPR_SHAPE_STROKES;
    auto line = made(hrbfnpr_line_style_init);
    line.hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
    auto style = made(hrbfnpr_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    style.lines = &line;
    style.line_count = 1;
    auto item = item_of(set_, &style);
    item.line_set = curved_lines_.get();
    drawing_ = draw_item(make_renderer(context_), item, camera());
    return drawing_.get();
}

void Stages::add_readers(std::vector<Stage>& stages) {
    const auto add_image = [&](const char* name, std::uint32_t format, int pixel_bytes) {
        add(stages, name, [this, format, pixel_bytes](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
            std::vector<std::uint8_t> pixels;
            const hrbfnpr_image image = image_in(pixels, format, sizes_.pixels, pixel_bytes);
            const auto count = static_cast<std::size_t>(sizes_.pixels * sizes_.pixels);
            std::vector<float> depth(count);
            std::vector<std::uint32_t> id(count);
            auto desc = made(hrbfnpr_raster_desc_init);
            desc.depth = out(depth, 1);
            desc.id = out(id, 1);
            const auto status = attempt([&] { return hrbfnpr_drawing_rasterize(drawing(), &image, &desc, error); });
            if (status == HRBFNPR_STATUS_OK) append(bytes, pixels), append(bytes, depth), append(bytes, id);
            return status;
        });
    };
    add_image("image.bytes", HRBFNPR_FORMAT_RGBA8, 4);
    add_image("image.floats", HRBFNPR_FORMAT_RGBA32F, 16);
    add_image("image.coverage", HRBFNPR_FORMAT_COVERAGE8, 1);
    for (const auto& [primitive, name] :
         {std::pair<std::uint32_t, const char*>{HRBFNPR_PRIMITIVE_POINTS, "vertices.points"},
          std::pair<std::uint32_t, const char*>{HRBFNPR_PRIMITIVE_LINE_STRIPS, "vertices.lines"},
          std::pair<std::uint32_t, const char*>{HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS, "vertices.triangles"}})
        add(stages, name,
            [this, kind = std::uint32_t{primitive}](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
                Layout layout(kind);
                layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
                layout.add(HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, 12);
                const hrbfnpr_vertex_layout* wanted = layout.get();
                std::int64_t count = 0, indices = 0, written = 0;
                EXPECT_EQ(hrbfnpr_drawing_vertex_bound(drawing(), kind, &count, &indices, nullptr), HRBFNPR_STATUS_OK);
                std::vector<float> vertex(static_cast<std::size_t>(4 * count));
                std::vector<std::uint32_t> index(static_cast<std::size_t>(indices)), mark(100000);
                auto status = attempt([&] {
                    return hrbfnpr_drawing_write_vertices(drawing(), wanted, vertex.data(), count, nullptr,
                                                          index.data(), indices, nullptr, error);
                });
                if (status != HRBFNPR_STATUS_OK) return status;
                status = attempt([&] {
                    return hrbfnpr_drawing_write_mark_indices(drawing(), 0, 1, HRBFNPR_CLASS_FRONT, kind, mark.data(),
                                                              100000, &written, error);
                });
                if (status == HRBFNPR_STATUS_OK) append(bytes, vertex), append(bytes, index), append(bytes, mark);
                return status;
            });
    add(stages, "mark_results", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        const auto count = static_cast<std::size_t>(layer_info(set_, 0).marks);
        std::vector<float> radius(count), opacity(count);
        auto results = made(hrbfnpr_mark_results_init);
        results.radius = out(radius, 1);
        results.opacity = out(opacity, 1);
        const auto status = attempt([&] { return hrbfnpr_drawing_mark_results(drawing(), 0, 0, &results, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, radius), append(bytes, opacity);
        return status;
    });
}

void Stages::add_page(std::vector<Stage>& stages, const char* name, std::uint32_t format, std::uint32_t flags) {
    add(stages, name, [this, format, flags](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto item = made(hrbfnpr_page_item_init);
        item.drawing = drawing();
        auto pen = made(hrbfnpr_pen_init);
        pen.line_type = HRBFNPR_LINE_TYPE_DASHED;
        pen.groups = "contour hidden*";
        auto note = made(hrbfnpr_annotation_init);
        const std::vector<double> at{1.0, 2.0};
        note.text = "A";
        note.points = in(at, 2);
        auto desc = made(hrbfnpr_page_desc_init);
        desc.format = format;
        desc.flags = flags;
        desc.title = "stage";
        desc.items = &item;
        desc.item_count = 1;
        desc.pens = &pen;
        desc.pen_count = 1;
        desc.annotations = &note;
        desc.annotation_count = 1;
        Text text;
        const auto status = attempt([&] {
            return hrbfnpr_page_write(context_.get(), &desc, Text::write, &text, nullptr, attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) {
            text.room.resize(text.used);
            append(bytes, text.room);
        }
        return status;
    });
}

void Stages::add_pages(std::vector<Stage>& stages) {
    add_page(stages, "page.svg", HRBFNPR_PAGE_FORMAT_SVG, 0);
    add_page(stages, "page.svg.plot", HRBFNPR_PAGE_FORMAT_SVG, HRBFNPR_PAGE_IN_PLOT_ORDER);
    add_page(stages, "page.pdf", HRBFNPR_PAGE_FORMAT_PDF, 0);
    add_page(stages, "page.hpgl", HRBFNPR_PAGE_FORMAT_HPGL, 0);
    add_page(stages, "page.gcode", HRBFNPR_PAGE_FORMAT_GCODE, 0);
    add_page(stages, "page.dxf", HRBFNPR_PAGE_FORMAT_DXF, 0);
}

} // namespace api_test
