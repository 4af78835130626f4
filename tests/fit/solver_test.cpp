// SPDX-License-Identifier: MIT
#include "shapes.h"

#include "base/status.h"
#include "dense.h"
#include "fit/cholesky.h"
#include "fit/condition.h"
#include "fit/lu.h"
#include "fit/null_space.h"
#include "fit/null_space_solver.h"
#include "fit/system.h"
#include "kernel/polynomial.h"

#include <gtest/gtest.h>

namespace solver_test {

namespace fit = hrbfnpr::fit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::base::Array;
using hrbfnpr::base::Memory;
using hrbfnpr::base::Runtime;
using hrbfnpr::geometry::VecArray;
using kernel::Kind;
using namespace fit_test;

namespace {

const Kind kinds[] = {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2};

VecArray positions(Memory& memory, const Cloud& cloud) {
    VecArray result(memory);
    for (std::int64_t i = 0; i < cloud.count(); ++i) result.push_back(4.0 * cloud.point(i));
    return result;
}

fit::HermiteSystem::Options options(Kind kind, std::int32_t degree) {
    return {kind, kind == Kind::gaussian ? 0.8 : 6.0, degree, 0.25, 0.125};
}

// The whole system of section 4.1, entry by entry.
Eigen::MatrixXd plain_system(const VecArray& x, const fit::HermiteSystem::Options& o) {
    const Eigen::Index n = x.size();
    const Eigen::Index m = kernel::polynomial_size(o.degree);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(4 * n + m, 4 * n + m);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const glm::dvec3 g = x[i] - x[j];
            const Eigen::Vector3d d(g.x, g.y, g.z);
            const kernel::Radial r = kernel::radial(o.kernel, o.radius, d.norm());
            k(4 * i, 4 * j) = r.phi;
            k.block<3, 1>(4 * i + 1, 4 * j) = r.a * d;
            k.block<1, 3>(4 * i, 4 * j + 1) = -r.a * d.transpose();
            k.block<3, 3>(4 * i + 1, 4 * j + 1) = -(r.a * Eigen::Matrix3d::Identity() + r.b * d * d.transpose());
        }
        k(4 * i, 4 * i) += o.value_diagonal;
        for (int c = 1; c <= 3; ++c) k(4 * i + c, 4 * i + c) += o.gradient_diagonal;
        kernel::PolynomialBasis basis;
        kernel::polynomial_basis(o.degree, x[i], basis);
        for (Eigen::Index t = 0; t < m; ++t) {
            k(4 * i, 4 * n + t) = k(4 * n + t, 4 * i) = basis.value[static_cast<std::size_t>(t)];
            for (int c = 0; c < 3; ++c)
                k(4 * i + 1 + c, 4 * n + t) = k(4 * n + t, 4 * i + 1 + c) =
                    basis.gradient[static_cast<std::size_t>(t)][c];
        }
    }
    return k;
}

