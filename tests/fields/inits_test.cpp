// SPDX-License-Identifier: MIT
// Tests the `_init` of every versioned struct, for callers that are older than the library, as old, or newer.
#include "api/struct_fields.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

namespace fields_test::inits_test {
namespace {

// These have no `_init`, or one with special rules (tests/api/version_test.cpp).
constexpr std::nullptr_t hrbfnpr_array_init = nullptr, hrbfnpr_array_out_init = nullptr, hrbfnpr_error_init = nullptr;

// A struct of a newer version: today's struct with a tail.
template <class T>
union Longer {
    T known;
    std::uint8_t bytes[sizeof(T) + 64];
    Longer() { fill(0x55); }
    void fill(int byte) { std::memset(bytes, byte, sizeof bytes); }
};

template <class T>
void try_init(const char* name, hrbfnpr_status (*init)(T*, std::uint32_t)) {
    SCOPED_TRACE(name);
    Longer<T> untouched;
    EXPECT_EQ(init(nullptr, sizeof(T)), HRBFNPR_STATUS_INVALID_ARGUMENT);
    for (const std::uint32_t size : {0U, 4U, 7U, 65537U, 0xFFFFFFFFU})
        EXPECT_EQ(init(&untouched.known, size), HRBFNPR_STATUS_UNSUPPORTED_STRUCT) << size;
    for (const std::uint8_t byte : untouched.bytes) ASSERT_EQ(byte, 0x55);

    // Every byte is filled.
    Longer<T> whole, again;
    again.fill(0xAA);
    EXPECT_EQ(init(&whole.known, sizeof(T)), HRBFNPR_STATUS_OK);
    EXPECT_EQ(init(&again.known, sizeof(T)), HRBFNPR_STATUS_OK);
    EXPECT_EQ(std::memcmp(&whole, &again, sizeof(T)), 0);
    EXPECT_EQ(whole.known.struct_size, sizeof(T));
    EXPECT_EQ(whole.bytes[sizeof(T)], 0x55);

    // Nothing is written after the struct of an older caller.
    for (std::uint32_t size = 8; size < sizeof(T); size += 8) {
        Longer<T> shorter;
        EXPECT_EQ(init(&shorter.known, size), HRBFNPR_STATUS_OK);
        EXPECT_EQ(shorter.known.struct_size, size);
        EXPECT_EQ(std::memcmp(&whole.bytes[4], &shorter.bytes[4], size - 4), 0);
        EXPECT_EQ(shorter.bytes[size], 0x55);
    }

    // The tail of a newer caller's struct is zero.
    Longer<T> longer;
    EXPECT_EQ(init(&longer.known, sizeof longer), HRBFNPR_STATUS_OK);
    EXPECT_EQ(longer.known.struct_size, sizeof longer);
    for (std::size_t i = sizeof(T); i < sizeof longer; ++i) ASSERT_EQ(longer.bytes[i], 0) << i;
}

void try_init(const char* /*name*/, std::nullptr_t /*none*/) {}

TEST(InitFunctions, WorkForOlderAndNewerCallers) {
#define INITS_TEST_STRUCT(record) try_init(#record, record##_init);
    HRBFNPR_STRUCTS(INITS_TEST_STRUCT)
#undef INITS_TEST_STRUCT
}

} // namespace
} // namespace fields_test::inits_test
