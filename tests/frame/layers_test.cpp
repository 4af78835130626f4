// SPDX-License-Identifier: MIT
// Tests what layers of surface hide and dim, against lines of sight through known solids.
#include "frame/line_of_sight.h"
#include "frame/scene/light.h"
#include "support/analytic.h"

#include <gtest/gtest.h>

#include <array>

namespace hrbfnpr::testing::layers_test {
namespace {

using frame::HiddenLines;

class LayersTest : public ::testing::Test {
protected:
    const drawing::Counts& draw(std::span<const frame::Item> items, const frame::Camera& camera) {
        frame.draw(items, camera);
        return frame.info();
    }
    std::vector<float> seen(const marks::PointSet& set, const Style& style, const frame::Camera& camera) {
        const std::array items{layered_item(set, style)};
        draw(items, camera);
        return seen_share(frame, set.layers[0].count());
    }
    // Expects that marks of the unit sphere are fully visible. Within a pixel of the contour, where the depth of a
    // surface changes by many pixels in one pixel, the share `most_lost` may be lost.
    template <class Toward>
    void expect_whole(double most_lost, const Toward& toward) {
        const drawing::Drawing& drawing = frame.drawing();
        std::int64_t at_rim = 0;
        std::int64_t lost = 0;
        for (const drawing::IndexRange& piece : drawing.dot_ranges) {
            for (std::int64_t i = piece.begin; i < piece.end; ++i) {
                const drawing::Dot& dot = drawing.dots[i];
                const glm::dvec3 place(drawing.source(dot.id).position);
                const double cosine = glm::dot(place, toward(place));
                const double off =
                    (1.0 - std::sqrt(std::max(0.0, 1.0 - cosine * cosine))) * static_cast<double>(dot.pixels_per_unit);
                if (off > 1.05) {
                    ASSERT_EQ(dot.opacity, 1.0F) << dot.id << ", " << off << " pixels inside of the contour";
                } else {
                    ++at_rim;
                    lost += dot.opacity < 1.0F;
                }
            }
        }
        EXPECT_LE(static_cast<double>(lost), most_lost * static_cast<double>(at_rim));
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
};

constexpr HiddenLines hiding[] = {HiddenLines::attenuate, HiddenLines::hide};

TEST_F(LayersTest, ASphereNeverDimsItsOwnFront) {
    for (const int count : {3000, 20000, 100000}) {
        const marks::PointSet set = clustered(runtime, sphere(runtime.memory, count));
        for (const HiddenLines hidden : hiding) {
            for (const double half : {0.6, 1.25, 6.0}) {
                const std::array items{layered_item(set, all_front(hidden))};
                const drawing::Counts& info = draw(items, front_camera(500, 500, half));
                EXPECT_EQ(info.shown + info.dropped_hidden, info.front);
                EXPECT_GT(info.splats, 0);
                expect_whole(0.005, [](const glm::dvec3&) { return glm::dvec3(0.0, 0.0, 1.0); });
                frame::Camera near_by = front_camera(500, 500, half);
                const glm::dvec3 eye(0.0, 1.0, 2.5);
                near_by.view = frame::look_at(eye, glm::dvec3(0.0), {0, 1, 0});
                near_by.projection = frame::perspective(0.5 * half, 500, 500, 0.1, 20.0, near_by.depth);
                draw(items, near_by);
                expect_whole(0.05, [&](const glm::dvec3& place) { return glm::normalize(eye - place); });
            }
        }
    }
}

// With 100 marks on 400 pixels, discs of layers stand out of their surface by more than the gap in front of it.
TEST_F(LayersTest, ASparseSphereNeverDimsItsOwnFront) {
    for (const int count : {100, 300}) {
        const marks::PointSet set = clustered(runtime, sphere(runtime.memory, count));
        const std::array items{layered_item(set, all_front(HiddenLines::attenuate))};
        frame::Camera camera = front_camera(500, 500);
        camera.view = frame::look_at({0.3, 1.0, 5.0}, glm::dvec3(0.0), {0, 1, 0});
        camera.projection = frame::perspective(0.5, 500, 500, 0.1, 20.0, camera.depth);
        EXPECT_EQ(draw(items, camera).dropped_hidden, 0) << count;
        for (const Disc& disc : frame.discs()) EXPECT_EQ(disc.color.w, 1.0F) << count << ", mark " << disc.id;
    }
}

// A halo extends from the contour, and the sphere's own front is beside the contour.
TEST_F(LayersTest, AHaloLeavesItsOwnFrontAlone) {
    const marks::PointSet set = clustered(runtime, sphere(runtime.memory, 100000));
    Style style = all_front(HiddenLines::hide);
    style.tone_fade = 0.25F;
    style.halo_width = 0.0F;
    const std::array without{layered_item(set, style)};
    const std::int64_t all = draw(without, front_camera(500, 500)).shown;
    style.halo_width = 2.0F;
    const std::array with{layered_item(set, style)};
    EXPECT_GE(draw(with, front_camera(500, 500)).shown, all - all / 1000);
}

TEST_F(LayersTest, APlaneNeverDimsItselfAtAnyTilt) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 100));
    for (const HiddenLines hidden : hiding) {
        for (const double tilt : {0.0, 0.3, 0.6, 0.9, 1.2, 1.35, 1.45, 1.5}) {
            const frame::Camera camera = camera_from({0.0, -std::sin(tilt), std::cos(tilt)}, 400, 1.25);
            const std::array items{layered_item(set, all_front(hidden))};
            EXPECT_EQ(draw(items, camera).front, 10000) << tilt;
            EXPECT_EQ(frame.info().shown, 10000) << tilt;
            for (const Disc& disc : frame.discs()) ASSERT_EQ(disc.color.w, 1.0F) << tilt;
        }
    }
}

