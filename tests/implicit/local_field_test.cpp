// SPDX-License-Identifier: MIT
#include "implicit/local_field.h"

#include "base/status.h"
#include "fields.h"
#include "implicit/hermite_hessians.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace local_field_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::geometry::VecArray;
using hrbfnpr::kernel::Kind;
using test::scatter;

namespace {

constexpr double pi = 3.14159265358979;

struct Sources {
    explicit Sources(base::Memory& memory) : position(memory), alpha(memory), beta(memory) {}
    VecArray position;
    base::Array<double> alpha;
    VecArray beta;

    void add(const glm::dvec3& p) {
        const int from = 4 * static_cast<int>(position.size());
        position.push_back(p);
        alpha.push_back(scatter(from));
        beta.push_back({scatter(from + 1), scatter(from + 2), scatter(from + 3)});
    }
    [[nodiscard]] implicit::Sources all() const {
        return {position.x.data(), position.y.data(), position.z.data(), alpha.data(),
                beta.x.data(),     beta.y.data(),     beta.z.data(),     position.size()};
    }
};

// A sheet with a spacing of about 1, and a cluster a hundred times as dense.
Sources sheet(base::Memory& memory, int side, int cluster) {
    Sources sources(memory);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            sources.add(
                {i + 0.3 * scatter(i + 99 * j), j + 0.3 * scatter(j + 77 * i), 2.0 * std::sin(2.0 * pi * i / side)});
    for (int i = 0; i < cluster; ++i)
        sources.add(glm::dvec3(3.0, 4.0, 0.5) +
                    0.01 * glm::dvec3(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)));
    return sources;
}

struct Error {
    double value = 0.0;
    double gradient = 0.0;
    double hessian = 0.0;
};

// Returns the error at points around the sources, in units of the sum of absolute terms. No side conditions make the
// sum itself small.
Error largest_error(const base::Runtime& runtime, const Sources& sources, const implicit::LocalFieldOptions& options) {
    const implicit::LocalField field(runtime, sources.position, sources.alpha.data(), sources.beta, options);
    const auto sums = implicit::hermite_sums(runtime.instruction_set, Kind::triharmonic);
    const auto hessians = implicit::hermite_hessians(runtime.instruction_set, Kind::triharmonic);
    Error error;
    for (std::int64_t i = 0; i < sources.position.size(); i += 3) {
        const int k = 5 * static_cast<int>(i);
        const glm::dvec3 p = sources.position[i] + 1.5 * glm::dvec3(scatter(k), scatter(k + 1), scatter(k + 2));
        const std::int32_t cube = field.cube_of(p);
        if (cube < 0) continue;
        double found[4] = {};
        double jet[10] = {};
        double expected[10] = {};
        field.add(cube, {&p.x, &p.y, &p.z, found, found + 1, found + 2, found + 3, 1});
        field.add_jets(cube, {&p.x,
                              &p.y,
                              &p.z,
                              jet,
                              {jet + 1, jet + 2, jet + 3},
                              {jet + 4, jet + 5, jet + 6, jet + 7, jet + 8, jet + 9},
                              1});
        sums(0.0, sources.all(), {&p.x, &p.y, &p.z, expected, expected + 1, expected + 2, expected + 3, 1});
        hessians(0.0, sources.all(),
                 {&p.x,
                  &p.y,
                  &p.z,
                  {expected + 4, expected + 5, expected + 6, expected + 7, expected + 8, expected + 9},
                  1});
        const auto off = [&](const double* of, int c) { return std::abs(of[c] - expected[c]); };
        error.value = std::max({error.value, off(found, 0), off(jet, 0)});
        for (int c = 1; c < 4; ++c) error.gradient = std::max({error.gradient, off(found, c), off(jet, c)});
        for (int c = 4; c < 10; ++c) error.hessian = std::max(error.hessian, off(jet, c));
    }
    double all = 0.0;
    for (std::int64_t j = 0; j < sources.position.size(); ++j) {
        const double r = glm::distance(sources.position[0], sources.position[j]);
        all += std::abs(sources.alpha[j]) * r * r * r;
    }
    return {error.value / all, error.gradient / all, error.hessian / all};
}

TEST(LocalField, CountsTheBitsOfEveryByte) {
    for (std::uint32_t byte = 0; byte < 256; ++byte) EXPECT_EQ(implicit::bits_of_byte[byte], std::popcount(byte));
}

TEST(LocalField, EqualsTheSumOverAllSources) {
    const base::Runtime runtime;
    const Error error = largest_error(runtime, sheet(runtime.memory, 24, 0), {1.0, 1e-7, 0});
    EXPECT_LT(error.value, 5e-12);
    EXPECT_LT(error.gradient, 1e-11);
    EXPECT_LT(error.hessian, 1e-10);
    EXPECT_GT(error.value, 0.0) << "nothing is far";
}

TEST(LocalField, ClustersAreDividedAsDeeplyAsTheyNeed) {
    const base::Runtime runtime;
    const Sources sources = sheet(runtime.memory, 16, 300);
    const Error error = largest_error(runtime, sources, {1.0, 1e-7, 0});
    EXPECT_LT(error.value, 1e-10);
    EXPECT_LT(error.gradient, 1e-10);
}

TEST(LocalField, ALooserToleranceIsLessAccurate) {
    const base::Runtime runtime;
    const Sources sources = sheet(runtime.memory, 20, 0);
    const Error loose = largest_error(runtime, sources, {1.0, 1e-3, 0});
    const Error finer = largest_error(runtime, sources, {1.0, 1e-3, 1});
    EXPECT_LT(finer.value, 0.2 * loose.value);
    EXPECT_LT(finer.gradient, 0.2 * loose.gradient);
}

// Few sources are near a source, at any distance from one source to the next.
TEST(LocalField, CubesAreDividedUntilFewSourcesAreNear) {
    const base::Runtime runtime;
    for (const int side : {24, 32, 40, 48}) {
        const Sources sources = sheet(runtime.memory, side, 0);
        const implicit::LocalField field(runtime, sources.position, sources.alpha.data(), sources.beta, {1.0, 1e-3, 0});
        std::int64_t most = 0;
        for (std::int64_t i = 0; i < sources.position.size(); ++i)
            most = std::max(most, field.near_centres(field.cube_of(sources.position[i])));
        EXPECT_LE(most, 180) << side;
        EXPECT_GT(most, 20) << side;
    }
}

TEST(LocalField, PlacesOutsideAllCubesHaveNoCube) {
    const base::Runtime runtime;
    const Sources sources = sheet(runtime.memory, 16, 0);
    const implicit::LocalField field(runtime, sources.position, sources.alpha.data(), sources.beta, {1.0, 1e-3, 0});
    EXPECT_EQ(field.cube_of({-5.0, 3.0, 0.0}), -1);
    EXPECT_EQ(field.cube_of({3.0, 3.0, 1e9}), -1);
    EXPECT_EQ(field.cube_of({NAN, 3.0, 0.0}), -1);
    EXPECT_GE(field.cube_of({-0.5, 3.0, 0.0}), 0) << "a little outside of the sources";
    for (std::int64_t i = 0; i < sources.position.size(); ++i) {
        EXPECT_GE(field.cube_of(sources.position[i]), 0);
        EXPECT_LT(field.cube_of(sources.position[i]), field.cubes());
    }
}

} // namespace

} // namespace local_field_test
