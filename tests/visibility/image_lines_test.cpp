// SPDX-License-Identifier: MIT
// Tests images of curves: their accuracy, and which parts behind the eye are left out.
#include "visibility/image_lines.h"

#include "stage.h"
#include "support/contour_shapes.h"

#include <limits>

namespace hrbfnpr::visibility::image_lines_test {
namespace {

using namespace test_stage;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

double distance_to_chord(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + share * way);
}

// Returns the largest image distance of the cubics from the chords that replace them.
double farthest_off(const Picture& picture, const ImageLines& lines) {
    double farthest = 0.0;
    for (const Line& line : lines.lines)
        for (std::int64_t i = line.first_point; i + 1 < line.first_point + line.points; ++i) {
            const ImagePoint& a = lines.points[i];
            const ImagePoint& b = lines.points[i + 1];
            const Piece& piece = lines.pieces[a.piece];
            const curves::View& view = picture.subjects[static_cast<std::size_t>(piece.subject)].view;
            const double end = b.piece == a.piece ? b.share : 1.0;
            for (int k = 1; k < 8; ++k) {
                const double u = a.share + (end - a.share) * k / 8.0;
                const glm::dvec2 place = view.see(cubic(picture.subjects, piece).at(u)).place;
                farthest = std::max(farthest, distance_to_chord(place, a.place, b.place));
            }
        }
    return farthest;
}

// A line with NaN or huge coordinates does not change the lengths of others.
TEST(Lengths, DoNotDependOnOtherLines) {
    ImageLines lines(runtime().memory);
    const double odd[] = {1.0, 1e300, std::numeric_limits<double>::quiet_NaN()};
    for (std::int32_t l = 0; l < 3; ++l) {
        for (const double far : {odd[l], 3.0}) {
            lines.lines.push_back({0, 0, lines.pieces.size(), 1, lines.points.size(), 3, false});
            const auto piece = static_cast<std::int32_t>(lines.pieces.size());
            lines.points.push_back({{0.0, 0.0}, piece, 0.0});
            lines.points.push_back({{far, 0.0}, piece, 0.5});
            lines.points.push_back({{3.0, 4.0}, piece, 1.0});
            lines.pieces.push_back({0, static_cast<std::int32_t>(lines.lines.size() - 1), 0, 1});
        }
    }
    const LineLengths lengths(runtime().memory, lines);
    for (const std::int64_t l : {1, 3, 5}) {
        const Line& line = lines.lines[l];
        EXPECT_EQ(lengths.total(line), 7.0);
        EXPECT_EQ(lengths.at_point(line.first_point + 1), 3.0);
        EXPECT_EQ(lengths.at(line, line.first_piece, 0.75), 5.0);
    }
}

TEST(ImageLines, StayWithinTheTolerance) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(0.1), 4.0)) {
        const Picture picture(runtime(), stage, eye);
        std::int64_t before = 0;
        for (const double tolerance : {0.5, 0.05, 0.005}) {
            const ImageLines lines = draw_lines(runtime(), picture.subjects, tolerance);
            EXPECT_LE(farthest_off(picture, lines), 1.5 * tolerance);
            EXPECT_GE(lines.points.size(), before);
            before = lines.points.size();
        }
    }
}

TEST(ImageLines, FollowTheOrderOfTheirCurves) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    for (const Eye& eye : test::eyes(cube_directions(0.1), 4.0)) {
        const Picture picture(runtime(), stage, eye);
        const ImageLines lines = draw_lines(runtime(), picture.subjects, 0.05);
        const LineLengths lengths(runtime().memory, lines);
        ASSERT_EQ(lines.lines.size(), 2);
        for (const Line& line : lines.lines) {
            EXPECT_TRUE(line.closed);
            EXPECT_EQ(lines.points[line.first_point].place, lines.points[line.first_point + line.points - 1].place);
            double along = 0.0;
            double sum = 0.0;
            for (std::int64_t i = line.first_point; i + 1 < line.first_point + line.points; ++i) {
                EXPECT_GE(lengths.at(line, lines.points[i].piece, lines.points[i].share), along);
                along = lengths.at(line, lines.points[i].piece, lines.points[i].share);
                sum += glm::distance(lines.points[i].place, lines.points[i + 1].place);
            }
            EXPECT_NEAR(lengths.total(line), sum, 1e-9 * sum);
        }
    }
}

TEST(ImageLines, HaveTheLengthOfACircle) {
    const test::SquareSphere sphere;
    Stage stage;
    add(runtime(), stage, sphere, {1.0, 0.0, 0.0}, 0.1);
    for (const Eye& eye : test::eyes(cube_directions(), 3.0)) {
        const Picture picture(runtime(), stage, eye);
        const ImageLines lines = draw_lines(runtime(), picture.subjects, 0.05);
        // A cone of sight with the half angle asin(1/3) meets the image plane, which is 750 pixels from the eye.
        const double radius = eye.perspective ? 750.0 * std::tan(std::asin(1.0 / 3.0)) : 250.0;
        EXPECT_NEAR(LineLengths(runtime().memory, lines).total(lines.lines[0]), 2.0 * 3.14159265 * radius,
                    0.001 * radius);
        for (const ImagePoint& p : lines.points) EXPECT_NEAR(glm::distance(p.place, glm::dvec2(400.0)), radius, 0.01);
    }
}

// A curve through the eye itself has no image there. All other curves have one.
TEST(ImageLines, AreFiniteWhereTheEyeIsOnTheSurface) {
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime(), stage, torus, {1.4, 0.0, 0.0}, 0.08);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.7 * i;
        const double around = 1.3 * i;
        const double r = 1.0 + 0.4 * std::cos(around);
        const glm::dvec3 place(r * std::cos(angle), r * std::sin(angle), 0.4 * std::sin(around));
        Picture picture(runtime(), stage, Eye::at(place, glm::length(place), true));
        picture.find();
        for (const ImagePoint& p : picture.found->lines.points)
            EXPECT_TRUE(std::isfinite(p.place.x) && std::isfinite(p.place.y));
        for (const Interval& part : picture.found->intervals) EXPECT_TRUE(std::isfinite(part.end_at));
    }
}

} // namespace
} // namespace hrbfnpr::visibility::image_lines_test
