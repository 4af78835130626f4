// SPDX-License-Identifier: MIT
#include "picture/plan.h"

#include "planned_call.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace picture_tests::plan_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

// Plans a picture of 800 x 600 pixels of a surface with an area of 3, at 200 pixels per unit.
struct Planned {
    Style style;
    Marks marks;
};

Planned planned(const Call& call, double width = 800.0, double height = 600.0, double area = 3.0,
                double pixels = 200.0) {
    Style style = plan_style(call, width, height, false);
    Marks marks = plan_marks(call, style, area, pixels, 500);
    return {std::move(style), std::move(marks)};
}

hrbfnpr_layer_style for_stipples(const Style& style) { return style.style_of(HRBFNPR_LAYER_KIND_STIPPLES, nullptr); }

TEST(Plan, ThePenIsAnEightHundredthOfThePicture) {
    PlannedCall plain;
    EXPECT_EQ(pen_of(plain.call(), 1600.0, 900.0), 2.0);
    EXPECT_EQ(pen_of(plain.call(), 900.0, 1600.0), 2.0);
    EXPECT_EQ(pen_of(plain.call(), 100.0, 100.0), 0.75); // No pen is finer.
    plain.desc.pen = 3.5;
    EXPECT_EQ(pen_of(plain.call(), 1600.0, 900.0), 3.5);
    const auto own = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    plain.desc.style = &own;
    EXPECT_EQ(pen_of(plain.call(), 1600.0, 900.0), 1.0);
}

// A reference program in Python computed the expected numbers.
TEST(Plan, CrossHatchingMatchesReferenceValues) {
    PlannedCall given(HRBFNPR_PRESET_CROSS_HATCH);
    given.desc.hatch_angle = 10.0;
    const Call call = given.call();
    const Planned made = planned(call, 1600.0, 1200.0);
    EXPECT_FLOAT_EQ(made.style.base.halo_width, 4.0F);
    EXPECT_FLOAT_EQ(made.style.base.silhouette_radius, 2.4F);
    const hrbfnpr_layer_style hatch = made.style.style_of(HRBFNPR_LAYER_KIND_HATCH, "hatch-2");
    EXPECT_FLOAT_EQ(hatch.radius, 2.0F);
    EXPECT_FLOAT_EQ(hatch.hatch_spacing, 5.2F);
    ASSERT_EQ(made.marks.layers.size(), 4U);
    EXPECT_EQ(made.marks.layers[0].budget, 7639);
    const std::array angles{10.0, 45.0, -20.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const hrbfnpr_layer_desc& layer = made.marks.layers[i + 1];
        EXPECT_EQ(layer.budget, 0); // The separation sets the number.
        EXPECT_DOUBLE_EQ(layer.separation, 0.005773502691896257);
        EXPECT_EQ(layer.angle, angles[i]);
    }
    EXPECT_TRUE(given.report->notes.empty());
}

TEST(Plan, StipplesFillTheDarkestTone) {
    PlannedCall given;
    const Planned made = planned(given.call());
    ASSERT_EQ(made.marks.layers.size(), 1U);
    EXPECT_EQ(made.marks.layers[0].budget, 30558);
    const double radius = static_cast<double>(for_stipples(made.style).radius);
    const double covered = 30558 * std::numbers::pi * radius * radius / (3.0 * 200.0 * 200.0);
    EXPECT_NEAR(covered, 0.8, 1e-4);
    given.change("marks.stipples.budget", "77");
    EXPECT_EQ(planned(given.call()).marks.layers[0].budget, 77);
}

