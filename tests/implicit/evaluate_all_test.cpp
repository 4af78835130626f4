// SPDX-License-Identifier: MIT
#include "implicit/evaluate_all.h"

#include "base/status.h"
#include "fields.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace evaluate_all_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::geometry::Bounds;
using hrbfnpr::geometry::VecArray;
using test::scatter;

namespace {

// f = x + 2 y + 4 z. It has `count` cells along x.
class Slices final : public implicit::Implicit {
public:
    explicit Slices(std::int64_t count) : count_(count) {
        bounds_.extend({-1.0, -1.0, -1.0});
        bounds_.extend({1.0, 1.0, 1.0});
    }

    void evaluate(const implicit::PointBatch& p, const implicit::FieldBatch& fields) const override {
        for (std::int64_t i = 0; i < p.count; ++i) {
            if (count_ > 0 && i > 0 && cell_of({p.x[i], 0, 0}) != cell_of({p.x[i - 1], 0, 0})) ++changes;
            if (fields.value != nullptr) fields.value[i] = p.x[i] + 2.0 * p.y[i] + 4.0 * p.z[i];
            for (std::size_t c = 0; c < 3 && fields.wants_gradient(); ++c) fields.gradient[c][i] = p.x[i] + double(c);
            for (std::size_t c = 0; c < 6 && fields.wants_hessian(); ++c) fields.hessian[c][i] = p.y[i] - double(c);
        }
    }
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const Bounds& bounds() const noexcept override { return bounds_; }
    [[nodiscard]] std::int64_t cells() const noexcept override { return count_; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept override {
        return static_cast<std::int32_t>(0.5 * (p.x + 1.0) * static_cast<double>(count_));
    }

    mutable std::atomic<int> changes{0}; // counts changes of the cell from one point to the next

private:
    std::int64_t count_;
    Bounds bounds_;
};

VecArray points(base::Memory& memory, int count) {
    VecArray result(memory);
    for (int i = 0; i < count; ++i) result.push_back({scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2)});
    return result;
}

TEST(EvaluateAll, ResultsAreInTheCallersOrder) {
    const base::Runtime runtime;
    for (const std::int64_t cells : {0, 1, 10})
        for (const int count : {0, 1, 255, 256, 257, 1000}) {
            const Slices slices(cells);
            const VecArray p = points(runtime.memory, count);
            test::Fields fields(static_cast<std::size_t>(count));
            implicit::evaluate_all(runtime, slices, p, fields.all());
            for (std::int64_t i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                EXPECT_EQ(fields.value[at], p.x[i] + 2.0 * p.y[i] + 4.0 * p.z[i]);
                for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(fields.gradient[c][at], p.x[i] + double(c));
                for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(fields.hessian[c][at], p.y[i] - double(c));
            }
        }
}

TEST(EvaluateAll, WritesOnlyRequestedFields) {
    const base::Runtime runtime;
    const Slices slices(5);
    const VecArray p = points(runtime.memory, 300);
    test::Fields fields(300);
    implicit::evaluate_all(runtime, slices, p, fields.batch(false, true, false));
    EXPECT_EQ(fields.value[7], -7.0);
    EXPECT_EQ(fields.hessian[0][7], -7.0);
    EXPECT_EQ(fields.gradient[2][7], p.x[7] + 2.0);
}

TEST(EvaluateAll, EvaluatesPointsOfACellTogether) {
    const base::Runtime runtime;
    const Slices slices(10);
    const VecArray p = points(runtime.memory, 2000);
    test::Fields fields(2000);
    implicit::evaluate_all(runtime, slices, p, fields.all());
    EXPECT_LT(slices.changes, 10);
    const base::Array<std::int32_t> order = implicit::order_by_cell(runtime, slices, p);
    ASSERT_EQ(order.size(), 2000);
    std::vector<int> seen(2000);
    for (std::int64_t i = 0; i < 2000; ++i) {
        ++seen[static_cast<std::size_t>(order[i])];
        if (i == 0) continue;
        const std::int32_t before = slices.cell_of(p[order[i - 1]]);
        const std::int32_t now = slices.cell_of(p[order[i]]);
        EXPECT_TRUE(before < now || (before == now && order[i - 1] < order[i])) << i;
    }
    for (const int times : seen) EXPECT_EQ(times, 1);
    EXPECT_TRUE(implicit::order_by_cell(runtime, Slices(0), p).empty());
}

} // namespace

} // namespace evaluate_all_test
