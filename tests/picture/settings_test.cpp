// SPDX-License-Identifier: MIT
#include "picture/call.h"
#include "picture/field_table.h"
#include "picture/json.h"
#include "picture/tuning_settings.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace hrbfnpr::picture::settings_test {
namespace {

// The Python package wrote this file, with one value of each sort.
constexpr const char* written_by_python = R"({
  "hrbfnpr-settings": 1,
  "preset": "hatch",
  "size": [120, 90],
  "pen": 1.0,
  "camera": {
    "view": [0.8660254037844387, -0.17101007166283433, 0.4698463103929541, 0.0, 0.0, 0.9396926207859084, 0.3420201433256687, 0.0, -0.4999999999999999, -0.29619813272602386, 0.8137976813493738, 0.0, -4.440892098500626e-16, 4.440892098500626e-16, -7.443863410889161, 1.0],
    "projection": [3.6739754257004287, 0.0, 0.0, 0.0, 0.0, 4.898633900933905, 0.0, 0.0, 0.04026589000668854, 0.030562712939808463, -4.473147140815416, -1.0, 0.0, 0.0, -31.633374144219015, 0.0]
  },
  "style": {
    "halo_width": 1.5,
    "tone_exponent": 1.4,
    "silhouette_radius": 0.90000004,
    "light": [0.2, 0.9, 0.5],
    "layers": [
      {"kind": "stipples", "shown": false, "directions": 1, "radius": 0.75, "hatch_spacing": 3.4499998, "hatch_pen": 0.45000002, "hatch_white": 0.90000004, "hatch_taper": 15.0, "hatch_shortest": 7.5, "name": "grain \u00e9\ud83d\ude00"},
      {"kind": "hatch", "shape": "hatch", "radius": 0.75, "ink": [0.1, 0.2, 0.3, 1.0], "hatch_spacing": 3.4499998, "hatch_pen": 0.45000002, "hatch_white": 0.90000004, "hatch_taper": 15.0, "hatch_shortest": 7.5}
    ],
    "lines": [
      {"kind": "contour", "width": 1.2750001, "taper": 9.0, "hidden_width": 0.90000004, "shortest": 1.5},
      {"kind": "isophote", "width": 1.5, "taper": 9.0, "hidden_width": 0.90000004, "shortest": 1.5, "levels": [0.3, 0.6]}
    ]
  },
  "marks": {
    "box_jitter": 0.2,
    "random_seed": 18446744073709551615,
    "layers": [
      {"kind": "stipples", "budget": 2000, "density": "curvature"},
      {"kind": "hatch", "budget": 0, "separation": 0.15, "angle": 20.0, "axis": [0.0, 0.0, 1.0], "tone_begin": 0.4, "tone_end": 0.9}
    ]
  },
  "fit": {"kernel": "wendland_c2", "kernel_radius": 3.0, "solver_tolerance": 1e-09, "regularization_mode": "auto", "normal_mode": "given", "trim": "never"},
  "mesh_fit": {"edges": "sharp", "crease_angle": 40.0, "share": 0.98},
  "line_set": {
    "cell_size": 0.07,
    "support": 1.5,
    "lines": [
      {"kind": "section", "name": "cut", "lower": 0.0, "upper": 0.0, "shortest": 0.01, "plane": [0.0, 1.0, 0.0], "levels": [0.0, 0.125]}
    ]
  },
  "paint": [
    {
      "map": "tone",
      "position": [1.0, 0.0, 0.4],
      "normal": [0.0, 0.0, 1.0],
      "radius": 0.6,
      "strength": 1.0,
      "value": 0.25
    },
    {
      "map": "direction",
      "position": [1.0, 0.0, 0.4],
      "normal": [0.0, 0.0, 1.0],
      "radius": 0.8,
      "strength": 0.5,
      "direction": [1.0, 1.0, 0.0]
    }
  ]
}
)";

struct SettingsTest : testing::Test {
    using Json = std::string;

