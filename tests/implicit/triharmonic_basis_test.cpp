// SPDX-License-Identifier: MIT
#include "implicit/triharmonic_basis.h"

#include "fields.h"
#include "implicit/cube_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace triharmonic_basis_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::geometry::VecArray;
using implicit::CubeBasis;
using implicit::triharmonic_size;

namespace {

TEST(TriharmonicBasis, HasTheExpectedNumberOfTerms) {
    for (int degree = 0; degree <= 5; ++degree) EXPECT_EQ(triharmonic_size(degree), CubeBasis::terms(degree));
    EXPECT_EQ(triharmonic_size(6), CubeBasis::terms(6) - 1); // without |p|^6
    EXPECT_EQ(triharmonic_size(7), CubeBasis::terms(7) - 4); // and without its products with x, y, z
    EXPECT_EQ(triharmonic_size(20), 21 * 21 + 19 * 19 + 17 * 17);
}

TEST(TriharmonicBasis, ValuesMatchTheCoefficients) {
    base::Memory memory;
    VecArray points(memory);
    for (int i = 0; i < 9; ++i)
        points.push_back({test::scatter(3 * i), test::scatter(3 * i + 1), test::scatter(3 * i + 2)});
    for (const int degree : {0, 1, 2, 5, 9, CubeBasis::degree_max}) {
        const int terms = CubeBasis::terms(degree);
        const base::Array<double> values = implicit::triharmonic_values(points, 9, degree, 10);
        const base::Array<double> coefficients = implicit::triharmonic_coefficients(memory, degree, terms);
        ASSERT_EQ(values.size(), 10 * triharmonic_size(degree));
        std::vector<double> term(static_cast<std::size_t>(terms));
        for (std::int64_t i = 0; i < 9; ++i) {
            CubeBasis::evaluate(degree, points[i], term.data());
            for (std::int64_t k = 0; k < triharmonic_size(degree); ++k) {
                double sum = 0.0;
                double size = 0.0;
                for (std::int64_t t = 0; t < terms; ++t) {
                    sum += coefficients[k * terms + t] * term[static_cast<std::size_t>(t)];
                    size += std::abs(coefficients[k * terms + t]);
                }
                EXPECT_NEAR(sum, values[k * 10 + i], 1e-13 * size) << degree << " " << k;
            }
        }
    }
}

// The seven-point Laplacian is exact for polynomials of second degree. Applied three times to the basis, its error is
// the square of the step.
TEST(TriharmonicBasis, TheThirdPowerOfTheLaplacianVanishes) {
    base::Memory memory;
    constexpr double step = 0.05;
    VecArray points(memory); // a grid of 7 x 7 x 7 about a point; only |i| + |j| + |k| <= 3 is used
    for (int k = -3; k <= 3; ++k)
        for (int j = -3; j <= 3; ++j)
            for (int i = -3; i <= 3; ++i) points.push_back(glm::dvec3(0.2, -0.1, 0.3) + step * glm::dvec3(i, j, k));
    const int degree = 7;
    const std::int64_t stride = points.size();
    base::Array<double> values = implicit::triharmonic_values(points, stride, degree, stride);
    for (std::int64_t column = 0; column < triharmonic_size(degree); ++column) {
        std::vector<double> u(values.data() + column * stride, values.data() + (column + 1) * stride);
        double size = 0.0;
        for (int times = 1; times <= 3; ++times) {
            const std::vector<double> old = u;
            for (int k = -3 + times; k <= 3 - times; ++k)
                for (int j = -3 + times; j <= 3 - times; ++j)
                    for (int i = -3 + times; i <= 3 - times; ++i) {
                        const auto at = static_cast<std::size_t>((i + 3) + 7 * (j + 3) + 49 * (k + 3));
                        u[at] = (old[at - 1] + old[at + 1] + old[at - 7] + old[at + 7] + old[at - 49] + old[at + 49] -
                                 6.0 * old[at]) /
                                (step * step);
                        if (times == 1) size = std::max(size, std::abs(u[at]));
                    }
        }
        EXPECT_LT(std::abs(u[3 + 21 + 147]), 40.0 * std::max(size, 1.0)) << column;
    }
}

} // namespace

} // namespace triharmonic_basis_test
