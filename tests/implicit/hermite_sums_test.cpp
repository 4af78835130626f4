// SPDX-License-Identifier: MIT
#include "implicit/hermite_sums.h"

#include "implicit/hrbf_block.h"

#include "hermite.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hermite_sums_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::test::instruction_sets;
using test::Fields;
using test::hermite_data;
using test::Points;
using test::scatter;
using test::targets;

namespace {

constexpr double untouched = -7.0;
constexpr double before = 0.5; // initial value of the sums

// Equation 1 and its gradient, term by term.
Fields plain_sums(const implicit::HrbfData& data, const Points& points) {
    Fields sums(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        double value = 0.0;
        glm::dvec3 gradient(0.0);
        for (std::int64_t j = 0; j < data.count(); ++j) {
            const glm::dvec3 d = points[i] - data.centre_position[j];
            const kernel::Radial k = kernel::radial(data.kernel, data.kernel_radius, glm::length(d));
            const double along = glm::dot(data.beta[j], d);
            value += data.alpha[j] * k.phi - k.a * along;
            gradient += (k.a * data.alpha[j] - k.b * along) * d - k.a * data.beta[j];
        }
        sums.value[i] = value;
        for (std::size_t c = 0; c < 3; ++c) sums.gradient[c][i] = gradient[static_cast<int>(c)];
    }
    return sums;
}

implicit::Targets slice(const Points& points, Fields& sums, std::size_t begin, std::size_t end) {
    return {points.x.data() + begin,         points.y.data() + begin,
            points.z.data() + begin,         sums.value.data() + begin,
            sums.gradient[0].data() + begin, sums.gradient[1].data() + begin,
            sums.gradient[2].data() + begin, static_cast<std::int64_t>(end - begin)};
}

double largest(const std::vector<double>& x) {
    double result = 0.0;
    for (const double value : x) result = std::max(result, std::abs(value));
    return result;
}

// Expects the sums of the first `count` targets in `found`, and the entries after them untouched.
void expect_sums(const std::vector<double>& found, const std::vector<double>& expected, std::size_t count,
                 const std::string& what) {
    const double tolerance = 1e-12 * (largest(expected) + before);
    for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(found[i] - before, expected[i], tolerance) << what << i;
    for (std::size_t i = count; i < found.size(); ++i) EXPECT_EQ(found[i], untouched) << what << i;
}

class HermiteSums : public testing::TestWithParam<kernel::Kind> {};

TEST_P(HermiteSums, MatchPlainSumsForAnyCount) {
    base::Memory memory;
    for (const int centres : {0, 1, 23}) {
        const implicit::HrbfData data = hermite_data(memory, GetParam(), centres);
        const Points points = targets(hermite_data(memory, GetParam(), 23), 24);
        const Fields plain = plain_sums(data, points);
        for (const base::InstructionSet set : instruction_sets()) {
            for (std::size_t count = 0; count <= 20; ++count) {
                Fields sums(points.size());
                for (std::vector<double>* sum : {&sums.value, &sums.gradient[0], &sums.gradient[1], &sums.gradient[2]})
                    std::fill_n(sum->begin(), count, before);
                implicit::hermite_sums(set, GetParam())(data.kernel_radius, implicit::sources_of(data),
                                                        slice(points, sums, 0, count));
                const std::string what = std::string(base::name(set)) + " " + std::to_string(count) + " at ";
                expect_sums(sums.value, plain.value, count, what);
                for (std::size_t c = 0; c < 3; ++c) expect_sums(sums.gradient[c], plain.gradient[c], count, what);
            }
        }
    }
}

TEST_P(HermiteSums, DoNotDependOnTheSplitOfTargets) {
    base::Memory memory;
    const implicit::HrbfData data = hermite_data(memory, GetParam(), 31);
    const Points points = targets(data, 137);
    for (const base::InstructionSet set : instruction_sets()) {
        const implicit::AddHermiteSums add = implicit::hermite_sums(set, GetParam());
        Fields together(points.size());
        add(data.kernel_radius, implicit::sources_of(data), slice(points, together, 0, points.size()));
        for (const std::size_t piece : {1U, 3U, 8U, 13U, 64U}) {
            Fields apart(points.size());
            for (std::size_t begin = 0; begin < points.size(); begin += piece)
                add(data.kernel_radius, implicit::sources_of(data),
                    slice(points, apart, begin, std::min(points.size(), begin + piece)));
            EXPECT_EQ(together.value, apart.value) << base::name(set) << piece;
            EXPECT_EQ(together.gradient, apart.gradient) << base::name(set) << piece;
        }
    }
}

TEST_P(HermiteSums, AreFiniteNextToASource) {
    base::Memory memory;
    const implicit::HrbfData data = hermite_data(memory, GetParam(), 2);
    Points points;
    for (double gap = 1e-2; gap > 1e-18; gap *= 0.1) points.add(data.centre_position[0] + glm::dvec3(gap, 0.0, 0.0));
    const Fields plain = plain_sums(data, points);
    for (const base::InstructionSet set : instruction_sets()) {
        Fields sums(points.size());
        for (std::vector<double>* sum : {&sums.value, &sums.gradient[0], &sums.gradient[1], &sums.gradient[2]})
            std::fill(sum->begin(), sum->end(), before);
        implicit::hermite_sums(set, GetParam())(data.kernel_radius, implicit::sources_of(data),
                                                slice(points, sums, 0, points.size()));
        expect_sums(sums.value, plain.value, points.size(), base::name(set));
        for (std::size_t c = 0; c < 3; ++c)
            expect_sums(sums.gradient[c], plain.gradient[c], points.size(), base::name(set));
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, HermiteSums,
                         testing::Values(kernel::Kind::triharmonic, kernel::Kind::gaussian, kernel::Kind::wendland_c2),
                         [](const auto& kind) { return std::string(1, "TGW"[static_cast<int>(kind.param)]); });

} // namespace

} // namespace hermite_sums_test
