// SPDX-License-Identifier: MIT
#include "mesh/pieces/cells.h"

#include "implicit/sheet_tree.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace read_once_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::implicit::SheetTreeData;

namespace {

// Runs a program on zeros and ones: bit k of `inputs` is the value of function k.
bool run(std::span<const std::int32_t> program, unsigned inputs, std::size_t& operands) {
    std::vector<bool> stack;
    operands = 0;
    for (const std::int32_t code : program) {
        if (code >= 0) {
            ++operands;
            stack.push_back((inputs >> static_cast<unsigned>(code) & 1U) != 0);
            continue;
        }
        const bool b = stack.back();
        stack.pop_back();
        const bool a = stack.back();
        stack.back() = code == SheetTreeData::maximum ? a || b : a && b;
    }
    EXPECT_EQ(stack.size(), 1U);
    return stack[0];
}

// There are as many trees as series-parallel networks, and no two are the same function.
TEST(ReadOnceTrees, IncludeEveryTreeOnce) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const mesh::ReadOnceTrees trees(runtime.memory);
    const std::int64_t expected[] = {1, 2, 8, 52, 472};
    for (std::int32_t n = 1; n <= mesh::ReadOnceTrees::most; ++n) {
        ASSERT_EQ(trees.count(n), expected[n - 1]);
        std::set<std::vector<bool>> tables;
        for (std::int64_t tree = 0; tree < trees.count(n); ++tree) {
            std::vector<bool> table;
            for (unsigned inputs = 0; inputs < 1U << static_cast<unsigned>(n); ++inputs) {
                std::size_t operands = 0;
                table.push_back(run(trees.program(n, tree), inputs, operands));
                EXPECT_EQ(operands, static_cast<std::size_t>(n));
            }
            tables.insert(table);
        }
        EXPECT_EQ(static_cast<std::int64_t>(tables.size()), trees.count(n));
    }
}

} // namespace

} // namespace read_once_test
