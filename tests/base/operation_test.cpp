// SPDX-License-Identifier: MIT
#include "base/long_array.h"
#include "base/operation.h"
#include "base/sort_on_threads.h"
#include "base/status.h"
#include "support/runtime.h"
#include "support/watcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace hrbfnpr::base::operation_test {
namespace {

using test::Watcher;

Status status_of(const auto& body) {
    try {
        body();
    } catch (const Error& error) {
        return error.status();
    }
    return Status::ok;
}

TEST(Operation, ProgressNeverFallsAndIsClamped) {
    Operation operation;
    operation.begin();
    operation.report(0.5);
    operation.report(0.25);
    EXPECT_EQ(operation.progress(), 0.5);
    operation.report(7.0);
    EXPECT_EQ(operation.progress(), 1.0);
    operation.begin();
    EXPECT_EQ(operation.progress(), 0.0);
    operation.report(-1.0);
    EXPECT_EQ(operation.progress(), 0.0);
}

TEST(Operation, TheCallbackSeesARisingProgress) {
    Operation operation;
    Watcher watcher;
    operation.set_callback(Watcher::call, &watcher);
    operation.begin();
    for (const double progress : {0.1, 0.4, 0.2, 0.9}) operation.report(progress);
    EXPECT_EQ(watcher.values, (std::vector<double>{0.1, 0.4, 0.4, 0.9}));
}

TEST(Operation, TheCallbackRunsOnlyOnTheThreadThatEntered) {
    Operation operation;
    Watcher watcher;
    operation.set_callback(Watcher::call, &watcher);
    operation.begin();
    std::thread([&] { operation.report(0.5); }).join();
    EXPECT_TRUE(watcher.values.empty());
    EXPECT_EQ(operation.progress(), 0.5);
}

TEST(Operation, ACallbackCanCancel) {
    Operation operation;
    Watcher watcher;
    watcher.cancel_at_call = 2;
    operation.set_callback(Watcher::call, &watcher);
    operation.begin();
    const Progress progress(&operation);
    progress.update(0.1);
    EXPECT_EQ(status_of([&] { progress.update(0.2); }), Status::cancelled);
    EXPECT_TRUE(operation.is_cancelled());
}

TEST(Operation, StaysCancelled) {
    Operation operation;
    operation.cancel();
    EXPECT_EQ(status_of([&] { operation.begin(); }), Status::cancelled);
    EXPECT_EQ(status_of([&] { Progress(&operation).check(); }), Status::cancelled);
}

TEST(Progress, PartsCanBeNested) {
    Operation operation;
    operation.begin();
    const Progress half = Progress(&operation).part(0.5, 1.0);
    half.update(0.5);
    EXPECT_DOUBLE_EQ(operation.progress(), 0.75);
    half.part(0.5, 0.75).update(1.0);
    EXPECT_DOUBLE_EQ(operation.progress(), 0.875);
}

TEST(Progress, WithoutAnOperationNothingHappens) {
    const Progress progress;
    progress.update(0.5);
    progress.check();
    progress.part(0.0, 0.5).update(1.0);
}

// While progress stands still, a check for a cancel calls the callback again after a while.
TEST(Operation, CallsBackWhileProgressStandsStill) {
    Watcher watcher;
    Operation operation;
    operation.set_callback(Watcher::call, &watcher);
    operation.begin();
    const Progress progress(&operation);
    progress.update(0.25);
    for (int i = 0; i < 100; ++i) progress.check();
    EXPECT_LT(watcher.values.size(), 50U);
    const std::size_t before = watcher.values.size();
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    progress.check();
    ASSERT_EQ(watcher.values.size(), before + 1);
    EXPECT_EQ(watcher.values.back(), 0.25);
    watcher.cancel_at = 0.0;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    EXPECT_THROW(progress.check(), Error);
}

TEST(SortLong, GivesTheResultOfStdSort) {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < 300000; ++i) numbers.push_back(i * 0x9E3779B97F4A7C15U);
    std::vector<std::uint64_t> sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    sort_long(numbers.data(), numbers.data() + numbers.size(), std::less<>());
    EXPECT_EQ(numbers, sorted);
}

