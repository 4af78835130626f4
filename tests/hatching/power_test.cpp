// SPDX-License-Identifier: MIT
// Tests powers of means against repeated means.
#include "hatching/power.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrbfnpr::hatching::power_test {
namespace {

// A ring of numbers; the mean of each is that of itself and its two neighbours.
struct Ring {
    [[nodiscard]] float operator()(std::int64_t i, const base::Array<float>& z) const {
        const std::int64_t count = z.size();
        return (z[(i + count - 1) % count] + z[i] + z[(i + 1) % count]) / 3.0F;
    }
};

base::Array<float> numbers(const base::Runtime& runtime) {
    base::Array<float> z(runtime.memory, 500);
    for (std::int64_t i = 0; i < z.size(); ++i) z[i] = static_cast<float>(i * i % 17) - 8.0F;
    z[250] = 300.0F;
    return z;
}

float farthest(const base::Runtime& runtime, int rounds, double deviations) {
    base::Array<float> repeated = numbers(runtime);
    for (int round = 0; round < rounds; ++round) {
        base::Array<float> next(runtime.memory, repeated.size());
        for (std::int64_t i = 0; i < next.size(); ++i) next[i] = Ring()(i, repeated);
        std::swap(next, repeated);
    }
    base::Array<float> power = numbers(runtime);
    apply_power(runtime, rounds, deviations, power, Ring());
    float most = 0.0F;
    for (std::int64_t i = 0; i < power.size(); ++i) most = std::max(most, std::abs(power[i] - repeated[i]));
    return most;
}

TEST(Power, EqualsRepeatedMeans) {
    const base::Runtime runtime;
    for (const int rounds : {0, 1, 2, 9, 20}) EXPECT_LT(farthest(runtime, rounds, 100.0), 2e-4F) << rounds;
}

TEST(Power, LeavesOutSmallWeightsOnly) {
    const base::Runtime runtime;
    EXPECT_LT(farthest(runtime, 100, 3.0), 0.003F * 300.0F);
    EXPECT_GT(farthest(runtime, 100, 1.0), 0.01F * 300.0F);
}

} // namespace
} // namespace hrbfnpr::hatching::power_test
