// SPDX-License-Identifier: MIT
// Tests each law against its formula.
#include "frame/scene/light.h"
#include "frame/scene/scene.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>

namespace hrbfnpr::frame::laws_test {
namespace {

TEST(FrontAlpha, IsTheSquareOfTheCosine) {
    EXPECT_FLOAT_EQ(front_alpha(-0.2F, 1.0F), 0.04F);
    EXPECT_FLOAT_EQ(front_alpha(-0.5F, 1.0F), 0.25F);
    EXPECT_FLOAT_EQ(front_alpha(-0.5F, 2.0F), 0.5F);
    EXPECT_FLOAT_EQ(front_alpha(-1.0F, 1.0F), 1.0F);
    EXPECT_FLOAT_EQ(front_alpha(-1.0F, 3.0F), 1.0F); // clamped
    EXPECT_FLOAT_EQ(front_alpha(-0.7F, 0.0F), 0.0F);
}

TEST(BackAlpha, IsLogarithmicInTheCosine) {
    // 0.2 (ln(nu - 0.05) + 5), computed by hand.
    EXPECT_NEAR(back_alpha(1.0F, 1.0F), 0.98974134F, 1e-6);
    EXPECT_NEAR(back_alpha(0.5F, 1.0F), 0.84029846F, 1e-6);
    EXPECT_NEAR(back_alpha(0.2F, 1.0F), 0.62057601F, 1e-6);
    EXPECT_NEAR(back_alpha(0.2F, 0.5F), 0.31028801F, 1e-6);
    EXPECT_EQ(back_alpha(0.05F, 1.0F), 0.0F);
    EXPECT_EQ(back_alpha(0.01F, 1.0F), 0.0F);
    EXPECT_EQ(back_alpha(0.051F, 1.0F), 0.0F); // ln(0.001) + 5 < 0
    EXPECT_EQ(back_alpha(1.0F, 4.0F), 1.0F);
}

TEST(DiscOpacity, GivesALayerTheRequestedOpacity) {
    EXPECT_EQ(disc_opacity(0.3F, 0.0F, 7.0F), 0.3F); // the published law
    EXPECT_EQ(disc_opacity(1.0F, 8.0F, 7.0F), 1.0F);
    EXPECT_EQ(disc_opacity(0.0F, 8.0F, 7.0F), 0.0F);
    for (const float alpha : {0.04F, 0.3F, 0.9F}) {
        for (const float overlap : {1.0F, 3.5F, 40.0F}) {
            const float each = disc_opacity(alpha, 8.0F, overlap);
            EXPECT_NEAR(std::pow(1.0F - each, overlap), std::pow(1.0F - alpha, 8.0F), 1e-5F);
        }
    }
}

TEST(ExpectedOverlap, IsDiscAreaOverTheAreaOfAMark) {
    EXPECT_NEAR(expected_overlap(3.0F, 2.0F, -1.0F), 7.0686F, 1e-3);
    EXPECT_NEAR(expected_overlap(3.0F, 2.0F, 0.5F), 14.137F, 1e-3); // foreshortened
    EXPECT_EQ(expected_overlap(0.1F, 2.0F, 1.0F), 1.0F);
    EXPECT_EQ(expected_overlap(3.0F, 0.0F, 1.0F), 1.0F); // spacing unknown
}

TEST(DepthTone, FallsWithTheLogarithmFromNearToFar) {
    EXPECT_EQ(depth_tone(1.0, 2.0, 8.0), 1.0F);
    EXPECT_EQ(depth_tone(2.0, 2.0, 8.0), 1.0F);
    EXPECT_FLOAT_EQ(depth_tone(4.0, 2.0, 8.0), 0.5F); // the geometric mean
    EXPECT_FLOAT_EQ(depth_tone(3.0, 2.0, 8.0), static_cast<float>(1.0 - std::log(1.5) / std::log(4.0)));
    EXPECT_EQ(depth_tone(8.0, 2.0, 8.0), 0.0F);
    EXPECT_EQ(depth_tone(100.0, 2.0, 8.0), 0.0F);
    EXPECT_EQ(depth_tone(-3.0, 2.0, 8.0), 1.0F); // an orthographic camera may be anywhere
}

TEST(ZoomScale, IsThePowerOfTheZoomBelowTheReference) {
    EXPECT_EQ(zoom_scale(2.0F, 2.0F), 1.0F);
    EXPECT_FLOAT_EQ(zoom_scale(0.5F, 2.0F), 0.25F);
    EXPECT_FLOAT_EQ(zoom_scale(0.5F, 1.0F), 0.5F);
    EXPECT_EQ(zoom_scale(0.5F, 0.0F), 1.0F);
    EXPECT_EQ(zoom_scale(0.0F, 2.0F), 0.0F);
}

TEST(ShareRule, ThinsMarksByOneCombinedThreshold) {
    const ToneTerms terms{0.25F, 0.5F, 0.5F, 0.8F};
    // u >= 1 - (1 - tau) tau_d scale share = 1 - 0.15.
    EXPECT_EQ(front_verdict(0.8501F, terms, ToneRule::share), Verdict::shown);
    EXPECT_EQ(front_verdict(0.8499F, terms, ToneRule::share), Verdict::depth);
    EXPECT_EQ(front_verdict(0.6999F, terms, ToneRule::share), Verdict::zoom);
    EXPECT_EQ(front_verdict(0.3999F, terms, ToneRule::share), Verdict::tone);
    EXPECT_EQ(front_verdict(0.0F, {}, ToneRule::share), Verdict::shown);
    EXPECT_EQ(front_verdict(0.9999999F, {1.0F, 1.0F, 1.0F, 1.0F}, ToneRule::share), Verdict::tone);
    EXPECT_TRUE(silhouette_shown(0.75F, 0.25F, ToneRule::share));
    EXPECT_FALSE(silhouette_shown(0.74F, 0.25F, ToneRule::share));
    EXPECT_FALSE(silhouette_shown(0.9999999F, 0.0F, ToneRule::share));
}

TEST(PublishedRule, TestsToneDepthAndZoomSeparately) {
    const ToneTerms terms{0.25F, 0.5F, 0.6F, 0.8F};
    EXPECT_EQ(front_verdict(0.25F, terms, ToneRule::published), Verdict::shown);
    EXPECT_EQ(front_verdict(0.24F, terms, ToneRule::published), Verdict::tone);
    EXPECT_EQ(front_verdict(0.51F, terms, ToneRule::published), Verdict::depth);
    EXPECT_EQ(front_verdict(0.61F, terms, ToneRule::published), Verdict::zoom);
    EXPECT_EQ(front_verdict(0.80F, terms, ToneRule::published), Verdict::tone);
    EXPECT_TRUE(silhouette_shown(0.24F, 0.25F, ToneRule::published));
    EXPECT_FALSE(silhouette_shown(0.25F, 0.25F, ToneRule::published));
}

struct PenTest : ::testing::Test {
    Style style; // its halo_width is 2
    LayerStyle layer;
    DiscSizes discs{&style, &layer, 0.1F, 0.0F, 0.0F, 1000.0F};
};

TEST_F(PenTest, FollowsTheZoom) {
    layer.radius = 2.0F;
    EXPECT_EQ(discs.front_ink(10.0F), 2.0F); // without a reference the zoom is 1
    layer.radius_zoom = 1.0F;
    EXPECT_EQ(discs.front_ink(10.0F), 2.0F);
    discs.zoom_at_one = 1.0F / 40.0F;
    EXPECT_FLOAT_EQ(discs.front_ink(10.0F), 0.5F);
    EXPECT_FLOAT_EQ(discs.front_ink(80.0F), 4.0F); // also beyond the reference
    layer.radius_zoom = 0.5F;
    EXPECT_FLOAT_EQ(discs.front_ink(10.0F), 1.0F);
}

TEST_F(PenTest, ScalesTheAreaOfBackPaper) {
    style.splat_radius = 6.0F;
    EXPECT_EQ(discs.front_splat(10.0F), 6.0F);
    EXPECT_EQ(discs.back_splat(10.0F), 8.0F);
    discs.zoom_at_one = 1.0F / 40.0F;
    style.zoom_exponent = 2.0;
    EXPECT_EQ(discs.front_splat(10.0F), 6.0F);
    EXPECT_FLOAT_EQ(discs.back_splat(10.0F), 2.0F); // area times 1/16
    EXPECT_FLOAT_EQ(discs.back_splat(80.0F), 8.0F);
}

TEST_F(PenTest, CoversBySpacingWithNoGaps) {
    EXPECT_FLOAT_EQ(discs.front_splat(100.0F), scene_tuning.splat_spacings * 10.0F);
    EXPECT_FLOAT_EQ(discs.back_splat(100.0F), scene_tuning.splat_spacings * 10.0F + 2.0F);
    EXPECT_EQ(discs.front_splat(1.0F), 1.0F); // at least a pixel
    EXPECT_EQ(discs.front_splat(1e9F), 1000.0F);
}

TEST(PaperPush, GrowsWithTheTilt) {
    EXPECT_FLOAT_EQ(front_push(5.0F, -1.0F, 10.0F), 0.5F);
    EXPECT_NEAR(front_push(5.0F, -0.6F, 10.0F), 0.5F * 1.8F / 0.6F, 1e-6F);
    EXPECT_NEAR(front_push(5.0F, 0.0F, 10.0F), 0.5F * 2.0F / 0.05F, 0.1F); // limited
    EXPECT_FLOAT_EQ(back_push(5.0F, 10.0F), 0.5F);
}

// The disc around each place of a sphere is behind every place within its radius in the picture.
TEST(PaperPush, PutsADiscBehindTheWholeSphere) {
    for (const double radius : {0.003, 0.01, 0.05, 0.2, 0.5}) {
        for (double nu = 0.05; nu <= 1.0; nu += 0.01) {
            const double from_axis = std::sqrt(1.0 - nu * nu);
            const double behind =
                nu - static_cast<double>(front_push(static_cast<float>(radius), static_cast<float>(-nu), 1.0F));
            const double farthest = std::min(1.0, from_axis + radius);
            EXPECT_LE(behind, std::sqrt(1.0 - farthest * farthest) + 1e-6) << radius << " " << nu;
        }
    }
}

// A mark that is shown stays while the zoom grows, the tone darkens or the depth decreases.
TEST(FrontVerdict, ZoomingInOnlyAddsMarks) {
    for (float u = 0.005F; u < 1.0F; u += 0.01F)
        for (const float tau : {0.0F, 0.3F, 0.8F}) {
            bool shown = false;
            for (float zoom = 0.05F; zoom < 3.0F; zoom *= 1.1F) {
                const ToneTerms terms{tau, 0.9F, zoom_scale(zoom, 2.0F), 0.7F};
                const bool now = front_verdict(u, terms, ToneRule::share) == Verdict::shown;
                EXPECT_TRUE(now || !shown) << u << " at zoom " << zoom;
                shown = now;
            }
        }
}

} // namespace
} // namespace hrbfnpr::frame::laws_test
