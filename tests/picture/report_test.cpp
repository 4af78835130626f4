// SPDX-License-Identifier: MIT
#include "picture/report.h"

#include "planned_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace picture_tests::report_test {
namespace {

using namespace hrbfnpr::picture;

struct ReportTest : testing::Test {
    Pool& pool = planned.pool;

    PlannedCall planned;
};

TEST_F(ReportTest, CountsHaveTheirNouns) {
    EXPECT_EQ(count_of(1, "sample", pool), "1 sample");
    EXPECT_EQ(count_of(0, "sample", pool), "0 samples");
    EXPECT_EQ(count_of(1, "vertex", pool), "1 vertex");
    EXPECT_EQ(count_of(2, "vertex", pool), "2 vertices");
    EXPECT_STREQ(has_or_have(1), "has");
    EXPECT_STREQ(has_or_have(0), "have");
}

TEST_F(ReportTest, LongNamesAreCutBetweenCharacters) {
    EXPECT_EQ(short_name("a short name", pool), "a short name");
    EXPECT_EQ(short_name("exactly twenty-four char", pool), "exactly twenty-four char");
    EXPECT_EQ(short_name("more than twenty-four chars", pool), "more than twenty-four...");
    EXPECT_EQ(short_name("twenty characters..\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9f", pool),
              "twenty characters..\xc3\xa4...");
}

TEST_F(ReportTest, ANoteHasADetailInTheCallersWords) {
    Report& report = planned.call().report;
    report.note(HRBFNPR_NOTE_GROUPS, {2.0}, "short ({together!} joins)", {.detail = "It is {samples=40} long."});
    report.warn(HRBFNPR_NOTE_BLANK, {}, "another", {.advice = "do {flip!}"});
    const hrbfnpr_note note = described(report.notes[0]);
    EXPECT_STREQ(note.text, "short (--together joins)");
    EXPECT_STREQ(note.detail, "It is --samples 40 long.");
    EXPECT_EQ(note.advice, nullptr);
    const hrbfnpr_note warning = described(report.notes[1]);
    EXPECT_STREQ(warning.advice, "do --flip");
    EXPECT_EQ(warning.detail, nullptr);
}

TEST_F(ReportTest, WhatIsShortDependsOnTheWording) {
    const std::string text = std::string(longest_note - 10, 'x') + "{flip!}"; // --flip, HRBFNPR_PICTURE_FLIP
    EXPECT_TRUE(planned.call().report.is_short(text));
    planned.desc.wording = HRBFNPR_WORDING_FIELDS;
    EXPECT_FALSE(planned.call().report.is_short(text));
}

} // namespace
} // namespace picture_tests::report_test
