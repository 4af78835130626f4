// SPDX-License-Identifier: MIT
#include "implicit/cube_shift.h"

#include "base/memory.h"
#include "fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cube_shift_test {

using hrbfnpr::implicit::CubeBasis;
using hrbfnpr::implicit::CubeShift;
using test::scatter;

namespace {

std::vector<double> some_terms(int degree, int highest) {
    std::vector<double> terms;
    int k = 0;
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
            for (int c = 0; a + b + c <= degree; ++c) terms.push_back(a + b + c <= highest ? scatter(k++) : 0.0);
    return terms;
}

double value_at(int degree, const std::vector<double>& terms, const glm::dvec3& place) {
    std::vector<double> products(terms.size());
    CubeBasis::evaluate(degree, place, products.data());
    double sum = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k) sum += terms[k] * products[k];
    return sum;
}

// Returns the largest error when a polynomial of degree `highest` is shifted to an octant and added to 1.
double largest_error(int from, int to, int highest, int octant) {
    const std::vector<double> terms = some_terms(from, highest);
    std::vector<double> moved(static_cast<std::size_t>(CubeBasis::terms(to)));
    moved[0] = 1.0;
    hrbfnpr::base::Memory memory;
    hrbfnpr::base::OwnedObject<CubeShift::Work> work(memory);
    CubeShift(from, to).add(terms.data(), octant, moved.data(), *work);
    const glm::dvec3 centre(octant & 1 ? 0.5 : -0.5, octant & 2 ? 0.5 : -0.5, octant & 4 ? 0.5 : -0.5);
    double largest = 0.0;
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 place(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2));
        const double expected = 1.0 + value_at(from, terms, centre + 0.5 * place);
        largest = std::max(largest, std::abs(value_at(to, moved, place) - expected));
    }
    return largest;
}

} // namespace

TEST(CubeShift, IsTheSamePolynomialInEachOctant) {
    for (const int degree : {1, 2, 5, 14, CubeBasis::degree_max})
        for (int octant = 0; octant < 8; ++octant) EXPECT_LT(largest_error(degree, degree, degree, octant), 1e-11);
}

TEST(CubeShift, ALowerDegreeLosesOnlyHigherTerms) {
    for (int octant = 0; octant < 8; ++octant) {
        EXPECT_LT(largest_error(16, 14, 14, octant), 1e-11);
        EXPECT_GT(largest_error(16, 14, 16, octant), 1e-9);
    }
}

} // namespace cube_shift_test
