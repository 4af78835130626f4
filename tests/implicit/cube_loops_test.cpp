// SPDX-License-Identifier: MIT
#include "implicit/cube_loops.h"

#include "fields.h"
#include "implicit/cube_basis.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cube_loops_test {

namespace base = hrbfnpr::base;
using hrbfnpr::implicit::cube_batch;
using hrbfnpr::implicit::cube_lanes;
using hrbfnpr::implicit::cube_loops;
using hrbfnpr::implicit::cube_rows;
using hrbfnpr::implicit::CubeBasis;
using hrbfnpr::implicit::CubeSamples;
using hrbfnpr::test::instruction_sets;
using test::Points;
using test::scatter;

namespace {

using Numbers = std::vector<double>;

Numbers scattered(std::size_t count, int from) {
    Numbers result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(scatter(from + static_cast<int>(i)));
    return result;
}

// A full batch of vectors. Vectors beyond the wanted ones may be written, too.
struct Batch {
    explicit Batch(std::size_t length) {
        for (std::size_t v = 0; v < cube_batch; ++v) {
            vectors.push_back(scattered(length, 100 * static_cast<int>(v)));
            before.push_back(vectors.back());
        }
        for (Numbers& vector : vectors) out.push_back(vector.data());
    }
    std::vector<Numbers> vectors;
    std::vector<Numbers> before;
    std::vector<double*> out;
};

TEST(CubeLoops, CubesAreThoseOfTheDistances) {
    constexpr std::size_t columns = 13;
    constexpr std::size_t row = 16;
    constexpr std::size_t rows = cube_rows;
    const Numbers nodes[3] = {scattered(40, 1), scattered(40, 500), scattered(40, 900)};
    const double* const node[3] = {nodes[0].data(), nodes[1].data(), nodes[2].data()};
    const double shift[3] = {4.0, -2.0, 6.0};
    for (const base::InstructionSet set : instruction_sets()) {
        Numbers panel(columns * rows, -1.0);
        cube_loops(set).cubes(node, row, columns, shift, 0.25, panel.data());
        for (std::size_t k = 0; k < columns; ++k)
            for (std::size_t i = 0; i < rows; ++i) {
                const double distance =
                    std::hypot(nodes[0][row + i] - nodes[0][k] + shift[0], nodes[1][row + i] - nodes[1][k] + shift[1],
                               nodes[2][row + i] - nodes[2][k] + shift[2]);
                EXPECT_NEAR(panel[k * rows + i], 0.25 * std::pow(distance, 3.0), 1e-12)
                    << base::name(set) << " " << i << " " << k;
            }
    }
}

TEST(CubeLoops, MultiplyAddsTheProduct) {
    constexpr std::size_t columns = 11;
    constexpr std::size_t rows = 24;
    constexpr std::size_t stride = 32;
    const Numbers matrix = scattered(stride * columns, 5);
    const Numbers in = scattered(columns * cube_batch, 77);
    for (const base::InstructionSet set : instruction_sets()) {
        for (int vectors = 1; vectors <= cube_batch; ++vectors) {
            Batch batch(stride);
            cube_loops(set).multiply(matrix.data(), stride, rows, columns, in.data(), batch.out.data(), vectors);
            for (std::size_t v = 0; v < static_cast<std::size_t>(vectors); ++v) {
                for (std::size_t i = 0; i < stride; ++i) {
                    double sum = batch.before[v][i];
                    for (std::size_t k = 0; i < rows && k < columns; ++k)
                        sum += matrix[k * stride + i] * in[k * cube_batch + v];
                    EXPECT_NEAR(batch.vectors[v][i], sum, 1e-13)
                        << base::name(set) << " " << vectors << " " << v << " " << i;
                }
            }
        }
    }
}

constexpr glm::dvec3 centre{3.0, -1.0, 0.5};
constexpr double half_width = 0.25;

Points samples(int count) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.add(centre + half_width * glm::dvec3(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)));
    return points;
}

CubeSamples in_cube(const Points& points) {
    return {points.x.data(),
            points.y.data(),
            points.z.data(),
            static_cast<std::int64_t>(points.size()),
            {centre.x, centre.y, centre.z},
            half_width};
}

// T_n(x) = cos(n arccos x) and its derivative.
double chebyshev(int n, double x) { return std::cos(n * std::acos(x)); }
double chebyshev_slope(int n, double x) { return n * std::sin(n * std::acos(x)) / std::sin(std::acos(x)); }

struct Term {
    double value;
    glm::dvec3 gradient; // with respect to the caller's coordinates
};

// T_a T_b T_c at p.
Term term(const glm::ivec3& n, const glm::dvec3& p) {
    const glm::dvec3 x = (p - centre) / half_width;
    glm::dvec3 t;
    glm::dvec3 slope;
    for (glm::length_t c = 0; c < 3; ++c) {
        t[c] = chebyshev(n[c], x[c]);
        slope[c] = chebyshev_slope(n[c], x[c]) / half_width;
    }
    return {t.x * t.y * t.z, {slope.x * t.y * t.z, t.x * slope.y * t.z, t.x * t.y * slope.z}};
}

std::vector<glm::ivec3> terms(int degree) {
    std::vector<glm::ivec3> result;
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
            for (int c = 0; a + b + c <= degree; ++c) result.emplace_back(a, b, c);
    return result;
}

