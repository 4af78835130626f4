// SPDX-License-Identifier: MIT
#include "fit/polynomial_space.h"

#include "base/status.h"
#include "dense.h"
#include "kernel/polynomial.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace polynomial_space_test {

namespace fit = hrbfnpr::fit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::base::Parallel;
using hrbfnpr::base::Runtime;
using hrbfnpr::geometry::VecArray;

namespace {

VecArray positions(const Runtime& runtime, int count) {
    const fit_test::Cloud cloud = fit_test::bumpy(count);
    VecArray result(runtime.memory);
    for (std::int64_t i = 0; i < cloud.count(); ++i)
        result.push_back(9.0 * cloud.point(i) + glm::dvec3(20.0, 0.0, -5.0));
    return result;
}

fit::HermiteSystem system_of(const VecArray& x, std::int32_t degree) {
    return {x, {kernel::Kind::triharmonic, 0.0, degree, 0.0, 0.0}};
}

Eigen::MatrixXd plain(const fit::HermiteSystem& system) {
    Eigen::MatrixXd p(system.rows(), system.terms());
    system.constraints(p.data());
    return p;
}

Eigen::VectorXd wave(Eigen::Index size) {
    Eigen::VectorXd x(size);
    for (Eigen::Index i = 0; i < size; ++i) x[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
    return x;
}

TEST(PolynomialSpace, TakeOutRemovesTheOrthogonalProjection) {
    const Runtime runtime;
    const VecArray x = positions(runtime, 60);
    for (std::int32_t degree = -1; degree <= 3; ++degree) {
        const fit::HermiteSystem system = system_of(x, degree);
        const fit::PolynomialSpace space(runtime, system);
        const Eigen::MatrixXd p = plain(system);
        EXPECT_EQ(space.terms(), p.cols());
        const Eigen::VectorXd before = wave(system.rows());
        Eigen::VectorXd after = before;
        space.make_orthogonal(after.data());
        // The result is orthogonal to the polynomials, and the difference is a polynomial.
        for (Eigen::Index k = 0; k < p.cols(); ++k)
            EXPECT_LT(std::abs(p.col(k).dot(after)), 1e-12 * p.col(k).norm() * before.norm()) << degree;
        const Eigen::VectorXd taken = before - after;
        if (p.cols() > 0) {
            const Eigen::MatrixXd unit = p * p.colwise().norm().cwiseInverse().asDiagonal();
            EXPECT_LT((fit_test::applied(unit, fit_test::least_squares(unit, taken)) - taken).norm(), 1e-10) << degree;
        } else {
            EXPECT_EQ(taken.norm(), 0.0);
        }
        Eigen::VectorXd again = after;
        space.make_orthogonal(again.data());
        EXPECT_LT((again - after).norm(), 1e-13 * before.norm()) << degree;
    }
}

TEST(PolynomialSpace, ExplainFindsThePolynomialAndLeavesNothing) {
    const Runtime runtime;
    const VecArray x = positions(runtime, 60);
    for (std::int32_t degree = 0; degree <= 3; ++degree) {
        const fit::HermiteSystem system = system_of(x, degree);
        const fit::PolynomialSpace space(runtime, system);
        const Eigen::MatrixXd p = plain(system);
        const Eigen::VectorXd c = wave(p.cols());
        Eigen::VectorXd values = fit_test::applied(p, c);
        const double size = values.norm();
        Eigen::VectorXd found = Eigen::VectorXd::Constant(p.cols(), 0.25); // subtract_best_polynomial() adds to this
        space.subtract_best_polynomial(values.data(), found.data());
        EXPECT_LT(values.norm(), 1e-12 * size) << degree;
        // The tolerance of a coefficient depends on the norm of its column.
        for (Eigen::Index k = 0; k < p.cols(); ++k)
            EXPECT_LT(std::abs(found[k] - 0.25 - c[k]) * p.col(k).norm(), 1e-9 * size) << degree << " " << k;
    }
}

TEST(PolynomialSpace, ExplainRemovesThePolynomialThatItFinds) {
    const Runtime runtime;
    const VecArray x = positions(runtime, 40);
    const fit::HermiteSystem system = system_of(x, 2);
    const fit::PolynomialSpace space(runtime, system);
    Eigen::VectorXd rest = wave(system.rows());
    Eigen::VectorXd projected = rest;
    Eigen::VectorXd c = Eigen::VectorXd::Zero(system.terms());
    space.subtract_best_polynomial(rest.data(), c.data());
    space.make_orthogonal(projected.data());
    EXPECT_LT((rest - projected).norm(), 1e-13);
    EXPECT_LT((rest + fit_test::applied(plain(system), c) - wave(system.rows())).norm(), 1e-10);
}

TEST(PolynomialSpace, EvaluatesAPolynomialAtOneSample) {
    const Runtime runtime;
    const VecArray x = positions(runtime, 60);
    for (std::int32_t degree = 0; degree <= 3; ++degree) {
        const fit::HermiteSystem system = system_of(x, degree);
        const fit::PolynomialSpace space(runtime, system);
        const Eigen::VectorXd c = wave(system.terms());
        const Eigen::VectorXd values = fit_test::applied(plain(system), c);
        for (std::int64_t sample = 0; sample < x.size(); sample += 7) {
            const std::array<double, 4> at = space.at(sample, c.data());
            for (Eigen::Index i = 0; i < 4; ++i)
                EXPECT_NEAR(at[static_cast<std::size_t>(i)], values[4 * sample + i], 1e-12 * values.norm());
        }
    }
}

TEST(PolynomialSpace, NeedsSamplesThatDetermineThePolynomial) {
    const Runtime runtime;
    const VecArray few = positions(runtime, 4); // 16 conditions
    EXPECT_NO_THROW(fit::PolynomialSpace(runtime, system_of(few, 1)));
    VecArray coincident(runtime.memory);
    for (int i = 0; i < 40; ++i) coincident.push_back({1.0, 2.0, 3.0});
    using Case = std::pair<const VecArray*, std::int32_t>;
    for (const auto& [x, degree] : {Case(&few, 3), Case(&coincident, 2)}) {
        try {
            const fit::PolynomialSpace space(runtime, system_of(*x, degree));
            ADD_FAILURE() << "no error for degree " << degree;
        } catch (const hrbfnpr::Error& error) {
            EXPECT_EQ(error.status(), hrbfnpr::Status::invalid_argument);
            EXPECT_NE(std::string(error.what()).find("lower polynomial_degree"), std::string::npos) << error.what();
        }
    }
}

} // namespace

} // namespace polynomial_space_test
