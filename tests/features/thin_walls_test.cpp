// SPDX-License-Identifier: MIT
// Tests line sets of walls that are thinner than the cells of their mesh.
#include "features/line_set.h"
#include "support/analytic.h"
#include "support/meshes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

namespace hrbfnpr::curves::thin_walls_test {
namespace {

using namespace test;

// A spherical shell. f is not a distance.
struct Shell {
    double thickness;
    [[nodiscard]] Field operator()(const glm::dvec3& p) const {
        const double r = glm::length(p);
        if (r == 0.0) return {1.0, glm::dvec3(0.0), {}};
        const double outer = r - 1.0;
        const double inner = r - 1.0 + thickness;
        return {outer * inner / thickness, p * ((outer + inner) / (thickness * r)), {}};
    }
};

struct Given {
    explicit Given(const Triangles& from) {
        for (std::size_t i = 0; i < from.vertices.size(); i += 3)
            vertex.emplace_back(from.vertices[i], from.vertices[i + 1], from.vertices[i + 2]);
        for (std::size_t i = 0; i < from.triangles.size(); i += 3)
            triangle.push_back({from.triangles[i], from.triangles[i + 1], from.triangles[i + 2]});
    }

    std::vector<glm::dvec3> vertex;
    std::vector<std::array<std::int32_t, 3>> triangle;
};

struct Found {
    std::int64_t triangles, turned, missed_seeds;
};

Found mesh_of_lines(double thickness, double spacing, const Given* given) {
    const AnyField field(cube(1.0), Shell{thickness});
    const std::vector<double> seeds{1, 0, 0, 1 - thickness, 0, 0, 0, 1, 0, 0, thickness - 1, 0};
    LineSetSettings settings;
    settings.seeds = seeds;
    settings.spacing = spacing;
    if (given != nullptr) settings.triangles = {given->vertex, given->triangle};
    const LineSet lines(with_threads(2), field, std::make_unique<implicit::DifferencedShape>(field), settings);
    return {lines.mesh().triangles(), lines.mesh().turned, lines.mesh().missed_seeds};
}

// Cells that resolve the walls would give more than a million triangles.
TEST(ThinWalls, TrianglesOfTheMeshReplaceCells) {
    const Triangles ball = icosphere(4);
    const Given walls(ball.with(ball.moved(0.99, 0, 0, 0).turned()));
    const Found found = mesh_of_lines(0.01, 0.4, &walls);
    EXPECT_LT(found.triangles, 50'000);
    EXPECT_EQ(found.turned, 0);
    EXPECT_EQ(found.missed_seeds, 0);
}

TEST(ThinWalls, TrianglesFarFromTheSurfaceAreNotUsed) {
    const Triangles ball = icosphere(3);
    const Given others(ball.with(ball.moved(0.5, 0, 0, 0)));
    EXPECT_EQ(mesh_of_lines(0.1, 0.4, &others).triangles, mesh_of_lines(0.1, 0.4, nullptr).triangles);
}

} // namespace
} // namespace hrbfnpr::curves::thin_walls_test
