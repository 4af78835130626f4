// SPDX-License-Identifier: MIT
// Tests published strokes along the caller's directions, and across them.
#include "support/caller_directions.h"
#include "support/point_sets.h"

namespace hrbfnpr::published::function_test {
namespace {

using namespace marks;
using namespace test;

generate::Settings along(Caller& caller) {
    generate::Settings settings = recursion({Kind::hatch}, 3);
    settings.layers[0].hatching.direction = caller.function();
    settings.seeds.initial_step = 0.05;
    return settings;
}

TEST(DirectionFunction, IsFollowedByTheStrokes) {
    const Sphere sphere;
    Caller caller{helix};
    generate::Settings settings = along(caller);
    const std::vector<double> seeds = spiral_seeds(64);
    use_points(settings, seeds);
    // A direction function has priority over any guide.
    for (const hatching::Guide guide : {hatching::Guide::curvature, hatching::Guide::combing, hatching::Guide::light}) {
        settings.layers[0].hatching.field.guide = guide;
        const PointSet set = make(sphere, settings);
        expect_sound(set, sphere);
        const Layer& marks = set.layers[0];
        EXPECT_EQ(marks.count(), 64 * 2 * 27);
        EXPECT_EQ(marks.strokes(), 128);
        EXPECT_TRUE(marks.curvature.empty());
        for (std::int64_t i = 0; i < marks.count(); ++i) {
            const glm::dvec3 p = position(set, marks, i);
            if (std::abs(p.z) > 0.9) continue;
            const bool across = marks.direction_of(i) == 1;
            EXPECT_LT(degrees_off_helix(vec(marks.direction, i), p, vec(marks.normal, i), across), 0.1) << i;
        }
    }
}

TEST(DirectionFunction, WithoutDirectionsStrokesAreStillMade) {
    const Sphere sphere;
    Caller nowhere{no_direction};
    generate::Settings settings = along(nowhere);
    const std::vector<double> seeds = spiral_seeds(64);
    use_points(settings, seeds);
    const PointSet set = make(sphere, settings);
    expect_sound(set, sphere);
    EXPECT_EQ(set.layers[0].count(), 64 * 2 * 27);
}

} // namespace
} // namespace hrbfnpr::published::function_test