TEST(SortOnThreads, GivesTheResultOfStdSort) {
    for (const int threads : {1, 3}) {
        const Runtime runtime = test::with_threads(threads);
        for (const std::uint64_t count : {0U, 1U, 40000U, 65536U, 250001U}) {
            Array<std::uint64_t> numbers(runtime.memory);
            for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(i * 0x9E3779B97F4A7C15U);
            std::vector<std::uint64_t> sorted(numbers.begin(), numbers.end());
            std::sort(sorted.begin(), sorted.end());
            sort_on_threads(runtime, numbers, std::less<>());
            EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), sorted.begin(), sorted.end())) << count;
        }
    }
}

TEST(ResizeLong, FillsWithZerosAndCanBeCancelled) {
    Memory memory;
    Array<std::int32_t> numbers(memory, 2);
    numbers[1] = 7;
    resize_long(numbers, 3'000'000, {});
    ASSERT_EQ(numbers.size(), 3'000'000);
    EXPECT_EQ(numbers[1], 7);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 0), 3'000'000 - 1);
    resize_long(numbers, 5, {});
    EXPECT_EQ(numbers.size(), 5);
    Operation operation;
    operation.cancel();
    EXPECT_EQ(status_of([&] { resize_long(numbers, 3'000'000, Progress(&operation)); }), Status::cancelled);
}

TEST(LongArray, GrowsLikeAnArrayAndCanBeCancelled) {
    Memory memory;
    Array<std::int64_t> numbers(memory), same(memory);
    for (std::int64_t i = 0; i < 2'000'000; ++i) {
        push_back_long(numbers, 3 * i, {});
        same.push_back(3 * i);
    }
    ASSERT_EQ(numbers.size(), same.size());
    EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), same.begin()));
    Operation operation;
    operation.begin();
    operation.cancel();
    EXPECT_EQ(status_of([&] {
                  for (std::int64_t i = 0; i < 2'000'000; ++i) push_back_long(numbers, i, Progress(&operation));
              }),
              Status::cancelled);
    EXPECT_EQ(numbers[1'999'999], 3 * 1'999'999);
}

TEST(LongArray, CanBeRefilledAndCancelled) {
    Memory memory;
    Array<std::int64_t> numbers(memory, 7);
    fill_long(numbers, 1'200'000, std::int64_t{-1}, {});
    ASSERT_EQ(numbers.size(), 1'200'000);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), -1), 1'200'000);
    fill_long(numbers, 3, std::int64_t{5}, {});
    ASSERT_EQ(numbers.size(), 3);
    EXPECT_EQ(numbers[2], 5);
    Operation operation;
    operation.begin();
    operation.cancel();
    EXPECT_EQ(status_of([&] { fill_long(numbers, 3, std::int64_t{5}, Progress(&operation)); }), Status::cancelled);
}

TEST(MergeLong, GivesTheResultOfStdMergeAndCanBeCancelled) {
    std::vector<int> a, b;
    for (int i = 0; i < 200000; ++i) (i % 7 < 3 ? a : b).push_back(i / 2);
    std::vector<int> merged(a.size() + b.size()), expected(merged.size());
    std::merge(a.begin(), a.end(), b.begin(), b.end(), expected.begin());
    const auto merge = [&](const Progress& progress) {
        merge_long(a.data(), a.data() + a.size(), b.data(), b.data() + b.size(), merged.data(), std::less<>(),
                   progress);
    };
    merge({});
    EXPECT_EQ(merged, expected);
    Operation operation;
    operation.cancel();
    EXPECT_EQ(status_of([&] { merge(Progress(&operation)); }), Status::cancelled);
}

} // namespace
} // namespace hrbfnpr::base::operation_test
