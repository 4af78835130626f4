// SPDX-License-Identifier: MIT
#include "curves/surface_mesh.h"

#include "curves/curves.h"
#include "curves/mesh_edges.h"
#include "mesh_checks.h"
#include "shapes.h"
#include "support/runtime.h"
#include "surface/support_domain.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace hrbfnpr::curves::surface_mesh_test {
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

class SurfaceMeshOfShapes : public testing::TestWithParam<Shape> {};

TEST_P(SurfaceMeshOfShapes, IsAClosedOrientedManifoldOnTheSurface) {
    const base::Runtime runtime = with_threads(2);
    const Shape& shape = GetParam();
    const std::unique_ptr<implicit::Implicit> implicit = shape.make();
    geometry::VecArray seed(runtime.memory);
    for (const glm::dvec3& place : shape.seed) seed.push_back(place);
    const SurfaceMesh mesh = triangulate(runtime, *implicit, seed, settings(*implicit, shape.side));
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
    Shapes, SurfaceMeshOfShapes,
    testing::Values(
        Shape{"sphere", [] { return std::make_unique<Sphere>(); }, {{0, 0, 1}}, 0.1, 2, 4 * pi},
        // The poles and some other points are exactly on corners of the lattice.
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
        // The shell is hardly thicker than a cell's diagonal.
        Shape{"shell",
              [] { return any(cube(1.1), Shell{0.09}); },
              {{0, 0, 1}, {0, .91, 0}},
              0.05,
              4,
              4 * pi*(1.0 + 0.91 * 0.91)},
        Shape{"linked_tori", [] { return std::make_unique<TwoTori>(); }, {{1.3, 0, 0}, {1, 0, 1.3}}, 0.05, 0, 0.0}),
    [](const testing::TestParamInfo<Shape>& shape) { return std::string(shape.param.name); });

// The region cuts the sphere at z = 0.3.
TEST(SurfaceMesh, EndsWhereTheRegionEnds) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    MeshSettings half = settings(sphere, 0.05);
    half.region.max.z = 0.3;
    const SurfaceMesh mesh = triangulate(runtime, sphere, seeds(runtime, {{0, 0, -1}}), half);
    const Measures found = measure(mesh, sphere);
    EXPECT_EQ(found.euler, 1);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.bad_across, 0);
    EXPECT_GT(found.border, 100);
    EXPECT_NEAR(found.area, 2 * pi * 1.3, 0.01 * 2 * pi * 1.3);
    std::int64_t on_border = 0;
    for (std::int64_t t = 0; t < mesh.triangles(); ++t)
        for (std::int64_t k = 0; k < 3; ++k)
            if (mesh.neighbour[3 * t + k] < 0) {
                ++on_border;
                EXPECT_NEAR(test_checks::corner(mesh, t, k).z, 0.3, 1e-12);
                EXPECT_NEAR(test_checks::corner(mesh, t, k + 1).z, 0.3, 1e-12);
            }
    EXPECT_EQ(on_border, found.border);
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) ASSERT_TRUE(half.region.contains(mesh.position[i]));
}

// Points of the unit sphere up to an angle from its south pole, `step` apart.
geometry::VecArray around_south_pole(const base::Runtime& runtime, double largest_angle, double step) {
    geometry::VecArray points(runtime.memory);
    for (double angle = 0.0; angle < largest_angle; angle += step)
        for (double turn = 0.0; turn < 2 * pi; turn += step / std::max(step, std::sin(angle)))
            points.push_back({std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), -std::cos(angle)});
    return points;
}

