// SPDX-License-Identifier: MIT
#include "visibility/invisibility.h"

#include "stage.h"

namespace hrbfnpr::visibility::hidden_by_test {
namespace {

using namespace test_stage;

struct Ball {
    glm::dvec3 centre;
    double radius;

    [[nodiscard]] glm::dmat4 place() const {
        glm::dmat4 m(radius);
        m[3] = glm::dvec4(centre, 1.0);
        return m;
    }
    // Returns the distance from p in a direction to the ball's surface, if it is beyond `least`; negative: none.
    [[nodiscard]] double met(const glm::dvec3& p, const glm::dvec3& way, double least) const {
        const double along = glm::dot(centre - p, way);
        const double beside = glm::dot(centre - p, centre - p) - along * along;
        if (beside >= radius * radius) return -1.0;
        const double half = std::sqrt(radius * radius - beside);
        return along - half > least ? along - half : along + half > least ? along + half : -1.0;
    }
};

const std::vector<Ball> balls{{{0.0, 0.0, 0.0}, 1.0}, {{0.7, 0.31, 0.2}, 0.8}, {{-0.5, 0.9, -0.4}, 0.6}};

// Returns the place in the middle of a part, by length in the image.
glm::dvec3 middle_of(const Picture& picture, const Interval& part) {
    const Line& line = picture.found->lines.lines[part.line];
    const double whole = picture.lengths->total(line);
    const double at = std::fmod(0.5 * (part.begin_at + part.end_at), whole);
    std::int64_t piece = line.first_piece;
    while (piece + 1 < line.first_piece + line.pieces && picture.lengths->at(line, piece + 1, 0.0) <= at) ++piece;
    const double begin = picture.lengths->at(line, piece, 0.0);
    const double share = (at - begin) / (picture.lengths->at(line, piece, 1.0) - begin);
    const Subject& subject = picture.subjects[static_cast<std::size_t>(line.subject)];
    return {subject.to_world * glm::dvec4(cubic(picture.subjects, picture.found->lines.pieces[piece]).at(share), 1.0)};
}

TEST(HiddenBy, IsTheNearestSurfaceInFront) {
    const base::Runtime runtime = test::with_threads(2);
    const test::SquareSphere sphere;
    Stage stage;
    for (const Ball& ball : balls) add(runtime, stage, sphere, {1.0, 0.0, 0.0}, 0.1, ball.place());
    int hidden = 0;
    int wrong = 0;
    for (const Eye& eye : test::eyes(cube_directions(0.1), 6.0)) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime, stage, eye);
        picture.find();
        find_hidden_by(runtime, picture.subjects, picture.occluders, *picture.found);
        for (const Interval& part : picture.found->intervals) {
            ASSERT_EQ(part.hidden_by < 0, part.invisibility == 0);
            if (part.end_at - part.begin_at < 1.0 || part.invisibility == 0) continue;
            const std::int32_t own =
                picture.subjects[static_cast<std::size_t>(picture.found->lines.lines[part.line].subject)].item;
            const glm::dvec3 p = middle_of(picture, part);
            const glm::dvec3 way = eye.perspective ? glm::normalize(eye.place() - p) : eye.back;
            std::int32_t nearest = -1;
            double least = 1e9;
            for (std::int32_t b = 0; b < 3; ++b) {
                const double met = balls[static_cast<std::size_t>(b)].met(p, way, b == own ? 0.05 : 0.0);
                if (met < 0.0 || met >= least) continue;
                least = met;
                nearest = b;
            }
            ++hidden;
            wrong += nearest == part.hidden_by ? 0 : 1;
        }
    }
    EXPECT_GT(hidden, 100);
    EXPECT_EQ(wrong, 0);
}

TEST(HiddenBy, OneItemHidesItself) {
    const base::Runtime runtime = test::with_threads(2);
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime, stage, torus, {1.4, 0.0, 0.0}, 0.08);
    Picture picture(runtime, stage, Eye::at({0.1, -1.0, 0.4}, 5.0, true));
    picture.find();
    find_hidden_by(runtime, picture.subjects, picture.occluders, *picture.found);
    int hidden = 0;
    for (const Interval& part : picture.found->intervals) {
        EXPECT_EQ(part.hidden_by, part.invisibility > 0 ? 0 : -1);
        hidden += part.invisibility > 0 ? 1 : 0;
    }
    EXPECT_GT(hidden, 0);
}

} // namespace
} // namespace hrbfnpr::visibility::hidden_by_test
