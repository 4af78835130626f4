// SPDX-License-Identifier: MIT
#include "base/groups.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace groups_test {
namespace {

using namespace hrbfnpr;

TEST(Groups, KeepTheOrderOfTheirItems) {
    base::Memory memory;
    const std::vector<std::pair<std::int64_t, std::int32_t>> given{{2, 7}, {0, 1}, {2, 3}, {4, 9}, {2, 5}, {0, 8}};
    const base::Groups groups(memory, 5, [&](auto&& put) {
        for (const auto& [group, item] : given) put(group, item);
    });
    ASSERT_EQ(groups.groups(), 5);
    const std::vector<std::vector<std::int32_t>> expected{{1, 8}, {}, {7, 3, 5}, {}, {9}};
    for (std::int64_t group = 0; group < 5; ++group) {
        const auto items = groups[group];
        EXPECT_EQ(std::vector<std::int32_t>(items.begin(), items.end()), expected[static_cast<std::size_t>(group)]);
        EXPECT_EQ(groups.count(group), static_cast<std::int64_t>(items.size()));
    }
}

TEST(Groups, MayBeEmpty) {
    base::Memory memory;
    EXPECT_EQ(base::Groups(memory, 0, [](auto&&) {}).groups(), 0);
    EXPECT_TRUE(base::Groups(memory, 3, [](auto&&) {})[2].empty());
}

} // namespace
} // namespace groups_test