// The mesh contains all of the surface that the samples support, and little of what lies beyond.
TEST(SurfaceMesh, EndsJustBeyondItsSamples) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    const geometry::VecArray samples = around_south_pole(runtime, 0.4, 0.04);
    const surface::SupportDomain domain(surface::Support(runtime, samples, samples, 0.0), 3.0, 0.0);
    MeshSettings cells = settings(sphere, 0.02);
    const SurfaceMesh whole = triangulate(runtime, sphere, samples, cells);
    cells.domain = &domain;
    const SurfaceMesh cap = triangulate(runtime, sphere, samples, cells);
    std::set<std::array<double, 3>> kept;
    double highest = -1.0;
    for (std::int64_t i = 0; i < cap.vertices(); ++i) {
        kept.insert({cap.position[i].x, cap.position[i].y, cap.position[i].z});
        highest = std::max(highest, cap.position[i].z);
    }
    std::int64_t supported = 0;
    for (std::int64_t i = 0; i < whole.vertices(); ++i) {
        const glm::dvec3 p = whole.position[i];
        if (!domain.contains(p, whole.gradient[i])) continue;
        ++supported;
        ASSERT_TRUE(kept.contains({p.x, p.y, p.z}));
    }
    EXPECT_GT(supported, 500);
    EXPECT_LT(highest, -0.4);
    EXPECT_LT(3 * cap.triangles(), whole.triangles());
}

// The level of a support, with its exact value at every vertex.
class ExactLevel final : public Level {
public:
    explicit ExactLevel(const SupportLevel& of) : of_(of) {}
    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return of_.surface(); }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override {
        of_.evaluate(points, out);
    }
    void at_vertices(const base::Work& work, const SurfaceMesh& mesh, base::Array<double>& level) const override {
        of_.at_vertices(work, mesh, level);
    }

private:
    const SupportLevel& of_;
};

TEST(SurfaceMesh, IsCutAsByExactSupportWhereSignsSuffice) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    const geometry::VecArray samples = around_south_pole(runtime, 0.8, 0.05);
    const SurfaceMesh mesh = triangulate(runtime, sphere, samples, settings(sphere, 0.04));
    surface::Support support(runtime, samples, samples, 0.0);
    geometry::CellGrid grid;
    grid.origin = glm::dvec3(-2.0);
    grid.side = 0.2;
    geometry::CellSet kept(runtime.memory), ends(runtime.memory);
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) { // the surface continues where x > 0
        const auto cell = grid.cell_of(mesh.position[i]);
        (grid.corner(cell).x > -1e-9 ? kept : ends).insert(geometry::CellGrid::pack(cell));
    }
    support.keep(grid, std::move(kept), std::move(ends), 3.0);
    const SupportLevel level(sphere, support, 3.0);
    base::Array<double> exact(runtime.memory), signs(runtime.memory);
    level.at_vertices(runtime, mesh, exact);
    level.signs_at_vertices(runtime, mesh, signs);
    std::int64_t only_signs = 0;
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) {
        ASSERT_EQ(exact[i] <= 0.0, signs[i] <= 0.0);
        only_signs += exact[i] != signs[i] ? 1 : 0;
    }
    EXPECT_GT(3 * only_signs, mesh.vertices());
    const ClippedMesh by_signs = clip(runtime, level, mesh);
    const ClippedMesh by_values = clip(runtime, ExactLevel(level), mesh);
    EXPECT_GT(by_signs.cut.size(), 20);
    EXPECT_EQ(by_signs.left_out, by_values.left_out);
    ASSERT_EQ(by_signs.mesh.vertices(), by_values.mesh.vertices());
    for (std::int64_t i = 0; i < by_signs.mesh.vertices(); ++i)
        ASSERT_EQ(by_signs.mesh.position[i], by_values.mesh.position[i]);
    EXPECT_TRUE(std::equal(by_signs.mesh.corner.begin(), by_signs.mesh.corner.end(), by_values.mesh.corner.begin(),
                           by_values.mesh.corner.end()));
}

TEST(SurfaceMesh, UsesWiderCellsToStayBelowTheTriangleLimit) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    const geometry::VecArray seed = seeds(runtime, {{0.0, 0.0, 1.0}});
    MeshSettings cells = settings(sphere, 0.02);
    cells.triangle_limit = 20000;
    EXPECT_THROW((void)triangulate(runtime, sphere, seed, cells), Error);
    const SurfaceMesh mesh = triangulate_of_any_size(runtime, sphere, seed, cells);
    EXPECT_LE(mesh.triangles(), 20000);
    EXPECT_GT(mesh.triangles(), 2000);
    EXPECT_EQ(cells.side, 0.08);
}

