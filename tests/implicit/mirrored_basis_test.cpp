// SPDX-License-Identifier: MIT
#include "implicit/mirrored_basis.h"

#include "fields.h"
#include "implicit/cube_basis.h"
#include "triharmonic_powers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrored_basis_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using implicit::CubeBasis;
using implicit::MirroredBasis;
using test::scatter;

namespace {

glm::dvec3 node(const MirroredBasis& basis, std::int64_t i) {
    const std::int64_t sign = i / basis.groups();
    const glm::dvec3 p = basis.nodes()[i % basis.groups()];
    return {(sign & 1) != 0 ? -p.x : p.x, (sign & 2) != 0 ? -p.y : p.y, (sign & 4) != 0 ? -p.z : p.z};
}

// Returns the terms, up to the degree `order`, of the polynomial that is fitted to f.
template <class F>
std::vector<double> fitted(const base::Runtime& runtime, const MirroredBasis& basis, int order, F&& f) {
    std::vector<double> values;
    for (std::int64_t i = 0; i < basis.size(); ++i) values.push_back(f(node(basis, i)));
    std::vector<double> terms(static_cast<std::size_t>(CubeBasis::terms(order)));
    MirroredBasis::Batch batch(const_cast<base::Memory&>(runtime.memory), basis, order);
    batch.add(values.data(), 1.0, terms.data());
    batch.flush(implicit::cube_loops(runtime.instruction_set));
    return terms;
}

double value(const std::vector<double>& terms, int degree, const glm::dvec3& p) {
    std::vector<double> all(terms.size());
    CubeBasis::evaluate(degree, p, all.data());
    double sum = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) sum += terms[k] * all[k];
    return sum;
}

template <class F>
double largest_error(const base::Runtime& runtime, const MirroredBasis& basis, F&& f) {
    const std::vector<double> terms = fitted(runtime, basis, basis.degree(), f);
    double error = 0.0;
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 p(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2));
        error = std::max(error, std::abs(value(terms, basis.degree(), p) - f(p)));
    }
    return error;
}

TEST(MirroredBasis, FitsReproduceTriharmonicPolynomials) {
    const base::Runtime runtime;
    for (int degree = MirroredBasis::degree_min; degree <= MirroredBasis::degree_max; degree += 2) {
        const MirroredBasis basis(runtime, degree);
        test_triharmonic::expect_reproduced(degree, [&](const auto& f) { return largest_error(runtime, basis, f); });
    }
}

TEST(MirroredBasis, NodesAreDistinctAndHavePositiveCoordinates) {
    const base::Runtime runtime;
    for (int degree = MirroredBasis::degree_min; degree <= MirroredBasis::degree_max; degree += 2) {
        const MirroredBasis basis(runtime, degree);
        EXPECT_EQ(basis.groups() % 8, 0) << degree;
        EXPECT_GE(basis.size(), implicit::triharmonic_size(degree)) << degree;
        for (std::int64_t i = 0; i < basis.groups(); ++i) {
            const glm::dvec3 p = basis.nodes()[i];
            EXPECT_GT(std::min({p.x, p.y, p.z}), 0.05) << degree << " " << i;
            EXPECT_LE(std::max({p.x, p.y, p.z}), 1.0) << degree << " " << i;
            for (std::int64_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(p, basis.nodes()[j]), 1e-3) << degree;
        }
    }
}

// Two degrees divide the error by 20 at least, down to rounding.
TEST(MirroredBasis, ApproximatesFarSources) {
    const base::Runtime runtime;
    double before = 1.0;
    for (int degree = 5; degree <= 15; degree += 2) {
        const MirroredBasis basis(runtime, degree);
        double error = 0.0;
        for (const glm::dvec3& source : {glm::dvec3(5.0, 0.9, -0.7), glm::dvec3(-1.0, -5.1, 5.3)})
            error = std::max(error, largest_error(runtime, basis, [&](const glm::dvec3& p) {
                                 return std::pow(glm::distance(p, source), 3.0);
                             }));
        EXPECT_LT(error, before / 20.0) << degree;
        before = std::max(error, 2e-11);
    }
    EXPECT_LT(before, 1e-9);
}

TEST(MirroredBasis, HigherOrdersHaveTheSameTermsAndZeros) {
    const base::Runtime runtime;
    const MirroredBasis basis(runtime, 7);
    const auto f = [](const glm::dvec3& p) { return std::exp(p.x + 0.3 * p.y - 0.2 * p.z); };
    const std::vector<double> terms = fitted(runtime, basis, 7, f);
    const std::vector<double> more = fitted(runtime, basis, 9, f);
    std::size_t at = 0;
    std::size_t k = 0;
    for (int a = 0; a <= 9; ++a)
        for (int b = 0; a + b <= 9; ++b)
            for (int c = 0; a + b + c <= 9; ++c) EXPECT_EQ(more[at++], a + b + c <= 7 ? terms[k++] : 0.0);
}

TEST(MirroredBasis, ABatchKeepsFunctionsApart) {
    const base::Runtime runtime;
    const MirroredBasis basis(runtime, 5);
    base::Memory memory;
    MirroredBasis::Batch batch(memory, basis, 5);
    const auto f = [](const glm::dvec3& p, int v) { return p.x * p.y + v * p.z; };
    std::vector<std::vector<double>> terms(implicit::cube_batch, std::vector<double>(CubeBasis::terms(5)));
    for (int v = 0; v < implicit::cube_batch; ++v) {
        EXPECT_FALSE(batch.full());
        std::vector<double> values;
        for (std::int64_t i = 0; i < basis.size(); ++i) values.push_back(f(node(basis, i), v));
        batch.add(values.data(), 2.0, terms[static_cast<std::size_t>(v)].data());
    }
    EXPECT_TRUE(batch.full());
    batch.flush(implicit::cube_loops(base::choose_instruction_set(base::InstructionSet::automatic)));
    const glm::dvec3 p(0.3, -0.6, 0.8);
    for (int v = 0; v < implicit::cube_batch; ++v)
        EXPECT_NEAR(value(terms[static_cast<std::size_t>(v)], 5, p), 2.0 * f(p, v), 1e-12) << v;
}

} // namespace

} // namespace mirrored_basis_test