// Counts the marks of a torus that a line of sight finds hidden or visible, and those for which the frame disagrees.
struct Agreement {
    int hidden = 0, seen = 0;             // by the line of sight, away from contours
    int lost = 0, dimmed = 0, leaked = 0; // seen but not drawn, or not wholly; hidden but drawn
};

Agreement agreement(const marks::PointSet& set, const Solid& solid, const std::vector<float>& share,
                    const glm::dvec3& toward, double band) {
    Agreement result;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const Mark mark = mark_of(set, i);
        if (glm::dot(mark.normal, toward) < 0.2) continue; // the back, and marks at the contour
        const double clear = own_clearance(solid, mark.position, toward);
        const float drawn = share[static_cast<std::size_t>(i) + 1];
        if (clear > band) {
            ++result.seen;
            result.lost += drawn < 0.0F;
            result.dimmed += drawn >= 0.0F && drawn != 1.0F;
        } else if (clear < -band) {
            ++result.hidden;
            result.leaked += drawn > 0.0F;
        }
    }
    return result;
}

TEST_F(LayersTest, ATorusHidesMarksLikeLinesOfSight) {
    int hidden = 0;
    for (const int rings : {90, 200}) {
        const marks::PointSet set = clustered(runtime, torus(runtime.memory, rings));
        for (const double tilt : {0.0, 0.4, 0.8, 1.0, 1.2, 1.35, 1.5}) {
            const glm::dvec3 toward(0.3 * std::sin(tilt), -std::sin(tilt), std::cos(tilt));
            const glm::dvec3 unit = glm::normalize(toward);
            for (const double half : {1.6, 0.8}) {
                const double pixel = 2.0 * half / 500.0;
                const Style style = all_front(HiddenLines::hide);
                // Marks represent a layer up to a spacing beyond the last mark.
                const double band = (2.0 + 2.0) * pixel + set.spacing;
                const std::vector<float> share = seen(set, style, camera_from(toward, 500, half));
                Agreement found = agreement(set, ring(), share, unit, band);
                if (half < 1.5) { // not all of the torus is inside the picture
                    found.lost = 0;
                }
                // Splats of random marks leave gaps, and extend a little too far: one mark in ten thousand.
                EXPECT_LE(found.lost, 3) << rings << " " << tilt << " " << half << " of " << found.seen;
                EXPECT_EQ(found.dimmed, 0) << rings << " " << tilt << " " << half << " of " << found.seen;
                EXPECT_EQ(found.leaked, 0) << rings << " " << tilt << " " << half << " of " << found.hidden;
                hidden += found.hidden;
                const std::vector<float> dimmed =
                    seen(set, all_front(HiddenLines::attenuate), camera_from(toward, 500, half));
                found = agreement(set, ring(), dimmed, unit, band);
                EXPECT_EQ(found.dimmed, 0) << rings << " " << tilt << " " << half << " of " << found.seen;
            }
        }
    }
    EXPECT_GT(hidden, 5000);
}

