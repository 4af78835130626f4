// SPDX-License-Identifier: MIT
// Tests chains of crossed edges: in closed and open meshes, and their direction.
#include "curves/mesh_edges.h"

#include "traced.h"

#include <functional>
#include <set>

namespace hrbfnpr::curves::mesh_chains_test {
namespace {

using namespace test_traced;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

base::Array<double> values(const SurfaceMesh& mesh, const std::function<double(const glm::dvec3&)>& g) {
    base::Array<double> level(runtime().memory);
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) level.push_back(g(mesh.position[i]));
    return level;
}

// The edges whose ends have different signs.
std::set<std::pair<std::int32_t, std::int32_t>> crossed_edges(const SurfaceMesh& mesh,
                                                              const base::Array<double>& level) {
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (std::int64_t i = 0; i < mesh.corner.size(); ++i) {
        const std::int32_t a = mesh.corner[i];
        const std::int32_t b = mesh.corner[i % 3 == 2 ? i - 2 : i + 1];
        if ((level[a] < 0.0) != (level[b] < 0.0)) edges.insert(level[a] < 0.0 ? std::pair(a, b) : std::pair(b, a));
    }
    return edges;
}

bool is_on_edge(const EdgeCrossing& crossing) {
    const double length = glm::distance(crossing.edge.negative, crossing.edge.positive);
    return glm::distance(crossing.place, crossing.edge.negative) <= length * (1.0 + 1e-12) &&
           glm::distance(crossing.place, crossing.edge.positive) <= length * (1.0 + 1e-12);
}

void expect_each_edge_once(const SurfaceMesh& mesh, const base::Array<double>& level,
                           const Chains<EdgeCrossing>& chains) {
    std::set<std::pair<std::int32_t, std::int32_t>> found;
    for (const EdgeCrossing& c : chains.point) {
        EXPECT_LT(level[c.negative], 0.0);
        EXPECT_GE(level[c.positive], 0.0);
        EXPECT_TRUE(is_on_edge(c));
        EXPECT_TRUE(found.insert({c.negative, c.positive}).second);
    }
    EXPECT_EQ(found, crossed_edges(mesh, level));
    EXPECT_EQ(chains.first[chains.count()], chains.point.size());
}

TEST(MeshChains, ParallelsOfASphereAreClosedWithNegativeOnTheLeft) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.1);
    const auto bands = [](const glm::dvec3& p) { return std::sin(6.0 * p.z + 0.1); };
    const base::Array<double> level = values(meshed.mesh, bands);
    const Chains<EdgeCrossing> chains = find_edge_crossings(runtime(), meshed.mesh, level);
    expect_each_edge_once(meshed.mesh, level, chains);
    ASSERT_EQ(chains.count(), 3); // 6 z + 0.1 = -pi, 0, pi
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        EXPECT_EQ(chains.closed[c], 1);
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const std::int64_t next = i + 1 < chains.first[c + 1] ? i + 1 : chains.first[c];
            const glm::dvec3 p = chains.point[i].place;
            EXPECT_NEAR(bands(p), 0.0, 0.05);
            const glm::dvec3 way = chains.point[next].place - p;
            const glm::dvec3 slope(0.0, 0.0, std::cos(6.0 * p.z + 0.1));
            EXPECT_GE(glm::dot(way, glm::cross(p, slope)), -1e-3) << c << ' ' << i;
        }
    }
}

TEST(MeshChains, OpenChainsRunFromBorderToBorder) {
    const test::Plane plane({0.0, 0.0, 1.0}, 0.0, {{-1.0, -1.0, -0.3}, {1.0, 1.0, 0.3}});
    const Meshed meshed(runtime(), plane, {{0.1, 0.1, 0.0}}, 0.1);
    const base::Array<double> level =
        values(meshed.mesh, [](const glm::dvec3& p) { return (p.x - 0.31) * (p.x + 0.27) + 0.01 * p.y; });
    const Chains<EdgeCrossing> chains = find_edge_crossings(runtime(), meshed.mesh, level);
    expect_each_edge_once(meshed.mesh, level, chains);
    ASSERT_EQ(chains.count(), 2);
    for (std::int64_t c = 0; c < 2; ++c) {
        EXPECT_EQ(chains.closed[c], 0);
        const glm::dvec3 a = chains.point[chains.first[c]].place;
        const glm::dvec3 b = chains.point[chains.first[c + 1] - 1].place;
        EXPECT_NEAR(std::max(a.y, b.y), meshed.mesh.region.max.y, 1e-9);
        EXPECT_NEAR(std::min(a.y, b.y), meshed.mesh.region.min.y, 1e-9);
        // f > 0 above the plane. The negative side, which is between the two lines, lies to the left.
        EXPECT_EQ(b.y > a.y, a.x > 0.0);
    }
}

TEST(MeshChains, ZeroCountsAsPositive) {
    const test::Plane plane({0.0, 0.0, 1.0}, 0.0, {{-1.0, -1.0, -0.3}, {1.0, 1.0, 0.3}});
    const Meshed meshed(runtime(), plane, {{0.1, 0.1, 0.0}}, 0.25);
    EXPECT_EQ(
        find_edge_crossings(runtime(), meshed.mesh, values(meshed.mesh, [](const glm::dvec3&) { return 0.0; })).count(),
        0);
    const base::Array<double> level = values(meshed.mesh, [](const glm::dvec3& p) { return std::min(0.0, p.x - 0.1); });
    const Chains<EdgeCrossing> chains = find_edge_crossings(runtime(), meshed.mesh, level);
    expect_each_edge_once(meshed.mesh, level, chains);
    EXPECT_EQ(chains.count(), 1);
    for (const EdgeCrossing& c : chains.point) EXPECT_EQ(c.place, c.edge.positive);
}

TEST(MeshChains, BearNaNAndEmptyMeshes) {
    const test::SquareSphere sphere;
    const Meshed meshed(runtime(), sphere, {{1.0, 0.0, 0.0}}, 0.1);
    const base::Array<double> level =
        values(meshed.mesh, [](const glm::dvec3& p) { return p.x > 0.3 ? HUGE_VAL - HUGE_VAL : p.y; });
    const Chains<EdgeCrossing> chains = find_edge_crossings(runtime(), meshed.mesh, level);
    for (const EdgeCrossing& c : chains.point) EXPECT_TRUE(is_on_edge(c));
    const Meshed empty(runtime(), sphere, {}, 0.1);
    EXPECT_EQ(find_edge_crossings(runtime(), empty.mesh, base::Array<double>(runtime().memory)).count(), 0);
}

} // namespace
} // namespace hrbfnpr::curves::mesh_chains_test
