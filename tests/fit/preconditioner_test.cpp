// SPDX-License-Identifier: MIT
#include "fit/preconditioner.h"

#include "base/status.h"
#include "dense.h"
#include "fit/local_factors.h"
#include "geometry/farthest_order.h"
#include "shapes.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <string>

namespace preconditioner_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
namespace geometry = hrbfnpr::geometry;
using hrbfnpr::geometry::VecArray;
using hrbfnpr::kernel::Kind;
using hrbfnpr::test::instruction_sets;

namespace {

const Kind kinds[] = {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2};

// The samples are about 1 apart.
VecArray positions(base::Memory& memory, int count) {
    const fit_test::Cloud cloud = fit_test::bumpy(count);
    VecArray result(memory);
    for (std::int64_t i = 0; i < cloud.count(); ++i) result.push_back(std::sqrt(count / 12.0) * cloud.point(i));
    return result;
}

fit::HermiteSystem::Options options(Kind kind, double diagonal) {
    return {kind, kind == Kind::gaussian ? 0.7 : 4.0, kind == Kind::triharmonic ? 1 : -1, 2.0 * diagonal, diagonal};
}

Eigen::MatrixXd plain(const fit::HermiteSystem& system) {
    Eigen::MatrixXd a(system.rows(), system.rows());
    system.block(0, system.samples(), 0, system.samples(), a.data(), a.rows());
    return a;
}

// A basis of functionals: the four of each sample minus their Taylor expansions about the first sample.
Eigen::MatrixXd orthogonal_to_linear(const VecArray& x) {
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(4 * x.size(), 4 * (x.size() - 1));
    for (Eigen::Index k = 1; k < x.size(); ++k) {
        const glm::dvec3 d = x[k] - x[0];
        z.block<4, 4>(4 * k, 4 * (k - 1)).setIdentity();
        z.block<4, 4>(0, 4 * (k - 1)) = -Eigen::Matrix4d::Identity();
        z.block<3, 1>(1, 4 * (k - 1)) = -Eigen::Vector3d(d.x, d.y, d.z);
    }
    return z;
}

// The last four columns of Z C^-T with C C^T = Z^T A Z.
Eigen::MatrixXd plain_factor(const VecArray& x, const fit::HermiteSystem::Options& o) {
    const Eigen::MatrixXd a = plain(fit::HermiteSystem(x, o));
    const Eigen::MatrixXd z =
        o.kernel == Kind::triharmonic ? orthogonal_to_linear(x) : Eigen::MatrixXd::Identity(a.rows(), a.rows());
    const Eigen::MatrixXd beside = fit_test::product(z.transpose(), fit_test::product(a, z));
    return fit_test::product(z, fit_test::inverse_of_upper_cholesky(beside)).rightCols(4);
}

Eigen::MatrixXd found_factor(const std::vector<float>& factor, std::size_t at, Eigen::Index rows) {
    using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(factor.data() + at, rows, 4).cast<double>();
}

// Sets of neighbouring samples.
std::vector<VecArray> sets(base::Memory& memory, std::int64_t set_size, std::int64_t count) {
    const VecArray all = positions(memory, 90);
    std::vector<VecArray> result;
    for (std::int64_t k = 0; k < count; ++k) {
        VecArray set(memory);
        for (std::int64_t m = 0; m < set_size; ++m) set.push_back(all[(7 * k + m) % all.size()]);
        result.push_back(std::move(set));
    }
    return result;
}

std::vector<float> factor_with(base::InstructionSet set, const std::vector<VecArray>& sets,
                               const fit::HermiteSystem::Options& o) {
    const auto set_size = static_cast<std::int32_t>(sets[0].size());
    const fit::LocalSystems systems{o.kernel,
                                    o.radius,
                                    o.value_diagonal,
                                    o.gradient_diagonal,
                                    o.kernel == Kind::triharmonic,
                                    set_size,
                                    static_cast<std::int64_t>(sets.size())};
    base::Memory memory;
    base::Array<double> position(memory);
    for (const VecArray& x : sets)
        for (std::int64_t m = 0; m < set_size; ++m)
            for (int c = 0; c < 3; ++c) position.push_back(x[m][c]);
    base::Array<double> room(memory, fit::local_factor_scratch_size(set, set_size));
    std::vector<float> factor(sets.size() * static_cast<std::size_t>(16 * set_size));
    fit::local_factors(set)(systems, position.data(), room.data(), factor.data());
    return factor;
}

TEST(LocalFactors, AreTheLastColumnsOfTheDenseFactor) {
    base::Memory memory;
    for (const Kind kind : kinds) {
        for (const double diagonal : {0.0, 0.1}) {
            for (const std::int64_t set_size : {2, 3, 17, 49}) {
                const std::vector<VecArray> all = sets(memory, set_size, 11);
                for (const base::InstructionSet set : instruction_sets()) {
                    const std::vector<float> factor = factor_with(set, all, options(kind, diagonal));
                    for (std::size_t k = 0; k < all.size(); ++k) {
                        const Eigen::MatrixXd expected = plain_factor(all[k], options(kind, diagonal));
                        const Eigen::MatrixXd found =
                            found_factor(factor, k * static_cast<std::size_t>(16 * set_size), 4 * set_size);
                        EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm())
                            << base::name(set) << " " << hrbfnpr::kernel::name(kind) << " " << set_size << " " << k;
                    }
                }
            }
        }
    }
}