TEST_F(LayersTest, FewMarksAreWrongNearAHidingContour) {
    // Includes all marks that are uncertain in the test above. Within a band of 2 px and the halo either result is
    // allowed, but not beyond it.
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 300));
    const double pixel = 3.2 / 600.0;
    std::int64_t wrong = 0;
    std::int64_t selected = 0;
    for (const double tilt : {0.9, 1.1, 1.3}) {
        const glm::dvec3 toward = glm::normalize(glm::dvec3(0.0, -std::sin(tilt), std::cos(tilt)));
        const Style style = all_front(HiddenLines::hide);
        const std::vector<float> share = seen(set, style, camera_from(toward, 600, 1.6));
        const Agreement found =
            agreement(set, ring(), share, toward, (2.0 + static_cast<double>(style.halo_width)) * pixel);
        wrong += found.lost + found.dimmed + found.leaked;
        selected += found.seen + found.hidden;
    }
    EXPECT_GT(selected, 50000);
    EXPECT_LE(static_cast<double>(wrong), 2e-4 * static_cast<double>(selected)) << wrong;
}

TEST_F(LayersTest, CuspsOfAnObliqueTorusLetNoInkThrough) {
    // Marks beside contours, on the far side of the hole and around the cusps, must not shine through.
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 260));
    const Style style = all_front(HiddenLines::hide);
    for (const double tilt : {1.0, 1.05, 1.2, 1.35}) {
        const glm::dvec3 toward = glm::normalize(glm::dvec3(0.0, -std::sin(tilt), std::cos(tilt)));
        const std::vector<float> share = seen(set, style, camera_from(toward, 600, 1.6));
        const double pixel = 3.2 / 600.0;
        int hidden = 0;
        int leaked = 0;
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            const Mark mark = mark_of(set, i);
            if (!(glm::dot(mark.normal, toward) > 0.0 && glm::dot(mark.normal, toward) < 0.3)) continue;
            // The line of sight starts a little outside of the mark's own fold.
            const glm::dvec3 start = mark.position + 2.0 * pixel * mark.normal;
            if (!(clearance(ring(), start + 0.05 * toward, toward) < -6.0 * pixel)) continue;
            ++hidden;
            leaked += share[static_cast<std::size_t>(i) + 1] > 0.0F;
        }
        EXPECT_GT(hidden, 300) << tilt;
        EXPECT_EQ(leaked, 0) << tilt << ", of " << hidden;
    }
}