Eigen::VectorXd right_hand_side(Eigen::Index size) {
    Eigen::VectorXd rhs(size);
    for (Eigen::Index i = 0; i < size; ++i) rhs[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
    return rhs;
}

TEST(HermiteSystem, BlocksAndProductsMatchThePlainMatrix) {
    const Runtime runtime;
    const VecArray x = positions(runtime.memory, bumpy(37));
    for (const Kind kind : kinds) {
        const fit::HermiteSystem system(x, options(kind, 2));
        const Eigen::MatrixXd plain = plain_system(x, options(kind, 2));
        ASSERT_EQ(system.unknowns(), plain.rows());
        const Eigen::Index rows = system.rows();
        EXPECT_LT((plain - plain.transpose()).norm(), 1e-12 * plain.norm());

        Eigen::MatrixXd block(4 * 9, 4 * 5);
        system.block(11, 20, 8, 13, block.data(), block.rows());
        EXPECT_LT((block - plain.block(44, 32, 36, 20)).norm(), 1e-12 * plain.norm());

        const Eigen::MatrixXd in = Eigen::MatrixXd::Random(rows, 3);
        Eigen::MatrixXd out(rows, 3);
        system.multiply(runtime.parallel, in.data(), 3, out.data(), {});
        EXPECT_LT((out - fit_test::product(plain.topLeftCorner(rows, rows), in)).norm(), 1e-11 * plain.norm());
        Eigen::VectorXd one(rows);
        system.multiply(runtime.parallel, in.data(), 1, one.data(), {});
        EXPECT_LT((one - out.col(0)).norm(), 1e-12 * plain.norm());

        Eigen::MatrixXd p(rows, system.terms());
        system.constraints(p.data());
        EXPECT_EQ(p, plain.topRightCorner(rows, system.terms()));
    }
}

TEST(NullSpace, IsOrthogonalAndRemovesTheConstraints) {
    const Runtime runtime;
    const VecArray x = positions(runtime.memory, bumpy(23));
    for (std::int32_t degree = -1; degree <= 3; ++degree) {
        const fit::HermiteSystem system(x, options(Kind::triharmonic, degree));
        const fit::NullSpace space(runtime.memory, system);
        const Eigen::Index n = system.rows();
        const Eigen::Index m = system.terms();
        Eigen::MatrixXd q = Eigen::MatrixXd::Identity(n, n);
        Eigen::MatrixXd qt = Eigen::MatrixXd::Identity(n, n);
        for (Eigen::Index c = 0; c < n; ++c) {
            space.apply(q.col(c).data());
            space.apply_transposed(qt.col(c).data());
        }
        EXPECT_LT((q.transpose() - qt).norm(), 1e-12) << degree;
        EXPECT_LT((fit_test::product(q.transpose(), q) - Eigen::MatrixXd::Identity(n, n)).norm(), 1e-12) << degree;
        Eigen::MatrixXd p(n, m);
        system.constraints(p.data());
        const Eigen::MatrixXd reduced = fit_test::product(q.transpose(), p);
        EXPECT_LT(reduced.topRows(n - m).norm(), 1e-12 * (1.0 + p.norm())) << degree;
        for (Eigen::Index k = 0; k < m; ++k)
            EXPECT_LT((reduced.row(n - 1 - k) - space.r().row(k)).norm(), 1e-12 * p.norm()) << degree;
    }
}

TEST(NullSpaceSolver, EqualsAPlainLuOfTheWholeSystem) {
    const Runtime runtime;
    for (const int count : {1, 2, 7, 33, 65, 90}) { // one tile is 32 samples
        const VecArray x = positions(runtime.memory, bumpy(count));
        for (const Kind kind : kinds) {
            for (const std::int32_t degree : {-1, 0, 1, 2, 3}) {
                if (4 * count < 2 * kernel::polynomial_size(degree)) continue;
                if (kind == Kind::triharmonic && degree < 1) continue;
                const fit::HermiteSystem system(x, options(kind, degree));
                const Eigen::MatrixXd plain = plain_system(x, options(kind, degree));
                const Eigen::VectorXd rhs = right_hand_side(plain.rows());
                const Eigen::VectorXd expected = fit_test::solved(plain, rhs);
                fit::NullSpaceSolver solver(runtime, system);
                ASSERT_TRUE(solver.factor({})) << count << " " << kernel::name(kind) << degree;
                Eigen::VectorXd found = rhs;
                solver.solve(found.data(), {});
                EXPECT_LT((found - expected).norm(), 1e-8 * expected.norm())
                    << count << " " << kernel::name(kind) << degree;
            }
        }
    }
}

TEST(NullSpaceSolver, DetectsAnIndefiniteSystem) {
    const Runtime runtime;
    const VecArray x = positions(runtime.memory, bumpy(40));
    fit::HermiteSystem::Options o = options(Kind::triharmonic, -1);
    o.value_diagonal = o.gradient_diagonal = 0.0;
    const fit::HermiteSystem system(x, o);
    fit::NullSpaceSolver solver(runtime, system);
    EXPECT_FALSE(solver.factor({}));
    o = options(Kind::gaussian, 0);
    o.value_diagonal = std::numeric_limits<double>::quiet_NaN();
    const fit::HermiteSystem broken(x, o);
    fit::NullSpaceSolver other(runtime, broken);
    EXPECT_FALSE(other.factor({}));
}

TEST(DenseLu, EqualsAPlainLu) {
    const Runtime runtime;
    for (const int count : {1, 2, 20, 50}) {
        const VecArray x = positions(runtime.memory, bumpy(count));
        for (const std::int32_t degree : {-1, 0, 1}) {
            const fit::HermiteSystem system(x, options(Kind::triharmonic, degree));
            const Eigen::MatrixXd plain = plain_system(x, options(Kind::triharmonic, degree));
            const Eigen::VectorXd rhs = right_hand_side(plain.rows());
            const Eigen::VectorXd expected = fit_test::solved(plain, rhs);
            const fit::DenseLu lu(runtime, system);
            Eigen::VectorXd found = rhs;
            lu.solve(found.data(), {});
            EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm()) << count << " " << degree;
            const double condition = plain.cwiseAbs().colwise().sum().maxCoeff() *
                                     fit_test::inverse(plain).cwiseAbs().colwise().sum().maxCoeff();
            EXPECT_LE(lu.condition({}), condition * (1.0 + 1e-6));
            EXPECT_GE(lu.condition({}), 0.3 * condition);
        }
    }
}

