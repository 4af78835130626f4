// SPDX-License-Identifier: MIT
// Tests that fits end where their samples end by default. Closed surfaces, and samples that tell nothing, stay whole.
#include "support/samples.h"
#include "trimmed.h"

#include <algorithm>
#include <cstring>

namespace api_test::fit_trim_test {
namespace {

TEST(FitTrim, EndsAnOpenSurfaceLikeASeparateTrim) {
    Error error;
    const Context context = make_context();
    const scenes::Samples open = zone(-1.0, 1.0, true);
    const Model model = fit(context, open);
    auto desc = made(hrbfnpr_trim_desc_init);
    desc.points = in(open.points);
    desc.normals = in(open.normals);
    hrbfnpr_model* made_model = nullptr;
    ASSERT_OK(hrbfnpr_model_trim(fit_whole(context, open).get(), &desc, nullptr, &made_model, error));
    const Model trimmed(made_model);
    const hrbfnpr_trim_info by_fit = info_of(model);
    const hrbfnpr_trim_info by_hand = info_of(trimmed);
    EXPECT_EQ(by_fit.is_trimmed, 1U);
    EXPECT_EQ(std::memcmp(&by_fit, &by_hand, sizeof by_fit), 0);
    EXPECT_EQ(stipples_of(context, model), stipples_of(context, trimmed));
    EXPECT_GT(lowest(stipples_of(context, model)), -1.0 * sphere_spacing);
}

TEST(FitTrim, UsesAllSamplesNotOnlyTheCentres) {
    Error error;
    const Context context = make_context();
    const scenes::Samples open = zone(0.0, 1.0);
    hrbfnpr_fit_desc desc = fit_desc(open);
    desc.maximum_centres = 60;
    hrbfnpr_model* made_model = nullptr;
    ASSERT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &made_model, error));
    const Model model(made_model);
    EXPECT_EQ(info_of(model).samples, whole / 2);
    EXPECT_EQ(info_of(model).is_trimmed, 1U);
    const std::vector<float> stipples = stipples_of(context, model);
    for (std::size_t i = 2; i < stipples.size(); i += 3) EXPECT_GT(stipples[i], -1.0 * sphere_spacing);
}

// A closed surface is not trimmed, so its marks have the same bits as those of a fit without trimming.
TEST(FitTrim, LeavesClosedSurfacesUnchanged) {
    const Context context = make_context();
    for (const scenes::Samples& closed : {scenes::trefoil(600), zone(-1.0, 1.0)}) {
        const Model model = fit(context, closed);
        EXPECT_EQ(info_of(model).is_trimmed, 0U);
        EXPECT_EQ(info_of(model).samples, static_cast<std::int64_t>(closed.points.size() / 3));
        EXPECT_GT(info_of(model).spacing, 0.0);
        EXPECT_EQ(stipples_of(context, model), stipples_of(context, fit_whole(context, closed)));
    }
}

// A hole that is larger than the gaps between samples is found, though all other samples are surrounded.
TEST(FitTrim, FindsAHoleInAClosedSurface) {
    const Context context = make_context();
    const Model model = fit(context, zone(-1.0, 0.9));
    EXPECT_EQ(info_of(model).is_trimmed, 1U);
    EXPECT_EQ(info_of(model).parts, 1);
    EXPECT_EQ(info_of(model).parts_to_end, 0);
    EXPECT_NEAR(info_of(model).share, 0.05, 0.03);
}

// All of the surface between wires and between cross sections stays, and so does the part beyond the last section that
// closes it.
TEST(FitTrim, KeepsASurfaceSpannedByWiresOrSections) {
    const Context context = make_context();
    const Model wires = fit(context, hrbfnpr::test::torus_wires(0.08));
    EXPECT_EQ(info_of(wires).is_trimmed, 0U);
    const Model sections = fit(context, hrbfnpr::test::torus_sections(9, 60));
    EXPECT_EQ(info_of(sections).is_trimmed, 0U);
    const std::vector<float> stipples = stipples_of(context, sections);
    float farthest = 0.0F;
    for (std::size_t i = 0; i < stipples.size(); i += 3) farthest = std::max(farthest, std::abs(stipples[i]));
    EXPECT_GT(farthest, 3.85F); // at most 4; the box of the samples ends at 3, and margins at 3.6
}

TEST(FitTrim, EndsAnOpenSurfaceOfParallelLines) {
    const Context context = make_context();
    scenes::Samples lines;
    for (int line = 0; line < 6; ++line)
        for (int i = 0; i < 60; ++i) lines.add({0.05 * i, 0.6 * line, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_EQ(info_of(fit(context, lines)).is_trimmed, 1U);
}

TEST(FitTrim, EndsAFlatSquareAtItsBorder) {
    const Context context = make_context();
    const Model model = fit(context, square());
    EXPECT_GE(info_of(model).parts_to_end, 1);
    for (const float coordinate : stipples_of(context, model)) {
        EXPECT_GT(coordinate, -0.1);
        EXPECT_LT(coordinate, 0.9 + 0.1);
    }
}

// One, two or three samples, and samples on a line, keep a surface without an end.
TEST(FitTrim, KeepsTheWholeSurfaceOfTooFewSamples) {
    const Context context = make_context();
    for (const int count : {1, 2, 3, 4, 9, 30}) {
        scenes::Samples samples;
        for (int i = 0; i < count; ++i) samples.add({0.1 * i, count == 4 ? 0.1 * (i % 2) : 0.0, 0.0}, {0.0, 0.0, 1.0});
        const Model model = fit(context, samples);
        EXPECT_GT(stipples_of(context, model).size(), std::size_t{3 * 3500}) << count;
        if (count >= 10) continue;
        EXPECT_EQ(info_of(model).samples, 0) << count;
        EXPECT_EQ(stipples_of(context, model), stipples_of(context, fit_whole(context, samples))) << count;
    }
}

} // namespace
} // namespace api_test::fit_trim_test
