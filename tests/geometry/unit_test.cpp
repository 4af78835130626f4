// SPDX-License-Identifier: MIT
// Tests units of length, and the conversion to integers of numbers that may be NaN.
#include "geometry/unit.h"

#include "geometry/cell_grid.h"

#include <gtest/gtest.h>

#include <limits>

namespace hrbfnpr::geometry::unit_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Unit, IsOneForOrdinarySizes) {
    for (const double size : {0.0, 1e-9, 1e-3, 1.0, 3.46, 1e9, infinity, nan, -1e-30}) EXPECT_EQ(unit_for(size), 1.0);
}

TEST(Unit, IsAPowerOfTwoInWhichTheSizeIsTwoToFour) {
    for (double size = 1e-300; size < 1e300; size *= 3.1e7) {
        const double unit = unit_for(size);
        if (unit == 1.0) continue;
        EXPECT_GE(size / unit, 2.0) << size;
        EXPECT_LT(size / unit, 4.0) << size;
        int power = 0;
        EXPECT_EQ(std::frexp(unit, &power), 0.5) << size;
    }
    EXPECT_EQ(unit_for(std::ldexp(3.5, -100)), std::ldexp(1.0, -100));
}

TEST(WholeNumber, IsAlwaysWithinItsRange) {
    EXPECT_EQ(truncate_to(2.9, 7), 2);
    EXPECT_EQ(truncate_to(7.0, 7), 7);
    EXPECT_EQ(truncate_to(-0.5, 7), 0);
    for (const double large : {8.0, 1e300, infinity}) EXPECT_EQ(truncate_to(large, 7), 7);
    for (const double none : {-1e300, -infinity, nan}) EXPECT_EQ(truncate_to(none, 7), 0);
}

TEST(CellGrid, HasACellForAnyPoint) {
    const CellGrid grid{glm::dvec3(0.0), 1e-300};
    EXPECT_EQ(grid.cell_of({nan, infinity, -infinity}), (CellGrid::Cell{0, CellGrid::most - 1, 0}));
    EXPECT_EQ(grid.cell_of(glm::dvec3(1e300)),
              (CellGrid::Cell{CellGrid::most - 1, CellGrid::most - 1, CellGrid::most - 1}));
}

} // namespace
} // namespace hrbfnpr::geometry::unit_test
