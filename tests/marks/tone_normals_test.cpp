// SPDX-License-Identifier: MIT
// Tests the normals that determine tone: the grain of a surface is smoothed away, its sheets and edges stay.
#include "support/instruction_sets.h"
#include "support/point_sets.h"
#include "support/runtime.h"

#include "base/random.h"
#include "marks/assemble.h"

#include <cmath>

namespace hrbfnpr::marks::tone_normals_test {
namespace {

using namespace test;

constexpr int side = 100;
constexpr double spacing = 0.01;
constexpr double length = 0.05;

Marks no_marks() { return Marks(runtime().memory); }

// Adds a square of marks in the plane of u and v. Their normals are tilted by up to `grain` in any direction.
void add_square(Marks& marks, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double grain) {
    for (int i = 0; i < side * side; ++i) {
        const auto tilt = base::uniform4(5, static_cast<std::uint64_t>(i), base::Purpose::candidate);
        marks.position.push_back(corner + spacing * (static_cast<double>(i % side) * u + double(i / side) * v));
        marks.normal.push_back(
            glm::normalize(glm::cross(u, v) + grain * (tilt[0] - 0.5) * u + grain * (tilt[1] - 0.5) * v));
        marks.rank.push_back(0.0F);
    }
}

base::Array<float> softened(const Marks& marks, double over = length, const base::Runtime& own = runtime()) {
    static const Sphere anything;
    const Site site{own, anything, 1e-7, 1};
    base::Array<float> result(own.memory);
    average_normals(site, marks, over, spacing, result);
    EXPECT_EQ(result.size(), 3 * marks.count());
    return result;
}

double off(const base::Array<float>& normals, std::int64_t begin, const glm::dvec3& expected) {
    double most = 0.0;
    for (std::int64_t i = begin; i < begin + side * side; ++i)
        most = std::max(most, glm::distance(vec(normals, i), expected));
    return most;
}

TEST(ToneNormals, SmoothTheRoughnessOfASurface) {
    Marks marks = no_marks();
    add_square(marks, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0);
    double grain = 0.0;
    for (std::int64_t i = 0; i < marks.count(); ++i)
        grain = std::max(grain, glm::distance(marks.normal[i], glm::dvec3(0, 0, 1)));
    EXPECT_GT(grain, 0.55);
    const double near = off(softened(marks), 0, {0, 0, 1});
    EXPECT_LT(near, 0.3);
    EXPECT_LT(off(softened(marks, 0.01), 0, {0, 0, 1}), grain);
    EXPECT_GT(off(softened(marks, 0.01), 0, {0, 0, 1}), near) << "over less";
    const base::Array<float> all = softened(marks);
    for (std::int64_t i = 0; i < marks.count(); ++i) ASSERT_NEAR(glm::length(vec(all, i)), 1.0, 1e-6);
}

TEST(ToneNormals, FollowACurve) {
    Marks marks = no_marks();
    for (int i = 0; i < side * side; ++i) { // a cylinder of radius 1
        const double angle = spacing * static_cast<double>(i % side);
        const glm::dvec3 normal(std::cos(angle), std::sin(angle), 0.0);
        marks.position.push_back(normal + glm::dvec3(0.0, 0.0, spacing * double(i / side)));
        marks.normal.push_back(normal);
        marks.rank.push_back(0.0F);
    }
    const base::Array<float> soft = softened(marks);
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const bool inside = i % side > 12 && i % side < side - 12; // skips marks near the ends of the arc
        if (inside) {
            ASSERT_LT(glm::distance(vec(soft, i), marks.normal[i]), 0.02) << i;
        }
    }
}

TEST(ToneNormals, KeepSheetsApartAndEdgesSharp) {
    Marks marks = no_marks();
    add_square(marks, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.0);
    add_square(marks, {0, 0, -0.02}, {0, 1, 0}, {1, 0, 0}, 0.0); // the back of the square
    add_square(marks, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.0);     // a wall on the square
    const base::Array<float> soft = softened(marks);
    EXPECT_LT(off(soft, 0, {0, 0, 1}), 1e-6);
    EXPECT_LT(off(soft, side * side, {0, 0, -1}), 1e-6);
    EXPECT_LT(off(soft, 2 * side * side, {1, 0, 0}), 1e-6);
}

// Computes the average for one mark by its definition, from one of `each` marks.
glm::dvec3 plain_average(const Marks& marks, std::int64_t i, std::int64_t each, double radius) {
    const glm::dvec3 own = marks.normal[i];
    glm::dvec3 sum = own;
    for (std::int64_t k = 0; k < marks.count(); k += each) {
        const glm::dvec3 way = marks.position[k] - marks.position[i];
        const double square = glm::dot(way, way);
        const double agree = glm::dot(own, marks.normal[k]);
        if (square >= radius * radius || agree <= 0.0 || std::abs(glm::dot(way, own)) > 0.7 * std::sqrt(square))
            continue;
        const double near = 1.0 - square / (radius * radius);
        sum += near * near * agree * marks.normal[k];
    }
    return glm::normalize(sum);
}

TEST(ToneNormals, EqualAPlainSumWithTheSameBitsOnEveryInstructionSet) {
    Marks marks = no_marks();
    add_square(marks, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0);
    add_square(marks, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5);
    const base::Array<float> soft = softened(marks);
    constexpr std::int64_t each = 4; // a circle of two lengths has 314 marks, of which about 64 are used
    for (std::int64_t i = 0; i < marks.count(); i += 17)
        ASSERT_LT(glm::distance(vec(soft, i), plain_average(marks, i, each, 2.0 * length)), 1e-6) << i;
    for (const base::InstructionSet set : instruction_sets()) {
        const base::Runtime runtime_of_set{nullptr, nullptr, nullptr, base::Parallel(1, nullptr, nullptr),
                                           set,     nullptr, nullptr};
        EXPECT_TRUE(same_bits(softened(marks, length, runtime_of_set), soft)) << name(set);
    }
}

TEST(ToneNormals, ExistOnlyForLayersThatRequestThem) {
    generate::Settings settings = blue({Kind::stipples, Kind::hatch}, 2000);
    of(settings, Kind::hatch).hatching.separation = 0.1;
    EXPECT_TRUE(of(make(Torus(), settings), Kind::stipples).tone_normal.empty());
    const PointSet set = make(Torus(), settings);
    const Layer& hatch = of(set, Kind::hatch);
    ASSERT_EQ(hatch.tone_normal.size(), hatch.normal.size());
    for (std::int64_t i = 0; i < hatch.count(); ++i)
        ASSERT_LT(glm::distance(vec(hatch.tone_normal, i), vec(hatch.normal, i)), 0.03);
    of(settings, Kind::hatch).tone_smoothing = 0.0;
    of(settings, Kind::stipples).tone_smoothing = 0.02;
    const PointSet other = make(Torus(), settings);
    EXPECT_TRUE(of(other, Kind::hatch).tone_normal.empty());
    EXPECT_EQ(of(other, Kind::stipples).tone_normal.size(), of(other, Kind::stipples).normal.size());
}

} // namespace
} // namespace hrbfnpr::marks::tone_normals_test
