// Layers that share the tones.
#include "support/point_sets.h"

#include <array>

namespace hrbfnpr::generate {
namespace {

using namespace test;

TEST(Layers, AppearOneAfterTheOther) {
    generate::Settings settings = blue({Kind::stipples, Kind::principal}, 3000);
    of(settings, Kind::stipples).part[0] = {0.0, 0.3};
    of(settings, Kind::principal).part = {TonePart{0.3, 0.6}, TonePart{0.6, 1.0}};
    const PointSet set = make(Torus(), settings);
    const Layer& stipples = of(set, Kind::stipples);
    for (const float rank : stipples.rank) EXPECT_GE(rank, 0.7F - 1e-6F);
    const Layer& strokes = of(set, Kind::principal);
    std::array<int, 2> seen{};
    for (std::int64_t i = 0; i < strokes.count(); ++i) {
        const std::uint32_t which = strokes.stroke[2 * i] & 1U;
        ++seen[which];
        EXPECT_GE(strokes.rank[i], which == 0 ? 0.4F - 1e-6F : 0.0F);
        EXPECT_LE(strokes.rank[i], which == 0 ? 0.7F + 1e-6F : 0.4F + 1e-6F);
    }
    EXPECT_GT(seen[0], 500);
    EXPECT_GT(seen[1], 500);
}

} // namespace
} // namespace hrbfnpr::generate
