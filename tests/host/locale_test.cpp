// A host in a country that writes 0,5: neither is its locale changed, nor does it change a byte.
#include "host/session.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale.h>
#include <locale>
#include <string>

namespace host_test {
namespace {

const char* const german = "de_DE.UTF-8";

// Makes the locale in a folder of its own, since few machines have it.
class CommaLocale : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "locale.XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        const std::string command =
            "localedef -i de_DE -f UTF-8 --no-archive " + (folder_ / german).string() + " >/dev/null 2>&1";
        static_cast<void>(std::system(command.c_str())); // whether it worked is seen next
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

Bytes session() { return everything(Scene(make_context(2))); }

TEST_F(CommaLocale, OfTheProcess) {
    const Bytes wanted = session();
    ASSERT_NE(std::setlocale(LC_ALL, german), nullptr);
    EXPECT_EQ(half(), "0,5");
    const Bytes got = session();
    EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), german);
    EXPECT_EQ(half(), "0,5");
    std::setlocale(LC_ALL, "C");
    EXPECT_TRUE(got == wanted);
}

TEST_F(CommaLocale, OfTheThread) {
    const Bytes wanted = session();
    const locale_t before = uselocale(german_);
    EXPECT_EQ(half(), "0,5");
    const Bytes got = session();
    EXPECT_EQ(uselocale(before), german_);
    EXPECT_TRUE(got == wanted);
}

TEST_F(CommaLocale, OfCPlusPlus) {
    const Bytes wanted = session();
    const std::locale before = std::locale::global(std::locale(german));
    const Bytes got = session();
    EXPECT_EQ(std::locale().name(), german);
    std::locale::global(before);
    EXPECT_TRUE(got == wanted);
}

} // namespace
} // namespace host_test
