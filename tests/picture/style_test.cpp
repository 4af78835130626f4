// SPDX-License-Identifier: MIT
#include "picture/style.h"

#include "picture/handles.h"

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <string>

namespace picture_tests::style_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class StyleTest : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};
};

hrbfnpr_layer_style layer_for(std::uint32_t kind, const char* name = nullptr) {
    auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    layer.kind = kind;
    layer.name = name;
    return layer;
}

TEST_F(StyleTest, NamedStylesCopyTheLibrarysStyles) {
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        hrbfnpr_style named;
        call([&](hrbfnpr_error* error) { return hrbfnpr_style_init_preset(&named, sizeof named, preset, error); });
        const Style style(preset, pool);
        const hrbfnpr_style view = style.view();
        ASSERT_EQ(view.layer_count, named.layer_count);
        ASSERT_EQ(view.line_count, named.line_count);
        EXPECT_EQ(view.tone_exponent, named.tone_exponent);
        for (std::int64_t i = 0; i < view.layer_count; ++i) {
            const hrbfnpr_layer_style& from = named.layers[i];
            EXPECT_EQ(view.layers[i].kind, from.kind);
            EXPECT_EQ(view.layers[i].radius, from.radius);
            ASSERT_EQ(view.layers[i].name == nullptr, from.name == nullptr);
            if (from.name == nullptr) continue;
            EXPECT_NE(view.layers[i].name, from.name);
            EXPECT_STREQ(view.layers[i].name, from.name);
        }
    }
    EXPECT_THROW(Style(99, pool), Error);
}

TEST_F(StyleTest, AKindOfLayersGetsItsOwnElement) {
    Style style(pool);
    style.layers.push_back(layer_for(HRBFNPR_LAYER_KIND_HATCH, "fur"));
    style.layers.push_back(layer_for(HRBFNPR_LAYER_KIND_ANY));
    style.layers[1].radius = 3.0F;
    style.layer(HRBFNPR_LAYER_KIND_HATCH).share = 0.5F;
    ASSERT_EQ(style.layers.size(), 3U);
    EXPECT_EQ(style.layers[1].kind, std::uint32_t{HRBFNPR_LAYER_KIND_HATCH});
    EXPECT_EQ(style.layers[1].radius, 3.0F); // It copies the radius of the element of all kinds.
    EXPECT_EQ(style.layers[2].share, 1.0F);
    EXPECT_EQ(&style.layer(HRBFNPR_LAYER_KIND_HATCH), &style.layers[1]);
    EXPECT_EQ(&style.layer(HRBFNPR_LAYER_KIND_ANY), &style.layers[2]);
    Style empty(pool);
    empty.layer(HRBFNPR_LAYER_KIND_STIPPLES).radius = 2.0F;
    ASSERT_EQ(empty.layers.size(), 1U);
    EXPECT_EQ(empty.layers[0].kind, std::uint32_t{HRBFNPR_LAYER_KIND_STIPPLES});
}

TEST_F(StyleTest, ALayerOfMarksTakesTheFirstMatch) {
    Style style(pool);
    style.layers.push_back(layer_for(HRBFNPR_LAYER_KIND_HATCH, "fur"));
    style.layers[0].radius = 2.0F;
    style.layers.push_back(layer_for(HRBFNPR_LAYER_KIND_STIPPLES));
    style.layers[1].radius = 3.0F;
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_HATCH, "fur").radius, 2.0F);
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_HATCH, nullptr).radius, 1.0F); // These are the defaults.
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_HATCH, "hair").radius, 1.0F);
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_STIPPLES, "dots").radius, 3.0F);
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_OWN, nullptr).kind, std::uint32_t{HRBFNPR_LAYER_KIND_OWN});
}

TEST_F(StyleTest, SettingTheInkSetsEveryInk) {
    Style style(HRBFNPR_PRESET_BLUEPRINT, pool);
    const float ink[4] = {0.25F, 0.5F, 0.75F, 1.0F};
    style.set_ink(ink);
    EXPECT_EQ(style.base.silhouette_ink[1], 0.5F);
    ASSERT_FALSE(style.lines.empty());
    for (const hrbfnpr_line_style& line : style.lines) EXPECT_EQ(line.ink[2], 0.75F);
    for (const hrbfnpr_layer_style& layer : style.layers) EXPECT_EQ(layer.ink[0], 0.25F);
    EXPECT_EQ(style.style_of(HRBFNPR_LAYER_KIND_OWN, nullptr).ink[0], 0.25F); // The element of any kind applies.
}

