// SPDX-License-Identifier: MIT
// Tests layers drawn as hatching: their fields, and the results of a drawing for their marks.
#include "drawing_fixture.h"

#include <limits>

namespace api_test::hatching_test {
namespace {

using HatchingTest = DrawingTest;

// A point between two marks has the id of the nearest mark.
TEST_F(HatchingTest, MarkResultsMatchTheDrawnLines) {
    style.tone = HRBFNPR_TONE_NONE;
    layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_HATCH;
    const Drawing drawing = drawn();
    std::map<std::uint32_t, float> radius; // for each id that a point has
    for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS).vertex) radius[v.id] = v.radius;
    for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS).vertex)
        radius[v.id] = std::max(radius[v.id], v.radius);
    std::uint32_t next_id = 1;
    bool any = false;
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        auto described = made(hrbfnpr_drawing_layer_info_init);
        EXPECT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), layer, &described, error));
        any = any || (described.shape == HRBFNPR_SHAPE_HATCH && described.strokes > 0);
        const Results results = results_of(drawing, set, layer);
        std::int64_t shown = 0;
        for (std::size_t i = 0; i < results.shown.size(); ++i) {
            const auto found = radius.find(next_id + static_cast<std::uint32_t>(i));
            EXPECT_EQ(results.shown[i] != HRBFNPR_CLASS_NONE, found != radius.end()) << i;
            if (found == radius.end()) continue;
            EXPECT_LE(results.radius[i], found->second);
            shown += results.shown[i] == HRBFNPR_CLASS_FRONT ? 1 : 0;
        }
        const auto points = indices_of(drawing, layer, HRBFNPR_CLASS_FRONT, HRBFNPR_PRIMITIVE_POINTS);
        EXPECT_EQ(static_cast<std::int64_t>(points.size()), shown) << "each mark once";
        next_id += static_cast<std::uint32_t>(results.shown.size());
    }
    EXPECT_TRUE(any);
}

} // namespace
} // namespace api_test::hatching_test
