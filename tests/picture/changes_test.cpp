// SPDX-License-Identifier: MIT
#include "picture/changes.h"
#include "picture/field_table.h"
#include "picture/handles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace hrbfnpr::picture::changes_test {
namespace {

struct ChangesTest : testing::Test {
    using Pair = std::pair<const char*, const char*>;

    [[nodiscard]] Changes changes(std::initializer_list<Pair> given) {
        std::vector<hrbfnpr_change> list;
        for (const auto& [field, value] : given) list.push_back({sizeof(hrbfnpr_change), 0, field, value});
        return {list.data(), static_cast<std::int64_t>(list.size()), 0, pool};
    }
    [[nodiscard]] std::string refused(const char* field, const char* value) {
        try {
            static_cast<void>(changes({{field, value}}));
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "";
    }
    // Returns a default layer style with one field changed.
    [[nodiscard]] hrbfnpr_layer_style layer_style(const char* field, const char* value) {
        auto style = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
        const std::string path = std::string("style.hatch.") + field;
        changes({{path.c_str(), value}}).apply("style.hatch", style);
        return style;
    }

    base::Memory memory;
    Pool pool{memory};
};

TEST_F(ChangesTest, FieldsAreSetByTheirNames) {
    const Changes given = changes({{"fit.kernel", "wendland-c2"},
                                   {"fit.kernel_radius", " 2.5 "},
                                   {"FIT.Polynomial-Degree", "-1"},
                                   {"fit.maximum_centres", "1e6"},
                                   {"mesh_fit.tolerance", "3"},
                                   {"mesh_fit.random_seed", "18446744073709551615"}});
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    given.apply("fit", fit);
    EXPECT_EQ(fit.kernel, std::uint32_t{HRBFNPR_KERNEL_WENDLAND_C2});
    EXPECT_EQ(fit.kernel_radius, 2.5);
    EXPECT_EQ(fit.polynomial_degree, -1);
    EXPECT_EQ(fit.maximum_centres, 1'000'000);
    EXPECT_EQ(fit.tolerance, 0.0) << "it is that of the other section";
    auto mesh_fit = defaults<hrbfnpr_mesh_fit_desc>(hrbfnpr_mesh_fit_desc_init);
    given.apply("mesh_fit", mesh_fit);
    EXPECT_EQ(mesh_fit.tolerance, 3.0);
    EXPECT_EQ(mesh_fit.random_seed, std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(given.value("fit.kernel"), "wendland_c2");
    EXPECT_EQ(given.number("fit.kernel"), 2.0);
    EXPECT_EQ(given.number("fit.polynomial_degree"), -1.0);
    EXPECT_FALSE(given.has("fit.solver"));
    EXPECT_FALSE(given.number("fit.solver"));
}

TEST_F(ChangesTest, ValuesAreReadInEveryNotation) {
    for (const char* ink : {"#ff8000", "#FF8000ff", "1,0.50196078431372548,0", "1, 0.50196078431372548, 0, 1"}) {
        const hrbfnpr_layer_style style = layer_style("ink", ink);
        EXPECT_EQ(style.ink[0], 1.0F) << ink;
        EXPECT_FLOAT_EQ(style.ink[1], 128.0F / 255.0F) << ink;
        EXPECT_EQ(style.ink[2], 0.0F) << ink;
        EXPECT_EQ(style.ink[3], 1.0F) << ink;
    }
    EXPECT_EQ(layer_style("ink", "#00000000").ink[3], 0.0F);
    for (const char* yes : {"1", "true", "True"}) EXPECT_EQ(layer_style("shown", yes).shown, 1U) << yes;
    for (const char* no : {"0", "false"}) EXPECT_EQ(layer_style("shown", no).shown, 0U) << no;
    EXPECT_EQ(layer_style("directions", "first").directions, 1U);
    EXPECT_EQ(layer_style("directions", "second,first").directions, 3U);
    EXPECT_EQ(layer_style("directions", "2").directions, 2U);
    EXPECT_EQ(layer_style("shape", "1").shape, std::uint32_t{HRBFNPR_SHAPE_STROKES});
    EXPECT_EQ(layer_style("name", "fur").kind, std::uint32_t{HRBFNPR_LAYER_KIND_ANY});

    auto style = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    changes({{"style.light", "-y"}}).apply("style", style);
    EXPECT_EQ(style.light[0], 0.0);
    EXPECT_EQ(style.light[1], -1.0);
    changes({{"style.light", "1,-2,+3e-1"}}).apply("style", style);
    EXPECT_EQ(style.light[1], -2.0);
    EXPECT_EQ(style.light[2], 0.3);
    const Changes ink = changes({{"style.ink", "#0000ff"}});
    EXPECT_EQ(ink.colour("style.ink")->at(2), 1.0F);
    EXPECT_FALSE(ink.colour("style.paper"));
}

TEST_F(ChangesTest, NamesAreSetAndCleared) {
    const Changes given = changes({{"marks.hatch.name", "fur"}, {"marks.stipples.name", ""}});
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    given.apply("marks.hatch", layer);
    EXPECT_STREQ(layer.name, "fur");
    given.apply("marks.stipples", layer);
    EXPECT_EQ(layer.name, nullptr);
}

TEST_F(ChangesTest, LaterChangesWin) {
    Vector<std::pair<String, String>> of_settings(&pool);
    of_settings.emplace_back("fit.kernel", "gaussian");
    of_settings.emplace_back("fit.tolerance", "0.5");
    const hrbfnpr_change own[] = {{sizeof(hrbfnpr_change), 0, "fit.kernel", "triharmonic"},
                                  {sizeof(hrbfnpr_change), 0, "fit.kernel", "wendland_c2"}};
    const Changes given(of_settings, own, 2, 0, pool);
    EXPECT_EQ(given.from_settings(), 2U);
    EXPECT_EQ(given.list().size(), 4U);
    EXPECT_EQ(given.value("fit.kernel"), "wendland_c2");
    EXPECT_TRUE(given.is_callers("fit.kernel"));
    EXPECT_FALSE(given.is_callers("fit.tolerance"));
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    given.apply("fit", fit);
    EXPECT_EQ(fit.kernel, std::uint32_t{HRBFNPR_KERNEL_WENDLAND_C2});
    EXPECT_EQ(fit.tolerance, 0.5);
}

TEST_F(ChangesTest, RegularizationAlsoSetsItsMode) {
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    const Changes automatic = changes({{"fit.regularization", "0.25"}, {"fit.regularization", "Auto"}});
    automatic.apply("fit", fit);
    EXPECT_EQ(fit.regularization_mode, std::uint32_t{HRBFNPR_REGULARIZATION_AUTO});
    EXPECT_EQ(fit.regularization, 0.0);
    EXPECT_FALSE(automatic.number("fit.regularization"));
    EXPECT_EQ(automatic.value("fit.regularization"), "auto");
    changes({{"fit.regularization", "0.25"}}).apply("fit", fit);
    EXPECT_EQ(fit.regularization_mode, std::uint32_t{HRBFNPR_REGULARIZATION_GIVEN});
    EXPECT_EQ(fit.regularization, 0.25);
    changes({{"fit.regularization_mode", "auto"}, {"fit.normal_mode", "none"}}).apply("fit", fit);
    EXPECT_EQ(fit.regularization, 0.0) << "the mode wants none";
    EXPECT_EQ(fit.normal_mode, std::uint32_t{HRBFNPR_NORMALS_GIVEN}) << "options tell of normals";
}

TEST_F(ChangesTest, AShareOfAllLayersIsMultiplied) {
    auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    layer.share = 0.5F;
    changes({{"style.layers.share", "0.5"}}).apply("style.layers", layer);
    EXPECT_EQ(layer.share, 0.25F);
    changes({{"style.hatch.share", "0.5"}}).apply("style.hatch", layer);
    EXPECT_EQ(layer.share, 0.5F);
}

TEST_F(ChangesTest, PathsOfAllStepsAreAccepted) {
    const Changes given = changes({{"style.ink", "#ff8000"},
                                   {"style.lines.wobble", "2"},
                                   {"style.layers.shape", "dots"},
                                   {"style.any.radius", "3"},
                                   {"marks.layers.tone_smoothing", "0.01"},
                                   {"marks.layers.flags", "curvature"},
                                   {"marks.seed-source", "Points"},
                                   {"line_set.support", "1.5"}});
    EXPECT_EQ(given.value("style.ink"), "#ff8000");
    EXPECT_EQ(given.value("marks.seed_source"), "points");
    EXPECT_EQ(given.number("marks.layers.flags"), double{HRBFNPR_LAYER_WITH_CURVATURE});
    auto style = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    const hrbfnpr_style before = style;
    given.apply("style", style);
    EXPECT_EQ(std::memcmp(&before, &style, sizeof style), 0);
}

TEST_F(ChangesTest, InvalidChangesAreNamed) {
    const std::pair<ChangesTest::Pair, const char*> cases[] = {
        {{"style.halo", "1"},
         "changes[0].field is \"style.halo\"; hrbfnpr_style has no field halo: there are halo_width,"},
        {{"fit.kernels", "1"}, "hrbfnpr_fit_desc has no field kernels: there are kernel, kernel_radius,"},
        {{"line_set.cell", "1"}, "hrbfnpr_line_set_desc has no field cell: there are flags, cell_size, support"},
        {{"look.halo", "1"}, "must begin with one of style., fit., mesh_fit., marks., line_set."},
        {{"style", "1"}, "must begin with one of style."},
        {{"", "1"}, "must begin with"},
        {{"style.hach.ink", "1"},
         "there are no layers hach; there are any, stipples, hatch, own, layers, ground, lines"},
        {{"marks.own.budget", "1"}, "there are no layers own; there are stipples,"},
        {{"style.hatch.kind", "any"}, "has no field kind"},
        {{"style.hatch.ink.x", "1"}, "has no field ink.x"},
        {{"style.layer_count", "1"}, "has no field layer_count"},
        {{"style.halo_width", "wide"}, "changes[0].value of style.halo_width is \"wide\"; it must be a finite number"},
        {{"style.halo_width", "1e39"}, "must be a finite number"},
        {{"style.halo_width", "nan"}, "must be a finite number"},
        {{"style.halo_width", "1,2"}, "must be a finite number"},
        {{"style.halo_width", ""}, "must be a finite number"},
        {{"style.tone", "callback"}, "must be one of none, light"},
        {{"style.tone", "2"}, "must be one of none, light"},
        {{"style.paper", "#12345"}, "must be #rrggbb, #rrggbbaa, or 3 or 4 numbers"},
        {{"style.paper", "#12345g"}, "must be #rrggbb"},
        {{"style.paper", "1,1"}, "must be #rrggbb"},
        {{"style.ink", "red"}, "changes[0].value of style.ink is \"red\"; it must be #rrggbb"},
        {{"style.light", "0,0,0"}, "not all 0"},
        {{"style.light", "w"}, "must be x, y or z"},
        {{"style.hatch.shown", "2"}, "must be true or false"},
        {{"style.hatch.directions", "third"}, "must be with commas between, of first, second"},
        {{"style.hatch.directions", "4"}, "of first, second"},
        {{"style.contours_of", "hatch"}, "hrbfnpr_style has no field contours_of"},
        {{"fit.maximum_centres", "1.5"}, "must be a whole number"},
        {{"fit.maximum_centres", "9223372036854775808"}, "must be a whole number"},
        {{"fit.preconditioner_neighbours", "-1"}, "must be a whole number of at least 0"},
        {{"fit.regularization", "much"}, "must be a finite number or auto"},
        {{nullptr, "1"}, "changes[0].field is NULL"},
        {{"fit.kernel", nullptr}, "changes[0].value is NULL"},
        {{"style.hatch.name", "\xff"}, "changes[0].value is not UTF-8"},
    };
    for (const auto& [change, message] : cases) {
        const std::string said = refused(change.first, change.second);
        EXPECT_NE(said.find(message), std::string::npos) << said << "\n  is not: " << message;
    }
    EXPECT_NE(refused(std::string(200, 'x').c_str(), "1").find("longer than"), std::string::npos);
    EXPECT_NE(refused("fit.kernel", std::string(5000, 'x').c_str()).find("longer than"), std::string::npos);
    EXPECT_TRUE(refused("style.halo", "1").ends_with(", ..."));
}

TEST_F(ChangesTest, UsesOfFieldsBecomeChangesOfTheirOwn) {
    const Changes given =
        changes({{"style.field", "tone=quality:0..1,direction=flow"}, {"style.field", "ink=rgb,tone="}});
    ASSERT_EQ(given.list().size(), 4U);
    EXPECT_EQ(given.list()[0].path, "style.layers.tone_field");
    EXPECT_EQ(given.list()[0].value, "quality:0..1");
    EXPECT_EQ(given.value("marks.direction_field"), "flow");
    EXPECT_EQ(given.value("style.layers.ink_field"), "rgb");
    EXPECT_EQ(given.value("style.layers.tone_field"), "");
    for (const char* const wrong : {"tone", "hue=quality", "tone=quality,ink", "=quality"})
        EXPECT_NE(refused("style.field", wrong).find("it must be USE=NAME"), std::string::npos) << wrong;
}

TEST_F(ChangesTest, PalettesAreListsOfColours) {
    const auto inks = changes({{"style.palette", "#ff8000,#00000080"}}).colours("style.palette", pool);
    ASSERT_TRUE(inks && inks->size() == 2);
    EXPECT_EQ((*inks)[0][0], 1.0F);
    EXPECT_FLOAT_EQ((*inks)[1][3], 128.0F / 255.0F);
    EXPECT_TRUE(changes({{"style.palette", ""}}).colours("style.palette", pool)->empty());
    EXPECT_FALSE(changes({}).colours("style.palette", pool));
    for (const char* const wrong : {"#ff80", "red", "#ff8000,", "0.5,0.5,0.5", "#ff8000 #000000"})
        EXPECT_NE(refused("style.palette", wrong).find("it must be 1 to 8 colours"), std::string::npos) << wrong;
    EXPECT_NE(refused("style.palette", "#000000,#000000,#000000,#000000,#000000,#000000,#000000,#000000,#000000"), "");
}

TEST_F(ChangesTest, AnInvalidListIsRefused) {
    const hrbfnpr_change change{sizeof(hrbfnpr_change), 0, "fit.kernel", "gaussian"};
    EXPECT_TRUE(Changes(nullptr, 0, 0, pool).list().empty());
    EXPECT_THROW(Changes(nullptr, 1, 0, pool), Error);
    EXPECT_THROW(Changes(&change, -1, 0, pool), Error);
    EXPECT_THROW(Changes(&change, std::numeric_limits<std::int64_t>::max(), 0, pool), Error);
    EXPECT_THROW(Changes(&change, 1, -8, pool), Error);
}

TEST_F(ChangesTest, EveryFieldsDefaultIsReadFromItsText) {
    const auto check = [&](Record record, const auto& values, std::size_t size) {
        for (const NamedField& field : fields_of(record)) {
            EXPECT_LT(field.offset, size) << field.name;
            EXPECT_EQ(find_field(record, field.name), &field);
            if (field.meaning == Meaning::text) continue;
            const FieldValue value = load_value(field, &values);
            const String text = text_of(field, value, pool);
            const std::optional<FieldValue> read = parse_value(field, text);
            ASSERT_TRUE(read) << name_of(record) << "." << field.name << " = " << text.c_str();
            auto copy = values;
            store_value(field, *read, &copy);
            EXPECT_EQ(std::memcmp(&copy, &values, size), 0) << field.name << " = " << text.c_str();
        }
    };
#define HRBFNPR_CHECK(name) check(Record::name, defaults<hrbfnpr_##name>(hrbfnpr_##name##_init), sizeof(hrbfnpr_##name))
    HRBFNPR_CHECK(style);
    HRBFNPR_CHECK(layer_style);
    HRBFNPR_CHECK(line_style);
    HRBFNPR_CHECK(fit_desc);
    HRBFNPR_CHECK(mesh_fit_desc);
    HRBFNPR_CHECK(generate_desc);
    HRBFNPR_CHECK(layer_desc);
    HRBFNPR_CHECK(line_set_desc);
    HRBFNPR_CHECK(line_desc);
    HRBFNPR_CHECK(page_desc);
#undef HRBFNPR_CHECK
}

TEST_F(ChangesTest, NumbersAreWrittenAsPythonWritesThem) {
    const std::pair<double, const char*> cases[] = {
        {0.0, "0.0"},
        {-0.0, "-0.0"},
        {1.0, "1.0"},
        {-2.5, "-2.5"},
        {0.1, "0.1"},
        {100.0, "100.0"},
        {1e15, "1000000000000000.0"},
        {9007199254740993.0, "9007199254740992.0"},
        {1e16, "1e+16"},
        {1.25e22, "1.25e+22"},
        {1e300, "1e+300"},
        {0.0001, "0.0001"},
        {0.00012345, "0.00012345"},
        {0.00001, "1e-05"},
        {1.5e-7, "1.5e-07"},
        {5e-324, "5e-324"},
        {1.7976931348623157e308, "1.7976931348623157e+308"},
        {-0.4999999999999999, "-0.4999999999999999"},
        {4.440892098500626e-16, "4.440892098500626e-16"},
    };
    for (const auto& [number, text] : cases) {
        String written(&pool);
        append_decimals(written, number);
        EXPECT_EQ(written, text);
        EXPECT_EQ(parse_number(written), number);
    }
    EXPECT_EQ(shortest_decimals(static_cast<double>(0.1F)), 0.1);
    EXPECT_EQ(shortest_decimals(static_cast<double>(1.65F)), 1.65);
    EXPECT_EQ(shortest_decimals(0.1), 0.1);
    EXPECT_EQ(shortest_decimals(1.0 / 3.0), 1.0 / 3.0);
    EXPECT_EQ(shortest_decimals(1e300), 1e300);
    for (const char* none : {"", "+", "-", ".", "1.0.0", "1e", "0x10", "inf", "nan", "1 2", "--1", "+-1", "1e400"})
        EXPECT_FALSE(parse_number(none)) << none;
    EXPECT_EQ(parse_number("+.5"), 0.5);
}

TEST_F(ChangesTest, ListsOfNamesFitTheirRoom) {
    constexpr std::string_view names[] = {"tone", "paper", "halo_width", "light"};
    EXPECT_EQ(listed_names(names, "halo", 100, pool), "tone, paper, halo_width, light");
    EXPECT_EQ(listed_names(names, "halo", 24, pool), "halo_width, tone, ...");
    EXPECT_LE(listed_names(names, "halo", 3, pool).size(), 5U);
}

} // namespace
} // namespace hrbfnpr::picture::changes_test