TEST(Plan, LinesKeepTheirSeparation) {
    PlannedCall given(HRBFNPR_PRESET_STIPPLE);
    given.desc.mark_kinds = "stipples,hatch";
    given.change("marks.tone_ranges", "in-turn");
    const Planned made = planned(given.call());
    ASSERT_EQ(made.marks.layers.size(), 2U);
    EXPECT_EQ(made.marks.layers[0].budget, 25254);
    EXPECT_EQ(made.marks.layers[1].budget, 0); // The separation sets the number.
    EXPECT_DOUBLE_EQ(made.marks.layers[1].separation, std::sqrt(3.0) / 300.0);
    EXPECT_EQ(made.marks.layers[0].tone_end, 1.0F); // Hatching has separate tones, so it gets no share of the others.
    EXPECT_EQ(made.marks.layers[1].tone_end, 0.0F);
    EXPECT_EQ(made.marks.base.tone_ranges, std::uint32_t{HRBFNPR_TONE_RANGES_IN_TURN});
    PlannedCall apart(HRBFNPR_PRESET_STIPPLE);
    apart.desc.mark_kinds = "hatch,stipples";
    apart.change("marks.layers.separation", "0.01").change("marks.layers.step", "0.002");
    const Marks marks = planned(apart.call()).marks;
    EXPECT_EQ(marks.layers[0].budget, 0);
    EXPECT_EQ(marks.layers[0].separation, 0.01);
    EXPECT_EQ(marks.layers[0].step, 0.002);
    EXPECT_EQ(marks.layers[1].separation, 0.0);
    EXPECT_EQ(marks.layers[1].step, 0.0); // Stipples have no lines.
}

