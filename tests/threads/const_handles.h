// SPDX-License-Identifier: MIT
// The handles that the threads of const_test.cpp share.
#pragma once

#include "host/session.h"
#include "support/meshes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace host_test {

inline constexpr std::int32_t picture_size = 48;

inline Drawing drawing_of(const Context& context, const PointSet& marks) {
    scenes::Check check;
    hrbfnpr_renderer* raw = nullptr;
    check(hrbfnpr_renderer_create(context.get(), &raw, check.error()));
    const Renderer renderer(raw);
    auto layer = made(hrbfnpr_layer_style_init);
    layer.shape = HRBFNPR_SHAPE_STROKES;
    auto style = made(hrbfnpr_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    auto item = made(hrbfnpr_item_init);
    item.point_set = marks.get();
    item.style = &style;
    auto camera = made(hrbfnpr_camera_init);
    const double low[3] = {-1.5, -1.5, -0.5}, high[3] = {1.5, 1.5, 0.5}, direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    check(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, picture_size, picture_size, 0.02,
                                    check.error()));
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_renderer_draw(raw, &item, 1, 0, &camera, &drawing, check.error()));
    return Drawing(drawing);
}

inline LineSet line_set_of(const Context& context, const Model& model) {
    scenes::Check check;
    hrbfnpr_line_set* lines = nullptr;
    check(hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &lines, check.error()));
    return LineSet(lines);
}

// An item with a light that casts shadows.
struct LitItem {
    explicit LitItem(const PointSet& marks, const LineSet& lines) {
        light.space = HRBFNPR_LIGHT_WORLD;
        light.shadow = 1.0F;
        light.softness = 0.1F;
        style.lights = &light;
        style.light_count = 1;
        item.point_set = marks.get();
        item.line_set = lines.get();
        item.style = &style;
    }
    LitItem(const LitItem&) = delete;
    LitItem& operator=(const LitItem&) = delete;

    hrbfnpr_light light = made(hrbfnpr_light_init);
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_item item = made(hrbfnpr_item_init);
};

inline hrbfnpr::test::Occluders occluders_of(const Context& context, const PointSet& marks, const LineSet& lines) {
    scenes::Check check;
    const LitItem lit(marks, lines);
    hrbfnpr_occluders* occluders = nullptr;
    check(hrbfnpr_occluders_create(context.get(), &lit.item, 1, 0, nullptr, &occluders, check.error()));
    return hrbfnpr::test::Occluders(occluders);
}

inline hrbfnpr::test::Shading shading_of(const Context& context, const hrbfnpr::test::Occluders& occluders,
                                         const PointSet& marks, const LineSet& lines) {
    scenes::Check check;
    const LitItem lit(marks, lines);
    hrbfnpr_shading* shading = nullptr;
    check(hrbfnpr_shading_create(context.get(), occluders.get(), &lit.item, nullptr, nullptr, nullptr, &shading,
                                 check.error()));
    return hrbfnpr::test::Shading(shading);
}

