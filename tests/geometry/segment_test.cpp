// SPDX-License-Identifier: MIT
// Tests the nearest point of a segment.
#include "geometry/segment.h"

#include <gtest/gtest.h>

namespace hrbfnpr::geometry::segment_test {
namespace {

TEST(Segment, NearestPointIsInsideOrAtAnEnd) {
    const glm::dvec3 from(1.0, 2.0, 3.0), to(1.0, 2.0, 7.0);
    EXPECT_EQ(nearest_parameter(glm::dvec3(4.0, 6.0, 4.0), from, to), 0.25);
    EXPECT_EQ(distance_to_segment(glm::dvec3(4.0, 6.0, 4.0), from, to), 5.0);
    EXPECT_EQ(nearest_parameter(glm::dvec3(1.0, 5.0, -1.0), from, to), 0.0);
    EXPECT_EQ(distance_to_segment(glm::dvec3(1.0, 5.0, -1.0), from, to), 5.0);
    EXPECT_EQ(nearest_parameter(glm::dvec3(1.0, 6.0, 10.0), from, to), 1.0);
    EXPECT_EQ(squared_distance_to_segment(glm::dvec3(1.0, 6.0, 10.0), from, to), 25.0);
}

TEST(Segment, MayBeASinglePoint) {
    const glm::vec2 place(3.0F, 4.0F);
    EXPECT_EQ(nearest_parameter(glm::vec2(0.0F), place, place), 0.0F);
    EXPECT_EQ(distance_to_segment(glm::vec2(0.0F), place, place), 5.0F);
}

} // namespace
} // namespace hrbfnpr::geometry::segment_test