    [[nodiscard]] std::shared_ptr<const Settings> read(const Json& json) { return read_settings(json, pool); }
    // Returns settings with additional keys, such as R"("pen": 2)".
    [[nodiscard]] std::shared_ptr<const Settings> with(const Json& keys) {
        return read("{\"hrbfnpr-settings\": 1, " + keys + "}");
    }
    [[nodiscard]] Json refused(const Json& json) {
        try {
            static_cast<void>(read(json));
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "";
    }
    // Writes the settings of a picture whose options come from settings, except for those of `desc`.
    [[nodiscard]] WrittenSettings written(const std::shared_ptr<const Settings>& settings,
                                          const hrbfnpr_picture_desc& desc) {
        const Options options(desc, settings, pool);
        const auto [width, height] = settings->size.value_or(std::array<std::int32_t, 2>{160, 120});
        auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
        camera.viewport[2] = width;
        camera.viewport[3] = height;
        const Marks* const marks = settings->has_layers ? &settings->marks : nullptr;
        return write_settings(options,
                              {settings->preset, settings->camera(width, height).value_or(camera), settings->style,
                               marks, settings->lines},
                              pool);
    }
    [[nodiscard]] hrbfnpr_picture_desc desc() const noexcept {
        return defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init);
    }
    [[nodiscard]] static std::string_view field(const Settings& settings, std::string_view path) {
        for (const auto& [name, value] : settings.fields)
            if (name == path) return value;
        return "none";
    }

    base::Memory memory;
    Pool pool{memory};
};

TEST_F(SettingsTest, AFileOfPythonIsReadAndWrittenAgain) {
    const WrittenSettings again = written(read(written_by_python), desc());
    EXPECT_EQ(again.json, written_by_python);
    EXPECT_EQ(again.not_held, "");
}

TEST_F(SettingsTest, ValuesOfAFileAreApplied) {
    const auto settings = read(written_by_python);
    EXPECT_EQ(settings->preset, std::uint32_t{HRBFNPR_PRESET_HATCH});
    EXPECT_EQ((*settings->size)[1], 90);
    EXPECT_EQ(settings->pen, 1.0);
    EXPECT_EQ(settings->style.base.tone_exponent, 1.4);
    EXPECT_EQ(settings->style.base.halo_width, 1.5F);
    ASSERT_EQ(settings->style.layers.size(), 2U);
    EXPECT_STREQ(settings->style.layers[0].name, "grain \xC3\xA9\xF0\x9F\x98\x80");
    EXPECT_EQ(settings->style.layers[0].shown, 0U);
    EXPECT_EQ(settings->style.layers[0].directions, 1U);
    EXPECT_EQ(settings->style.layers[1].shape, std::uint32_t{HRBFNPR_SHAPE_HATCH});
    ASSERT_EQ(settings->style.lines.size(), 2U);
    ASSERT_EQ(settings->style.lines[1].levels.count, 2);
    EXPECT_EQ(static_cast<const double*>(settings->style.lines[1].levels.data)[1], 0.6);
    ASSERT_TRUE(settings->has_layers);
    ASSERT_EQ(settings->marks.layers.size(), 2U);
    EXPECT_EQ(settings->marks.layers[0].density, std::uint32_t{HRBFNPR_DENSITY_CURVATURE});
    EXPECT_EQ(settings->marks.layers[1].budget, 0);
    EXPECT_EQ(settings->marks.layers[1].axis[2], 1.0);
    EXPECT_EQ(settings->marks.layers[1].levels, -1);
    EXPECT_EQ(field(*settings, "marks.random_seed"), "18446744073709551615");
    EXPECT_EQ(field(*settings, "fit.kernel"), "wendland_c2");
    EXPECT_EQ(field(*settings, "fit.regularization"), "auto");
    EXPECT_EQ(field(*settings, "fit.normal_mode"), "given");
    EXPECT_EQ(field(*settings, "mesh_fit.share"), "0.98");
    EXPECT_EQ(field(*settings, "line_set.support"), "1.5");
    ASSERT_TRUE(settings->has_lines);
    EXPECT_STREQ(settings->lines[0].name, "cut");
    EXPECT_EQ(settings->lines[0].plane[1], 1.0);
    ASSERT_EQ(settings->dabs.size(), 2U);
    EXPECT_EQ(settings->dabs[0].value, 0.25);
    EXPECT_EQ(settings->dabs[1].map, std::uint32_t{HRBFNPR_DAB_DIRECTION});
    EXPECT_EQ(settings->dabs[1].direction[1], 1.0);
    const Options options(desc(), settings, pool);
    EXPECT_EQ(options.desc.normals, std::uint32_t{HRBFNPR_NORMALS_GIVEN});
    EXPECT_TRUE(options.has(HRBFNPR_PICTURE_CLOSE));
}