TEST(LocalFactors, DoNotDependOnTheirNeighboursInTheBatch) {
    base::Memory memory;
    const std::vector<VecArray> all = sets(memory, 9, 19);
    for (const base::InstructionSet set : instruction_sets()) {
        EXPECT_GE(fit::local_factor_batch(set), 1);
        const std::vector<float> together = factor_with(set, all, options(Kind::triharmonic, 0.0));
        for (std::int64_t count = 1; count < 19; ++count) {
            const std::vector<float> factor = factor_with(set, sets(memory, 9, count), options(Kind::triharmonic, 0.0));
            EXPECT_TRUE(std::equal(factor.begin(), factor.end(), together.begin())) << base::name(set) << count;
        }
    }
}

// A sample that occurs twice makes a pivot 0.
TEST(LocalFactors, StayFiniteWhereSamplesAreDependent) {
    base::Memory memory;
    std::vector<VecArray> all = sets(memory, 6, 5);
    for (VecArray& x : all) x.set(4, x[2]);
    for (const Kind kind : kinds)
        for (const base::InstructionSet set : instruction_sets())
            for (const float x : factor_with(set, all, options(kind, 0.0))) ASSERT_TRUE(std::isfinite(x));
}

struct Arranged {
    explicit Arranged(const VecArray& x) : tree(x, {}), rank(x.memory(), x.size()) {
        const geometry::FarthestOrder order = geometry::farthest_order(tree.points(), 0, {});
        for (std::int64_t k = 0; k < x.size(); ++k) rank[order.order[k]] = k;
    }
    geometry::PointTree tree;
    base::Array<std::int64_t> rank;
};

