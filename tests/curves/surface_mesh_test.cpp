// SPDX-License-Identifier: MIT
#include "curves/surface_mesh.h"

#include "mesh_checks.h"
#include "shapes.h"
#include "support/runtime.h"
#include "support/watched_operation.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves {
namespace {

using namespace test;
using namespace test_shapes;
using test_checks::measure;
using test_checks::Measures;

constexpr double pi = 3.14159265358979323846;

struct Shape {
    const char* name;
    std::function<std::unique_ptr<implicit::Implicit>()> make;
    std::vector<glm::dvec3> seed;
    double side;
    std::int64_t euler;
    double area; // 0: not known
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

std::unique_ptr<implicit::Implicit> any(const geometry::Bounds& bounds, std::function<Field(const glm::dvec3&)> f) {
    return std::make_unique<AnyField>(bounds, std::move(f));
}

class Closed : public testing::TestWithParam<Shape> {};

TEST_P(Closed, IsAClosedOrientedManifoldOnTheSurface) {
    const base::Runtime runtime = with_threads(2);
    const Shape& shape = GetParam();
    const std::unique_ptr<implicit::Implicit> implicit = shape.make();
    geometry::VecArray seed(runtime.memory);
    for (const glm::dvec3& place : shape.seed) seed.push_back(place);
    const SurfaceMesh mesh = triangulate(runtime, *implicit, seed, settings(*implicit, shape.side), {});
    const Measures found = measure(mesh, *implicit);
    EXPECT_EQ(found.euler, shape.euler);
    EXPECT_EQ(found.border, 0);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.bad_across, 0);
    EXPECT_EQ(found.turned, 0);
    EXPECT_EQ(mesh.turned, 0);
    EXPECT_EQ(found.unused, 0);
    EXPECT_EQ(mesh.unresolved, 0);
    EXPECT_EQ(mesh.missed_seeds, 0);
    EXPECT_LE(found.off, 1e-9 * implicit->diagonal());
    EXPECT_EQ(found.gradient_off, 0.0);
    EXPECT_GT(found.volume, 0.0);
    EXPECT_GT(found.smallest_area, 1e-5 * mesh.side * mesh.side);
    EXPECT_LE(mesh.side, shape.side);
    EXPECT_NEAR(found.area, shape.area, shape.area > 0.0 ? 0.01 * shape.area : 100.0);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Closed,
    testing::Values(
        Shape{"sphere", [] { return std::make_unique<Sphere>(); }, {{0, 0, 1}}, 0.1, 2, 4 * pi},
        // Its poles, and more, are exactly on corners of the lattice.
        Shape{"on_corners",
              [] { return std::make_unique<SquareSphere>(1.0, 2.0); },
              {{0, 0, 1}},
              0.05 * 2.0 * (1.0 + 0.1 * std::sqrt(3.0)),
              2,
              4 * pi},
        Shape{"ellipsoid",
              [] {
                  return any({{-1, -.6, -.35}, {1, .6, .35}}, ellipsoid);
              },
              {{1, 0, 0}},
              0.04,
              2,
              5.1050},
        Shape{"torus", [] { return std::make_unique<Torus>(); }, {{1.35, 0, 0}}, 0.06, 0, 4 * pi* pi * 0.35},
        Shape{"two_holes", [] { return any(cube(1.2), two_holes); }, {{0, 0, 0.2}}, 0.03, -2, 0.0},
        Shape{"two_spheres",
              [] { return any(cube(1.2), two_spheres); },
              {{-.6, .6, 0}, {.6, .1, .1}},
              0.04,
              4,
              4 * pi*(0.25 + 0.09)},
        // Hardly thicker than a cell's diagonal.
        Shape{"shell",
              [] { return any(cube(1.1), Shell{0.09}); },
              {{0, 0, 1}, {0, .91, 0}},
              0.08,
              4,
              4 * pi*(1.0 + 0.91 * 0.91)},
        Shape{"linked_tori", [] { return std::make_unique<TwoTori>(); }, {{1.3, 0, 0}, {1, 0, 1.3}}, 0.05, 0, 0.0}),
    [](const testing::TestParamInfo<Shape>& shape) { return std::string(shape.param.name); });

} // namespace
} // namespace hrbfnpr::curves
