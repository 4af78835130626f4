// SPDX-License-Identifier: MIT
// Tests drawings by their marks, as images of every format, and with marks that have moved.
#include "drawing_fixture.h"

namespace api_test::drawing_marks_test {
namespace {

// ---- marks ---------------------------------------------------------------------------------

TEST_F(DrawingTest, MarkResultsAgreeWithTheVertices) {
    for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_STROKES}) {
        SCOPED_TRACE(shape);
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
        style.tone = HRBFNPR_TONE_LIGHT;
        layers[0].shape = layers[1].shape = shape;
        const Drawing drawing = drawn();
        std::map<std::uint32_t, std::vector<const Vertex*>> by_id;
        const Vertices points = vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS);
        const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
        for (const Vertex& v : points.vertex) by_id[v.id].push_back(&v);
        for (const Vertex& v : lines.vertex) by_id[v.id].push_back(&v);
        EXPECT_EQ(lines.vertex.empty(), shape == HRBFNPR_SHAPE_DOTS);
        std::uint32_t id = 0;
        std::int64_t shown = 0;
        for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
            const Results results = results_of(drawing, set, layer);
            for (std::size_t i = 0; i < results.shown.size(); ++i) {
                ++id;
                const auto found = by_id.find(id);
                if (found == by_id.end()) {
                    ASSERT_EQ(results.shown[i], HRBFNPR_CLASS_NONE) << id;
                    ASSERT_EQ(results.radius[i], 0.0F);
                    ASSERT_EQ(results.opacity[i], 0.0F);
                    continue;
                }
                ASSERT_EQ(found->second.size(), 1U) << "mark " << id << " is drawn more than once";
                const Vertex& v = *found->second[0];
                ASSERT_EQ(results.shown[i], v.mark_class) << id;
                ASSERT_EQ(results.radius[i], v.radius) << id;
                ASSERT_FLOAT_EQ(results.opacity[i], v.color[3]) << id;
                ++shown;
            }
        }
        EXPECT_EQ(shown, static_cast<std::int64_t>(by_id.size()));
    }
}

TEST_F(DrawingTest, MarkIndicesAreTheShownMarks) {
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
    style.tone = HRBFNPR_TONE_LIGHT;
    const Drawing drawing = drawn();
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer)
        for (const std::uint32_t mark_class : {HRBFNPR_CLASS_FRONT, HRBFNPR_CLASS_SILHOUETTE}) {
            SCOPED_TRACE(testing::Message() << layer << ", class " << mark_class);
            const Results results = results_of(drawing, set, layer);
            std::vector<std::uint32_t> points = indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_POINTS);
            const auto lines = strips_of(indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_LINE_STRIPS));
            const auto triangles = indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
            std::sort(points.begin(), points.end());
            std::vector<std::uint32_t> wanted;
            for (std::size_t i = 0; i < results.shown.size(); ++i)
                if (results.shown[i] == mark_class) wanted.push_back(static_cast<std::uint32_t>(i));
            EXPECT_EQ(points, wanted);
            const auto first_of = attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST);
            std::vector<std::uint32_t> doubled;
            for (const auto& strip : lines) {
                EXPECT_GE(strip.size(), 2U);
                for (std::size_t i = 0; i < strip.size(); ++i) {
                    EXPECT_EQ(results.shown[strip[i]], mark_class);
                    EXPECT_EQ(strip[i], strip[0] + i);
                    doubled.insert(doubled.end(), {2 * strip[i], 2 * strip[i] + 1});
                }
                const auto stroke = std::upper_bound(first_of.begin(), first_of.end(), strip[0]);
                ASSERT_NE(stroke, first_of.end());
                EXPECT_LT(strip.back(), *stroke) << "a strip goes over the end of its stroke";
                doubled.push_back(static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART));
            }
            EXPECT_EQ(triangles, doubled);
            EXPECT_TRUE(layer != stipples || lines.empty());
        }
}

