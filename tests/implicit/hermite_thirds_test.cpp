// SPDX-License-Identifier: MIT
#include "implicit/hermite_thirds.h"

#include "implicit/hrbf_block.h"

#include "fields.h"
#include "implicit/scaled.h"
#include "implicit/shape_source.h"
#include "kernel/polynomial.h"
#include "support/analytic.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hermite_thirds_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::test::instruction_sets;
using test::hessian_index;
using test::Points;
using test::scatter;

namespace {

struct Thirds {
    explicit Thirds(std::size_t count, double value = 0.0) {
        for (auto& component : hessian) component.assign(count, value);
        for (auto& component : third) component.assign(count, value);
    }
    implicit::ThirdTargets targets(const Points& points, std::size_t begin, std::size_t end) {
        implicit::ThirdTargets t{points.x.data() + begin,
                                 points.y.data() + begin,
                                 points.z.data() + begin,
                                 {},
                                 {},
                                 static_cast<std::int64_t>(end - begin)};
        for (std::size_t c = 0; c < 6; ++c) t.hessian[c] = hessian[c].data() + begin;
        for (std::size_t c = 0; c < 10; ++c) t.third[c] = third[c].data() + begin;
        return t;
    }
    implicit::ThirdBatch batch() {
        implicit::ThirdBatch batch;
        for (std::size_t c = 0; c < 6; ++c) batch.hessian[c] = hessian[c].data();
        for (std::size_t c = 0; c < 10; ++c) batch.third[c] = third[c].data();
        return batch;
    }
    bool operator==(const Thirds&) const = default;

    std::array<std::vector<double>, 6> hessian;
    std::array<std::vector<double>, 10> third;
};

constexpr std::array<std::array<std::size_t, 3>, 10> axes = {
    {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 1}, {0, 1, 2}, {0, 2, 2}, {1, 1, 1}, {1, 1, 2}, {1, 2, 2}, {2, 2, 2}}};

implicit::HrbfData make(base::Memory& memory, kernel::Kind kind, int centres, std::int32_t degree = -1) {
    implicit::HrbfData data(memory);
    data.kernel = kind;
    data.kernel_radius = kind == kernel::Kind::gaussian ? 0.8 : 1.5;
    data.polynomial_degree = degree;
    for (int k = 0; k < kernel::polynomial_size(degree); ++k) data.polynomial.push_back(scatter(900 + k));
    for (int j = 0; j < centres; ++j) {
        data.centre_position.push_back({scatter(7 * j), scatter(7 * j + 1), scatter(7 * j + 2)});
        data.beta.push_back({scatter(7 * j + 3), scatter(7 * j + 4), scatter(7 * j + 5)});
        data.alpha.push_back(scatter(7 * j + 6));
    }
    return data;
}

// The first target and every fifth one are centres.
Points points_of(const implicit::HrbfData& data, int count) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.add(i % 5 == 0 ? data.centre_position[i % data.count()]
                              : glm::dvec3(scatter(5000 + 3 * i), scatter(5001 + 3 * i), scatter(5002 + 3 * i)));
    return points;
}

double largest(const std::vector<double>& x) {
    double result = 0.0;
    for (const double value : x) result = std::max(result, std::abs(value));
    return result;
}

template <std::size_t n>
void expect_near(const std::array<std::vector<double>, n>& found, const std::array<std::vector<double>, n>& expected,
                 double relative, const std::string& what) {
    for (std::size_t c = 0; c < n; ++c) {
        ASSERT_GT(largest(expected[c]), 0.0);
        for (std::size_t i = 0; i < expected[c].size(); ++i)
            EXPECT_NEAR(found[c][i], expected[c][i], relative * largest(expected[c])) << what << " " << c << " " << i;
    }
}

class HermiteThirds : public testing::TestWithParam<kernel::Kind> {
protected:
    [[nodiscard]] static double smoothing() { return GetParam() == kernel::Kind::gaussian ? 0.0 : 0.04; }
    base::Memory memory;
};