Eigen::VectorXd wave(Eigen::Index size) {
    Eigen::VectorXd x(size);
    for (Eigen::Index i = 0; i < size; ++i) x[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
    return x;
}

// |L L^T A w - w| / |w|. If A is definite only beside the linear polynomials, w is orthogonal to these.
double inverse_error(const base::Runtime& runtime, const VecArray& x, const fit::HermiteSystem::Options& o,
                     std::int32_t neighbours) {
    const Arranged arranged(x);
    const fit::HermiteSystem system(arranged.tree.points(), o);
    fit::Preconditioner preconditioner(runtime, system, arranged.tree, arranged.rank, neighbours);
    Eigen::VectorXd w = wave(system.rows());
    if (o.kernel == Kind::triharmonic) {
        Eigen::MatrixXd p(system.rows(), system.terms());
        system.constraints(p.data());
        w -= fit_test::applied(p, fit_test::least_squares(p, w));
    }
    const Eigen::VectorXd aw = fit_test::applied(plain(system), w);
    Eigen::VectorXd found(system.rows());
    preconditioner.apply(aw.data(), found.data());
    return (found - w).norm() / w.norm();
}

TEST(Preconditioner, IsTheInverseOfFewSamples) {
    const base::Runtime runtime;
    for (const Kind kind : kinds)
        for (const int count : {2, 5, 32})
            for (const double diagonal : {0.0, 0.1})
                EXPECT_LT(inverse_error(runtime, positions(runtime.memory, count), options(kind, diagonal), 16), 1e-9)
                    << hrbfnpr::kernel::name(kind) << count;
}

TEST(Preconditioner, IsTheInverseIfAllSamplesAreNeighbours) {
    base::Runtime runtime;
    for (const base::InstructionSet set : instruction_sets()) {
        runtime.instruction_set = set;
        for (const Kind kind : kinds)
            for (const int count : {33, 40, 49})
                for (const double diagonal : {0.0, 0.1}) // the last sample's factor consists of floats
                    EXPECT_LT(
                        inverse_error(runtime, positions(runtime.memory, count), options(kind, diagonal), count - 1),
                        1e-4)
                        << base::name(set) << " " << hrbfnpr::kernel::name(kind) << count;
    }
}

TEST(Preconditioner, ImprovesWithMoreNeighbours) {
    const base::Runtime runtime;
    const VecArray x = positions(runtime.memory, 300);
    double before = 10.0;
    for (const std::int32_t neighbours : {4, 12, 48}) {
        const double now = inverse_error(runtime, x, options(Kind::triharmonic, 0.0), neighbours);
        EXPECT_LT(now, before) << neighbours;
        before = now;
    }
}

Eigen::VectorXd applied(const base::Runtime& runtime, const Arranged& arranged, const fit::HermiteSystem::Options& o) {
    const fit::HermiteSystem system(arranged.tree.points(), o);
    fit::Preconditioner preconditioner(runtime, system, arranged.tree, arranged.rank, 16);
    Eigen::VectorXd z(system.rows());
    preconditioner.apply(wave(system.rows()).data(), z.data());
    return z;
}

TEST(Preconditioner, IsTheSameForAllInstructionSetsAndThreads) {
    base::Runtime runtime;
    const Arranged arranged(positions(runtime.memory, 600));
    for (const Kind kind : kinds) {
        runtime.parallel = base::Parallel(1, nullptr, nullptr);
        runtime.instruction_set = base::InstructionSet::baseline;
        const Eigen::VectorXd baseline = applied(runtime, arranged, options(kind, 0.0));
        for (const base::InstructionSet set : instruction_sets()) {
            runtime.parallel = base::Parallel(1, nullptr, nullptr);
            runtime.instruction_set = set;
            const Eigen::VectorXd serial = applied(runtime, arranged, options(kind, 0.0));
            EXPECT_LT((serial - baseline).norm(), 1e-6 * baseline.norm()) << base::name(set);
            for (const int threads : {2, 3, 7}) {
                runtime.parallel = base::Parallel(threads, nullptr, nullptr);
                EXPECT_EQ(applied(runtime, arranged, options(kind, 0.0)), serial) << base::name(set) << threads;
            }
        }
    }
}

TEST(Preconditioner, RefusesAnIndefiniteSystem) {
    const base::Runtime runtime;
    const Arranged arranged(positions(runtime.memory, 80));
    fit::HermiteSystem::Options flat = options(Kind::gaussian, 0.0);
    flat.radius = 1e6;
    try {
        static_cast<void>(applied(runtime, arranged, flat));
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), hrbfnpr::Status::singular_system);
    }
}

} // namespace

} // namespace preconditioner_test