TEST_F(LayersTest, ABallInFrontDimsByTheLawsOfBothItsLayers) {
    const double radius = 0.8;
    const marks::PointSet front = clustered(runtime, sphere(runtime.memory, 30000, radius));
    const marks::PointSet behind = clustered(runtime, plane(runtime.memory, 120));
    Style style = all_front(HiddenLines::attenuate);
    style.attenuation_front = 0.5;
    style.attenuation_back = 0.3;
    style.splat_overlap = 2.0F;
    const std::array items{layered_item(behind, style, shifted({0.0, 0.0, -3.0})), layered_item(front, style)};
    draw(items, front_camera(800, 800, 1.0));
    const double pixel = 2.0 / 800.0;
    const std::vector<float> share = seen_share(frame, 14400 + 30000);
    double worst = 0.0;
    int selected = 0;
    for (std::int64_t i = 0; i < 14400; ++i) {
        const Mark mark = mark_of(behind, i);
        const double off = std::hypot(mark.position.x, mark.position.y);
        const float drawn = share[static_cast<std::size_t>(i) + 1];
        if (off > radius + (static_cast<double>(style.halo_width) + 2.0) * pixel) {
            ASSERT_EQ(drawn, 1.0F) << off;
        } else if (off < 0.8 * radius) {
            const auto nu = static_cast<float>(std::sqrt(1.0 - off * off / (radius * radius)));
            const float law = layer_transmittance(style, -nu, false) * layer_transmittance(style, nu, false);
            worst = std::max(worst, static_cast<double>(std::abs(drawn - law)));
            ++selected;
        }
    }
    EXPECT_GT(selected, 3000);
    EXPECT_LT(worst, 0.03);
    for (std::int64_t i = 14400; i < 44400; ++i) {
        const float drawn = share[static_cast<std::size_t>(i) + 1];
        ASSERT_TRUE(drawn == 1.0F || drawn == -1.0F);
    }
}

// A plane in front of the plane z = 0, which lets a share of its ink through.
struct Front {
    double z;
    bool faces_away;
};

TEST_F(LayersTest, StackedOpenLayersDimExactly) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 60));
    Style style = all_front(HiddenLines::attenuate);
    style.attenuation_front = 0.4;
    style.attenuation_back = 0.3;
    style.splat_overlap = 1.0F;
    const float front = layer_transmittance(style, -1.0F, false);
    const float back = layer_transmittance(style, 1.0F, false);
    struct Case {
        std::vector<Front> layers;
        float clear;
    };
    // 100 pixels per unit.
    const Case cases[] = {{{}, 1.0F},
                          {{{0.6, false}}, front},
                          {{{0.05, false}}, front}, // layers of two items only need a small gap
                          {{{0.6, true}}, back},
                          {{{0.05, true}}, back}, // and so do two sides
                          {{{0.6, true}, {1.2, false}}, back * front},
                          {{{0.05, true}, {0.1, false}}, back * front}, // a thin slab
                          {{{0.6, false}, {1.2, true}}, back * front},
                          {{{0.6, false}, {1.2, false}}, front * front},
                          {{{0.6, true}, {1.2, true}}, back * back},
                          {{{0.6, true}, {1.2, false}, {1.8, true}, {2.4, false}}, back * front * back * front},
                          {{{-0.6, false}, {-1.2, true}}, 1.0F}}; // behind the plane
    for (const Case& c : cases) {
        std::vector<frame::Item> items{layered_item(set, style)};
        Style blank = style;
        blank.kind[0].share = 0.0F;
        blank.kind[0].shown = true;
        for (const Front& f : c.layers) {
            glm::dmat4 m = shifted({0.0, 0.0, f.z});
            if (f.faces_away) { // turned about y
                m[0][0] = -1.0;
                m[2][2] = -1.0;
            }
            items.push_back(layered_item(set, blank, m));
        }
        draw(items, front_camera(250, 250));
        const std::vector<float> share = seen_share(frame, 3600 * static_cast<std::int64_t>(items.size()));
        for (std::size_t id = 1; id <= 3600; ++id) ASSERT_NEAR(share[id], c.clear, 2e-6F) << c.layers.size();
    }
}