TEST_F(SettingsTest, MissingValuesGetDefaults) {
    const auto settings = read(R"({"hrbfnpr-settings": 1})");
    EXPECT_EQ(settings->preset, std::uint32_t{HRBFNPR_PRESET_CONTOUR_AND_STIPPLE});
    EXPECT_FALSE(settings->size);
    EXPECT_FALSE(settings->camera(10, 10));
    EXPECT_EQ(settings->pen, 0.0);
    EXPECT_FALSE(settings->has_layers);
    EXPECT_FALSE(settings->has_lines);
    EXPECT_TRUE(settings->fields.empty());
    EXPECT_EQ(settings->style.layers.size(), Style(settings->preset, pool).layers.size());
    EXPECT_EQ(with(R"("style": {"lines": []})")->style.lines.size(), 0U);
    EXPECT_TRUE(with(R"("line_set": {"lines": []})")->has_lines);
    // If a key is repeated, the last one counts.
    EXPECT_EQ(with(R"("pen": 3, "pen": 2)")->pen, 2.0);
    EXPECT_EQ(with(R"("marks": {"layers": [{"kind": "hatch", "tone_begin": 0.5, "tone_end": 0}]})")
                  ->marks.layers[0]
                  .tone_begin,
              0.0F);
}

TEST_F(SettingsTest, InvalidValuesAreNamed) {
    const std::string dab = R"({"map": "tone", "position": [0, 0, 0], "normal": [0, 0, 1], "radius": 1, "strength": 1)";
    const std::string zeros = "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]";
    const std::pair<std::string, const char*> cases[] = {
        {R"("styel": {})", "styel: there is no such field; there are hrbfnpr-settings, preset"},
        {R"("preset": "hatched")", "preset: there is no style \"hatched\"; there are stipple"},
        {R"("preset": 3)", "preset: there is no style 3; there are stipple"},
        {R"("size": [0, 5])", "size: a pair of whole numbers from 1 to 32768 is needed, not [0, 5]"},
        {R"("size": [5])", "size: a list of 2 numbers is needed, not [5]"},
        {R"("pen": "thick")", "pen: a number from 0 to 100 is needed, not \"thick\""},
        {R"("pen": true)", "pen: a number from 0 to 100 is needed, not true"},
        {R"("style": 1)", "style: an object is needed, not 1"},
        {R"("style": {"radiuss": 1})",
         "style.radiuss: there is no such field; there are rim_light, rim_exponent, tone"},
        {R"("style": {"halo": 1})", "style.halo: there is no such field; there are halo_width"},
        {R"("style": {"tone": "loud"})", "style.tone: one of none, light is needed, not \"loud\""},
        {R"("style": {"tone": 1})", "style.tone: one of none, light is needed, not 1"},
        {R"("style": {"paper": [1, 1, 1]})", "style.paper: a list of 4 numbers is needed, not [1, 1, 1]"},
        {R"("style": {"halo_width": 1e39})", "style.halo_width: a number that fits a float is needed, not 1e+39"},
        {R"("style": {"layers": {}})", "style.layers: a list of objects is needed, not {}"},
        {R"("style": {"layers": [{"kind": "hatch"}, {"radius": "wide"}]})",
         "style.layers[1].radius: a number is needed, not \"wide\""},
        {R"("style": {"layers": [{"name": 3}]})", "style.layers[0].name: a text or null is needed, not 3"},
        {R"("style": {"layers": [{"name": "a\u0000b"}]})", "style.layers[0].name: a text or null is needed"},
        {R"("style": {"lines": [{"levels": 3}]})", "style.lines[0].levels: a list of numbers is needed, not 3"},
        {R"("marks": {"flags": 1})", "marks.flags: there is no such field; there are"},
        {R"("marks": {"seed_source": "points"})", "marks.seed_source: one of auto, samples, box is needed"},
        {R"("marks": {"layers": [{"kind": "stipples", "budget": 1.5}]})",
         "marks.layers[0].budget: a whole number is needed, not 1.5"},
        {R"("marks": {"layers": [{"kind": "any"}]})", "marks.layers[0].kind: one of stipples"},
        {R"("marks": {"box_resolution": -1})", "marks.box_resolution: a number that fits a uint32_t is needed, not -1"},
        {R"("camera": {"eye": [0, 0, 1]})", "camera.target: it is missing"},
        {R"("camera": {"view": )" + zeros + R"(, "projection": )" + zeros + "}", "size: it is missing"},
        {R"("size": [9, 9], "camera": {"view": )" + zeros + "}", "camera.projection: it is missing"},
        {R"("camera": {"eye": [0,0,1], "target": [0,0,0], "up": [0,1,0], "vertical_angle": 0, "near_plane": 1,
            "far_plane": 2})",
         "camera.view_height: it is missing"},
        {R"("camera": {"eye": [0,0,1], "target": [0,0,0], "up": [0,1,0], "vertical_angle": 4, "near_plane": 1,
            "far_plane": 2})",
         "camera.vertical_angle: a number from 0 to 3.14 is needed, not 4"},
        {R"("fit": {"kernel": "csg"})", "fit.kernel: one of triharmonic, gaussian, wendland_c2 is needed"},
        {R"("line_set": {"lines": [{"kind": "contour"}]})", "line_set.lines[0].kind: one of ridge"},
        {R"("paint": 1)", "paint: a list of objects is needed, not 1"},
        {R"("paint": [)" + dab + R"(, "value": 0}, )" + dab + "}]", "paint[1].value: it is missing"},
        {R"("paint": [{"map": "tone", "position": [0,0,0], "normal": [0,0,1], "radius": 0, "strength": 1, "value": 0}])",
         "paint[0].radius: a number above 0 is needed, not 0"},
        {R"("paint": [{"map": "colour"}])", "paint[0].map: one of tone, density, direction is needed, not \"colour\""},
        {R"("paint": [3])", "paint[0]: an object is needed, not 3"},
    };
    for (const auto& [keys, message] : cases) {
        const std::string said = refused("{\"hrbfnpr-settings\": 1, " + keys + "}");
        EXPECT_TRUE(said.starts_with(message)) << said << "\n  does not begin with: " << message;
    }
}