TEST(TiledCholesky, FactorsSolvesAndEstimatesTheInverseNorm) {
    const Runtime runtime;
    for (const Eigen::Index size : {1, 5, 128, 129, 300}) {
        const Eigen::MatrixXd half = Eigen::MatrixXd::Random(size, size);
        const Eigen::MatrixXd matrix =
            fit_test::product(half, half.transpose()) + 0.1 * Eigen::MatrixXd::Identity(size, size);
        constexpr Eigen::Index side = fit::TiledCholesky::side;
        fit::TiledCholesky tiled(runtime.memory, size);
        Eigen::MatrixXd padded = Eigen::MatrixXd::Identity(tiled.padded(), tiled.padded());
        padded.topLeftCorner(size, size) = matrix;
        for (std::int64_t t = 0; t < tiled.tile_count(); ++t) {
            const auto at = fit::TiledCholesky::position(t);
            Eigen::Map<Eigen::MatrixXd>(tiled.tile(at.i, at.j), side, side) =
                padded.block(at.i * side, at.j * side, side, side);
        }
        const double norm = matrix.cwiseAbs().colwise().sum().maxCoeff();
        EXPECT_NEAR(tiled.norm(runtime.parallel, {}), norm, 1e-12 * norm);
        ASSERT_TRUE(tiled.factor(runtime.parallel, {}));
        Eigen::VectorXd x = Eigen::VectorXd::Zero(tiled.padded());
        x.head(size) = right_hand_side(size);
        tiled.solve(runtime.parallel, x.data(), {});
        const Eigen::VectorXd expected = fit_test::solved(matrix, right_hand_side(size));
        EXPECT_LT((x.head(size) - expected).norm(), 1e-9 * expected.norm()) << size;
        EXPECT_EQ(x.tail(tiled.padded() - size).norm(), 0.0);

        const double inverse = fit_test::inverse(matrix).cwiseAbs().colwise().sum().maxCoeff();
        Eigen::VectorXd work = Eigen::VectorXd::Zero(tiled.padded());
        const double estimate =
            fit::inverse_norm(size, work.data(), [&](double* v) { tiled.solve(runtime.parallel, v, {}); });
        EXPECT_LE(estimate, inverse * (1.0 + 1e-9));
        EXPECT_GE(estimate, 0.3 * inverse);
    }
}

TEST(TiledCholesky, NumbersTilesRowByRow) {
    std::int64_t t = 0;
    for (std::int64_t i = 0; i < 200; ++i) {
        for (std::int64_t j = 0; j <= i; ++j, ++t) {
            const auto at = fit::TiledCholesky::position(t);
            ASSERT_TRUE(at.i == i && at.j == j) << t;
        }
    }
    const std::int64_t huge = (std::int64_t{1} << 47) + 12345;
    const auto at = fit::TiledCholesky::position(huge);
    EXPECT_EQ(at.i * (at.i + 1) / 2 + at.j, huge);
    EXPECT_LE(at.j, at.i);
    EXPECT_EQ(fit::TiledCholesky::bytes(std::int64_t{1} << 40), -1);
    EXPECT_EQ(fit::TiledCholesky::bytes(0), 0);
    EXPECT_EQ(fit::TiledCholesky::bytes(129), 3 * 128 * 128 * 8);
}

} // namespace

} // namespace solver_test
