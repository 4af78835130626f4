// SPDX-License-Identifier: MIT
#include "geometry/along_curves.h"
#include "support/samples.h"

#include <gtest/gtest.h>

namespace hrbfnpr::geometry::along_curves_test {
namespace {

bool are(const test::Samples& samples, int times = 1) {
    base::Memory memory;
    VecArray points(memory);
    for (int k = 0; k < times; ++k)
        for (std::size_t i = 0; i < samples.points.size(); i += 3)
            points.push_back({samples.points[i], samples.points[i + 1], samples.points[i + 2]});
    return lie_along_curves(PointTree(points, {}));
}

TEST(AlongCurves, WiresAndSectionsAreDetected) {
    EXPECT_TRUE(are(test::torus_wires(0.05)));
    EXPECT_TRUE(are(test::torus_wires(0.25)));
    EXPECT_TRUE(are(test::torus_sections(9, 64)));
    EXPECT_TRUE(are(test::with_noise(test::torus_wires(0.05), 0.03)));
    EXPECT_FALSE(are(test::with_noise(test::torus_wires(0.05), 0.5)));
}

TEST(AlongCurves, DuplicatedPointsAreDetected) { EXPECT_TRUE(are(test::torus_wires(0.05), 2)); }

TEST(AlongCurves, PointsSpreadOverASurfaceAreNotDetected) {
    for (const test::Samples& shape : {test::sphere(25), test::sphere(5000), test::torus(700), test::bumpy(600)}) {
        EXPECT_FALSE(are(shape)) << shape.count();
        EXPECT_FALSE(are(test::with_noise(shape, 0.02))) << shape.count();
    }
    for (const double apart : {1.0, 1.5}) {
        test::Samples grid;
        for (int i = 0; i < 120; ++i)
            for (int k = 0; k < 120; ++k) grid.add({1.0 * i, apart * k, 0.0}, {0.0, 0.0, 1.0});
        EXPECT_FALSE(are(grid)) << apart;
    }
    EXPECT_FALSE(are(test::sphere_6()));
}

} // namespace
} // namespace hrbfnpr::geometry::along_curves_test
