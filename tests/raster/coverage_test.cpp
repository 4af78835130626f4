// SPDX-License-Identifier: MIT
// Tests tone by coverage: the ink covers the requested part of the paper at any zoom, and marks fade.
#include "frame/depth_layers/gather.h"
#include "frame/line_of_sight.h"
#include "generate/generate.h"
#include "raster/picture.h"
#include "support/analytic.h"

#include <gtest/gtest.h>

#include <array>

namespace hrbfnpr::testing::coverage_test {
namespace {

using frame::ToneCurve;

constexpr int size = 400;

// A square of side 2 in the plane z = 0 with evenly spread stipples in a blue-noise order.
marks::PointSet patch(const base::Runtime& runtime, std::int64_t marks) {
    const test::Plane plane({0.0, 0.0, 1.0}, 0.0, {{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
    generate::Settings settings;
    settings.layers.emplace_back().budget = marks;
    return clustered(runtime, generate::generate(runtime, plane, {}, settings));
}

// Draws front ink only; tau is the cosine of the light.
Style toned(double tau) {
    Style style;
    style.hidden_lines = frame::HiddenLines::show;
    style.contour_kinds = 0;
    style.light = {std::sqrt(1.0 - tau * tau), 0.0, tau};
    return style;
}

class Coverage : public ::testing::Test {
protected:
    void draw(const marks::PointSet& set, const Style& style, const frame::Camera& camera) {
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera);
    }
    // Returns the darkness of the picture's middle.
    double covered(const marks::PointSet& set, const Style& style, double half) {
        const std::array items{layered_item(set, style)};
        return picture_of(runtime, items, front_camera(size, size, half), size, size)
            .darkness(20, 20, size - 20, size - 20);
    }
    // Returns the area of each mark's ink over that of a full mark.
    std::vector<double> areas(std::int64_t marks, double radius) const {
        std::vector<double> result(static_cast<std::size_t>(marks) + 1, 0.0);
        for (const Disc& disc : frame.discs())
            result[disc.id] = static_cast<double>(disc.radius) * static_cast<double>(disc.radius) / (radius * radius);
        return result;
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
};

// Tells whether the marks are enough for this coverage and for 0.6, with some to spare.
bool enough(std::int64_t budget, double half, float radius, double coverage) {
    // The patch is about 1.18 times as large as the requested box.
    const double density = static_cast<double>(budget) / 4.7 * std::pow(2.0 * half / size, 2.0);
    const double ink = density * pi * static_cast<double>(radius * radius);
    return ink > 1.3 * static_cast<double>(frame::ink_for(static_cast<float>(std::max(coverage, 0.6)),
                                                          frame::Overlap::blue_noise, 1.0F));
}

TEST_F(Coverage, MatchesTheToneForAnyMarkSizeZoomAndBudget) {
    int judged = 0;
    for (const std::int64_t budget : {20000, 60000}) {
        const marks::PointSet set = patch(runtime, budget);
        for (const double half : {0.5, 0.8}) {
            for (const float radius : {1.0F, 1.5F, 2.5F, 4.0F}) {
                for (const float fade : {0.0F, 0.25F}) {
                    for (const double coverage : {0.05, 0.15, 0.3, 0.45}) {
                        if (!enough(budget, half, radius, coverage)) continue;
                        Style style = toned(1.0 - coverage);
                        style.kind[0].radius = radius;
                        style.tone_fade = fade;
                        EXPECT_NEAR(covered(set, style, half), coverage, 0.03)
                            << budget << " " << half << " " << radius << " " << fade;
                        ++judged;
                    }
                }
            }
        }
    }
    EXPECT_GT(judged, 60);
}

TEST_F(Coverage, MatchesDarkTones) {
    const marks::PointSet set = patch(runtime, 60000);
    for (const float radius : {2.5F, 4.0F}) {
        for (const double coverage : {0.6, 0.7, 0.8, 0.9}) {
            ASSERT_TRUE(enough(60000, 0.8, radius, coverage));
            Style style = toned(1.0 - coverage);
            style.kind[0].radius = radius;
            style.tone_fade = 0.0F;
            EXPECT_NEAR(covered(set, style, 0.8), coverage, 0.04) << radius;
        }
    }
}

TEST_F(Coverage, MatchesTheToneOfATiltedPatch) {
    const marks::PointSet set = patch(runtime, 60000);
    for (const double tilt : {0.4, 0.8, 1.1}) {
        Style style = toned(0.5);
        style.kind[0].radius = 1.5F;
        style.light_space = frame::LightSpace::world;
        const std::array items{layered_item(set, style)};
        const frame::Camera camera = camera_from({0.0, -std::sin(tilt), std::cos(tilt)}, size, 0.8);
        const Picture picture = picture_of(runtime, items, camera, size, size);
        EXPECT_NEAR(picture.darkness(150, 190, 250, 210), 0.5, 0.06) << tilt;
    }
}

TEST_F(Coverage, TooFewMarksAreAllShown) {
    const marks::PointSet set = patch(runtime, 4000);
    Style style = toned(0.1);
    style.tone_fade = 0.0F;
    draw(set, style, front_camera(size, size, 1.1));
    EXPECT_EQ(frame.info().shown, set.layers[0].count());
    EXPECT_EQ(frame.info().dropped_tone, 0);
}

TEST_F(Coverage, TooFewMarksMakeAllTonesPaler) {
    const marks::PointSet set = patch(runtime, 4000);
    const auto shown_at = [&](double coverage) {
        Style style = toned(1.0 - coverage);
        style.tone_fade = 0.0F;
        draw(set, style, front_camera(size, size, 1.1));
        return static_cast<double>(frame.info().shown);
    };
    const double all = static_cast<double>(set.layers[0].count());
    EXPECT_NEAR(shown_at(0.15) / all, 0.244, 0.01);
    EXPECT_NEAR(shown_at(0.3) / all, 0.488, 0.01);
    EXPECT_NEAR(shown_at(0.45) / all, 0.735, 0.01);
}

TEST_F(Coverage, ZoomingInNeverRemovesAMarkNorItsInk) {
    const marks::PointSet flat = patch(runtime, 20000);
    const marks::PointSet round = clustered(runtime, torus(runtime.memory, 110));
    for (const marks::PointSet* set : {&flat, &round}) {
        for (const float fade : {0.0F, 0.25F}) {
            Style style = toned(0.4);
            style.tone_fade = fade;
            style.fill_light = 0.0F; // counts many marks on the unlit side, too
            std::vector<double> before(static_cast<std::size_t>(set->layers[0].count()) + 1, 0.0);
            std::int64_t drawn = 0;
            for (double half = 2.0; half > 0.1; half /= 1.07) {
                draw(*set, style, front_camera(size, size, half));
                const std::vector<double> now = areas(set->layers[0].count(), 1.0);
                for (std::int64_t i = 0; i < set->layers[0].count(); ++i) {
                    const glm::dvec3 p = mark_of(*set, i).position;
                    const auto id = static_cast<std::size_t>(i) + 1;
                    if (std::max(std::abs(p.x), std::abs(p.y)) < half) {
                        ASSERT_GE(now[id], before[id] - 1e-4) << half << " " << id;
                    }
                    drawn += now[id] > 0.0;
                }
                before = now;
            }
            EXPECT_GT(drawn, 100000);
        }
    }
}

// Ink per area of random marks, interpolated between 64 steps as in a frame.
double ink_of_table(double coverage) {
    const double at = 64.0 * coverage;
    const double cell = std::min(std::floor(at), 63.0);
    const auto ink = [](double step) {
        return static_cast<double>(frame::ink_for(static_cast<float>(step / 64.0), frame::Overlap::random, 0.0F));
    };
    return ink(cell) + (ink(cell + 1.0) - ink(cell)) * (at - cell);
}

TEST_F(Coverage, SmallChangesOfLightChangeInkOnlyALittle) {
    const marks::PointSet set = clustered(runtime, sphere(runtime.memory, 20000));
    const frame::Camera camera = front_camera(size, size);
    const double fade = 0.25;
    const auto light = [](double angle) { return glm::dvec3(std::sin(angle), 0.3, std::cos(angle)); };
    for (const ToneCurve curve : {ToneCurve::linear, ToneCurve::coverage}) {
        std::vector<double> before;
        for (int step = 0; step < 20; ++step) {
            Style style = toned(0.5);
            style.tone_curve = curve;
            style.tone_fade = static_cast<float>(fade);
            style.light = light(0.004 * step);
            draw(set, style, camera);
            const std::vector<double> now = areas(set.layers[0].count(), 1.0);
            for (std::int64_t i = 0; step > 0 && i < set.layers[0].count(); ++i) {
                const Mark mark = mark_of(set, i);
                // The share of the marks that is shown. A mark grows over the `fade`-th part of it.
                const auto needed = [&](int at) {
                    const double lit = glm::dot(mark.normal, glm::normalize(light(0.004 * at)));
                    const double tau = lit > 0.0 ? lit : double{style.fill_light} * lit * lit;
                    const double dark = 1.0 - std::min(tau, 0.999);
                    return curve == ToneCurve::linear ? dark : ink_of_table(dark);
                };
                const double least = std::min(needed(step), needed(step - 1));
                const double change = std::abs(needed(step) - needed(step - 1)) / (fade * least);
                const auto id = static_cast<std::size_t>(i) + 1;
                ASSERT_LE(std::abs(now[id] - before[id]), 1.1 * change + 0.02) << id << " " << step;
            }
            before = now;
            // A second draw gives the same bits.
            const std::vector<Disc> discs(frame.discs().begin(), frame.discs().end());
            draw(set, style, camera);
            ASSERT_EQ(frame.discs().size(), discs.size());
            for (std::size_t i = 0; i < discs.size(); ++i) {
                ASSERT_EQ(frame.discs()[i].id, discs[i].id);
                ASSERT_EQ(frame.discs()[i].radius, discs[i].radius);
            }
        }
    }
}

TEST_F(Coverage, FadesOnlyIfEnabled) {
    const marks::PointSet set = patch(runtime, 20000);
    Style style = toned(0.6);
    style.tone_fade = 0.0F;
    style.kind[0].radius = 1.25F;
    draw(set, style, front_camera(size, size));
    EXPECT_GT(frame.discs().size(), 1000U);
    for (const Disc& disc : frame.discs()) ASSERT_EQ(disc.radius, 1.25F);
    style.tone_fade = 0.25F;
    draw(set, style, front_camera(size, size));
    std::array<std::int64_t, 4> quarters{}; // counts of discs by quarters of the full area
    for (const Disc& disc : frame.discs()) {
        const float area = disc.radius * disc.radius / (1.25F * 1.25F);
        ++quarters[static_cast<std::size_t>(std::min(3.0F, 4.0F * area))];
    }
    // A quarter of the discs grows, at an even pace.
    const auto all = static_cast<double>(frame.discs().size());
    for (std::size_t q = 0; q < 3; ++q) EXPECT_NEAR(static_cast<double>(quarters[q]), all / 16.0, 0.03 * all);
}

TEST_F(Coverage, LinearShowsTheShareOfTheMarks) {
    const marks::PointSet set = patch(runtime, 20000);
    for (const double tau : {0.2, 0.5, 0.8}) {
        Style style = toned(tau);
        style.tone_curve = ToneCurve::linear;
        style.tone_fade = 0.0F;
        draw(set, style, front_camera(size, size));
        EXPECT_NEAR(static_cast<double>(frame.info().shown), (1.0 - tau) * 20000.0, 30.0);
        EXPECT_EQ(frame.info().shown + frame.info().dropped_tone + frame.info().culled, frame.info().marks);
    }
}

} // namespace
} // namespace hrbfnpr::testing::coverage_test
