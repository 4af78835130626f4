// SPDX-License-Identifier: MIT
// Compares the number of sheets in front of contours with known results and with plain counts along lines of sight.
#include "visibility/invisibility.h"

#include "fit/shapes.h"
#include "stage.h"
#include "support/contour_shapes.h"

namespace hrbfnpr::visibility::invisibility_test {
namespace {

using namespace test_stage;

constexpr double pi = 3.141592653589793;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// Makes a transform of three columns and the image of the origin.
glm::dmat4 affine(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& to) {
    return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(to, 1.0)};
}

TEST(Invisibility, NothingHidesASphere) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        Picture picture(runtime(), stage, eye);
        picture.find();
        ASSERT_EQ(picture.found->intervals.size(), 1);
        EXPECT_EQ(picture.found->intervals[0].invisibility, 0);
        EXPECT_EQ(picture.found->report.closed, 1);
        EXPECT_EQ(picture.found->crossings.size(), 0);
        expect_right(picture, 10);
    }
}

// Each sphere is smaller than the one in front of it, so each has two more sheets in front.
TEST(Invisibility, IsRightForSpheresInARow) {
    const test::SquareSphere sphere;
    for (const Eye& eye : test::eyes(cube_directions(), 6.0)) {
        Stage stage;
        for (int i = 0; i < 3; ++i)
            add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved((2.0 - 2.0 * i) * eye.back, 0.9 - 0.25 * i));
        Picture picture(runtime(), stage, eye);
        picture.find();
        ASSERT_EQ(picture.found->intervals.size(), 3);
        for (const Interval& part : picture.found->intervals)
            EXPECT_EQ(part.invisibility, 2 * picture.found->lines.lines[part.line].subject);
        expect_right(picture, 10);
    }
}

// Two circles overlap in the image. The length of the farther one inside the nearer one is known.
TEST(Invisibility, IsRightForOverlappingCircles) {
    const test::SquareSphere sphere;
    for (const glm::dvec3& towards : cube_directions()) {
        const Eye eye = Eye::at(towards, 6.0, false, 200.0);
        Stage stage;
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved(2.0 * eye.back));
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved(1.2 * eye.right - 0.5 * eye.up));
        Picture picture(runtime(), stage, eye);
        picture.find();
        ASSERT_EQ(picture.found->crossings.size(), 2);
        EXPECT_EQ(picture.found->crossings[0].change + picture.found->crossings[1].change, 0);
        const glm::dvec2 middle(400.0 + 0.6 * 200.0, 400.0 + 0.25 * 200.0); // the point midway between the centres
        const double away = 200.0 * std::sqrt(1.0 - 0.65 * 0.65);           // distance of the crossings from there
        for (const Crossing& crossing : picture.found->crossings) {
            EXPECT_NEAR(glm::distance(crossing.place, middle), away, 0.01);
            EXPECT_NEAR(glm::dot(crossing.place - middle, glm::dvec2(1.2, 0.5)), 0.0, 0.01);
            EXPECT_NEAR(crossing.gap, 2.0 / 0.2, 1.0);
        }
        for (const Interval& part : picture.found->intervals) {
            const bool far = picture.found->lines.lines[part.line].subject == 1;
            const double length = part.end_at - part.begin_at;
            const double inside = 2.0 * std::acos(0.65) * 200.0; // length of an arc
            const double expected = !far ? 400.0 * pi : part.invisibility == 2 ? inside : 400.0 * pi - inside;
            EXPECT_NEAR(length, expected, 0.1);
            EXPECT_TRUE(part.invisibility == 0 || (far && part.invisibility == 2));
        }
        expect_right(picture, 20);
    }
}

void expect_right_from_everywhere(Stage& stage, const std::vector<glm::dvec3>& directions, double distance,
                                  int places) {
    int compared = 0;
    for (const Eye& eye : test::eyes(directions, distance)) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        compared += expect_right(picture, places);
    }
    EXPECT_GT(compared, 2000);
}

TEST(Invisibility, IsRightForATorusFromEverywhere) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    int compared = 0;
    std::int64_t hidden = 0;
    const auto look = [&](const Eye& eye) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        compared += expect_right(picture, 40);
        for (const Interval& part : picture.found->intervals) hidden += part.invisibility > 0 ? 1 : 0;
    };
    for (const Eye& eye : test::eyes(cube_directions(0.1), 4.0)) look(eye);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.03 + 0.038 * i;
        look(Eye::at({std::cos(angle), 0.3 * std::cos(angle), std::sin(angle)}, 4.0, i % 2 == 0));
    }
    EXPECT_GT(compared, 2000);
    EXPECT_GT(hidden, 50);
}

