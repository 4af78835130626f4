// SPDX-License-Identifier: MIT
// Tests the energy of given normals, by the sparse factor and by conjugate gradients.
#include "shapes.h"

#include "fit/fit_centres.h"
#include "fit/hermite_energy.h"
#include "fit/samples.h"
#include "geometry/farthest_order.h"

#include <gtest/gtest.h>

namespace hermite_energy_test {

namespace {

using namespace hrbfnpr;

struct Made {
    explicit Made(const fit_test::Cloud& cloud) : tree(points(cloud), base::Progress()), rank(runtime.memory) {
        const geometry::FarthestOrder order = geometry::farthest_order(tree.points(), 0, base::Progress());
        rank.resize(tree.size());
        for (std::int64_t k = 0; k < order.order.size(); ++k) rank[order.order[k]] = k;
    }
    // The points, scaled so that their spacing is 1.
    geometry::VecArray points(const fit_test::Cloud& cloud) {
        const auto samples = fit::read_samples(runtime, fit_test::view(cloud.points), fit_test::view(cloud.normals));
        geometry::VecArray position(runtime.memory);
        for (std::int64_t i = 0; i < cloud.count(); ++i) position.push_back(cloud.point(i) / samples.spacing);
        return position;
    }
    geometry::VecArray normals(const fit_test::Cloud& cloud) const {
        geometry::VecArray normal(runtime.memory);
        for (std::int64_t at = 0; at < tree.size(); ++at) normal.push_back(cloud.normal(tree.index(at)));
        return normal;
    }

    base::Runtime runtime;
    geometry::PointTree tree;
    base::Array<std::int64_t> rank;
};

TEST(HermiteEnergy, MatchesTheFitAndItsSparseEstimateIsNear) {
    const fit_test::Cloud cloud = fit_test::torus(600);
    Made made(cloud);
    fit::HermiteEnergy energy(made.runtime, made.tree, made.rank, {});
    const geometry::VecArray normal = made.normals(cloud);
    geometry::VecArray beta(made.runtime.memory, made.tree.size());
    const double solved = energy.accurate_energy(normal, beta, 1e-8, base::Progress());
    const double sparse = energy.approximate_energy(normal, beta);

    const auto fitted = fit::fit(made.runtime, fit_test::input(cloud));
    double exact = 0.0;
    for (std::int64_t i = 0; i < cloud.count(); ++i) exact += glm::dot(cloud.normal(i), fitted.data.beta[i]);
    EXPECT_NEAR(solved, exact, 1e-4 * exact);
    EXPECT_NEAR(sparse, exact, 0.3 * exact);
}

TEST(HermiteEnergy, DerivativesMatchDifferences) {
    const fit_test::Cloud cloud = fit_test::bumpy(300);
    Made made(cloud);
    fit::HermiteEnergy energy(made.runtime, made.tree, made.rank, {2.0, 16});
    geometry::VecArray normal = made.normals(cloud);
    geometry::VecArray beta(made.runtime.memory, made.tree.size());
    geometry::VecArray rest(made.runtime.memory, made.tree.size());
    (void)energy.approximate_energy(normal, beta);
    const base::Array<double> stiffness = energy.stiffness();
    for (const std::int64_t i : {3, 77, 299}) {
        double trace = 0.0;
        for (glm::length_t c = 0; c < 3; ++c) {
            glm::dvec3 step(0.0);
            step[c] = 0.01;
            const glm::dvec3 kept = normal[i];
            normal.set(i, kept + step);
            const double after = energy.approximate_energy(normal, rest);
            normal.set(i, kept - step);
            const double before = energy.approximate_energy(normal, rest);
            normal.set(i, kept);
            EXPECT_NEAR((after - before) / 0.02, 2.0 * beta[i][c], 1e-6 + 1e-4 * std::abs(beta[i][c])) << i;
            trace += (after + before - 2.0 * energy.approximate_energy(normal, rest)) / 1e-4 / 2.0;
        }
        EXPECT_NEAR(stiffness[i], trace, 1e-3 * trace) << i;
    }
}

} // namespace

} // namespace hermite_energy_test