TEST_F(DrawingTest, IdsAreNumberedOverItemsAndLayers) {
    const hrbfnpr_item items[2] = {item_of(set, &style), item_of(set, &style)};
    const hrbfnpr_camera camera = front_camera(side);
    hrbfnpr_drawing* raw = nullptr;
    ASSERT_OK(hrbfnpr_renderer_draw(renderer.get(), items, 2, 0, &camera, &raw, error));
    const Drawing drawing(raw);
    std::uint32_t id = 0;
    for (std::int64_t item = 0; item < 2; ++item)
        for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
            const auto stroke = attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE);
            const hrbfnpr_layer_info info = layer_info(set, layer);
            for (std::int64_t mark = 0; mark < info.marks; ++mark) {
                const hrbfnpr_mark_identity identity = identity_of(drawing, ++id);
                ASSERT_EQ(identity.id, id);
                ASSERT_EQ(identity.item, item);
                ASSERT_EQ(identity.layer, layer);
                ASSERT_EQ(identity.mark, mark);
                if (info.strokes == 0) {
                    ASSERT_EQ(identity.stroke, -1);
                    continue;
                }
                ASSERT_GE(identity.stroke, 0);
                ASSERT_LT(identity.stroke, info.strokes);
                ASSERT_EQ(identity.place, stroke[static_cast<std::size_t>(2 * mark + 1)]);
            }
        }
    auto identity = made(hrbfnpr_mark_identity_init);
    for (const std::uint32_t none : {0U, id + 1, 0xFFFFFFFFU})
        EXPECT_FAILS(hrbfnpr_drawing_identify(raw, none, &identity, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "id is ");
}

// ---- poses ---------------------------------------------------------------------------------

// Poses of all layers of a set, shifted.
struct Poses {
    std::vector<std::vector<double>> position;
    std::vector<std::vector<float>> normal;
    std::vector<hrbfnpr_layer_pose> pose;

    Poses(const PointSet& set, const std::array<double, 3>& shift) {
        const hrbfnpr_point_set_info info = info_of(set);
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            position.emplace_back();
            for (const float coordinate : attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION)) {
                const std::size_t axis = position.back().size() % 3;
                position.back().push_back(double{coordinate} + info.origin[axis] + shift[axis]);
            }
            normal.push_back(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL));
            pose.push_back(made(hrbfnpr_layer_pose_init));
            pose.back().layer = layer;
            pose.back().position = in(position.back());
            pose.back().normal = in(normal.back());
        }
    }
};

int most_different(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int{a[i]} - int{b[i]}));
    return most;
}

// Only one layer moves. It is drawn like a set that was made at the new place.
TEST_F(DrawingTest, OneLayerCanMoveAlone) {
    layers[1].shown = 0;
    const std::array<double, 3> shift{0.2, 0.1, 0.0};
    Poses poses(set, shift);
    hrbfnpr_item item = item_of(set, &style);
    item.poses = &poses.pose[own];
    item.pose_count = 1;
    const Drawing drawing = draw_item(renderer, item, front_camera(side));
    auto arrays = made(hrbfnpr_layer_arrays_init);
    arrays.name = "arcs";
    arrays.position = in(poses.position[own]);
    arrays.normal = in(poses.normal[own]);
    arrays.stroke_first = in(first, 1);
    arrays.rank = in(rank, 1);
    auto desc = made(hrbfnpr_point_set_desc_init);
    desc.layers = &arrays;
    desc.layer_count = 1;
    hrbfnpr_point_set* raw = nullptr;
    ASSERT_OK(hrbfnpr_point_set_create(context.get(), &desc, &raw, error));
    const PointSet there(raw);
    const Drawing expected = draw_item(renderer, item_of(there, &style), front_camera(side));
    EXPECT_EQ(info_of(drawing).strokes, 2);
    EXPECT_LE(most_different(rasterize(drawing, side), rasterize(expected, side)), 8);
    const std::vector<std::uint8_t> unmoved = rasterize(drawn(), side);
    EXPECT_GT(most_different(rasterize(drawing, side), unmoved), 100);
}

} // namespace
} // namespace api_test::drawing_marks_test
