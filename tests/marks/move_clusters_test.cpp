// SPDX-License-Identifier: MIT
// Clusters of marks that have moved keep the same marks, and the data of each cluster are right.
#include "marks/point_set.h"

#include "frame/hand_made.h"
#include "support/allocator.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::testing::move_clusters_test {
namespace {

using marks::Cluster;
using marks::MarkBlock;
using marks::MarkClusters;

struct Moved {
    std::vector<float> position, normal;

    template <class Motion>
    Moved(const marks::Layer& layer, const Motion& motion) {
        for (std::int64_t i = 0; i < layer.count(); ++i) {
            glm::vec3 p = marks::vector_at(layer.position, i);
            glm::vec3 n = marks::vector_at(layer.normal, i);
            motion(p, n);
            for (int k = 0; k < 3; ++k) {
                position.push_back(p[k]);
                normal.push_back(n[k]);
            }
        }
    }
};

glm::vec3 vector_of(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

void expect_sound(const marks::Layer& layer, const Moved& places, double unit, const MarkClusters& moved) {
    const MarkClusters& before = layer.clusters;
    ASSERT_EQ(moved.cluster.size(), before.cluster.size());
    ASSERT_EQ(moved.block.size(), before.block.size());
    ASSERT_TRUE(test::same_bits(moved.width, before.width));
    for (std::int64_t c = 0; c < moved.cluster.size(); ++c) {
        const Cluster& cluster = moved.cluster[c];
        ASSERT_EQ(cluster.block, before.cluster[c].block);
        ASSERT_EQ(cluster.count, before.cluster[c].count);
        ASSERT_EQ(cluster.direction, before.cluster[c].direction);
        ASSERT_NEAR(cluster.cone.cosine * cluster.cone.cosine + cluster.cone.sine * cluster.cone.sine, 1.0F, 1e-5F);
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            const MarkBlock& block = moved.block[cluster.block + i / MarkBlock::size];
            const std::int64_t at = i % MarkBlock::size;
            ASSERT_EQ(block.mark[at], before.block[cluster.block + i / MarkBlock::size].mark[at]);
            ASSERT_EQ(block.rank[at], before.block[cluster.block + i / MarkBlock::size].rank[at]);
            const auto mark = static_cast<std::size_t>(3 * block.mark[at]);
            const glm::vec3 p(block.x[at], block.y[at], block.z[at]);
            const glm::vec3 n(block.nx[at], block.ny[at], block.nz[at]);
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_EQ(p[static_cast<int>(k)],
                          static_cast<float>(static_cast<double>(places.position[mark + k]) / unit));
                ASSERT_EQ(n[static_cast<int>(k)], places.normal[mark + k]);
            }
            // The tolerance is the rounding of the centre.
            const float rounded = 1.1e-7F * (1.0F + glm::length(vector_of(cluster.centre)));
            ASSERT_LE(glm::distance(p, vector_of(cluster.centre)), cluster.radius + rounded);
            ASSERT_GE(glm::dot(n, vector_of(cluster.cone.axis)), cluster.cone.cosine - 1e-6F);
        }
    }
    ASSERT_EQ(moved.piece.size(), before.piece.size());
    for (const marks::StrokePiece& piece : moved.piece) {
        for (std::int64_t i = 0; i < piece.count; ++i) {
            const auto mark = static_cast<std::size_t>(3 * layer.mark_of(piece.first + i));
            glm::vec3 p;
            glm::vec3 n;
            for (std::size_t k = 0; k < 3; ++k) {
                p[static_cast<int>(k)] = static_cast<float>(static_cast<double>(places.position[mark + k]) / unit);
                n[static_cast<int>(k)] = places.normal[mark + k];
            }
            const float rounded = 1.1e-7F * (1.0F + glm::length(vector_of(piece.centre)));
            ASSERT_LE(glm::distance(p, vector_of(piece.centre)), piece.radius + rounded);
            ASSERT_GE(glm::dot(n, vector_of(piece.cone.axis)), piece.cone.cosine - 1e-6F);
        }
    }
}

