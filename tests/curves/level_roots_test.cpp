// SPDX-License-Identifier: MIT
// Tests zeros of g between two points of a surface, also where f hardly changes between them.
#include "curves/curves.h"

#include "traced.h"

namespace hrbfnpr::curves::level_roots_test {
namespace {

using namespace test_traced;

constexpr double wanted = 0.1;
constexpr double bulge = 1e-3;

// The strip z^3 + slope z + bulge (1 - x^2) = 0. A chord from x = -1 to 1 misses its middle by bulge / slope.
test::AnyField strip(double slope) {
    return {{{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}}, [=](const glm::dvec3& p) {
                return test::Field{p.z * p.z * p.z + slope * p.z + bulge * (1.0 - p.x * p.x),
                                   {-2.0 * bulge * p.x, 0.0, 3.0 * p.z * p.z + slope},
                                   {-2.0 * bulge, 0.0, 0.0, 0.0, 0.0, 6.0 * p.z}};
            }};
}

// g = x - wanted
class Across final : public Level {
public:
    explicit Across(const implicit::Implicit& surface) noexcept : surface_(surface) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override {
        surface_.evaluate(points, {out.value, out.gradient, {}});
        for (std::int64_t i = 0; i < points.count; ++i) {
            out.level[i] = points.x[i] - wanted;
            for (std::size_t c = 0; c < 3; ++c) out.level_gradient[c][i] = c == 0 ? 1.0 : 0.0;
        }
    }
    void at_vertices(const base::Work&, const SurfaceMesh&, base::Array<double>&) const override {}

private:
    const implicit::Implicit& surface_;
};

CurvePoint halved(double slope) {
    const base::Runtime runtime = test::with_threads(1);
    const test::AnyField surface = strip(slope);
    base::Array<Bracket> places(runtime.memory);
    places.push_back({{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    base::Array<CurvePoint> points(runtime.memory);
    bisect(runtime, Across(surface), places, 10, points);
    return points[0];
}

TEST(LevelRoots, AreOnTheSurface) {
    const CurvePoint p = halved(1.0);
    EXPECT_NEAR(p.position.x, wanted, 0x1p-9);
    EXPECT_NEAR(p.position.z, -bulge * (1.0 - p.position.x * p.position.x), 1e-8);
}

// A step along the gradient would have a length of a thousand chords, or would be impossible.
TEST(LevelRoots, StayInTheirIntervalWhereTheSlopeVanishes) {
    for (const double slope : {1e-6, 0.0}) {
        const CurvePoint p = halved(slope);
        EXPECT_NEAR(p.position.x, wanted, 0x1p-9) << slope;
        EXPECT_LE(std::abs(p.position.z), 1.0) << slope;
    }
}

} // namespace
} // namespace hrbfnpr::curves::level_roots_test
