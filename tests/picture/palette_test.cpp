// SPDX-License-Identifier: MIT
#include "picture/palette.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace picture_tests::palette_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class PaletteTest : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};
    Vector<std::array<float, 3>> colours{&pool};

    // Adds colours around a middle.
    void add(const std::array<float, 3>& middle, int count) {
        for (int i = 0; i < count; ++i) {
            const auto part = static_cast<float>(i);
            colours.push_back({middle[0] + 0.03F * std::sin(part), middle[1] + 0.03F * std::sin(2.0F * part),
                               middle[2] + 0.03F * std::cos(part)});
        }
    }
};

TEST_F(PaletteTest, GroupsOfHuesGetInks) {
    add({0.8F, 0.2F, 0.15F}, 900);
    add({0.2F, 0.35F, 0.85F}, 60);
    add({0.85F, 0.8F, 0.3F}, 300);
    const Vector<std::array<float, 4>> inks = inks_of(colours, pool);
    ASSERT_EQ(inks.size(), 3U);
    const auto count_of = [&](auto&& is_wanted) { return std::count_if(inks.begin(), inks.end(), is_wanted); };
    const auto is_red = [](const auto& ink) { return ink[0] > 2.0F * std::max(ink[1], ink[2]) && ink[0] < 0.75F; };
    const auto is_blue = [](const auto& ink) { return ink[2] > 2.0F * std::max(ink[0], ink[1]); };
    const auto is_yellow = [](const auto& ink) { return ink[1] > 0.8F * ink[0] && ink[1] > 4.0F * ink[2]; };
    EXPECT_EQ(count_of(is_red), 1);
    EXPECT_EQ(count_of(is_blue), 1);
    EXPECT_EQ(count_of(is_yellow), 1);
    for (const auto& ink : inks) EXPECT_EQ(ink[3], 1.0F);
    EXPECT_EQ(inks_of(colours, pool), inks);
}

TEST_F(PaletteTest, ColoursOfOneHueGetOneInk) {
    colours.assign(50, {0.5F, 0.5F, 0.5F});
    ASSERT_EQ(inks_of(colours, pool).size(), 1U);
    const std::array<float, 4> ink = inks_of(colours, pool)[0];
    EXPECT_NEAR(ink[0], ink[1], 1e-4F);
    EXPECT_NEAR(ink[0], ink[2], 1e-4F);
    EXPECT_LT(ink[0], 0.5F);
    colours.push_back({0.0F, 0.0F, 0.0F}); // It has another lightness, which is a matter of the tone.
    EXPECT_EQ(inks_of(colours, pool).size(), 1U);
    colours.push_back({0.9F, 0.1F, 0.1F});
    EXPECT_EQ(inks_of(colours, pool).size(), 2U);
}

TEST_F(PaletteTest, AFewHuesEachGetAnInk) {
    for (int i = 0; i < 6; ++i) {
        const double turn = i * 2.0 * 3.14159265 / 6.0;
        std::array<float, 3> colour{};
        for (std::size_t k = 0; k < 3; ++k)
            colour[k] = static_cast<float>(0.5 + 0.4 * std::cos(turn + 2.0944 * static_cast<double>(k)));
        for (int repeat = 0; repeat < 40; ++repeat) colours.push_back(colour);
    }
    EXPECT_EQ(inks_of(colours, pool).size(), 6U);
    add({0.8F, 0.2F, 0.15F}, 60); // Many hues share three inks.
    EXPECT_EQ(inks_of(colours, pool).size(), 3U);
}

} // namespace
} // namespace picture_tests::palette_test
