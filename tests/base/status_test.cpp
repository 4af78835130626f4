// SPDX-License-Identifier: MIT
#include "base/status.h"

#include <gtest/gtest.h>

#include <string>

namespace hrbfnpr::status_test {
namespace {

std::string cut(const std::string& text, int capacity) {
    char buffer[16];
    copy_message(buffer, capacity, text.c_str());
    return buffer;
}

TEST(Status, MessagesAreCutAtACharacter) {
    EXPECT_EQ(cut("abc", 8), "abc");
    EXPECT_EQ(cut("abcdefg", 8), "abcdefg");
    EXPECT_EQ(cut("abcdefgh", 8), "abcdefg");
    EXPECT_EQ(cut("abcdef\u00e9", 8), "abcdef");    // a two-byte character with room for one byte
    EXPECT_EQ(cut("abcd\u20acx", 8), "abcd\u20ac"); // a three-byte character that just fits
    EXPECT_EQ(cut("abcde\u20acx", 8), "abcde");     // a three-byte character with room for two bytes
    EXPECT_EQ(cut("abcd\U0001F600", 8), "abcd");    // a four-byte character with room for three bytes
    EXPECT_EQ(cut("\U0001F600\U0001F600", 4), "");  // not even one fits
    EXPECT_EQ(cut("abc", 1), "");
}

TEST(Status, ErrorsHoldTheirMessageInPlace) {
    const Error error(Status::io, std::string(1000, 'x').c_str());
    EXPECT_EQ(error.status(), Status::io);
    EXPECT_EQ(std::string(error.what()), std::string(247, 'x'));
}

TEST(Status, FailFormatsItsMessage) {
    try {
        fail(Status::singular_system, "%d of %s", 3, "four");
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::singular_system);
        EXPECT_STREQ(error.what(), "3 of four");
        return;
    }
    FAIL() << "no exception";
}

} // namespace
} // namespace hrbfnpr::status_test
