// SPDX-License-Identifier: MIT
#include "implicit/hermite_hessians.h"

#include "implicit/hrbf_block.h"

#include "hermite.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hermite_hessians_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::test::instruction_sets;
using test::Fields;
using test::hermite_data;
using test::hessian_index;
using test::Points;
using test::scatter;
using test::targets;

namespace {

using Hessians = std::array<std::vector<double>, 6>;

constexpr double untouched = -7.0;
constexpr double before = 0.5; // initial value of the sums

// The Hessian of equation 1, term by term: alpha Hess psi minus beta times the third derivatives of psi.
Hessians plain_sums(const implicit::HrbfData& data, const Points& points) {
    Hessians sums;
    for (std::vector<double>& sum : sums) sum.assign(points.size(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::int64_t j = 0; j < data.count(); ++j) {
            const glm::dvec3 d = points[i] - data.centre_position[j];
            const glm::dvec3 beta = data.beta[j];
            const kernel::Radial k = kernel::radial(data.kernel, data.kernel_radius, glm::length(d));
            const double q = glm::dot(beta, d);
            for (glm::length_t m = 0; m < 3; ++m) {
                for (glm::length_t n = m; n < 3; ++n) {
                    const double same = m == n ? 1.0 : 0.0;
                    const double second = k.a * same + k.b * (d[m] * d[n]);
                    const double third = k.b * (same * q + beta[m] * d[n] + beta[n] * d[m]) + k.c * (d[m] * d[n] * q);
                    sums[hessian_index[m][n]][i] += data.alpha[j] * second - third;
                }
            }
        }
    }
    return sums;
}

implicit::HessianTargets slice(const Points& points, Hessians& sums, std::size_t begin, std::size_t end) {
    return {points.x.data() + begin,
            points.y.data() + begin,
            points.z.data() + begin,
            {sums[0].data() + begin, sums[1].data() + begin, sums[2].data() + begin, sums[3].data() + begin,
             sums[4].data() + begin, sums[5].data() + begin},
            static_cast<std::int64_t>(end - begin)};
}

// Adds the sums of the first `count` targets to `before`, with this instruction set.
Hessians sum_up(base::InstructionSet set, const implicit::HrbfData& data, const Points& points, std::size_t count) {
    Hessians sums = Fields(points.size()).hessian;
    for (std::vector<double>& sum : sums) std::fill_n(sum.begin(), count, before);
    implicit::hermite_hessians(set, data.kernel)(data.kernel_radius, implicit::sources_of(data),
                                                 slice(points, sums, 0, count));
    return sums;
}

double largest(const std::vector<double>& x) {
    double result = 0.0;
    for (const double value : x) result = std::max(result, std::abs(value));
    return result;
}

// Expects the sums of the first `count` targets in `found`, and the entries after them untouched.
void expect_sums(const Hessians& found, const Hessians& expected, std::size_t count, const std::string& what) {
    for (std::size_t c = 0; c < 6; ++c) {
        const double tolerance = 1e-12 * (largest(expected[c]) + before);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_NEAR(found[c][i] - before, expected[c][i], tolerance) << what << " " << c << " " << i;
        for (std::size_t i = count; i < found[c].size(); ++i)
            EXPECT_EQ(found[c][i], untouched) << what << " " << c << " " << i;
    }
}

class HermiteHessians : public testing::TestWithParam<kernel::Kind> {};

TEST_P(HermiteHessians, MatchPlainSumsForAnyCount) {
    base::Memory memory;
    for (const int centres : {0, 1, 23}) {
        const implicit::HrbfData data = hermite_data(memory, GetParam(), centres);
        const Points points = targets(hermite_data(memory, GetParam(), 23), 67);
        const Hessians plain = plain_sums(data, points);
        for (const base::InstructionSet set : instruction_sets())
            for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 7U, 8U, 9U, 15U, 16U, 17U, 25U, 64U})
                expect_sums(sum_up(set, data, points, count), plain, count,
                            std::string(base::name(set)) + " " + std::to_string(count));
    }
}

