// SPDX-License-Identifier: MIT
// Tests errors, cancelling and threads of the iterative solver.
#include "base/status.h"
#include "shapes.h"
#include "support/runtime.h"

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
        static_cast<void>(fit::fit(runtime, chosen));
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
    expect_error(chosen, Status::not_converged, "a residual of ");
    expect_error(chosen, Status::not_converged, " in 2 iterations, not 1.0e-10");
}

TEST(IterativeErrors, TooManyNeighboursAreRefused) {
    const Cloud cloud = bumpy(250);
    fit::FitInput chosen = iterative(cloud);
    const base::Runtime runtime;
    chosen.preconditioner_neighbours = 48;
    EXPECT_LE(fit::fit(runtime, chosen).report.gradient_residual_max, 1e-6);
    chosen.preconditioner_neighbours = 49;
    expect_error(chosen, Status::invalid_argument, "preconditioner_neighbours is 49");
}

// The vectors have more than one chunk.
TEST(IterativeRobustness, AnyThreadCountGivesTheSameBits) {
    const Cloud cloud = bumpy(4500);
    fit::FitInput chosen = iterative(cloud);
    chosen.solver_tolerance = 0.1;
    chosen.preconditioner_neighbours = 8;
    const base::Runtime serial = with_threads(1), three = with_threads(3);
    const fit::FitResult expected = fit::fit(serial, chosen);
    const fit::FitResult found = fit::fit(three, chosen);
    EXPECT_TRUE(same_bits(found.data.alpha, expected.data.alpha));
    EXPECT_TRUE(same_bits(found.data.beta.x, expected.data.beta.x));
    EXPECT_TRUE(same_bits(found.data.beta.y, expected.data.beta.y));
    EXPECT_TRUE(same_bits(found.data.beta.z, expected.data.beta.z));
    EXPECT_EQ(found.report.solver_residual, expected.report.solver_residual);
}

} // namespace

} // namespace iterative_robustness_test