TEST_F(SettingsTest, OtherTextsAreRefused) {
    EXPECT_EQ(refused("{}"), "this is not a settings file: it must begin with {\"hrbfnpr-settings\": 1}");
    EXPECT_EQ(refused("[1]"), "this is not a settings file: it must begin with {\"hrbfnpr-settings\": 1}");
    EXPECT_EQ(refused("7"), "this is not a settings file: it must begin with {\"hrbfnpr-settings\": 1}");
    EXPECT_EQ(refused(R"({"hrbfnpr-settings": 2})"), "hrbfnpr-settings: version 1 is needed, not 2");
    EXPECT_EQ(refused(R"({"hrbfnpr-settings": "1"})"), "hrbfnpr-settings: version 1 is needed, not \"1\"");
    EXPECT_TRUE(refused("{\n\"a\": }").starts_with("this is not JSON: line 2, column 6: syntax error"));
    for (const char* text : {"", "{", "{} {}", "nan", "{\"a\": NaN}", "\xff", "\"\xff\"", "\"\\ud800\"", "1e999"})
        EXPECT_TRUE(refused(text).starts_with("this is not JSON: ")) << text << ": " << refused(text);
    EXPECT_NE(refused(std::string(100'000, '[')).find("nested more than"), std::string::npos);
    EXPECT_NE(refused(std::string(settings_tuning.most_bytes + 1, ' ')).find(" bytes are too large"),
              std::string::npos);
    std::string many = "{\"hrbfnpr-settings\": 1";
    for (int i = 0; i < 20'000; ++i) many += ", \"key" + std::to_string(i) + "\": [[], {}]";
    EXPECT_TRUE(refused(many + "}").starts_with("key0: there is no such field; there are "));
}

TEST_F(SettingsTest, TheCameraOfTheFileIsUsed) {
    const Json view =
        R"("eye": [1.2, 0.8, 2.5], "target": [0, 0, 0], "up": [0, 1, 0], "near_plane": 1, "far_plane": 5)";
    const std::array<double, 3> eye{1.2, 0.8, 2.5}, target{}, up{0.0, 1.0, 0.0};
    auto wanted = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    hrbfnpr_camera_look_at(&wanted, eye.data(), target.data(), up.data(), nullptr);
    hrbfnpr_camera_perspective(&wanted, 0.52, 300.0, 200.0, 1.0, 5.0, nullptr);
    const auto made = with("\"camera\": {" + view + ", \"vertical_angle\": 0.52}")->camera(300, 200);
    EXPECT_EQ(std::memcmp(&*made, &wanted, sizeof wanted), 0);
    hrbfnpr_camera_orthographic(&wanted, 2.5, 300.0, 200.0, 1.0, 5.0, nullptr);
    const auto flat = with("\"camera\": {" + view + ", \"vertical_angle\": 0, \"view_height\": 2.5}")->camera(300, 200);
    EXPECT_EQ(std::memcmp(&*flat, &wanted, sizeof wanted), 0);
    const auto none = with(R"("camera": {"eye": [0,0,0], "target": [0,0,0], "up": [0,1,0], "vertical_angle": 1,
        "near_plane": 1, "far_plane": 5})");
    EXPECT_THROW(static_cast<void>(none->camera(9, 9)), Error) << "it looks nowhere";
}

TEST_F(SettingsTest, MatricesAreScaledToAnotherSize) {
    const auto settings = read(written_by_python); // Its size is 120 x 90.
    const hrbfnpr_camera own = *settings->camera(120, 90);
    EXPECT_EQ(own.projection[0], 3.6739754257004287);
    EXPECT_EQ(own.viewport[2], 120.0);
    const hrbfnpr_camera wide = *settings->camera(480, 180); // This picture is twice as high.
    EXPECT_EQ(wide.projection[5], own.projection[5]);
    EXPECT_DOUBLE_EQ(wide.projection[0], own.projection[0] / 2.0);
    EXPECT_DOUBLE_EQ(wide.projection[8], own.projection[8] / 2.0);
    EXPECT_EQ(wide.projection[11], own.projection[11]);
}

TEST_F(SettingsTest, OptionsAreWritten) {
    // The Python package wrote these for --kernel wendland-c2 --kernel-radius 3 --regularization auto --normals keep
    // --close --tolerance 0.001 --max-centres 900 --random-seed 7 --edges 40 --support 3.
    const hrbfnpr_change changes[] = {{sizeof(hrbfnpr_change), 0, "line_set.support", "3"},
                                      {sizeof(hrbfnpr_change), 0, "fit.regularization", "auto"},
                                      {sizeof(hrbfnpr_change), 0, "fit.kernel_radius", "3"},
                                      {sizeof(hrbfnpr_change), 0, "fit.kernel", "wendland-c2"},
                                      {sizeof(hrbfnpr_change), 0, "marks.tone_ranges", "in-turn"},
                                      {sizeof(hrbfnpr_change), 0, "marks.distribution", "published"},
                                      {sizeof(hrbfnpr_change), 0, "style.hatch.ink", "#ff0000"}};
    hrbfnpr_picture_desc given = desc();
    given.changes = changes;
    given.change_count = static_cast<std::int64_t>(std::size(changes));
    given.normals = HRBFNPR_NORMALS_GIVEN;
    given.flags = HRBFNPR_PICTURE_CLOSE | HRBFNPR_PICTURE_FLIP;
    given.tolerance = 0.001;
    given.maximum_centres = 900;
    given.random_seed = 7;
    given.edges = HRBFNPR_PICTURE_EDGES_SHARP;
    given.edge_angle = 40.0;
    given.samples = 100;
    given.viewpoint[0] = given.viewpoint[1] = given.viewpoint[2] = 0.0;
    const auto settings = with(R"("marks": {"layers": [{"kind": "stipples", "budget": 2000}]})");
    const WrittenSettings made = written(settings, given);
    const auto has = [&](const char* text) { return std::string_view(made.json).find(text) != std::string_view::npos; };
    EXPECT_TRUE(has(R"(
  "marks": {
    "distribution": "published",
    "tone_ranges": "in_turn",
    "random_seed": 7,
    "layers": [
      {"kind": "stipples", "budget": 2000}
    ]
  },
  "fit": {"kernel": "wendland_c2", "kernel_radius": 3.0, "tolerance": 0.001, "maximum_centres": 900, "regularization_mode": "auto", "normal_mode": "given", "trim": "never"},
  "mesh_fit": {"tolerance": 0.001, "maximum_centres": 900, "edges": "sharp", "crease_angle": 40.0},
  "line_set": {"support": 3.0}
}
)")) << made.json;
    EXPECT_EQ(made.not_held, "{samples}, {viewpoint}, {flip!}");
    EXPECT_EQ(written(read(made.json.c_str()), desc()).json, made.json);
}

TEST_F(SettingsTest, FieldsAndInksAreWrittenAndRead) {
    const auto settings = with(R"("style": {"palette": [[0.5, 0.25, 0.0, 1.0], [0.0, 0.0, 0.5, 1.0]],
        "layers": [{"kind": "any", "tone_field": "-quality:0.2..0.9", "ink_field": "rgb", "palette_rule": "mixed"}]},
        "marks": {"direction_field": "flow", "layers": [{"kind": "hatch"}]})");
    const WrittenSettings made = written(settings, desc());
    const auto again = read(made.json.c_str());
    ASSERT_EQ(again->style.layers.size(), 1U);
    const hrbfnpr_layer_style& layer = again->style.layers[0];
    EXPECT_STREQ(layer.tone_field, "-quality:0.2..0.9");
    EXPECT_STREQ(layer.ink_field, "rgb");
    EXPECT_EQ(layer.mask_field, nullptr);
    EXPECT_EQ(layer.palette_rule, std::uint32_t{HRBFNPR_PALETTE_MIXED});
    ASSERT_EQ(again->style.palette.size(), 2U);
    EXPECT_EQ(again->style.palette[0], (std::array{0.5F, 0.25F, 0.0F, 1.0F}));
    EXPECT_EQ(field(*again, "marks.direction_field"), "flow");
    EXPECT_EQ(written(again, desc()).json, made.json);
    EXPECT_THROW(static_cast<void>(with(R"("style": {"palette": [[0.5, 0.25, 0.0]]})")), Error);
    EXPECT_THROW(static_cast<void>(with(R"("marks": {"direction_field": 1})")), Error);
}

TEST_F(SettingsTest, AFunctionOfToneIsWrittenAsLight) {
    auto settings = std::make_shared<Settings>(pool);
    settings->style.base.tone = HRBFNPR_TONE_CALLBACK;
    EXPECT_EQ(read(written(settings, desc()).json.c_str())->style.base.tone, std::uint32_t{HRBFNPR_TONE_LIGHT});
}

TEST_F(SettingsTest, EveryPresetIsWrittenAndRead) {
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        const auto settings = with("\"preset\": \"" + std::string(hrbfnpr_preset_name(preset)) + "\"");
        const WrittenSettings made = written(settings, desc());
        const auto again = read(made.json.c_str());
        EXPECT_EQ(written(again, desc()).json, made.json);
        ASSERT_EQ(again->style.layers.size(), settings->style.layers.size());
        for (std::size_t i = 0; i < again->style.layers.size(); ++i)
            EXPECT_EQ(again->style.layers[i].hatch_spacing, settings->style.layers[i].hatch_spacing);
        EXPECT_EQ(again->style.base.attenuation_back, settings->style.base.attenuation_back);
    }
}

// Each field that a file can hold keeps a value other than its default.
TEST_F(SettingsTest, EveryFieldOfAStyleIsWrittenAndRead) {
    auto settings = std::make_shared<Settings>(pool);
    for (const NamedField& named : fields_of(Record::style)) {
        FieldValue value = load_value(named, &settings->style.base);
        if (named.meaning == Meaning::choice)
            value.whole = value.whole == 0 ? 1 : 0;
        else
            for (double& number : value.numbers) number += 0.25;
        store_value(named, value, &settings->style.base);
    }
    const WrittenSettings made = written(settings, desc());
    const auto again = read(made.json.c_str());
    for (const NamedField& named : fields_of(Record::style)) {
        const FieldValue wanted = load_value(named, &settings->style.base);
        const FieldValue found = load_value(named, &again->style.base);
        EXPECT_EQ(found.whole, wanted.whole) << named.name;
        EXPECT_EQ(found.numbers, wanted.numbers) << named.name;
    }
}

TEST_F(SettingsTest, NaNIsNotWritten) {
    auto settings = std::make_shared<Settings>(pool);
    settings->style.base.depth_max = std::nan("");
    EXPECT_THROW(static_cast<void>(written(settings, desc())), Error);
}

TEST_F(SettingsTest, JsonIsReadInEveryForm) {
    const JsonDocument document(R"( {"a": [ -1, 2.50, 1E2, true, null, "\u00e9\n\"" ], "b": {"c": {}}} )", pool);
    String line(&pool);
    document.write_line(line, 0);
    EXPECT_EQ(line, R"({"a": [-1, 2.5, 100.0, true, null, "\u00e9\n\""], "b": {"c": {}}})");
    const JsonValue root = document.root();
    EXPECT_EQ(root.size(), 2U);
    EXPECT_EQ(root.find("a")->size(), 6U);
    EXPECT_FALSE(root.find("c"));
    EXPECT_FALSE(root.find("a")->find("c"));
    EXPECT_EQ(root.in_short(7, pool), "{\"a\": [");
}

} // namespace
} // namespace hrbfnpr::picture::settings_test
