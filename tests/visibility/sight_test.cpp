// SPDX-License-Identifier: MIT
// Tests rays that prove which places are visible, against distances of straight lines from balls, walls and an open
// sheet.
#include "visibility/sight.h"

#include "stage.h"
#include "support/sharp_shapes.h"

namespace hrbfnpr::visibility::sight_test {
namespace {

using namespace test_stage;

struct Ball {
    glm::dvec3 centre;
    double radius;

    // Returns how deep the ray from p gets into the ball; a negative number is the distance at which it passes by.
    [[nodiscard]] double depth(const glm::dvec3& p, const glm::dvec3& way) const {
        const double along = std::max(0.0, glm::dot(centre - p, way));
        return radius - glm::distance(centre, p + along * way);
    }
};

const std::vector<Ball> balls{{{0.0, 0.0, 0.0}, 1.0}, {{0.7, 0.31, 0.2}, 0.8}, {{-0.5, 0.9, -0.4}, 0.6}};

Stage stage_of_balls(const base::Runtime& runtime, const test::SquareSphere& sphere) {
    Stage stage;
    for (const Ball& ball : balls) add(runtime, stage, sphere, {1.0, 0.0, 0.0}, 0.1, moved(ball.centre, ball.radius));
    return stage;
}

std::vector<Occluder> occluders_of(const Stage& stage, const glm::dvec4& eye) {
    std::vector<Occluder> occluders;
    for (const std::unique_ptr<Actor>& actor : stage)
        occluders.push_back({&actor->sheets, &actor->surface, actor->to_world, glm::inverse(actor->to_world) * eye});
    return occluders;
}

glm::dvec3 random_direction(std::uint64_t i) {
    const auto r = base::uniform4(7, i, base::Purpose::probe);
    const double z = 2.0 * r[0] - 1.0;
    const double turn = 6.283185307179586 * r[1];
    return {std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z};
}

TEST(Sight, DecidesPlacesOnBallsAsStraightLinesDo) {
    const base::Runtime runtime = test::with_threads(2);
    const test::SquareSphere sphere;
    const Stage stage = stage_of_balls(runtime, sphere);
    constexpr double margin = 0.01;
    for (const glm::dvec4& eye : {glm::dvec4(4.0, 2.0, 3.0, 1.0), glm::dvec4(-0.5, 0.3, 0.8, 0.0)}) {
        std::vector<SightPlace> places;
        std::vector<double> depths;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            const auto own = static_cast<std::int32_t>(i % 3);
            const Ball& ball = balls[static_cast<std::size_t>(own)];
            const glm::dvec3 normal = random_direction(i);
            SightPlace place{ball.centre + ball.radius * normal, own, margin};
            const glm::dvec3 way = glm::normalize(eye.w != 0.0 ? glm::dvec3(eye) - place.place : -glm::dvec3(eye));
            double depth = -1.0;
            for (std::size_t k = 0; k < 3; ++k)
                if (k != i % 3 || glm::dot(normal, way) < 0.0)
                    depth = std::max(depth, balls[k].depth(place.place, way));
            places.push_back(place);
            depths.push_back(depth);
        }
        const base::Array<Sighting> found = look_at(runtime, occluders_of(stage, eye), places);
        int undecided = 0;
        std::array<int, 2> decided{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Seen seen = found[static_cast<std::int64_t>(i)].seen;
            if (seen == Seen::undecided) {
                ++undecided;
                EXPECT_LT(std::abs(depths[i]), 2.5 * margin) << i;
                continue;
            }
            ++decided[seen == Seen::hidden ? 1 : 0];
            if (std::abs(depths[i]) > 0.5 * margin) {
                EXPECT_EQ(seen == Seen::hidden, depths[i] > 0.0) << i;
            }
            EXPECT_EQ(found[static_cast<std::int64_t>(i)].hidden_by >= 0, seen == Seen::hidden);
        }
        EXPECT_GT(decided[0], 300);
        EXPECT_GT(decided[1], 1000);
        EXPECT_GT(undecided, 0);
        EXPECT_LT(undecided, 200);
    }
}

TEST(Sight, FindsWallsThinnerThanTheMargin) {
    const base::Runtime runtime = test::with_threads(1);
    // A floor, and a wall above it that is a hundredth as thick as the margin.
    const geometry::Bounds box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const test::SharpShape shape(
        box, test::min_of({test::plane({0.0, 0.0, 1.0}, -0.5),
                           test::max_of({test::plane({0.0, 0.0, 1.0}, 0.5), test::plane({0.0, 0.0, -1.0}, -0.4999),
                                         test::plane({1.0, 0.0, 0.0}, 0.0)})}));
    Stage stage;
    add(runtime, stage, shape, {0.9, 0.9, -0.5}, 0.1);
    const std::vector<Occluder> occluders = occluders_of(stage, {0.0, 0.0, -1.0, 0.0});
    const auto seen = [&](double x, double reach) {
        SightPlace place{{x, 0.2, -0.5}, 0, 0.01};
        place.reach = reach;
        return look_at(runtime, occluders, {&place, 1})[0].seen;
    };
    EXPECT_EQ(seen(-0.5, 10.0), Seen::hidden);
    EXPECT_EQ(seen(0.5, 10.0), Seen::visible);
    EXPECT_EQ(seen(0.004, 10.0), Seen::undecided);
    EXPECT_EQ(seen(-0.5, 0.5), Seen::visible); // The ray ends before the wall.
}

TEST(Sight, CutFacesHideIfTheyAreCut) {
    const base::Runtime runtime = test::with_threads(1);
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime, stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    const std::vector<Occluder> occluders = occluders_of(stage, {0.0, 0.0, -1.0, 0.0});
    SightPlace place{{0.0, 0.0, -1.0}, 0, 0.01};
    place.reach = 1.0; // to the plane z = 0
    EXPECT_EQ(look_at(runtime, occluders, {&place, 1})[0].seen, Seen::visible);
    place.is_cut = true;
    EXPECT_EQ(look_at(runtime, occluders, {&place, 1})[0].seen, Seen::hidden);
}

TEST(Sight, MovesPlacesOutOfTheirOwnSolid) {
    const base::Runtime runtime = test::with_threads(1);
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime, stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    const std::vector<Occluder> occluders = occluders_of(stage, {0.0, 0.0, -1.0, 0.0});
    SightPlace place{0.95 * glm::normalize(glm::dvec3(0.3, 0.2, 1.0)), 0, 0.01};
    EXPECT_EQ(look_at(runtime, occluders, {&place, 1})[0].seen, Seen::hidden);
    place.lift = 0.06;
    EXPECT_EQ(look_at(runtime, occluders, {&place, 1})[0].seen, Seen::visible);
}

} // namespace
} // namespace hrbfnpr::visibility::sight_test
