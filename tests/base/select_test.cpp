// SPDX-License-Identifier: MIT
#include "base/select.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace select_test {
namespace {

using namespace hrbfnpr;

// Different numbers in an order that looks random.
std::vector<std::uint32_t> numbers(std::uint32_t count) {
    std::vector<std::uint32_t> made(count);
    std::uint32_t state = 1;
    for (std::uint32_t& number : made) number = state = state * 1664525 + 1013904223;
    return made;
}

void expect_selection(std::vector<std::uint32_t> given) {
    std::vector<std::uint32_t> sorted = given;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < given.size(); ++k) {
        std::vector<std::uint32_t> a = given;
        base::select(a.data(), a.data() + k, a.data() + a.size(), std::less<>());
        ASSERT_EQ(a[k], sorted[k]);
        EXPECT_TRUE(std::all_of(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(k),
                                [&](std::uint32_t x) { return x < sorted[k]; }));
        std::sort(a.begin(), a.end());
        EXPECT_EQ(a, sorted);
    }
}

TEST(Select, PutsTheElementInItsPlace) {
    for (std::uint32_t count = 1; count < 60; ++count) expect_selection(numbers(count));
}

TEST(Select, AcceptsAnyOrder) {
    std::vector<std::uint32_t> rising(100);
    std::iota(rising.begin(), rising.end(), 0U);
    expect_selection(rising);
    expect_selection({rising.rbegin(), rising.rend()});
    std::vector<std::uint32_t> organ; // rises, then falls, which makes bad pivots
    for (std::uint32_t i = 0; i < 50; ++i) organ.push_back(2 * i);
    for (std::uint32_t i = 50; i > 0; --i) organ.push_back(2 * i - 1);
    expect_selection(organ);
}

// The order decides how sums are rounded, so it must not depend on the platform.
TEST(Select, LeavesTheSameOrderEverywhere) {
    std::vector<std::uint32_t> a = numbers(1000);
    base::select(a.data(), a.data() + 500, a.data() + 1000, std::less<>());
    std::uint32_t hash = 2166136261;
    for (const std::uint32_t x : a) hash = (hash ^ x) * 16777619;
    EXPECT_EQ(hash, 3923316305U);
}

} // namespace
} // namespace select_test
