// SPDX-License-Identifier: MIT
// Compares the parts of contours that have nothing beside them with known results and with plain counts along lines of
// sight that pass close by.
#include "visibility/invisibility.h"

#include "stage.h"
#include "support/contour_shapes.h"

namespace hrbfnpr::visibility::outline_test {
namespace {

using namespace test_stage;

constexpr double pi = 3.141592653589793;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

Outline outline_of(const Picture& picture, const base::Runtime& on = runtime()) {
    const std::vector<std::uint8_t> wanted(picture.subjects.size(), 1);
    return find_outline(on, picture.subjects, picture.occluders, *picture.found, *picture.lengths, wanted);
}

double length_of(const Outline& outline) {
    double sum = 0.0;
    for (const OutlinePart& part : outline.parts) sum += part.end_at - part.begin_at;
    return sum;
}

// Counts the sheets of all surfaces on the line of sight through a place in the image.
std::int32_t sheets_through(const Picture& picture, const Eye& eye, const glm::dvec2& pixel) {
    const glm::dvec2 off = (pixel - 0.5 * Eye::size) / eye.pixels;
    const glm::dvec3 at = off.x * eye.right - off.y * eye.up;
    const glm::dvec3 from = eye.perspective ? eye.place() : at + 30.0 * eye.back;
    const glm::dvec3 to = from + 60.0 * glm::normalize(at - from);
    std::int32_t sheets = 0;
    for (const Occluder& occluder : picture.occluders) {
        const glm::dmat4 own = glm::inverse(occluder.to_world);
        glm::dvec3 a(own * glm::dvec4(from, 1.0));
        glm::dvec3 b(own * glm::dvec4(to, 1.0));
        if (curves::test_dense::clip(surface::search_region(*occluder.surface), a, b))
            sheets += curves::test_dense::roots({*occluder.surface, a, b}, 400);
    }
    return sheets;
}

// Tells whether the place is on the outline; nothing if it is within `clear` pixels of a part's end.
std::optional<bool> says(const Picture& picture, const Outline& outline, const Place& place, double clear) {
    const double whole = picture.lengths->total(picture.found->lines.lines[place.line]);
    bool in = false;
    for (const OutlinePart& part : outline.parts) {
        if (part.line != place.line) continue;
        const bool all = part.end_at - part.begin_at >= whole;
        for (const double at : {place.at, place.at + whole}) {
            in = in || all || (at >= part.begin_at && at <= part.end_at);
            if (!all && (std::abs(at - part.begin_at) < clear || std::abs(at - part.end_at) < clear))
                return std::nullopt;
        }
    }
    return in;
}

// Tells whether the lines of sight on one side of the curve meet no surface.
bool is_outline(const Picture& picture, const Eye& eye, const Place& place) {
    constexpr double beside = 0.005; // pixels: beside a cusp the hidden contour is nearer than 0.02
    const Piece& piece = picture.found->lines.pieces[place.piece];
    const curves::View& view = picture.subjects[static_cast<std::size_t>(piece.subject)].view;
    const glm::dvec3 p = picture.point_at(place);
    const glm::dvec3 way = cubic(picture.subjects, piece).derivative(place.share);
    const glm::dvec2 here = view.see(p).place;
    const glm::dvec2 along = view.see(p + 1e-4 * way).place - here;
    const glm::dvec2 across = beside * glm::normalize(glm::dvec2(-along.y, along.x));
    return sheets_through(picture, eye, here + across) == 0 || sheets_through(picture, eye, here - across) == 0;
}

struct Compared {
    int places = 0, outline = 0;
};

Compared expect_outline(const Picture& picture, const Eye& eye, int places) {
    const Outline outline = outline_of(picture);
    EXPECT_EQ(outline.settled, 0);
    Compared compared;
    for (int i = 0; i < places; ++i) {
        const Place place = picture.random_place(i);
        const std::optional<bool> said = says(picture, outline, place, 0.1);
        if (!said) continue;
        ++compared.places;
        compared.outline += *said ? 1 : 0;
        EXPECT_EQ(*said, is_outline(picture, eye, place)) << place.line << ' ' << place.at;
    }
    return compared;
}

void expect_right_from_everywhere(const Stage& stage, double turned, double distance, int places) {
    Compared all;
    for (const Eye& eye : test::eyes(cube_directions(turned), distance)) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        InvisibilitySettings fine; // crossings by less are invisible, but matter here
        fine.tolerance = 1e-3;
        picture.find(fine);
        const Compared some = expect_outline(picture, eye, places);
        all.places += some.places;
        all.outline += some.outline;
    }
    EXPECT_GT(all.places, 1000);
    EXPECT_GT(all.outline, all.places / 10);
    EXPECT_LT(all.outline, all.places);
}

TEST(Outline, IsTheWholeContourOfASphere) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        Picture picture(runtime(), stage, eye);
        picture.find();
        const Outline outline = outline_of(picture);
        ASSERT_EQ(outline.parts.size(), 1);
        EXPECT_EQ(outline.parts[0].end_at - outline.parts[0].begin_at,
                  picture.lengths->total(picture.found->lines.lines[0]));
    }
}

