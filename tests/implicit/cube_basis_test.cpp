// SPDX-License-Identifier: MIT
#include "implicit/cube_basis.h"

#include "base/status.h"
#include "fields.h"
#include "triharmonic_powers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cube_basis_test {

namespace base = hrbfnpr::base;
using hrbfnpr::geometry::VecArray;
using hrbfnpr::implicit::CubeBasis;
using test::scatter;

namespace {

VecArray points_in_cube(base::Memory& memory, int count) {
    VecArray points(memory);
    for (int i = 0; i < count; ++i) points.push_back({scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)});
    return points;
}

// Interpolates f at the points from its values at the nodes.
template <class F>
std::vector<double> interpolated(const base::Runtime& runtime, const CubeBasis& basis, const VecArray& points, F&& f) {
    const auto count = static_cast<int>(points.size());
    const base::Array<double> matrix = basis.interpolation(runtime, points, count);
    std::vector<double> result(static_cast<std::size_t>(count));
    for (int k = 0; k < basis.size(); ++k)
        for (int i = 0; i < count; ++i)
            result[static_cast<std::size_t>(i)] +=
                matrix[std::int64_t{k} * CubeBasis::padded(count) + i] * f(basis.nodes()[k]);
    return result;
}

template <class F>
double largest_error(const base::Runtime& runtime, const CubeBasis& basis, F&& f) {
    const VecArray points = points_in_cube(runtime.memory, 13);
    const std::vector<double> found = interpolated(runtime, basis, points, f);
    double error = 0.0;
    for (std::int64_t i = 0; i < points.size(); ++i)
        error = std::max(error, std::abs(found[static_cast<std::size_t>(i)] - f(points[i])));
    return error;
}

TEST(CubeBasis, TermsAreProductsOfCosines) {
    for (const int degree : {0, 1, 2, 7, CubeBasis::degree_max}) {
        std::vector<double> terms(static_cast<std::size_t>(CubeBasis::terms(degree)));
        const glm::dvec3 p(0.3, -0.8, 0.55);
        CubeBasis::evaluate(degree, p, terms.data());
        std::size_t k = 0;
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b)
                for (int c = 0; a + b + c <= degree; ++c)
                    EXPECT_NEAR(terms[k++],
                                std::cos(a * std::acos(p.x)) * std::cos(b * std::acos(p.y)) *
                                    std::cos(c * std::acos(p.z)),
                                1e-13);
        EXPECT_EQ(k, terms.size());
    }
}

TEST(CubeBasis, InterpolationReproducesTriharmonicPolynomials) {
    const base::Runtime runtime;
    for (const int degree : {0, 1, 2, 3, 5, 8, 14, CubeBasis::degree_max}) {
        const CubeBasis basis(runtime, degree);
        test_triharmonic::expect_reproduced(degree, [&](const auto& f) { return largest_error(runtime, basis, f); });
    }
    const CubeBasis basis(runtime, 6);
    EXPECT_GT(largest_error(runtime, basis, [](const glm::dvec3& p) { return test_triharmonic::power(p, 0, 3, 0.0); }),
              1e-2);
}

// Each degree divides the error by about 2.9, down to rounding.
TEST(CubeBasis, ApproximatesFarSources) {
    const base::Runtime runtime;
    const glm::dvec3 source(3.1, 0.9, -0.7);
    const auto kernel = [&](const glm::dvec3& p) { return std::pow(glm::distance(p, source), 3.0); };
    const double first = largest_error(runtime, CubeBasis(runtime, 6), kernel);
    EXPECT_LT(first, 3e-2);
    for (const int degree : {9, 12, 15}) {
        const double error = largest_error(runtime, CubeBasis(runtime, degree), kernel);
        EXPECT_LT(error, 4.0 * first * std::pow(2.9, 6 - degree)) << degree;
    }
    EXPECT_LT(largest_error(runtime, CubeBasis(runtime, CubeBasis::degree_max), kernel), 1e-9);
}

TEST(CubeBasis, ToCoefficientsInvertsEvaluation) {
    const base::Runtime runtime;
    for (const int degree : {0, 1, 2, 6, 9, CubeBasis::degree_max}) {
        const CubeBasis basis(runtime, degree);
        std::vector<double> terms(static_cast<std::size_t>(basis.terms()));
        for (std::int64_t i = 0; i<basis.size(); i += basis.size()> 300 ? 97 : 1) {
            CubeBasis::evaluate(degree, basis.nodes()[i], terms.data());
            for (std::int64_t j = 0; j < basis.size(); ++j) {
                double sum = 0.0;
                for (std::int64_t k = 0; k < basis.terms(); ++k)
                    sum += terms[static_cast<std::size_t>(k)] * basis.to_coefficients()[j * basis.term_stride() + k];
                EXPECT_NEAR(sum, i == j ? 1.0 : 0.0, 1e-11) << degree << " " << i << " " << j;
            }
        }
    }
}

TEST(CubeBasis, TheStoredTransposeMatchesTheMatrix) {
    const base::Runtime runtime;
    const CubeBasis basis(runtime, 7);
    for (std::int64_t j = 0; j < basis.size(); ++j)
        for (std::int64_t k = 0; k < basis.terms(); ++k)
            EXPECT_EQ(basis.to_coefficients()[j * basis.term_stride() + k],
                      basis.to_coefficients_transposed()[k * basis.stride() + j]);
}

TEST(CubeBasis, NodesAreDistinctAndInTheCube) {
    const base::Runtime runtime;
    for (const int degree : {0, 3, 10}) {
        const CubeBasis basis(runtime, degree);
        EXPECT_EQ(basis.nodes().size(), basis.stride());
        EXPECT_EQ(basis.stride() % 8, 0);
        for (std::int64_t i = 0; i < basis.size(); ++i) {
            const glm::dvec3 p = basis.nodes()[i];
            EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1.0);
            for (std::int64_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(p, basis.nodes()[j]), 1e-3);
        }
        for (std::int64_t i = basis.size(); i < basis.stride(); ++i) EXPECT_EQ(basis.nodes()[i], glm::dvec3(0.0));
    }
}

// Lebesgue's constant stays small. The nodes are chosen for that.
TEST(CubeBasis, InterpolationIsStable) {
    const base::Runtime runtime;
    const CubeBasis basis(runtime, 10);
    const VecArray points = points_in_cube(runtime.memory, 50);
    const base::Array<double> matrix = basis.interpolation(runtime, points, 50);
    for (std::int64_t i = 0; i < 50; ++i) {
        double sum = 0.0;
        for (std::int64_t k = 0; k < basis.size(); ++k) sum += std::abs(matrix[k * CubeBasis::padded(50) + i]);
        EXPECT_LT(sum, 500.0) << i;
    }
}

} // namespace

} // namespace cube_basis_test
