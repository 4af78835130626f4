// SPDX-License-Identifier: MIT
// Clusters of marks are complete and ordered, and the data of each cluster are right.
#include "marks/point_set.h"

#include "frame/hand_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::testing::clusters_test {
namespace {

using marks::Cluster;
using marks::MarkClusters;

glm::dvec3 vector_of(const std::array<float, 3>& a) {
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}
// A mark, found by its place in the blocks.
struct Placed {
    glm::dvec3 position, normal;
    float rank;
    std::uint32_t mark;
};

Placed placed(const MarkClusters& m, std::int64_t place) {
    const marks::MarkBlock& b = m.block[place / marks::MarkBlock::size];
    const std::int64_t i = place % marks::MarkBlock::size;
    return {vector_of({b.x[i], b.y[i], b.z[i]}), vector_of({b.nx[i], b.ny[i], b.nz[i]}), b.rank[i], b.mark[i]};
}

// Checks that the pieces cover all marks of all strokes, in their order.
void expect_sound_pieces(const marks::Layer& layer) {
    std::int64_t number = 0;
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        std::int64_t place = layer.stroke_first[s];
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t k = marks::pieces_of(end - place); k > 0; --k) {
            const marks::StrokePiece& piece = layer.clusters.piece[number++];
            ASSERT_EQ(std::int64_t{piece.first}, place);
            std::uint8_t level = 255;
            for (std::int64_t i = 0; i < piece.count; ++i, ++place) {
                const std::int64_t mark = layer.mark_of(place);
                const glm::dvec3 p(marks::vector_at(layer.position, mark));
                const glm::dvec3 n(marks::vector_at(layer.normal, mark));
                ASSERT_LE(glm::length(p - vector_of(piece.centre)), static_cast<double>(piece.radius) + 1e-7);
                ASSERT_GE(glm::dot(n, vector_of(piece.cone.axis)), static_cast<double>(piece.cone.cosine));
                const glm::dvec3 soft(
                    layer.tone_normal.empty() ? n : glm::dvec3(marks::vector_at(layer.tone_normal, mark)));
                ASSERT_GE(glm::dot(soft, vector_of(piece.tone.axis)), static_cast<double>(piece.tone.cosine));
                ASSERT_NEAR(std::hypot(piece.tone.cosine, piece.tone.sine), 1.0F, 1e-5F);
                level = std::min(level, layer.level[mark]);
            }
            ASSERT_EQ(piece.level, level);
        }
        ASSERT_EQ(place, end);
    }
    ASSERT_EQ(number, layer.clusters.piece.size());
}

void expect_sound(const marks::Layer& layer, bool strokes = false) {
    const MarkClusters& m = layer.clusters;
    constexpr std::int64_t size = marks::MarkBlock::size;
    std::vector<int> met(static_cast<std::size_t>(layer.count()), 0);
    std::int64_t blocks = 0;
    for (const Cluster& c : m.cluster) {
        ASSERT_EQ(c.block, blocks);
        ASSERT_GT(c.count, 0);
        ASSERT_LE(c.count, marks::most_in_cluster);
        blocks += (c.count + size - 1) / size;
        ASSERT_LE(blocks, m.block.size());
        const glm::dvec3 axis = vector_of(c.cone.axis);
        ASSERT_NEAR(glm::length(axis), 1.0, 1e-6);
        ASSERT_NEAR(c.cone.cosine * c.cone.cosine + c.cone.sine * c.cone.sine, 1.0F, 1e-5F);
        for (std::int64_t place = c.block * size; place < c.block * size + c.count; ++place) {
            const Placed p = placed(m, place);
            ASSERT_LT(p.mark, layer.count());
            const std::int64_t mark = p.mark;
            ++met[static_cast<std::size_t>(mark)];
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(static_cast<float>(p.position[k]), layer.position[3 * mark + k]);
                ASSERT_EQ(static_cast<float>(p.normal[k]), layer.normal[3 * mark + k]);
            }
            ASSERT_EQ(p.rank, layer.rank[mark]);
            if (!layer.width.empty()) {
                ASSERT_EQ(m.width[place], layer.width[mark]);
            }
            if (place > c.block * size) {
                ASSERT_LE(p.rank, placed(m, place - 1).rank);
            }
            ASSERT_LE(glm::length(p.position - vector_of(c.centre)), static_cast<double>(c.radius) + 1e-7);
            ASSERT_GE(glm::dot(p.normal, axis), static_cast<double>(c.cone.cosine));
            ASSERT_EQ(c.direction, strokes ? layer.stroke[2 * mark] & 1U : 0U);
        }
    }
    ASSERT_EQ(blocks, m.block.size());
    ASSERT_EQ(m.width.empty(), layer.width.empty());
    for (const int times : met) ASSERT_EQ(times, 1);
    expect_sound_pieces(layer);
}

class Clusters : public ::testing::Test {
protected:
    base::Runtime runtime;
};

