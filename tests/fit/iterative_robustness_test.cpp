// SPDX-License-Identifier: MIT
// Errors, cancelling and threads of the iterative solver.
#include "base/status.h"
#include "shapes.h"
#include "support/runtime.h"
#include "support/watched_operation.h"

#include <gtest/gtest.h>

#include <string>

namespace iterative_robustness_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::kernel::Kind;
using namespace fit_test;
using hrbfnpr::test::same_bits;
using hrbfnpr::test::with_threads;

namespace {

fit::FitInput iterative(const Cloud& cloud, Kind kind = Kind::triharmonic, std::int32_t degree = 1) {
    fit::FitInput result = input(cloud, kind, degree);
    result.solver = fit::SolverKind::iterative;
    if (kind == Kind::gaussian) result.kernel_radius = 0.1;
    if (kind == Kind::wendland_c2) result.kernel_radius = 0.5;
    return result;
}

void expect_error(const fit::FitInput& chosen, Status status, const std::string& part) {
    const base::Runtime runtime;
    try {
        static_cast<void>(fit::fit(runtime, chosen, {}));
        ADD_FAILURE() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), status) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(runtime.memory.bytes_now(), 0);
}

TEST(IterativeErrors, TheTriharmonicKernelNeedsALinearPolynomial) {
    const Cloud cloud = bumpy(250);
    for (const std::int32_t degree : {-1, 0})
        expect_error(iterative(cloud, Kind::triharmonic, degree), Status::invalid_argument, "polynomial_degree >= 1");
}

TEST(IterativeErrors, SamplesThatDoNotDetermineThePolynomialAreNamed) {
    expect_error(iterative(bumpy(4), Kind::triharmonic, 3), Status::invalid_argument, "lower polynomial_degree");
}

TEST(IterativeErrors, WithoutConvergenceTheResidualIsNamed) {
    const Cloud cloud = bumpy(400);
    fit::FitInput chosen = iterative(cloud);
    chosen.iteration_limit = 2;
    expect_error(chosen, Status::not_converged, "relative residual of ");
    expect_error(chosen, Status::not_converged, " in 2 iterations, not 1.0e-10");
}

TEST(IterativeErrors, AsManyNeighboursAsThereMayBe) {
    const Cloud cloud = bumpy(250);
    fit::FitInput chosen = iterative(cloud);
    const base::Runtime runtime;
    chosen.preconditioner_neighbours = 48;
    EXPECT_LE(fit::fit(runtime, chosen, {}).report.gradient_residual_max, 1e-6);
    chosen.preconditioner_neighbours = 49;
    expect_error(chosen, Status::invalid_argument, "preconditioner_neighbours is 49");
}

void expect_same_bits(const fit::FitResult& a, const fit::FitResult& b, const std::string& what) {
    EXPECT_TRUE(same_bits(a.data.alpha, b.data.alpha)) << what;
    EXPECT_TRUE(same_bits(a.data.beta.x, b.data.beta.x)) << what;
    EXPECT_TRUE(same_bits(a.data.beta.y, b.data.beta.y)) << what;
    EXPECT_TRUE(same_bits(a.data.beta.z, b.data.beta.z)) << what;
    EXPECT_TRUE(same_bits(a.data.polynomial, b.data.polynomial)) << what;
    EXPECT_EQ(a.report.iterations, b.report.iterations) << what;
    EXPECT_EQ(a.report.condition_estimate, b.report.condition_estimate) << what;
    EXPECT_EQ(a.report.solver_residual, b.report.solver_residual) << what;
    EXPECT_EQ(a.report.gradient_residual_rms, b.report.gradient_residual_rms) << what;
}

void expect_same_bits_for_threads(const fit::FitInput& chosen, std::initializer_list<int> counts) {
    const base::Runtime serial = with_threads(1);
    const fit::FitResult expected = fit::fit(serial, chosen, {});
    for (const int threads : counts) {
        const base::Runtime runtime = with_threads(threads);
        expect_same_bits(expected, fit::fit(runtime, chosen, {}),
                         hrbfnpr::kernel::name(chosen.kernel) + std::to_string(threads));
    }
}

// Vectors of more than one piece.
TEST(IterativeRobustness, SameBitsForManySamples) {
    const Cloud cloud = bumpy(4500);
    fit::FitInput chosen = iterative(cloud);
    chosen.solver_tolerance = 0.1;
    chosen.preconditioner_neighbours = 8;
    expect_same_bits_for_threads(chosen, {3});
}

} // namespace

} // namespace iterative_robustness_test