TEST(Plan, TonesAreSharedBetweenLayersInTurn) {
    PlannedCall given(HRBFNPR_PRESET_CROSS_HATCH);
    given.desc.mark_kinds = "stipples,hatch";
    given.change("marks.tone_ranges", "in-turn").change("style.stipples.shown", "true");
    given.change("marks.distribution", "published"); // Both directions of its strokes get a share.
    const Marks marks = planned(given.call()).marks;
    EXPECT_FLOAT_EQ(marks.layers[0].tone_end, 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(marks.layers[1].tone_begin, 1.0F / 3.0F);
    EXPECT_FLOAT_EQ(marks.layers[1].tone_end, 2.0F / 3.0F);
    EXPECT_FLOAT_EQ(marks.layers[1].second_tone_begin, 2.0F / 3.0F);
    EXPECT_EQ(marks.layers[1].second_tone_end, 1.0F);
    // The style keeps its own tone ranges until the caller gives some.
    PlannedCall scientific(HRBFNPR_PRESET_SCIENTIFIC_STIPPLE);
    EXPECT_FLOAT_EQ(planned(scientific.call()).marks.layers[0].tone_begin, 0.08F);
    scientific.change("marks.tone_ranges", "full");
    EXPECT_EQ(planned(scientific.call()).marks.layers[0].tone_end, 0.0F);
}

TEST(Plan, ReportsLimitedMarks) {
    PlannedCall given(HRBFNPR_PRESET_STIPPLE);
    given.desc.pen = 0.5;
    const Marks marks = planned(given.call(), 800.0, 600.0, 30.0, 2000.0).marks;
    EXPECT_EQ(marks.layers[0].budget, 2'000'000);
    ASSERT_EQ(given.report->notes.size(), 1U);
    const Note& note = given.report->notes[0];
    EXPECT_EQ(note.code, std::uint32_t{HRBFNPR_NOTE_MARKS_LIMITED});
    EXPECT_NEAR(note.figures[0], 101017348.0, 1.0);
    EXPECT_EQ(note.figures[1], 2e6);
    EXPECT_EQ(note.text, "stipples: dark tones are too light; a larger --mark-radius fills them");
    given.desc.pen = 1.0;
    EXPECT_EQ(planned(given.call(), 800.0, 600.0, 30.0, 2000.0).marks.layers[0].budget, 2'000'000);
    EXPECT_EQ(given.report->notes[0].text, "stipples: dark tones are too light; --marks stipples=26000000 fills them");
}

TEST(Plan, LinesAloneNeedFewMarks) {
    PlannedCall given(HRBFNPR_PRESET_XRAY);
    EXPECT_EQ(planned(given.call()).marks.layers[0].budget, 4000);
    given.desc.flags = HRBFNPR_PICTURE_KEEP_MARKS;
    EXPECT_GT(planned(given.call()).marks.layers[0].budget, 4000);
    given.desc.flags = 0;
    given.change("style.any.shown", "1");
    EXPECT_GT(planned(given.call()).marks.layers[0].budget, 4000);
}

TEST(Plan, TheRecursionPlansLevels) {
    PlannedCall given(HRBFNPR_PRESET_FULL);
    given.change("marks.distribution", "published");
    const Planned made = planned(given.call());
    ASSERT_EQ(made.marks.layers.size(), 2U);
    EXPECT_EQ(made.marks.layers[1].kind, std::uint32_t{HRBFNPR_LAYER_KIND_HATCH});
    EXPECT_EQ(made.marks.layers[0].levels, 3);
    EXPECT_EQ(made.marks.layers[1].levels, 3);
    EXPECT_EQ(made.marks.layers[0].budget, 0);
    EXPECT_EQ(for_stipples(made.style).radius, 1.0F);
    const Marks fine = planned(given.call(), 800.0, 600.0, 1e9, 2000.0).marks;
    EXPECT_EQ(fine.layers[0].levels, 6);
    ASSERT_EQ(given.report->notes.size(), 2U);
    EXPECT_EQ(given.report->notes[0].code, std::uint32_t{HRBFNPR_NOTE_LEVELS_LIMITED});
    EXPECT_NE(given.report->notes[0].text.find("stipples: dark tones are too light; --levels stipples="), String::npos);
}

// Its strokes are one layer, in place of the style's layers of lines.
TEST(Plan, TheRecursionPutsStrokesInOneLayer) {
    struct Row {
        std::uint32_t preset, guide, directions;
    };
    const std::array rows{Row{HRBFNPR_PRESET_HATCH, HRBFNPR_HATCH_GUIDE_CURVATURE, 2U},
                          Row{HRBFNPR_PRESET_CROSS_HATCH, HRBFNPR_HATCH_GUIDE_CURVATURE, 3U},
                          Row{HRBFNPR_PRESET_COMBING, HRBFNPR_HATCH_GUIDE_COMBING, 3U}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.preset);
        PlannedCall given(row.preset);
        given.change("marks.distribution", "published");
        const Planned made = planned(given.call());
        ASSERT_EQ(made.marks.layers.size(), 2U);
        const hrbfnpr_layer_desc& strokes = made.marks.layers[1];
        EXPECT_EQ(strokes.kind, std::uint32_t{HRBFNPR_LAYER_KIND_HATCH});
        EXPECT_EQ(strokes.guide, row.guide);
        EXPECT_EQ(strokes.separation, 0.0);
        const hrbfnpr_layer_style style = made.style.style_of(strokes.kind, strokes.name);
        EXPECT_EQ(style.shape, std::uint32_t{HRBFNPR_SHAPE_DOTS});
        EXPECT_EQ(style.directions, row.directions);
    }
}

TEST(Plan, ChangesApplyInOrder) {
    PlannedCall given(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE);
    given.change("style.any.radius", "5").change("style.own.share", "0.25").change("style.ink", "#ff0000");
    given.change("style.silhouette_ink", "#00ff00").change("style.layers.share", "0.5");
    given.change("style.stipples.ink", "#0000ff").change("style.lines.wobble", "0.5").change("style.lines.width", "7");
    const Style style = plan_style(given.call(), 1600.0, 1200.0, false);
    const hrbfnpr_layer_style own = style.style_of(HRBFNPR_LAYER_KIND_OWN, nullptr);
    EXPECT_EQ(own.radius, 5.0F); // It copies the element of all kinds, in pixels of this picture.
    EXPECT_EQ(own.share, 0.25F);
    EXPECT_EQ(own.ink[0], 1.0F);
    EXPECT_EQ(for_stipples(style).ink[2], 1.0F);
    EXPECT_EQ(for_stipples(style).ink[0], 0.0F);
    EXPECT_EQ(for_stipples(style).share, 0.5F);
    EXPECT_EQ(style.base.silhouette_ink[1], 1.0F);
    for (const hrbfnpr_line_style& line : style.lines) {
        EXPECT_EQ(line.ink[1], 1.0F);
        EXPECT_EQ(line.width, 7.0F);
        EXPECT_EQ(line.wobble_width, 0.25F);
    }
}