TEST_F(LayersTest, HiddenInkIsGoneWithHideAndWholeWithShow) {
    const marks::PointSet big = clustered(runtime, sphere(runtime.memory, 20000));
    const marks::PointSet small = clustered(runtime, sphere(runtime.memory, 3000, 0.5));
    const auto drawn_of_small = [&](HiddenLines hidden, const glm::dvec3& at) {
        const std::array items{layered_item(big, all_front(hidden)),
                               layered_item(small, all_front(hidden), shifted(at))};
        draw(items, front_camera(500, 500));
        std::int64_t count = 0;
        for (const Disc& disc : frame.discs()) {
            EXPECT_EQ(disc.color.w, 1.0F);
            count += disc.id > 20000;
        }
        return count;
    };
    const std::int64_t all = drawn_of_small(HiddenLines::show, {0.2, 0.0, -2.0});
    EXPECT_EQ(frame.info().dropped_hidden, 0);
    EXPECT_EQ(frame.info().splats, 0);
    EXPECT_NEAR(static_cast<double>(all), 1500.0, 5.0); // half of the marks
    EXPECT_EQ(drawn_of_small(HiddenLines::hide, {0.2, 0.0, -2.0}), 0);
    EXPECT_EQ(frame.info().dropped_hidden, all);
    EXPECT_EQ(drawn_of_small(HiddenLines::hide, {0.2, 0.0, 2.0}), all);
}

TEST_F(LayersTest, AHaloHasItsWidthAtAnyZoom) {
    const marks::PointSet disc = clustered(runtime, sphere(runtime.memory, 60000, 0.5));
    const marks::PointSet wall = clustered(runtime, plane(runtime.memory, 700));
    for (const HiddenLines hidden : hiding) {
        for (const double half : {1.25, 0.8, 0.55}) {
            for (const float halo : {0.0F, 3.0F, 7.0F}) {
                Style style = all_front(hidden);
                style.halo_width = halo;
                if (halo == 0.0F && hidden != HiddenLines::hide)
                    continue; // by its law, a layer lets everything through where it turns away
                const std::array items{layered_item(wall, style, shifted({0.0, 0.0, -2.0})), layered_item(disc, style)};
                draw(items, front_camera(600, 600, half));
                const double rim = 0.5 * 300.0 / half;
                // The nearest ink of the wall in each of 90 directions.
                std::array<double, 90> nearest{};
                nearest.fill(1e9);
                for (const Disc& d : frame.discs()) {
                    if (d.id > 490000U || d.color.w < 0.05F) continue;
                    const double x = static_cast<double>(d.x) - 300.0;
                    const double y = static_cast<double>(d.y) - 300.0;
                    const auto way = static_cast<std::size_t>((std::atan2(y, x) + pi) / (2.0 * pi) * 89.999);
                    nearest[way] = std::min(nearest[way], std::hypot(x, y) - rim);
                }
                const auto [least, most] = std::minmax_element(nearest.begin(), nearest.end());
                EXPECT_GE(*least, static_cast<double>(halo) - 1.0) << half << " " << halo;
                EXPECT_LE(*most, static_cast<double>(halo) + (halo > 0.0F ? 1.0 : 2.0) + 1.0) << half << " " << halo;
            }
        }
    }
}

