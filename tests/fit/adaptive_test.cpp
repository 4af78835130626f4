// SPDX-License-Identifier: MIT
#include "fit/adaptive.h"

#include "base/status.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace adaptive_test {

namespace {

using namespace hrbfnpr;
using namespace fit_test;

// Adds every second sample in the first round, and the others in the second round.
struct Halves {
    explicit Halves(const base::Runtime& runtime) : samples(runtime.memory) {}

    fit::AdaptiveFit run(const base::Runtime& runtime, const fit::FitInput& call, double residual_of_rounds) {
        base::Array<std::int64_t> first(runtime.memory);
        for (std::int64_t i = 0; i < samples.position.size(); i += 2) first.push_back(i);
        const auto look = [&](const fit::AdaptiveFit& now) {
            fit::NextCentres next(runtime.memory, {});
            residuals.push_back(now.fit.result.report.solver_residual);
            for (std::int64_t i = 1; i < samples.position.size() && now.rounds == 1; i += 2) next.centres.push_back(i);
            next.continues = now.rounds == 1;
            return next;
        };
        return fit::fit_adaptively(runtime, call, samples, std::move(first), {}, {2, residual_of_rounds, false}, look);
    }

    fit::Samples samples;
    std::vector<double> residuals; // the relative residual of each round
};

TEST(AdaptiveFit, SolvesRoughlyInRoundsAndExactlyAtTheEnd) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(600);
    fit::FitInput call = input(cloud);
    call.automatic_tolerance = 1e-9;
    Halves exact(runtime);
    Halves rough(runtime);
    exact.samples = fit::read_samples(runtime, call.points, call.normals);
    rough.samples = fit::read_samples(runtime, call.points, call.normals);
    const fit::AdaptiveFit expected = exact.run(runtime, call, 0.0);
    const fit::AdaptiveFit found = rough.run(runtime, call, 1e-2);
    ASSERT_EQ(rough.residuals.size(), 2U);
    for (const double residual : rough.residuals) {
        EXPECT_GT(residual, 1e-6);
        EXPECT_LE(residual, 1e-2);
    }
    EXPECT_LE(found.fit.result.report.solver_residual, 1e-9);
    EXPECT_EQ(found.rounds, 2);
    ASSERT_EQ(found.fit.result.data.count(), 600);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 p = 1.1 * cloud.point(11 * i);
        const Sampled a = at(expected.fit.result.data, p);
        const Sampled b = at(found.fit.result.data, p);
        EXPECT_NEAR(a.value, b.value, 1e-7) << i;
        EXPECT_LE(glm::distance(a.gradient, b.gradient), 1e-6) << i;
    }
}

// A fit that starts at the weights of the same fit needs no iterations.
TEST(AdaptiveFit, StartsAtTheWeightsOfAnEarlierFit) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(600);
    fit::FitInput call = input(cloud);
    call.automatic_tolerance = 1e-6;
    const fit::Samples samples = fit::read_samples(runtime, call.points, call.normals);
    const fit::CentreFit cold = fit::fit_centres(runtime, call, samples, {});
    const fit::CentreFit warm = fit::fit_centres(runtime, call, samples, {}, {&cold.result.data, nullptr});
    EXPECT_GT(cold.result.report.iterations, 3);
    EXPECT_EQ(warm.result.report.iterations, 0);
    EXPECT_LE(warm.result.report.solver_residual, 1e-6);
}

} // namespace

} // namespace adaptive_test
