// SPDX-License-Identifier: MIT
#include "geometry/neighbours.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace hrbfnpr::geometry::neighbours_test {
namespace {

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

// A lattice with many ties, in which each seventh point is at the same place.
VecArray lattice(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i)
        points.push_back(i % 7 == 0 ? glm::dvec3(3.0) : glm::dvec3(i * 31 % 9, i * 17 % 8, i * 5 % 6));
    return points;
}

TEST(Neighbours, AreTheNearestInOrder) {
    for (const int count : {1, 2, 5, 9, 300}) {
        const VecArray points = lattice(count);
        const Neighbours neighbours(base::Parallel(3, nullptr, nullptr), points, 6, {});
        ASSERT_EQ(neighbours.each(), std::min(6, count - 1));
        for (int i = 0; i < count; ++i) {
            std::vector<double> distances;
            for (int j = 0; j < count; ++j)
                if (j != i) distances.push_back(glm::distance(points[j], points[i]));
            std::sort(distances.begin(), distances.end());
            const auto found = neighbours.of(i);
            EXPECT_EQ(std::set<std::int64_t>(found.begin(), found.end()).size(), found.size());
            EXPECT_EQ(std::count(found.begin(), found.end(), i), 0);
            for (std::size_t k = 0; k < found.size(); ++k)
                ASSERT_EQ(glm::distance(points[found[k]], points[i]), distances[k]) << count << " " << i << " " << k;
        }
    }
}

TEST(Neighbours, AreEmptyWithoutPoints) {
    EXPECT_EQ(Neighbours(base::Parallel(), VecArray(memory()), 6, {}).each(), 0);
}

} // namespace
} // namespace hrbfnpr::geometry::neighbours_test