TEST_F(StyleTest, CopiesShareNothing) {
    std::optional<Style> copy;
    std::optional<Pool> other(std::in_place, memory);
    {
        Pool inner(memory);
        Style style(inner);
        style.layers.push_back(layer_for(HRBFNPR_LAYER_KIND_HATCH, style.keep("fur")));
        auto line = defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
        const std::array levels{0.25, -0.5};
        line.levels = style.keep_levels(levels.data(), levels.size());
        style.lines.push_back(line);
        copy.emplace(style, *other);
        const Style same_pool(style);
        EXPECT_NE(same_pool.layers[0].name, style.layers[0].name);
    }
    EXPECT_STREQ(copy->layers[0].name, "fur");
    EXPECT_EQ(static_cast<const double*>(copy->lines[0].levels.data)[1], -0.5);
    Style assigned(HRBFNPR_PRESET_FULL, pool);
    assigned = Style(*copy, pool);
    copy.reset();
    other.reset();
    EXPECT_STREQ(assigned.layers[0].name, "fur");
    ASSERT_EQ(assigned.lines[0].levels.count, 2);
    EXPECT_EQ(static_cast<const double*>(assigned.lines[0].levels.data)[0], 0.25);
    const Style moved(std::move(assigned));
    EXPECT_STREQ(moved.layers[0].name, "fur");
}

TEST_F(StyleTest, ACallersListIsChecked) {
    auto given = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    given.layer_count = 1;
    EXPECT_THROW(Style(given, pool), Error);
    auto line = defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
    const std::array<double, 3> levels{0.1, 7.0, 0.2};
    line.levels = {levels.data(), 2, 16, HRBFNPR_SCALAR_FLOAT64, 1};
    given.layer_count = 0;
    given.lines = &line;
    given.line_count = 1;
    const Style style(given, pool);
    ASSERT_EQ(style.lines[0].levels.count, 2);
    EXPECT_EQ(static_cast<const double*>(style.lines[0].levels.data)[1], 0.2); // The style packs the levels.
    line.levels.components = 3;
    EXPECT_THROW(Style(given, pool), Error);
}

TEST_F(StyleTest, EqualMarksCompareEqual) {
    Marks marks(pool);
    const std::array points{1.0, 2.0, 3.0};
    marks.set_seed_points({points.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 3});
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    layer.name = marks.keep("fur");
    marks.layers.push_back(layer);
    Pool other(memory);
    Marks copy(marks, other);
    EXPECT_TRUE(copy.same_as(marks));
    EXPECT_NE(copy.base.seed_points.data, marks.base.seed_points.data);
    copy.layers[0].angle = 5.0;
    EXPECT_FALSE(copy.same_as(marks));
    copy = marks;
    EXPECT_TRUE(copy.same_as(marks));
    copy.layers[0].name = nullptr;
    EXPECT_FALSE(copy.same_as(marks));
    copy = marks;
    copy.base.random_seed = 2;
    EXPECT_FALSE(copy.same_as(marks));
    copy = marks;
    copy.set_seed_points({});
    EXPECT_FALSE(copy.same_as(marks));
    copy = marks;
    copy.layers.push_back(layer);
    EXPECT_FALSE(copy.same_as(marks));
}

TEST_F(StyleTest, MarksOfTheSamePaintCompareEqual) {
    const auto painted = [&](double value, const char* direction) {
        Marks marks(pool);
        marks.layers.push_back(defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init));
        auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
        dab.value = value;
        marks.dabs.push_back(dab);
        marks.direction_field = direction;
        return Marks(marks);
    };
    EXPECT_TRUE(painted(0.5, "flow").same_as(painted(0.5, "flow")));
    EXPECT_FALSE(painted(0.5, "flow").same_as(painted(0.25, "flow")));
    EXPECT_FALSE(painted(0.5, "flow").same_as(painted(0.5, "")));
}

TEST_F(StyleTest, FieldsAndInksAreCopied) {
    std::string name = "quality";
    const std::array<float, 8> inks{0.1F, 0.2F, 0.3F, 1.0F, 0.4F, 0.5F, 0.6F, 1.0F};
    auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    layer.mask_field = name.c_str();
    auto given = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    given.layers = &layer;
    given.layer_count = 1;
    given.palette = inks.data();
    given.palette_count = 2;
    Style first(given, pool);
    name = "another";
    const Style copy(first);
    first = Style(pool);
    const hrbfnpr_style view = copy.view();
    EXPECT_STREQ(view.layers[0].mask_field, "quality");
    EXPECT_EQ(view.layers[0].tone_field, nullptr);
    ASSERT_EQ(view.palette_count, 2);
    EXPECT_EQ(view.palette[6], 0.6F);
    given.palette_count = 9;
    EXPECT_THROW(Style(given, pool), Error);
}

} // namespace
} // namespace picture_tests::style_test
