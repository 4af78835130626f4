// SPDX-License-Identifier: MIT
// Draws a point set, whatever it holds: as an image, as vertices, as indices of marks.
#include "fuzz.h"
#include "support/preset_names.h"

#include <cmath>

namespace fuzz {
namespace {

constexpr int side = 32; // side of the picture, in pixels

// The set's box fills the picture. If the box has no size, that of a unit ball is used.
hrbfnpr_camera camera_for(const hrbfnpr_point_set* set) {
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    Call call("point_set_get_info");
    call.expect(hrbfnpr_point_set_get_info(set, &info, call.error()));
    const double direction[3] = {0.3, 0.2, -1};
    const double up[3] = {0, 1, 0};
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    Call fit("camera_fit_bounds");
    if (fit.expect(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.5, side, side,
                                             0.1, fit.error()),
                   {HRBFNPR_STATUS_INVALID_ARGUMENT}))
        return camera;
    const double low[3] = {-1, -1, -1};
    const double high[3] = {1, 1, 1};
    Call unit("camera_fit_bounds");
    unit.expect(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, side, side, 0.1, unit.error()));
    return camera;
}

void rasterize(const hrbfnpr_drawing* drawing) {
    std::array<std::uint8_t, 4 * side * side> pixels{};
    std::array<float, side * side> depth{};
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.width = image.height = side;
    image.pixels = pixels.data();
    hrbfnpr_raster_desc desc;
    hrbfnpr_raster_desc_init(&desc, sizeof desc);
    desc.depth = {depth.data(), static_cast<std::int64_t>(depth.size()), 0, HRBFNPR_SCALAR_FLOAT32, 1};
    Call call("drawing_rasterize");
    call.expect(hrbfnpr_drawing_rasterize(drawing, &image, &desc, call.error()));
    for (const float distance : depth) require(std::isfinite(distance), "the depth of a picture is finite");
}

// Writes the vertices of a drawing: position, normal, direction and radius.
void write_vertices(const hrbfnpr_drawing* drawing, std::uint32_t primitive) {
    constexpr std::size_t floats = 10;
    const std::array<std::uint32_t, 4> which = {HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_VERTEX_ATTRIBUTE_NORMAL,
                                                HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION, HRBFNPR_VERTEX_ATTRIBUTE_RADIUS};
    std::array<hrbfnpr_vertex_attribute, 4> attributes;
    for (std::uint32_t i = 0; i < 4; ++i) {
        hrbfnpr_vertex_attribute_init(&attributes[i], sizeof attributes[i]);
        attributes[i].attribute = which[i];
        attributes[i].scalar = HRBFNPR_SCALAR_FLOAT32;
        attributes[i].offset = 12 * i;
    }
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.primitive = primitive;
    layout.attributes = attributes.data();
    layout.attribute_count = 4;
    std::int64_t bound = 0;
    std::int64_t indices = 0;
    Call ask("drawing_vertex_bound");
    ask.expect(hrbfnpr_drawing_vertex_bound(drawing, primitive, &bound, &indices, ask.error()));
    std::vector<float> vertices(floats * static_cast<std::size_t>(bound) + 1);
    std::vector<std::uint32_t> index(static_cast<std::size_t>(indices) + 1);
    std::int64_t written = 0;
    Call call("drawing_write_vertices");
    call.expect(hrbfnpr_drawing_write_vertices(drawing, &layout, vertices.data(), bound, &written, index.data(),
                                               indices, nullptr, call.error()));
    require(written == bound, "the bound of vertices is their number");
    for (std::int64_t i = 0; i < written; ++i) {
        const float* const vertex = &vertices[floats * static_cast<std::size_t>(i)];
        require(std::isfinite(vertex[9]) && vertex[9] >= 0.0F, "the radius of a vertex is finite");
    }
    index.pop_back();
    for (const std::uint32_t i : index)
        require(i < bound || i == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART), "an index is one of a vertex");
}

// Writes the indices of the marks that are drawn.
void write_mark_indices(const hrbfnpr_drawing* drawing, const hrbfnpr_point_set* set, std::uint32_t primitive) {
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    Call ask("point_set_get_info");
    ask.expect(hrbfnpr_point_set_get_info(set, &info, ask.error()));
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        std::int64_t count = 0;
        Call measure("drawing_write_mark_indices");
        measure.expect(hrbfnpr_drawing_write_mark_indices(drawing, 0, layer, HRBFNPR_CLASS_FRONT, primitive, nullptr, 0,
                                                          &count, measure.error()),
                       {HRBFNPR_STATUS_BUFFER_TOO_SMALL});
        std::vector<std::uint32_t> index(static_cast<std::size_t>(count));
        Call call("drawing_write_mark_indices");
        call.expect(hrbfnpr_drawing_write_mark_indices(drawing, 0, layer, HRBFNPR_CLASS_FRONT, primitive, index.data(),
                                                       count, &count, call.error()));
        for (const std::uint32_t i : index)
            require(i < 2 * info.marks || i == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART),
                    "an index is one of a mark");
    }
}

} // namespace

void draw(Context& context, const hrbfnpr_point_set* set, std::uint32_t choice) {
    hrbfnpr_renderer* renderer = nullptr;
    Call create("renderer_create");
    create.expect(hrbfnpr_renderer_create(context.handle, &renderer, create.error()));
    hrbfnpr_style style;
    Call preset("style_init_preset");
    constexpr auto presets = static_cast<std::uint32_t>(std::size(hrbfnpr::testing::preset_names));
    preset.expect(hrbfnpr_style_init_preset(&style, sizeof style, choice % presets, preset.error()));
    if (choice / 16 % 2 != 0) style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    hrbfnpr_layer_style strokes;
    hrbfnpr_layer_style_init(&strokes, sizeof strokes);
    strokes.shape = choice / 64 % 2 != 0 ? HRBFNPR_SHAPE_HATCH : HRBFNPR_SHAPE_STROKES;
    if (choice / 32 % 2 != 0) {
        style.layers = &strokes;
        style.layer_count = 1;
    }
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = set;
    item.style = &style;
    const hrbfnpr_camera camera = camera_for(set);
    hrbfnpr_drawing* drawing = nullptr;
    Call call("renderer_draw");
    call.expect(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, call.error()));
    hrbfnpr_drawing_info info;
    hrbfnpr_drawing_info_init(&info, sizeof info);
    Call ask("drawing_get_info");
    ask.expect(hrbfnpr_drawing_get_info(drawing, &info, ask.error()));
    require(info.marks == info.outside + info.front + info.back + info.silhouette + info.culled,
            "every mark of a drawing has a class");
    rasterize(drawing);
    for (const std::uint32_t primitive :
         {HRBFNPR_PRIMITIVE_POINTS, HRBFNPR_PRIMITIVE_LINE_STRIPS, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS}) {
        write_vertices(drawing, primitive);
        write_mark_indices(drawing, set, primitive);
    }
    hrbfnpr_drawing_release(drawing);
    hrbfnpr_renderer_release(renderer);
}

} // namespace fuzz
