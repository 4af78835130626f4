// SPDX-License-Identifier: MIT
#include "features/soft_edges.h"

#include "feature_shapes.h"
#include "features/line_set.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace hrbfnpr::curves::soft_edges_test {
namespace {

using namespace test_features;
using test_shapes::seeds;

constexpr double pi = 3.14159265358979323846;
constexpr SoftEdgeRequest usual{15.0, 35.0, 0.01};

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

SoftEdges edges_of(const implicit::Implicit& surface, const glm::dvec3& seed, double side,
                   const SoftEdgeRequest& request = usual) {
    const SurfaceMesh mesh =
        triangulate(runtime(), surface, seeds(runtime(), {seed}), test_shapes::settings(surface, side));
    EXPECT_GT(mesh.triangles(), 1000);
    return find_soft_edges(runtime(), surface, mesh, request);
}

// Two planes through the line along `axis` that meet in an edge at which normals turn by an angle, with a rounding of
// about the given radius. If `sign` is -1, the edge is a fold.
class Wedge {
public:
    Wedge(double degrees, double radius, double sign)
        : axis(glm::normalize(glm::dvec3(0.3, 0.2, 1.0))), sign_(sign), sharpness_(1.0 / radius) {
        const glm::dvec3 middle = glm::normalize(glm::cross(axis, glm::dvec3(1.0, -0.4, 0.1)));
        const glm::dvec3 aside = glm::cross(axis, middle);
        const double half = 0.5 * degrees * pi / 180.0;
        left_ = std::cos(half) * middle - std::sin(half) * aside;
        right_ = std::cos(half) * middle + std::sin(half) * aside;
        aside_ = aside;
    }
    [[nodiscard]] Field operator()(const glm::dvec3& p) const {
        const double a = sharpness_ * sign_ * glm::dot(left_, p);
        const double b = sharpness_ * sign_ * glm::dot(right_, p);
        const double most = std::max(a, b);
        const double wa = std::exp(a - most);
        const double wb = std::exp(b - most);
        return {sign_ * (most + std::log(wa + wb)) / sharpness_, (wa * left_ + wb * right_) / (wa + wb), {}};
    }
    [[nodiscard]] double off_edge(const glm::dvec3& p) const { return std::abs(glm::dot(aside_, p)); }

    const glm::dvec3 axis;

private:
    double sign_, sharpness_;
    glm::dvec3 left_, right_, aside_;
};

const geometry::Bounds cube{glm::dvec3(-1.0), glm::dvec3(1.0)};

TEST(SoftEdges, TheStrengthOfARoundEdgeIsItsAngle) {
    constexpr double side = 0.04;
    for (const double sign : {1.0, -1.0})
        for (const double degrees : {40.0, 70.0, 100.0}) {
            const Wedge wedge(degrees, 0.01, sign);
            const AnyField field(cube, wedge);
            const SoftEdges found = edges_of(field, glm::dvec3(0.0), side);
            const SurfaceLines& lines = sign > 0.0 ? found.convex : found.concave;
            EXPECT_EQ((sign > 0.0 ? found.concave : found.convex).curves.count(), 0);
            ASSERT_EQ(lines.curves.count(), 1) << degrees << " " << sign;
            double least = 1.0;
            double most = -1.0;
            for (std::int64_t i = 0; i < lines.curves.point.size(); ++i) {
                const glm::dvec3& p = lines.curves.point[i].position;
                const double along = glm::dot(wedge.axis, p);
                least = std::min(least, along);
                most = std::max(most, along);
                if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 0.85) continue; // the walls of the cube
                EXPECT_LT(wedge.off_edge(p), 0.5 * side);
                EXPECT_NEAR(field.at(p).value, 0.0, 1e-8);
                EXPECT_NEAR(static_cast<double>(lines.strength[i]), degrees, 0.1 * degrees);
            }
            EXPECT_GT(most - least, 1.8) << "the line goes from wall to wall of the cube";
        }
}

TEST(SoftEdges, WeakEdgesAreNotFound) {
    const AnyField field(cube, Wedge(25.0, 0.01, 1.0));
    EXPECT_EQ(edges_of(field, glm::dvec3(0.0), 0.04).convex.curves.count(), 0);
    EXPECT_EQ(edges_of(field, glm::dvec3(0.0), 0.04, {15.0, 20.0, 0.01}).convex.curves.count(), 1);
}

TEST(SoftEdges, ARoundSurfaceHasNone) {
    const test::Torus torus(1.0, 0.35);
    const test::Torus thin(1.0, 0.08);
    for (const test::Torus* const ring : {&torus, &thin}) {
        const SoftEdges found = edges_of(*ring, {ring == &torus ? 1.35 : 1.08, 0.0, 0.0}, 0.03);
        EXPECT_EQ(found.convex.curves.count() + found.concave.curves.count(), 0);
    }
}

