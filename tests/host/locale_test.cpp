// SPDX-License-Identifier: MIT
// Tests a host whose locale writes 0,5: the library does not change the locale, and the locale changes no byte.
#include "host/calls.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale.h>
#include <locale>
#include <string>

namespace host_test::locale_test {
namespace {

const char* const german = "de_DE.UTF-8";

// Makes the locale in a temporary folder, since few machines have it.
class CommaLocale : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "locale.XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        const std::string command =
            "localedef -i de_DE -f UTF-8 --no-archive " + (folder_ / german).string() + " >/dev/null 2>&1";
        static_cast<void>(std::system(command.c_str())); // newlocale() below tells whether it worked
        setenv("LOCPATH", folder_.c_str(), 1);
        german_ = newlocale(LC_ALL_MASK, german, nullptr);
        if (german_ == nullptr) GTEST_SKIP() << "cannot make de_DE.UTF-8 here (Debian: locales)";
    }
    void TearDown() override {
        if (german_ != nullptr) freelocale(german_);
        unsetenv("LOCPATH");
        std::filesystem::remove_all(folder_);
    }
    static std::string half() {
        char text[8];
        std::snprintf(text, sizeof text, "%.1f", 0.5);
        return text;
    }

    std::filesystem::path folder_;
    locale_t german_ = nullptr;
};

// Log and error messages with numbers in them.
std::string messages() {
    std::string all;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.log_user = &all;
    desc.log = [](void* user, std::int32_t level, const char* message) {
        if (level == HRBFNPR_LOG_WARNING) *static_cast<std::string*>(user) += message;
    };
    const Context context = make_context(desc);
    const scenes::Samples samples = scenes::torus(300);
    auto short_of = fit_desc(samples);
    short_of.tolerance = 0.00125;
    short_of.maximum_centres = 40;
    const Model model = fit(context, short_of); // does not reach the tolerance, and warns
    auto bad = made(hrbfnpr_generate_desc_init);
    bad.box_jitter = 0.75;
    hrbfnpr_point_set* none = nullptr;
    auto error = made(hrbfnpr_error_init);
    hrbfnpr_point_set_generate(context.get(), model.get(), &bad, nullptr, &none, &error);
    all += error.message;
    EXPECT_NE(all.find("0.00125"), std::string::npos) << all;
    EXPECT_NE(all.find("0.75"), std::string::npos) << all;
    return all;
}

Bytes session() {
    Bytes bytes = everything(make_context(2));
    const std::string words = messages();
    bytes.insert(bytes.end(), words.begin(), words.end());
    return bytes;
}

TEST_F(CommaLocale, InTheProcessDoesNotChangeResults) {
    const Bytes wanted = session();
    ASSERT_NE(std::setlocale(LC_ALL, german), nullptr);
    EXPECT_EQ(half(), "0,5");
    const Bytes got = session();
    EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), german);
    EXPECT_EQ(half(), "0,5");
    std::setlocale(LC_ALL, "C");
    EXPECT_TRUE(got == wanted);
}

TEST_F(CommaLocale, InTheThreadDoesNotChangeResults) {
    const Bytes wanted = session();
    const locale_t before = uselocale(german_);
    EXPECT_EQ(half(), "0,5");
    const Bytes got = session();
    EXPECT_EQ(uselocale(before), german_);
    EXPECT_TRUE(got == wanted);
}

TEST_F(CommaLocale, InCPlusPlusDoesNotChangeResults) {
    const Bytes wanted = session();
    const std::locale before = std::locale::global(std::locale(german));
    const Bytes got = session();
    EXPECT_EQ(std::locale().name(), german);
    std::locale::global(before);
    EXPECT_TRUE(got == wanted);
}

} // namespace
} // namespace host_test::locale_test
