// SPDX-License-Identifier: MIT
// Tests that all crossings of lines are found, on both curves, and with the nearer curve by distance.
#include "visibility/image_lines.h"

#include "stage.h"
#include "support/contour_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hrbfnpr::visibility::crossings_test {
namespace {

using namespace test_stage;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

struct Seen3 {
    glm::dvec2 place;
    double away; // distance from the eye, or along the view direction
};

Seen3 seen_at(const Picture& picture, std::int32_t number, double share) {
    const Piece& piece = picture.found->lines.pieces[number];
    const Subject& subject = picture.subjects[static_cast<std::size_t>(piece.subject)];
    const glm::dvec3 p = cubic(picture.subjects, piece).at(share);
    const glm::dvec3 in_world(subject.to_world * glm::dvec4(p, 1.0));
    const glm::dvec4 eye = subject.to_world * subject.view.eye;
    return {subject.view.see(p).place,
            eye.w != 0.0 ? glm::distance(in_world, glm::dvec3(eye)) : glm::dot(in_world, glm::dvec3(eye))};
}

// Counts by brute force the segments of a finer image that cross. Pieces near each other along a line are skipped:
// beside a cusp cubics may cross where their curves do not.
std::int64_t count_crossings(const Picture& picture) {
    const ImageLines lines = draw_lines(runtime(), picture.subjects, 1e-3);
    std::vector<std::int64_t> segments;
    for (const Line& line : lines.lines)
        for (std::int64_t i = line.first_point; i + 1 < line.first_point + line.points; ++i) segments.push_back(i);
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const auto between = [&](std::int64_t s, std::int64_t t) {
        const glm::dvec2 a = lines.points[s].place, b = lines.points[s + 1].place;
        const glm::dvec2 c = lines.points[t].place, d = lines.points[t + 1].place;
        if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
        return (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0) &&
               (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
    };
    std::int64_t count = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (std::size_t j = i + 1; j < segments.size(); ++j) {
            const std::int32_t p = lines.points[segments[i]].piece, q = lines.points[segments[j]].piece;
            const Line& line = lines.lines[lines.pieces[p].line];
            const bool beside = lines.pieces[p].line == lines.pieces[q].line &&
                                (std::abs(p - q) <= 3 || std::abs(p - q) >= line.pieces - 3);
            if (!beside && between(segments[i], segments[j])) ++count;
        }
    return count;
}

class Crossings : public testing::Test {
protected:
    void check_all(const Stage& stage, double distance) {
        const std::vector<Eye> eyes = test::eyes(cube_directions(0.1), distance);
        for (std::size_t i = 0; i < eyes.size(); i += 3) check(stage, eyes[i]);
    }
    void check(const Stage& stage, const Eye& eye) {
        SCOPED_TRACE(named(eye));
        Picture picture(runtime(), stage, eye);
        picture.find();
        all += picture.found->crossings.size();
        for (const Crossing& c : picture.found->crossings) {
            const Seen3 far = seen_at(picture, c.far_piece, c.far_share);
            const Seen3 near = seen_at(picture, c.near_piece, c.near_share);
            EXPECT_LE(glm::distance(far.place, c.place), 1e-6);
            EXPECT_LE(glm::distance(near.place, c.place), 1e-6);
            EXPECT_GT(far.away, near.away);
            EXPECT_EQ(std::abs(c.change), 2);
        }
        EXPECT_EQ(picture.found->crossings.size(), count_crossings(picture));
    }

    std::int64_t all = 0;
};

TEST_F(Crossings, AreFoundOnATorus) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    check_all(stage, 4.0);
    EXPECT_GT(all, 5);
}

TEST_F(Crossings, AreFoundOnAKnot) {
    const test::Knot knot;
    Stage stage;
    add(runtime(), stage, knot, {1.0 + test::Knot::tube, 0.0, 0.0}, 0.05);
    check_all(stage, 4.0);
    EXPECT_GT(all, 300);
}

TEST_F(Crossings, AreFoundBetweenTwoItems) {
    const test::Torus torus(1.0, 0.3);
    Stage stage;
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1);
    glm::dmat4 mirrors(1.0);
    std::swap(mirrors[1], mirrors[2]);
    mirrors[3] = {1.0, 0.05, 0.02, 1.0};
    add(runtime(), stage, torus, {1.3, 0.0, 0.0}, 0.1, mirrors);
    check_all(stage, 5.0);
    EXPECT_GT(all, 150);
}

