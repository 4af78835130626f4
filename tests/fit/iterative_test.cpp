// SPDX-License-Identifier: MIT
// Tests the iterative solver through fit().
#include "base/status.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace iterative_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::kernel::Kind;
using namespace fit_test;

namespace {

const Kind kinds[] = {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2};

fit::FitInput solved_by(fit::SolverKind solver, const Cloud& cloud, Kind kind = Kind::triharmonic,
                        std::int32_t degree = 1) {
    fit::FitInput result = input(cloud, kind, degree);
    result.solver = solver;
    return result;
}

// The kernel radius, 0.9 or 3 spacings, as a caller would give it.
double radius(Kind kind, const Cloud& cloud) {
    const double spacing = fit::fit(base::Runtime(), input(cloud)).data.spacing;
    return kind == Kind::triharmonic ? 0.0 : (kind == Kind::gaussian ? 0.9 : 3.0) * spacing;
}

// Compares f and its gradient of two fits, off and on the surface.
void expect_same_function(const fit::FitResult& a, const fit::FitResult& b, const Cloud& cloud, double tolerance,
                          const std::string& what) {
    for (int i = 0; i < 60; ++i) {
        const std::int64_t near = 37 * i % cloud.count();
        const double off = 0.15 * std::sin(3.0 * i);
        const glm::dvec3 p =
            cloud.point(near) + off * cloud.normal(near) + 0.02 * glm::dvec3(std::sin(i), std::cos(i), 0);
        const Sampled one = at(a.data, p);
        const Sampled other = at(b.data, p);
        EXPECT_NEAR(one.value, other.value, tolerance) << what;
        EXPECT_NEAR(glm::distance(one.gradient, other.gradient), 0.0, tolerance) << what;
    }
}

void expect_the_direct_solution(fit::FitInput chosen, const Cloud& cloud, const std::string& what) {
    const base::Runtime runtime;
    chosen.solver = fit::SolverKind::direct;
    const fit::FitResult direct = fit::fit(runtime, chosen);
    chosen.solver = fit::SolverKind::iterative;
    const fit::FitResult iterative = fit::fit(runtime, chosen);
    EXPECT_EQ(direct.report.solver, fit::SolverKind::direct) << what;
    EXPECT_EQ(iterative.report.solver, fit::SolverKind::iterative) << what;
    EXPECT_EQ(iterative.report.solver_reason, fit::SolverReason::requested) << what;
    EXPECT_LE(iterative.report.solver_residual, 1.2e-10) << what;
    expect_same_function(direct, iterative, cloud, 1e-7, what);
}

TEST(Iterative, FindsTheDirectSolution) {
    const Cloud cloud = bumpy(160);
    for (const Kind kind : kinds) {
        for (const std::int32_t degree : {1, 2, 3}) {
            fit::FitInput chosen = input(cloud, kind, degree);
            chosen.kernel_radius = radius(kind, cloud);
            expect_the_direct_solution(chosen, cloud, hrbfnpr::kernel::name(kind) + std::to_string(degree));
        }
    }
}

TEST(Iterative, FindsTheDirectSolutionForKernelsWithoutPolynomial) {
    const Cloud cloud = bumpy(160);
    for (const Kind kind : {Kind::gaussian, Kind::wendland_c2}) {
        for (const std::int32_t degree : {-1, 0}) {
            fit::FitInput chosen = input(cloud, kind, degree);
            chosen.kernel_radius = radius(kind, cloud);
            expect_the_direct_solution(chosen, cloud, hrbfnpr::kernel::name(kind) + std::to_string(degree));
        }
    }
}

TEST(Iterative, FindsTheDirectSolutionWithRegularization) {
    const Cloud cloud = bumpy(160);
    for (const Kind kind : kinds) {
        for (const double regularization : {1e-5, 1e-2}) {
            fit::FitInput chosen = input(cloud, kind, 1);
            chosen.kernel_radius = radius(kind, cloud);
            chosen.regularization = regularization;
            expect_the_direct_solution(chosen, cloud, hrbfnpr::kernel::name(kind) + std::to_string(regularization));
        }
    }
}

TEST(Iterative, FindsTheDirectSolutionOfFewSamples) {
    for (const int count : {1, 2, 3, 33, 60}) {
        const Cloud cloud = bumpy(count);
        expect_the_direct_solution(input(cloud), cloud, std::to_string(count));
    }
}

TEST(Iterative, ReportsTheMisfitOfTheFinishedFunction) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(300);
    for (const double regularization : {0.0, 1e-3}) {
        fit::FitInput chosen = solved_by(fit::SolverKind::iterative, cloud);
        chosen.regularization = regularization;
        const fit::FitResult result = fit::fit(runtime, chosen);
        double value = 0.0;
        double gradient = 0.0;
        for (std::int64_t i = 0; i < cloud.count(); ++i) {
            const Sampled s = at(result.data, cloud.point(i));
            value = std::max(value, std::abs(s.value));
            gradient = std::max(gradient, glm::distance(s.gradient, cloud.normal(i)));
        }
        EXPECT_NEAR(result.report.value_residual_max, value, 1e-12);
        EXPECT_NEAR(result.report.gradient_residual_max, gradient, 1e-12);
    }
}