TEST_P(HermiteThirds, MatchPlainSumsForAnyCountAndCut) {
    const implicit::HrbfData data = make(memory, GetParam(), 23);
    for (const std::size_t count : {1U, 2U, 3U, 5U, 8U, 9U, 16U, 67U}) {
        const Points points = points_of(data, static_cast<int>(count));
        Thirds plain(count);
        implicit::add_hermite_thirds_plainly(GetParam(), data.kernel_radius, smoothing(), implicit::sources_of(data),
                                             plain.targets(points, 0, count));
        for (const base::InstructionSet set : instruction_sets()) {
            Thirds found(count);
            const implicit::AddHermiteThirds add = implicit::hermite_thirds(set, GetParam());
            add(data.kernel_radius, smoothing(), implicit::sources_of(data), found.targets(points, 0, count));
            expect_near(found.hessian, plain.hessian, 1e-12, base::name(set));
            expect_near(found.third, plain.third, 1e-12, base::name(set));
            Thirds apart(count);
            for (std::size_t begin = 0; begin < count; begin += 3)
                add(data.kernel_radius, smoothing(), implicit::sources_of(data),
                    apart.targets(points, begin, std::min(count, begin + 3)));
            EXPECT_EQ(found, apart) << base::name(set);
        }
    }
}

// Without smoothing the Hessian is that of the function. With smoothing the thirds are still the Hessian's derivatives.
TEST_P(HermiteThirds, MatchTheHessianAndItsDifferences) {
    const implicit::HrbfData data = make(memory, GetParam(), 9);
    Points points;
    for (int i = 0; i < 40; ++i) points.add({scatter(3 * i + 5001), scatter(3 * i + 5002), scatter(3 * i + 5003)});
    test::Fields fields(points.size());
    implicit::evaluate(data, points.batch(), fields.all());
    Thirds bare(points.size());
    implicit::add_hermite_thirds_plainly(GetParam(), data.kernel_radius, 0.0, implicit::sources_of(data),
                                         bare.targets(points, 0, points.size()));
    expect_near(bare.hessian, fields.hessian, 1e-12, "bare");

    const double h = 1e-4;
    Thirds at(points.size());
    implicit::add_hermite_thirds_plainly(GetParam(), data.kernel_radius, smoothing(), implicit::sources_of(data),
                                         at.targets(points, 0, points.size()));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<Thirds, 2> moved = {Thirds(points.size()), Thirds(points.size())};
        for (const int side : {0, 1}) {
            Points shifted = points;
            for (double& x : axis == 0 ? shifted.x : axis == 1 ? shifted.y : shifted.z) x += side == 0 ? -h : h;
            implicit::add_hermite_thirds_plainly(
                GetParam(), data.kernel_radius, smoothing(), implicit::sources_of(data),
                moved[static_cast<std::size_t>(side)].targets(shifted, 0, points.size()));
        }
        for (std::size_t c = 0; c < 10; ++c) {
            if (axes[c][0] != axis) continue; // any of the three axes would do
            const std::size_t other = hessian_index[axes[c][1]][axes[c][2]];
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_NEAR(at.third[c][i], (moved[1].hessian[other][i] - moved[0].hessian[other][i]) / (2.0 * h),
                            2e-5 * largest(at.third[c]))
                    << c << " " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, HermiteThirds,
                         testing::Values(kernel::Kind::triharmonic, kernel::Kind::gaussian, kernel::Kind::wendland_c2));

// Compares a polynomial of degree 3, in another unit and place, with differences of the source's own Hessian.
TEST(HrbfShape, HasThePolynomialAndTheScale) {
    base::Memory memory;
    for (const int centres : {0, 11}) {
        implicit::HrbfData data = make(memory, kernel::Kind::triharmonic, centres, 3);
        data.centre = {10.0, -3.0, 2.0};
        data.scale = 5.0;
        data.spacing = 2.0; // 0.4 in normalised units
        const implicit::HrbfShape shape(base::choose_instruction_set(base::InstructionSet::automatic), data);
        Points points;
        for (int i = 0; i < 30; ++i)
            points.add(data.centre + 5.0 * glm::dvec3(scatter(3 * i + 1), scatter(3 * i + 2), scatter(3 * i + 3)));
        Thirds at(points.size());
        shape.evaluate(points.batch(), at.batch());
        if (centres == 0) {
            test::Fields fields(points.size());
            implicit::evaluate(data, points.batch(), fields.all());
            expect_near(at.hessian, fields.hessian, 1e-12, "no centres");
        }
        const double h = 1e-3;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Points low = points;
            Points high = points;
            for (double& x : axis == 0 ? low.x : axis == 1 ? low.y : low.z) x -= h;
            for (double& x : axis == 0 ? high.x : axis == 1 ? high.y : high.z) x += h;
            Thirds below(points.size());
            Thirds above(points.size());
            shape.evaluate(low.batch(), below.batch());
            shape.evaluate(high.batch(), above.batch());
            for (std::size_t c = 0; c < 10; ++c) {
                if (axes[c][2] != axis) continue;
                const std::size_t other = hessian_index[axes[c][0]][axes[c][1]];
                for (std::size_t i = 0; i < points.size(); ++i)
                    EXPECT_NEAR(at.third[c][i], (above.hessian[other][i] - below.hessian[other][i]) / (2.0 * h),
                                1e-5 * largest(at.third[c]))
                        << c << " " << i;
            }
        }
    }
}