TEST(Plan, LinesOfOneKindCanBeChangedAlone) {
    PlannedCall given;
    given.desc.lines = "contour,ridges";
    given.change("style.ridge.width", "3").change("style.contour.hidden", "dashed");
    const Style style = plan_style(given.call(), 1600.0, 1200.0, false);
    ASSERT_EQ(style.lines.size(), 2U);
    EXPECT_NE(style.lines[0].width, 3.0F);
    EXPECT_EQ(style.lines[0].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_DASHED});
    EXPECT_EQ(style.lines[1].width, 3.0F);
    EXPECT_NE(style.lines[1].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_DASHED});
}

TEST(Plan, HidingHiddenLinesAlsoHidesPartsOfLines) {
    PlannedCall given(HRBFNPR_PRESET_XRAY);
    given.change("style.hidden_lines", "hide");
    const Style style = plan_style(given.call(), 800.0, 600.0, false);
    EXPECT_EQ(style.base.hidden_lines, std::uint32_t{HRBFNPR_HIDDEN_LINES_HIDE});
    EXPECT_EQ(style.lines[0].hidden, std::uint32_t{HRBFNPR_HIDDEN_PARTS_NONE});
    given.change("style.lines.hidden", "dashed");
    EXPECT_EQ(plan_style(given.call(), 800.0, 600.0, false).lines[0].hidden,
              std::uint32_t{HRBFNPR_HIDDEN_PARTS_DASHED});
}

TEST(Plan, ATransparentPictureHasNoPaper) {
    PlannedCall given;
    EXPECT_EQ(plan_style(given.call(), 800.0, 600.0, false).base.paper[3], 1.0F);
    given.desc.flags = HRBFNPR_PICTURE_TRANSPARENT;
    EXPECT_EQ(plan_style(given.call(), 800.0, 600.0, false).base.paper[3], 0.0F);
}

TEST(Plan, ACallersStyleIsUsedUnchanged) {
    auto own = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    layer.radius = 2.5F;
    own.layers = &layer;
    own.layer_count = 1;
    own.halo_width = 9.0F;
    PlannedCall given;
    given.desc.style = &own;
    const Style style = plan_style(given.call(), 4000.0, 3000.0, false);
    EXPECT_EQ(for_stipples(style).radius, 2.5F);
    EXPECT_EQ(style.base.halo_width, 9.0F);
}

TEST(Plan, UnknownMarkKindsAreRefused) {
    PlannedCall given;
    for (const char* const wrong : {"dots", "principal", "own", "any", "stipples,hatching"}) {
        given.desc.mark_kinds = wrong;
        const Call call = given.call();
        EXPECT_THROW(static_cast<void>(planned(call)), Error) << wrong;
    }
    given.desc.mark_kinds = ",";
    EXPECT_EQ(planned(given.call()).marks.layers.size(), 1U); // The layers are those of the style.
}

TEST(Plan, SeedsAndTheRandomNumberComeFromTheDescriptor) {
    const std::array points{0.0F, 1.0F, 2.0F};
    PlannedCall given;
    given.desc.seed_points = {points.data(), 1, 0, HRBFNPR_SCALAR_FLOAT32, 3};
    given.desc.random_seed = 7;
    const Marks marks = planned(given.call()).marks;
    EXPECT_EQ(marks.base.seed_source, std::uint32_t{HRBFNPR_SEED_POINTS});
    ASSERT_EQ(marks.base.seed_points.count, 1);
    EXPECT_EQ(static_cast<const double*>(marks.base.seed_points.data)[2], 2.0);
    EXPECT_EQ(marks.base.random_seed, 7U);
    given.change("marks.seed_source", "box").change("marks.random_seed", "9");
    const Marks boxed = planned(given.call()).marks;
    EXPECT_EQ(boxed.base.seed_source, std::uint32_t{HRBFNPR_SEED_BOX});
    EXPECT_EQ(boxed.base.random_seed, 9U);
}