TEST_F(Clusters, HoldEveryMarkOnceAndBoundThem) {
    for (const int count : {1, 2, 3, 127, 128, 129, 5000, 200000}) {
        const marks::PointSet set = clustered(runtime, sphere(runtime.memory, count));
        expect_sound(set.layers[0]);
        if (count == 200000) { // the number of clusters is limited, too
            EXPECT_LT(set.layers[0].clusters.cluster.size(), 200000 / 20);
        }
        EXPECT_GE(set.bytes(), set.layers[0].clusters.bytes());
    }
    expect_sound(clustered(runtime, torus(runtime.memory, 150)).layers[0]);
    expect_sound(clustered(runtime, plane(runtime.memory, 70)).layers[0]);
}

TEST_F(Clusters, StrokesHaveOneSetOfClustersEach) {
    marks::PointSet set = torus(runtime.memory, 40);
    add_torus_strokes(set, marks::Kind::hatch, 400, 27, 0.3);
    add_torus_strokes(set, marks::Kind::own, 100, 9, 0.3);
    for (std::int64_t i = 0; i < set.layers[1].count(); ++i)
        set.layers[1].width.push_back(0.1F + 0.9F * static_cast<float>(i % 7) / 7.0F);
    for (const float x : set.layers[2].direction) set.layers[2].tone_normal.push_back(x); // far from the marks' normals
    marks::cluster_marks(runtime, set);
    expect_sound(set.layers[0]);
    expect_sound(set.layers[1], true);
    expect_sound(set.layers[2], true);
    // Clustering again keeps nothing of the first result.
    const std::int64_t clusters = set.layers[1].clusters.cluster.size();
    marks::cluster_marks(runtime, set);
    EXPECT_EQ(set.layers[1].clusters.cluster.size(), clusters);
    expect_sound(set.layers[1], true);
}

