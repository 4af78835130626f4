// SPDX-License-Identifier: MIT
#include "kernel/polynomial.h"

namespace hrbfnpr::kernel {
namespace {

using Exponents = std::array<int, 3>;

constexpr std::array<Exponents, polynomial_size_max> monomials = {{
    {0, 0, 0},                                                        //
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1},                                  //
    {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1}, {0, 0, 2}, //
    {3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0}, {0, 2, 1}, {0, 1, 2}, {0, 0, 3},
}};

// Powers of t and their derivatives: [derivative][exponent].
using Powers = std::array<std::array<double, 4>, 3>;

Powers powers(double t) noexcept {
    return {{{1.0, t, t * t, t * t * t}, {0.0, 1.0, 2.0 * t, 3.0 * t * t}, {0.0, 0.0, 2.0, 6.0 * t}}};
}

class Point {
public:
    explicit Point(const glm::dvec3& p) noexcept : axis_{powers(p.x), powers(p.y), powers(p.z)} {}

    // Returns the monomial, differentiated by_x, by_y and by_z times along the three axes.
    [[nodiscard]] double at(const Exponents& e, int by_x, int by_y, int by_z) const noexcept {
        return factor(0, by_x, e[0]) * factor(1, by_y, e[1]) * factor(2, by_z, e[2]);
    }

private:
    [[nodiscard]] double factor(std::size_t axis, int by, int exponent) const noexcept {
        return axis_[axis][static_cast<std::size_t>(by)][static_cast<std::size_t>(exponent)];
    }

    std::array<Powers, 3> axis_;
};

} // namespace

void polynomial_basis(std::int32_t degree, const glm::dvec3& p, PolynomialBasis& basis) noexcept {
    const Point point(p);
    for (std::size_t k = 0; k < static_cast<std::size_t>(polynomial_size(degree)); ++k) {
        const Exponents& e = monomials[k];
        basis.value[k] = point.at(e, 0, 0, 0);
        basis.gradient[k] = {point.at(e, 1, 0, 0), point.at(e, 0, 1, 0), point.at(e, 0, 0, 1)};
    }
}

PolynomialField polynomial(std::int32_t degree, const double* coefficients, const glm::dvec3& p) noexcept {
    PolynomialField field;
    // This shortcut gives the same bits as the general code below. With few centres, the general code would take a
    // tenth of the total time.
    if (degree == 1) {
        field.value = 0.0 + coefficients[0] + coefficients[1] * p.x + coefficients[2] * p.y + coefficients[3] * p.z;
        field.gradient = 0.0 + glm::dvec3(coefficients[1], coefficients[2], coefficients[3]);
        return field;
    }
    const Point point(p);
    for (std::size_t k = 0; k < static_cast<std::size_t>(polynomial_size(degree)); ++k) {
        const Exponents& e = monomials[k];
        const double c = coefficients[k];
        field.value += c * point.at(e, 0, 0, 0);
        field.gradient += c * glm::dvec3(point.at(e, 1, 0, 0), point.at(e, 0, 1, 0), point.at(e, 0, 0, 1));
        field.hessian[0] += c * point.at(e, 2, 0, 0);
        field.hessian[1] += c * point.at(e, 1, 1, 0);
        field.hessian[2] += c * point.at(e, 1, 0, 1);
        field.hessian[3] += c * point.at(e, 0, 2, 0);
        field.hessian[4] += c * point.at(e, 0, 1, 1);
        field.hessian[5] += c * point.at(e, 0, 0, 2);
    }
    return field;
}

std::array<double, 10> polynomial_thirds(std::int32_t degree, const double* coefficients) noexcept {
    // If x^a y^b z^c of degree 3 is differentiated a, b and c times along its axes, the result is a! b! c!.
    constexpr std::array<double, 10> factorials = {6, 2, 2, 2, 1, 2, 6, 2, 2, 6};
    std::array<double, 10> third{};
    if (degree < 3) return third;
    for (std::size_t k = 0; k < third.size(); ++k) third[k] = factorials[k] * coefficients[10 + k];
    return third;
}

} // namespace hrbfnpr::kernel
