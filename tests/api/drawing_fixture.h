// SPDX-License-Identifier: MIT
// A set with three layers and one of own strokes, and functions that read its drawing.
#pragma once

#include "fixture.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace api_test {

constexpr std::int32_t side = 128;

struct Vertex {
    float position[3];
    float window[3];
    float radius;
    float color[4];
    std::uint32_t id;
    std::uint32_t mark_class;
    std::uint32_t is_paper;
    std::uint32_t layer;
    float length;
};

struct Vertices {
    std::vector<Vertex> vertex;
    std::vector<std::uint32_t> index;
};

inline Vertices vertices_of(const Drawing& drawing, std::uint32_t primitive) {
    Error error;
    Layout layout(primitive);
    layout.stride = sizeof(Vertex);
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, position))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, window))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, radius))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_COLOR, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, color))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_ID, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, id))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_CLASS, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, mark_class))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, is_paper))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_LAYER, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, layer))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_LENGTH, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, length));
    std::int64_t count = 0;
    std::int64_t indices = 0;
    EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), primitive, &count, &indices, error));
    Vertices all{std::vector<Vertex>(static_cast<std::size_t>(count)),
                 std::vector<std::uint32_t>(static_cast<std::size_t>(indices))};
    std::int64_t written = -1;
    std::int64_t written_indices = -1;
    EXPECT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), all.vertex.data(), count, &written,
                                             all.index.data(), indices, &written_indices, error));
    EXPECT_EQ(written, count);
    EXPECT_EQ(written_indices, indices);
    return all;
}

// Returns the strips of an array of indices, each without the restart that ends it.
inline std::vector<std::vector<std::uint32_t>> strips_of(const std::vector<std::uint32_t>& index) {
    std::vector<std::vector<std::uint32_t>> strips;
    std::vector<std::uint32_t> strip;
    for (const std::uint32_t i : index) {
        if (i != static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART)) {
            strip.push_back(i);
            continue;
        }
        strips.push_back(strip);
        strip.clear();
    }
    EXPECT_TRUE(strip.empty()) << "the last strip is not ended";
    return strips;
}

inline hrbfnpr_mark_identity identity_of(const Drawing& drawing, std::uint32_t id) {
    Error error;
    auto identity = made(hrbfnpr_mark_identity_init);
    EXPECT_OK(hrbfnpr_drawing_identify(drawing.get(), id, &identity, error));
    return identity;
}

struct Results {
    std::vector<std::uint8_t> shown;
    std::vector<float> radius, opacity;
};

inline Results results_of(const Drawing& drawing, const PointSet& set, std::int64_t layer) {
    Error error;
    const auto count = static_cast<std::size_t>(layer_info(set, layer).marks);
    Results results{std::vector<std::uint8_t>(count, 77), std::vector<float>(count, -1.0F),
                    std::vector<float>(count, -1.0F)};
    auto wanted = made(hrbfnpr_mark_results_init);
    wanted.shown = out(results.shown, 1);
    wanted.radius = out(results.radius, 1);
    wanted.opacity = out(results.opacity, 1);
    EXPECT_OK(hrbfnpr_drawing_mark_results(drawing.get(), 0, layer, &wanted, error));
    return results;
}

inline std::vector<std::uint32_t> indices_of(const Drawing& drawing, std::int64_t layer, std::uint32_t mark_class,
                                             std::uint32_t primitive) {
    Error error;
    std::int64_t count = 0;
    const hrbfnpr_status status =
        hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, layer, mark_class, primitive, nullptr, 0, &count, error);
    EXPECT_EQ(status, count == 0 ? HRBFNPR_STATUS_OK : HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(count));
    EXPECT_OK(hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, layer, mark_class, primitive, indices.data(), count,
                                                 &count, error));
    return indices;
}

// The set has three layers on a sphere, and a fourth of two own strokes: an arc along the equator and one towards the
// pole.
class DrawingTest : public testing::Test {
protected:
    static constexpr std::int64_t own = 3;
    static constexpr int arc = 40; // marks of a stroke

    DrawingTest() {
        for (int s = 0; s < 2; ++s)
            for (int i = 0; i < arc; ++i) {
                const double a = -0.6 + 1.2 * i / (arc - 1);
                place.insert(place.end(), {s == 0 ? std::sin(a) : 0.0, s == 0 ? 0.0 : std::sin(a), std::cos(a)});
            }
        auto arrays = made(hrbfnpr_layer_arrays_init);
        arrays.name = "arcs";
        arrays.position = arrays.normal = in(place);
        arrays.stroke_first = in(first, 1);
        arrays.rank = in(rank, 1);
        auto desc = made(hrbfnpr_point_set_desc_init);
        const PointSet base = generate(context, custom_sphere(context, sphere), small_desc());
        desc.base = base.get();
        desc.layers = &arrays;
        desc.layer_count = 1;
        hrbfnpr_point_set* made_set = nullptr;
        EXPECT_OK(hrbfnpr_point_set_create(context.get(), &desc, &made_set, error));
        set.reset(made_set);
        // Own strokes are red and wide, and ignore the light. All strokes are drawn as strokes.
        layers[0].name = "arcs";
        layers[0].ink[0] = 1.0F;
        layers[0].radius = 2.0F;
        layers[0].contours = 0;
        layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_STROKES;
        style.layers = layers;
        style.layer_count = 2;
        style.tone = HRBFNPR_TONE_NONE;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    }

    Drawing drawn() { return draw_item(renderer, item_of(set, &style), front_camera(side)); }
    // The pixel position of a world point.
    std::array<double, 2> pixel(const double* p) {
        const hrbfnpr_camera camera = front_camera(side);
        double eye[3] = {0, 0, 0};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                eye[row] += camera.view[4 * column + row] * (column < 3 ? p[column] : 1.0);
        return {side * (0.5 - 0.5 * camera.projection[0] * eye[0] / eye[2]),
                side * (0.5 + 0.5 * camera.projection[5] * eye[1] / eye[2])};
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    std::vector<double> place;
    std::vector<std::uint32_t> first{0, arc, 2 * arc};
    std::vector<float> rank = std::vector<float>(2 * arc, 0.99F);
    PointSet set;
    Renderer renderer = make_renderer(context);
    hrbfnpr_layer_style layers[2] = {made(hrbfnpr_layer_style_init), made(hrbfnpr_layer_style_init)};
    hrbfnpr_style style = made(hrbfnpr_style_init);
};

} // namespace api_test