// Waves in random directions, whose normals are off by an angle on average.
class Noise {
public:
    Noise(double degrees, double shortest, double longest) {
        std::mt19937 random(7);
        const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
        for (int i = 0; i < 200; ++i) {
            glm::dvec3 way(2.0 * next() - 1.0, 2.0 * next() - 1.0, 2.0 * next() - 1.0);
            way = 2.0 * pi / (shortest + (longest - shortest) * next()) * glm::normalize(way);
            wave_.push_back({way, 2.0 * pi * next()});
        }
        // The mean square of the slope along the surface is a third for each wave.
        slope_ = degrees * pi / 180.0 / std::sqrt(static_cast<double>(wave_.size()) / 3.0);
    }
    void add_to(Field& field, const glm::dvec3& p) const {
        for (const Wave& wave : wave_) {
            const double size = slope_ / glm::length(wave.way);
            field.value += size * std::sin(glm::dot(wave.way, p) + wave.phase);
            field.gradient += size * std::cos(glm::dot(wave.way, p) + wave.phase) * wave.way;
        }
    }

private:
    struct Wave {
        glm::dvec3 way;
        double phase;
    };
    std::vector<Wave> wave_;
    double slope_ = 0.0;
};

TEST(SoftEdges, NoiseHasNone) {
    const double side = 0.03;
    const Noise noise(8.0, 3.0 * side, 10.0 * side);
    const AnyField plane(cube, [&](const glm::dvec3& p) {
        Field field{
            glm::dot(glm::normalize(glm::dvec3(0.2, 0.1, 1.0)), p), glm::normalize(glm::dvec3(0.2, 0.1, 1.0)), {}};
        noise.add_to(field, p);
        return field;
    });
    const AnyField ball({glm::dvec3(-1.2), glm::dvec3(1.2)}, [&](const glm::dvec3& p) {
        Field field{glm::length(p) - 1.0, glm::normalize(p), {}};
        noise.add_to(field, p);
        return field;
    });
    for (const AnyField* const field : {&plane, &ball}) {
        const glm::dvec3 seed(0.0, 0.0, field == &plane ? 0.0 : 1.0);
        const SoftEdges found = edges_of(*field, seed, side);
        EXPECT_EQ(found.convex.curves.count(), 0);
        EXPECT_EQ(found.concave.curves.count(), 0);
    }
}

TEST(SoftEdges, AnEdgeIsFoundInNoise) {
    const double side = 0.03;
    const Noise noise(15.0, 1.5 * side, 4.0 * side);
    const Wedge wedge(80.0, 0.02, 1.0);
    const AnyField field(cube, [&](const glm::dvec3& p) {
        Field of = wedge(p);
        noise.add_to(of, p);
        return of;
    });
    const SoftEdges found = edges_of(field, glm::dvec3(0.0), side);
    const Curves& lines = found.convex.curves;
    EXPECT_LE(lines.count(), 2) << "without smoothing, noise breaks the line";
    double least = 1.0;
    double most = -1.0;
    for (const CurvePoint& p : lines.point) {
        EXPECT_LT(wedge.off_edge(p.position), 2.0 * side);
        least = std::min(least, glm::dot(wedge.axis, p.position));
        most = std::max(most, glm::dot(wedge.axis, p.position));
    }
    EXPECT_GT(most - least, 1.8);
}

TEST(SoftEdges, SameBitsForAnyNumberOfThreads) {
    const AnyField field(cube, Wedge(70.0, 0.02, 1.0));
    const SurfaceMesh mesh =
        triangulate(runtime(), field, seeds(runtime(), {glm::dvec3(0.0)}), test_shapes::settings(field, 0.04));
    const SoftEdges some = find_soft_edges(runtime(), field, mesh, usual);
    base::Runtime one = test::with_threads(1);
    const SoftEdges same = find_soft_edges(one, field, mesh, usual);
    const base::Array<CurvePoint>& a = some.convex.curves.point;
    const base::Array<CurvePoint>& b = same.convex.curves.point;
    ASSERT_GT(a.size(), 10);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(CurvePoint)), 0);
}

TEST(SoftEdges, ALineSetHasEdgesAndFoldsByName) {
    const AnyField field(cube, Wedge(70.0, 0.02, -1.0));
    LineRequest request;
    request.kind = LineKind::soft_edge;
    std::strcpy(request.name.data(), "rim");
    LineSetSettings settings;
    settings.side = 0.04;
    const std::array<double, 3> seed = {0.0, 0.0, 0.0};
    settings.seeds = seed;
    settings.lines = {&request, 1};
    const LineSet set(runtime(), field, std::make_unique<implicit::DifferencedShape>(field), settings);
    ASSERT_EQ(set.found().size(), 2U);
    EXPECT_FALSE(set.has_shape()) << "soft edges need no derivatives of curvatures";
    std::int64_t lines = 0;
    for (const FoundLines& found : set.found()) {
        EXPECT_EQ(found.kind, LineKind::soft_edge);
        EXPECT_STREQ(found.name.data(), "rim");
        EXPECT_EQ(found.lines.curves.count(), found.concave ? 1 : 0);
        EXPECT_TRUE(found.is_on(CreaseSide::both));
        EXPECT_EQ(found.is_on(CreaseSide::convex), !found.concave);
        EXPECT_EQ(found.is_on(CreaseSide::concave), found.concave);
        lines += found.lines.curves.count();
    }
    EXPECT_EQ(lines, 1);
}

} // namespace
} // namespace hrbfnpr::curves::soft_edges_test