TEST(SurfaceMesh, ReachesOnlyPartsWithASeed) {
    const base::Runtime runtime = with_threads(2);
    const AnyField both(cube(1.2), two_spheres);
    const SurfaceMesh mesh = triangulate(runtime, both, seeds(runtime, {{.6, .1, .1}}), settings(both, 0.04));
    EXPECT_EQ(measure(mesh, both).euler, 2);
    EXPECT_NEAR(measure(mesh, both).area, 4 * pi * 0.09, 0.01 * 4 * pi * 0.09);
    EXPECT_EQ(triangulate(runtime, both, seeds(runtime, {}), settings(both, 0.04)).triangles(), 0);
    // The first seed is outside of the region, the second one far from the surface.
    EXPECT_EQ(triangulate(runtime, both, seeds(runtime, {{9, 9, 9}, {.6, -.2, .1}}), settings(both, 0.04)).triangles(),
              0);
}

// All corners of the seed's own cell are on one side, because the cap above the cell is lower than the cell.
TEST(SurfaceMesh, FindsTheSurfaceFromANearbySeed) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    for (int k = 0; k < 200; ++k) {
        const auto at = spiral_point(k, 200);
        const glm::dvec3 n(at[0], at[1], at[2]);
        const SurfaceMesh mesh =
            triangulate(runtime, sphere, seeds(runtime, {n * (1.0 + 0.09 * std::sin(k))}), settings(sphere, 0.2));
        ASSERT_EQ(measure(mesh, sphere).euler, 2) << k;
        ASSERT_EQ(mesh.missed_seeds, 0);
    }
}

// The pole is in the middle of a cell's face and a little above it, so all corners of the cell are outside.
TEST(SurfaceMesh, FindsTheSurfaceFromACellWithoutAChangeOfSign) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    MeshSettings cells;
    cells.side = 0.2001;
    cells.region = {{-1.1, -1.1, -1.205}, {1.1, 1.1, 1.195}};
    const SurfaceMesh mesh = triangulate(runtime, sphere, seeds(runtime, {{0, 0, 1}}), cells);
    EXPECT_EQ(measure(mesh, sphere).euler, 2);
    EXPECT_EQ(mesh.missed_seeds, 0);
}

// The small sphere contains no corner of a cell.
TEST(SurfaceMesh, CountsSeedsOfPartsThatCellsMiss) {
    const base::Runtime runtime = with_threads(2);
    const AnyField two(cube(1.0), [](const glm::dvec3& p) {
        const double large = glm::length(p) - 0.6;
        const glm::dvec3 q = p - glm::dvec3(0.83, 0.83, 0.83);
        const double small = glm::length(q) - 0.02;
        return large < small ? Field{large, p / glm::length(p), {}} : Field{small, q / glm::length(q), {}};
    });
    MeshSettings coarse = settings(two, 0.1);
    const glm::dvec3 small(0.85, 0.83, 0.83);
    geometry::VecArray seed = seeds(runtime, {{0.6, 0, 0}, {0, 0.6, 0}, small, small - glm::dvec3(0.04, 0, 0)});
    EXPECT_EQ(triangulate(runtime, two, seed, coarse).missed_seeds, 2);
    coarse.side = 0.01;
    EXPECT_EQ(triangulate(runtime, two, seed, coarse).missed_seeds, 0);
}

