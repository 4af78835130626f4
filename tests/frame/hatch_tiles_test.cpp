// SPDX-License-Identifier: MIT
// Tests points of hatching in tiles.
#include "base/random.h"
#include "frame/hatch/points.h"

#include <gtest/gtest.h>

#include <vector>

namespace hrbfnpr::testing::hatch_tiles_test {
namespace {

// Adds points that wander over the picture, and out of it.
void add_points(drawing::Drawing& drawing, frame::HatchPoints::Batch& batch, std::uint64_t seed) {
    batch.first_dot = drawing.dots.size();
    float x = 150.0F;
    float y = 100.0F;
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const auto u = base::uniform4(seed, i, base::Purpose::candidate);
        drawing::Dot dot{};
        dot.x = x += static_cast<float>(40.0 * (u[0] - 0.5));
        dot.y = y += static_cast<float>(40.0 * (u[1] - 0.5));
        if (i % 500 == 0) dot.x = x = 10.0F + 64.0F * static_cast<float>(i / 500); // on the side of a tile
        drawing.dots.push_back(dot);
        batch.samples.sample.push_back({});
    }
}

TEST(HatchTiles, AssignEachPointToItsNearestTile) {
    const base::Runtime runtime;
    drawing::Drawing drawing(runtime.memory);
    drawing.first_pixel = {10, -20};
    drawing.dot_tiles.build(runtime.parallel, 300, 200, {}, [](std::int64_t, auto&) { return false; });
    frame::HatchTiles tiles(runtime);
    for (const std::int64_t count : {0, 3, 2}) { // also fewer than before
        base::List<frame::HatchPoints::Batch> batches(runtime.memory);
        drawing.dots.clear();
        drawing.dots.push_back({}); // a dot that is not of hatching
        for (std::int64_t i = 0; i < count; ++i)
            add_points(drawing, batches.add(runtime.memory), static_cast<std::uint64_t>(i));
        tiles.build({batches.begin(), static_cast<std::size_t>(count)}, drawing);
        for (std::int64_t tile = 0; tile < drawing.dot_tiles.tiles(); ++tile) {
            const drawing::Tiles::Extent extent = drawing.dot_tiles.own_extent(tile);
            std::vector<std::int64_t> expected, found;
            for (std::int64_t i = 1; i < drawing.dots.size(); ++i)
                if (extent.holds(drawing.dots[i].x - 10.0F, drawing.dots[i].y + 20.0F)) expected.push_back(i);
            tiles.for_tile(tile, [&](std::int64_t i) { found.push_back(i); });
            EXPECT_EQ(found, expected) << tile << " of " << count;
            EXPECT_EQ(expected.empty(), count == 0) << tile;
        }
    }
}

} // namespace
} // namespace hrbfnpr::testing::hatch_tiles_test
