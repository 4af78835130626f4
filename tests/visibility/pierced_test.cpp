// SPDX-License-Identifier: MIT
// Tests items that intersect each other.
#include "visibility/image_lines.h"

#include "fit/shapes.h"
#include "stage.h"
#include "support/contour_shapes.h"

#include <cstring>

namespace hrbfnpr::visibility::pierced_test {
namespace {

using namespace test_stage;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// Expects each place on the surface of another item. There the line enters or leaves that item.
void expect_on_surfaces(const Picture& picture) {
    for (const Piercing& place : picture.found->piercings) {
        const Piece& piece = picture.found->lines.pieces[place.piece];
        const Subject& subject = picture.subjects[static_cast<std::size_t>(piece.subject)];
        const Occluder& other = picture.occluders[static_cast<std::size_t>(place.item)];
        EXPECT_NE(subject.item, place.item);
        EXPECT_EQ(std::abs(place.change), 1);
        const glm::dvec3 p(glm::inverse(other.to_world) * subject.to_world *
                           glm::dvec4(cubic(picture.subjects, piece).at(place.share), 1.0));
        double value = 0.0;
        double g[3];
        other.surface->evaluate({&p.x, &p.y, &p.z, 1}, {&value, {&g[0], &g[1], &g[2]}, {}});
        EXPECT_LT(std::abs(value), 1e-8 * std::hypot(g[0], g[1], g[2]));
    }
}

// Looks at a stage from all eyes: rays need not settle anything, and all counts equal the dense ones. Returns the
// number of places found.
std::int64_t expect_exact(const Stage& stage, const std::vector<Eye>& eyes, int places) {
    std::int64_t pierced = 0;
    int compared = 0;
    for (const Eye& eye : eyes) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        expect_on_surfaces(picture);
        pierced += picture.found->piercings.size();
        compared += expect_right(picture, places);
    }
    EXPECT_GT(compared, static_cast<int>(eyes.size()) * places / 2);
    return pierced;
}

TEST(Pierced, PlacesAreExactForOverlappingSpheres) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1, moved({0.7, 0.31, 0.2}, 0.8));
    EXPECT_GT(expect_exact(stage, test::eyes(cube_directions(0.1), 6.0), 20), 100);
}

// The contour of one sphere, a circle, meets the other sphere in two known points.
TEST(Pierced, PlacesMatchKnownPoints) {
    const test::SquareSphere sphere;
    const Eye eye = Eye::at({0.0, 0.0, 1.0}, 6.0, false, 200.0);
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1, moved({0.8, 0.0, 0.6}));
    Picture picture(runtime(), stage, eye);
    picture.find();
    ASSERT_EQ(picture.found->piercings.size(), 4);
    std::int32_t sum = 0;
    for (const Piercing& place : picture.found->piercings) {
        const glm::dvec3 p = cubic(picture.subjects, picture.found->lines.pieces[place.piece]).at(place.share);
        // x^2 + y^2 = 1 and (x - 0.8)^2 + y^2 + 0.6^2 = 1. For the other sphere the same holds from its own centre.
        EXPECT_NEAR(p.x, place.item == 1 ? 0.625 : -0.625, 1e-5);
        sum += place.change;
    }
    EXPECT_EQ(sum, 0);
    expect_right(picture, 40);
}

TEST(Pierced, PlacesAreExactForATorusThroughASphere) {
    const test::SquareSphere sphere;
    const test::Torus torus(1.0, 0.3);
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.08, moved({0.9, 0.1, 0.05}, 0.6));
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.08);
    EXPECT_GT(expect_exact(stage, test::eyes(cube_directions(0.1), 6.0), 20), 100);
}

// A flat, wide ellipsoid cuts a bumpy fit. It is placed obliquely and mirrored.
TEST(Pierced, PlacesAreFoundForASlabThroughAFit) {
    const auto cloud = hrbfnpr::test::bumpy(400, 0.3);
    base::Runtime& with = runtime();
    const implicit::Hrbf fitted{with.instruction_set, fit::fit(with, fit_test::input(cloud)).data};
    const test::Ellipsoid slab({1.6, 1.4, 0.12});
    Stage stage;
    geometry::VecArray seeds(with.memory);
    for (std::size_t i = 0; i < cloud.points.size(); i += 3)
        seeds.push_back({cloud.points[i], cloud.points[i + 1], cloud.points[i + 2]});
    const glm::dmat4 oblique{glm::dvec4(0.9, 0.3, 0.1, 0.0), glm::dvec4(-0.3, 0.9, 0.2, 0.0),
                             glm::dvec4(0.0, 0.2, -1.0, 0.0), glm::dvec4(0.05, -0.1, 0.1, 1.0)};
    stage.push_back(std::make_unique<Actor>(with, fitted, seeds, 0.06, glm::dmat4(1.0)));
    add(with, stage, slab, {1.6, 0.0, 0.0}, 0.05, oblique);
    EXPECT_GT(expect_exact(stage, test::eyes(cube_directions(0.13), 6.0), 20), 100);
}

TEST(Pierced, PlacesAreExactForThreeItems) {
    const test::SquareSphere sphere;
    const test::Torus torus(1.0, 0.3);
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.08, moved({0.9, 0.1, 0.05}, 0.6));
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.08);
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.08, moved({0.45, 0.5, 0.2}, 0.5));
    EXPECT_GT(expect_exact(stage, test::eyes(cube_directions(0.1), 6.0), 20), 200);
}

// The small ball is smaller than the cells of the large one.
TEST(Pierced, PlacesAreFoundForASmallItemInALargeItem) {
    const test::SquareSphere sphere;
    for (const Eye& eye : test::eyes({{0.3, 0.2, 1.0}, {-1.0, 0.4, 0.3}}, 6.0)) {
        Stage stage;
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.35);
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.15, moved(0.98 * eye.right + 0.05 * eye.back, 0.08));
        Picture picture(runtime(), stage, eye);
        picture.find();
        EXPECT_GE(picture.found->piercings.size(), 2);
        expect_right(picture, 60);
    }
}

// Lines of each item are in the surface of the other, like a picture on a wall. Halving such lines had no end.
TEST(Pierced, PlacesStayFewForCoincidentItems) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    Picture picture(runtime(), stage, Eye::at({0.0, 0.0, 1.0}, 6.0, false));
    picture.find();
    EXPECT_LT(picture.found->piercings.size(), 10000);
}

TEST(Pierced, OneItemPiercesNothing) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    Picture picture(runtime(), stage, Eye::at({0.3, 0.2, 1.0}, 4.0, true));
    picture.find();
    EXPECT_TRUE(picture.found->piercings.empty());
}

} // namespace
} // namespace hrbfnpr::visibility::pierced_test