class MoveClusters : public ::testing::Test {
protected:
    base::Runtime runtime;
    MarkClusters moved{runtime.memory};
};

constexpr auto stay = [](glm::vec3&, glm::vec3&) {};

TEST_F(MoveClusters, MarksThatStayKeepTheirClusters) {
    marks::PointSet made = torus(runtime.memory, 150);
    add_torus_strokes(made, marks::Kind::hatch, 100, 27, 0.3);
    const marks::PointSet set = clustered(runtime, std::move(made));
    for (const marks::Layer& layer : set.layers) {
        const Moved places(layer, stay);
        marks::move_clusters(layer, places.position.data(), places.normal.data(), set.unit, moved);
        expect_sound(layer, places, set.unit, moved);
        for (std::int64_t c = 0; c < moved.cluster.size(); ++c) {
            const Cluster& a = layer.clusters.cluster[c];
            const Cluster& b = moved.cluster[c];
            ASSERT_EQ(a.centre, b.centre) << c;
            ASSERT_EQ(a.radius, b.radius) << c;
            ASSERT_EQ(a.cone.axis, b.cone.axis) << c;
            ASSERT_EQ(a.cone.cosine, b.cone.cosine) << c;
        }
    }
}

TEST_F(MoveClusters, BoundTheirMarksWhereverTheyGo) {
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 120));
    const marks::Layer& layer = set.layers[0];
    const auto expect = [&](const auto& motion) {
        const Moved places(layer, motion);
        marks::move_clusters(layer, places.position.data(), places.normal.data(), set.unit, moved);
        expect_sound(layer, places, set.unit, moved);
    };
    expect([](glm::vec3& p, glm::vec3& n) {
        p = glm::vec3(p.z, p.x, p.y) + glm::vec3(30.0F, -2.0F, 1.0F);
        n = glm::vec3(n.z, n.x, n.y);
    });
    expect([](glm::vec3& p, glm::vec3& n) { // more and more twisted about x
        const float angle = 2.0F * p.x;
        const auto turn = [&](glm::vec3& v) {
            v = {v.x, std::cos(angle) * v.y - std::sin(angle) * v.z, std::sin(angle) * v.y + std::cos(angle) * v.z};
        };
        turn(p);
        turn(n);
    });
    expect([](glm::vec3& p, glm::vec3& n) { // torn apart, normals in all directions
        const float at = p.x;
        p = {std::sin(900.0F * p.x), std::sin(700.0F * p.y), std::cos(800.0F * p.z)};
        n = glm::normalize(glm::vec3(std::sin(500.0F * at), std::cos(300.0F * at), 0.01F));
    });
    expect([](glm::vec3& p, glm::vec3&) { p = glm::vec3(1.0F); }); // all at one place
}

// The curvature of a sphere decreases as the sphere grows.
TEST_F(MoveClusters, FollowTheCurvatureOfTheSurface) {
    const marks::PointSet set = clustered(runtime, sphere(runtime.memory, 20000));
    const marks::Layer& layer = set.layers[0];
    for (const float scale : {1.0F, 2.0F, 0.25F}) {
        const Moved places(layer, [&](glm::vec3& p, glm::vec3&) { p *= scale; });
        marks::move_clusters(layer, places.position.data(), places.normal.data(), set.unit, moved);
        std::int64_t known = 0;
        for (const Cluster& cluster : moved.cluster) {
            if (cluster.max_curvature < 0.0F) continue;
            ++known;
            const auto expected = static_cast<float>(set.unit) / scale;
            ASSERT_NEAR(cluster.max_curvature, expected, 0.15F * expected) << scale;
        }
        EXPECT_GT(known, moved.cluster.size() * 9 / 10);
    }
}

TEST_F(MoveClusters, AnEmptyLayerHasNoClusters) {
    const marks::Layer empty(runtime.memory);
    marks::move_clusters(empty, nullptr, nullptr, 1.0, moved);
    EXPECT_TRUE(moved.cluster.empty());
    EXPECT_TRUE(moved.block.empty());
}

} // namespace
} // namespace hrbfnpr::testing::move_clusters_test