TEST(Iterative, NeedsFewIterations) {
    const base::Runtime runtime;
    const fit::FitReport report = fit::fit(runtime, solved_by(fit::SolverKind::iterative, bumpy(1500))).report;
    EXPECT_GE(report.iterations, 3);
    EXPECT_LE(report.iterations, 20);
    EXPECT_GE(report.condition_estimate, 1.0);
    EXPECT_LE(report.condition_estimate, 100.0);
    EXPECT_GE(report.seconds_total, report.seconds_precondition + report.seconds_solve);
    EXPECT_GT(report.peak_bytes, 0);
}

TEST(Iterative, NeedsFewerIterationsWithMoreNeighbours) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(800);
    fit::FitInput chosen = solved_by(fit::SolverKind::iterative, cloud);
    std::int32_t before = 1000;
    for (const std::uint32_t neighbours : {6U, 16U, 48U}) {
        chosen.preconditioner_neighbours = neighbours;
        const fit::FitReport report = fit::fit(runtime, chosen).report;
        EXPECT_LT(report.iterations, before) << neighbours;
        before = report.iterations;
    }
}

TEST(Iterative, EndsAtTheGivenTolerance) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(400);
    fit::FitInput chosen = solved_by(fit::SolverKind::iterative, cloud);
    std::int32_t before = 0;
    for (const double tolerance : {1e-2, 1e-5, 1e-10}) {
        chosen.solver_tolerance = tolerance;
        const fit::FitReport report = fit::fit(runtime, chosen).report;
        EXPECT_LE(report.solver_residual, 1.2 * tolerance);
        EXPECT_GT(report.iterations, before) << tolerance;
        before = report.iterations;
    }
}

// Two parallel sheets whose distance is less than a tenth of the sample spacing.
Cloud sheets(int side) {
    Cloud cloud;
    for (int i = 0; i < side * side; ++i) {
        const double x = (i % side + 0.3 * std::sin(1.3 * i)) / side;
        const double y = (i / side + 0.3 * std::cos(2.1 * i)) / side;
        cloud.add({x, y, 0.0}, {0, 0, -1});
        cloud.add({y, x, 0.01}, {0, 0, 1});
    }
    return cloud;
}

TEST(Iterative, ConvergesBetweenTwoSheets) {
    const base::Runtime runtime;
    const Cloud cloud = sheets(20);
    const fit::FitResult result = fit::fit(runtime, solved_by(fit::SolverKind::iterative, cloud));
    EXPECT_LE(result.report.iterations, 40);
    EXPECT_LT(at(result.data, {0.5, 0.5, 0.005}).value, 0.0);
    EXPECT_GT(at(result.data, {0.5, 0.5, 0.015}).value, 0.0);
    EXPECT_GT(at(result.data, {0.5, 0.5, -0.005}).value, 0.0);
}