// Slopes are at most degree^2 / half_width.
double tolerance(int degree) { return 1e-12 * (1.0 + degree * degree / half_width); }

TEST(CubeLoops, MomentsSumTheTermsAtTheSamples) {
    for (const int degree : {0, 1, 2, 5, 20}) {
        const std::vector<glm::ivec3> list = terms(degree);
        for (const int count : {0, 1, 2, 3, 4, 7, 8, 9, 17}) {
            const auto size = static_cast<std::size_t>(count);
            const Points points = samples(count);
            const Numbers alpha = scattered(size, 1);
            const Numbers beta[3] = {scattered(size, 50), scattered(size, 150), scattered(size, 250)};
            const double* const at[3] = {beta[0].data(), beta[1].data(), beta[2].data()};
            Numbers expected(list.size());
            for (std::size_t k = 0; k < list.size(); ++k)
                for (std::size_t j = 0; j < size; ++j) {
                    const Term t = term(list[k], points[j]);
                    expected[k] += alpha[j] * t.value + glm::dot({beta[0][j], beta[1][j], beta[2][j]}, t.gradient);
                }
            for (const base::InstructionSet set : instruction_sets()) {
                base::Memory memory;
                base::Array<double> sums(memory, static_cast<std::int64_t>(list.size()) * cube_lanes);
                Numbers found(list.size() + 1, 9.0);
                cube_loops(set).moments(degree, in_cube(points), alpha.data(), at, sums.data(), found.data());
                for (std::size_t k = 0; k < list.size(); ++k)
                    EXPECT_NEAR(found[k], expected[k], count * tolerance(degree))
                        << base::name(set) << " " << degree << " " << count << " " << k;
                EXPECT_EQ(found.back(), 9.0);
            }
        }
    }
}

TEST(CubeLoops, EvaluateAddsThePolynomialAndItsGradient) {
    for (const int degree : {0, 1, 2, 5, 20}) {
        const std::vector<glm::ivec3> list = terms(degree);
        const Numbers coefficients = scattered(list.size(), 33);
        for (const int count : {0, 1, 2, 3, 4, 7, 8, 9, 17}) {
            const auto size = static_cast<std::size_t>(count);
            const Points points = samples(count);
            std::vector<Term> expected(size);
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t k = 0; k < list.size(); ++k) {
                    const Term t = term(list[k], points[i]);
                    expected[i].value += coefficients[k] * t.value;
                    expected[i].gradient += coefficients[k] * t.gradient;
                }
            for (const base::InstructionSet set : instruction_sets()) {
                Numbers field[4];
                for (Numbers& component : field) component.assign(size + 1, 0.5);
                double* const gradient[3] = {field[1].data(), field[2].data(), field[3].data()};
                cube_loops(set).evaluate(degree, coefficients.data(), in_cube(points), field[0].data(), gradient);
                const std::string what = std::string(base::name(set)) + " " + std::to_string(degree);
                const double enough = static_cast<double>(list.size()) * tolerance(degree);
                for (std::size_t i = 0; i < size; ++i) {
                    EXPECT_NEAR(field[0][i], 0.5 + expected[i].value, enough) << what;
                    for (std::size_t c = 0; c < 3; ++c)
                        EXPECT_NEAR(field[1 + c][i], 0.5 + expected[i].gradient[static_cast<int>(c)], enough) << what;
                }
                for (const Numbers& component : field) EXPECT_EQ(component.back(), 0.5) << what;
            }
        }
    }
}

// Compares with central differences of the gradient.
TEST(CubeLoops, HessianIsTheGradientsDerivative) {
    const int degree = 7;
    const std::vector<glm::ivec3> list = terms(degree);
    const Numbers coefficients = scattered(list.size(), 33);
    const int count = 11;
    const Points points = samples(count);
    constexpr double step = 1e-5;
    for (const base::InstructionSet set : instruction_sets()) {
        Numbers found[6];
        double* to[6];
        for (std::size_t c = 0; c < 6; ++c) {
            found[c].assign(count + 1, 0.5);
            to[c] = found[c].data();
        }
        cube_loops(set).hessian(degree, coefficients.data(), in_cube(points), to);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Numbers gradient[2][3];
            for (int side = 0; side < 2; ++side) {
                Points moved;
                for (std::size_t i = 0; i < points.size(); ++i) {
                    glm::dvec3 p = points[i];
                    p[static_cast<int>(axis)] += side == 0 ? -step : step;
                    moved.add(p);
                }
                Numbers value(count);
                for (Numbers& component : gradient[side]) component.assign(count, 0.0);
                double* const out[3] = {gradient[side][0].data(), gradient[side][1].data(), gradient[side][2].data()};
                cube_loops(set).evaluate(degree, coefficients.data(), in_cube(moved), value.data(), out);
            }
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const double slope = (gradient[1][c][i] - gradient[0][c][i]) / (2.0 * step);
                    EXPECT_NEAR(found[test::hessian_index[axis][c]][i], 0.5 + slope, 1e-3 + 1e-4 * std::abs(slope))
                        << base::name(set) << " " << axis << c;
                }
        }
        for (const Numbers& component : found) EXPECT_EQ(component.back(), 0.5);
    }
}

} // namespace

} // namespace cube_loops_test
