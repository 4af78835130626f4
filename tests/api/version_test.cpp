// SPDX-License-Identifier: MIT
#include "fixture.h"

namespace api_test::version_test {
namespace {

TEST(Version, AgreesWithTheHeader) {
    EXPECT_EQ(hrbfnpr_version(), static_cast<std::uint32_t>(HRBFNPR_VERSION_MAJOR * 10000 +
                                                            HRBFNPR_VERSION_MINOR * 100 + HRBFNPR_VERSION_PATCH));
    EXPECT_EQ(hrbfnpr_abi_version(), static_cast<std::uint32_t>(HRBFNPR_ABI_VERSION));
    const std::string text = std::to_string(HRBFNPR_VERSION_MAJOR) + "." + std::to_string(HRBFNPR_VERSION_MINOR) + "." +
                             std::to_string(HRBFNPR_VERSION_PATCH);
    EXPECT_EQ(hrbfnpr_version_string(), text);
}

TEST(Status, EveryNumberHasItsName) {
    const std::vector<std::pair<std::int32_t, std::string>> names = {
        {HRBFNPR_STATUS_OK, "OK"},
        {HRBFNPR_STATUS_INVALID_ARGUMENT, "INVALID_ARGUMENT"},
        {HRBFNPR_STATUS_OUT_OF_MEMORY, "OUT_OF_MEMORY"},
        {HRBFNPR_STATUS_BUFFER_TOO_SMALL, "BUFFER_TOO_SMALL"},
        {HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "UNSUPPORTED_STRUCT"},
        {HRBFNPR_STATUS_SINGULAR_SYSTEM, "SINGULAR_SYSTEM"},
        {HRBFNPR_STATUS_NOT_CONVERGED, "NOT_CONVERGED"},
        {HRBFNPR_STATUS_CANCELLED, "CANCELLED"},
        {HRBFNPR_STATUS_IO, "IO"},
        {HRBFNPR_STATUS_CORRUPT_DATA, "CORRUPT_DATA"},
        {HRBFNPR_STATUS_VERSION_MISMATCH, "VERSION_MISMATCH"},
        {HRBFNPR_STATUS_CALLBACK, "CALLBACK"},
        {HRBFNPR_STATUS_INTERNAL, "INTERNAL"}};
    for (const auto& [number, name] : names) EXPECT_EQ(hrbfnpr_status_name(number), name);
    EXPECT_STREQ(hrbfnpr_status_name(1), "UNKNOWN");
    EXPECT_STREQ(hrbfnpr_status_name(-12), "UNKNOWN");
}

TEST(BuildInfo, IsOneJsonObject) {
    std::int64_t needed = 0;
    EXPECT_EQ(hrbfnpr_build_info(nullptr, 0, &needed), HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    ASSERT_GT(needed, 0);
    std::string text(static_cast<std::size_t>(needed), '?');
    ASSERT_EQ(hrbfnpr_build_info(text.data(), needed, nullptr), HRBFNPR_STATUS_OK);
    EXPECT_EQ(text.back(), '\0');
    text.pop_back();
    EXPECT_EQ(text.front(), '{');
    EXPECT_EQ(text.back(), '}');
    for (const char* key :
         {"version", "abi", "compiler", "instruction_sets", "thread_backends", "dependencies", "Eigen", "GLM"})
        EXPECT_NE(text.find('"' + std::string(key) + "\": "), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '"') % 2, 0);
    EXPECT_EQ(text.find("\"\""), std::string::npos) << "an empty value: " << text;
}

TEST(BuildInfo, WritesNothingIntoABufferThatIsTooSmall) {
    std::string text(8, '?');
    std::int64_t needed = 0;
    EXPECT_EQ(hrbfnpr_build_info(text.data(), 8, &needed), HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    EXPECT_EQ(text, "????????");
    EXPECT_GT(needed, 8);
    EXPECT_EQ(hrbfnpr_build_info(text.data(), -1, &needed), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(hrbfnpr_build_info(nullptr, 8, &needed), HRBFNPR_STATUS_INVALID_ARGUMENT);
}

TEST(ErrorRecord, IsInitializedEmpty) {
    hrbfnpr_error error;
    std::memset(&error, 0x55, sizeof error);
    EXPECT_EQ(hrbfnpr_error_init(&error, sizeof error), HRBFNPR_STATUS_OK);
    EXPECT_EQ(error.struct_size, sizeof error);
    EXPECT_EQ(error.status, HRBFNPR_STATUS_OK);
    EXPECT_STREQ(error.message, "");
    EXPECT_EQ(hrbfnpr_error_init(nullptr, sizeof error), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(hrbfnpr_error_init(&error, 255), HRBFNPR_STATUS_UNSUPPORTED_STRUCT);
}

TEST(ErrorRecord, IsFilledByFailuresAndUntouchedBySuccesses) {
    Error error;
    hrbfnpr_context* context = nullptr;
    EXPECT_EQ(hrbfnpr_context_create(nullptr, nullptr, error), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(error.record.status, HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_STREQ(error.record.message, "out_context is NULL");
    EXPECT_EQ(hrbfnpr_context_create(nullptr, &context, error), HRBFNPR_STATUS_OK);
    EXPECT_STREQ(error.record.message, "out_context is NULL");
    hrbfnpr_context_release(context);
}

TEST(ErrorRecord, IsUntouchedIfNotInitialized) {
    hrbfnpr_error error;
    std::memset(&error, 0x55, sizeof error);
    error.struct_size = 255;
    EXPECT_EQ(hrbfnpr_context_create(nullptr, nullptr, &error), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(error.status, 0x55555555);
    EXPECT_EQ(error.message[0], 0x55);
}

TEST(ErrorRecord, ALargerFutureRecordIsFilledToTheKnownSize) {
    struct Larger {
        hrbfnpr_error error;
        char tail[8];
    } larger;
    std::memset(&larger, 0x55, sizeof larger);
    EXPECT_EQ(hrbfnpr_error_init(&larger.error, sizeof larger), HRBFNPR_STATUS_OK);
    EXPECT_EQ(hrbfnpr_context_create(nullptr, nullptr, &larger.error), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_STREQ(larger.error.message, "out_context is NULL");
}

TEST(ErrorRecord, MayBeNull) {
    EXPECT_EQ(hrbfnpr_context_create(nullptr, nullptr, nullptr), HRBFNPR_STATUS_INVALID_ARGUMENT);
}

} // namespace
} // namespace api_test::version_test
