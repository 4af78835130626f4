// SPDX-License-Identifier: MIT
#include "output/vector/shapes.h"

#include <gtest/gtest.h>

namespace hrbfnpr::output::shapes_test {
namespace {

std::int64_t points_of_spiral(double pen_width) {
    base::Memory memory;
    base::Array<glm::dvec2> points(memory);
    PageDot dot{};
    dot.radius = 0.3;
    add_spiral(dot, pen_width, 0.05, points);
    return points.size();
}

TEST(SpiralTest, HasMoreTurnsForThinnerPens) {
    EXPECT_GT(points_of_spiral(0.01), 5 * points_of_spiral(0.1));
    EXPECT_GT(points_of_spiral(0.001), 5 * points_of_spiral(0.01));
}

TEST(SpiralTest, IsBoundedForPensOfNoWidth) {
    EXPECT_LT(points_of_spiral(1e-9), 20000);
    EXPECT_LT(points_of_spiral(1e-300), 20000);
}

} // namespace
} // namespace hrbfnpr::output::shapes_test
