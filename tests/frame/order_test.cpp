// The order of painting, tiles, and what does not depend on threads or on memory.
#include "frame/hand_made.h"
#include "frame/order.h"
#include "frame/tile_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace hrbfnpr::testing {
namespace {

using frame::Disc;
using frame::FarToNear;
using frame::Frame;
using frame::HiddenLines;
using frame::Style;
using frame::TileBins;

TEST(FarFirstKey, RisesAsDepthFalls) {
    const float depths[] = {
        std::numeric_limits<float>::infinity(), 1e30F, 2.0F, 1.0F, 1e-30F, 0.0F, -1e-30F, -1.0F, -1e30F};
    for (std::size_t i = 0; i + 1 < std::size(depths); ++i)
        EXPECT_LT(frame::far_first_key(depths[i], 7), frame::far_first_key(depths[i + 1], 3));
    EXPECT_EQ(frame::far_first_key(1.0F, 0xFFFFFFFFU) & 0xFFFFFFFFU, 0xFFFFFFFFU);
}

TEST(FarToNearSort, IsAStableSort) {
    base::Memory memory;
    for (const int threads : {1, 3}) {
        const base::Parallel parallel(threads, nullptr, nullptr);
        FarToNear order(memory);
        for (const std::int64_t count : {0, 1, 2, 1000, 100000}) {
            base::Array<std::uint64_t> keys(memory);
            for (std::int64_t i = 0; i < count; ++i) {
                const auto u = base::uniform4(3, static_cast<std::uint64_t>(i), base::Purpose::candidate);
                // Few different depths, so that there are ties.
                const float depth = std::floor(static_cast<float>(u[0] * 500.0 - 250.0)) * 0.25F;
                keys.push_back(frame::far_first_key(depth, static_cast<std::uint32_t>(i)));
            }
            std::vector<std::uint64_t> expected(keys.begin(), keys.end());
            std::stable_sort(expected.begin(), expected.end(),
                             [](std::uint64_t a, std::uint64_t b) { return a >> 32U < b >> 32U; });
            order.sort(parallel, keys);
            EXPECT_TRUE(std::equal(expected.begin(), expected.end(), keys.begin(), keys.end())) << count;
        }
    }
}

std::vector<TileBins::Footprint> random_discs(std::int64_t count) {
    std::vector<TileBins::Footprint> discs;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto u = base::uniform4(5, static_cast<std::uint64_t>(i), base::Purpose::candidate);
        const double radius = i % 50 == 0 ? 400.0 * u[2] : 20.0 * u[2]; // some over very many tiles
        discs.push_back({static_cast<float>(1200.0 * u[0] - 100.0), static_cast<float>(900.0 * u[1] - 100.0),
                         static_cast<float>(radius)});
    }
    return discs;
}

