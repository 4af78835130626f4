// SPDX-License-Identifier: MIT
// Tests that the boundary passes every field of a style to the frame: the frame's style is turned back into the public
// struct, and must equal the original.
#include "api/struct_fields.h"
#include "api/style_fields.h"
#include "support/named_style.h"

#include <cstring>
#include <gtest/gtest.h>
#include <span>
#include <string_view>
#include <vector>

namespace hrbfnpr::frame::style_fields_test {
namespace {

using api::FieldLayout;
using testing::NamedStyle;
using testing::preset_count;

using Fields = std::span<const FieldLayout>;

// Fields of the public structs that the frame has in another form, or not at all.
bool is_of_boundary(std::string_view name) {
    return name == "struct_size" || name.starts_with("reserved") || name == "levels" || name == "layers" ||
           name == "lines" || name.ends_with("_count") || name.ends_with("_stride");
}

template <class Given>
void expect_equal_fields(const Given& back, const Given& given, Fields fields, const char* name) {
    for (const FieldLayout& field : fields) {
        const auto bytes = [&](const Given& of) { return reinterpret_cast<const std::byte*>(&of) + field.offset; };
        if (is_of_boundary(field.name)) continue;
        EXPECT_EQ(std::memcmp(bytes(back), bytes(given), field.size), 0) << name << ": " << field.name;
    }
}

void expect_same_style(const Style& style, const hrbfnpr_style& given, const char* name) {
    hrbfnpr_style back{};
    api::style_fields().set_defaults(style, back);
    expect_equal_fields(back, given, api::fields_of_hrbfnpr_style, name);
    ASSERT_EQ(std::ssize(style.layers), given.layer_count);
    for (std::size_t i = 0; i < style.layers.size(); ++i) {
        hrbfnpr_layer_style layer{};
        api::layer_style_fields().set_defaults(style.layers[i], layer);
        expect_equal_fields(layer, given.layers[i], api::fields_of_hrbfnpr_layer_style, name);
    }
    ASSERT_EQ(std::ssize(style.lines), given.line_count);
    for (std::size_t i = 0; i < style.lines.size(); ++i) {
        hrbfnpr_line_style line{};
        api::line_style_fields().set_defaults(style.lines[i], line);
        expect_equal_fields(line, given.lines[i], api::fields_of_hrbfnpr_line_style, name);
        EXPECT_EQ(std::ssize(style.lines[i].levels), given.lines[i].levels.count);
        EXPECT_EQ(static_cast<const void*>(style.lines[i].levels.data()), given.lines[i].levels.data);
    }
}

TEST(StyleFields, NamedStylesReachTheFrame) {
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        const NamedStyle named(i);
        expect_same_style(named.style, named.given, named.name);
    }
}

// Sets every number of a struct to an allowed number that differs from its default.
template <class Given>
Given with_other_values(Given given, Fields fields) {
    for (const FieldLayout& field : fields) {
        if (is_of_boundary(field.name)) continue;
        std::byte* const at = reinterpret_cast<std::byte*>(&given) + field.offset;
        const std::string_view type = field.type;
        const auto set = [&](auto number) {
            for (std::size_t i = 0; i + sizeof number <= field.size; i += sizeof number) {
                decltype(number) now;
                std::memcpy(&now, at + i, sizeof now);
                const decltype(number) other = now == number ? number / 2 : number;
                std::memcpy(at + i, &other, sizeof other);
            }
        };
        if (type.starts_with("float")) set(0.75F);
        if (type.starts_with("double")) set(0.75);
        if (type == "uint32_t") set(std::uint32_t{1});
    }
    return given;
}

TEST(StyleFields, AllFieldsOfAnyStyleReachTheFrame) {
    constexpr double levels[] = {-0.5, 0.0, 0.5};
    hrbfnpr_layer_style layer = with_other_values(api::default_layer_style(), api::fields_of_hrbfnpr_layer_style);
    layer.name = "fur";
    layer.hatch_tone_begin = 0.25F; // less than the end
    hrbfnpr_line_style line = with_other_values(api::default_line_style(), api::fields_of_hrbfnpr_line_style);
    line.name = "seam";
    line.kind = HRBFNPR_LINE_KIND_ISOPHOTE;
    line.levels = {levels, std::size(levels), sizeof(double), HRBFNPR_SCALAR_FLOAT64, 1};
    line.wobble_length = 55.0F; // at least 1
    hrbfnpr_style given = with_other_values(api::default_style(), api::fields_of_hrbfnpr_style);
    double touched = 0.0;
    given.tone_user = &touched;
    given.tone_function = [](void*, std::int64_t, const float*, const float*, float*) { return std::int32_t{0}; };
    given.depth_max = 2.0;   // beyond depth_min
    given.tone_white = 1.5F; // above tone_black
    given.tone_steps = 3;
    given.light_softness = 0.25F;
    given.layers = &layer;
    given.layer_count = 1;
    given.lines = &line;
    given.line_count = 1;
    base::Memory memory;
    api::StyleLists lists(memory);
    Style style = api::checked_style(given, "style", lists);
    style.layers = lists.layers.span();
    style.lines = lists.lines.span();
    style.lights = lists.lights.span();
    expect_same_style(style, given, "any");
}

} // namespace
} // namespace hrbfnpr::frame::style_fields_test
