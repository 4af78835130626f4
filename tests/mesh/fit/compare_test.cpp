// SPDX-License-Identifier: MIT
// Tests known distances between spheres, one of them a mesh and one a surface.
#include "mesh/fit/compare.h"

#include "curves/surface_mesh.h"
#include "mesh/meshes.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace compare_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::icosphere;
using hrbfnpr::test::Sphere;
using hrbfnpr::test::with_threads;
using namespace mesh_test;

namespace {

mesh::Comparison compared(const hrbfnpr::implicit::Implicit& surface, const Triangles& with, double tolerance,
                          double far, int threads = 2, const hrbfnpr::surface::Support* support = nullptr,
                          double limit = 0.0) {
    const hrbfnpr::base::Runtime runtime = with_threads(threads);
    const mesh::Mesh made = mesh_test::made(runtime, with);
    const mesh::FaceTree tree(runtime, made.vertex, made.triangle);
    mesh::CompareSettings settings;
    settings.tolerance = tolerance;
    settings.far = far;
    settings.points = 4000;
    settings.support = limit;
    return mesh::compare(runtime, surface, made, tree, support, settings);
}

// Two balls as one surface: f is that of the union.
class Two : public hrbfnpr::test::Analytic {
public:
    explicit Two(const glm::dvec3& centre) : Analytic(hrbfnpr::test::cube(3.0)), a_(1.0), b_(1.0, centre) {}
    [[nodiscard]] hrbfnpr::test::Field at(const glm::dvec3& p) const override {
        const hrbfnpr::test::Field a = a_.at(p), b = b_.at(p);
        return a.value < b.value ? a : b;
    }

private:
    Sphere a_, b_;
};

TEST(CompareMesh, KnowsTheDistanceBothWays) {
    const mesh::Comparison found = compared(Sphere(1.02), icosphere(5), 0.03, 0.05);
    EXPECT_EQ(found.surface.points, 4000);
    EXPECT_EQ(found.mesh.points, 4000);
    for (const mesh::DistanceStatistics& way : {found.surface, found.mesh}) {
        EXPECT_NEAR(way.mean, 0.02, 1e-3);
        EXPECT_NEAR(way.p99, 0.02, 2e-3);
        EXPECT_NEAR(way.most, 0.02, 2e-3);
        EXPECT_EQ(way.share, 1.0);
        EXPECT_EQ(way.beyond, 0.0);
    }
    EXPECT_LT(found.normal_p99, 2.0);
    EXPECT_EQ(found.components, 1);
    EXPECT_EQ(found.genus, 0);
    const mesh::Comparison narrow = compared(Sphere(1.02), icosphere(5), 0.01, 0.015);
    EXPECT_EQ(narrow.surface.share + narrow.mesh.share, 0.0);
    EXPECT_EQ(narrow.surface.beyond, 1.0);
}

TEST(CompareMesh, FindsInventedAndMissingParts) {
    // The second ball is only in the mesh, so that its place is inside the box and the surface is searched there.
    const Triangles both = icosphere(4).with(icosphere(4).moved(1.0, 2.6, 0.0, 0.0));
    const mesh::Comparison missed = compared(Sphere(1.0), both, 0.01, 0.05);
    EXPECT_NEAR(missed.mesh.beyond, 0.5, 0.03);
    EXPECT_EQ(missed.surface.beyond, 0.0);
    EXPECT_NEAR(missed.mesh.most, 2.6, 0.05);
    // The mesh is one ball. A speck makes its box large enough for the surface's second ball.
    const Triangles one = icosphere(4).with(icosphere(0).moved(0.02, 2.6, 1.0, 0.0));
    const mesh::Comparison invented = compared(Two({2.0, -0.3, 0.0}), one, 0.01, 0.05);
    EXPECT_GT(invented.surface.beyond, 0.25);
    EXPECT_LT(invented.mesh.beyond, 0.01);
}

TEST(CompareMesh, LeavesOutTheSurfaceBeyondABorder) {
    const auto half = [](double, double, double z) { return z > 0.0; };
    const mesh::Comparison found = compared(Sphere(1.0), icosphere(5).where(half), 0.01, 0.05);
    // This is a share of the region, which ends 0.05 diagonals below the border.
    EXPECT_GT(found.left_out, 0.05);
    EXPECT_LT(found.left_out, 0.25);
    EXPECT_EQ(found.surface.share, 1.0);
    EXPECT_EQ(found.genus, -1);
}

// The region between two planes that are much closer than a cell is wide.
class Plate : public hrbfnpr::test::Analytic {
public:
    Plate() : Analytic(hrbfnpr::test::cube(1.0)) {}
    [[nodiscard]] hrbfnpr::test::Field at(const glm::dvec3& p) const override {
        const double above = p.z - 0.137;
        return {std::abs(above) - 0.005, {0.0, 0.0, above < 0.0 ? -1.0 : 1.0}};
    }
};

TEST(FindSurface, UsesSmallerCellsUntilItFindsASurface) {
    const hrbfnpr::base::Runtime runtime = with_threads(2);
    hrbfnpr::geometry::VecArray seeds(runtime.memory);
    seeds.push_back({0.1, 0.2, 0.142});
    mesh::SurfaceSearch search;
    search.region = hrbfnpr::test::cube(1.0);
    search.side = 0.3;
    const hrbfnpr::curves::SurfaceMesh found = mesh::find_surface(runtime, Plate(), seeds, search);
    EXPECT_GT(found.triangles(), 0);
    EXPECT_LT(found.side, 0.02);
}

TEST(CompareMesh, LeavesOutUnsupportedParts) {
    const hrbfnpr::base::Runtime runtime = with_threads(2);
    hrbfnpr::geometry::VecArray position(runtime.memory), normal(runtime.memory);
    const Triangles ball = icosphere(4);
    for (std::size_t i = 0; i < ball.vertices.size(); i += 3) {
        const glm::dvec3 p{ball.vertices[i], ball.vertices[i + 1], ball.vertices[i + 2]};
        if (p.x < 0.0) continue;
        position.push_back(p);
        normal.push_back(p);
    }
    const hrbfnpr::surface::Support support(runtime, position, normal, 0.0);
    const mesh::Comparison found = compared(Sphere(1.0), ball, 0.01, 0.05, 2, &support, 3.0);
    EXPECT_NEAR(found.left_out, 0.5, 0.05);
    EXPECT_EQ(compared(Sphere(1.0), ball, 0.01, 0.05, 2, &support, 0.0).left_out, 0.0);
}

TEST(CompareMesh, UsesSmallerCellsForThinSurfaces) {
    // The ball is one cell across.
    const double radius = 0.4 / 128.0 * std::sqrt(12.0);
    const Triangles grains = icosphere(3).moved(radius, 0, 0, 0).with(icosphere(1).moved(0.01, 2, 2, 2));
    const mesh::Comparison found = compared(Sphere(radius), grains, 0.1 * radius, 1.0);
    EXPECT_EQ(found.components, 1);
    EXPECT_EQ(found.genus, 0);
    EXPECT_GT(found.surface.share, 0.99);
}

TEST(CompareMesh, DoesNotCountMeshInsideAnotherPart) {
    // The balls overlap. The part of each ball inside the other does not count as mesh.
    const Triangles both = icosphere(5).with(icosphere(5).moved(1.0, 1.0, 0.0, 0.0));
    const mesh::Comparison found = compared(Two({1.0, 0.0, 0.0}), both, 0.01, 0.05);
    EXPECT_EQ(found.mesh.share, 1.0);
    EXPECT_LT(found.mesh.points, 3600);
}

TEST(CompareMesh, SpreadMatchesASortedList) {
    hrbfnpr::base::Memory memory;
    std::vector<double> plain;
    hrbfnpr::base::Array<double> numbers(memory);
    for (int i = 0; i < 1000; ++i) {
        plain.push_back(std::abs(std::sin(12.9898 * i)));
        numbers.push_back(plain.back());
    }
    const mesh::DistanceStatistics spread = mesh::statistics_of(numbers, 0.5, 0.9);
    std::sort(plain.begin(), plain.end());
    double sum = 0.0;
    for (const double number : plain) sum += number;
    EXPECT_NEAR(spread.mean, sum / 1000.0, 1e-12);
    EXPECT_EQ(spread.p99, plain[990]);
    EXPECT_EQ(spread.most, plain[999]);
    const auto upto = [&](double limit) { return std::upper_bound(plain.begin(), plain.end(), limit) - plain.begin(); };
    EXPECT_EQ(spread.share, static_cast<double>(upto(0.5)) / 1000.0);
    EXPECT_DOUBLE_EQ(spread.beyond, 1.0 - static_cast<double>(upto(0.9)) / 1000.0);
    numbers.clear();
    EXPECT_TRUE(std::isnan(mesh::statistics_of(numbers, 0.5, 0.9).mean));
}

} // namespace

} // namespace compare_test
