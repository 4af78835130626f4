// SPDX-License-Identifier: MIT
// Tests stipples with a density on the surface.
#include "support/point_sets.h"

#include <array>
#include <cmath>

namespace hrbfnpr::stipples::density_test {
namespace {

using namespace test;

TEST(Density, DistributesMarksByTheFunction) {
    generate::Settings settings = blue({Kind::stipples}, 4000);
    of(settings, Kind::stipples).density.kind = Density::callback;
    of(settings, Kind::stipples).density.function = [](void*, std::int64_t count, const double* p, const double*,
                                                       double* density) {
        for (std::int64_t i = 0; i < count; ++i) density[i] = p[3 * i] > 0.0 ? 1.0 : p[3 * i + 1] > 0.0 ? 0.25 : 0.0;
        return 0;
    };
    const PointSet set = make(Sphere(), settings);
    ASSERT_EQ(of(set, Kind::stipples).count(), 4000);
    for (const std::int64_t prefix : {500, 4000}) {
        std::array<int, 3> parts{};
        for (std::int64_t i = 0; i < prefix; ++i) {
            const glm::dvec3 p = position(set, Kind::stipples, i);
            ++parts[p.x > 0.0 ? 0U : p.y > 0.0 ? 1U : 2U];
        }
        // Half of the sphere has density 1, a quarter 1/4 and a quarter 0: 8 to 1 to 0.
        EXPECT_NEAR(parts[0], 8.0 / 9.0 * static_cast<double>(prefix), 0.02 * static_cast<double>(prefix));
        EXPECT_NEAR(parts[1], static_cast<double>(prefix) / 9.0, 0.02 * static_cast<double>(prefix));
        EXPECT_EQ(parts[2], 0);
    }
    const LevelReport& report = of(set, Kind::stipples).report.level[0];
    EXPECT_EQ(report.attempted, report.placed + report.dropped_budget + report.dropped_strayed +
                                    report.dropped_not_converged + report.dropped_degenerate);
}

TEST(Density, FollowsCurvature) {
    generate::Settings settings = blue({Kind::stipples}, 4000);
    of(settings, Kind::stipples).density.kind = Density::curvature;
    of(settings, Kind::stipples).density.strength = 1.0;
    const Torus torus(1.0, 0.8);
    const PointSet set = make(torus, settings);
    int inner = 0;
    for (std::int64_t i = 0; i < 4000; ++i)
        if (const glm::dvec3 p = position(set, Kind::stipples, i); std::hypot(p.x, p.y) < 1.0) ++inner;
    const double uniform = 0.5 - 0.8 / 3.14159265;
    EXPECT_GT(inner / 4000.0, uniform + 0.02) << "the inner half bends more";
    of(settings, Kind::stipples).density.strength = 0.0;
    const PointSet even = make(torus, settings);
    inner = 0;
    for (std::int64_t i = 0; i < 4000; ++i)
        if (const glm::dvec3 p = position(even, Kind::stipples, i); std::hypot(p.x, p.y) < 1.0) ++inner;
    EXPECT_NEAR(inner / 4000.0, uniform, 0.01);
}

} // namespace
} // namespace hrbfnpr::stipples::density_test