// A field that has the values 1, 2 and 3 at three points.
inline hrbfnpr_field* make_field(const Context& context, hrbfnpr_error* error, hrbfnpr_status& status) {
    static constexpr double points[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, values[3] = {1, 2, 3};
    auto desc = made(hrbfnpr_field_desc_init);
    desc.points = {points, 3, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.values = {values, 3, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    hrbfnpr_field* field = nullptr;
    status = hrbfnpr_field_create(context.get(), &desc, nullptr, &field, error);
    return field;
}

inline hrbfnpr::test::Field field_of(const Context& context) {
    scenes::Check check;
    hrbfnpr_status status = HRBFNPR_STATUS_OK;
    hrbfnpr::test::Field field(make_field(context, check.error(), status));
    check(status);
    return field;
}

// The marks with a field "a".
inline hrbfnpr_point_set* make_marks_with_field(const Context& context, const PointSet& marks,
                                                const hrbfnpr::test::Field& field, hrbfnpr_error* error,
                                                hrbfnpr_status& status) {
    auto named = made(hrbfnpr_mark_field_init);
    named.name = "a";
    named.field = field.get();
    hrbfnpr_point_set* set = nullptr;
    status = hrbfnpr_point_set_with_fields(context.get(), marks.get(), &named, 1, 0, nullptr, &set, error);
    return set;
}

inline PointSet marks_with_field(const Context& context, const PointSet& marks, const hrbfnpr::test::Field& field) {
    scenes::Check check;
    hrbfnpr_status status = HRBFNPR_STATUS_OK;
    PointSet set(make_marks_with_field(context, marks, field, check.error(), status));
    check(status);
    return set;
}

inline hrbfnpr::test::Mesh mesh_of(const Context& context) {
    scenes::Check check;
    const hrbfnpr::test::Triangles from = hrbfnpr::test::icosphere(2);
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = {from.vertices.data(), static_cast<std::int64_t>(from.vertices.size() / 3), 0,
                     HRBFNPR_SCALAR_FLOAT64, 3};
    desc.triangles = {from.triangles.data(), static_cast<std::int64_t>(from.faces()), 0, HRBFNPR_SCALAR_INT32, 3};
    hrbfnpr_mesh* mesh = nullptr;
    check(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &mesh, check.error()));
    return hrbfnpr::test::Mesh(mesh);
}

inline hrbfnpr_picture_desc picture_desc_of(const hrbfnpr_change& change) {
    auto desc = made(hrbfnpr_picture_desc_init);
    desc.flags = HRBFNPR_PICTURE_ALLOW_BLANK;
    desc.width = desc.height = picture_size;
    desc.changes = &change;
    desc.change_count = 1;
    return desc;
}

inline hrbfnpr_change few_marks() {
    auto change = made(hrbfnpr_change_init);
    change.field = "marks.layers.budget";
    change.value = "200";
    return change;
}

inline hrbfnpr::test::Picture picture_of(const Context& context, const Model& model) {
    scenes::Check check;
    const hrbfnpr_change change = few_marks();
    auto source = made(hrbfnpr_picture_source_init);
    source.model = model.get();
    hrbfnpr_picture_desc desc = picture_desc_of(change);
    desc.sources = &source;
    desc.source_count = 1;
    hrbfnpr_picture* picture = nullptr;
    check(hrbfnpr_picture_create(context.get(), &desc, nullptr, &picture, check.error()));
    return hrbfnpr::test::Picture(picture);
}

// Makes another picture of the same surface.
inline hrbfnpr_status restyle(const hrbfnpr_picture* picture, hrbfnpr::test::Picture& to, hrbfnpr_error* error) {
    const hrbfnpr_change change = few_marks();
    const hrbfnpr_picture_desc desc = picture_desc_of(change);
    hrbfnpr_picture* made = nullptr;
    const hrbfnpr_status status = hrbfnpr_picture_restyle(picture, &desc, nullptr, &made, error);
    to.reset(made);
    return status;
}

inline Drawing drawing_of(hrbfnpr_picture* picture) {
    scenes::Check check;
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_picture_draw(picture, nullptr, nullptr, &drawing, check.error()));
    return Drawing(drawing);
}

inline hrbfnpr::test::Settings settings_of(const Context& context) {
    static constexpr char text[] = R"({"hrbfnpr-settings": 1, "preset": "stipple"})";
    struct Reader {
        const char* next = text;
        static std::int64_t read(void* user, void* to, std::uint64_t size) {
            auto& self = *static_cast<Reader*>(user);
            const std::size_t count = std::min<std::size_t>(size, std::strlen(self.next));
            std::memcpy(to, self.next, count);
            self.next += count;
            return static_cast<std::int64_t>(count);
        }
    };
    scenes::Check check;
    Reader reader;
    hrbfnpr_settings* settings = nullptr;
    check(hrbfnpr_settings_load(context.get(), Reader::read, &reader, &settings, check.error()));
    return hrbfnpr::test::Settings(settings);
}

} // namespace host_test