// A line that reaches the plane of the eye has image points that are nearly infinite. The crossings of other lines are
// found all the same.
TEST_F(Crossings, AreFoundDespiteALineFarOutside) {
    const Eye eye = Eye::at({0.0, 0.0, 1.0}, 4.0, true);
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    curves::Curves line(runtime().memory);
    for (const double from_eye : {6.0, 5.0, 3.0, 1.0, 1e-3, 1e-6, 1e-12, 1e-300}) {
        curves::CurvePoint p;
        p.position = eye.place() - from_eye * eye.back + (5.1 - from_eye) * eye.right;
        p.gradient = eye.up;
        p.level_gradient = glm::cross(eye.back + eye.right, eye.up); // the direction is right and back
        line.point.push_back(p);
    }
    line.first.push_back(line.point.size());
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
    for (const ImagePoint& p : picture.found->lines.points) EXPECT_LT(std::abs(p.place.x), 1e10);
    EXPECT_EQ(picture.found->crossings.size(), 1);
    expect_right(picture, 20);
}

// Crossings are sorted by the farther piece and its share, without duplicates.
TEST_F(Crossings, AreSortedByPieceAndShare) {
    const test::Knot knot;
    Stage stage;
    add(runtime(), stage, knot, {1.0 + test::Knot::tube, 0.0, 0.0}, 0.05);
    Picture picture(runtime(), stage, Eye::at({0.2, 0.5, 1.0}, 4.0, true));
    picture.find();
    const base::Array<Crossing>& found = picture.found->crossings;
    ASSERT_GT(found.size(), 4);
    for (std::int64_t i = 0; i + 1 < found.size(); ++i) {
        const bool later =
            found[i].far_piece < found[i + 1].far_piece ||
            (found[i].far_piece == found[i + 1].far_piece && found[i].far_share < found[i + 1].far_share);
        EXPECT_TRUE(later);
    }
}

// Two circles overlap less and less. Newton's steps from one of their two crossings may end at the other.
TEST(TouchingLines, HaveBalancedCrossings) {
    const test::SquareSphere large(1.0, 1.2);
    const test::SquareSphere small(0.7, 1.2);
    int crossed = 0;
    for (int i = 0; i < 60; ++i) {
        const double overlap = 1e-2 * std::pow(0.75, i);
        const double angle = 0.37 * i;
        const double away = 1.7 - overlap;
        const glm::dvec3 place(away * std::cos(angle), away * std::sin(angle), 3.0);
        Stage stage;
        add(runtime(), stage, large, {1.0, 0.0, 0.0}, 0.2);
        add(runtime(), stage, small, {0.7, 0.0, 0.0}, 0.2, glm::translate(glm::dmat4(1.0), place));
        Picture picture(runtime(), stage, Eye::at({0.0, 0.0, 1.0}, 10.0, false));
        picture.find();
        EXPECT_EQ(picture.worst_sum(), 0) << overlap;
        EXPECT_EQ(picture.found->report.settled, 0) << overlap;
        crossed += picture.found->crossings.empty() ? 0 : 1;
    }
    EXPECT_GT(crossed, 10);
}

// A curve runs back and forth within a hundredth of a pixel of a line. Far away, two lines of two points cross.
TEST(Tangles, HaveFewCrossings) {
    base::Memory& memory = runtime().memory;
    curves::Curves lines(memory);
    const auto add = [&](const glm::dvec3& place, const glm::dvec3& way) {
        curves::CurvePoint p;
        p.position = place;
        p.gradient = {0.0, 0.0, 1.0};
        p.level_gradient = glm::cross(way, p.gradient);
        lines.point.push_back(p);
    };
    const auto end = [&] {
        lines.first.push_back(lines.point.size());
        lines.closed.push_back(0);
    };
    for (int i = 0; i < 3000; ++i) {
        const double x = 0.618 * i - std::floor(0.618 * i);
        add({x, 1e-4 * std::sin(1.0 * i), 0.01 * i}, {i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0});
    }
    end();
    for (const double z : {0.0, 1.0}) {
        const glm::dvec3 way(1.0, z > 0.0 ? 1.0 : -1.0, 0.0);
        add(glm::dvec3(2.0, 2.0, z) - way, way);
        add(glm::dvec3(2.0, 2.0, z) + way, way);
        end();
    }
    Subject subject;
    subject.curves = &lines;
    subject.view.eye = {0.0, 0.0, 1.0, 0.0};
    subject.view.to_window = glm::scale(glm::dmat4(1.0), glm::dvec3(100.0, 100.0, 1.0));
    subject.side = 0.01;
    const std::array subjects{subject};
    const ImageLines image = draw_lines(runtime(), subjects, 0.05);
    CrossingReport report;
    const base::Array<Crossing> found = find_crossings(runtime(), subjects, image, report);
    EXPECT_GT(report.tangles, 10);
    EXPECT_LT(found.size(), 16 * image.points.size());
    EXPECT_EQ(std::count_if(found.begin(), found.end(), [](const Crossing& c) { return c.place.y > 100.0; }), 1);
}

} // namespace
} // namespace hrbfnpr::visibility::crossings_test