TEST(TileBins, HoldEveryDiscThatTouchesATileInOrder) {
    base::Memory memory;
    const std::int32_t width = 1000;
    const std::int32_t height = 700;
    const std::vector<TileBins::Footprint> discs = random_discs(20000);
    // Pieces with gaps, and empty ones.
    const std::array<frame::Piece, 5> pieces{{{0, 0}, {10, 9000}, {9000, 9000}, {9001, 19000}, {19990, 20000}}};
    const auto taken = [&](std::size_t i) {
        const auto at = static_cast<std::int64_t>(i);
        return i % 3 != 0 && std::any_of(pieces.begin(), pieces.end(),
                                         [&](const frame::Piece& p) { return p.begin <= at && at < p.end; });
    };
    for (const int threads : {1, 2, 7}) {
        TileBins bins(memory, 32);
        bins.build(base::Parallel(threads, nullptr, nullptr), width, height, pieces,
                   [&](std::int64_t i, TileBins::Footprint& print) {
                       print = discs[static_cast<std::size_t>(i)];
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
                const TileBins::Footprint& d = discs[i];
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

TEST(TileBins, BearStrangeFootprints) {
    base::Memory memory;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const TileBins::Footprint discs[] = {{nan, 1, 1},
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
    TileBins bins(memory, 32);
    const std::array pieces{frame::Piece{0, std::size(discs)}};
    bins.build(base::Parallel(), 64, 32, pieces, [&](std::int64_t i, TileBins::Footprint& print) {
        print = discs[i];
        return true;
    });
    std::vector<std::uint32_t> found;
    bins.for_tile(0, [&](std::uint32_t i) { found.push_back(i); });
    EXPECT_EQ(found, (std::vector<std::uint32_t>{4, 5, 8}));
}

// Slow and plain: the painting order by comparing eye depths.
TEST(PaintingOrder, IsFarToNearWithInkBeforeItsMarkAndPaperBehindIt) {
    base::Runtime runtime;
    sampling::PointSet set(runtime.memory);
    set.spacing = 0.04;
    // A mark every 0.01 of depth, facing the eye; 100 pixels a unit.
    for (int i = 0; i < 100; ++i) add_stipple(set, {0.0, 0.0, 0.01 * i}, {0.0, 0.0, 1.0});
    Style style;
    style.tone = frame::Tone::none;
    style.cover_radius = 5.0F; // 0.05 units
    style.group[0].radius = 2.0F;
    const std::array items{item_of(set, style)};
    Frame frame(runtime);
    frame.prepare(items, front_camera(200, 200, 1.0));
    ASSERT_EQ(frame.discs().size(), 200U);
    double before = -100.0;
    for (const Disc& disc : frame.discs()) {
        const double mark = 0.01 * (disc.id - 1);
        const double place = disc.is_paper ? mark - 0.05 : mark + 0.02;
        EXPECT_GE(place, before - 1e-5);
        before = place;
    }
}

class Kept : public ::testing::TestWithParam<HiddenLines> {
protected:
    static std::vector<std::byte> bytes_of(const Frame& frame) {
        std::vector<std::byte> bytes;
        for (const Disc& disc : frame.discs()) {
            const float numbers[] = {disc.x,
                                     disc.y,
                                     disc.radius,
                                     disc.depth,
                                     disc.color.x,
                                     disc.color.w,
                                     static_cast<float>(disc.is_paper),
                                     static_cast<float>(disc.mark_class)};
            const std::size_t at = bytes.size();
            bytes.resize(at + sizeof numbers + sizeof disc.id);
            std::memcpy(bytes.data() + at, numbers, sizeof numbers);
            std::memcpy(bytes.data() + at + sizeof numbers, &disc.id, sizeof disc.id);
        }
        return bytes;
    }
    static Style style() {
        Style style;
        style.hidden_lines = GetParam();
        style.zoom_reference = 200.0;
        style.depth_min = 9.5;
        style.depth_max = 12.0;
        return style;
    }
};

TEST_P(Kept, SameBitsForAnyThreadCount) {
    std::vector<std::byte> expected;
    for (const int threads : {1, 2, 3, 7}) {
        const base::Runtime runtime(nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr),
                                    base::InstructionSet::automatic, nullptr, nullptr);
        const sampling::PointSet set = sphere(runtime.memory, 30000);
        const std::array items{item_of(set, style())};
        Frame frame(runtime);
        frame.prepare(items, front_camera(400, 400));
        const std::vector<std::byte> bytes = bytes_of(frame);
        EXPECT_FALSE(bytes.empty());
        if (expected.empty()) expected = bytes;
        EXPECT_EQ(bytes, expected) << threads;
    }
}

frame::Camera orbit(int step) {
    frame::Camera camera = front_camera(300, 300);
    const double angle = 0.5 * step;
    camera.view = frame::look_at({8.0 * std::sin(angle), 3.0, 8.0 * std::cos(angle)}, glm::dvec3(0.0), {0, 1, 0});
    camera.projection = frame::perspective(0.4, 300, 300, 1.0, 20.0, camera.depth);
    return camera;
}

std::int32_t half_tone(void*, std::int64_t count, const float*, const float*, float* tau) {
    std::fill(tau, tau + count, 0.5F);
    return 0;
}

TEST_P(Kept, AllocatesNothingOnceWarm) {
    CountingAllocator counter;
    const base::Runtime runtime(CountingAllocator::allocate, CountingAllocator::deallocate, &counter,
                                base::Parallel(2, nullptr, nullptr), base::InstructionSet::automatic, nullptr, nullptr);
    const sampling::PointSet set = torus(runtime.memory, 100);
    std::array items{item_of(set, style()), item_of(set, style())};
    items[1].style.tone = frame::Tone::callback;
    items[1].style.tone_function = half_tone;
    Frame frame(runtime);
    frame.prepare(items, orbit(0));
    const std::int64_t warm = counter.calls;
    frame.prepare(items, orbit(0));
    EXPECT_EQ(counter.calls, warm) << "the same view again";
    for (int step = 0; step < 13; ++step) frame.prepare(items, orbit(step));
    const std::int64_t once_round = counter.calls;
    for (int step = 0; step < 13; ++step) frame.prepare(items, orbit(step));
    EXPECT_EQ(counter.calls, once_round) << "a second time round";
    EXPECT_GT(frame.info().scratch_bytes, 0);
    EXPECT_LE(frame.info().scratch_bytes, runtime.memory.bytes_now());
}

INSTANTIATE_TEST_SUITE_P(HiddenLines, Kept,
                         ::testing::Values(HiddenLines::attenuate, HiddenLines::hide, HiddenLines::show),
                         [](const auto& one) { return "mode_" + std::to_string(static_cast<int>(one.param)); });

} // namespace
} // namespace hrbfnpr::testing