// If a smaller sphere is in front of a larger one, the outline is only that of the larger one. Side by side, both
// count.
TEST(Outline, IsRightForTwoSpheres) {
    const test::SquareSphere sphere;
    const Eye eye = Eye::at({0.3, 0.2, 1.0}, 9.0, false, 100.0);
    const auto length = [&](const glm::dvec3& place) {
        Stage stage;
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1, moved(place, 0.5));
        add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
        Picture picture(runtime(), stage, eye);
        picture.find();
        return length_of(outline_of(picture));
    };
    EXPECT_NEAR(length(2.0 * eye.back), 200.0 * pi, 0.1);
    EXPECT_NEAR(length(-2.0 * eye.back), 200.0 * pi, 0.1); // hidden
    EXPECT_NEAR(length(3.0 * eye.right), 300.0 * pi, 0.1);
    // The small sphere overlaps in part: arcs of circles of radius 100 and 50 whose centres are 100 apart.
    const double large = 2.0 * std::acos((100.0 * 100.0 + 100.0 * 100.0 - 50.0 * 50.0) / (2.0 * 100.0 * 100.0));
    const double small = 2.0 * std::acos((100.0 * 100.0 + 50.0 * 50.0 - 100.0 * 100.0) / (2.0 * 100.0 * 50.0));
    for (const double before : {2.0, -2.0})
        EXPECT_NEAR(length(eye.right + before * eye.back), 300.0 * pi - 100.0 * large - 50.0 * small, 0.2);
}

TEST(Outline, IsRightForATorusFromEverywhere) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    expect_right_from_everywhere(stage, 0.1, 4.0, 30);
}

TEST(Outline, IsRightForAKnotFromEverywhere) {
    const test::Knot knot;
    Stage stage;
    add(runtime(), stage, knot, {1.0 + test::Knot::tube, 0.0, 0.0}, 0.05);
    expect_right_from_everywhere(stage, 0.05, 4.0, 30);
}

TEST(Outline, IsRightForLinkedAndMirroredItems) {
    const test::Torus torus(1.0, 0.3);
    Stage stage;
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1);
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1,
        glm::dmat4({1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {1.0, 0.05, 0.02, 1.0}));
    expect_right_from_everywhere(stage, 0.2, 5.0, 30);
}

TEST(Outline, IsFoundOnlyForWantedItems) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    Picture picture(runtime(), stage, Eye::at({1.0, 0.0, 0.0}, 3.0, true));
    picture.find();
    const std::vector<std::uint8_t> wanted{0};
    const Outline none =
        find_outline(runtime(), picture.subjects, picture.occluders, *picture.found, *picture.lengths, wanted);
    EXPECT_EQ(none.parts.size() + none.rays, 0);
}

} // namespace
} // namespace hrbfnpr::visibility::outline_test
