// SPDX-License-Identifier: MIT
#include "kernel/polynomial.h"

#include <gtest/gtest.h>

#include <array>

namespace polynomial_test {

namespace kernel = hrbfnpr::kernel;

namespace {

const glm::dvec3 at{0.7, -1.3, 0.4};
constexpr double h = 1e-3;

glm::dvec3 moved(const glm::dvec3& p, glm::length_t axis, double by) {
    glm::dvec3 result = p;
    result[axis] += by;
    return result;
}

std::array<double, kernel::polynomial_size_max> coefficients() {
    std::array<double, kernel::polynomial_size_max> c{};
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = 0.3 + 0.17 * static_cast<double>(k * k % 7) - 0.5 * (k % 3 == 0);
    return c;
}

TEST(Polynomial, HasTheBinomialNumberOfTerms) {
    EXPECT_EQ(kernel::polynomial_size(-1), 0);
    EXPECT_EQ(kernel::polynomial_size(0), 1);
    EXPECT_EQ(kernel::polynomial_size(1), 4);
    EXPECT_EQ(kernel::polynomial_size(2), 10);
    EXPECT_EQ(kernel::polynomial_size(3), 20);
}

TEST(Polynomial, BasisHasTheDocumentedOrder) {
    kernel::PolynomialBasis basis;
    kernel::polynomial_basis(3, {2.0, 3.0, 5.0}, basis);
    const std::array<double, 20> expected = {1, 2, 3, 5, 4, 6, 10, 9, 15, 25, 8, 12, 20, 18, 30, 50, 27, 45, 75, 125};
    EXPECT_EQ(basis.value, expected);
}

TEST(Polynomial, BasisGradientsAreDerivatives) {
    kernel::PolynomialBasis basis;
    kernel::PolynomialBasis plus;
    kernel::PolynomialBasis minus;
    kernel::polynomial_basis(3, at, basis);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        kernel::polynomial_basis(3, moved(at, axis, h), plus);
        kernel::polynomial_basis(3, moved(at, axis, -h), minus);
        for (std::size_t k = 0; k < 20; ++k)
            EXPECT_NEAR(basis.gradient[k][axis], (plus.value[k] - minus.value[k]) / (2 * h), 2e-6) << k << " " << axis;
    }
}

TEST(Polynomial, ValueIsTheCombinationOfTheBasis) {
    const auto c = coefficients();
    for (std::int32_t degree = -1; degree <= 3; ++degree) {
        kernel::PolynomialBasis basis;
        kernel::polynomial_basis(degree, at, basis);
        double value = 0.0;
        glm::dvec3 gradient{0.0};
        for (std::size_t k = 0; k < static_cast<std::size_t>(kernel::polynomial_size(degree)); ++k) {
            value += c[k] * basis.value[k];
            gradient += c[k] * basis.gradient[k];
        }
        const kernel::PolynomialField field = kernel::polynomial(degree, c.data(), at);
        EXPECT_NEAR(field.value, value, 1e-14) << degree;
        EXPECT_NEAR(glm::length(field.gradient - gradient), 0.0, 1e-14) << degree;
    }
}

TEST(Polynomial, HessianIsTheDerivativeOfTheGradient) {
    const auto c = coefficients();
    constexpr std::size_t index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (std::int32_t degree = -1; degree <= 3; ++degree) {
        const kernel::PolynomialField field = kernel::polynomial(degree, c.data(), at);
        for (glm::length_t a = 0; a < 3; ++a) {
            const glm::dvec3 plus = kernel::polynomial(degree, c.data(), moved(at, a, h)).gradient;
            const glm::dvec3 minus = kernel::polynomial(degree, c.data(), moved(at, a, -h)).gradient;
            for (glm::length_t b = 0; b < 3; ++b)
                EXPECT_NEAR(field.hessian[index[a][b]], (plus[b] - minus[b]) / (2 * h), 1e-5)
                    << degree << " " << a << b;
        }
    }
}

TEST(Polynomial, DegreeOneGivesTheBitsOfAHigherDegree) {
    std::array<double, kernel::polynomial_size_max> c{0.3, -1.7, 2.9, 0.41};
    for (const glm::dvec3& p : {glm::dvec3(0.1, -0.7, 1.3), glm::dvec3(-31.7, 0.0, 2e-9)}) {
        const kernel::PolynomialField low = kernel::polynomial(1, c.data(), p);
        const kernel::PolynomialField high = kernel::polynomial(2, c.data(), p);
        EXPECT_EQ(low.value, high.value);
        EXPECT_EQ(low.gradient, high.gradient);
        for (const double second : low.hessian) EXPECT_EQ(second, 0.0);
    }
}

} // namespace

} // namespace polynomial_test
