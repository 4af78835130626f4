// SPDX-License-Identifier: MIT
#include "picture/lights.h"

#include "picture/handles.h"
#include "picture/plan.h"
#include "planned_call.h"

#include <gtest/gtest.h>

namespace picture_tests::lights_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

Style style_of(const char* light, std::initializer_list<std::pair<const char*, const char*>> more = {}) {
    static base::Memory memory;
    static Pool pool(memory);
    PlannedCall planned(HRBFNPR_PRESET_STIPPLE);
    planned.change("style.light", light);
    for (const auto& [field, value] : more) planned.change(field, value);
    return {plan_style(planned.call(), 100.0, 100.0, false), pool};
}

TEST(Lights, DirectionSetsTheSingleLight) {
    const Style style = style_of("1,2,3");
    EXPECT_TRUE(style.lights.empty());
    EXPECT_EQ(style.base.light[1], 2.0);
}

TEST(Lights, ListTakesWhatItDoesNotSayFromTheStyle) {
    const Style style =
        style_of("1,2,3:shadow=0.5;0,0,-4:place,space=item,intensity=2",
                 {{"style.light_shadow", "1"}, {"style.light_space", "world"}, {"style.light_softness", "0.1"}});
    ASSERT_EQ(style.lights.size(), 2U);
    EXPECT_EQ(style.lights[0].space, std::uint32_t{HRBFNPR_LIGHT_WORLD});
    EXPECT_EQ(style.lights[0].shadow, 0.5F);
    EXPECT_EQ(style.lights[0].intensity, style.base.light_intensity);
    EXPECT_EQ(style.lights[1].kind, std::uint32_t{HRBFNPR_LIGHT_KIND_PLACE});
    EXPECT_EQ(style.lights[1].space, std::uint32_t{HRBFNPR_LIGHT_ITEM});
    EXPECT_EQ(style.lights[1].place[2], -4.0);
    EXPECT_EQ(style.lights[1].intensity, 2.0F);
    EXPECT_EQ(style.lights[1].shadow, 0.0F);
    EXPECT_EQ(style.lights[1].softness, 0.1F);
    EXPECT_EQ(style_of("1,2,3:").lights.size(), 1U);
}

TEST(Lights, WrongTextsAreRefused) {
    for (const char* text : {"1,2:", "1,2,3:shade=1", "1,2,3:shadow=2", "1,2,3:place=x", "0,0,0:", "1,2,3;;", ";1,2,3",
                             "1,1,1;1,1,1;1,1,1;1,1,1;1,1,1;1,1,1;1,1,1;1,1,1;1,1,1"}) {
        SCOPED_TRACE(text);
        EXPECT_THROW(static_cast<void>(style_of(text)), Error);
    }
    EXPECT_NO_THROW(static_cast<void>(style_of("0,0,0:place")));
}

} // namespace
} // namespace picture_tests::lights_test