TEST_P(HermiteHessians, DoNotDependOnTheSplitOfTargets) {
    base::Memory memory;
    const implicit::HrbfData data = hermite_data(memory, GetParam(), 31);
    const Points points = targets(data, 137);
    for (const base::InstructionSet set : instruction_sets()) {
        const implicit::AddHermiteHessians add = implicit::hermite_hessians(set, GetParam());
        const Hessians together = sum_up(set, data, points, points.size());
        for (const std::size_t piece : {1U, 3U, 8U, 13U, 64U}) {
            Hessians apart;
            for (std::vector<double>& sum : apart) sum.assign(points.size(), before);
            for (std::size_t begin = 0; begin < points.size(); begin += piece)
                add(data.kernel_radius, implicit::sources_of(data),
                    slice(points, apart, begin, std::min(points.size(), begin + piece)));
            EXPECT_EQ(together, apart) << base::name(set) << piece;
        }
    }
}

// Points next to the source are included, where the limit depends on the direction.
TEST_P(HermiteHessians, MatchPlainSumsAtASource) {
    base::Memory memory;
    const implicit::HrbfData data = hermite_data(memory, GetParam(), 2);
    Points points;
    points.add(data.centre_position[0]);
    for (double gap = 1e-2; gap > 1e-18; gap *= 0.1) {
        points.add(data.centre_position[0] + gap * glm::dvec3(1.0, 0.0, 0.0));
        points.add(data.centre_position[0] + gap * glm::dvec3(-0.3, 0.7, 0.5));
    }
    const Hessians plain = plain_sums(data, points);
    for (const base::InstructionSet set : instruction_sets())
        expect_sums(sum_up(set, data, points, points.size()), plain, points.size(), base::name(set));
}

// At a source its own beta adds nothing. Its alpha adds the kernel's second derivative.
TEST_P(HermiteHessians, LeaveASourcesOwnThirdDerivativeOut) {
    base::Memory memory;
    implicit::HrbfData data = hermite_data(memory, GetParam(), 1);
    Points points;
    points.add(data.centre_position[0]);
    const double a = kernel::radial(data.kernel, data.kernel_radius, 0.0).a;
    for (const double alpha : {0.0, 2.0}) {
        data.alpha[0] = alpha;
        const Hessians diagonal = [&] {
            Hessians expected;
            for (std::size_t c = 0; c < 6; ++c) expected[c].assign(1, c == 0 || c == 3 || c == 5 ? alpha * a : 0.0);
            return expected;
        }();
        for (const base::InstructionSet set : instruction_sets())
            expect_sums(sum_up(set, data, points, 1), diagonal, 1, base::name(set));
    }
}

// At a source in the origin, doubles come closer than smallest_r2.
TEST_P(HermiteHessians, AreBoundedArbitrarilyCloseToASource) {
    base::Memory memory;
    implicit::HrbfData data = hermite_data(memory, GetParam(), 1);
    data.centre_position.set(0, glm::dvec3(0.0));
    Points points;
    for (double gap = 1e-10; gap > 0.0; gap *= 1e-5) points.add(gap * glm::dvec3(-0.3, 0.7, 0.5));
    const double bound = 100.0; // larger than alpha a and beta b d
    for (const base::InstructionSet set : instruction_sets())
        for (const std::vector<double>& sum : sum_up(set, data, points, points.size()))
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_LT(std::abs(sum[i]), bound) << base::name(set) << " " << i; // not a NaN
}

INSTANTIATE_TEST_SUITE_P(Kernels, HermiteHessians,
                         testing::Values(kernel::Kind::triharmonic, kernel::Kind::gaussian, kernel::Kind::wendland_c2),
                         [](const auto& kind) { return std::string(1, "TGW"[static_cast<int>(kind.param)]); });

} // namespace

} // namespace hermite_hessians_test