TEST_F(Clusters, AcceptDegenerateSets) {
    marks::PointSet empty(runtime.memory);
    marks::cluster_marks(runtime, empty);
    EXPECT_TRUE(empty.layers.empty());
    marks::PointSet bare(runtime.memory);
    layer_of(bare, marks::Kind::stipples);
    marks::cluster_marks(runtime, bare);
    EXPECT_TRUE(bare.layers[0].clusters.cluster.empty());
    marks::PointSet heap(runtime.memory); // 300 marks at one place with the same normal
    for (int i = 0; i < 300; ++i) add_stipple(heap, {0.5, 0.25, -2.0}, {0.0, 0.6, 0.8});
    marks::cluster_marks(runtime, heap);
    expect_sound(heap.layers[0]);
    for (const Cluster& c : heap.layers[0].clusters.cluster) EXPECT_EQ(c.radius, 0.0F);
    marks::PointSet star(runtime.memory); // marks at one place with normals in all directions
    for (int i = 0; i < 1000; ++i) add_stipple(star, {1.0, 1.0, 1.0}, spiral_direction(i, 1000));
    marks::cluster_marks(runtime, star);
    expect_sound(star.layers[0]);
    marks::PointSet opposite(runtime.memory);
    add_stipple(opposite, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    add_stipple(opposite, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
    marks::cluster_marks(runtime, opposite);
    expect_sound(opposite.layers[0]);
    marks::PointSet line(runtime.memory);
    for (int i = 0; i < 1000; ++i) add_stipple(line, {0.001 * i, 0.0, 0.0}, {0.0, 0.0, 1.0});
    marks::cluster_marks(runtime, line);
    expect_sound(line.layers[0]);
    marks::PointSet far(runtime.memory);
    for (int i = 0; i < 500; ++i) add_stipple(far, 1e30 * spiral_direction(i, 500), spiral_direction(i, 500));
    marks::cluster_marks(runtime, far);
    EXPECT_FALSE(far.layers[0].clusters.cluster.empty());
}

// Positions, centres and radii are in the set's unit, so the result does not depend on the size.
TEST_F(Clusters, AreFiniteForAnyFiniteMarks) {
    const marks::PointSet unit = clustered(runtime, sphere(runtime.memory, 3000));
    ASSERT_EQ(unit.unit, 1.0);
    for (const int power : {-149, -140, -100, -66, 66, 100, 127}) {
        SCOPED_TRACE(power);
        marks::PointSet set(runtime.memory);
        for (std::int64_t i = 0; i < unit.layers[0].count(); ++i)
            add_stipple(set, std::ldexp(1.0, power) * glm::dvec3(marks::vector_at(unit.layers[0].position, i)),
                        glm::dvec3(marks::vector_at(unit.layers[0].normal, i)));
        for (float& coordinate : set.layers[0].position)
            coordinate =
                std::clamp(coordinate, std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max());
        marks::cluster_marks(runtime, set);
        ASSERT_NE(set.unit, 1.0);
        std::int64_t marks = 0;
        for (const Cluster& c : set.layers[0].clusters.cluster) {
            marks += c.count;
            ASSERT_LT(c.radius, 8.0F);
            for (const float number : {c.radius, c.max_curvature, c.cone.axis[0], c.shape[0], c.shape[3], c.shape[5]})
                ASSERT_TRUE(std::isfinite(number));
        }
        EXPECT_EQ(marks, set.layers[0].count());
        if (power < -100 || power > 100) continue; // here some digits are lost
        const marks::MarkBlock& small = set.layers[0].clusters.block[0];
        const marks::MarkBlock& same = unit.layers[0].clusters.block[0];
        EXPECT_EQ(set.layers[0].clusters.cluster.size(), unit.layers[0].clusters.cluster.size());
        EXPECT_EQ(small.mark[3], same.mark[3]);
        EXPECT_EQ(small.rank[3], same.rank[3]);
        EXPECT_EQ(double{small.x[3]} * set.unit, std::ldexp(double{same.x[3]}, power));
    }
    marks::PointSet ends(runtime.memory); // as far apart as floats allow
    constexpr double most = std::numeric_limits<float>::max();
    for (int i = 0; i < 400; ++i)
        add_stipple(ends, (i % 3 == 0 ? -most : i % 3 == 1 ? most : 1e-45) * glm::dvec3(1.0), spiral_direction(i, 400));
    marks::cluster_marks(runtime, ends);
    for (const Cluster& c : ends.layers[0].clusters.cluster) EXPECT_TRUE(std::isfinite(c.radius));
}

// No file and no array gives such positions. This makes sure that the undefined-behaviour sanitizer has nothing to
// report.
TEST_F(Clusters, AcceptNonFiniteMarks) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    marks::PointSet set(runtime.memory);
    for (int i = 0; i < 300; ++i)
        add_stipple(set, {i % 7 == 0 ? nan : 0.1 * i, i % 5 == 0 ? HUGE_VAL : 1.0, 0.0}, {0.0, 0.0, 1.0});
    marks::cluster_marks(runtime, set);
    EXPECT_FALSE(set.layers[0].clusters.cluster.empty());
}

// t . S t for a tangent direction t.
double curvature(const Cluster& c, const glm::dvec3& t) {
    const auto s = [&](std::size_t k) { return static_cast<double>(c.shape[k]); };
    return t.x * (s(0) * t.x + 2.0 * (s(1) * t.y + s(2) * t.z)) + t.y * (s(3) * t.y + 2.0 * s(4) * t.z) +
           t.z * s(5) * t.z;
}

// The tangents and curvatures that are expected at a centre. share_off() returns the share of the marks whose cluster's
// shape is off by more than 5 % of the largest curvature.
struct Tangents {
    glm::dvec3 first, second;
    double first_curvature, second_curvature;
};

template <class Wanted>
double share_off(const marks::Layer& layer, double largest, const Wanted& wanted) {
    std::int64_t off = 0;
    for (const Cluster& c : layer.clusters.cluster) {
        const Tangents t = wanted(vector_of(c.centre));
        const double error = std::max(std::abs(curvature(c, t.first) - t.first_curvature),
                                      std::abs(curvature(c, t.second) - t.second_curvature));
        if (error > 0.05 * largest) off += c.count;
        if (c.max_curvature < 0.0F) { // too few marks to estimate it
            EXPECT_LT(c.count, 12);
            continue;
        }
        EXPECT_GE(static_cast<double>(c.max_curvature), 0.75 * largest);
        EXPECT_LE(static_cast<double>(c.max_curvature),
                  1.6 * largest); // `bend` is a norm: on a sphere sqrt(2) times the curvature
    }
    return static_cast<double>(off) / static_cast<double>(layer.count());
}

TEST_F(Clusters, KnowTheCurvatureOfASphere) {
    for (const double radius : {0.25, 1.0, 40.0}) {
        const auto wanted = [&](const glm::dvec3& centre) {
            const glm::dvec3 t = geometry::any_perpendicular(glm::normalize(centre));
            return Tangents{t, glm::cross(glm::normalize(centre), t), 1.0 / radius, 1.0 / radius};
        };
        const marks::PointSet many = clustered(runtime, sphere(runtime.memory, 200000, radius));
        EXPECT_EQ(share_off(many.layers[0], 1.0 / radius, wanted), 0.0);
        // A cluster of a few marks at the edge of its cell has the shape of the whole cell.
        const marks::PointSet some = clustered(runtime, sphere(runtime.memory, 50000, radius));
        EXPECT_LE(share_off(some.layers[0], 1.0 / radius, wanted), 0.005);
    }
}

TEST_F(Clusters, KnowTheCurvaturesOfATorus) {
    const double minor = 0.45;
    const auto wanted = [&](const glm::dvec3& centre) {
        const glm::dvec3 out = glm::normalize(glm::dvec3(centre.x, centre.y, 0.0));
        const glm::dvec3 n = glm::normalize(centre - out);
        const glm::dvec3 along(-out.y, out.x, 0.0);
        return Tangents{glm::cross(n, along), along, 1.0 / minor, glm::dot(n, out) / (1.0 + minor * glm::dot(n, out))};
    };
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 400, minor));
    EXPECT_LE(share_off(set.layers[0], 1.0 / minor, wanted), 0.005);
}

} // namespace
} // namespace hrbfnpr::testing::clusters_test