// If the contour is drawn as a line, its halo is at most three times as wide as the line.
TEST_F(LayersTest, AHaloFadesWithItsLine) {
    test::SquareSphere ball;
    curves::LineSetSettings settings;
    settings.side = 0.1;
    const curves::LineSet lines(runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), settings);
    const marks::PointSet disc = clustered(runtime, sphere(runtime.memory, 60000));
    const marks::PointSet wall = clustered(runtime, plane(runtime.memory, 700));
    glm::dmat4 half_size(0.5);
    half_size[3][3] = 1.0;
    // Returns the median distance of the wall's ink from the contour, over 90 directions.
    const auto gap_beside = [&](const frame::LineStyle& line) {
        Style style = all_front(HiddenLines::hide);
        style.halo_width = 6.0F;
        std::array items{layered_item(wall, style, shifted({0.0, 0.0, -2.0})), layered_item(disc, style, half_size)};
        items[1].lines = &lines;
        items[1].style.lines = std::span(&line, 1);
        draw(items, front_camera(600, 600));
        std::array<double, 90> nearest{};
        nearest.fill(1e9);
        for (const Disc& d : frame.discs()) {
            if (d.id > 490000U || d.color.w < 0.05F) continue;
            const double x = static_cast<double>(d.x) - 300.0;
            const double y = static_cast<double>(d.y) - 300.0;
            const auto way = static_cast<std::size_t>((std::atan2(y, x) + pi) / (2.0 * pi) * 89.999);
            nearest[way] = std::min(nearest[way], std::hypot(x, y) - 120.0);
        }
        std::nth_element(nearest.begin(), nearest.begin() + 45, nearest.end());
        return nearest[45];
    };
    frame::LineStyle line;
    line.width = 3.0F;
    EXPECT_NEAR(gap_beside(line), 6.0, 1.5);
    line.width = 1.5F;
    EXPECT_NEAR(gap_beside(line), 4.5, 1.0);
    line.width = 0.1F;
    EXPECT_LT(gap_beside(line), 2.0);
}

TEST_F(LayersTest, InstancesLookLikeSeparateSets) {
    const marks::PointSet set = clustered(runtime, torus(runtime.memory, 80));
    const marks::PointSet same = clustered(runtime, torus(runtime.memory, 80));
    Style first;
    first.attenuation_front = 0.3;
    first.splat_overlap = 2.0F;
    Style second = first;
    second.kind[0].radius = 2.0F;
    second.kind[0].ink = {0.5F, 0.0F, 0.0F, 1.0F};
    second.hidden_lines = HiddenLines::hide;
    glm::dmat4 transform = shifted({0.2, 0.3, 1.0});
    transform[0] = {0.0, 0.7, 0.0, 0.0};
    transform[1] = {0.0, 0.0, 0.7, 0.0};
    transform[2] = {0.7, 0.0, 0.0, 0.0};
    const std::array instances{layered_item(set, first), layered_item(set, second, transform)};
    const std::array sets{layered_item(set, first), layered_item(same, second, transform)};
    draw(instances, front_camera(500, 500, 1.8));
    const std::vector<Disc> discs(frame.discs().begin(), frame.discs().end());
    draw(sets, front_camera(500, 500, 1.8));
    ASSERT_EQ(frame.discs().size(), discs.size());
    const auto marks = static_cast<std::uint32_t>(set.layers[0].count());
    std::array<bool, 2> both{};
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const Disc& d = frame.discs()[i];
        ASSERT_EQ(d.id, discs[i].id);
        ASSERT_EQ(glm::vec3(d.x, d.y, d.radius), glm::vec3(discs[i].x, discs[i].y, discs[i].radius));
        ASSERT_EQ(d.color, discs[i].color);
        both[d.id > marks ? 1 : 0] = true;
    }
    EXPECT_TRUE(both[0] && both[1]);
}

TEST_F(LayersTest, StylesOfOneFrameHaveOneVisibility) {
    const marks::PointSet set = clustered(runtime, sphere(runtime.memory, 100));
    for (const bool published_first : {false, true}) {
        std::array items{layered_item(set, Style{}), layered_item(set, Style{}), item_of(set, Style{})};
        if (published_first) std::swap(items[0], items[2]);
        try {
            frame.draw(items, front_camera(100, 100));
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            EXPECT_NE(
                std::string(error.what())
                    .find(published_first ? "items[1].style.visibility differs" : "items[2].style.visibility differs"),
                std::string::npos)
                << error.what();
        }
        EXPECT_FALSE(frame.drawn());
    }
}

} // namespace
} // namespace hrbfnpr::testing::layers_test
