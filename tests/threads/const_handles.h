// SPDX-License-Identifier: MIT
// The handles that const_test.cpp shares between its threads.
#pragma once

#include "host/session.h"
#include "support/meshes.h"

#include <cstdint>

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

} // namespace host_test
