// SPDX-License-Identifier: MIT
#include "curves/given_mesh.h"

#include "mesh_checks.h"
#include "shapes.h"
#include "support/meshes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace hrbfnpr::curves::given_mesh_test {
namespace {

using namespace test;
using namespace test_shapes;
using test_checks::measure;
using test_checks::Measures;

struct Given {
    explicit Given(const Triangles& from) {
        for (std::size_t i = 0; i < from.vertices.size(); i += 3)
            vertex.emplace_back(from.vertices[i], from.vertices[i + 1], from.vertices[i + 2]);
        for (std::size_t i = 0; i < from.triangles.size(); i += 3)
            triangle.push_back({from.triangles[i], from.triangles[i + 1], from.triangles[i + 2]});
    }
    [[nodiscard]] GivenTriangles view() const { return {vertex, triangle}; }

    std::vector<glm::dvec3> vertex;
    std::vector<std::array<std::int32_t, 3>> triangle;
};

// Makes the part of the unit sphere with z below 0.5, whose border is a circle.
Triangles bowl() {
    constexpr int around = 40;
    constexpr int rings = 20;
    Triangles mesh;
    const std::int32_t pole = mesh.add(0, 0, -1);
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const double down = 2.0 / 3.0 * 3.141592653589793 * ring / rings;
            const double turn = 2.0 * 3.141592653589793 * i / around;
            static_cast<void>(
                mesh.add(std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), -std::cos(down)));
        }
    for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around;
        mesh.face(pole, 1 + next, 1 + i);
        for (int ring = 1; ring < rings; ++ring) {
            const int low = 1 + (ring - 1) * around;
            mesh.face(low + i, low + next, low + around + next);
            mesh.face(low + i, low + around + next, low + around + i);
        }
    }
    return mesh;
}

GivenMeshSettings settings_of(const implicit::Implicit& implicit, double side) {
    GivenMeshSettings settings;
    settings.region = surface::search_region(implicit);
    settings.side = side;
    return settings;
}

// Both walls of a shell are a hundredth of the diagonal apart. Cells that are ten times as wide do not find them.
TEST(GivenMesh, ResolvesWallsThinnerThanCells) {
    const base::Runtime runtime = with_threads(2);
    const AnyField shell(cube(1.0), Shell{0.01});
    const Given given(icosphere(3).with(icosphere(3).moved(0.99, 0, 0, 0).turned()));
    const SurfaceMesh mesh = mesh_of_triangles(runtime, shell, given.view(), settings_of(shell, 0.1));
    const Measures found = measure(mesh, shell);
    EXPECT_EQ(found.euler, 4);
    EXPECT_EQ(found.border, 0);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.turned, 0);
    EXPECT_EQ(mesh.turned, 0);
    EXPECT_EQ(mesh.unresolved, 0);
    EXPECT_LE(found.off, 1e-9 * shell.diagonal());
    EXPECT_NEAR(found.area, 4.0 * 3.14159 * (1.0 + 0.99 * 0.99), 0.1);
    for (std::int64_t e = 0; e < mesh.corner.size(); ++e)
        EXPECT_LE(glm::distance(mesh.position[mesh.corner[e]], mesh.position[mesh.corner[e - e % 3 + (e + 1) % 3]]),
                  0.1);
}

TEST(GivenMesh, ContinuesOpenTrianglesByAStrip) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    const Given given(bowl());
    GivenMeshSettings settings = settings_of(sphere, 0.2);
    const Measures without = measure(mesh_of_triangles(runtime, sphere, given.view(), settings), sphere);
    settings.strip = 0.1;
    const SurfaceMesh mesh = mesh_of_triangles(runtime, sphere, given.view(), settings);
    const Measures found = measure(mesh, sphere);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.turned, 0);
    EXPECT_EQ(found.euler, without.euler);
    EXPECT_LE(found.off, 1e-9 * sphere.diagonal());
    const double rim = 2.0 * 3.14159 * std::sqrt(0.75);
    EXPECT_NEAR(found.area - without.area, 0.1 * rim, 0.02 * rim);
}

TEST(GivenMesh, TheResultDoesNotDependOnTheNumberOfThreads) {
    const AnyField shell(cube(1.0), Shell{0.05});
    const Given given(icosphere(3));
    std::vector<double> first;
    for (const int threads : {1, 3}) {
        const base::Runtime runtime = with_threads(threads);
        const SurfaceMesh mesh = mesh_of_triangles(runtime, shell, given.view(), settings_of(shell, 0.05));
        const std::vector<double> x(mesh.position.x.begin(), mesh.position.x.end());
        if (first.empty()) first = x;
        EXPECT_EQ(x, first);
    }
}

} // namespace
} // namespace hrbfnpr::curves::given_mesh_test