TEST(Solver, AutomaticIsDirectForFewSamplesAndIterativeForMany) {
    const base::Runtime runtime;
    for (const Kind kind : kinds) {
        const fit::FitReport few = fit::fit(runtime, input(bumpy(80), kind, 1)).report;
        EXPECT_EQ(few.solver, fit::SolverKind::direct);
        EXPECT_EQ(few.solver_reason, fit::SolverReason::small);
    }
    const fit::FitReport many = fit::fit(runtime, input(bumpy(600))).report;
    EXPECT_EQ(many.solver, fit::SolverKind::iterative);
    EXPECT_EQ(many.solver_reason, fit::SolverReason::large);
    const fit::FitReport asked = fit::fit(runtime, solved_by(fit::SolverKind::direct, bumpy(300))).report;
    EXPECT_EQ(asked.solver, fit::SolverKind::direct);
    EXPECT_EQ(asked.solver_reason, fit::SolverReason::requested);
}

TEST(Solver, AutomaticIsDirectWhereTheSystemIsNotDefinite) {
    const base::Runtime runtime;
    const fit::FitReport report = fit::fit(runtime, input(bumpy(250), Kind::triharmonic, 0)).report;
    EXPECT_EQ(report.solver, fit::SolverKind::direct);
    EXPECT_EQ(report.solver_reason, fit::SolverReason::not_definite);
}

TEST(Solver, AutomaticFallsBackToTheDirectSolver) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(250);
    fit::FitInput chosen = input(cloud);
    chosen.iteration_limit = 2;
    const fit::FitReport report = fit::fit(runtime, chosen).report;
    EXPECT_EQ(report.solver, fit::SolverKind::direct);
    EXPECT_EQ(report.solver_reason, fit::SolverReason::not_converged);
    EXPECT_LE(report.solver_residual, 1e-10);
    EXPECT_LE(report.value_residual_max, 1e-10);
    EXPECT_LE(report.gradient_residual_max, 1e-10);
    EXPECT_GT(report.condition_estimate, 1e3); // condition number of the factored matrix
}

// The faces of a box with samples that crowd towards its edges: rounding stops the iterations before they reach the
// tolerance.
Cloud graded_box() {
    std::vector<double> place;
    for (double gap = 0.5; place.size() < 17; gap *= 0.6) {
        place.push_back(gap);
        if (gap < 0.5) place.push_back(1.0 - gap);
    }
    Cloud cloud;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (const double u : place)
                for (const double v : place) {
                    std::array<double, 3> point{};
                    std::array<double, 3> normal{};
                    point[static_cast<std::size_t>(axis)] = side > 0.0 ? 1.0 : 0.0;
                    point[static_cast<std::size_t>((axis + 1) % 3)] = u;
                    point[static_cast<std::size_t>((axis + 2) % 3)] = v;
                    normal[static_cast<std::size_t>(axis)] = side;
                    cloud.add({point[0], point[1], point[2]}, {normal[0], normal[1], normal[2]});
                }
    return cloud;
}

TEST(Solver, AutomaticKeepsAnAcceptableIterativeSolution) {
    const base::Runtime runtime;
    const Cloud cloud = graded_box();
    fit::FitInput chosen = input(cloud);
    const fit::FitReport automatic = fit::fit(runtime, chosen).report;
    chosen.solver = fit::SolverKind::iterative;
    const fit::FitReport asked = fit::fit(runtime, chosen).report;
    EXPECT_GT(asked.solver_residual, 1e-10) << "it tells nothing";
    EXPECT_EQ(automatic.solver, fit::SolverKind::iterative);
    EXPECT_EQ(automatic.solver_reason, fit::SolverReason::large);
    EXPECT_EQ(automatic.solver_residual, asked.solver_residual);
    EXPECT_LE(automatic.value_residual_max, 1e-9);
}

} // namespace

} // namespace iterative_test
