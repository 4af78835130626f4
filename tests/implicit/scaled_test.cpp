// SPDX-License-Identifier: MIT
// Tests an implicit in another unit of length.
#include "fields.h"

#include "implicit/custom.h"
#include "implicit/scaled.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace scaled_test {

namespace implicit = hrbfnpr::implicit;

namespace {

// x y - 3, scaled by `unit` in place and value.
std::int32_t saddle(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                    double* hessian) {
    const double unit = *static_cast<double*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = points[3 * i] / unit;
        const double y = points[3 * i + 1] / unit;
        value[i] = unit * (x * y - 3.0);
        const double g[3] = {y, x, 0.0};
        const double h[6] = {0.0, 1.0 / unit, 0.0, 0.0, 0.0, 0.0};
        for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = g[c];
        for (int c = 0; hessian != nullptr && c < 6; ++c) hessian[6 * i + c] = h[c];
    }
    return 0;
}

implicit::CustomFunction saddle_in(double& unit) {
    implicit::CustomFunction function;
    function.function = saddle;
    function.user = &unit;
    function.has_gradient = function.has_hessian = true;
    function.bounds = {unit * glm::dvec3(-2.0), unit * glm::dvec3(3.0)};
    return function;
}

// There are more points than in a batch; the fields are evaluated one by one and all together.
TEST(Scaled, GivesTheSameFunctionInAnotherUnit) {
    double small = 0x1p-80;
    double one = 1.0;
    const implicit::Custom own(saddle_in(small));
    const implicit::Custom expected(saddle_in(one));
    const implicit::Scaled scaled(own, small);
    EXPECT_EQ(scaled.bounds().min, expected.bounds().min);
    EXPECT_EQ(scaled.diagonal(), expected.diagonal());
    EXPECT_EQ(scaled.concurrent(), own.concurrent());
    constexpr std::int64_t count = 700;
    std::vector<double> x, y, z(count, 0.25);
    for (int i = 0; i < count; ++i) {
        x.push_back(0.01 * i);
        y.push_back(3.0 - 0.02 * i);
    }
    const implicit::PointBatch points{x.data(), y.data(), z.data(), count};
    for (const int wanted : {1, 2, 4, 7}) {
        std::vector<double> got(10 * count, -1.0);
        std::vector<double> right(10 * count, -1.0);
        const auto evaluate = [&](const implicit::Implicit& function, std::vector<double>& to) {
            implicit::FieldBatch fields;
            if ((wanted & 1) != 0) fields.value = to.data();
            for (std::size_t k = 0; (wanted & 2) != 0 && k < 3; ++k) fields.gradient[k] = to.data() + (1 + k) * count;
            for (std::size_t k = 0; (wanted & 4) != 0 && k < 6; ++k) fields.hessian[k] = to.data() + (4 + k) * count;
            function.evaluate(points, fields);
        };
        evaluate(scaled, got);
        evaluate(expected, right);
        EXPECT_EQ(got, right) << wanted;
    }
}

// There are more points than in a batch. A function without sheets has none in another unit either.
TEST(Scaled, HasTheSameSheets) {
    const auto own = hrbfnpr::test::bored_cube();
    constexpr double unit = 0.25;
    const implicit::Scaled scaled(*own, unit);
    ASSERT_NE(scaled.sheets(), nullptr);
    EXPECT_EQ(scaled.sheets()->count(), 7);
    constexpr std::int64_t count = 600;
    std::vector<double> x, y, z;
    for (int i = 0; i < count; ++i) {
        x.push_back(6.0 * std::sin(12.9898 * i));
        y.push_back(6.0 * std::sin(78.233 * i + 1.0));
        z.push_back(6.0 * std::sin(37.719 * i + 2.0));
    }
    const implicit::PointBatch points{x.data(), y.data(), z.data(), count};
    std::vector<std::int32_t> active(count);
    scaled.sheets()->active(points, active.data());
    std::vector<double> f(count), gx(count), gy(count), gz(count);
    std::vector<std::vector<double>> h(6, std::vector<double>(count));
    std::vector<int> seen(7);
    for (std::int32_t sheet = 0; sheet < 7; ++sheet) {
        scaled.sheets()->evaluate(sheet, points,
                                  {f.data(),
                                   {gx.data(), gy.data(), gz.data()},
                                   {h[0].data(), h[1].data(), h[2].data(), h[3].data(), h[4].data(), h[5].data()}});
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 p = unit * glm::dvec3(x[i], y[i], z[i]);
            const hrbfnpr::test::Field field = own->sheet_at(sheet, p);
            ASSERT_EQ(f[i], field.value / unit);
            ASSERT_EQ(glm::dvec3(gx[i], gy[i], gz[i]), field.gradient);
            ASSERT_EQ(h[3][i], unit * field.hessian[3]);
            ASSERT_EQ(active[i], own->active_at(p));
            seen[static_cast<std::size_t>(active[i])] = 1;
        }
    }
    EXPECT_EQ(seen, std::vector<int>(7, 1));
    double one = 1.0;
    const implicit::Custom smooth(saddle_in(one));
    EXPECT_EQ(implicit::Scaled(smooth, 2.0).sheets(), nullptr);
}

} // namespace

} // namespace scaled_test