TEST(Plan, SettingsHaveAStyleAPenAndLayers) {
    PlannedCall given;
    given.settings = read_settings(R"({"hrbfnpr-settings": 1, "preset": "hatch", "pen": 2,
        "style": {"layers": [{"kind": "hatch", "name": "fur", "radius": 1.5}], "lines": [{"kind": "section"}]},
        "marks": {"tone_ranges": "in_turn", "random_seed": 5, "layers": [{"kind": "stipples"},
                  {"kind": "hatch", "name": "fur", "budget": 0, "separation": 0.01, "angle": 20}]}})",
                                   given.pool);
    given.desc.hatch_angle = 5.0;
    const Call call = given.call();
    EXPECT_EQ(pen_of(call, 800.0, 600.0), 2.0);
    const Planned made = planned(call);
    ASSERT_EQ(made.style.layers.size(), 1U); // Other kinds get no element.
    EXPECT_EQ(made.style.layers[0].radius, 3.0F);
    ASSERT_EQ(made.marks.layers.size(), 2U);
    EXPECT_EQ(made.marks.layers[0].budget, 40000); // The default counts as given.
    EXPECT_EQ(made.marks.layers[0].tone_end, 0.0F);
    EXPECT_STREQ(made.marks.layers[1].name, "fur");
    EXPECT_EQ(made.marks.layers[1].budget, 0);
    EXPECT_EQ(made.marks.layers[1].separation, 0.01);
    EXPECT_EQ(made.marks.layers[1].angle, 25.0);
    EXPECT_EQ(made.marks.base.tone_ranges, std::uint32_t{HRBFNPR_TONE_RANGES_IN_TURN});
    EXPECT_EQ(made.marks.base.random_seed, 5U);
    given.change("marks.hatch.budget", "123");
    EXPECT_EQ(planned(given.call()).marks.layers[1].budget, 123);
    given.desc.mark_kinds = "stipples"; // They replace the settings' layers.
    const Marks stipples = planned(given.call()).marks;
    ASSERT_EQ(stipples.layers.size(), 1U);
    EXPECT_NE(stipples.layers[0].budget, 40000);
}

TEST(Plan, ANamedStyleOverridesSettings) {
    PlannedCall given;
    given.settings = read_settings(R"({"hrbfnpr-settings": 1, "preset": "hatch", "pen": 2,
        "style": {"halo_width": 30}, "marks": {"tone_ranges": "in_turn", "layers": [{"kind": "stipples"}]}})",
                                   given.pool);
    given.desc.style_name = "scientific-stipple";
    const Planned made = planned(given.call());
    EXPECT_LT(made.style.base.halo_width, 10.0F);
    EXPECT_NE(made.marks.layers[0].budget, 40000);
    EXPECT_FLOAT_EQ(made.marks.layers[0].tone_begin, 0.08F); // Only the caller's tone_ranges replace the style's range.
    EXPECT_EQ(made.marks.base.tone_ranges, std::uint32_t{HRBFNPR_TONE_RANGES_IN_TURN});
}

TEST(Plan, PaintReachesTheLayers) {
    auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
    dab.normal[2] = dab.radius = 1.0;
    dab.map = HRBFNPR_DAB_DENSITY;
    PlannedCall given;
    given.desc.dabs = &dab;
    given.desc.dab_count = 1;
    EXPECT_EQ(planned(given.call()).marks.layers[0].density, std::uint32_t{HRBFNPR_DENSITY_FIELD});
}

