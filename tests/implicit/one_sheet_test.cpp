// SPDX-License-Identifier: MIT
// Tests one sheet of an implicit with creases, and derivatives beside a crease.
#include "implicit/shape_source.h"
#include "implicit/sheets.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace hrbfnpr::implicit::one_sheet_test {
namespace {

using namespace test;

std::vector<double> thirds_of(const ShapeSource& shape, const std::vector<glm::dvec3>& points) {
    const std::size_t count = points.size();
    std::vector<double> x(count), y(count), z(count), out(16 * count, -1.0);
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = points[i].x;
        y[i] = points[i].y;
        z[i] = points[i].z;
    }
    ThirdBatch to;
    for (std::size_t c = 0; c < 6; ++c) to.hessian[c] = out.data() + c * count;
    for (std::size_t c = 0; c < 10; ++c) to.third[c] = out.data() + (6 + c) * count;
    shape.evaluate({x.data(), y.data(), z.data(), static_cast<std::int64_t>(count)}, to);
    return out;
}

TEST(OneSheet, HasTheValuesOfItsSheetEverywhere) {
    const auto shape = stepped_shaft();
    const OneSheet cylinder(*shape, *shape, 0);
    const glm::dvec3 p(0.3, -0.4, 2.5); // far from the region where the sheet is f
    double value = 0.0;
    cylinder.evaluate({&p.x, &p.y, &p.z, 1}, {&value, {}, {}});
    EXPECT_DOUBLE_EQ(value, -0.5);
    EXPECT_EQ(cylinder.sheets(), nullptr);
    EXPECT_EQ(cylinder.diagonal(), shape->diagonal());
    EXPECT_EQ(cylinder.sheet(), 0);
}

// The points are nearer to creases than the step of the differences, on both sides in turn.
TEST(DifferencedShape, StaysOnItsSheet) {
    const auto shape = stepped_shaft();
    std::vector<glm::dvec3> side, ring;
    for (int i = 0; i < 70; ++i) {
        const glm::dvec3 out(std::cos(0.1 * i), std::sin(0.1 * i), 0.0);
        side.push_back(out - glm::dvec3(0.0, 0.0, 1e-5));
        ring.push_back((1.0 - 1e-5) * out);
    }
    std::vector<glm::dvec3> both;
    for (std::size_t i = 0; i < side.size(); ++i) {
        both.push_back(side[i]);
        both.push_back(ring[i]);
    }
    const std::vector<double> found = thirds_of(DifferencedShape(*shape), both);
    const OneSheet cylinder(*shape, *shape, 0);
    const OneSheet plane(*shape, *shape, 1);
    const std::vector<double> on_side = thirds_of(DifferencedShape(cylinder), side);
    const std::vector<double> on_ring = thirds_of(DifferencedShape(plane), ring);
    for (std::size_t c = 0; c < 16; ++c)
        for (std::size_t i = 0; i < side.size(); ++i) {
            ASSERT_EQ(found[c * both.size() + 2 * i], on_side[c * side.size() + i]) << c;
            ASSERT_EQ(found[c * both.size() + 2 * i + 1], on_ring[c * side.size() + i]) << c;
        }
}

} // namespace
} // namespace hrbfnpr::implicit::one_sheet_test