TEST(Invisibility, IsRightForAKnotFromEverywhere) {
    const test::Knot knot;
    Stage stage;
    add(runtime(), stage, knot, {1.0 + test::Knot::tube, 0.0, 0.0}, 0.05);
    int compared = 0;
    for (const Eye& eye : test::eyes(cube_directions(0.05), 4.0)) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        compared += expect_right(picture, 50, 300);
        EXPECT_GT(picture.found->crossings.size(), 6);
    }
    EXPECT_GT(compared, 2000);
}

TEST(Invisibility, IsRightForTwoHolesFromEverywhere) {
    const test::TwoHoles surface;
    Stage stage;
    add(runtime(), stage, surface, {1.05, 0.1, 0.0}, 0.04);
    expect_right_from_everywhere(stage, cube_directions(0.05), 3.0, 45);
}

// The items are turned, stretched and mirrored. Each is partly in front of the others and partly behind them.
TEST(Invisibility, IsRightForTransformedItems) {
    const test::Torus torus(1.0, 0.4);
    const test::Ellipsoid ellipsoid({1.0, 0.6, 0.4});
    Stage stage;
    const double c = std::cos(0.7), s = std::sin(0.7);
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.1,
        affine({0.7 * c, 0.7 * s, 0.0}, {-0.9 * s, 0.9 * c, 0.1}, {0.0, 0.2, 0.6}, {-1.3, 0.1, 0.2}));
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.1,
        affine({0.0, 0.6, 0.1}, {0.0, 0.1, 0.7}, {-0.5, 0.0, 0.0}, {1.1, -0.2, 0.1})); // mirrors
    add(runtime(), stage, ellipsoid, {1.0, 0.0, 0.0}, 0.1,
        affine({-0.8, 0.1, 0.0}, {0.1, 0.9, 0.2}, {0.0, 0.3, 0.9}, {0.1, 0.2, -1.8})); // mirrors
    int mirrored = 0;
    for (const std::unique_ptr<Actor>& actor : stage)
        mirrored += glm::determinant(glm::dmat3(actor->to_world)) < 0.0 ? 1 : 0;
    ASSERT_EQ(mirrored, 2);
    expect_right_from_everywhere(stage, cube_directions(0.1), 5.0, 50);
}

// Each torus is partly in front of the other and partly behind it.
TEST(Invisibility, IsRightForLinkedItems) {
    const test::Torus torus(1.0, 0.3);
    Stage stage;
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1);
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1,
        affine({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.05, 0.02})); // mirrors
    expect_right_from_everywhere(stage, cube_directions(0.1), 5.0, 50);
}

// Swallowtails of a torus, from just born ones to visible ones: four cusps appear at once. Lines hidden only by a
// swallowtail too small to be seen may be shown.
TEST(Invisibility, IsRightForNewSwallowtails) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    const auto eye_at = [](double angle, bool perspective) {
        return Eye::at({std::cos(angle), 0.013, std::sin(angle)}, 4.0, perspective);
    };
    const auto cusps = [&](double angle, bool perspective) {
        Picture picture(runtime(), stage, eye_at(angle, perspective));
        picture.find();
        return picture.found->report.cusps;
    };
    int compared = 0;
    for (const bool perspective : {true, false}) {
        double some = 0.4;
        double none = 1.4;
        ASSERT_GT(cusps(some, perspective), 0);
        ASSERT_EQ(cusps(none, perspective), 0);
        for (int k = 0; k < 40; ++k) {
            const double middle = 0.5 * (some + none);
            (cusps(middle, perspective) > 0 ? some : none) = middle;
        }
        for (double older = 1e-7; older < 0.3; older *= 1.6) {
            SCOPED_TRACE(testing::Message() << perspective << ' ' << older);
            Picture picture(runtime(), stage, eye_at(some - older, perspective));
            picture.find();
            EXPECT_GT(picture.found->report.cusps, 0);
            EXPECT_EQ(picture.found->report.settled, 0);
            EXPECT_EQ(picture.found->report.contradictions, 0);
            for (int i = 0; i < 60; ++i) {
                const Place place = picture.random_place(i);
                const std::optional<std::int32_t> sheets = picture.sheets_at(place);
                if (!sheets || picture.near_cusp(place)) continue;
                ++compared;
                EXPECT_EQ(*sheets, picture.dense_count(place, 400));
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

// The surface around the eye has no contour. It is one sheet in front of all that is outside it.
TEST(Invisibility, IsRightWithTheEyeInsideASphere) {
    const test::SquareSphere sphere;
    for (const glm::dvec3& towards : cube_directions(0.1)) {
        const Eye eye = Eye::at(towards, 1.0, true);
        Stage stage;
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved({0.0, 0.0, 0.0}, 2.0));
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved({0.0, 0.0, 0.0}, 0.3));
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved(-4.0 * eye.back + 0.5 * eye.right, 0.7));
        Picture picture(runtime(), stage, eye);
        picture.find();
        EXPECT_EQ(picture.found->report.lines, 2);
        for (const Interval& part : picture.found->intervals) {
            const bool beyond = picture.found->lines.lines[part.line].subject == 2;
            EXPECT_TRUE(beyond ? part.invisibility == 1 || part.invisibility == 3 : part.invisibility == 0);
        }
        expect_right(picture, 20);
    }
}

