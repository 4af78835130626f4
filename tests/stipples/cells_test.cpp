// SPDX-License-Identifier: MIT
// Tests maps of cells, and the cells around one cell.
#include "stipples/surface_cells.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace hrbfnpr::stipples::cells_test {
namespace {

using geometry::CellGrid;
using geometry::morton_cell;
using geometry::morton_code;
using geometry::neighbour;
using geometry::neighbour_count;

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

TEST(CellMap, FindsTheGivenCells) {
    base::Array<std::uint64_t> codes(memory());
    for (std::uint64_t i = 0; i < 1000; ++i) codes.push_back(i * i * 7919U);
    const CellMap map(memory(), codes);
    for (std::int64_t i = 0; i < codes.size(); ++i) EXPECT_EQ(map.find(codes[i]), i);
    for (std::uint64_t i = 1; i < 1000; ++i) EXPECT_EQ(map.find(i * i * 7919U + 1), -1);
    EXPECT_EQ(CellMap(memory()).find(3), -1);
}

CellGrid::Cell random_cell(std::mt19937& random) {
    return {static_cast<std::int64_t>(random() % 9), static_cast<std::int64_t>(random() % 9),
            static_cast<std::int64_t>(random() % 9)};
}

TEST(CellMap, FindsNeighbouringCells) {
    std::set<std::uint64_t> all;
    std::mt19937 random(6);
    for (int i = 0; i < 300; ++i) all.insert(morton_code(random_cell(random)));
    base::Array<std::uint64_t> codes(memory());
    for (const std::uint64_t code : all) codes.push_back(code);
    const CellMap map(memory(), codes);
    CellMap::BlocksAround blocks;
    for (std::int64_t i = 0; i < codes.size(); ++i) {
        const CellMap::Around around = map.around(codes[i], blocks);
        EXPECT_EQ(around[CellMap::centre_index], i);
        for (int step = 0; step < neighbour_count; ++step) {
            const CellGrid::Cell there = neighbour(morton_cell(codes[i]), step);
            EXPECT_EQ(around[static_cast<std::size_t>(step)],
                      CellGrid::inside(there) ? map.find(morton_code(there)) : -1);
        }
        CellGrid::Cell next = morton_cell(codes[i]);
        ++next[1];
        EXPECT_EQ(around[CellMap::centre_index + CellMap::step_along[1]], map.find(morton_code(next)));
    }
}

} // namespace
} // namespace hrbfnpr::stipples::cells_test
