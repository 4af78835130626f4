// SPDX-License-Identifier: MIT
// Tests the prepared evaluator on fitted surfaces.
#include "implicit/prepared.h"

#include "base/status.h"
#include "implicit/evaluate_all.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace prepared_test {

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::geometry::VecArray;
using implicit::Prepared;
using namespace fit_test;

namespace {

struct Everything {
    Everything(base::Memory& memory, std::int64_t count) : numbers(memory, 10 * count) {
        fields.value = numbers.data();
        for (std::int64_t c = 0; c < 3; ++c)
            fields.gradient[static_cast<std::size_t>(c)] = numbers.data() + (1 + c) * count;
        for (std::int64_t c = 0; c < 6; ++c)
            fields.hessian[static_cast<std::size_t>(c)] = numbers.data() + (4 + c) * count;
    }
    base::Array<double> numbers;
    implicit::FieldBatch fields;
};

// Points near the surface as for marks, off the surface, inside, and outside of all cubes.
VecArray places(base::Memory& memory, const Cloud& cloud) {
    VecArray result(memory);
    for (std::int64_t i = 0; i < cloud.count(); ++i) {
        const auto s = static_cast<double>(i);
        const double off = 0.1 * std::pow(std::sin(s), 5.0);
        result.push_back(cloud.point(i) + off * cloud.normal(i) +
                         0.05 * glm::dvec3(std::sin(3.0 * s), std::sin(5.0 * s), std::sin(7.0 * s)));
    }
    for (int i = 0; i < 40; ++i) result.push_back(0.02 * i * glm::dvec3(1.0, -0.6, 0.3));
    result.push_back({3.0, 0.1, 0.2});
    result.push_back({-40.0, 500.0, 1.0});
    return result;
}

class PreparedTest : public testing::Test {
protected:
    PreparedTest() : cloud(bumpy(800)), result(fit::fit(runtime, input(cloud))), at(places(runtime.memory, cloud)) {}

    [[nodiscard]] Everything evaluate(const base::Runtime& on, const implicit::Implicit& of) const {
        Everything all(const_cast<base::Memory&>(on.memory), at.size());
        implicit::evaluate_all(on, of, at, all.fields);
        return all;
    }

    base::Runtime runtime;
    Cloud cloud;
    fit::FitResult result;
    VecArray at;
};

TEST_F(PreparedTest, EqualsTheSumOverAllCentres) {
    const auto prepared = Prepared::make(runtime, result.data);
    ASSERT_NE(prepared, nullptr);
    const Everything found = evaluate(runtime, *prepared);
    Everything expected(runtime.memory, at.size());
    implicit::evaluate(result.data, {at.x.data(), at.y.data(), at.z.data(), at.size()}, expected.fields);
    const double diagonal = prepared->diagonal();
    for (std::int64_t i = 0; i < at.size(); ++i) {
        EXPECT_NEAR(found.fields.value[i], expected.fields.value[i], 1e-9 * std::max(diagonal, glm::length(at[i])))
            << i;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(found.fields.gradient[c][i], expected.fields.gradient[c][i], 1e-7) << i;
        for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(found.fields.hessian[c][i], expected.fields.hessian[c][i], 1e-4) << i << " " << c;
    }
    EXPECT_LT(prepared->error().value, 1e-9);
    EXPECT_LT(prepared->error().gradient, 1e-7);
    EXPECT_GT(prepared->error().gradient, 0.0);
    EXPECT_GT(prepared->bytes(), result.data.count() * 100);
}

TEST_F(PreparedTest, CellsContainTheSamplesButNoDistantPlaces) {
    const auto prepared = Prepared::make(runtime, result.data);
    ASSERT_NE(prepared, nullptr);
    EXPECT_GT(prepared->cells(), 50);
    std::int64_t inside = 0;
    for (std::int64_t i = 0; i < cloud.count(); ++i)
        inside += prepared->cell_of(cloud.point(i)) + 1 < prepared->cells() ? 1 : 0;
    EXPECT_EQ(inside, cloud.count());
    EXPECT_EQ(prepared->cell_of({-40.0, 500.0, 1.0}) + 1, prepared->cells());
    EXPECT_EQ(prepared->cell_of({NAN, 0.0, 0.0}) + 1, prepared->cells());
}

TEST_F(PreparedTest, APointsResultDoesNotDependOnOtherPoints) {
    const auto prepared = Prepared::make(runtime, result.data);
    const Everything all = evaluate(runtime, *prepared);
    for (std::int64_t i = 0; i < at.size(); i += 37) {
        Everything one(runtime.memory, 1);
        prepared->evaluate({&at.x[i], &at.y[i], &at.z[i], 1}, one.fields);
        EXPECT_EQ(one.fields.value[0], all.fields.value[i]) << i;
        EXPECT_EQ(one.fields.gradient[1][0], all.fields.gradient[1][i]) << i;
        EXPECT_EQ(one.fields.hessian[4][0], all.fields.hessian[4][i]) << i;
    }
}

// Parts nearly coincide and cross, so samples contradict each other and the weights need many digits.
TEST(Prepared, StaysAccurateForCrossingParts) {
    const base::Runtime runtime;
    Cloud crossing = bumpy(1200);
    const Cloud other = bumpy(1200).moved(1.0, {0.003, 0.002, 0.001});
    for (std::int64_t i = 0; i < other.count(); ++i) crossing.add(other.point(i), other.normal(i));
    const fit::FitResult fitted = fit::fit(runtime, input(crossing));
    const auto prepared = Prepared::make(runtime, fitted.data);
    ASSERT_NE(prepared, nullptr);
    EXPECT_GT(prepared->error().gradient, 5e-7); // the error is large enough to make the test meaningful
    EXPECT_LT(prepared->error().value, 200e-9);
    EXPECT_LT(prepared->error().gradient, 200e-7);
}

// The degrees are such that no level of cells causes most of the error.
TEST(Prepared, IsAccurateWithManyLevels) {
    const base::Runtime runtime;
    const fit::FitResult fitted = fit::fit(runtime, input(bumpy(2000)));
    const auto prepared = Prepared::make(runtime, fitted.data);
    ASSERT_NE(prepared, nullptr);
    EXPECT_LT(prepared->error().value, 3e-10);
    EXPECT_LT(prepared->error().gradient, 1e-7);
}

TEST(Prepared, IsUsedOnlyForManyTriharmonicCentres) {
    const base::Runtime runtime;
    const fit::FitResult few = fit::fit(runtime, input(bumpy(100)));
    EXPECT_EQ(Prepared::make(runtime, few.data), nullptr);
    EXPECT_FALSE(Prepared::pays(few.data, 1e12));
    const fit::FitResult other = fit::fit(runtime, input(bumpy(600), hrbfnpr::kernel::Kind::wendland_c2, 1));
    EXPECT_EQ(Prepared::make(runtime, other.data), nullptr);
    EXPECT_FALSE(Prepared::pays(other.data, 1e12));
    const fit::FitResult many = fit::fit(runtime, input(bumpy(600)));
    EXPECT_FALSE(Prepared::pays(many.data, 1000.0));
    EXPECT_TRUE(Prepared::pays(many.data, 1e8));
}

} // namespace

} // namespace prepared_test
