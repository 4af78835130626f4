// SPDX-License-Identifier: MIT
// Tests the assignment of stroke segments to tiles.
#include "base/random.h"
#include "base/runtime.h"
#include "drawing/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hrbfnpr::testing::segments_test {
namespace {

using drawing::Drawing;
using drawing::StrokePoint;

constexpr int width = 640;
constexpr int height = 384;

class SegmentTiles : public ::testing::Test {
protected:
    SegmentTiles() : drawing(runtime.memory) {
        drawing.dot_tiles.build(runtime.parallel, width, height, {}, [](std::int64_t, auto&) { return false; });
    }
    void add_stroke(const StrokePoint& a, const StrokePoint& b) {
        drawing::Stroke stroke;
        stroke.first = drawing.points.size();
        stroke.count = 2;
        drawing.strokes.push_back(stroke);
        drawing.points.push_back(a);
        drawing.points.push_back(b);
        drawing.points.back().length = 1.0F;
    }
    static StrokePoint point(double x, double y, double radius) {
        StrokePoint p{};
        p.x = static_cast<float>(x);
        p.y = static_cast<float>(y);
        p.radius = static_cast<float>(radius);
        return p;
    }
    // The indices of the tiles that contain a segment.
    std::vector<std::int64_t> tiles_of(std::uint32_t segment) const {
        std::vector<std::int64_t> tiles;
        for (std::int64_t tile = 0; tile < drawing.segment_tiles.tiles(); ++tile)
            drawing.segment_tiles.for_tile(tile, [&](std::uint32_t i) {
                if (i == segment) tiles.push_back(tile);
            });
        return tiles;
    }

    base::Runtime runtime;
    Drawing drawing;
};

TEST_F(SegmentTiles, AreTheTilesThatAStraightSegmentPasses) {
    add_stroke(point(70.0, 96.0, 1.0), point(380.0, 96.0, 1.0));
    add_stroke(point(96.0, 70.0, 1.0), point(96.0, 120.0, 1.0));
    drawing::bin_segments(runtime.parallel, drawing);
    EXPECT_EQ(tiles_of(0), (std::vector<std::int64_t>{11, 12, 13, 14, 15}));
    EXPECT_EQ(tiles_of(2), (std::vector<std::int64_t>{11}));
}

TEST_F(SegmentTiles, ContainEveryCoveredPixel) {
    constexpr std::uint64_t count = 200;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto u = base::uniform4(1, i, base::Purpose::candidate);
        const auto v = base::uniform4(2, i, base::Purpose::candidate);
        const double radius = 12.0 * v[0] * v[0];
        add_stroke(point(width * (1.2 * u[0] - 0.1), height * (1.2 * u[1] - 0.1), radius),
                   point(width * (1.2 * u[2] - 0.1), height * (1.2 * u[3] - 0.1), radius * v[1]));
    }
    drawing::bin_segments(runtime.parallel, drawing);
    for (std::uint32_t s = 0; s < 2 * count; s += 2) {
        const std::vector<std::int64_t> tiles = tiles_of(s);
        const StrokePoint& a = drawing.points[s];
        const StrokePoint& b = drawing.points[s + 1];
        for (int y = 0; y < height; y += 3)
            for (int x = 0; x < width; x += 3) {
                float at = 0.0F;
                const auto px = static_cast<float>(x) + 0.5F;
                const auto py = static_cast<float>(y) + 0.5F;
                if (!drawing::covers({}, a, b, px, py, at)) continue;
                const std::int64_t tile =
                    y / drawing::tile_size * (width / drawing::tile_size) + x / drawing::tile_size;
                ASSERT_NE(std::find(tiles.begin(), tiles.end(), tile), tiles.end()) << s << ": " << x << ' ' << y;
            }
    }
}

} // namespace
} // namespace hrbfnpr::testing::segments_test
