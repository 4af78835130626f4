// SPDX-License-Identifier: MIT
// Tests the random choice of a given number of candidates.
#include "marks/site.h"

#include "support/analytic.h"
#include "support/point_sets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hrbfnpr::marks::thinning_test {
namespace {

std::uint64_t key_of(std::int64_t i) noexcept { return static_cast<std::uint64_t>(i) * 977U + 5U; }

std::int64_t kept(std::int64_t count, std::int64_t room) {
    static const test::Sphere anything;
    const Site site{test::runtime(), anything, 1e-6, 7};
    const Thinning thinning(site, count, room, 0, key_of);
    std::int64_t found = 0;
    for (std::int64_t i = 0; i < count; ++i) found += thinning.keeps(key_of(i)) ? 1 : 0;
    return found;
}

TEST(Thinning, KeepsAsManyMarksAsFit) {
    for (const std::int64_t count : {std::int64_t{1}, std::int64_t{2}, std::int64_t{5000}, std::int64_t{300000}})
        for (const std::int64_t room : {std::int64_t{0}, std::int64_t{1}, count / 3, count - 1, count, count + 1})
            EXPECT_EQ(kept(count, room), std::min(count, room)) << count << ", " << room;
}

} // namespace
} // namespace hrbfnpr::marks::thinning_test
