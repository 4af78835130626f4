// SPDX-License-Identifier: MIT
#include "base/memory.h"
#include "base/runtime.h"
#include "support/allocator.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace hrbfnpr::base::memory_test {
namespace {

using test::Allocator;

TEST(Memory, CountsBytesNowAndAtPeak) {
    Memory memory;
    void* a = memory.allocate(100);
    void* b = memory.allocate(50);
    EXPECT_EQ(memory.bytes_now(), 150);
    memory.deallocate(a, 100);
    EXPECT_EQ(memory.bytes_now(), 50);
    EXPECT_EQ(memory.bytes_peak(), 150);
    memory.deallocate(b, 50);
    EXPECT_EQ(memory.bytes_now(), 0);
}

TEST(Memory, AlignsToCacheLines) {
    Memory memory;
    void* a = memory.allocate(1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a) % Memory::alignment, 0U);
    memory.deallocate(a, 1);
}

#if defined(__linux__)
// Returns the flags of the mapping that contains an address, or an empty string if the system does not tell them.
std::string flags_of(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    const auto place = reinterpret_cast<std::uintptr_t>(address);
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0, end = 0;
        char dash = 0;
        std::istringstream words(line);
        if (words >> std::hex >> begin >> dash >> end && dash == '-') here = begin <= place && place < end;
        if (here && line.rfind("VmFlags:", 0) == 0) return line + " ";
    }
    return "";
}

TEST(Memory, AsksForHugePagesForLargeArrays) {
    if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"))
        GTEST_SKIP() << "this system has no huge pages to ask for";
    constexpr std::uint64_t size = std::uint64_t{64} << 20U;
    Memory memory;
    errno = 7;
    auto* large = static_cast<char*>(memory.allocate(size));
    EXPECT_EQ(errno, 7);
    const std::string flags = flags_of(large + size / 2);
    if (!flags.empty()) {
        EXPECT_NE(flags.find(" hg "), std::string::npos) << flags;
    }
    memory.deallocate(large, size);
}
#endif

TEST(Memory, UsesTheGivenAllocatorWithSizeAndAlignment) {
    Allocator allocator;
    Memory memory(Allocator::allocate, Allocator::deallocate, &allocator);
    {
        const Array<double> array(memory, 10);
        EXPECT_EQ(allocator.bytes, 80);
        EXPECT_EQ(allocator.smallest_alignment, Memory::alignment);
    }
    EXPECT_EQ(allocator.bytes, 0);
}

TEST(Memory, ReportsHowManyBytesWereRefused) {
    Allocator allocator;
    allocator.refuse_at = 1;
    Memory memory(Allocator::allocate, Allocator::deallocate, &allocator);
    try {
        [[maybe_unused]] void* block = memory.allocate(12345);
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::out_of_memory);
        EXPECT_NE(std::string(error.what()).find("12345"), std::string::npos) << error.what();
    }
    EXPECT_EQ(memory.bytes_now(), 0);
}

TEST(Array, NewElementsAreZero) {
    Memory memory;
    Array<int> array(memory, 3);
    array[0] = array[1] = array[2] = 7;
    array.resize(1);
    array.resize(4); // within and beyond the capacity
    EXPECT_EQ(array[0], 7);
    EXPECT_EQ(array[1], 0);
    EXPECT_EQ(array[3], 0);
}

TEST(Array, ResizingForOverwriteKeepsExistingElements) {
    Memory memory;
    Array<int> array(memory, 2);
    array[0] = 7;
    array[1] = 8;
    array.resize_for_overwrite(1000);
    EXPECT_EQ(array.size(), 1000);
    EXPECT_EQ(array[0], 7);
    EXPECT_EQ(array[1], 8);
    array.resize_for_overwrite(1);
    array.resize(2);
    EXPECT_EQ(array[1], 0);
}

TEST(Array, KeepsElementsWhenItGrows) {
    Memory memory;
    Array<std::int64_t> array(memory);
    for (std::int64_t i = 0; i < 1000; ++i) array.push_back(i * i);
    ASSERT_EQ(array.size(), 1000);
    for (std::int64_t i = 0; i < 1000; ++i) ASSERT_EQ(array[i], i * i);
    EXPECT_EQ(array.back(), 999 * 999);
}

TEST(Array, PushesAnElementOfItself) {
    Memory memory;
    Array<int> array(memory);
    for (int i = 0; i < 16; ++i) array.push_back(i + 1);
    array.push_back(array[0]); // the array grows while the argument points into it
    EXPECT_EQ(array.back(), 1);
}

TEST(Array, MovesWithoutCopying) {
    Memory memory;
    Array<int> from(memory, 5);
    from[4] = 9;
    const int* data = from.data();
    Array<int> to(std::move(from));
    EXPECT_EQ(to.data(), data);
    Array<int> other(memory, 2);
    other = std::move(to);
    EXPECT_EQ(other.data(), data);
    EXPECT_EQ(other[4], 9);
}

TEST(Array, ReturnsAllItsMemory) {
    Memory memory;
    {
        Array<double> array(memory, 1000);
        array.resize(100000);
        Array<double> other(std::move(array));
        other.release();
        EXPECT_EQ(memory.bytes_now(), 0);
        EXPECT_TRUE(other.empty());
        other.push_back(1.0); // usable again
    }
    EXPECT_EQ(memory.bytes_now(), 0);
}

TEST(Array, RefusesSizesBeyondAnyMemory) {
    Memory memory;
    Array<double> array(memory);
    EXPECT_THROW(array.resize(std::int64_t{1} << 61), Error);
    EXPECT_THROW(array.resize(std::int64_t{1} << 62), Error);
    EXPECT_EQ(array.size(), 0);
}

TEST(Array, IsUnchangedWhenTheAllocatorRefuses) {
    Allocator allocator;
    allocator.refuse_at = 2;
    Memory memory(Allocator::allocate, Allocator::deallocate, &allocator);
    Array<int> array(memory, 4);
    array[3] = 42;
    EXPECT_THROW(array.resize(100), Error);
    EXPECT_EQ(array.size(), 4);
    EXPECT_EQ(array[3], 42);
}

TEST(Runtime, LogsFormattedMessages) {
    struct Seen {
        std::int32_t level = -1;
        std::string text;
    } seen;
    const LogFn log = [](void* user, std::int32_t level, const char* message) {
        *static_cast<Seen*>(user) = {level, message};
    };
    const Runtime runtime(nullptr, nullptr, nullptr, Parallel(), InstructionSet::automatic, log, &seen);
    runtime.log(LogLevel::warning, "%d samples", 12);
    EXPECT_EQ(seen.level, 2);
    EXPECT_EQ(seen.text, "12 samples");
    Runtime().log(LogLevel::info, "nobody listens");
}

} // namespace
} // namespace hrbfnpr::base::memory_test