TEST(Plan, FieldsReachTheStyleAndTheMarks) {
    PlannedCall given(HRBFNPR_PRESET_CROSS_HATCH);
    given.change("style.field", "tone=quality:0..1,direction=flow,mask=good").change("style.hatch.mask_field", "");
    given.change("style.palette", "#ff0000,#00ff00");
    const Planned made = planned(given.call());
    for (const hrbfnpr_layer_style& layer : made.style.layers) EXPECT_STREQ(layer.tone_field, "quality:0..1");
    const hrbfnpr_layer_style hatch = made.style.style_of(HRBFNPR_LAYER_KIND_HATCH, nullptr);
    EXPECT_EQ(hatch.mask_field, nullptr);
    EXPECT_STREQ(made.style.style_of(HRBFNPR_LAYER_KIND_OWN, nullptr).mask_field, "good");
    EXPECT_EQ(made.marks.direction_field, "flow");
    ASSERT_EQ(made.style.palette.size(), 2U);
    EXPECT_EQ(made.style.palette[1], (std::array{0.0F, 1.0F, 0.0F, 1.0F}));
}

TEST(Plan, APartGetsItsShareOfABudget) {
    base::Memory memory;
    Pool pool(memory);
    Marks marks(pool);
    for (const std::int64_t budget : {std::int64_t{1001}, std::int64_t{3}, std::int64_t{0}}) {
        marks.layers.push_back(defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init));
        marks.layers.back().budget = budget;
    }
    const Marks part = share_of(marks, 0.5);
    EXPECT_EQ(part.layers[0].budget, 500); // 500.5 is rounded to the even number.
    EXPECT_EQ(part.layers[1].budget, 2);
    EXPECT_EQ(part.layers[2].budget, 0); // A share of no limit is no limit.
    EXPECT_EQ(share_of(marks, 1e-9).layers[0].budget, 1);
}

TEST(Plan, InvalidAreasGiveOneMark) {
    PlannedCall given(HRBFNPR_PRESET_STIPPLE);
    EXPECT_EQ(planned(given.call(), 800.0, 600.0, std::numeric_limits<double>::quiet_NaN()).marks.layers[0].budget, 1);
    EXPECT_EQ(planned(given.call(), 800.0, 600.0, 0.0).marks.layers[0].budget, 1);
    given.change("marks.distribution", "published");
    EXPECT_EQ(planned(given.call(), 800.0, 600.0, std::numeric_limits<double>::infinity()).marks.layers[0].levels, 6);
    EXPECT_EQ(planned(given.call(), 800.0, 600.0, 0.0).marks.layers[0].levels, 1);
}

TEST(Plan, PlacingMarksIsReportedAsAStage) {
    PlannedCall given(HRBFNPR_PRESET_HATCH);
    given.change("marks.layers.budget", "300");
    const Call call = given.call();
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 60; ++i) { // The points are on a sphere.
        const double z = -1.0 + (2.0 * i + 1.0) / 60.0;
        const double angle = 2.399963 * i;
        points.emplace_back(std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
    }
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    fit.points = fit.normals = {points.data(), 60, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const Model model = make<Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
        return hrbfnpr_model_fit(&call.context, &fit, nullptr, made, error);
    });
    const PointSet set = generate_marks(call, model, planned(call).marks, nullptr);
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    ASSERT_EQ(hrbfnpr_point_set_get_info(set.get(), &info, nullptr), HRBFNPR_STATUS_OK);
    ASSERT_EQ(given.report->stages.size(), 1U);
    EXPECT_EQ(given.report->stages[0].stage, std::uint32_t{HRBFNPR_STAGE_MARKS});
    EXPECT_EQ(std::string(given.report->stages[0].says), std::to_string(info.marks) + " marks: stipples, hatch");
    EXPECT_EQ(sides_of(call, model), std::uint32_t{HRBFNPR_SIDES_FRONT});
    EXPECT_EQ(sides_of(call, Model()), std::uint32_t{HRBFNPR_SIDES_FRONT});
    given.desc.sides = HRBFNPR_PICTURE_SIDES_BOTH;
    EXPECT_EQ(sides_of(given.call(), Model()), std::uint32_t{HRBFNPR_SIDES_BOTH});
}

} // namespace
} // namespace picture_tests::plan_test