// At a sample the bare Hessian jumps. The smoothed one is the same from all sides.
TEST(HrbfShape, IsContinuousAtASample) {
    base::Memory memory;
    implicit::HrbfData data = make(memory, kernel::Kind::triharmonic, 1);
    data.spacing = 1.0;
    const auto set = base::choose_instruction_set(base::InstructionSet::automatic);
    Points points;
    for (const double side : {-1e-6, 1e-6}) points.add(data.centre_position[0] + glm::dvec3(side, 0.0, 0.0));
    const auto jump = [&](double smoothing) {
        Thirds at(2);
        implicit::HrbfShape(set, data, smoothing).evaluate(points.batch(), at.batch());
        return std::abs(at.hessian[0][1] - at.hessian[0][0]);
    };
    EXPECT_GT(jump(1e-9), 0.1);
    EXPECT_LT(jump(implicit::ordinary_smoothing), 1e-4);
}

TEST(DifferencedShape, DifferencesHessiansOfAPolynomial) {
    // f = x^3 y + x y z^2 + z^4 / 4
    const hrbfnpr::test::AnyField field(hrbfnpr::test::cube(1.0), [](const glm::dvec3& p) {
        const double x = p.x;
        const double y = p.y;
        const double z = p.z;
        return hrbfnpr::test::Field{x * x * x * y + x * y * z * z + 0.25 * z * z * z * z,
                                    {3 * x * x * y + y * z * z, x * x * x + x * z * z, 2 * x * y * z + z * z * z},
                                    {6 * x * y, 3 * x * x + z * z, 2 * y * z, 0.0, 2 * x * z, 2 * x * y + 3 * z * z}};
    });
    Points points;
    for (int i = 0; i < 300; i += 7) points.add({scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)});
    Thirds at(points.size());
    implicit::DifferencedShape(field).evaluate(points.batch(), at.batch());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [x, y, z] = std::array{points.x[i], points.y[i], points.z[i]};
        EXPECT_EQ(at.hessian[4][i], 2 * x * z);
        const std::array<double, 10> expected = {6 * y, 6 * x, 0, 0, 2 * z, 2 * y, 0, 0, 2 * x, 6 * z};
        for (std::size_t c = 0; c < 10; ++c) EXPECT_NEAR(at.third[c][i], expected[c], 1e-10) << c;
    }
}

TEST(ScaledShape, MatchesTheScaledFunction) {
    const hrbfnpr::test::Torus torus(40.0, 15.0);
    const implicit::Scaled scaled(torus, 32.0);
    const implicit::DifferencedShape own(torus);
    const implicit::ScaledShape shape(own, 32.0);
    const implicit::DifferencedShape expected(scaled);
    Points points;
    for (int i = 0; i < 40; ++i)
        points.add({1.0 + 0.3 * scatter(i), 0.4 * scatter(i + 50), 0.2 + 0.1 * scatter(i + 90)});
    Thirds found(points.size());
    Thirds differenced(points.size());
    shape.evaluate(points.batch(), found.batch());
    expected.evaluate(points.batch(), differenced.batch());
    expect_near(found.hessian, differenced.hessian, 1e-12, "scaled");
    expect_near(found.third, differenced.third, 1e-9, "scaled");
}

} // namespace

} // namespace hermite_thirds_test
