// SPDX-License-Identifier: MIT
#include "geometry/cell_block.h"
#include "geometry/cell_set.h"
#include "geometry/morton.h"
#include "geometry/point_tree.h"
#include "geometry/tangent_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace hrbfnpr::geometry::geometry_test {
namespace {

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

glm::dvec3 pseudo_random(int i) {
    return {std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)};
}

// Two clusters far apart, points that coincide, and points on a line.
VecArray awkward(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i) {
        glm::dvec3 p = pseudo_random(i / 3 * 3 + (i % 3 == 0 ? 1 : i % 3));
        if (i % 7 == 0) p = 1e-3 * p + glm::dvec3(50.0, 0.0, 0.0);
        if (i % 5 == 0) p = glm::dvec3(p.x, 0.0, 0.0);
        if (i % 11 == 0) p = glm::dvec3(0.25, 0.5, 0.75);
        points.push_back(p);
    }
    return points;
}

TEST(PointTree, MatchesABruteForceSearch) {
    for (const int count : {1, 2, 8, 9, 17, 100, 777}) {
        const VecArray points = awkward(count);
        const PointTree tree(points, {});
        ASSERT_EQ(tree.size(), count);
        std::set<std::int64_t> seen;
        for (int at = 0; at < count; ++at) {
            seen.insert(tree.index(at));
            EXPECT_EQ(tree.points()[at], points[tree.index(at)]);
            double nearest = std::numeric_limits<double>::infinity();
            std::vector<std::int64_t> expected;
            for (int i = 0; i < count; ++i) {
                const double distance = glm::distance(points[i], tree.points()[at]);
                if (i != tree.index(at)) nearest = std::min(nearest, distance);
                if (distance <= 0.3) expected.push_back(i);
            }
            EXPECT_DOUBLE_EQ(tree.nearest_other(at), nearest);
            std::vector<std::int64_t> found;
            tree.within(tree.points()[at], 0.3, [&](std::int64_t other, double squared) {
                found.push_back(tree.index(other));
                EXPECT_DOUBLE_EQ(std::sqrt(squared), glm::distance(tree.points()[at], points[tree.index(other)]));
            });
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
        }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>(count));
    }
}

TEST(PointTree, IsEmptyForNoPoints) {
    const PointTree tree(VecArray(memory()), {});
    tree.within(glm::dvec3(0.0), 1e9, [](std::int64_t, double) { FAIL(); });
    EXPECT_TRUE(tree.bounds().empty());
}

TEST(Morton, CodesConvertBackToTheirCells) {
    for (const std::array<std::int64_t, 3>& cell :
         {std::array<std::int64_t, 3>{0, 0, 0}, {1, 2, 3}, {12345, 654321, 2097151}, {2097151, 0, 77}}) {
        EXPECT_EQ(morton_cell(morton_code(cell)), cell);
        EXPECT_EQ(morton_code(cell) >> 3U, morton_code({cell[0] / 2, cell[1] / 2, cell[2] / 2})) << "the larger cell";
    }
    EXPECT_EQ(morton_code({1, 0, 0}), 1U);
    EXPECT_EQ(morton_code({0, 1, 1}), 6U);
}

TEST(CellSet, BehavesLikeAStdSet) {
    CellSet cells(memory());
    std::set<std::uint64_t> reference;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const std::uint64_t cell = i * i % 3001 * 7919 % (std::uint64_t{1} << 40U);
        EXPECT_EQ(cells.insert(cell), reference.insert(cell).second);
    }
    EXPECT_TRUE(cells.insert((std::uint64_t{1} << 63U) - 1)) << "the largest cell there is";
    EXPECT_EQ(cells.size(), static_cast<std::int64_t>(reference.size()) + 1);
}

CellGrid::Cell random_cell(std::mt19937& random) {
    return {static_cast<std::int64_t>(random() % 9), static_cast<std::int64_t>(random() % 9),
            static_cast<std::int64_t>(random() % 9)};
}

TEST(CellSet, InsertsManyNeighboursAtOnce) {
    CellSet cells(memory());
    std::set<CellGrid::Cell> reference;
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        const CellGrid::Cell cell = random_cell(random);
        std::uint32_t wanted = 0;
        for (int step = 0; step < neighbour_count; ++step)
            if (random() % 2 == 0 && CellGrid::inside(neighbour(cell, step))) wanted |= 1U << step;
        std::uint32_t fresh = 0;
        for (int step = 0; step < neighbour_count; ++step)
            if ((wanted >> step & 1U) != 0 && reference.insert(neighbour(cell, step)).second) fresh |= 1U << step;
        EXPECT_EQ(cells.insert_around(cell, wanted), fresh);
        EXPECT_EQ(cells.insert(CellGrid::pack(cell)), reference.insert(cell).second) << "one set for both";
    }
    EXPECT_EQ(cells.size(), static_cast<std::int64_t>(reference.size()));
}

TEST(CellGrid, PacksAndPlacesCells) {
    const CellGrid grid{{-1.0, -2.0, -3.0}, 0.5};
    const CellGrid::Cell cell = grid.cell_of({0.1, 0.1, 0.1});
    EXPECT_EQ(cell, (CellGrid::Cell{2, 4, 6}));
    EXPECT_EQ(CellGrid::unpack(CellGrid::pack(cell)), cell);
    EXPECT_EQ(grid.centre(cell), glm::dvec3(0.25, 0.25, 0.25));
    const CellGrid::Cell last = {CellGrid::most - 1, 0, CellGrid::most - 1};
    EXPECT_EQ(CellGrid::unpack(CellGrid::pack(last)), last);
    EXPECT_TRUE(CellGrid::inside(last));
    EXPECT_FALSE(CellGrid::inside({0, -1, 0}));
    EXPECT_FALSE(CellGrid::inside({0, CellGrid::most, 0}));
    EXPECT_EQ(grid.cell_of({-9.0, 1e9, -3.0}), (CellGrid::Cell{0, CellGrid::most - 1, 0})) << "clamped";
}

void expect_right_handed(const TangentFrame& frame, const glm::dvec3& n) {
    EXPECT_NEAR(glm::length(frame.u), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(frame.r), 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(glm::cross(frame.u, frame.r), n), 0.0, 1e-12);
}

TEST(TangentFrame, IsOrthonormalForEveryNormal) {
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = glm::normalize(pseudo_random(i));
        expect_right_handed(stipple_frame(n), n);
        expect_right_handed(combing_frame(n), n);
        EXPECT_NEAR(glm::dot(any_perpendicular(n), n), 0.0, 1e-15);
    }
    for (const glm::dvec3 axis : {glm::dvec3(0.36, 0.48, 0.80), glm::dvec3(-0.36, -0.48, -0.80),
                                  glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
        expect_right_handed(stipple_frame(axis), axis);
        expect_right_handed(combing_frame(axis), axis);
    }
}

// Stark's construction: n crossed with the axis of its smallest component, so u has no part along that axis.
TEST(TangentFrame, CombingLeavesOutTheSmallestComponent) {
    EXPECT_EQ(combing_frame(glm::normalize(glm::dvec3(0.1, 0.7, -0.6))).u.x, 0.0);
    EXPECT_EQ(combing_frame(glm::normalize(glm::dvec3(0.7, -0.1, -0.6))).u.y, 0.0);
    EXPECT_EQ(combing_frame(glm::normalize(glm::dvec3(0.7, 0.6, 0.1))).u.z, 0.0);
}

} // namespace
} // namespace hrbfnpr::geometry::geometry_test