// The eye is in the hole of a ring. Lines come from behind the eye, so only those completely in front of it are closed.
TEST(Invisibility, IsRightForLinesThatPassBehindTheEye) {
    const test::Torus torus(1.0, 0.4);
    const test::SquareSphere sphere;
    int compared = 0;
    for (const glm::dvec3& towards : cube_directions(0.1)) {
        const Eye eye = Eye::at(towards, 0.45, true);
        SCOPED_TRACE(named(eye));
        Stage stage;
        add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.2, moved(-3.0 * eye.back, 0.8));
        Picture picture(runtime(), stage, eye);
        picture.find();
        for (const ImagePoint& p : picture.found->lines.points) {
            EXPECT_TRUE(std::isfinite(p.place.x) && std::isfinite(p.place.y));
            const Piece& piece = picture.found->lines.pieces[p.piece];
            const Subject& subject = picture.subjects[static_cast<std::size_t>(piece.subject)];
            EXPECT_GT(subject.view.see(subject.curves->point[piece.a].position).w, 0.0);
        }
        compared += expect_right(picture, 80);
    }
    EXPECT_GT(compared, 1000);
}

TEST(Invisibility, IsRightForAFit) {
    const test::Samples samples = test::bumpy(700, 0.3);
    const fit_test::Cloud cloud(samples);
    const implicit::Hrbf hrbf(runtime().instruction_set, fit::fit(runtime(), fit_test::input(cloud)).data);
    Stage stage;
    add(runtime(), stage, hrbf, {samples.points[0], samples.points[1], samples.points[2]}, 0.06);
    int compared = 0;
    for (const Eye& eye : test::eyes(cube_directions(), 4.0)) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        compared += expect_right(picture, 12, 200);
    }
    EXPECT_GT(compared, 500);
}

// A straight line that belongs to no surface is behind a sphere.
TEST(Invisibility, IsRightForLinesOfNoSurface) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    const Eye eye = Eye::at({0.2, -0.3, 1.0}, 6.0, false, 150.0);
    curves::Curves line(runtime().memory);
    for (int i = 0; i <= 20; ++i) {
        curves::CurvePoint p;
        p.position = -2.0 * eye.back + (-2.0 + 0.2 * i) * eye.right + 0.6 * eye.up;
        p.gradient = eye.up;
        p.level_gradient = eye.back; // the direction is along `right`
        line.point.push_back(p);
    }
    line.first.push_back(21);
    line.closed.push_back(0);
    Picture picture(runtime(), stage, eye);
    Subject subject;
    subject.curves = &line;
    subject.view = eye.view();
    subject.side = 0.1;
    subject.item = -1;
    subject.sheet_change = 0;
    picture.add(subject);
    picture.find();
    expect_right(picture, 50);
    std::vector<Interval> parts;
    for (const Interval& part : picture.found->intervals)
        if (picture.found->lines.lines[part.line].subject == 1) parts.push_back(part);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].invisibility, 0);
    EXPECT_EQ(parts[1].invisibility, 2);
    EXPECT_EQ(parts[2].invisibility, 0);
    EXPECT_NEAR(parts[1].begin_at, 150.0 * (2.0 - 0.8), 0.01);
    EXPECT_NEAR(parts[1].end_at, 150.0 * (2.0 + 0.8), 0.01);
}

TEST(Invisibility, IsEmptyWithoutItems) {
    Picture picture(runtime(), {}, Eye::at({1.0, 0.0, 0.0}, 3.0, true));
    picture.find();
    EXPECT_EQ(picture.found->intervals.size(), 0);
    EXPECT_EQ(picture.found->report.lines, 0);
}

} // namespace
} // namespace hrbfnpr::visibility::invisibility_test
