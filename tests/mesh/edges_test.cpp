// SPDX-License-Identifier: MIT
#include "mesh/edges.h"

#include "base/status.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace edges_test {

namespace {

using namespace hrbfnpr;

// The lower vertex, the higher vertex, the face, and whether the side runs from the lower to the higher vertex.
using PlainSide = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t>;

TEST(SidesByEdge, AreSortedByEdgeAndFace) {
    const base::Runtime runtime;
    // A torus, an edge of three faces, and vertices without faces.
    base::Array<mesh::Triangle> triangle(runtime.memory);
    const mesh::Mesh torus = mesh_test::made(runtime, test::torus(60, 30, 0.3));
    for (std::int64_t face = torus.faces() - 1; face >= 0; --face) triangle.push_back(torus.triangle[face]);
    for (const std::int32_t apex : {5000, 4000, 6000}) triangle.push_back({3, apex, 7});
    std::vector<PlainSide> expected;
    for (std::int64_t face = 0; face < triangle.size(); ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = triangle[face][k];
            const std::int32_t b = triangle[face][(k + 1) % 3];
            expected.emplace_back(std::min(a, b), std::max(a, b), static_cast<std::int32_t>(face), a < b ? 1 : 0);
        }
    std::sort(expected.begin(), expected.end());
    const base::Array<mesh::Side> sides = mesh::sides_by_edge(runtime, triangle);
    ASSERT_EQ(sides.size(), static_cast<std::int64_t>(expected.size()));
    for (std::int64_t i = 0; i < sides.size(); ++i) {
        const mesh::Side& side = sides[i];
        EXPECT_EQ(PlainSide(mesh::low_end(side), mesh::high_end(side), side.face, side.forward),
                  expected[static_cast<std::size_t>(i)])
            << i;
    }
    EXPECT_EQ(mesh::sides_by_edge(runtime, base::Array<mesh::Triangle>(runtime.memory)).size(), 0);
}

} // namespace

} // namespace edges_test
