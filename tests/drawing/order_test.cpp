// SPDX-License-Identifier: MIT
// Tests the order by depth, and tiles.
#include "base/random.h"
#include "drawing/drawing.h"
#include "drawing/tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace hrbfnpr::testing::order_test {
namespace {

using drawing::DepthSort;
using drawing::Tiles;

TEST(FarFirstKey, RisesAsDepthFalls) {
    const float depths[] = {
        std::numeric_limits<float>::infinity(), 1e30F, 2.0F, 1.0F, 1e-30F, 0.0F, -1e-30F, -1.0F, -1e30F};
    for (std::size_t i = 0; i + 1 < std::size(depths); ++i)
        EXPECT_LT(drawing::far_first_key(depths[i], 7), drawing::far_first_key(depths[i + 1], 3));
    EXPECT_EQ(drawing::far_first_key(1.0F, 0xFFFFFFFFU) & 0xFFFFFFFFU, 0xFFFFFFFFU);
}

TEST(FarToNearSort, IsAStableSort) {
    base::Memory memory;
    for (const int threads : {1, 3}) {
        const base::Parallel parallel(threads, nullptr, nullptr);
        DepthSort order(memory);
        for (const std::int64_t count : {0, 1, 2, 1000, 100000}) {
            base::Array<std::uint64_t> keys(memory);
            for (std::int64_t i = 0; i < count; ++i) {
                const auto u = base::uniform4(3, static_cast<std::uint64_t>(i), base::Purpose::candidate);
                // There are few different depths, so that ties occur.
                const float depth = std::floor(static_cast<float>(u[0] * 500.0 - 250.0)) * 0.25F;
                keys.push_back(drawing::far_first_key(depth, static_cast<std::uint32_t>(i)));
            }
            std::vector<std::uint64_t> expected(keys.begin(), keys.end());
            std::stable_sort(expected.begin(), expected.end(),
                             [](std::uint64_t a, std::uint64_t b) { return a >> 32U < b >> 32U; });
            order.sort(parallel, keys);
            EXPECT_TRUE(std::equal(expected.begin(), expected.end(), keys.begin(), keys.end())) << count;
        }
    }
}

struct Round {
    float x, y, radius;
};

std::vector<Round> random_discs(std::int64_t count) {
    std::vector<Round> discs;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto u = base::uniform4(5, static_cast<std::uint64_t>(i), base::Purpose::candidate);
        const double radius = i % 50 == 0 ? 400.0 * u[2] : 20.0 * u[2]; // some discs cover very many tiles
        discs.push_back({static_cast<float>(1200.0 * u[0] - 100.0), static_cast<float>(900.0 * u[1] - 100.0),
                         static_cast<float>(radius)});
    }
    return discs;
}

TEST(Tiles, HoldEveryDiscThatTouchesATileInOrder) {
    base::Memory memory;
    const std::int32_t width = 1000;
    const std::int32_t height = 700;
    const std::vector<Round> discs = random_discs(20000);
    // The pieces have gaps between them, and some are empty.
    const std::array<drawing::IndexRange, 5> pieces{{{0, 0}, {10, 9000}, {9000, 9000}, {9001, 19000}, {19990, 20000}}};
    const auto taken = [&](std::size_t i) {
        const auto at = static_cast<std::int64_t>(i);
        return i % 3 != 0 && std::any_of(pieces.begin(), pieces.end(),
                                         [&](const drawing::IndexRange& p) { return p.begin <= at && at < p.end; });
    };
    for (const int threads : {1, 2, 7}) {
        Tiles bins(memory, 32);
        bins.build(base::Parallel(threads, nullptr, nullptr), width, height, pieces,
                   [&](std::int64_t i, Tiles::Footprint& print) {
                       const Round& d = discs[static_cast<std::size_t>(i)];
                       print = Tiles::Footprint::of_disc(d.x, d.y, d.radius);
                       return i % 3 != 0;
                   });
        ASSERT_EQ(bins.columns(), 32);
        ASSERT_EQ(bins.rows(), 22);
        for (std::int64_t tile = 0; tile < bins.tiles(); ++tile) {
            const auto left = static_cast<float>(tile % bins.columns() * bins.tile_size());
            const auto top = static_cast<float>(tile / bins.columns() * bins.tile_size());
            const auto tile_side = static_cast<float>(bins.tile_size());
            std::vector<std::uint32_t> expected;
            for (std::size_t i = 0; i < discs.size(); ++i) {
                const Round& d = discs[i];
                if (taken(i) && d.x + d.radius >= left && d.x - d.radius < left + tile_side && d.y + d.radius >= top &&
                    d.y - d.radius < top + tile_side)
                    expected.push_back(static_cast<std::uint32_t>(i));
            }
            std::vector<std::uint32_t> found;
            bins.for_tile(tile, [&](std::uint32_t i) { found.push_back(i); });
            ASSERT_EQ(found, expected) << tile;
        }
    }
}

TEST(Tiles, AcceptInvalidFootprints) {
    base::Memory memory;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Round discs[] = {{nan, 1, 1},
                           {1, nan, 1},
                           {1, 1, nan},
                           {1, 1, -1},
                           {1, 1, 0},
                           {1, 1, infinity},
                           {1e30F, 1, 1},
                           {-1e30F, 1, 1},
                           {1, 1, 1e30F},
                           {infinity, 1, 1},
                           {infinity, 1, infinity}};
    Tiles bins(memory, 32);
    const std::array pieces{drawing::IndexRange{0, std::size(discs)}};
    bins.build(base::Parallel(), 64, 32, pieces, [&](std::int64_t i, Tiles::Footprint& print) {
        print = Tiles::Footprint::of_disc(discs[i].x, discs[i].y, discs[i].radius);
        return true;
    });
    std::vector<std::uint32_t> found;
    bins.for_tile(0, [&](std::uint32_t i) { found.push_back(i); });
    EXPECT_EQ(found, (std::vector<std::uint32_t>{4, 5, 8}));
}

} // namespace
} // namespace hrbfnpr::testing::order_test