// The missed seed is near triangles, but they face the other way.
TEST(SurfaceMesh, CountsMissedSeedsNextToAnotherPart) {
    const base::Runtime runtime = with_threads(2);
    const AnyField drop(cube(1.0), [](const glm::dvec3& p) {
        const glm::dvec3 q = p - glm::dvec3(0.03, 0.02, 0.1);
        const double small = glm::length(q) - 0.02;
        return p.z < small ? Field{p.z, {0, 0, 1}, {}} : Field{small, q / glm::length(q), {}};
    });
    const geometry::VecArray seed = seeds(runtime, {{0.5, 0, 0}, {0.03, 0.02, 0.08}});
    MeshSettings cells;
    cells.side = 0.1501;
    cells.region = {{-1.05, -1.05, -1.125}, {1.05, 1.05, 1.125}};
    EXPECT_EQ(triangulate(runtime, drop, seed, cells).missed_seeds, 1);
}

TEST(SurfaceMesh, ReportsWhereAWallIsTooThin) {
    const base::Runtime runtime = with_threads(2);
    const AnyField shell(cube(1.1), Shell{0.03});
    EXPECT_GT(triangulate(runtime, shell, seeds(runtime, {{0, 0, 1}}), settings(shell, 0.06)).turned, 0);
}

TEST(SurfaceMesh, TooManyTrianglesNameTheRemedy) {
    const base::Runtime runtime = with_threads(2);
    const Sphere sphere;
    MeshSettings fine = settings(sphere, 0.05);
    const geometry::VecArray seed = seeds(runtime, {{0, 0, 1}});
    const std::int64_t triangles = triangulate(runtime, sphere, seed, fine).triangles();
    fine.triangle_limit = triangles;
    EXPECT_EQ(triangulate(runtime, sphere, seed, fine).triangles(), triangles);
    const auto refused = [&] {
        try {
            static_cast<void>(triangulate(runtime, sphere, seed, fine));
        } catch (const Error& error) {
            return error.status() == Status::invalid_argument &&
                   std::string(error.what()).find("cell_size") != std::string::npos;
        }
        return false;
    };
    --fine.triangle_limit;
    EXPECT_TRUE(refused());
    fine.triangle_limit = 1000;
    const std::int64_t before = sphere.evaluations;
    fine.side = 1e-4;
    EXPECT_TRUE(refused());
    EXPECT_LT(sphere.evaluations - before, 100000) << "it is found in time";
    fine.side = 1e-9; // more cells along an axis than their numbers can hold
    EXPECT_TRUE(refused());
}

// f is NaN in a ball around a pole and in a thin layer that cells hardly meet.
TEST(SurfaceMesh, LeavesOutPlacesWithNaN) {
    const base::Runtime runtime = with_threads(2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const AnyField holed(cube(1.0), [&](const glm::dvec3& p) {
        const double r = glm::length(p);
        if (p.z > 0.9 || std::abs(p.z + 0.30101) < 1e-4) return Field{nan, glm::dvec3(nan), {}};
        return Field{r - 1.0, p / r, {}};
    });
    const SurfaceMesh mesh = triangulate(runtime, holed, seeds(runtime, {{1, 0, 0}}), settings(holed, 0.05));
    const Measures found = measure(mesh, Sphere());
    EXPECT_EQ(found.euler, 1);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.bad_across, 0);
    EXPECT_GT(found.border, 10);
    EXPECT_NEAR(found.area, 2 * pi * 1.9, 0.2);
    EXPECT_EQ(mesh.gradient.size(), mesh.position.size());
    std::int64_t off = 0;
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) {
        ASSERT_TRUE(std::isfinite(glm::length(mesh.position[i])) && std::isfinite(glm::length(mesh.gradient[i])));
        if (std::abs(glm::length(mesh.position[i]) - 1.0) > 1e-8) ++off;
    }
    EXPECT_LE(off, mesh.unresolved);
}

TEST(SurfaceMesh, NeedsFewerThanThreeEvaluationsPerVertex) {
    const base::Runtime runtime = with_threads(2);
    const AnyField quartic(cube(1.2), two_holes);
    const SurfaceMesh mesh = triangulate(runtime, quartic, seeds(runtime, {{0, 0, .2}}), settings(quartic, 0.03));
    EXPECT_LT(quartic.evaluations, 3 * mesh.vertices());
}

} // namespace
} // namespace hrbfnpr::curves::surface_mesh_test
